#!/usr/bin/env bash
# The command line of sightline-stability, and its page in a browser. usage: stability.sh FOLDER_OF_PROGRAMS
# shellcheck source=tests/cli/lib.sh disable=SC2016
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
stability=$(realpath -- "${1:?usage: stability.sh FOLDER_OF_PROGRAMS}")/sightline-stability

run "$stability" --help
expect_exit 0
expect_quiet
for word in --case --group --level --accel --quick --list --explain --out --json --html fast watertight precise exact always \
  naive policy 'Exit status'; do
  expect_prints "$word"
done

run bash -c '"$0" --case sph-far --quick >/dev/full' "$stability"
expect_exit 1
expect_says 'standard output: cannot be written'

# ---- What is refused, before anything is asked

refuses 2 --no-such-option "$stability" --no-such-option
refuses 2 "unknown case 'sph-fra'; near are sph-far" "$stability" --case sph-fra
refuses 2 "unknown case 'sph-fra'; near are sph-far" "$stability" --case sph-far,sph-fra
refuses 2 "unknown case 'nothing-*'" "$stability" --case 'nothing-*'
refuses 2 "unknown case ''" "$stability" --case ''
refuses 2 "unknown group 'spheer'; near are sphere" "$stability" --group spheer
refuses 2 "unknown level 'watertigt'; near are watertight" "$stability" --level watertigt
refuses 2 "unknown structure 'kd-tee'; near are kd-tree" "$stability" --accel kd-tee
refuses 2 "unknown case 'sph-fra'; near are sph-far" "$stability" --explain sph-fra
refuses 2 'expected one case, found' "$stability" --explain 'sph-*'
refuses 2 '--out: expected with --explain' "$stability" --out a.svg
refuses 2 'ends in .svg' "$stability" --explain sph-far --out a.png
refuses 2 '--list: expected without' "$stability" --list --html
refuses 2 '--explain: expected without' "$stability" --explain sph-far --json a.json
refuses 2 '--explain: expected without' "$stability" --explain sph-far --group sphere
refuses 2 'no case is left' "$stability" --quick --case sph-pole --accel kd-tree
refuses 1 'expected a file that can be written' "$stability" --quick --case sph-pole --json /dev/null/a.json
refuses 1 'expected a file that can be written' "$stability" --quick --case sph-pole --html /dev/null/a.html
refuses 1 'expected a file' "$stability" --quick --explain sph-pole --out /dev/null/a.svg
refuses 1 'a folder' "$stability" --quick --case sph-pole --json /

# ---- Some cases

run "$stability" --list
expect_exit 0
expect_quiet
grep '^  ' "$scratch/stdout" | sed 's/^ *//; s/ .*//' >"$scratch/ids"
check 'a list of cases' test "$(wc -l <"$scratch/ids")" -gt 0
run "$stability" --list --group sphere
expect_exit 0
check 'only spheres' test "$(head -n 1 "$scratch/stdout")" = sphere
spheres=$(grep -c '^  ' "$scratch/stdout")
run "$stability" --list --group sphere,plane --case 'sph-*' --case pln-in-plane
expect_exit 0
expect_prints pln-in-plane
check 'spheres and a plane' test "$(grep -c '^  ' "$scratch/stdout")" -gt 2

run "$stability" --quick --case sph-pole,sph-far
expect_exit 0
expect_quiet
expect_no_file
for word in sph-pole sph-far watertight 'is wrong nowhere: 2 cases' '10% of their questions'; do expect_prints "$word"; done
run "$stability" --quick --case sph-far --level exact
expect_exit 0
check 'one column' bash -c '! grep -q watertight "$1"' - "$scratch/stdout"

run "$stability" --explain sph-far --quick
expect_exit 0
expect_quiet
for word in inputs expected why oracle 'naive code' questions for true got '--explain sph-far' out/stability/sph-far.svg; do
  expect_prints "$word"
