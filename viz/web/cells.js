// What is shown: the state of the page, and its cells.

const $ = (id) => document.getElementById(id);
const state = {
  structure: 0,
  ray: 0,
  step: 0,
  depth: 0,
  only: false,
  leaves: false,
  axis: -1,
  cut: 0.5,
  color: 'depth',
  opacity: 0.6
};
let space = null, timer = null;

const structure = () => structure_at(state.structure);
const walk = () => structure().walks[state.ray];
const last_step = () => walk().steps.kind.length - 1;

function is_chosen(cells, extent, i, position) {
  if (cells.depth[i] > state.depth || (state.only && cells.depth[i] < state.depth)) return false;
  if (state.leaves && !cells.leaf[i]) return false;
  return state.axis < 0 || (extent[6 * i + state.axis] <= position && position <= extent[6 * i + 3 + state.axis]);
}

const level_of_count = (count) => count === 0 ? 0 : 1 + Math.ceil(Math.log2(count));

// From the least level that is shown to the highest, so that few levels differ well.
function color_scale(cells, chosen) {
  const ramp =
      data.ramp[is_dark() ? 'dark' : 'light'].map((text) => [1, 3, 5].map((k) => parseInt(text.slice(k, k + 2), 16)));
  const level = state.color === 'depth' ? (i) => cells.depth[i] : (i) => level_of_count(cells.count[i]);
  let least = Infinity, most = 0;
  for (const i of chosen) least = Math.min(least, level(i)), most = Math.max(most, level(i));
  const share = (i) => most > least ? (level(i) - least) / (most - least) : 0.35;
  return {least: Math.min(least, most), most, color_of: (i) => ramp[Math.round((ramp.length - 1) * share(i))]};
}

function show_legend(least, most) {
  const is_depth = state.color === 'depth',
        text = (level) => is_depth ? level :
      level === 0                  ? 0 :
                                     commas(2 ** (level - 1));
  $('legend').innerHTML = '<span class=marks><b class="mark bar" style="background:var(--now)"></b>this step’s cell' +
      '<b class="mark bar" style="background:var(--stack)"></b>on the stack<b class="mark bar" style="background:var(--ink)"></b>' +
      `ray</span>${
                              is_depth ? 'depth of a cell; the root has 0' :
                                         'candidates in a leaf'}<i style="background:linear-gradient(to right,` +
      `${data.ramp[is_dark() ? 'dark' : 'light'].join(',')})"></i><div><span>${text(least)}</span><span>${
                              text(most)}</span></div>`;
}

function show_cells() {
  const {cells, cell_count} = structure(), lines = lines_toward(structure(), space?.view_axis()), chosen = [],
                [lo, hi] = data.bounds.map((p) => p[state.axis]);
  const position = lo + (hi - lo) * state.cut;
  for (let i = 0; i < cells.kind.length; ++i)
    if (is_chosen(cells, lines.extent, i, position)) chosen.push(i);
  const {least, most, color_of} = color_scale(cells, chosen);
  state.cells = chosen.length;
  // Shallow cells last: an edge that they share with deeper ones has their color.
  state.lines = space ? space.set_cells(lines, chosen.reverse(), color_of) : 0;
  space?.set_mesh(state.opacity, space.cut_at(state.axis, state.cut));
  const kept = cells.kind.length < cell_count ? `; this page has the largest ${commas(cells.kind.length)}` : '';
  $('shown').textContent = `${commas(chosen.length)} of ${commas(cell_count)} cells shown${kept}.`;
  $('depth-value').textContent = `${state.depth} of ${structure().depths.length - 1}`;
  show_legend(least, most);
}
