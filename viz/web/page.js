// What is shown, and how it is chosen.

const $ = (id) => document.getElementById(id);
const state = { structure: 0, ray: 0, step: 0, depth: 0, only: false, leaves: false, axis: -1, cut: 0.5, color: 'depth',
  opacity: 0.6 };
let space = null, timer = null;

const structure = () => structure_at(state.structure);
const walk = () => structure().walks[state.ray];
const last_step = () => walk().steps.kind.length - 1;

// ---- Cells

function is_chosen(cells, extent, i, position) {
  if (cells.depth[i] > state.depth || (state.only && cells.depth[i] < state.depth)) return false;
  if (state.leaves && !cells.leaf[i]) return false;
  return state.axis < 0 || (extent[6 * i + state.axis] <= position && position <= extent[6 * i + 3 + state.axis]);
}

const level_of_count = (count) => count === 0 ? 0 : 1 + Math.ceil(Math.log2(count));

function color_scale(cells) {
  const ramp = data.ramp[is_dark() ? 'dark' : 'light'].map((text) => [1, 3, 5].map((k) => parseInt(text.slice(k, k + 2), 16)));
  const level = state.color === 'depth' ? (i) => cells.depth[i] : (i) => level_of_count(cells.count[i]);
  let most = state.color === 'depth' ? structure().depths.length - 1 : 0;
  if (state.color === 'count') for (let i = 0; i < cells.count.length; ++i) most = Math.max(most, level(i));
  return { most, color_of: (i) => ramp[Math.round((ramp.length - 1) * (most ? level(i) / most : 0.35))] };
}

function show_cells() {
  const { cells, cell_count } = structure(), lines = lines_toward(structure(), space?.view_axis()), chosen = [], [lo, hi] = data.bounds.map((p) => p[state.axis]);
  const position = lo + (hi - lo) * state.cut;
  for (let i = 0; i < cells.kind.length; ++i) if (is_chosen(cells, lines.extent, i, position)) chosen.push(i);
  const { most, color_of } = color_scale(cells);
  state.cells = chosen.length;
  state.lines = space ? space.set_cells(lines, chosen, color_of) : 0;
  space?.set_mesh(state.opacity, space.cut_at(state.axis, state.cut));
  const kept = cells.kind.length < cell_count ? `; this page has the largest ${commas(cells.kind.length)}` : '';
  $('shown').textContent = `${commas(chosen.length)} of ${commas(cell_count)} cells shown${kept}.`;
  $('depth-value').textContent = `${state.depth} of ${structure().depths.length - 1}`;
  const low = state.color === 'depth' ? '0 (root)' : '0', high = state.color === 'depth' ? most : commas(2 ** Math.max(0, most - 1));
  $('legend').innerHTML = '<span class=marks><b class="mark bar" style="background:var(--now)"></b>this step’s cell' +
    '<b class="mark bar" style="background:var(--candidate)"></b>on the stack<b class="mark bar" style="background:var(--ink)"></b>' +
    `ray</span>${state.color === 'depth' ? 'depth of a cell' : 'candidates in a leaf'}<i style="background:linear-gradient(to right,` +
    `${data.ramp[is_dark() ? 'dark' : 'light'].join(',')})"></i><div><span>${low}</span><span>${high}</span></div>`;
}

// ---- The walk

function point_at(t) {
  const { origin, direction } = data.rays[state.ray];
  return origin.map((o, k) => o + t * direction[k]);
}

// Some structures set leaves apart from inner nodes by the highest bit of their numbers, which says nothing here.
const number_of = (cells, i) => cells.node[i] % 2 ** 31;

function sentence_of(w, step) {
  const { kind, cell, t, far, flags, triangle, id, skipped } = w.steps, c = cell[step], { cells } = w;
  const place = `${number_of(cells, c)}, depth ${cells.depth[c]},`;
  const before = skipped[step] ? `After ${commas(skipped[step])} triangles that it misses, the ray ` : 'The ray ';
  if (flags[step] & 4) return `The ray passes an empty part of node ${place} from t = ${digits(t[step])} on.`;
  if (kind[step] === 0) return `The ray opens ${cells.leaf[c] ? 'empty cell' : 'inner node'} ${place} which it enters at t = ${digits(t[step])}.`;
  if (kind[step] === 1) {
    return `The ray opens leaf ${place} which it enters at t = ${digits(t[step])}, and has ${commas(cells.count[c])} ` +
      `triangle${cells.count[c] === 1 ? '' : 's'} to try.`;
  }
  if (kind[step] === 3) return `${cells.leaf[c] ? 'Leaf' : 'Node'} ${place} is dropped unopened: it begins at t = ${digits(t[step])}, beyond the far limit ${digits(far[step])}.`;
  const what = `${before}tries triangle ${id[triangle[step]]} of leaf ${number_of(cells, c)}: `;
  if (!flags[step]) return what + 'it passes by.';
  return what + `crossed at t = ${digits(t[step])}, ${flags[step] & 2 ? 'the nearest hit so far.' : 'not nearer than the hit so far.'}`;
}

