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

run "$view" csg --help
expect_exit 0
expect_quiet
for word in --solid --ray --pick --precision --accel --out Examples hit; do expect_prints "$word"; done
run "$view" csg --list
expect_exit 0
for word in widget lens menger:2 not-a-sphere FILE.json; do expect_prints "$word"; done

run "$view" graph --help
expect_exit 0
expect_quiet
for word in --scene --select --drag --time --frames --bounds --level --out Examples bubble; do expect_prints "$word"; done

refuses 1 'no display' "$view"
refuses 1 'no display' "$view" --scene teapot:3 --accel bih --page noise
refuses 2 subcommand "$view" nothing
refuses 2 --no-such-option "${partitions[@]}" --no-such-option --out a.vtp
refuses 2 NAME "$view" partitions --accel '' --out a.vtp
refuses 2 'one structure' "$view" partitions --accel kd-tree,bih --out a.vtp
refuses 2 max_leaf_size "$view" partitions --accel kd-tree:max_leaf_size=-1 --out a.vtp
refuses 2 threads "${partitions[@]}" --threads -1 --out a.vtp
refuses 2 'a number' "${partitions[@]}" --zoom nan --out a.vtp
refuses 2 'a number' "${partitions[@]}" --azimuth nan --out a.vtp
refuses 2 'a number' "${partitions[@]}" --elevation nan --out a.vtp
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

noise=("$view" noise --out a.png)
refuses 2 'perlin|improved|value|white, found simplex' "${noise[@]}" --kind simplex
refuses 2 'cubic|quintic, found linear' "${noise[@]}" --ease linear
refuses 2 turbulence "${noise[@]}" --fractal multi
refuses 2 isosurfaces "${noise[@]}" --show everything
refuses 2 'two numbers' "${noise[@]}" --point 3
refuses 2 'two numbers' "${noise[@]}" --point nan,1
refuses 2 z=POSITION "${noise[@]}" --slice x=1
refuses 2 'from 1 to 32' "${noise[@]}" --fractal fbm --octaves 0
refuses 2 'above 0, at most 1' "${noise[@]}" --gain 0
refuses 2 'above 1' "${noise[@]}" --lacunarity 1
refuses 2 'above 0' "${noise[@]}" --frequency nan
refuses 2 'power of two' "${noise[@]}" --period 100
refuses 2 '.vti' "$view" noise --out a.jpg
refuses 2 'at least 800x500' "${noise[@]}" --size 640x480
refuses 1 /dev/null "$view" noise --out /dev/null/a.png

run "$view" wood --list
expect_exit 0
expect_prints texture_frequency
refuses 2 marble "$view" wood --texture bark --out a.png
refuses 2 texture_frequency "$view" wood --texture wood:rings=3 --out a.png
refuses 2 'from 0 to' "$view" wood --texture wood:noise_amplitude=-1 --out a.png
refuses 2 wood "$view" wood --tune --texture marble --out a.png
refuses 2 '.png' "$view" wood --out a.vtp
refuses 2 'at least 800x500' "$view" wood --size 640x480 --out a.png
refuses 2 'has a gradient' "$view" normals --kind white --out a.png
refuses 2 'not in range' "$view" normals --divisions 1 --out a.png
refuses 2 '0 to 0.5' "$view" normals --amplitude nan --out a.png
refuses 2 '0.01 to 1000' "${noise[@]}" --extent nan
refuses 1 /dev/null "$view" normals --out /dev/null/a.png
refuses 2 'file is required' "$view" picture
refuses 1 'no display' "$view" picture none.png

