#include <string_view>

#include "bench/claims/run.h"
#include "bench/subcommand.h"

namespace sightline::bench {
namespace {

/// Colors that differ to every eye (Okabe and Ito, "Color Universal Design", 2008), with a dash for each as well.
constexpr std::string_view head = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Sightline: the course's claims, measured</title>
<link rel="icon" href="data:,">
<style>
:root { --paper: #fff; --ink: #1f2430; --soft: #5c6370; --faint: #d9dce3; --band: #f3f5f8; --link: #0072b2;
        --holds: #007a58; --limit: #8a6100; --fails: #b8321f; --open: #5c6370;
        --c0: #0072b2; --c1: #d55e00; --c2: #009e73; --c3: #a8508a; --c4: #2f8fc4; --c5: #b07d00; color-scheme: light dark; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #15181e; --ink: #e6e8ec; --soft: #a2a9b5; --faint: #363c48; --band: #1d222a; --link: #56b4e9;
          --holds: #2bc495; --limit: #e6b84c; --fails: #ff8a75; --open: #a2a9b5;
          --c0: #56b4e9; --c1: #f08a4b; --c2: #2bc495; --c3: #d88bbd; --c4: #9ad0f0; --c5: #e6b84c; } }
body { margin: 0 auto; padding: 1.5rem; max-width: 72rem; background: var(--paper); color: var(--ink);
       font: 15px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.6rem; margin: 0 0 .3rem; } h2 { margin: 0; font-size: 1.3rem; }
p { margin: .3rem 0; max-width: 60rem; } .soft { color: var(--soft); }
a { color: var(--link); } a:focus-visible, summary:focus-visible { outline: 2px solid var(--link); }
section { margin-top: 2.6rem; border-top: 1px solid var(--faint); padding-top: 1.2rem; }
.holds { --mark: var(--holds); } .limit { --mark: var(--limit); } .fails { --mark: var(--fails); } .open { --mark: var(--open); }
.verdict { color: var(--mark); font-weight: 600; white-space: nowrap; } .name { color: var(--soft); font-size: 13px; }
.reason { border-left: 4px solid var(--mark); padding: .3rem .8rem; background: var(--band); }
dl { display: grid; grid-template-columns: 6.5rem 1fr; gap: .2rem .6rem; margin: .6rem 0; max-width: 60rem; }
dt { color: var(--soft); } dd { margin: 0; }
.charts { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 26rem), 1fr)); gap: 1rem; margin: 1rem 0; }
figure { margin: 0; min-width: 0; } figcaption { font-weight: 600; font-size: 14px; }
svg { width: 100%; height: auto; background: var(--band); border-radius: 6px; display: block; }
svg text { fill: var(--soft); font-size: 12px; } svg .grid { stroke: var(--faint); stroke-width: 1; }
svg path { fill: none; stroke: var(--line); stroke-width: 2; } svg circle { fill: var(--line); }
.legend { list-style: none; margin: .4rem 0 0; padding: 0; font-size: 13px; }
.legend li { display: flex; gap: .5rem; align-items: center; } .legend svg { width: 30px; height: 10px; background: none; flex: none; }
.legend .power { color: var(--soft); margin-left: auto; white-space: nowrap; font-variant-numeric: tabular-nums; }
.wide { overflow-x: auto; } table { border-collapse: collapse; font-size: 13px; }
th, td { padding: .15rem .6rem; text-align: left; border-bottom: 1px solid var(--faint); vertical-align: top; }
td.number, th.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
@media (max-width: 40rem) { dl { grid-template-columns: 1fr; } dt { margin-top: .4rem; } }
summary { cursor: pointer; color: var(--link); margin: .4rem 0; }
</style></head><body>
<h1>The course's claims, measured</h1>
<p class="soft">Each statement has an experiment and a rule that was fixed before measuring; the verdict is what the rule
makes of the figures. Times are medians of rounds in which all take turns, with intervals that hold the true median with
95 %; counts are exact.</p>
<p class="soft" id="machine"></p><div class="wide"><table id="verdicts"></table></div><main id="all"></main>
<script type="application/json" id="data">)";

