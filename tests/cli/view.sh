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

for word in '--set kd-tree.max_leaf_size=' '--set bih.lazy='; do expect_prints "$word"; done
mv "$scratch/stdout" "$scratch/list"
run "$view" --list
expect_exit 0
check 'the same as list' cmp -s "$scratch/list" "$scratch/stdout"

refuses 2 help "$view"
refuses 2 subcommand "$view"
refuses 2 subcommand "$view" nothing
refuses 2 --no-such-option "${partitions[@]}" --no-such-option --out a.vtp
refuses 2 NAME "$view" partitions --accel '' --out a.vtp
refuses 2 'one structure' "$view" partitions --accel kd-tree,bih --out a.vtp
refuses 2 max_leaf_size "$view" partitions --accel kd-tree:max_leaf_size=-1 --out a.vtp
refuses 2 threads "${partitions[@]}" --threads -1 --out a.vtp
refuses 2 no-such-tree "$view" partitions --accel no-such-tree --scene teapot --out a.vtp
refuses 2 brute-force "$view" partitions --accel no-such-tree --scene teapot --out a.vtp # lists what there is
refuses 2 no_such_field "${partitions[@]}" --set kd-tree.no_such_field=1 --out a.vtp
refuses 2 max_leaf_size "${partitions[@]}" --set kd-tree.max_leaf_size=-1 --out a.vtp
refuses 2 ACCEL.OPTION=VALUE "${partitions[@]}" --set max_leaf_size=8 --out a.vtp
refuses 2 bih "${partitions[@]}" --set bih.max_leaf_size=8 --out a.vtp
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

same=("$view" partitions --scene soup:200 --out "$scratch/same.vtp")
run "${same[@]}" --accel kd-tree:max_leaf_size=16,max_depth=5 --threads 1
expect_exit 0
mv "$scratch/same.vtp" "$scratch/once.vtp"
run "${same[@]}" --set kd-tree.max_leaf_size=16 --set kd-tree.max_depth=5
expect_exit 0
check 'the same cells, however they are asked for' cmp -s "$scratch/once.vtp" "$scratch/same.vtp"
run "$view" partitions --out default.vtp
expect_exit 0
expect_file default.vtp
run "$view" partitions --accel bih:lazy=true --scene soup:200 --out lazy.vtp
expect_exit 0
expect_file lazy.vtp
finish
