// The walk of the ray, step by step.

function point_at(t) {
  const {origin, direction} = data.rays[state.ray];
  return origin.map((o, k) => o + t * direction[k]);
}

// Some structures set leaves apart from inner nodes by the highest bit of their numbers, which says nothing here.
const number_of = (cells, i) => cells.node[i] % 2 ** 31;

function sentence_of(w, step) {
  const {kind, cell, t, far, flags, triangle, id, skipped} = w.steps, c = cell[step], {cells} = w;
  const place = `${number_of(cells, c)}, depth ${cells.depth[c]},`;
  const before = skipped[step] ? `After ${commas(skipped[step])} triangles that it misses, the ray ` : 'The ray ';
  if (flags[step] & 4) return `The ray passes an empty part of node ${place} from t = ${digits(t[step])} on.`;
  if (kind[step] === 0)
    return `The ray opens ${cells.leaf[c] ? 'empty cell' : 'inner node'} ${place} which it enters at t = ${
        digits(t[step])}.`;
  if (kind[step] === 1) {
    return `The ray opens leaf ${place} which it enters at t = ${digits(t[step])}, and has ${commas(cells.count[c])} ` +
        `triangle${cells.count[c] === 1 ? '' : 's'} to try.`;
  }
  if (kind[step] === 3)
    return `${cells.leaf[c] ? 'Leaf' : 'Node'} ${place} is dropped unopened: it begins at t = ${
        digits(t[step])}, beyond the far limit ${digits(far[step])}.`;
  const what = `${before}tries triangle ${id[triangle[step]]} of leaf ${number_of(cells, c)}: `;
  if (!flags[step]) return what + 'it passes by.';
  return what +
      `crossed at t = ${digits(t[step])}, ${
             flags[step] & 2 ? 'the nearest hit so far.' : 'not nearer than the hit so far.'}`;
}

function show_step() {
  const w = walk(), step = state.step, names = ['nodes', 'leaves', 'triangles', 'dropped'];
  const is_empty = last_step() < 0, counters = is_empty ? [0, 0, 0, 0] : counters_at(w, step);
  $('step').value = step;
  $('step-value').textContent = is_empty ? 'none' : `${commas(step + 1)} of ${commas(last_step() + 1)}`;
  $('sentence').textContent = is_empty ? 'The ray meets no cell at all.' : sentence_of(w, step);
  $('counters').innerHTML = counters.map((n, k) => `<div><dt>${names[k]}</dt><dd>${commas(n)}</dd></div>`).join('');
  const far = is_empty ? Infinity : w.steps.far[step], hit = is_empty ? -1 : hit_at(w, step);
  $('far').textContent = `Far limit: t = ${digits(far)}${
      hit < 0 ? '; nothing is hit yet' : `; hit: triangle ${w.steps.id[w.steps.triangle[hit]]}`}.`;
  const stack = is_empty ? [] : stack_at(w, step);
  $('stack-title').textContent = `On the stack: ${commas(stack.length)}${stack.length ? ', with t of entry' : ''}`;
  $('stack').replaceChildren(...stack.slice(0, 60).map((i) => {
    const item = document.createElement('li'), entry = w.steps.t[w.until[i]];
    item.textContent =
        `${w.cells.leaf[i] ? 'leaf' : 'node'} ${number_of(w.cells, i)}, depth ${w.cells.depth[i]}, t ${digits(entry)}`;
    return item;
  }));
  Object.assign(state, {
    counters,
    far,
    stack: stack.map((i) => w.cells.node[i]),
    cell: is_empty ? null : w.cells.node[w.steps.cell[step]]
  });
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
    const waiting = [], now = [], {kind, cell, t, flags, triangle, corners} = w.steps;
    for (const i of stack.slice(0, 200)) push_outline(waiting, w.cells, i);
    space.add_lines(waiting, css('--stack'), 2.5);
    push_outline(now, w.cells, cell[step]);
    space.add_lines(now, css('--now'), 4.5);
    if (kind[step] === 2) {
      const at = 9 * triangle[step], c = Array.from(corners.subarray(at, at + 9));
      space.add_triangles(c, css('--now'), 0.75);
      space.add_lines([...c.slice(0, 6), ...c.slice(3, 9), ...c.slice(6, 9), ...c.slice(0, 3)], css('--now'), 2.5);
    }
    if (kind[step] !== 2 || flags[step]) space.add_point(point_at(t[step]), css('--now'), 9);
    if (hit >= 0) space.add_point(point_at(t[hit]), css('--ink'), 11);
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