constexpr std::string_view script = R"(</script>
<script>
'use strict';
const data = JSON.parse(document.getElementById('data').textContent);
const make = (name, attributes = {}, parent = null, text = '') => {
  const is_drawn = ['svg', 'g', 'text', 'line', 'path', 'circle', 'title'].includes(name);
  const element = is_drawn ? document.createElementNS('http://www.w3.org/2000/svg', name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text !== '') element.textContent = text;
  if (parent) parent.append(element);
  return element;
};
const kind_of = { 'holds': 'holds', 'holds with a limit': 'limit', 'does not hold': 'fails', 'not resolved': 'open' };
const digits = (x, n = 3) => x === null ? 'unknown' : x === 0 ? '0' : Math.abs(x) >= 1e15 || Math.abs(x) < 1e-3 ?
  x.toExponential(1) : Math.abs(x) >= 999.5 ? Math.round(x).toLocaleString('en-US') : String(+x.toPrecision(n));
const short = (x) => x >= 1e15 || x < 1e-3 ? x.toExponential(0) : x >= 1e9 ? `${x / 1e9}G` : x >= 1e6 ? `${x / 1e6}M` :
  x >= 1e3 ? `${x / 1e3}k` : String(+x.toPrecision(3));
const with_unit = (text, unit) => unit === '' ? text : unit === 'x' ? text + '\u00d7' : `${text} ${unit}`;
const dashes = ['', '7 4', '2 3', '9 3 2 3', '12 4', '4 2'];
const style_of = (i) => ({ style: `--line: var(--c${i % 6})`, 'stroke-dasharray': dashes[(i + Math.floor(i / 6)) % 6] });

function ticks(lo, hi) {
  const all = [], step = Math.max(1, Math.ceil((hi - lo) / 6));
  for (let d = Math.floor(lo); d <= hi; ++d)
    for (const m of hi - lo < 2.2 ? [1, 2, 5] : [1])
      if ((((d % step) + step) % step) === 0 && d + Math.log10(m) >= lo - 1e-9 && d + Math.log10(m) <= hi + 1e-9) all.push(m * 10 ** d);
  return all;
}

// All on scales of logarithms, so that a power law is a straight line and its exponent the slope.
function chart(title, growths, parent) {
  const width = 480, height = 300, left = 62, right = 16, top = 14, bottom = 40;
  const own = make('figure', {}, parent), points = growths.map((g) => g.x.map((x, i) => [x, g.y[i]]).filter(([x, y]) => x > 0 && y > 0));
  const all = points.flat(), unit = [...new Set(growths.map((g) => g.y_unit))].filter((u) => u).join(', ');
  if (all.length === 0) return own.remove();
  make('figcaption', {}, own, title + (unit ? `, ${unit}` : ''));
  const span = (k) => { const values = all.map((p) => Math.log10(p[k])), lo = Math.min(...values), hi = Math.max(...values),
    pad = Math.max(0.08, 0.04 * (hi - lo)); return [lo - pad, hi + pad]; };
  const [x0, x1] = span(0), [y0, y1] = span(1);
  const x_of = (x) => left + (Math.log10(x) - x0) / (x1 - x0) * (width - left - right);
  const y_of = (y) => height - bottom - (Math.log10(y) - y0) / (y1 - y0) * (height - bottom - top);
  const svg = make('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img', class: 'chart' }, own);
  make('title', {}, svg, `${title}: ${growths.length} lines on scales of logarithms`);
  for (const x of ticks(x0, x1)) {
    make('line', { class: 'grid', x1: x_of(x), x2: x_of(x), y1: top, y2: height - bottom }, svg);
    make('text', { x: x_of(x), y: height - bottom + 16, 'text-anchor': 'middle' }, svg, short(x));
  }
  for (const y of ticks(y0, y1)) {
    make('line', { class: 'grid', x1: left, x2: width - right, y1: y_of(y), y2: y_of(y) }, svg);
    make('text', { x: left - 7, y: y_of(y) + 4, 'text-anchor': 'end' }, svg, short(y));
  }
  make('text', { x: width - right, y: height - 7, 'text-anchor': 'end' }, svg, `${growths[0].x_unit} \u2192`);
  const legend = make('ul', { class: 'legend' }, own);
  growths.forEach((g, i) => {
    const group = make('g', { class: 'series' }, svg), style = style_of(i);
    make('path', { ...style, d: points[i].map(([x, y], k) => `${k ? 'L' : 'M'}${x_of(x).toFixed(1)} ${y_of(y).toFixed(1)}`).join('') }, group);
    for (const [x, y] of points[i]) {
      const dot = make('circle', { style: style.style, cx: x_of(x).toFixed(1), cy: y_of(y).toFixed(1), r: 3.2 }, group);
      make('title', {}, dot, `${g.name}: ${with_unit(digits(y), g.y_unit)} at ${digits(x)} ${g.x_unit}`);
    }
    const line = make('li', {}, legend), key = make('svg', { viewBox: '0 0 30 10' }, line);
    make('path', { ...style, d: 'M0 5L30 5' }, key);
    make('span', {}, line, g.name);
    if (g.fit) make('span', { class: 'power' }, line, `n^${g.fit.exponent.toFixed(2)}` +
      (g.fit.standard_error === null ? '' : ` \u00b1 ${digits(g.fit.standard_error, 1)}`));
  });
}