csg=("$view" csg --solid lens)
refuses 2 six "${csg[@]}" --ray 1,2,3 --out a.json
refuses 2 six "${csg[@]}" --ray '' --out a.json
refuses 2 finite "${csg[@]}" --ray 0,0,0,nan,0,1 --out a.json
refuses 2 finite "${csg[@]}" --ray inf,0,0,1,0,0 --out a.json
refuses 2 finite "${csg[@]}" --ray 0,0,0,1,0,0x --out a.json
refuses 2 'not zero' "${csg[@]}" --ray 1,2,3,0,0,0 --out a.json
refuses 2 '2^-500' "${csg[@]}" --ray 1,2,3,0,1e-200,0 --out a.json
refuses 2 pixel "${csg[@]}" --pick 5 --out a.json
refuses 2 'X from 28 to' "${csg[@]}" --pick 1599,450 --out a.json
refuses 2 'X from 28 to' "${csg[@]}" --pick 27,450 --out a.json
refuses 2 pixel "${csg[@]}" --pick 300.5,450 --out a.json
refuses 2 pixel "${csg[@]}" --pick -3,nan --out a.json
refuses 2 excludes "${csg[@]}" --pick 300,450 --ray 0,0,0,1,0,0 --out a.json
refuses 2 watertight "${csg[@]}" --precision double --out a.json
refuses 2 octopus "${csg[@]}" --accel octopus --out a.json
refuses 2 'name alone' "${csg[@]}" --accel kd-tree:max_leaf_size=4 --out a.json
refuses 2 'at least 800x450' "${csg[@]}" --size 640x480 --out a.png
refuses 2 a.vtp "${csg[@]}" --out a.vtp
refuses 2 not-a-sphere "$view" csg --solid octopus --out a.json # lists what there is
refuses 2 'from 1 to 4' "$view" csg --solid menger:9 --out a.json
refuses 2 'no size' "$view" csg --solid lens:2 --out a.json
refuses 1 no-such.json "$view" csg --solid no-such.json --out a.json
refuses 1 /dev/null "${csg[@]}" --out /dev/null/a.png
printf '{"op":"diff",\n"args":[' >"$scratch/broken.json"
refuses 1 broken.json:2 "$view" csg --solid "$scratch/broken.json" --out a.json
printf '{"op":"diff","args":[{"prim":"sphere","c":[0,0,0],"r":1},{"prim":"box","lo":[0,0]}]}' >"$scratch/short.json"
refuses 1 /args/1 "$view" csg --solid "$scratch/short.json" --out a.json
printf '{"op":"minus","args":[]}' >"$scratch/op.json"
refuses 1 /op "$view" csg --solid "$scratch/op.json" --out a.json
printf '{"prim":"sphere","c":[0,0,0],"r":-1}' >"$scratch/negative.json"
refuses 1 negative.json "$view" csg --solid "$scratch/negative.json" --out a.json

for level in fast watertight precise exact; do
  run "${csg[@]}" --ray -2.25,0.25,0,1,0,0 --precision "$level" --accel kd-tree --out a.json
  expect_exit 0
  expect_quiet
  expect_file a.json
  expect_prints 'wasInA isInA wasInB isInB'
  expect_prints "precision  $level"
done
expect_prints '0.7817541634481457      0      1     0      0      discarded  sphere red (0)'
expect_prints 'hit'
run "${csg[@]}" --ray 0,5,0,1,0,0 --out a.json
expect_exit 0
expect_prints none
printf '{"op":"compl","args":[{"prim":"half","n":[0,0,1],"w":0,"material":"unheard-of"}]}' >"$scratch/half.json"
run "$view" csg --solid "$scratch/half.json" --ray 0,0,-1,0,0,2 --out a.png --out a.json --size 800x450
expect_exit 0
expect_prints '[0.5, inf]'
expect_file a.png
expect_file a.json
run "$view" csg --solid swiss-cheese:40 --pick 300,450 --out a.json
expect_exit 0

