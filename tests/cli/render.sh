#!/usr/bin/env bash
# The command line of sightline-render, most of it over a source that needs no renderer. usage: render.sh FOLDER_OF_PROGRAMS
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
programs=$(realpath -- "${1:?usage: render.sh FOLDER_OF_PROGRAMS}")
fake=$programs/fake_render

run "$programs/sightline-render" --help
expect_exit 0
expect_quiet
for word in SCENE --out --size --samples --error --aov --resume --preview --explain 'Exit status'; do expect_prints "$word"; done

# ---- What is refused, before anything is rendered

refuses 2 --no-such-option "$fake" teapot:1 --no-such-option
refuses 2 'expected a scene, found none' "$fake"
refuses 2 'found "kettle"' "$fake" kettle
refuses 1 'expected a file' "$fake" none.json
refuses 2 '--size: expected WxH' "$fake" teapot:1 --size 64
refuses 2 '--size: expected WxH' "$fake" teapot:1 --size 0x64
refuses 2 '--size: expected WxH' "$fake" teapot:1 --size 16384x16384
refuses 2 '--samples' "$fake" teapot:1 --samples 0
refuses 2 '--samples' "$fake" teapot:1 --samples -4
refuses 2 '--error: expected a number from 0' "$fake" teapot:1 --error=-1
refuses 2 '--error: expected a number' "$fake" teapot:1 --error nan
refuses 2 '--shadow-error: expected a number from 0' "$fake" teapot:1 --shadow-error=-1
refuses 2 '--exposure: expected' "$fake" teapot:1 --exposure 65
refuses 2 '--time: expected a number' "$fake" teapot:1 --time inf
refuses 2 '--aov: expected names of depth, normal, id, cost, samples' "$fake" teapot:1 --aov depth,colour
refuses 2 '--precision: expected fast' "$fake" teapot:1 --precision best
refuses 2 'kd-tee' "$fake" teapot:1 --accel kd-tee
refuses 2 '--set: expected --accel' "$fake" teapot:1 --set kd-tree.max_depth=3
refuses 2 '--out: expected a name that ends in .exr, .png' "$fake" teapot:1 --out picture.doc
refuses 2 '--out: expected a name that ends in' "$fake" teapot:1 --out picture
refuses 1 'expected a file that can be written' "$fake" teapot:1 --out /dev/null/a.png

# ---- Pictures

run "$fake" teapot:1 --size 64x48
expect_exit 0
expect_one_line
expect_says 'out/teapot-1.png: 64 x 48, 4 samples a pixel'
expect_file out/teapot-1.png
check 'one file' test "$(ls -A "$work/out")" = teapot-1.png

small=(teapot:1 --size 40x30 --samples 16)
for extension in png exr tif; do
  run "$fake" "${small[@]}" --out a.$extension --threads 1
  expect_exit 0
  sleep 1 # dates would count seconds
  run_again "$fake" "${small[@]}" --out b.$extension --threads 2 --quiet
  expect_exit 0
  expect_quiet
  check "the same bytes in a.$extension and b.$extension" cmp -s "$work/a.$extension" "$work/b.$extension"
  run_again "$fake" "${small[@]}" --out b.$extension --seed 2
  check "other bytes for another seed" bash -c "! cmp -s '$work/a.$extension' '$work/b.$extension'"
done
run "$fake" "${small[@]}" --aov depth,normal,id,cost,samples --out new/a.png --explain --exposure 1
expect_exit 0
for each in png depth.png normal.png id.png cost.png samples.png png.bill.txt; do expect_file "new/a.$each"; done
check '7 files' test "$(find "$work/new" -type f | wc -l)" = 7
check 'the rays of 16 samples' grep -q "^camera rays $((40 * 30 * 16))$" "$work/new/a.png.bill.txt"
run "$fake" "${small[@]}" --aov depth,normal,id,cost,samples --out a.exr
expect_exit 0
check 'one file' test "$(ls -A "$work")" = a.exr
if type -P oiiotool >/dev/null; then
  run_again oiiotool --info -v a.exr
  for word in 'R, G, B, Z' 'N.X, N.Y, N.Z' id cost samples 'sightline:scene: "teapot:1"' 'Software: "Sightline ' \
    'sightline:samples: "16"'; do expect_prints "$word"; done
  check 'no date' bash -c "! grep -q DateTime '$scratch/stdout'"
  run_again "$fake" "${small[@]}" --out a.exr --dated --time 2.5
  run_again oiiotool --info -v a.exr
  for word in 'DateTime' 'sightline:seconds' 'sightline:time: "2.5"'; do expect_prints "$word"; done
fi
run "$fake" teapot:1 --plan
expect_exit 0
expect_quiet
expect_prints '4 samples of noise'
expect_no_file

# ---- Ended early, and gone on with

