#!/usr/bin/env bash
# The command line of sightline-bench. usage: bench.sh FOLDER_OF_PROGRAMS
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
bench=$(realpath -- "${1:?usage: bench.sh FOLDER_OF_PROGRAMS}")/sightline-bench
quick=(--quick --rays 500 --rounds 3 --scene soup:200)
make_broken_meshes

run "$bench" --help
expect_exit 0
expect_quiet
for word in --accel --scene --json kd-tree teapot Embree; do expect_prints "$word"; done
run "$bench" --list
expect_exit 0
expect_prints brute-force

refuses 2 no-such-tree "$bench" --accel no-such-tree
refuses 2 brute-force "$bench" --accel no-such-tree # the message lists what there is
refuses 2 'unknown option --no-such-option' "$bench" --no-such-option 5
refuses 2 "'5'" "$bench" --quick 5
refuses 2 'whole number' "$bench" --rays 1e5
refuses 2 table "$bench" --json -
refuses 2 no_such_field "$bench" --accel kd-tree:no_such_field=1
refuses 2 NAME "$bench" --accel kd-tree:8
refuses 2 twice "$bench" --accel kd-tree:max_leaf_size=8,max_depth=9 --accel kd-tree:max_leaf_size=8,max_depth=9
refuses 2 kd-tree "$bench" --set kd-tree.max_leaf_size=-5
refuses 2 ACCEL.OPTION=VALUE "$bench" --set max_leaf_size=5
refuses 2 max_leaf_size "$bench" --set kd-tree.max_leaf_size=nan
refuses 2 expected "$bench" --set nonsense
refuses 2 no-such-work "$bench" --workload no-such-work
refuses 2 rays "$bench" --rays -1
refuses 2 rays "$bench" --rays 1e99
refuses 2 rounds "$bench" --rounds 0
refuses 2 'unknown peer' "$bench" --peer no-such-peer
refuses 2 cgal "$bench" --peer no-such-peer # the message lists what there is
refuses 2 'stands alone' "$bench" --peer none,embree
refuses 2 'unknown level' "$bench" --precision fast,no-such-level
refuses 2 watertight "$bench" --precision no-such-level # the message lists what there is
refuses 2 twice "$bench" --precision fast,watertight,fast
refuses 2 twice "$bench" --precision fast --precision fast
refuses 2 wide-tree "$bench" --stream --accel kd-tree # the message lists those that can
refuses 2 'kd-tree fast' "$bench" --accel kd-tree --precision fast --self-check kd-tree # and what is in the run
refuses 2 terrain "$bench" --growth teapot
refuses 2 growth-to "$bench" --growth soup --growth-to 10
refuses 2 growth-to "$bench" --growth soup --growth-to 1e9
refuses 2 growth-to "$bench" --growth soup --growth-to 20000000
refuses 2 'goes with' "$bench" --growth-to 5000
refuses 2 scene "$bench" --growth soup --scene teapot
refuses 2 'after --' "$bench" --growth soup -- --benchmark_filter=x
refuses 2 stray "$bench" stray
refuses 2 soup "$bench" --scene soup:0
refuses 2 soup "$bench" --scene soup:many
refuses 1 no-such-file.ply "$bench" --scene no-such-file.ply
while IFS= read -r mesh; do
  refuses 1 "$(basename -- "$mesh")" "$bench" "${quick[@]:0:5}" --scene "$mesh" --json out.json
done < <(broken_meshes)
refuses 1 /dev/null "$bench" "${quick[@]}" --json /dev/null/out.json
refuses 1 folder "$bench" "${quick[@]}" --json "$scratch"

run "$bench" "${quick[@]}" --accel kd-tree,brute-force --json out.json
expect_exit 0
expect_prints kd-tree
expect_prints embree
expect_file out.json
check 'only the file that was asked for' test "$(ls -A "$work")" = out.json
run "$bench" "${quick[@]}" --accel kd-tree:max_leaf_size=16,max_depth=5,bih --set bih.lazy=true --json out.json
expect_exit 0
expect_prints kd-tree:max_leaf_size=16,max_depth=5
for option in '"max_depth": *"5"' '"max_leaf_size": *"16"' '"lazy": *"true"'; do
  check "$option in the JSON file" grep -q -e "$option" "$work/out.json"
