#!/usr/bin/env bash
# The command line of sightline-bench claims, and its page as a browser shows it. usage: claims.sh FOLDER_OF_PROGRAMS
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
bench=$(realpath -- "${1:?usage: claims.sh FOLDER_OF_PROGRAMS}")/sightline-bench
page=$root/tests/cli/page.mjs

run "$bench" claims --help
expect_exit 0
expect_quiet
for word in --claim --quick --html --json --rounds --seed --list 'holds with a limit' 'not resolved'; do
  expect_prints "$word"
done
run "$bench" claims --list
expect_exit 0
expect_quiet
for word in bsp_cost kd_build kd_search lazy_bih bounding_spheres unordered_hierarchies grid_cells; do
  expect_prints "$word "
done

refuses 2 "unknown claim 'no-such-claim'" "$bench" claims --claim no-such-claim
refuses 2 kd_build "$bench" claims --claim no-such-claim # the message lists what there is
refuses 2 no-such-option "$bench" claims --no-such-option
refuses 2 stray "$bench" claims stray
refuses 2 rounds "$bench" claims --rounds 0
refuses 2 table "$bench" claims --json -
refuses 2 table "$bench" claims --html -
refuses 1 /dev/null "$bench" claims --claim grid_cells --quick --json /dev/null/out.json
refuses 1 /dev/null "$bench" claims --claim grid_cells --quick --html /dev/null/out.html

run "$bench" claims --claim kd_search,grid_cells --quick --rounds 3 --json out.json --html out.html
expect_exit 0
for word in 'kd_search' 'Lee and Wong 1977' 'verdict     ' 'exponent' 'stadium' 'grid_cells '; do expect_prints "$word"; done
for file in out.json out.html; do expect_file "$file"; done
check 'both claims in the JSON' python3 - "$work/out.json" <<'PYTHON'
import json, sys
report = json.load(open(sys.argv[1]))
assert [claim['name'] for claim in report['claims']] == ['kd_search', 'grid_cells'], report['claims']
planes = report['claims'][0]['growths'][0]
assert 0.6 < planes['fit']['exponent'] < 0.75, planes  # counted: the same wherever it runs
for claim in report['claims']:
    assert claim['verdict'] in ('holds', 'holds with a limit', 'does not hold', 'not resolved'), claim['verdict']
    assert claim['statement'] and claim['rule'] and claim['reason'] and claim['figures']
PYTHON

if has_browser; then
  run_again node "$page" out.html --eval "document.querySelectorAll('#verdicts tr').length" \
    --eval "document.querySelectorAll('section').length" --eval "document.querySelectorAll('svg.chart').length" \
    --eval "document.querySelectorAll('svg.chart .series').length" \
    --eval "[...document.querySelectorAll('svg.chart path')].every((p) => /^M[-0-9. L]+$/.test(p.getAttribute('d')))" \
    --eval "document.querySelector('.power').textContent.startsWith('n^0.6')"
  expect_exit 0
  check 'verdicts, sections, charts and their lines' diff "$scratch/stdout" - <<'TEXT'
2
2
8
31
true
true
TEXT
fi
finish