slow=(teapot:1 --size 40x30 --samples 16 --error 0.02 --aov cost --out a.exr)
run "$fake" "${slow[@]}"
cp "$work/a.exr" "$scratch/whole.exr"
# end_after FILE|SECONDS SIGNAL...: of a run that would take some four seconds, as soon as the file is there, or so long
# after its first sample, however slow the machine.
end_after() {
  local after=$1 file=$scratch/started pause=$1 signal process
  shift
  if [[ $after != [0-9]* ]]; then file=$after pause=0; fi
  ran="${slow[*]} ended after $after by $*"
  rm -f -- "$scratch/started"
  (
    cd -- "$work"
    SIGHTLINE_FAKE_STARTED=$scratch/started SIGHTLINE_FAKE_DELAY=500 \
      "$fake" "${slow[@]}" "${more[@]}" >"$scratch/stdout" 2>"$scratch/stderr" </dev/null &
    process=$!
    while [ ! -e "$file" ] && kill -0 "$process" 2>/dev/null; do sleep 0.05; done
    sleep "$pause"
    for signal; do kill -"$signal" "$process" 2>/dev/null; sleep 0.3; done
    wait "$process" 2>/dev/null
  ) && status=0 || status=$?
}
rm -rf -- "$work" && mkdir -p "$work"
more=()
end_after 0.6 TERM
expect_exit 143
expect_says '% of its samples; the same command with --resume goes on'
expect_file a.exr
expect_file a.exr.checkpoint
check 'two files' test "$(find "$work" -type f | wc -l)" = 2
more=(--resume)
end_after 0.3 TERM
expect_exit 143
run_again "$fake" "${slow[@]}" --resume --threads 1
expect_exit 0
check 'the same bytes as without a stop' cmp "$work/a.exr" "$scratch/whole.exr"
check 'no checkpoint any more' test "$(ls -A "$work")" = a.exr

# Signalled twice in one go, as timeout does with a program of its own process group. Scripts' own background processes
# ignore SIGINT.
rm -rf -- "$work" && mkdir -p "$work"
run_again env SIGHTLINE_FAKE_DELAY=3000 timeout --preserve-status -s INT 5 "$fake" "${slow[@]}" --quiet
expect_exit 130
expect_file a.exr.checkpoint
cp "$work/a.exr.checkpoint" "$scratch/checkpoint"

# Killed: the checkpoint of the interval is there.
rm -rf -- "$work" && mkdir -p "$work"
more=(--checkpoint 0.3)
end_after a.exr.checkpoint KILL
expect_exit 137
expect_file a.exr.checkpoint
run_again "$fake" "${slow[@]}" --resume
expect_exit 0
check 'the same bytes as without a stop' cmp "$work/a.exr" "$scratch/whole.exr"

# A second signal ends at once: nothing is left.
rm -rf -- "$work" && mkdir -p "$work"
more=()
slow=(teapot:1 --size 3000x3000 --samples 16 --out a.exr)
end_after 0.6 TERM TERM
expect_exit 143
check 'no file, or whole ones' bash -c "! ls -A '$work' | grep -q '^\.'"

# ---- Checkpoints of something else

with_checkpoint() { # STATUS TEXT SIZE SAMPLES ERROR AOV OPTIONS...
  rm -rf -- "$work" && mkdir -p "$work"
  cp "$scratch/checkpoint" "$work/a.exr.checkpoint"
  run_again "$fake" teapot:1 --out a.exr --resume --size "$3" --samples "$4" --error "$5" --aov "$6" "${@:7}"
  expect_exit "$1"
  expect_one_line
  expect_says "$2"
}
with_checkpoint 0 'a.exr: 40 x 30' 40x30 16 0.02 cost
with_checkpoint 1 'expected a checkpoint of 50 x 30 pixels, found 40 x 30' 50x30 16 0.02 cost
with_checkpoint 1 'of 8 samples a pixel, found 16' 40x30 8 0.02 cost
with_checkpoint 1 'error bound' 40x30 16 0.01 cost
with_checkpoint 1 'the same --aov' 40x30 16 0.02 depth
with_checkpoint 1 'that of another picture' 40x30 16 0.02 cost --seed 9
head -c 5000 "$scratch/checkpoint" >"$scratch/cut"
mv "$scratch/cut" "$scratch/checkpoint"
with_checkpoint 1 'cut off or changed' 40x30 16 0.02 cost
echo text >"$scratch/checkpoint"
with_checkpoint 1 'expected a checkpoint of this version' 40x30 16 0.02 cost
run "$fake" "${small[@]}" --out a.png --resume
expect_exit 0
expect_says 'is not there: rendering from the beginning'

# ---- A window that follows

unset DISPLAY WAYLAND_DISPLAY
mkdir "$scratch/alone"
cp "$fake" "$scratch/alone/"
run "$scratch/alone/fake_render" "${small[@]}" --out a.png --preview --quiet
expect_exit 0
expect_one_line
expect_says './sightline view builds sightline-view'
expect_file a.png
if [[ -x $programs/sightline-view ]]; then
  run "$fake" "${small[@]}" --out a.png --preview --quiet
  expect_exit 0
  expect_file a.png
fi
if [[ -x $programs/sightline-view ]] && type -P Xvfb >/dev/null; then
  Xvfb -displayfd 3 -screen 0 800x600x24 -noreset 3>"$scratch/display" 2>/dev/null &
  server=$!
  for ((i = 0; i < 100; ++i)); do [[ ! -s $scratch/display ]] || break; sleep 0.1; done
  DISPLAY=:$(<"$scratch/display")
  export DISPLAY
  mkdir "$scratch/temporary"
  SIGHTLINE_FAKE_DELAY=500 TMPDIR=$scratch/temporary run "$fake" "${small[@]}" --out a.png --preview --quiet
  expect_exit 0
  expect_quiet
  expect_file a.png
  check 'no preview left' test -z "$(ls -A "$scratch/temporary")"
  (sleep 3; rm "$work/a.png") &
  run_again timeout 60 "$programs/sightline-view" picture a.png --follow
  expect_exit 0 # once the file was gone
  expect_quiet
  unset DISPLAY
  kill "$server"
fi

# ---- What fails on the way

run env SIGHTLINE_FAKE_FAILURE=1 "$fake" "${small[@]}" --out a.png
expect_exit 1
expect_one_line
expect_says 'the source has failed'
expect_file a.png.checkpoint
run_again "$fake" "${small[@]}" --out a.png --resume
expect_exit 0

finish