function figure_table(claim, parent) {
  const details = make('details', {}, parent);
  make('summary', {}, details, `${claim.figures.length} figures`);
  const own = make('table', {}, make('div', { class: 'wide' }, details)), row = make('tr', {}, make('thead', {}, own));
  make('th', {}, row, 'figure'), make('th', { class: 'number' }, row, 'value'), make('th', { class: 'number' }, row, 'interval');
  const body = make('tbody', {}, own);
  for (const f of claim.figures) {
    const line = make('tr', {}, body);
    make('td', {}, line, f.name), make('td', { class: 'number' }, line, with_unit(digits(f.median), f.unit));
    make('td', { class: 'number' }, line, f.low === null ? 'unknown' : f.low === f.high ? 'exact' : `${digits(f.low)} to ${digits(f.high)}`);
  }
}

const m = data.machine;
document.getElementById('machine').textContent = `Sightline ${m.versions.sightline}, ${data.date}. ${m.processor}, ` +
  `${m.hardware_threads} hardware threads, ${m.system}; load ${m.load === null ? 'unknown' : digits(m.load)}. ` +
  `${m.compiler} ${m.flags}. ${data.rounds} rounds${data.quick ? ', quick' : ''}, seed ${data.seed}.` +
  (m.assertions ? ' Assertions are on in this build: its times say little.' : '');
for (const claim of data.claims) {
  const kind = kind_of[claim.verdict], row = make('tr', { class: kind }, document.getElementById('verdicts'));
  make('a', { href: `#${claim.name}` }, make('td', {}, row), claim.statement);
  make('td', { class: 'verdict' }, row, claim.verdict);
  const section = make('section', { id: claim.name, class: kind }, document.getElementById('all'));
  make('div', { class: 'name' }, section, claim.name);
  make('h2', {}, section, claim.statement);
  const reason = make('p', { class: 'reason' }, section);
  make('span', { class: 'verdict' }, reason, claim.verdict);
  reason.append(`: ${claim.reason}`);
  const about = make('dl', {}, section);
  for (const part of ['experiment', 'rule']) make('dt', {}, about, part), make('dd', {}, about, claim[part]);
  const charts = new Map();
  for (const g of claim.growths) {
    const key = g.chart || `${g.y_unit || 'counts'} over ${g.x_unit}`;
    charts.set(key, [...(charts.get(key) ?? []), g]);
  }
  const shelf = make('div', { class: 'charts' }, section);
  for (const [title, growths] of charts) chart(title, growths, shelf);
  figure_table(claim, section);
}
</script></body></html>
)";

}  // namespace

std::string page_text(const ClaimsReport& report) {
  return std::string(head) + json_within_page(json_text(report)) + std::string(script);
}

}  // namespace sightline::bench