function show_step() {
  const w = walk(), step = state.step, names = ['nodes', 'leaves', 'triangles', 'dropped'];
  const is_empty = last_step() < 0, counters = is_empty ? [0, 0, 0, 0] : counters_at(w, step);
  $('step').value = step;
  $('step-value').textContent = is_empty ? 'none' : `${commas(step + 1)} of ${commas(last_step() + 1)}`;
  $('sentence').textContent = is_empty ? 'The ray meets no cell at all.' : sentence_of(w, step);
  $('counters').innerHTML = counters.map((n, k) => `<div><dt>${names[k]}</dt><dd>${commas(n)}</dd></div>`).join('');
  const far = is_empty ? Infinity : w.steps.far[step], hit = is_empty ? -1 : hit_at(w, step);
  $('far').textContent = `Far limit: t = ${digits(far)}${hit < 0 ? '; nothing is hit yet' :
    `; hit: triangle ${w.steps.id[w.steps.triangle[hit]]}`}.`;
  const stack = is_empty ? [] : stack_at(w, step);
  $('stack-title').textContent = `On the stack: ${commas(stack.length)}`;
  $('stack').replaceChildren(...stack.slice(0, 60).map((i) => {
    const item = document.createElement('li'), entry = w.steps.t[w.until[i]];
    item.textContent = `${w.cells.leaf[i] ? 'leaf' : 'node'} ${number_of(w.cells, i)}, depth ${w.cells.depth[i]}, from t = ${digits(entry)}`;
    return item;
  }));
  Object.assign(state, { counters, far, stack: stack.map((i) => w.cells.node[i]),
    cell: is_empty ? null : w.cells.node[w.steps.cell[step]] });
  if (!is_empty) move_now(w, step);
  if (space) draw_step(w, step, stack, hit);
  remember();
}

function draw_step(w, step, stack, hit) {
  space.clear_walk();
  const reach = 3 * space.radius / Math.hypot(...data.rays[state.ray].direction);
  const from = point_at(0), far = hit_at(w, last_step());
  const centre = new THREE.Vector3(...data.focus).sub(new THREE.Vector3(...from)).length();
  const end = far < 0 ? reach + centre / (3 * space.radius) * reach : w.steps.t[far];
  space.add_lines([...from, ...point_at(end)], css('--ink'), 2.5);
  if (last_step() >= 0) {
    const waiting = [], now = [], { kind, cell, t, flags, triangle, corners } = w.steps;
    for (const i of stack.slice(0, 200)) push_outline(waiting, w.cells, i);
    space.add_lines(waiting, css('--candidate'), 2);
    push_outline(now, w.cells, cell[step]);
    space.add_lines(now, css('--now'), 4.5);
    if (kind[step] === 2) {
      const at = 9 * triangle[step], c = Array.from(corners.subarray(at, at + 9));
      space.add_triangles(c, css('--now'), 0.75);
      space.add_lines([...c.slice(0, 6), ...c.slice(3, 9), ...c.slice(6, 9), ...c.slice(0, 3)], css('--now'), 2.5);
    }
    if (kind[step] !== 2 || flags[step]) space.add_point(point_at(t[step]), css('--now'), 9);
    if (hit >= 0) space.add_point(point_at(t[hit]), css('--hit'), 11);
  }
  space.draw_soon();
}

function go_to(step) {
  state.step = Math.max(0, Math.min(last_step(), step));
  show_step();
}

function play(is_on = timer === null) {
  clearInterval(timer);
  timer = null;
  if (is_on && last_step() > 0) {
    if (state.step >= last_step()) go_to(0);
    const wait = Math.max(30, Math.min(450, 20000 / last_step()));
    timer = setInterval(() => state.step < last_step() ? go_to(state.step + 1) : play(false), wait);
  }
  $('play').textContent = timer === null ? '▶ play' : '❚❚ pause';
}

// ---- Choosing

