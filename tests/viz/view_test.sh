#!/bin/bash
# Checks sightline-view from outside: view_test.sh FOLDER_OF_PROGRAMS. Exit 0 when all hold.
set -u
view=$1/sightline-view
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0

fail() {
  echo "FAIL $1"
  failures=$((failures + 1))
}

# expect STATUS PATTERN ARGUMENTS...: exit status, and exactly one line on stderr that matches.
expect() {
  local status=$1 pattern=$2
  shift 2
  "$view" "$@" >"$folder/stdout" 2>"$folder/stderr"
  local found=$?
  [ $found -eq "$status" ] || fail "'$*': exit $found instead of $status: $(head -1 "$folder/stderr")"
  [ "$(wc -l <"$folder/stderr")" -eq 1 ] || fail "'$*': $(wc -l <"$folder/stderr") lines on stderr"
  grep -qE -- "$pattern" "$folder/stderr" || fail "'$*': no '$pattern' in: $(head -1 "$folder/stderr")"
}

# A run without any display and without Xvfb.
headless() { env -u DISPLAY PATH=/nonexistent "$view" "$@" 2>>"$folder/log"; }

cell=(partitions --accel kd-tree --scene teapot:4)

# Usage
expect 2 "accelerator 'octopus'" partitions --accel octopus --scene teapot --out "$folder/a.png"
expect 2 "no option 'leaf_size'" "${cell[@]}" --set kd-tree.leaf_size=3 --out "$folder/a.png"
expect 2 "max_leaf_size" "${cell[@]}" --set kd-tree.max_leaf_size=none --out "$folder/a.png"
expect 2 "OPTION=VALUE" "${cell[@]}" --set kd-tree.max_leaf_size --out "$folder/a.png"
expect 2 "ACCEL.OPTION=VALUE" "${cell[@]}" --set max_leaf_size=8 --out "$folder/a.png"
expect 2 "--depth" "${cell[@]}" --depth 7:2 --out "$folder/a.png"
expect 2 "--depth" "${cell[@]}" --depth deep --out "$folder/a.png"
expect 2 "--slice" "${cell[@]}" --slice w=0.5 --out "$folder/a.png"
expect 2 "--slice" "${cell[@]}" --slice y=1.5 --out "$folder/a.png"
expect 2 "--slice" "${cell[@]}" --slice y=nan --out "$folder/a.png"
expect 2 "--size" "${cell[@]}" --size 0x0 --out "$folder/a.png"
expect 2 "--out" "${cell[@]}" --out "$folder/a.bmp"
expect 2 "--max-cells|max_cells" "${cell[@]}" --max-cells 0 --out "$folder/a.png"
expect 2 "--accel" partitions --accel kd-tree,bih --scene teapot
expect 1 "no display"
expect 2 "." partitions --accel kd-tree --scene teapot --nonsense
expect 2 "no-such-scene" partitions --accel kd-tree --scene no-such-scene --out "$folder/a.vtp"

# Failures
touch "$folder/file"
expect 1 "no-such.ply" partitions --accel kd-tree --scene "$folder/no-such.ply" --out "$folder/a.vtp"
expect 1 "$folder/file" "${cell[@]}" --out "$folder/file/a.vtp"
expect 1 "match" "${cell[@]}" --depth 900:901 --out "$folder/a.vtp"
env -u DISPLAY "$view" "${cell[@]}" >"$folder/stdout" 2>"$folder/stderr"
[ $? -eq 1 ] && grep -q "no display" "$folder/stderr" || fail "a window without a display: $(cat "$folder/stderr")"
headless "${cell[@]}" --out "$folder/a.png"
[ $? -eq 1 ] && grep -q "xvfb" "$folder/log" || fail "a picture without Xvfb: $(cat "$folder/log")"
[ -z "$(find "$folder" -name '*a.*')" ] || fail "a refused output left a file: $(ls -A "$folder")"