done
run "$bench" "${quick[@]}" --accel kd-tree --peer all --json out.json
expect_exit 0
for peer in embree embree-high embree-robust; do expect_prints "$peer "; done
check 'no summary of one scene' grep -q '"summary": null' "$work/out.json"
run "$bench" "${quick[@]}" --accel kd-tree --peer none --workload build
expect_exit 0
check 'no peer' bash -c "! grep -q '^embree' '$scratch/stdout'"
run "$bench" "${quick[@]}" --scene soup:300 --accel kd-tree --json out.json
expect_exit 0
expect_prints 'all 2 scenes: soup:200, soup:300'
expect_prints 'speed on bounce rays'
expect_prints interval
check 'a summary in the JSON file' grep -q '"summary": \[' "$work/out.json"
run "$bench" "${quick[@]}" --precision fast,watertight --stream --accel wide-tree,kd-tree,bih:lazy=true --json out.json
expect_exit 0
for name in 'wide-tree' 'wide-tree stream' 'wide-tree fast' 'wide-tree fast stream' 'kd-tree' 'kd-tree fast'; do
  expect_prints "$name "
  check "$name in the JSON file" grep -q "\"name\": \"$name\"" "$work/out.json"
done
for price in 'wide-tree over wide-tree fast' 'wide-tree over wide-tree stream' 'kd-tree over kd-tree fast'; do
  expect_prints "$price"
done
expect_prints 'bih:lazy=true fast is watertight all the same'
check 'prices in the JSON file' grep -q '"over": "wide-tree fast"' "$work/out.json"
run "$bench" "${quick[@]}" --precision watertight --precision fast --accel kd-tree --self-check 'kd-tree fast' --json out.json
expect_exit 1
expect_one_line
expect_says 'kd-tree fast is wrong'
expect_no_file
run "$bench" --growth terrain --growth-to 3000 --quick --rays 300 --accel kd-tree,brute-force --json out.json
expect_exit 0
for word in 'growth of terrain' exponent brute-force embree; do expect_prints "$word"; done
check 'exponents in the JSON file' grep -q '"exponent"' "$work/out.json"
run "$bench" --growth soup --growth-to 3000 --quick --rays 300 --accel kd-tree --self-check kd-tree --json out.json
expect_exit 1
expect_one_line
expect_no_file
run "$bench" "${quick[@]}" --accel kd-tree --self-check kd-tree --json out.json
expect_exit 1
expect_one_line
expect_says kd-tree
expect_no_file

# ---- Solids

solids=(solids --quick --rounds 1)
run "$bench" solids --help
expect_exit 0
expect_quiet
for word in --precision --single --ablation --accel widget cheese:256 solid.use_bounds povray; do expect_prints "$word"; done
refuses 2 'unknown scene' "$bench" solids --scene no-such-scene
refuses 2 cheese:16 "$bench" solids --scene cheese:17 # the message lists what there is
refuses 2 'unknown level' "$bench" solids --precision no-such-level
refuses 2 twice "$bench" solids --precision fast,fast
refuses 2 'unknown accelerator' "$bench" solids --accel no-such-tree
refuses 2 'unknown peer' "$bench" solids --peer no-such-peer
refuses 2 solid.OPTION=VALUE "$bench" solids --set use_bounds=false
refuses 2 use_bounds "$bench" solids --set solid.no_such_option=1
refuses 2 'true or false' "$bench" solids --set solid.use_bounds=5
refuses 2 rounds "$bench" solids --rounds 0
refuses 2 stray "$bench" solids stray
refuses 2 table "$bench" solids --json -
refuses 2 'unknown line' "$bench" solids --self-check no-such-line
refuses 1 /dev/null "$bench" solids --json /dev/null/out.json
mkdir -p "$scratch/empty"
run env PATH="$scratch/empty" "$bench" "${solids[@]}" --scene widget --json out.json
expect_exit 0
expect_prints 'Without POV-Ray, which'
expect_prints 'watertight '
check 'no POV-Ray in the JSON file' grep -q '"povray": null' "$work/out.json"
run "$bench" "${solids[@]}" --scene cheese:1 --scene cheese:16 --scene cheese:4 --peer none --ablation \
  --precision exact,fast --accel kd-tree --set solid.index_from=4 --json out.json
expect_exit 0
for word in 'exact, use_bounds off' 'exact, all off' 'fast ' exponent 'solid in kd-tree'; do expect_prints "$word"; done
check 'exponents in the JSON file' grep -q '"exponent"' "$work/out.json"
run "$bench" "${solids[@]}" --scene widgets --peer none --single
expect_exit 0
for word in 'watertight ' 'watertight single' '64 solids in bih'; do expect_prints "$word"; done
run "$bench" "${solids[@]}" --scene widget --peer none --precision watertight,exact --self-check exact --json out.json
expect_exit 1
expect_one_line
expect_says 'exact is wrong'
expect_no_file
if command -v povray >/dev/null; then
  run "$bench" "${solids[@]}" --scene widget
  expect_exit 0
  expect_prints 'beside POV-Ray'
  expect_prints 'sees otherwise: 0 of coverage'
fi

# ---- Noise

