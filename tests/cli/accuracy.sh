#!/usr/bin/env bash
# The command line of sightline-accuracy, and its page as a browser shows it. usage: accuracy.sh FOLDER_OF_PROGRAMS
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
accuracy=$(realpath -- "${1:?usage: accuracy.sh FOLDER_OF_PROGRAMS}")/sightline-accuracy
page=$root/tests/cli/page.mjs

run "$accuracy" --help
expect_exit 0
expect_quiet
for word in --axis --quick --html --charts --json --seed; do expect_prints "$word"; done
run "$accuracy" --list
expect_exit 0
expect_quiet
for word in triangle box sphere quadratic torus query offset volume build noise gradient matrix tessellation samples \
  adaptive cut-off; do expect_prints "$word "; done

refuses 2 "unknown axis 'no-such-axis'" "$accuracy" --axis no-such-axis
refuses 2 quadratic "$accuracy" --axis no-such-axis # the message lists what there is
refuses 2 no-such-option "$accuracy" --no-such-option
refuses 2 stray "$accuracy" stray
refuses 2 rounds "$accuracy" --rounds 0
refuses 2 seed "$accuracy" --seed many
refuses 2 "expected a whole number from 0 on, found '-1'" "$accuracy" --seed=-1
refuses 2 "found 'NaN'" "$accuracy" --seed NaN
refuses 2 "unknown axis ''" "$accuracy" --axis box,,
refuses 1 'expected a folder of scenes, found nothing' "$accuracy" --axis box --data /nowhere
refuses 2 table "$accuracy" --json -
refuses 2 table "$accuracy" --html -
refuses 1 /dev/null "$accuracy" --axis box --quick --rounds 3 --json /dev/null/out.json
refuses 1 /dev/null "$accuracy" --axis box --quick --rounds 3 --html /dev/null/out.html
refuses 1 /dev/null "$accuracy" --axis box --quick --rounds 3 --charts /dev/null/charts

run "$accuracy" --axis quadratic --quick --rounds 3
expect_exit 0
for word in 'so that nothing is resolved' 'not resolved'; do expect_prints "$word"; done

run "$accuracy" --axis box,quadratic --quick --rounds 7 --json out.json --html out.html --charts charts
expect_exit 0
for word in 'Ize, 2 ulp' 'Kahan fma double' 'per million' 'A/A' 'ns/test'; do expect_prints "$word"; done
for file in out.json out.html charts/box-1.png charts/box-1.svg charts/quadratic-3.png; do expect_file "$file"; done
# Marks within the picture: an ellipse for each on the front.
check 'marks in the SVG' grep -q -E '<ellipse|<circle [^>]*cx="[0-9]{2,3}' "$work/charts/box-1.svg"
check 'both axes in the JSON' python3 - "$work/out.json" <<'PYTHON'
import json, sys
report = json.load(open(sys.argv[1]))
assert [axis['name'] for axis in report['axes']] == ['box', 'quadratic'], report['axes']
box = {c['name']: c for c in report['axes'][0]['panels'][0]['choices']}
assert box['ours float']['wrong_per_million'] == 0 < box['min and max, divided']['wrong_per_million']
assert all(c['seconds']['low'] <= c['seconds']['median'] <= c['seconds']['high'] for c in box.values())
PYTHON

if has_browser; then
  run_again node "$page" out.html --eval "document.querySelectorAll('svg').length" \
    --eval "document.querySelectorAll('svg .point').length" --eval "document.querySelector('svg .line').getAttribute('d')[0]" \
    --eval "document.querySelector('svg .point').dispatchEvent(new MouseEvent('mousemove', {clientX: 9, clientY: 9}))" \
    --eval "document.getElementById('tip').textContent.includes('per test') ? 'told' : 'nothing told'" \
    --eval "getComputedStyle(document.getElementById('tip')).visibility" \
    --eval "document.querySelector('svg .point').dispatchEvent(new MouseEvent('mouseleave'))" \
    --eval "getComputedStyle(document.getElementById('tip')).visibility"
  expect_exit 0
  check 'charts, marks, a line, and a tip that comes and goes' diff "$scratch/stdout" - <<'TEXT'
4
29
M
true
told
visible
true
hidden
TEXT
fi
finish
