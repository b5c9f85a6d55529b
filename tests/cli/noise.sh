#!/usr/bin/env bash
# The command line of sightline-noise. usage: noise.sh FOLDER_OF_PROGRAMS
# shellcheck source=tests/cli/lib.sh disable=SC2016
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
noise=$(realpath -- "${1:?usage: noise.sh FOLDER_OF_PROGRAMS}")/sightline-noise

# ask LINES [OPTION...]: from the standard input.
ask() {
  printf '%b' "$1" >"$scratch/points"
  run bash -c '"$@" <"$0"' "$scratch/points" "$noise" "${@:2}"
}
# answers LINES ANSWERS [OPTION...]: exactly these.
answers() {
  ask "$1" "${@:3}"
  expect_exit 0
  expect_quiet
  check "the answers $2" test "$(cat "$scratch/stdout")" = "$(printf '%b' "$2")"
}

run "$noise" --help
expect_exit 0
expect_quiet
for word in --kind --ease --seed --period --fractal --octaves --lacunarity --gain --frequency --warp --footprint --gradient \
  --precision --in --image --size --slice --extent perlin improved value white ridged turbulence quintic 'Exit status'; do
  expect_prints "$word"
done
refuses 2 --no-such-option "$noise" --no-such-option
refuses 2 'perlin|improved|value|white, found simplex' "$noise" --kind simplex
refuses 2 'cubic|quintic, found linear' "$noise" --ease linear
refuses 2 'none|fbm|turbulence|ridged, found brown' "$noise" --fractal brown
refuses 2 'fast|precise, found exact' "$noise" --precision exact
refuses 2 'power of two' "$noise" --period 255
refuses 2 'octaves from 1 to 32, found 0' "$noise" --fractal fbm --octaves 0
refuses 2 'lacunarity above 1' "$noise" --fractal fbm --lacunarity 1
refuses 2 'gain above 0' "$noise" --fractal fbm --gain 2
refuses 2 'frequency above 0' "$noise" --frequency 0
refuses 2 'warp from 0' "$noise" --warp -1
refuses 2 --footprint "$noise" --footprint -1
refuses 2 --octaves "$noise" --octaves many
refuses 2 'WIDTHxHEIGHT' "$noise" --image a.png --size 640
refuses 2 'WIDTHxHEIGHT' "$noise" --image a.png --size 0x4
refuses 2 --extent "$noise" --image a.png --extent 0
refuses 2 'expected with --image' "$noise" --size 4x4
refuses 2 'found both' "$noise" --image a.png --in points
refuses 2 'found --gradient' "$noise" --image a.png --gradient
refuses 1 no-such-file "$noise" --in no-such-file
refuses 1 'extension' "$noise" --image slice.nonsense
refuses 1 'cannot' "$noise" --in /

# ---- Points

answers '.5 .5 .5\n' '-0.25\n' --kind improved
answers '.5 .5 .5' '-0.25\n' --kind improved
answers '  3.14,42 ,\t7\r\n' '0.13691995878400012\n' --kind improved
answers '17.3 4.7\n17.3 4.7 0\n' '-0.23245943951999978\n-0.23245943951999978\n' --kind improved
answers '.5 .5 .5\n' '-0.25 -0.6875 0.25 0\n' --kind improved --gradient
answers '.5 .5\n' "$("$noise" --kind improved --gradient <<<'.5 .5 0' | cut -d' ' -f1-3)\n" --kind improved --gradient
answers '# none\n\n \t\n3 4 5\n' '0\n'
answers '' ''
ask '0.1 0.2 0.3\n'
double=$(cat "$scratch/stdout")
ask '0.1 0.2 0.3\n' --precision fast
check 'fewer digits of a float' test "$(wc -c <"$scratch/stdout")" -lt "${#double}"
check 'nearly the same number' awk -v a="$double" -v b="$(cat "$scratch/stdout")" 'BEGIN { exit !((a - b) ^ 2 < 1e-10) }'
ask '1e999 0 0\n0 0 0\n'
expect_exit 1
expect_says 'line 1: column 1: expected a number that is finite as a double'
ask 'inf 0 0\nnan 0\n'
expect_exit 0
check 'no number' test "$(cat "$scratch/stdout")" = "$(printf 'nan\nnan')"
for fractal in fbm turbulence ridged; do
  ask '0.3 0.4 0.5\n' --fractal "$fractal" --octaves 3 --lacunarity 2.5 --gain 0.4 --frequency 3 --warp 0.5 --footprint 0.01 \
    --ease quintic --seed 9 --period 64 --kind value
  expect_exit 0
  check 'one number' test "$(wc -w <"$scratch/stdout")" = 1
done

# ---- Bad lines among good ones

refused() { # TEXT LINE
  ask "1 2 3\n\n$2\n.5 .5 .5\n" --kind improved
  expect_exit 1
  expect_one_line
  expect_says "line 3: $1"
  expect_says 'expected'
  check 'two answers' test "$(cat "$scratch/stdout")" = "$(printf '0\n-0.25')"
}
refused 'column 1: expected a number, found '\''x'\' 'x y z'
refused 'column 5: expected a number, found '\''3z'\' '1 2 3z'
refused 'column 7: expected two or three numbers, found '\''4'\' '1 2 3 4'
refused 'column 2: expected two or three numbers, found the end of the line after 1' '1'
refused 'column 3: expected a number, found' '1 - 2'
refused 'column 5: expected a number after the comma' '1,2,'
refused 'column 3: expected a number, found' '1,,2'
long=$(printf '1%.0s' {1..5000})
refused 'expected a line of at most 4096' "$long 2 3"

# ---- Many points, files, and answers at once

seq 1 20000 | awk '{ print $1 / 7, $1 / 11, -$1 / 13 }' >"$scratch/many"
run "$noise" --in "$scratch/many"
expect_exit 0
check 'as many answers as points' test "$(wc -l <"$scratch/stdout")" = 20000
cp "$scratch/stdout" "$scratch/all"
run bash -c '"$0" <"$1"' "$noise" "$scratch/many"
check 'the same from the standard input' cmp -s "$scratch/stdout" "$scratch/all"
run bash -c 'head -n 1 "$1" | "$0"' "$noise" "$scratch/many"
check 'the same alone' test "$(cat "$scratch/stdout")" = "$(head -n 1 "$scratch/all")"
run bash -c 'coproc "$0" --kind improved; echo .5 .5 .5 >&"${COPROC[1]}"; read -r -t 60 line <&"${COPROC[0]}"; echo "$line"' "$noise"
expect_prints '-0.25'
run bash -c '"$0" --in "$1" >/dev/full' "$noise" "$scratch/many"
expect_exit 1
expect_says 'cannot write'

# ---- Slices

for file in slice.png slice.exr; do
  run "$noise" --image "$file" --size 40x30 --slice z=0.5 --extent 4 --fractal fbm
  expect_exit 0
  expect_quiet
  expect_file "$file"
  check 'nothing else' test "$(ls -A "$work")" = "$file"
done
run "$noise" --image "$scratch/points/slice.png" # a file, and no folder
expect_exit 1
expect_one_line
finish