function show_table() {
  const head = ['structure', 'nodes', 'leaves', 'triangles', 'dropped', 't of the hit', 'triangle', 'mean work', 'cells', 'bytes'];
  const rows = data.structures.map((raw, i) => {
    const w = structure_at(i).walks[state.ray], last = w.steps.kind.length - 1;
    const counters = last < 0 ? [0, 0, 0, 0] : counters_at(w, last);
    const cells = [raw.label, ...counters.map(commas), w.hit ? digits(w.hit.t) : 'none', w.hit ? w.hit.triangle : '–',
      raw.mean_work.toFixed(1), commas(raw.cell_count), commas(raw.bytes)];
    return `<tr data-index=${i} class="${i === state.structure ? 'now' : ''}">${cells.map((text, k) =>
      k ? `<td>${text}</td>` : '<th scope=row></th>').join('')}</tr>`;
  });
  $('table').innerHTML = `<thead><tr>${head.map((text) => `<th>${text}</th>`).join('')}</tr></thead><tbody>${rows.join('')}</tbody>`;
  document.querySelectorAll('#table tbody th').forEach((th, i) => th.textContent = data.structures[i].label);
}

function show_charts() {
  const w = walk(), counters = last_step() < 0 ? [0, 0, 0] : counters_at(w, last_step());
  draw_work(structure(), counters[0] + counters[1] + counters[2]);
  $('work-note').textContent = `of a coarse picture; mean ${structure().mean_work.toFixed(1)}`;
  draw_depths(structure(), state.depth);
  draw_time(w);
  if (last_step() >= 0) move_now(w, state.step);
}

function show_all() {
  for (const tab of $('tabs').children) tab.setAttribute('aria-selected', +tab.dataset.index === state.structure);
  $('about').textContent = structure().description;
  $('depth').max = structure().depths.length - 1;
  $('depth').value = state.depth, $('only').checked = state.only, $('leaves').checked = state.leaves;
  $('axis').value = state.axis, $('cut').value = state.cut, $('color').value = state.color, $('opacity').value = state.opacity;
  $('cut').disabled = state.axis < 0;
  $('step').max = Math.max(0, last_step());
  $('ray').value = state.ray;
  space?.recolor();
  show_cells();
  show_table();
  show_charts();
  show_step();
}

// A structure that falls into many parts at once is cut, others are shown as deep as reads well.
function choose_structure(index) {
  play(false);
  const { readable_depth, is_cut } = data.structures[index];
  Object.assign(state, { structure: index, step: 0, depth: readable_depth, only: false, leaves: is_cut, axis: is_cut ? 2 : -1, cut: 0.5 });
  show_all();
}

function set_depth(depth) {
  state.depth = Math.max(0, Math.min(structure().depths.length - 1, depth));
  $('depth').value = state.depth;
  show_cells();
  draw_depths(structure(), state.depth);
  remember();
}

// The state stands in the address, so that it can be kept and sent.
function remember() {
  const { label } = data.structures[state.structure], { ray, step, depth, only, leaves, axis, cut, color, opacity } = state;
  const parts = { accel: label, ray, step: step + 1, depth, only: +only, leaves: +leaves, axis: 'xyz'[axis] ?? '', cut, color, opacity };
  history.replaceState(null, '', '#' + new URLSearchParams(parts));
}

