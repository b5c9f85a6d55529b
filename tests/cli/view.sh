#!/usr/bin/env bash
# The command line of sightline-view. usage: view.sh FOLDER_OF_PROGRAMS
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
view=$(realpath -- "${1:?usage: view.sh FOLDER_OF_PROGRAMS}")/sightline-view
partitions=("$view" partitions --accel kd-tree --scene soup:200)
make_broken_meshes
unset DISPLAY WAYLAND_DISPLAY

run "$view" --help
expect_exit 0
expect_quiet
expect_prints partitions
run "$view" partitions --help
expect_exit 0
for word in --accel --scene --depth --slice --out; do expect_prints "$word"; done
run "$view" list
expect_exit 0
for word in kd-tree brute-force teapot soup; do expect_prints "$word"; done

refuses 2 help "$view"
refuses 2 subcommand "$view" nothing
refuses 2 --no-such-option "${partitions[@]}" --no-such-option --out a.vtp
refuses 2 --accel "$view" partitions --scene teapot --out a.vtp
refuses 2 --scene "$view" partitions --accel kd-tree --out a.vtp
refuses 2 no-such-tree "$view" partitions --accel no-such-tree --scene teapot --out a.vtp
refuses 2 brute-force "$view" partitions --accel no-such-tree --scene teapot --out a.vtp # lists what there is
refuses 2 no_such_field "${partitions[@]}" --set no_such_field=1 --out a.vtp
refuses 2 max_leaf_size "${partitions[@]}" --set max_leaf_size=-1 --out a.vtp
refuses 2 depth "${partitions[@]}" --depth 5:x --out a.vtp
refuses 2 slice "${partitions[@]}" --slice w=3 --out a.vtp
refuses 2 size "${partitions[@]}" --size 0x0 --out a.png
refuses 2 a.bmp "${partitions[@]}" --out a.bmp
refuses 2 soup "$view" partitions --accel kd-tree --scene soup:0 --out a.vtp
refuses 1 display "${partitions[@]}" # a window, and nowhere to open it
refuses 1 no-such-file.ply "$view" partitions --accel kd-tree --scene no-such-file.ply --out a.vtp
while IFS= read -r mesh; do
  refuses 1 "$(basename -- "$mesh")" "$view" partitions --accel kd-tree --scene "$mesh" --out a.vtp
done < <(broken_meshes)
for out in /dev/null/a.vtp /dev/null/a.png /dev/null/a.gltf; do refuses 1 /dev/null "${partitions[@]}" --out "$out"; done
mkdir -p "$scratch/taken.vtp"
refuses 1 taken.vtp "${partitions[@]}" --out "$scratch/taken.vtp"

for out in a.vtp a.gltf a.png; do
  run "${partitions[@]}" --out "$out"
  expect_exit 0
  expect_no_output
  expect_file "$out"
  check 'only the file that was asked for' test "$(ls -A "$work")" = "$out"
done
finish
