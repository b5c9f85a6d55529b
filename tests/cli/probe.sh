#!/usr/bin/env bash
# The command line of sightline-probe. usage: probe.sh FOLDER_OF_PROGRAMS
# shellcheck source=tests/cli/lib.sh disable=SC2016
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
probe=$(realpath -- "${1:?usage: probe.sh FOLDER_OF_PROGRAMS}")/sightline-probe
ray='"ray":{"o":[-3,0,0],"d":[1,0,0]}'

# ask LINES [OPTION...]: from the standard input.
ask() {
  printf '%b' "$1" >"$scratch/questions"
  run bash -c '"$@" <"$0"' "$scratch/questions" "$probe" "${@:2}"
}
# answers STATUS LINE ANSWER [OPTION...]: exactly this one.
answers() {
  ask "$2\n" "${@:4}"
  expect_exit "$1"
  expect_quiet
  check "the answer $3" test "$(cat "$scratch/stdout")" = "$3"
}

run "$probe" --help
expect_exit 0
expect_quiet
for word in sphere torus box mesh tree half cylinder cone quadric compl frame t_first --precision 'Exit status'; do
  expect_prints "$word"
done
refuses 2 --no-such-option "$probe" --no-such-option
refuses 2 'watertight|precise' "$probe" --precision coarse
refuses 2 --precision "$probe" --precision
refuses 2 two "$probe" one two
refuses 1 no-such-file "$probe" no-such-file
refuses 1 'cannot be read' "$probe" /

# ---- Every form of question

answers 0 "{\"id\":1,$ray,\"sphere\":{\"c\":[0,0,0],\"r\":1}}" '{"id":1,"roots":[2.0,4.0],"multiplicity":[1,1],"t_first":2.0}'
answers 0 "{$ray,\"sphere\":{\"c\":[0,1,0],\"r\":1}}" '{"roots":[3.0],"multiplicity":[2],"t_first":3.0}'
answers 0 "{$ray,\"sphere\":{\"c\":[-9,0,0],\"r\":1}}" '{"roots":[-7.0,-5.0],"multiplicity":[1,1],"t_first":null}'
answers 0 "{$ray,\"sphere\":{\"c\":[0,3,0],\"r\":1}}" '{"roots":[],"multiplicity":[],"t_first":null}'
answers 0 '{"id":"q","ray":{"o":[-10,2,1],"d":[1,0,0]},"torus":{"R":2,"r":1}}' '{"id":"q","roots":[10.0],"multiplicity":[4],"t_first":10.0}'
answers 0 "{$ray,\"box\":{\"lo\":[-1,-1,-1],\"hi\":[1,0,1]}}" '{"hit":true,"enter":2.0,"exit":4.0,"t_first":2.0}'
answers 0 "{$ray,\"box\":{\"lo\":[-5,-1,-1],\"hi\":[1,0,1]}}" '{"hit":true,"enter":-2.0,"exit":4.0,"t_first":4.0}'
answers 0 "{$ray,\"box\":{\"lo\":[-5,1,-1],\"hi\":[1,2,1]}}" '{"hit":false,"enter":null,"exit":null,"t_first":null}'
answers 0 "{$ray,\"mesh\":{\"v\":[[0,0,0],[0,1,0],[0,0,1],[0,-1,-1]],\"f\":[[0,1,2],[0,2,3],[0,3,1]]}}" \
  '{"t":[3.0],"tris":[[0,1,2]],"t_first":3.0}'
answers 0 "{$ray,\"mesh\":{\"v\":[],\"f\":[]}}" '{"t":[],"tris":[],"t_first":null}'
box='{"prim":"box","lo":[-1,-1,-1],"hi":[1,1,1]}' half='{"prim":"half","n":[1,0,0],"w":0}'
answers 0 "{$ray,\"tree\":$box}" '{"intervals":[[2.0,4.0]],"t_first":2.0}'
answers 0 "{$ray,\"tree\":{\"op\":\"union\",\"args\":[$box,$half]}}" '{"intervals":[["-inf",4.0]],"t_first":4.0}'
answers 0 "{$ray,\"tree\":{\"op\":\"inter\",\"args\":[$box,$half]}}" '{"intervals":[[2.0,3.0]],"t_first":2.0}'
answers 0 "{$ray,\"tree\":{\"op\":\"diff\",\"args\":[$box,$half]}}" '{"intervals":[[3.0,4.0]],"t_first":3.0}'
answers 0 "{$ray,\"tree\":{\"op\":\"xor\",\"args\":[$box,$half]}}" '{"intervals":[["-inf",2.0],[3.0,4.0]],"t_first":2.0}'
answers 0 "{$ray,\"tree\":{\"op\":\"compl\",\"args\":[$half]}}" '{"intervals":[[3.0,"inf"]],"t_first":3.0}'
answers 0 "{$ray,\"tree\":{\"op\":\"diff\",\"args\":[$box,$box]}}" '{"intervals":[],"t_first":null}'
answers 0 "{$ray,\"tree\":{\"op\":\"union\",\"args\":[$half,{\"op\":\"compl\",\"args\":[$half]}]}}" '{"intervals":[["-inf","inf"]],"t_first":null}'
for prim in '"cylinder","p":[0,0,-1],"q":[0,0,1],"r":1' '"cone","p":[0,0,1],"q":[0,0,-1],"r":2' '"torus","R":1,"r":0.5,"a":[0,0,1]' \
  '"quadric","q":[1,1,1,0,0,0,0,0,0,-1]' '"sphere","c":[0,0,0],"r":1,"frame":{"scale":2}' \
  '"mesh","v":[[-1,-1,-1],[2,0,0],[0,2,0],[0,0,2]],"f":[[0,2,1],[0,1,3],[0,3,2],[1,2,3]]'; do
  ask "{$ray,\"tree\":{\"prim\":$prim}}"
  expect_exit 0
  expect_prints '"intervals":[['
