#!/usr/bin/env bash
# The command line of sightline-scenes. usage: scenes.sh FOLDER_OF_PROGRAMS
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
scenes=$(realpath -- "${1:?usage: scenes.sh FOLDER_OF_PROGRAMS}")/sightline-scenes
data=$root/data/scenes

run "$scenes" --help
expect_exit 0
expect_quiet
for word in SCENE --out --size --export glTF 'Exit status'; do expect_prints "$word"; done
refuses 2 --no-such-option "$scenes" --no-such-option
refuses 2 'WxH from 16x16' "$scenes" --size 1x1 teapot
refuses 2 'expected a scene to write' "$scenes" --export a.glb
refuses 2 'found "kettle"' "$scenes" kettle
refuses 2 'expected a size from 1 to 128' "$scenes" teapot:0
refuses 1 'expected a file' "$scenes" none.json
refuses 1 'one of the extensions' "$scenes" none.doc

run "$scenes" "$data/rocket.json"
expect_exit 0
expect_quiet
for word in orbit '  rocket' body steel 'lights' 'cameras' 'flight' '6 s'; do expect_prints "$word"; done

run "$scenes" "$data/rocket.json" --export rocket.glb --out pictures --size 64x48
expect_exit 0
expect_file rocket.glb
expect_file pictures/index.html
expect_file pictures/rocket.png
run_again "$scenes" rocket.glb --export again.gltf
expect_exit 0
expect_prints orbit
expect_file again.gltf
run_again "$scenes" again.gltf
expect_exit 0
expect_prints porthole

run "$scenes" "$data/kitchen-table.json" --export table.glb
expect_exit 0
expect_says 'found solids; left out'
expect_file table.glb
refuses 1 'the extension .glb or .gltf' "$scenes" teapot:1 --export teapot.obj

printf '{"objects": [{"geometry": {"sphere": {"radius": "big"}}}]}' >"$scratch/bad.json"
refuses 1 '/objects/0/geometry/sphere/radius: expected a number, found "big"' "$scenes" "$scratch/bad.json"
printf '{"include": "self.json"}' >"$scratch/self.json"
refuses 1 'self.json -> self.json' "$scenes" "$scratch/self.json"

finish
