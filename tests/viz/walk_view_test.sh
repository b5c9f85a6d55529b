#!/bin/bash
# Checks sightline-view walk from outside: walk_view_test.sh FOLDER_OF_PROGRAMS. Exit 0 when all hold.
set -u
view=$1/sightline-view
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0

fail() {
  echo "FAIL $1"
  failures=$((failures + 1))
}

walk=(walk --scene teapot:2)

# expect STATUS PATTERN ARGUMENTS...: exit status, and exactly one line on stderr that matches.
expect() {
  local status=$1 pattern=$2
  shift 2
  "$view" "${walk[@]}" "$@" >"$folder/stdout" 2>"$folder/stderr"
  local found=$?
  [ $found -eq "$status" ] || fail "'$*': exit $found instead of $status: $(head -1 "$folder/stderr")"
  [ "$(wc -l <"$folder/stderr")" -eq 1 ] || fail "'$*': $(wc -l <"$folder/stderr") lines on stderr"
  grep -qE -- "$pattern" "$folder/stderr" || fail "'$*': no '$pattern' in: $(head -1 "$folder/stderr")"
}

# A run without any display and without Xvfb.
headless() { env -u DISPLAY PATH=/nonexistent "$view" "${walk[@]}" "$@" 2>"$folder/log"; }

out=(--out "$folder/a.json")
expect 2 "accelerator 'octopus'" --accel octopus "${out[@]}"
expect 2 "--ray" --ray 1,2,3 "${out[@]}"
expect 2 "--ray" --ray 0,0,0,0,0,0 "${out[@]}"
expect 2 "--ray" --ray 0,0,0,1e60,0,0 "${out[@]}"
expect 2 "--ray" --ray 0,0,nan,1,0,0 "${out[@]}"
expect 2 "--earlier" --earlier 1 "${out[@]}"
expect 2 "--pick.* X from" --pick 1900,500 "${out[@]}"
expect 2 "--pick.* X from" --pick 500.5,500 "${out[@]}"
expect 2 "--pick" --pick 500,400 --ray 0,0,0,1,0,0 "${out[@]}"
expect 2 "--step.* from 0 to" --step 100000 "${out[@]}"
expect 2 "--step.* counted from the end" --step -100000 "${out[@]}"
expect 2 "--size" --size 400x300 "${out[@]}"
expect 2 "--zoom" --zoom 0 "${out[@]}"
expect 2 "--out" --out "$folder/a.svg"
expect 2 "--frames" --every 2 "${out[@]}"
expect 2 "--every" --every 0 --frames "$folder/frames"
touch "$folder/file"
expect 1 "$folder/file" --out "$folder/file/a.json"
headless
[ $? -eq 1 ] && grep -q "no display" "$folder/log" || fail "a window without a display: $(cat "$folder/log")"
headless --out "$folder/a.png"
[ $? -eq 1 ] && grep -q "xvfb" "$folder/log" || fail "a picture without Xvfb: $(cat "$folder/log")"
[ -z "$(find "$folder" -name '*a.*')" ] || fail "a refused output left a file: $(ls -A "$folder")"

# Data, of boxes, spheres, polyhedra and what puts nothing aside, without a display
for accel in grid sphere-tree bsp-tree; do
  headless --accel "$accel" --out "$folder/w.json" --out "$folder/w.vtp" --out "$folder/w.gltf" ||
    fail "$accel: $(cat "$folder/log")"
  grep -q '"steps"' "$folder/w.json" && grep -q '"kind": "candidate"' "$folder/w.json" || fail "$accel: no steps"
  grep -q 'Name="state"' "$folder/w.vtp" || fail "$accel.vtp has no state"
  grep -q '"accessors"' "$folder/w.gltf" || fail "$accel.gltf is no glTF"
done
headless --ray 100,100,100,1,0,0 --out "$folder/nothing.json" || fail "a ray that meets nothing: $(cat "$folder/log")"

# Pictures
if command -v Xvfb >/dev/null; then
  small=(--size 960x540)
  for picture in "--accel grid --step 3 --pick 300,200" "--accel bih --set bih.lazy=true --after 5 --step 0"; do
    for name in one two; do
      # shellcheck disable=SC2086
      env -u DISPLAY "$view" "${walk[@]}" "${small[@]}" $picture --out "$folder/$name.png" 2>"$folder/log" ||
        fail "walk $picture: $(cat "$folder/log")"
    done
    cmp -s "$folder/one.png" "$folder/two.png" || fail "walk $picture twice differs"
    [ "$(wc -c <"$folder/one.png")" -gt 20000 ] || fail "walk $picture has only $(wc -c <"$folder/one.png") bytes"
  done
  env -u DISPLAY "$view" "${walk[@]}" "${small[@]}" --frames "$folder/frames" --every 12 2>"$folder/log" ||
    fail "frames: $(cat "$folder/log")"
  [ -f "$folder/frames/step-00000.png" ] && [ -f "$folder/frames/step-00012.png" ] || fail "frames are missing"
  [ -f "$folder/frames/step-00001.png" ] && fail "a frame too many"
  cmp -s "$folder/frames/step-00000.png" "$folder/frames/step-00012.png" && fail "two steps look the same"
fi
[ $failures -eq 0 ] && echo "all hold"
exit $((failures > 0))