done
for precision in fast watertight precise exact; do
  answers 0 "{$ray,\"sphere\":{\"c\":[0,0,0],\"r\":1}}" '{"roots":[2.0,4.0],"multiplicity":[1,1],"t_first":2.0}' --precision "$precision"
done

# ---- Bad lines among good ones

good="{\"id\":0,$ray,\"sphere\":{\"c\":[0,0,0],\"r\":1}}"
refused() { # TEXT LINE: says so with its number, and answers the others
  ask "$good\n\n$2\n$good"
  expect_exit 1
  expect_quiet
  check 'three answers' test "$(wc -l <"$scratch/stdout")" = 3
  check 'two good ones' test "$(grep -c '"t_first":2.0' "$scratch/stdout")" = 2
  check "'$1' in the second answer" bash -c 'sed -n 2p "$0" | grep -q -F -e "$1"' "$scratch/stdout" "$1"
  check 'its line and an error' bash -c 'sed -n 2p "$0" | grep -q -E "\"line\":3,\"error\":\".*expected .*found "' "$scratch/stdout"
}
refused 'byte 2' 'nonsense'
refused 'unexpected end' "{\"id\":1,$ray"
refused '/: expected an object' '[1,2]'
refused '"/: expected a member' '{"sphere":{"c":[0,0,0],"r":1}}'
refused 'none' "{$ray}"
refused 'one of the members' "{$ray,\"cube\":{}}"
refused 'both' "{$ray,\"sphere\":{\"c\":[0,0,0],\"r\":1},\"box\":{\"lo\":[0,0,0],\"hi\":[1,1,1]}}"
refused '/ray/o: expected 3 numbers' '{"ray":{"o":[0,0],"d":[1,0,0]},"sphere":{"c":[0,0,0],"r":1}}'
refused '/ray/d/1: expected a number' '{"ray":{"o":[0,0,0],"d":[1,"0",0]},"sphere":{"c":[0,0,0],"r":1}}'
refused '/ray/d: expected a direction other than 0' '{"ray":{"o":[0,0,0],"d":[0,0,0]},"sphere":{"c":[0,0,0],"r":1}}'
refused 'expected JSON' '{"ray":{"o":[0,0,NaN],"d":[1,0,0]},"sphere":{"c":[0,0,0],"r":1}}'
refused 'finite as a double' '{"ray":{"o":[0,0,1e999],"d":[1,0,0]},"sphere":{"c":[0,0,0],"r":1}}'
refused '/sphere/r: expected a radius' "{$ray,\"sphere\":{\"c\":[0,0,0],\"r\":-1}}"
refused '/torus: expected a member' "{$ray,\"torus\":{\"R\":1}}"
refused '/box/hi/2: expected a number that is not below' "{$ray,\"box\":{\"lo\":[0,0,0],\"hi\":[1,1,-1]}}"
refused '/mesh/f/0/2: expected a vertex below 2' "{$ray,\"mesh\":{\"v\":[[0,0,0],[1,0,0]],\"f\":[[0,1,2]]}}"
refused '/tree/op: expected one of union' "{$ray,\"tree\":{\"op\":\"minus\",\"args\":[$box]}}"
refused '/tree/args: expected 1 argument' "{$ray,\"tree\":{\"op\":\"compl\",\"args\":[$box,$box]}}"
refused '/tree/args: expected at least 1 argument' "{$ray,\"tree\":{\"op\":\"union\",\"args\":[]}}"
refused '/tree/args/1/prim: expected one of box' "{$ray,\"tree\":{\"op\":\"union\",\"args\":[$box,{\"prim\":\"cube\"}]}}"
refused '/tree: closed mesh: ' "{$ray,\"tree\":{\"prim\":\"mesh\",\"v\":[[0,0,0],[1,0,0],[0,1,0]],\"f\":[[0,1,2]]}}"
refused '/tree: expected a member \"op\" or \"prim\", found none' "{$ray,\"tree\":{}}"
refused 'byte' "{\"id\":\"\\\\xff\",$ray}"
refused '"id":[7]' "{\"id\":[7],$ray}"

deep=$(printf '[%.0s' {1..5000})
refused 'within each other' "$deep"
ask "$good" # no end of the line
expect_exit 0
check 'one answer' test "$(wc -l <"$scratch/stdout")" = 1
ask ''
expect_exit 0
expect_no_output
ask "\r\n$good\r\n \t\n"
expect_exit 0
run bash -c '{ head -c 70000000 /dev/zero | tr "\0" "["; printf "\n%s\n" "$1"; } | "$0"' "$probe" "$good"
expect_exit 1
expect_prints 'expected a line of at most'
expect_prints '"t_first":2.0'

# ---- Files, and answers at once

printf '%s\n' "$good" >"$scratch/file.jsonl"
for file in "$scratch/file.jsonl" -; do
  run bash -c '"$0" "$1" <"$2"' "$probe" "$file" "$scratch/file.jsonl"
  expect_exit 0
  expect_prints '"roots":[2.0,4.0]'
done
run bash -c 'coproc "$0"; echo "$1" >&"${COPROC[1]}"; read -r -t 60 line <&"${COPROC[0]}"; echo "$line"' "$probe" "$good"
expect_prints '"roots":[2.0,4.0]'
run "$probe" "$root/data/questions.jsonl"
expect_exit 0
finish