# Data, of every structure, without a display
for accel in $("$view" list | sed -n '/^accelerators/,/^scenes/p' | sed -n 's/^  \([a-z][a-z-]*\) .*/\1/p'); do
  headless partitions --accel "$accel" --scene teapot:4 --out "$folder/$accel.vtp" || fail "$accel as .vtp"
  grep -q '<VTKFile type="PolyData"' "$folder/$accel.vtp" || fail "$accel.vtp is no VTK file"
  for array in depth leaf candidates node; do
    grep -q "Name=\"$array\"" "$folder/$accel.vtp" || fail "$accel.vtp has no $array"
  done
  headless partitions --accel "$accel" --scene teapot:4 --out "$folder/$accel.gltf" || fail "$accel as .gltf"
  grep -q '"accessors"' "$folder/$accel.gltf" || fail "$accel.gltf is no glTF"
done
headless "${cell[@]}" --slice x=0.3 --leaves --max-cells 7 --out "$folder/few.vtp" || fail "few cells as .vtp"
grep -q "7 of .* cells" "$folder/log" || fail "--max-cells 7 shows another number: $(tail -1 "$folder/log")"

# Pictures; no Xvfb may survive the program, however it ends
if command -v Xvfb >/dev/null; then
  env -u DISPLAY "$view" "${cell[@]}" --size 640x480 --out "$folder/kd.png" 2>"$folder/log" || fail "kd.png: $(cat "$folder/log")"
  [ "$(head -c 8 "$folder/kd.png" | od -An -tx1 | tr -d ' ')" = 89504e470d0a1a0a ] || fail "kd.png is no PNG"
  env -u DISPLAY "$view" "${cell[@]}" --size 640x480 --out "$folder/again.png" 2>/dev/null
  cmp -s "$folder/kd.png" "$folder/again.png" || fail "the same picture twice differs"
  DISPLAY=:9999 "$view" "${cell[@]}" --slice y=0.4 --size 640x480 --out "$folder/cut.png" 2>"$folder/log" ||
    fail "a picture with a dead display: $(cat "$folder/log")"
  env -u DISPLAY "$view" csg --solid lens --size 800x450 --out "$folder/lens.png" >"$folder/lens.txt" 2>"$folder/log" ||
    fail "lens.png: $(cat "$folder/log")"
  env -u DISPLAY "$view" csg --solid nothing --size 800x450 --out "$folder/nothing.png" >/dev/null 2>&1
  env -u DISPLAY "$view" csg --solid lens --size 800x450 --out "$folder/again.png" >/dev/null 2>&1
  cmp -s "$folder/lens.png" "$folder/again.png" || fail "the same ladder twice differs"
  [ "$(head -c 8 "$folder/lens.png" | od -An -tx1 | tr -d ' ')" = 89504e470d0a1a0a ] || fail "lens.png is no PNG"
  [ "$(wc -c <"$folder/lens.png")" -gt 30000 ] || fail "lens.png has only $(wc -c <"$folder/lens.png") bytes"
  cmp -s "$folder/lens.png" "$folder/nothing.png" && fail "lens and nothing look the same"
  # A ray through a pixel of the picture hits what is shown there, and nothing beside it.
  "$view" csg --solid lens --size 800x450 --pick 150,225 --out "$folder/pick.json" | grep -q '^material   \(red\|blue\)' ||
    fail "a pick in the middle misses"
  "$view" csg --solid lens --size 800x450 --pick 20,60 --out "$folder/pick.json" | grep -q '^none' ||
    fail "a pick in the corner hits"
  for panel in slice lattice spectrum volume; do
    env -u DISPLAY "$view" noise --show $panel --size 800x500 --out "$folder/$panel.png" 2>"$folder/log" ||
      fail "noise --show $panel: $(cat "$folder/log")"
    [ "$(wc -c <"$folder/$panel.png")" -gt 15000 ] || fail "$panel.png has only $(wc -c <"$folder/$panel.png") bytes"
  done
  env -u DISPLAY "$view" noise --kind white --size 800x500 --out "$folder/white.png" 2>"$folder/log" ||
    fail "a sheet of white noise: $(cat "$folder/log")"
  env -u DISPLAY "$view" noise --show lattice --size 800x500 --out "$folder/again.png" 2>/dev/null
  cmp -s "$folder/lattice.png" "$folder/again.png" || fail "the same lattice twice differs"
  env -u DISPLAY "$view" noise --show lattice --seed 1 --size 800x500 --out "$folder/other.png" 2>/dev/null
  cmp -s "$folder/lattice.png" "$folder/other.png" && fail "two seeds look the same"
  for picture in "wood" "wood --tune" "wood --texture marble:layers=2" "normals --divisions 16"; do
    # shellcheck disable=SC2086
    env -u DISPLAY "$view" $picture --size 800x540 --out "$folder/texture.png" >"$folder/stdout" 2>"$folder/log" ||
      fail "$picture: $(cat "$folder/log")"
    [ "$(wc -c <"$folder/texture.png")" -gt 30000 ] || fail "$picture has only $(wc -c <"$folder/texture.png") bytes"
    # shellcheck disable=SC2086
    env -u DISPLAY "$view" $picture --size 800x540 --out "$folder/again.png" >/dev/null 2>&1
    cmp -s "$folder/texture.png" "$folder/again.png" || fail "$picture twice differs"
  done
  grep -q '^the surface displaced .* 3072 ' "$folder/stdout" || fail "normals tell no triangles"
  for graph in "levels:3" "levels:3 --select left --drag 1,0,0" "rocket --time 0:2 --frames 3 --bounds cylinder"; do
    # shellcheck disable=SC2086
    env -u DISPLAY "$view" graph --scene $graph --size 800x500 --out "$folder/graph.png" >/dev/null 2>"$folder/log" ||
      fail "graph $graph: $(cat "$folder/log")"
    [ "$(wc -c <"$folder/graph.png")" -gt 20000 ] || fail "graph $graph has only $(wc -c <"$folder/graph.png") bytes"
    # shellcheck disable=SC2086
    env -u DISPLAY "$view" graph --scene $graph --size 800x500 --out "$folder/again.png" >/dev/null 2>&1
    cmp -s "$folder/graph.png" "$folder/again.png" || fail "graph $graph twice differs"
  done
  for signal in INT TERM KILL; do
    # A job of its own, so that SIGINT is not ignored as in background jobs of scripts.
    env -u DISPLAY env --default-signal "$view" partitions --accel brute-force --scene soup:300000 --out "$folder/x.png" 2>/dev/null &
    program=$!
    server=
    for _ in $(seq 200); do
      server=$(pgrep -P $program -x Xvfb) && break
      sleep 0.05
    done
    [ -n "$server" ] || fail "no Xvfb was started"
    kill -$signal $program
    wait $program 2>/dev/null
    for _ in $(seq 100); do
      [ -z "$server" ] || ! kill -0 "$server" 2>/dev/null && break
      sleep 0.05
    done
    [ -n "$server" ] && kill -0 "$server" 2>/dev/null && fail "Xvfb lives on after SIG$signal"
  done
fi

# A table needs no display, and says so when it is all there is
env -u DISPLAY "$view" csg --solid widget >"$folder/stdout" 2>"$folder/stderr" || fail "a table without a display"
grep -q 'wasInA isInA wasInB isInB' "$folder/stdout" || fail "no booleans in the table"
grep -q 'no display' "$folder/stderr" || fail "a missing window is not told"
headless noise --out "$folder/noise.vti" || fail "noise as .vti"
grep -q 'WholeExtent="0 127 0 127 0 127"' "$folder/noise.vti" || fail "noise.vti has another size"
headless noise && fail "a window of noise without a display"
grep -q 'no display' "$folder/log" || fail "a missing window of noise is not told"
"$view" --help | grep -q "Examples" || fail "--help has no examples"
"$view" partitions --help | grep -q -- "--slice" || fail "partitions --help does not tell --slice"
[ $failures -eq 0 ] && echo "all hold"
exit $((failures > 0))