graph=("$view" graph --scene levels:3)
refuses 2 'such as left,' "${graph[@]}" --select lefty --out a.png # lists names like it
refuses 2 'of 17 nodes' "${graph[@]}" --select '#17' --out a.png
refuses 2 'of 17 nodes' "${graph[@]}" --select '' --out a.png
refuses 2 'three numbers' "${graph[@]}" --select left --drag 1,2 --out a.png
refuses 2 'three numbers' "${graph[@]}" --select left --drag nan,0,0 --out a.png
refuses 2 'three numbers' "${graph[@]}" --select left --drag 1e300,0,0 --out a.png
refuses 2 --select "${graph[@]}" --drag 1,0,0 --out a.png
refuses 2 excludes "${graph[@]}" --select left --drag 1,0,0 --time 0:1 --out a.png
refuses 2 'two numbers' "${graph[@]}" --time 3 --out a.png
refuses 2 'two numbers' "${graph[@]}" --time 2:1 --out a.png
refuses 2 'two numbers' "${graph[@]}" --time 0:inf --out a.png
refuses 2 'a scene that moves' "$view" graph --scene teapot:2 --time 0:1 --out a.png
refuses 2 'in range' "${graph[@]}" --time 0:1 --frames 1 --out a.png
refuses 2 '2 to 12' "${graph[@]}" --select left --drag 1,0,0 --frames 13 --out a.png
refuses 2 'beside it' "${graph[@]}" --frames 4 --out a.png
refuses 2 cylinder "${graph[@]}" --bounds ellipsoid --out a.png
refuses 2 --level "${graph[@]}" --level 3:1 --out a.png
refuses 2 'from 0 to 4' "${graph[@]}" --level 9 --out a.png
refuses 2 'at least 800x500' "${graph[@]}" --size 640x480 --out a.png
refuses 2 .png "${graph[@]}" --out a.vtp
refuses 2 .png "${graph[@]}" --out ''
refuses 2 'a number' "${graph[@]}" --zoom nan --out a.png
refuses 2 rocket "$view" graph --scene octopus --out a.png
refuses 1 no-such.json "$view" graph --scene no-such.json --out a.png
refuses 1 /dev/null "${graph[@]}" --out /dev/null/a.png
for kind in box sphere cylinder; do
  run "${graph[@]}" --select top/left --drag=-0.5,0.25,0 --bounds "$kind" --size 800x500 --out a.png
  expect_exit 0
  expect_quiet
  expect_file a.png
  expect_prints '3rd          0'
  expect_prints 'moves along  4'
done
run "$view" graph --scene rocket --time 0:3 --frames 3
expect_exit 0
expect_says 'no display'
expect_prints 't = 1.5 s'

# Pages: without a subcommand, the file of one is what its subcommand writes.
run "$view" window --help
expect_exit 0
expect_quiet
for word in --page --accel --scene --ray --pick --out F8 Examples; do expect_prints "$word"; done
pages=("$view" --scene teapot:3 --accel box-tree)
refuses 2 'one of partitions, walk, build, heat, compare, csg, noise, graph' "${pages[@]}" --page tree --out a.png
refuses 2 'walk, heat or compare' "${pages[@]}" --page noise --ray 0,0,9,0,0,-1 --out a.png
refuses 2 'six finite numbers' "${pages[@]}" --ray 1,2 --out a.json
refuses 2 excludes "${pages[@]}" --ray 0,0,9,0,0,-1 --pick 4,4 --out a.json
refuses 2 max_leaf_size "${pages[@]}" --set box-tree.max_leaf_size=-1 --out a.png
refuses 2 'at least 1200x751' "${pages[@]}" --size 800x600
refuses 2 brute-force "$view" --accel brute-force --page build --out a.json
refuses 1 /dev/null "${pages[@]}" --out /dev/null/a.png
run "${pages[@]}" --ray=-9,1.5,0.2,1,0,0 --out a.json
expect_exit 0
run_again "$view" walk --scene teapot:3 --accel box-tree --ray=-9,1.5,0.2,1,0,0 --out b.json
expect_exit 0
check 'a page and its subcommand to be the same' cmp -s "$work/a.json" "$work/b.json"
run "${pages[@]}" --out a.vtp
expect_exit 0
run_again "$view" partitions --scene teapot:3 --accel box-tree --out b.vtp
expect_exit 0
check 'the first page to be partitions' cmp -s "$work/a.vtp" "$work/b.vtp"

