#include <string_view>

#include "bench/accuracy/run.h"
#include "bench/subcommand.h"

namespace sightline::bench {
namespace {

/// Colors that differ to every eye (Okabe and Ito, "Color Universal Design", 2008), with a shape for each as well.
constexpr std::string_view head = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Sightline: accuracy and what it costs</title>
<link rel="icon" href="data:,">
<style>
:root { --paper: #fff; --ink: #1f2430; --soft: #5c6370; --faint: #d9dce3; --band: #f3f5f8;
        --front: #0072b2; --dominated: #b84a00; --open: #007a58; color-scheme: light dark; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #15181e; --ink: #e6e8ec; --soft: #a2a9b5; --faint: #363c48; --band: #1d222a;
          --front: #56b4e9; --dominated: #e69f00; --open: #2bc495; } }
body { margin: 0 auto; padding: 1.5rem; max-width: 76rem; background: var(--paper); color: var(--ink);
       font: 15px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.6rem; margin: 0 0 .3rem; } h2 { margin: 2.2rem 0 .2rem; font-size: 1.25rem; }
h3 { margin: 1.2rem 0 0; font-size: 1rem; } p { margin: .2rem 0 .6rem; color: var(--soft); max-width: 60rem; overflow-wrap: anywhere; }
nav { display: flex; flex-wrap: wrap; }
nav a { color: var(--front); margin-right: .9rem; } a:focus-visible, .point:focus-visible { outline: 2px solid var(--front); }
.panel { display: grid; grid-template-columns: minmax(0, 1fr); gap: .6rem; margin-bottom: 1.6rem; }
svg { width: 100%; min-width: 680px; height: auto; background: var(--band); border-radius: 6px; }
svg text { fill: var(--ink); font-size: 12px; } svg .soft { fill: var(--soft); }
.point text { paint-order: stroke; stroke: var(--band); stroke-width: 4px; }
svg .grid { stroke: var(--faint); stroke-width: 1; } svg .line { fill: none; stroke: var(--front); stroke-width: 1.6; }
.front { --mark: var(--front); } .dominated { --mark: var(--dominated); } .open { --mark: var(--open); }
.point { fill: var(--mark); stroke: var(--mark); cursor: pointer; } .dominated .shape { fill: var(--band); stroke-width: 2; }
.point line { stroke-width: 1.5; }
.wide { overflow-x: auto; } table { border-collapse: collapse; font-size: 13px; white-space: nowrap; }
th, td { padding: .15rem .5rem; text-align: right; border-bottom: 1px solid var(--faint); }
th:first-child, td:first-child { text-align: left; padding-left: 0; } tr.front td:first-child { font-weight: 600; }
td.place { color: var(--mark); white-space: normal; min-width: 13rem; } tr.lit { background: var(--band); }
#tip { position: fixed; pointer-events: none; visibility: hidden; background: var(--ink); color: var(--paper);
       padding: .35rem .6rem; border-radius: 5px; font-size: 13px; white-space: pre; z-index: 9; }
</style></head><body>
<h1>Accuracy, and what it costs</h1>
<p>Each mark is a choice: farther left is more accurate, farther down is faster. The line joins those that no other
beats in both. Errors are taken against exact or very wide numbers; times are medians of rounds in which all choices of
a panel take turns, with intervals that hold the true median with <span id="confidence"></span>.</p>
<p id="machine"></p><nav id="axes"></nav><main id="all"></main><div id="tip" role="status"></div>
<script type="application/json" id="data">)";

constexpr std::string_view script = R"(</script>
<script>
'use strict';
const data = JSON.parse(document.getElementById('data').textContent);
const tip = document.getElementById('tip');
const make = (name, attributes = {}, parent = null, text = '') => {
  const is_drawn = ['svg', 'g', 'text', 'line', 'path', 'circle', 'rect', 'title'].includes(name);
  const element = is_drawn ? document.createElementNS('http://www.w3.org/2000/svg', name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text !== '') element.textContent = text;
  if (parent) parent.append(element);
  return element;
};
const kind_of = { 'front': 'front', 'dominated': 'dominated', 'not resolved': 'open', 'unknown': 'open' };
const error_of = (panel, choice) => panel.front_by === panel.wrong_name ? choice.wrong_per_million :
  panel.front_by === 'RMS error' ? choice.rms_error : choice.maximum_error;
const of_all = (choice) => choice.wrong_interval === null ? '' : `, ${choice.wrong_interval.map((x) => digits(x, 2)).join(' to ')} with 95 %, of ${choice.decisions.toLocaleString('en')}`;
const digits = (x, n = 3) => x === null ? '' : x === 0 ? '0' : Math.abs(x) >= 1e6 || Math.abs(x) < 1e-2 ?
  x.toExponential(1) : String(+x.toPrecision(n));
// In units that suit `like`, so that an interval has one unit.
const time = (seconds, like = seconds) => { const ns = seconds * 1e9, size = like * 1e9;
  return size >= 1e6 ? digits(ns / 1e6) + ' ms' : size >= 1e4 ? digits(ns / 1e3) + ' \u00b5s' : digits(ns) + ' ns'; };
const interval = (s) => `${time(s.low, s.median)} to ${time(s.high, s.median)}`;
const standing = (choice) => choice.place === 'dominated' ?
  `${digits(choice.time_over_that.median)}x the time of ${choice.beside}` :
  choice.place === 'not resolved' ? `not resolved: ${choice.beside}` : choice.place;
const told = (panel, choice) => [choice.name,
  choice.maximum_error === null ? '' : `error: ${digits(choice.maximum_error)} at most, ${digits(choice.rms_error)} RMS ${panel.error_unit}`,
  choice.wrong_per_million === null ? '' : `${panel.wrong_name}: ${digits(choice.wrong_per_million)} per million${of_all(choice)}`,
  `time: ${time(choice.seconds.median)} per ${panel.unit}, ${interval(choice.seconds)}`,
  ...Object.entries(choice.extras).map(([name, value]) => `${name}: ${digits(value, 4)}`), standing(choice)]
  .filter((line) => line).join('\n');
const show_tip = (text, x, y) => {
  tip.textContent = text, tip.style.visibility = 'visible';
  tip.style.left = Math.max(4, Math.min(x + 14, innerWidth - tip.offsetWidth - 4)) + 'px';
  tip.style.top = Math.max(4, Math.min(y + 14, innerHeight - tip.offsetHeight - 4)) + 'px';
};
const hide_tip = () => { tip.style.visibility = 'hidden', tip.textContent = ''; };

function chart(panel, parent, rows) {
  const width = 960, height = 360, left = 76, right = 24, top = 18, bottom = 52, zero = 70;
  const shown = panel.choices.filter((c) => error_of(panel, c) !== null);
  const svg = make('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img' }, make('div', { class: 'wide' }, parent));
  make('title', {}, svg, `${panel.name}: error and time of ${shown.length} choices`);
  const errors = shown.map((c) => error_of(panel, c)), some = errors.filter((e) => e > 0);
  const has_zero = errors.some((e) => e === 0), from = left + (has_zero ? zero : 0);
  const span = (values) => { const lo = Math.log10(Math.min(...values)), hi = Math.log10(Math.max(...values)),
    pad = Math.max(0.12, 0.06 * (hi - lo)); return [lo - pad, hi + pad]; };
  const [x0, x1] = some.length ? span(some) : [0, 1];
  const [y0, y1] = span(shown.flatMap((c) => [c.seconds.low * 1e9, c.seconds.high * 1e9]));
  const x_of = (e) => e > 0 ? from + (Math.log10(e) - x0) / (x1 - x0) * (width - right - 90 - from) : left + zero / 2;
  const y_of = (s) => height - bottom - (Math.log10(s * 1e9) - y0) / (y1 - y0) * (height - bottom - top);
  const ticks = (lo, hi) => { const all = [], step = Math.max(1, Math.ceil((hi - lo) / 8));
    for (let d = Math.floor(lo); d <= hi; ++d) for (const m of hi - lo < 1.6 ? [1, 2, 5] : [1])
      if (d % step === 0 && d + Math.log10(m) >= lo && d + Math.log10(m) <= hi) all.push(m * 10 ** d);
    return all; };
  if (has_zero) {
    make('line', { class: 'grid', x1: from, x2: from, y1: top, y2: height - bottom, 'stroke-dasharray': '3 4' }, svg);
    make('text', { class: 'soft', x: left + zero / 2, y: height - bottom + 18, 'text-anchor': 'middle' }, svg, '0');
  }
  for (const e of some.length ? ticks(x0, x1) : []) {
    make('line', { class: 'grid', x1: x_of(e), x2: x_of(e), y1: top, y2: height - bottom }, svg);
    make('text', { class: 'soft', x: x_of(e), y: height - bottom + 18, 'text-anchor': 'middle' }, svg, digits(e));
  }
  for (const ns of ticks(y0, y1)) {
    make('line', { class: 'grid', x1: left, x2: width - right, y1: y_of(ns / 1e9), y2: y_of(ns / 1e9) }, svg);
    make('text', { class: 'soft', x: left - 8, y: y_of(ns / 1e9) + 4, 'text-anchor': 'end' }, svg, time(ns / 1e9));
  }
  make('text', { x: width - right, y: height - 12, 'text-anchor': 'end' }, svg, panel.front_by === panel.wrong_name ?
    `${panel.wrong_name} per million \u2192` : `${panel.front_by} ${panel.error_unit} \u2192`);
  make('text', { x: left, y: height - 12 }, svg, `time per ${panel.unit} \u2191`);
  const line = shown.filter((c) => c.place === 'front' || c.place === 'not resolved').sort((a, b) =>
    error_of(panel, a) - error_of(panel, b) || b.seconds.median - a.seconds.median);
  make('path', { class: 'line', d: line.map((c, i) => `${i ? 'L' : 'M'}${x_of(error_of(panel, c))} ${y_of(c.seconds.median)}`).join('') }, svg);
  const boxes = [];
  const order = [...shown].sort((a, b) => (a.place !== 'front') - (b.place !== 'front'));
  for (const choice of order) boxes.push({ x: x_of(error_of(panel, choice)) - 6, y: y_of(choice.seconds.median) - 6, w: 12, h: 12 });
  for (const choice of order) {
    const x = x_of(error_of(panel, choice)), y = y_of(choice.seconds.median), kind = kind_of[choice.place];
    const g = make('g', { class: `point ${kind}`, tabindex: 0, 'aria-label': told(panel, choice), 'data-choice': choice.name }, svg);
    make('line', { x1: x, x2: x, y1: y_of(choice.seconds.low), y2: y_of(choice.seconds.high) }, g);
    const shape = kind === 'front' ? make('circle', { cx: x, cy: y, r: 5.5 }, g) : kind === 'dominated' ?
      make('rect', { x: x - 4.5, y: y - 4.5, width: 9, height: 9 }, g) :
      make('path', { d: `M${x} ${y - 6.5}L${x + 6.5} ${y}L${x} ${y + 6.5}L${x - 6.5} ${y}Z` }, g);
    shape.classList.add('shape');
    const w = choice.name.length * 6.3, places = [[x + 10, y - 6], [x + 10, y + 8], [x + 10, y - 20], [x - w - 10, y - 6],
      [x - w / 2, y - 24], [x - w / 2, y + 10]];
    const free = places.map(([bx, by]) => ({ x: bx, y: by, w, h: 13 })).find((b) => b.x > 2 && b.x + b.w < width &&
      b.y > 2 && b.y + b.h < height - bottom + 4 &&
      boxes.every((o) => b.x > o.x + o.w || o.x > b.x + b.w || b.y > o.y + o.h || o.y > b.y + b.h));
    if (free) boxes.push(free), make('text', { x: free.x, y: free.y + 11 }, g, choice.name);
    const light = (is_lit) => rows.get(choice.name).classList.toggle('lit', is_lit);
    g.addEventListener('mousemove', (e) => (show_tip(told(panel, choice), e.clientX, e.clientY), light(true)));
    g.addEventListener('mouseleave', () => (hide_tip(), light(false)));
    g.addEventListener('focus', () => { const r = g.getBoundingClientRect(); show_tip(told(panel, choice), r.right, r.bottom), light(true); });
    g.addEventListener('blur', () => (hide_tip(), light(false)));
  }
}

