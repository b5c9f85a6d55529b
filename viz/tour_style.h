#pragma once

#include <string_view>

namespace sightline::viz {

/// The look of the tour's page; in the page itself, so that the folder can be copied anywhere.
inline constexpr std::string_view tour_style = R"(
:root { color-scheme: light; --ink: #1c2230; --soft: #5d6677; --line: #dfe3ea; --accent: #0d7a86; }
* { box-sizing: border-box; }
body { margin: 0; color: var(--ink); background: #fff; font: 17px/1.55 system-ui, "Segoe UI", Roboto, sans-serif; }
header, main { max-width: 1120px; margin: 0 auto; padding: 0 20px; }
header { padding-top: 40px; }
header p { max-width: 46em; font-size: 1.1rem; }
h1 { font-size: 2.6rem; line-height: 1; margin: 0; letter-spacing: -0.02em; }
h2 { font-size: 1.7rem; margin: 48px 0 12px; padding-top: 20px; border-top: 3px solid var(--ink); }
h2 small, td small { font-weight: normal; color: var(--soft); }
h2 small { font-size: 1rem; margin-left: 0.6em; }
h3 { font-size: 1.2rem; margin: 32px 0 8px; }
p { max-width: 50em; }
.note, figcaption { color: var(--soft); font-size: 0.88rem; }
figure { margin: 0; min-width: 0; }
figure img { display: block; width: 100%; height: auto; border: 1px solid var(--line); border-radius: 6px; }
.scene > figure { max-width: 800px; }
figcaption { margin-top: 6px; }
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: 20px; align-items: start; }
.structure { border-top: 1px solid var(--line); margin-top: 28px; scroll-margin-top: 12px; }
nav a { display: inline-block; margin: 0 6px 6px 0; padding: 3px 12px; border: 1px solid var(--line);
  border-radius: 99px; color: var(--accent); text-decoration: none; font-size: 0.92rem; }
.walk { font-size: 1.1rem; } p a { color: var(--accent); }
nav a:hover { border-color: var(--accent); }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: 0.92rem; font-variant-numeric: tabular-nums; }
th, td { padding: 7px 12px; border-bottom: 1px solid var(--line); text-align: right; white-space: nowrap; }
thead th { font-weight: 600; color: var(--soft); vertical-align: bottom; border-bottom: 2px solid var(--ink);
  line-height: 1.25; }
th:first-child { text-align: left; }
td small { display: inline-block; min-width: 4em; }
.rate { background: linear-gradient(#d3ecef, #d3ecef) left center / var(--share) 72% no-repeat; }
.peer { color: var(--soft); background: #f7f8fa; }
.peer .rate { background: none; }
code, pre { font: 0.88rem/1.5 ui-monospace, "DejaVu Sans Mono", monospace; }
pre { background: #f4f6f9; padding: 9px 14px; border-radius: 6px; overflow-x: auto; margin: 12px 0 0; }
dl { display: grid; gap: 4px; }
dt { background: #f4f6f9; padding: 6px 12px; border-radius: 6px; overflow-x: auto; }
dd { margin: 0 0 12px 12px; color: var(--soft); }
@media (max-width: 720px) { .pair { grid-template-columns: 1fr; } body { font-size: 16px; } }
)";

}  // namespace sightline::viz
