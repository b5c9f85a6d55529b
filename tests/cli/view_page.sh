#!/usr/bin/env bash
# The command line of `sightline-view page`, and its page as a browser shows it. usage: view_page.sh FOLDER_OF_PROGRAMS
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
view=$(realpath -- "${1:?usage: view_page.sh FOLDER_OF_PROGRAMS}")/sightline-view
browse=$root/tests/cli/page.mjs
soup=("$view" page --scene soup:200)
unset DISPLAY WAYLAND_DISPLAY

run "$view" page --help
expect_exit 0
expect_quiet
for word in --accel --scene --ray --pick --html Examples; do expect_prints "$word"; done

run "${soup[@]}" --html a.html
if [[ $status == 1 ]]; then # built without three.js
  expect_one_line
  expect_says libjs-three
  expect_no_file
  finish
fi

refuses 2 html "${soup[@]}"
refuses 2 brute-force "${soup[@]}" --accel no-such-tree --html a.html # lists what there is
refuses 2 'each structure once' "${soup[@]}" --accel bih,kd-tree,bih --html a.html
refuses 2 max_leaf_size "${soup[@]}" --accel kd-tree:max_leaf_size=-1 --html a.html
refuses 2 bih "${soup[@]}" --accel kd-tree --set bih.max_leaf_size=8 --html a.html
refuses 2 six "${soup[@]}" --ray 1,2,3 --html a.html
refuses 2 six "${soup[@]}" --ray 0,0,0,nan,0,1 --html a.html
refuses 2 'not zero' "${soup[@]}" --ray 1,2,3,0,0,0 --html a.html
refuses 2 'finite as floats' "${soup[@]}" --ray 1e300,2,3,1,0,0 --html a.html
refuses 2 'X from 0 to 1199' "${soup[@]}" --pick 1200,5 --html a.html
refuses 2 'Y from 0 to 299' "${soup[@]}" --size 400x300 --pick 7,300 --html a.html
refuses 1 no-such-file.ply "$view" page --scene no-such-file.ply --html a.html
refuses 1 /dev/null "${soup[@]}" --html /dev/null/a.html

run "${soup[@]}" --accel all --html a.html
expect_exit 0
expect_file a.html
check 'a line for each structure, and the head' test "$(wc -l <"$scratch/stdout")" = 9
cp "$work/a.html" "$scratch/once.html"
run "${soup[@]}" --accel all --threads 1 --html a.html
check 'the same page again' cmp -s "$scratch/once.html" "$work/a.html"

page=("$view" page --accel 'kd-tree,box-tree,grid' --pick '600,450' --ray '0,1,9,0.02,0.01,-1' --html a.html)
run "${page[@]}"
expect_exit 0
expect_quiet
check 'no more than a few megabytes' test "$(stat -c %s "$work/a.html")" -lt 6000000
cp "$scratch/stdout" "$scratch/walks"

# What the page counts at a step, reckoned here from the steps alone: kinds, and cells on the stack.
python3 - "$work/a.html" >"$scratch/expected" <<'PYTHON'
import base64, json, re, struct, sys
page = open(sys.argv[1]).read()
data = json.loads(re.search(r'id=data>(.*?)</script>', page, re.S).group(1))
def numbers(text, kind):
    raw = base64.b64decode(text)
    return struct.unpack(f'<{len(raw) // struct.calcsize(kind)}{kind}', raw)
for step in (6, 12):
    walk = data['structures'][1]['walks'][0]
    kinds = numbers(walk['steps']['kind_u8'], 'B')
    node = numbers(walk['cells']['node_u32'], 'I')
    since, until = numbers(walk['since_u32'], 'I'), numbers(walk['until_u32'], 'I')
    stack = sorted((c for c in range(len(node)) if since[c] <= step < until[c]), key=lambda c: until[c])
    print(json.dumps([node[numbers(walk['steps']['cell_u32'], 'I')[step]], [kinds[:step + 1].count(k) for k in range(4)],
                      [node[c] for c in stack]], separators=(',', ':')))