refuses 2 'one structure, found 2' "$view" heat --accel kd-tree,bih --out a.png
refuses 2 --against "$view" heat --against kd-tree --out a.png
run "$view" heat --scene teapot:3 --size 960x540 --out a.png --out a.json
expect_exit 0
expect_file a.png
check 'figures of one structure' grep -q '"kd-tree"' "$work/a.json"
run_again "$view" --page heat --scene teapot:3 --size 960x540 --out b.png
expect_exit 0
check 'the same map twice' cmp -s "$work/a.png" "$work/b.png"

run "$view" compare --help
expect_exit 0
expect_quiet
for word in --accel --scene --show --count --against --alone --ray --pick --turn --out Examples histogram; do
  expect_prints "$word"
done
compare=("$view" compare --accel kd-tree,bih,kd-tree:max_leaf_size=32 --scene teapot:3)
refuses 2 'two to six structures, found 1' "$view" compare --accel kd-tree --out a.png
refuses 2 'found 7' "$view" compare --accel bih,bih,bih,bih,bih,bih,bih --out a.png
refuses 2 no-such-tree "$view" compare --accel kd-tree,no-such-tree --out a.png
refuses 2 max_leaf_size "$view" compare --accel kd-tree,bih:max_leaf_size=-1 --out a.png
refuses 2 'no accelerator' "${compare[@]}" --set grid.no_such_field=1 --out a.png
refuses 2 'walk, work, difference, histogram or all' "${compare[@]}" --show everything --out a.png
refuses 2 'nodes, candidates, all' "${compare[@]}" --count triangles --out a.png
refuses 2 --against "${compare[@]}" --against grid --out a.png
refuses 2 --alone "${compare[@]}" --alone 4 --out a.png
refuses 2 'six finite numbers' "${compare[@]}" --ray 1,2,3 --out a.png
refuses 2 'six finite numbers' "${compare[@]}" --ray 0,0,0,nan,0,0 --out a.png
refuses 2 'not zero' "${compare[@]}" --ray 0,0,0,0,0,0 --out a.png
refuses 2 'finite as float' "${compare[@]}" --ray 0,0,0,1e200,0,0 --out a.png
refuses 2 'a panel shows' "${compare[@]}" --pick 2,2 --out a.png
refuses 2 'a panel shows' "${compare[@]}" --pick 100.5,200 --out a.png
refuses 2 'a panel shows' "${compare[@]}" --pick 1e300,200 --out a.png
refuses 2 excludes "${compare[@]}" --pick 100,200 --ray 0,0,0,1,0,0 --out a.png
refuses 2 --pick "${compare[@]}" --turn 30 --out a.png
refuses 2 'a number' "${compare[@]}" --zoom nan --out a.png
refuses 2 'at least 960x540' "${compare[@]}" --size 800x500 --out a.png
refuses 2 .json "${compare[@]}" --out a.bmp
refuses 2 no-such-scene "$view" compare --scene no-such-scene --out a.json
refuses 1 /dev/null "${compare[@]}" --out /dev/null/a.json
run "${compare[@]}" --size 960x540 --against bih --out a.json --out a.csv
expect_exit 0
expect_quiet
expect_prints 'the same bits in all 3 structures'
expect_file a.json
expect_file a.csv
check 'the labels in the data' grep -q '^"\?kd-tree:max_leaf_size=32"\?,candidates,0,0,' "$work/a.csv"
check 'equal hits in the data' grep -q '"same_hits": true' "$work/a.json"
run "${compare[@]}" --size 960x540 --show all --count candidates --against bih --out a.png --out a.svg
expect_exit 0
for kind in walk work difference histogram; do expect_file "a-$kind.png"; done
run_again "${compare[@]}" --size 960x540 --show walk --count candidates --against bih --out b.png --out b.svg
expect_exit 0
check 'the same walks twice' cmp -s "$work/a-walk.png" "$work/b.png"
check 'the same histograms twice' cmp -s "$work/a.svg" "$work/b.svg"
check 'work and walks to look different' test "$(cksum <"$work/a-work.png")" != "$(cksum <"$work/a-walk.png")"
check 'a drawing in SVG' grep -q '<svg' "$work/a.svg"
run "${compare[@]}"
expect_exit 0
expect_says 'no display'
finish