function recall(text) {
  const asked = new URLSearchParams(text.replace(/^#/, '')), whole = (key, from, to) =>
    asked.has(key) && /^\d+$/.test(asked.get(key)) ? Math.max(from, Math.min(to, +asked.get(key))) : null;
  const share = (key) => asked.get(key) && +asked.get(key) >= 0 && +asked.get(key) <= 1 ? +asked.get(key) : null;
  const index = data.structures.findIndex((raw) => raw.label === asked.get('accel'));
  choose_structure(Math.max(0, index));
  state.ray = whole('ray', 0, data.rays.length - 1) ?? 0;
  state.step = (whole('step', 1, last_step() + 1) ?? 1) - 1;
  state.depth = whole('depth', 0, structure().depths.length - 1) ?? state.depth;
  if (asked.has('leaves')) state.leaves = asked.get('leaves') === '1';
  if (asked.has('only')) state.only = asked.get('only') === '1';
  if (asked.has('axis')) state.axis = asked.get('axis') ? 'xyz'.indexOf(asked.get('axis')) : -1;
  if (asked.get('color') === 'count') state.color = 'count';
  state.cut = share('cut') ?? state.cut, state.opacity = share('opacity') ?? state.opacity;
  show_all();
}

const keys = {
  ArrowLeft: [() => { play(false); go_to(state.step - 1); }, '← →', 'a step back, a step forward'],
  ArrowRight: [() => { play(false); go_to(state.step + 1); }],
  Home: [() => go_to(0), 'Home End', 'first and last step'],
  End: [() => go_to(last_step())],
  ' ': [() => play(), 'Space', 'play and pause'],
  '+': [() => set_depth(state.depth + 1), '+ −', 'deeper, less deep'],
  '=': [() => set_depth(state.depth + 1)],
  '-': [() => set_depth(state.depth - 1)],
  l: [() => $('leaves').click(), 'L', 'leaves only'],
  o: [() => $('only').click(), 'O', 'only this depth'],
  m: [() => { state.opacity = state.opacity > 0 ? 0 : 1; show_all(); }, 'M', 'mesh, or none'],
  ']': [() => choose_structure((state.structure + 1) % data.structures.length), '[ ]', 'the structure before, the next'],
  '[': [() => choose_structure((state.structure + data.structures.length - 1) % data.structures.length)],
  v: [() => space?.look_from('front'), 'V', 'look from where rays are picked'],
  r: [() => space?.look_from('side'), 'R', 'look as at first'],
  h: [() => { $('keys').hidden = !$('keys').hidden; }, 'H', 'these keys, or none'],
};

function listen() {
  document.addEventListener('keydown', (event) => {
    const is_taken = event.ctrlKey || event.altKey || event.metaKey || event.target.matches('select') ||
      (event.target.matches('input[type=range]') && /^(Arrow|Home|End)/.test(event.key)) ||
      (event.target.matches('button, input[type=checkbox]') && event.key === ' ');
    const key = keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (is_taken || !key) return;
    event.preventDefault();
    key[0]();
  });
  const on = (id, what, act) => $(id).addEventListener(what, act);
  on('depth', 'input', () => set_depth(+$('depth').value));
  on('only', 'change', () => { state.only = $('only').checked; show_all(); });
  on('leaves', 'change', () => { state.leaves = $('leaves').checked; show_all(); });
  on('axis', 'change', () => { state.axis = +$('axis').value; show_all(); });
  on('cut', 'input', () => { state.cut = +$('cut').value; show_cells(); remember(); });
  on('color', 'change', () => { state.color = $('color').value; show_all(); });
  on('opacity', 'input', () => { state.opacity = +$('opacity').value; show_cells(); remember(); });
  on('step', 'input', () => { play(false); go_to(+$('step').value); });
  on('ray', 'change', () => { play(false); state.ray = +$('ray').value; state.step = 0; show_all(); });
  for (const [id, key] of [['first', 'Home'], ['back', 'ArrowLeft'], ['play', ' '], ['forward', 'ArrowRight'], ['last', 'End']]) {
    on(id, 'click', () => keys[key][0]());
  }
  const seek = (event) => { if (event.buttons) { play(false); go_to(step_at(walk(), event.clientX)); } };
  on('time', 'pointerdown', seek);
  on('time', 'pointermove', seek);
  on('table', 'click', (event) => { const row = event.target.closest('tr[data-index]'); if (row) choose_structure(+row.dataset.index); });
  let width = innerWidth;
  addEventListener('resize', () => { if (innerWidth !== width) show_charts(); width = innerWidth; });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', show_all);
}

function begin() {
  $('title').innerHTML = 'Sightline <small></small>';
  $('title').firstElementChild.textContent = `${data.scene}, ${commas(data.triangles)} triangles`;
  $('note').textContent = data.note;
  $('command').textContent = data.command;
  data.structures.forEach((raw, i) => {
    const tab = document.createElement('button');
    tab.textContent = raw.label, tab.dataset.index = i;
    tab.setAttribute('role', 'tab');
    tab.addEventListener('click', () => choose_structure(i));
    $('tabs').append(tab);
  });
  data.rays.forEach((ray, i) => $('ray').append(new Option(ray.label, i)));
  $('ray').hidden = data.rays.length < 2;
  $('keys').innerHTML = '<dl>' + Object.values(keys).filter((key) => key[1]).map((key) => `<dt><b>${key[1]}</b></dt><dd>${key[2]}</dd>`).join('') +
    '</dl>drag to turn, wheel to come closer, right button to shift';
  try {
    space = new Space($('canvas'));
    space.on_turn = () => { if (structure().cells.kind[0] === 1) show_cells(); };
  } catch (error) {
    $('trouble').hidden = false;
    $('trouble').textContent = `This browser draws nothing in space (WebGL: ${error.message}); all else works.`;
  }
  listen();
  recall(location.hash);
}

window.sightline = { state, data, picture: () => space.picture(), go_to, set_depth };
begin();
