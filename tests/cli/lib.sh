# shellcheck shell=bash disable=SC2034
# For tests of command lines: run a command in an empty folder, then say what is expected of it.
set -euo pipefail

root=$(dirname -- "$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")")
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
work=$scratch/work # where commands run
failures=0
checks=0

# run COMMAND...: in the emptied folder $work, without a terminal. The command may fail.
run() {
  ran="$*"
  rm -rf -- "$work"
  mkdir -p "$work"
  run_again "$@"
}

# The same, in $work as it is.
run_again() {
  ran="$*"
  status=0
  (cd -- "$work" && exec "$@") >"$scratch/stdout" 2>"$scratch/stderr" </dev/null || status=$?
}

check() { # DESCRIPTION CONDITION...
  local description=$1
  shift
  checks=$((checks + 1))
  "$@" && return 0
  failures=$((failures + 1))
  printf 'FAILED %s\n  expected %s\n  exit %s, stderr: %s\n' "$ran" "$description" "$status" "$(head -c 2000 "$scratch/stderr")"
}

expect_exit() { check "exit $1" test "$status" = "$1"; }
# Beside what tells of progress, where the machine is so slow that there is some.
expect_one_line() { check 'one line on stderr' test "$(grep -c -v -E '\([0-9]+ s so far' "$scratch/stderr")" = 1; }
expect_quiet() { check 'nothing on stderr' test ! -s "$scratch/stderr"; }
expect_no_output() { check 'nothing on stdout' test ! -s "$scratch/stdout"; }
expect_says() { check "stderr to say '$1'" grep -q -i -F -e "$1" "$scratch/stderr"; }
expect_prints() { check "stdout to have '$1'" grep -q -i -F -e "$1" "$scratch/stdout"; }
expect_file() { check "a file $1" test -s "$work/$1"; }
expect_no_file() { check 'no file left behind' test -z "$(ls -A "$work")"; }

# refuses STATUS TEXT COMMAND...: one line that says TEXT, and no file.
refuses() {
  local expected=$1 text=$2
  shift 2
  run "$@"
  expect_exit "$expected"
  expect_one_line
  expect_says "$text"
  expect_no_file
}

# Whether pages can be tried; says so where they cannot.
has_browser() {
  type -P chromium >/dev/null && type -P node >/dev/null && return
  echo 'pages are NOT tried: chromium and node are not both here'
  return 1
}

finish() {
  echo "$checks checks, $failures failed"
  exit $((failures > 0))
}

# Meshes that no program may accept, in $scratch/meshes; `broken_meshes` lists them.
make_broken_meshes() {
  local folder=$scratch/meshes
  mkdir -p "$folder/folder.ply"
  ply() { # VERTEX LINES, FACE LINES
    printf 'ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\n' 3
    printf 'element face %d\nproperty list uchar int vertex_indices\nend_header\n' "$1"
    printf '%s\n' "${@:2}"
  }
  ply 1 '0 0 0' '1 0 0' 'nan 1 0' '3 0 1 2' >"$folder/nan.ply"
  ply 1 '0 0 0' '1 0 0' 'inf 1 0' '3 0 1 2' >"$folder/infinite.ply"
  ply 1 '0 0 0' '1 0 0' '0 1 0' '3 0 1 3' >"$folder/index.ply"
  ply 1 '0 0 0' '1 0 0' '0 1 0' '3 0 1 -1' >"$folder/negative_index.ply"
  ply 0 '0 0 0' '1 0 0' '0 1 0' >"$folder/no_triangle.ply"
  ply 2 '0 0 0' '1 0 0' '0 1 0' '3 0 1 2' >"$folder/truncated_faces.ply"
  ply 1 '0 0 0' '1 0' >"$folder/truncated_vertices.ply"
  printf 'ply\nformat ascii 1.0\nelement vert' >"$folder/truncated_header.ply"
  { ply 1 | sed 's/ascii/binary_little_endian/'; printf '\0\0\200\77'; } >"$folder/truncated_binary.ply"
  printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n' >"$folder/index.obj"
  printf 'v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n' >"$folder/nan.obj"
  printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\n' >"$folder/no_triangle.obj"
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n' >"$folder/truncated.off"
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' >"$folder/index.off"
  head -c 100 /dev/zero >"$folder/truncated.stl"
  printf 'solid a\nendsolid a\n' >"$folder/no_triangle.stl"
  printf '{"asset": {"version": "2.0"}, "meshes": [' >"$folder/truncated.gltf"
  printf 'no mesh at all\n' >"$folder/text.ply"
  local kind
  for kind in ply obj stl off gltf; do : >"$folder/empty.$kind"; done
}
broken_meshes() { printf '%s\n' "$scratch"/meshes/*; }