run "$bench" noise --help
expect_exit 0
expect_quiet
for word in --rounds --quick --json --self-check libnoise stb_perlin; do expect_prints "$word"; done
refuses 2 rounds "$bench" noise --rounds 0
refuses 2 stray "$bench" noise stray
refuses 2 table "$bench" noise --json -
refuses 1 /dev/null "$bench" noise --json /dev/null/out.json
run "$bench" noise --quick --rounds 1 --json out.json
expect_exit 0
for word in 'perlin float scalar' 'improved double batch' 'fbm of 8 float batch' 'central differences' 'at the double point'; do
  expect_prints "$word"
done
check 'times in the JSON file' grep -q '"seconds_a_point"' "$work/out.json"
run "$bench" noise --quick --rounds 1 --self-check --json out.json
expect_exit 1
expect_one_line
expect_says 'is wrong, so no times are shown'
expect_no_file

# ---- Scene graphs

run "$bench" graph --help
expect_exit 0
expect_quiet
for word in --rounds --quick --json --self-check cylinders; do expect_prints "$word"; done
refuses 2 rounds "$bench" graph --rounds 0
refuses 2 stray "$bench" graph stray
refuses 2 table "$bench" graph --json -
refuses 1 /dev/null "$bench" graph --json /dev/null/out.json
run "$bench" graph --quick --rounds 1 --json out.json
expect_exit 0
for word in 'cached, root moves' 'depth 256' 'in vain' cylinder teapots 'one leaf' '10,000 nodes, sphere'; do
  expect_prints "$word"
done
check 'times in the JSON file' grep -q '"speed_over_first"' "$work/out.json"
run "$bench" graph --quick --rounds 1 --self-check --json out.json
expect_exit 1
expect_one_line
expect_says 'box is wrong, so no times are shown'
expect_no_file

# ---- Tori

torus=(torus --quick --rays 200 --rounds 3)
run "$bench" torus --help
expect_exit 0
expect_quiet
for word in --minor --precision --rays --json Ferrari; do expect_prints "$word"; done
refuses 2 'unknown level' "$bench" torus --precision no-such-level
refuses 2 twice "$bench" torus --precision fast,fast
refuses 2 minor "$bench" torus --minor 0
refuses 2 minor "$bench" torus --minor nan
refuses 2 minor "$bench" torus --minor thin
refuses 2 rays "$bench" torus --rays 5
refuses 2 rounds "$bench" torus --rounds 0
refuses 2 stray "$bench" torus stray
refuses 2 table "$bench" torus --json -
refuses 2 'unknown line' "$bench" torus --self-check fast # which proves nothing
refuses 1 /dev/null "$bench" torus --json /dev/null/out.json
run "$bench" "${torus[@]}" --json out.json
expect_exit 0
for word in 'Ferrari  ' 'fast ' 'watertight ' 'precise ' 'exact ' 'r/R = 0.5, mixed' 'r/R = 0.005, grazing'; do
  expect_prints "$word"
done
check 'exact has all roots right' bash -c "grep '^exact' '$scratch/stdout' | grep -c '  0  *0\$' | grep -q -x 6"
check 'ratios in the JSON file' grep -q '"time_over_ferrari"' "$work/out.json"
run "$bench" "${torus[@]}" --minor 0.25 --precision exact --self-check exact --json out.json
expect_exit 1
expect_one_line
expect_says 'exact is wrong'
expect_no_file

# ---- Instances, and scenes that move

instances=(instances --quick --count 200 --rays 200 --rounds 2)
run "$bench" instances --help
expect_exit 0
expect_quiet
for word in --count --accel --lower --rays --json Embree; do expect_prints "$word"; done
refuses 2 count "$bench" instances --count 0
refuses 2 count "$bench" instances --count many
refuses 2 rays "$bench" instances --rays 5
refuses 2 no-such-tree "$bench" instances --accel no-such-tree
refuses 2 no-such-tree "$bench" instances --lower no-such-tree
refuses 2 'one structure' "$bench" instances --lower kd-tree,bih
refuses 2 twice "$bench" instances --accel kd-tree,kd-tree
refuses 2 'one level' "$bench" instances --precision fast,watertight
refuses 2 'unknown level' "$bench" instances --precision exact
refuses 2 kettle "$bench" instances --scene kettle
refuses 2 stray "$bench" instances stray
refuses 2 table "$bench" instances --json -
refuses 2 'unknown line' "$bench" instances --self-check embree # which may round otherwise
refuses 1 none.ply "$bench" instances --scene none.ply
refuses 1 /dev/null "$bench" instances --json /dev/null/out.json
run "$bench" "${instances[@]}" --json out.json
expect_exit 0
for word in 'box-tree  ' 'kd-tree  ' 'embree  ' resident camera inside; do expect_prints "$word"; done
check 'memory in the JSON file' grep -q '"resident_bytes"' "$work/out.json"
run "$bench" "${instances[@]}" --accel bih --lower kd-tree --scene soup:300 --precision fast
expect_exit 0
expect_prints 'its mesh and kd-tree'
rm -f "$work/out.json"
run "$bench" "${instances[@]}" --accel kd-tree,bih --self-check bih --json out.json
expect_exit 1
expect_one_line
expect_says 'bih is wrong'
expect_no_file