function table(panel) {
  const wide = make('div', { class: 'wide' }), own = make('table', {}, wide), rows = new Map();
  const extras = Object.keys(panel.choices[0].extras);
  const heading = make('tr', {}, make('thead', {}, own)), body = make('tbody', {}, own);
  for (const name of ['choice', 'maximum', 'RMS', `${panel.wrong_name} per million`, 'of', `per ${panel.unit}`, 'interval', ...extras, 'standing'])
    make('th', { scope: 'col' }, heading, name);
  for (const c of panel.choices) {
    const row = make('tr', { class: kind_of[c.place] }, body);
    for (const text of [c.name, digits(c.maximum_error, 2), digits(c.rms_error, 2), digits(c.wrong_per_million) + (c.wrong_interval === null ? '' : ` (${c.wrong_interval.map((x) => digits(x, 2)).join(' to ')})`),
      c.decisions > 0 ? c.decisions.toLocaleString('en') : '', time(c.seconds.median), interval(c.seconds), ...extras.map((e) => digits(c.extras[e] ?? null, 4))])
      make('td', {}, row, text);
    make('td', { class: 'place' }, row, standing(c));
    rows.set(c.name, row);
  }
  return [wide, rows];
}

const surest = Math.max(...data.axes.flatMap((a) => a.panels.flatMap((p) => p.choices.map((c) => c.seconds.confidence))));
document.getElementById('confidence').textContent = surest >= 0.95 ? '95 %' :
  `no more than ${digits(100 * surest, 2)} %: of so few rounds nothing is resolved`;