done
expect_file out/stability/sph-far.svg
check 'a drawing' grep -q '^<svg .*xmlns="http://www.w3.org/2000/svg"' "$work/out/stability/sph-far.svg"
run "$stability" --explain sph-far --quick --out new/a.svg
expect_exit 0
expect_file new/a.svg

# ---- All cases

run "$stability" --quick --json all.json --html
expect_exit 0
expect_says 'wrote all.json'
expect_says 'wrote out/stability/index.html'
check 'a line a case' diff -q <(grep '^  ' "$scratch/stdout" | sed '/^  [a-z]*  *[0-9]/d; s/^ *//; s/ .*//') "$scratch/ids"
run_again node -e '
  const report = JSON.parse(require("fs").readFileSync("all.json"));
  const { schema, share, machine, cases, keeps_promises, summary } = report;
  if (schema !== "sightline-stability 1" || share !== 0.1 || !machine.flags || !keeps_promises) throw report;
  for (const one of cases) {
    console.log(one.id);
    if (!one.why || !one.answers.length || one.answers.some((each) => each.asked < 1 || !each.first.inputs)) throw one;
    if (one.naive.some((each) => each.wrong < 1 || !each.first_wrong)) throw one;
  }
  if (summary.cases !== cases.length || summary.wrong_at_default.length > 0) throw summary;'
expect_exit 0
check 'the same cases as JSON' cmp -s "$scratch/stdout" "$scratch/ids"

# ---- The page, and a drawing

page() { run_again "$root/tests/cli/page.mjs" "$@"; }
shown='[...document.querySelectorAll("tr.row")].filter((row) => row.checkVisibility()).length'
type_text='((text) => { const input = document.getElementById("text"); input.value = text; input.dispatchEvent(new Event("input")); })'
choose='((id, value) => { const one = document.getElementById(id); one.value = value; one.dispatchEvent(new Event("input")); })'
open_row='document.querySelector("#sph-far button").click()'
# Labels of all drawings stay in their frames; letters as this machine has them.
outside='document.querySelectorAll("tr.detail").forEach((row) => { row.hidden = false; }),
  [...document.querySelectorAll("svg.sketch")].flatMap((svg) => [...svg.querySelectorAll("text")].filter((text) => {
    const { x, y, width, height } = text.getBBox(), frame = svg.viewBox.baseVal;
    return x < 0 || y < 0 || x + width > frame.width || y + height > frame.height;
  }).map((text) => `${svg.closest("tr").id}: ${text.textContent}`)).join("; ")'
wide='document.documentElement.scrollWidth <= innerWidth'
page out/stability/index.html --eval "$shown" --eval "$type_text('SPH-far'), $shown" \
  --eval "$type_text('no such words'), $shown" --eval "document.getElementById('clear').click(), $shown" \
  --eval "$choose('group', 'sphere'), $shown" --eval "document.getElementById('clear').click(), $shown" \
  --eval "document.querySelector('#sph-far-detail svg').checkVisibility()" \
  --eval "$open_row, document.querySelector('#sph-far-detail svg').checkVisibility()" --eval 'location.hash' \
  --eval "$open_row, document.querySelector('#sph-far-detail svg').checkVisibility()" --eval "$wide" \
  --eval 'document.querySelectorAll("svg.sketch").length' --eval "$outside" --size 390x844 --eval "$wide"
expect_exit 0
expect_quiet
all=$(wc -l <"$scratch/ids")
check 'all rows, filters, an open case, drawings with their labels inside' diff <(printf '%s\n' "$all" 1 0 "$all" "$spheres" "$all" \
  false true '#sph-far' false true "$all" '' true) "$scratch/stdout"
run "$stability" --explain sph-far --quick --out a.svg
page a.svg --eval 'document.documentElement.nodeName'
expect_exit 0
check 'an SVG' test "$(cat "$scratch/stdout")" = svg
finish