PYTHON
check 'two steps to compare' test "$(wc -l <"$scratch/expected")" = 2

if has_browser; then
  # Keeps what expressions with a value print.
  browsing() {
    run_again node "$browse" a.html --size 1100x700 "$@"
    expect_exit 0
    grep -v '^null$' "$scratch/stdout" >"$scratch/told" || true
  }
  tab() { printf "document.querySelectorAll('#tabs button')[%d].click()" "$1"; }
  now='JSON.stringify([sightline.state.cell, sightline.state.counters, sightline.state.stack])'
  right=(--key ArrowRight --key ArrowRight --key ArrowRight)

  # Steps; then, at the last one, all structures have counted what the table on stdout tells of both rays.
  browsing --eval "document.getElementById('trouble').hidden" --eval "$(tab 1)" "${right[@]}" "${right[@]}" --eval "$now" \
    --eval "for (let i = 0; i < 6; ++i) document.getElementById('forward').click()" --eval "$now" \
    --key ArrowLeft --eval 'sightline.state.step' --key Home --eval 'sightline.state.step' \
    --eval "[...document.querySelectorAll('#counters dd')].map((dd) => dd.textContent).join()" \
    --key Space --eval 'new Promise((done) => setTimeout(() => done(sightline.state.step > 0), 1000))' --key Space \
    --eval "JSON.stringify(
    sightline.data.structures.map((raw, i) => sightline.data.rays.map((ray, r) => {
      document.querySelectorAll('#tabs button')[i].click();
      const choice = document.getElementById('ray');
      choice.value = r, choice.dispatchEvent(new Event('change'));
      sightline.go_to(1e9);
      return [raw.label, ...sightline.state.counters].join(' ');
    }))).replace(/[\[\]\"]/g, '').replaceAll(',', '\n')"
  {
    printf 'true\n%s\n%s\n' "$(head -1 "$scratch/expected")" "$(tail -1 "$scratch/expected")"
    printf '11\n0\n1,0,0,0\ntrue\n'
    awk 'NR > 1 {print $1, $3, $4, $5, $6}' "$scratch/walks"
  } >"$scratch/wanted"
  check 'cells, counters and stacks of steps, by keys and buttons; the counters of the table' \
    diff "$scratch/told" "$scratch/wanted"

  # Depth, leaves and cuts change what is drawn; a drag turns it; the address keeps it all.
  differ='sightline.picture() !== window.before && (window.before = sightline.picture(), true)'
  browsing --eval "window.before = sightline.picture(), null" --eval 'sightline.state.lines / 12 === sightline.state.cells' \
    --drag 300,400,420,440 --eval "$differ" --eval "$differ" \
    --eval 'window.lines = sightline.state.lines, null' --key + --eval 'sightline.state.lines > window.lines' --eval "$differ" \
    --key - --eval 'sightline.state.lines === window.lines' --eval "sightline.set_depth(99), null" \
    --eval 'sightline.state.cells' --key l --eval 'sightline.state.cells' --key l --eval "$differ" --key o \
    --eval 'sightline.state.cells' --key h --eval "document.getElementById('keys').hidden" \
    --eval "new URLSearchParams(location.hash.slice(1)).get('depth')" \
    --size 390x800 --scheme dark --shot narrow.png --eval 'document.documentElement.scrollWidth <= 390' \
    --eval "getComputedStyle(document.body).backgroundColor"
  python3 - "$work/a.html" >"$scratch/expected" <<'PYTHON'
import json, re, sys
data = json.loads(re.search(r'id=data>(.*?)</script>', open(sys.argv[1]).read(), re.S).group(1))
depths = data['structures'][0]['depths']
print('true\ntrue\nfalse\ntrue\ntrue\ntrue')
print(sum(map(sum, depths)), sum(leaves for _, leaves in depths), 'true', sum(depths[-1]), 'false', len(depths) - 1, sep='\n')
print('true\nrgb(20, 23, 29)')
PYTHON
  check 'what is drawn, and how it looks narrow and dark' diff "$scratch/told" "$scratch/expected"
fi
finish