const m = data.machine;
document.getElementById('machine').textContent = `Sightline ${m.versions.sightline}, ${data.date}. ${m.processor}, ` +
  `${m.hardware_threads} hardware threads, ${m.system}; load ${m.load === null ? 'unknown' : digits(m.load)}. ` +
  `${m.compiler} ${m.flags}. ${data.rounds} rounds${data.quick ? ', quick' : ''}, seed ${data.seed}.` +
  (m.assertions ? ' Assertions are on in this build: its times say little.' : '');
for (const axis of data.axes) {
  make('a', { href: `#${axis.name}` }, document.getElementById('axes'), axis.name);
  const section = make('section', { id: axis.name }, document.getElementById('all'));
  make('h2', {}, section, axis.name);
  make('p', {}, section, axis.question);
  for (const panel of axis.panels) {
    const own = make('div', { class: 'panel' }, section), about = make('div', {}, own);
    make('h3', {}, about, panel.name);
    make('p', {}, about, `${panel.description}. The same choice timed twice: ${digits(panel.same_over_same.median)}x, ` +
      `${digits(panel.same_over_same.low)} to ${digits(panel.same_over_same.high)}.`);
    const [wide, rows] = table(panel);
    chart(panel, own, rows);
    own.append(wide);
  }
}
const note = make('p', {}, document.getElementById('machine').parentNode.insertBefore(document.createElement('div'),
  document.getElementById('axes')));
for (const [kind, sign, text] of [['front', '\u25cf', ' on the front'], ['open', '\u25c6', ' not resolved'], ['dominated', '\u25a1', ' dominated']]) {
  make('span', { class: kind, style: 'color: var(--mark)' }, note, sign);
  note.append(text + '\u2003');
}
</script></body></html>
)";

}  // namespace

std::string page_text(const AccuracyReport& report) {
  return std::string(head) + json_within_page(json_text(report)) + std::string(script);
}

}  // namespace sightline::bench