moving=(moving --levels 4 --frames 5)
run "$bench" moving --help
expect_exit 0
expect_quiet
for word in --levels --frames --accel --json renderLevel; do expect_prints "$word"; done
refuses 2 levels "$bench" moving --levels 1
refuses 2 frames "$bench" moving --frames 0
refuses 2 'can be refitted' "$bench" moving --accel kd-tree
refuses 2 stray "$bench" moving stray
refuses 2 table "$bench" moving --json -
refuses 2 'unknown line' "$bench" moving --self-check kd-tree
refuses 1 /dev/null "$bench" moving --json /dev/null/out.json
run "$bench" "${moving[@]}" --json out.json
expect_exit 0
for word in 'box-tree ' 'wide-tree ' 'bih ' '15 spheres' refitted; do expect_prints "$word"; done
check 'ratios in the JSON file' grep -q '"build_over_refit"' "$work/out.json"
rm -f "$work/out.json"
run "$bench" "${moving[@]}" --self-check bih --json out.json
expect_exit 1
expect_one_line
expect_says 'bih is wrong'
expect_no_file

render=(render --quick --rounds 2)
run "$bench" render --help
expect_exit 0
expect_quiet
for word in --scene --textures --only --precision --json stripped; do expect_prints "$word"; done
refuses 2 'unknown scene' "$bench" render --scene no-such-scene
refuses 2 'unknown level' "$bench" render --precision no-such-level
refuses 2 'unknown way' "$bench" render --textures blurred
refuses 2 'unknown line' "$bench" render --only nobody
refuses 2 'unknown peer' "$bench" render --peer nobody
refuses 2 rounds "$bench" render --rounds 0
refuses 2 stray "$bench" render stray
refuses 1 /dev/null "$bench" render --json /dev/null/out.json
run "$bench" "${render[@]}" --scene widget --json out.json
expect_exit 0
for word in 'plan ' 'plan again' 'stripped ' 'all effects' '"plain"'; do expect_prints "$word"; done
check 'ratios in the JSON file' grep -q '"time_over_plan"' "$work/out.json"
rm -f "$work/out.json"
run "$bench" "${render[@]}" --scene wood --peer none --textures point
expect_exit 0
expect_prints patterned
run "$bench" render --quick --scene wood --only stripped
expect_exit 0
for line in stripped 'all effects'; do
  run "$bench" "${render[@]}" --scene widget --peer none --self-check "$line" --json out.json
  expect_exit 1
  expect_one_line
  expect_says "$line is wrong"
  expect_no_file
done
run "$bench" render --quick --rounds 1 --ladder --json out.json
expect_exit 0
for word in 'hard shadow again' 'soft shadow ' absorption 'motion blur ' 'rays a pixel' 'interval'; do expect_prints "$word"; done
for word in '"time_over_below"' '"counts_per_pixel"' '"resolved"'; do
  check "$word in the JSON file" grep -q -e "$word" "$work/out.json"
done
refuses 1 'fog is wrong, so no times are shown' "$bench" render --quick --rounds 1 --ladder --self-check fog --json out.json
refuses 2 'unknown rung' "$bench" render --ladder --self-check plan
refuses 2 'excludes' "$bench" render --ladder --scene wood
refuses 2 'excludes' "$bench" render --ladder --threads 1
refuses 2 'excludes' "$bench" render --ladder --peer none
run "$bench" render --quick --rounds 1 --threads 1 --scene spheres --scene teapot:2 --json out.json
expect_exit 0
for word in spheres teapot:2 'million rays/s' efficiency; do expect_prints "$word"; done
check 'rates in the JSON file' grep -q '"rays_per_second"' "$work/out.json"
refuses 1 'is wrong, so no times are shown' "$bench" render --quick --threads 1 --scene teapot:2 --self-check 1 --json out.json
refuses 2 'expected numbers from 1' "$bench" render --threads 0
refuses 2 'expected numbers from 1' "$bench" render --threads 1,100000
refuses 2 threads "$bench" render --threads many
refuses 2 twice "$bench" render --threads 1,1
refuses 2 'unknown number of threads' "$bench" render --threads 1 --self-check fog
refuses 2 'kettle' "$bench" render --threads 1 --scene kettle
refuses 1 'none.json' "$bench" render --threads 1 --scene none.json
refuses 1 valgrind env PATH="$scratch/empty" "$bench" render --instructions --json out.json
refuses 2 'unknown scene' "$bench" render --instructions --scene cornell
refuses 2 'excludes' "$bench" render --instructions --rounds 5
finish
