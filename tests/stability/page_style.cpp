#include "tests/stability/page.h"

namespace sightline::stability {

// Verdicts are told apart by words first, then by blue, amber and vermilion, which color-blind readers tell apart, too.
const std::string_view page_style = R"(
:root { color-scheme: light dark; --ink: #1c2230; --soft: #566073; --line: #d9dee7; --paper: #fff; --raised: #f4f6f9;
  --accent: #0d6a86; --exact: #dcebf8; --exact-ink: #0b3a5c; --bound: #fdf0c8; --bound-ink: #5a4100;
  --wrong: #b83b00; --wrong-ink: #fff; --fast: #f7dccf; --fast-ink: #7a2500; --ray: #0072b2; --truth: #00795a; --naive: #c04a00; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6e9ef; --soft: #a3adbd; --line: #343b48; --paper: #14171d; --raised: #1d222b;
    --accent: #6cc3de; --exact: #173650; --exact-ink: #cfe6fa; --bound: #4a3a0c; --bound-ink: #ffe9a8;
    --wrong: #ff8a4c; --wrong-ink: #1a0d05; --fast: #4b2717; --fast-ink: #ffcdb2; --ray: #56b4e9; --truth: #3fc79f; --naive: #ff9a5c; }
}
* { box-sizing: border-box; }
body { margin: 0; color: var(--ink); background: var(--paper); font: 16px/1.5 system-ui, "Segoe UI", Roboto, sans-serif; }
header, main, footer { max-width: 1180px; margin: 0 auto; padding: 0 20px; }
header { padding-top: 36px; }
h1 { font-size: 2.2rem; line-height: 1.1; margin: 0 0 8px; letter-spacing: -0.02em; }
h2 { font-size: 1.05rem; margin: 20px 0 6px; }
p { max-width: 50em; margin: 8px 0; }
.note { color: var(--soft); font-size: 0.88rem; }
code, pre { font: 0.86rem/1.5 ui-monospace, "DejaVu Sans Mono", monospace; }
pre { background: var(--raised); padding: 8px 12px; border-radius: 6px; overflow-x: auto; margin: 6px 0; }
.verdict { font-weight: 650; }
.good.verdict::before { content: "✓ "; }
.bad.verdict::before { content: "✗ "; color: var(--naive); }
.filters { display: flex; flex-wrap: wrap; gap: 10px 14px; align-items: end; margin: 22px 0 10px; }
.filters label { display: grid; gap: 2px; font-size: 0.8rem; color: var(--soft); }
.filters input, .filters select, .filters button { font: inherit; font-size: 0.95rem; color: var(--ink); background: var(--paper);
  border: 1px solid var(--line); border-radius: 6px; padding: 5px 9px; min-height: 36px; }
.filters input { width: 15em; }
#count { color: var(--soft); font-size: 0.9rem; padding-bottom: 7px; }
table { border-collapse: collapse; width: 100%; font-size: 0.92rem; font-variant-numeric: tabular-nums; }
th, td { padding: 5px 10px; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
th { font-weight: 600; }
.matrix > thead th { color: var(--soft); position: sticky; top: 0; background: var(--paper); z-index: 1;
  border-bottom: 2px solid var(--ink); }
.matrix .group th { padding-top: 20px; font-size: 1.05rem; border-bottom: 1px solid var(--ink); }
.row { cursor: pointer; }
.row:hover > th, .row:hover > td.plain { background: var(--raised); }
.row button { all: unset; cursor: pointer; color: var(--accent); white-space: nowrap; }
.row button::before { content: "▸"; display: inline-block; width: 1.1em; color: var(--soft); }
.row button[aria-expanded=true]::before { content: "▾"; }
.row button:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; border-radius: 3px; }
td.exact, .chip.exact { background: var(--exact); color: var(--exact-ink); }
td.bound, .chip.bound { background: var(--bound); color: var(--bound-ink); }
td.wrong, .chip.wrong { background: var(--wrong); color: var(--wrong-ink); font-weight: 700; }
td.fast, .chip.fast { background: var(--fast); color: var(--fast-ink); font-weight: 600; }
td.none { color: var(--soft); }
td small { display: block; font-weight: 400; line-height: 1.2; }
.remarks { max-width: 22em; font-size: 0.86rem; }
.chip { display: inline-block; padding: 0 8px; border-radius: 4px; font-size: 0.88rem; }
.legend { display: grid; grid-template-columns: max-content 1fr; gap: 5px 12px; margin: 12px 0; font-size: 0.9rem; max-width: 60em; }
.legend dt, .legend dd { margin: 0; }
.sums { width: auto; margin: 10px 0; }
.sums td, .sums th { padding: 3px 14px 3px 0; }
.sums td, .sums thead th { text-align: right; }
.sums thead th:first-child { text-align: left; }
.detail > td { padding: 0 0 24px; }
.case { padding: 6px 4px 0 18px; border-left: 3px solid var(--accent); }
.told { display: grid; grid-template-columns: minmax(0, 1fr) minmax(0, 1fr); gap: 8px 28px; align-items: start; }
.told dl { display: grid; grid-template-columns: max-content minmax(0, 1fr); gap: 6px 14px; margin: 8px 0; }
.told dt { color: var(--soft); }
.told dd { margin: 0; overflow-wrap: anywhere; }
figure { margin: 8px 0; }
figcaption { color: var(--soft); font-size: 0.86rem; }
svg.sketch { width: 100%; height: auto; max-width: 560px; border: 1px solid var(--line); border-radius: 6px; }
.sketch .paper { fill: var(--paper); }
.sketch .halo { stroke: var(--paper); }
.sketch .shape { color: var(--ink); } .sketch .ray { color: var(--ray); } .sketch .truth { color: var(--truth); }
.sketch .naive { color: var(--naive); } .sketch .aid { color: var(--soft); }
.scroll { overflow-x: auto; }
.answers { font-size: 0.88rem; width: auto; }
.answers td, .answers th { white-space: nowrap; }
.question { display: grid; grid-template-columns: 4em minmax(0, 1fr); gap: 2px 14px; margin: 10px 0; font-size: 0.88rem; }
.question dt { color: var(--soft); }
.question dt.bad { color: var(--naive); font-weight: 700; }
.question dd { margin: 0; overflow-wrap: anywhere; }
.question small { display: inline; color: var(--soft); margin-left: 0.8em; }
footer { padding: 28px 20px 40px; }
@media (max-width: 860px) {
  body { font-size: 15px; }
  header, main, footer { padding-left: 12px; padding-right: 12px; }
  .matrix-scroll { overflow-x: auto; }
  .matrix > thead th { position: static; }
  .matrix th, .matrix td { padding: 4px 6px; font-size: 0.84rem; }
  .remarks { min-width: 14em; }
  .matrix th[scope=row] { position: sticky; left: 0; background: var(--paper); }
  .case { position: sticky; left: 0; width: calc(100vw - 28px); padding-left: 10px; }
  .told { grid-template-columns: minmax(0, 1fr); }
  .filters input { width: 100%; } .filters label:first-child { flex: 1 1 100%; }
}
@media print {
  :root { color-scheme: light; --ink: #000; --soft: #444; --line: #bbb; --paper: #fff; --raised: #fff; --accent: #000;
    --exact: #dcebf8; --exact-ink: #000; --bound: #fdf0c8; --bound-ink: #000; --wrong: #fff; --wrong-ink: #000; --fast: #f7dccf; --fast-ink: #000;
    --ray: #0072b2; --truth: #00795a; --naive: #c04a00; }
  body { font-size: 10pt; }
  .filters { display: none; }
  header, main, footer { max-width: none; padding-left: 0; padding-right: 0; }
  .matrix > thead th { position: static; }
  .matrix th, .matrix td { padding: 2px 6px; }
  td.wrong, .chip.wrong { outline: 2px solid #000; outline-offset: -2px; }
  td.exact, td.bound, td.fast { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  .row, figure { break-inside: avoid; }
  .row button::before { display: none; }
}
)";

// Rows are there already: the script hides and shows. A case that the address names is opened.
const std::string_view page_script = R"(
'use strict';
const rows = [...document.querySelectorAll('tr.row')];
const [text, group, verdict] = ['text', 'group', 'verdict'].map((id) => document.getElementById(id));
const detail_of = (row) => row.nextElementSibling;

function open_case(row, is_open) {
  row.querySelector('button').setAttribute('aria-expanded', is_open);
  detail_of(row).hidden = !is_open;
}
function is_open(row) { return !detail_of(row).hidden; }

function filter() {
  const words = text.value.toLowerCase().split(/\s+/).filter(Boolean);
  let shown = 0;
  for (const row of rows) {
    const marks = row.dataset.marks.split(' ');
    const fits = words.every((word) => row.dataset.find.includes(word)) &&
      (!group.value || row.dataset.group === group.value) && (!verdict.value || marks.includes(verdict.value));
    row.hidden = !fits;
    if (!fits) open_case(row, false);
    shown += fits;
  }
  for (const body of document.querySelectorAll('.matrix > tbody')) {
    body.hidden = ![...body.querySelectorAll('tr.row')].some((row) => !row.hidden);
  }
  document.getElementById('count').textContent = `${shown} of ${rows.length} cases`;
}
for (const control of [text, group, verdict]) control.addEventListener('input', filter);
document.getElementById('clear').addEventListener('click', () => {
  text.value = group.value = verdict.value = '';
  filter();
});

for (const row of rows) {
  row.addEventListener('click', () => {
    if (!getSelection().isCollapsed && getSelection().containsNode(row, true)) return; // text is being marked
    open_case(row, !is_open(row));
    if (is_open(row)) history.replaceState(null, '', '#' + row.id);
  });
}
function open_named() {
  const row = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (!row || !rows.includes(row)) return;
  open_case(row, true);
  row.scrollIntoView();
}
addEventListener('hashchange', open_named);
filter();
open_named();
)";

}  // namespace sightline::stability
