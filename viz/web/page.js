// How it is chosen what is shown.

const mean_work = (raw) => raw.mean_work < 1000 ? raw.mean_work.toFixed(1) : commas(Math.round(raw.mean_work));

function show_table() {
  const head = [
    'structure', 'nodes', 'leaves', 'triangles', 'dropped', 't of the hit', 'triangle', 'mean work', 'cells', 'bytes'
  ];
  const rows = data.structures.map((raw, i) => {
    const w = structure_at(i).walks[state.ray], last = w.steps.kind.length - 1;
    const counters = last < 0 ? [0, 0, 0, 0] : counters_at(w, last);
    const cells = [
      raw.label, ...counters.map(commas), w.hit ? digits(w.hit.t) : 'none', w.hit ? w.hit.triangle : '–',
      mean_work(raw), commas(raw.cell_count), commas(raw.bytes)
    ];
    return `<tr data-index=${i} class="${i === state.structure ? 'now' : ''}">${
        cells.map((text, k) => k ? `<td>${text}</td>` : '<th scope=row></th>').join('')}</tr>`;
  });
  $('table').innerHTML =
      `<thead><tr>${head.map((text) => `<th>${text}</th>`).join('')}</tr></thead><tbody>${rows.join('')}</tbody>`;
  document.querySelectorAll('#table tbody th').forEach((th, i) => th.textContent = data.structures[i].label);
}

function show_charts() {
  const w = walk(), counters = last_step() < 0 ? [0, 0, 0] : counters_at(w, last_step());
  draw_work(structure(), counters[0] + counters[1] + counters[2]);
  $('work-note').textContent = `of a coarse picture; mean ${mean_work(structure())}`;
  draw_depths(structure(), state.depth);
  draw_time(w);
  if (last_step() >= 0) move_now(w, state.step);
}

function show_all() {
  for (const tab of $('tabs').children) tab.setAttribute('aria-selected', +tab.dataset.index === state.structure);
  $('about').textContent = structure().description;
  $('depth').max = structure().depths.length - 1;
  $('depth').value = state.depth, $('only').checked = state.only, $('leaves').checked = state.leaves;
  $('axis').value = state.axis, $('cut').value = state.cut, $('color').value = state.color,
  $('opacity').value = state.opacity;
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
  const {readable_depth, is_cut} = data.structures[index];
  Object.assign(
      state,
      {structure: index, step: 0, depth: readable_depth, only: false, leaves: is_cut, axis: is_cut ? 2 : -1, cut: 0.5});
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
  const {label} = data.structures[state.structure], {ray, step, depth, only, leaves, axis, cut, color, opacity} = state;
  const parts = {
    accel: label,
    ray,
    step: step + 1,
    depth,
    only: +only,
    leaves: +leaves,
    axis: 'xyz'[axis] ?? '',
    cut,
    color,
    opacity
  };
  history.replaceState(null, '', '#' + new URLSearchParams(parts));
}

function recall(text) {
  const asked = new URLSearchParams(text.replace(/^#/, '')),
        whole = (key, from, to) =>
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
  ArrowLeft: [
    () => {
      play(false);
      go_to(state.step - 1);
    },
    '← →', 'a step back, a step forward'
  ],
  ArrowRight: [() => {
    play(false);
    go_to(state.step + 1);
  }],
  Home: [() => go_to(0), 'Home End', 'first and last step'],
  End: [() => go_to(last_step())],
  ' ': [() => play(), 'Space', 'play and pause'],
  '+': [() => set_depth(state.depth + 1), '+ −', 'deeper, less deep'],
  '=': [() => set_depth(state.depth + 1)],
  '-': [() => set_depth(state.depth - 1)],
  l: [() => $('leaves').click(), 'L', 'leaves only'],
  o: [() => $('only').click(), 'O', 'only this depth'],
  m: [
    () => {
      state.opacity = state.opacity > 0 ? 0 : 1;
      show_all();
    },
    'M', 'mesh, or none'
  ],
  ']':
      [() => choose_structure((state.structure + 1) % data.structures.length), '[ ]', 'the structure before, the next'],
  '[': [() => choose_structure((state.structure + data.structures.length - 1) % data.structures.length)],
  v: [() => space?.look_from('front'), 'V', 'look from where rays are picked'],
  r: [() => space?.look_from('side'), 'R', 'look as at first'],
  h: [
    () => {
      $('keys').hidden = !$('keys').hidden;
    },
    'H', 'these keys, or none'
  ],
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
  on('only', 'change', () => {
    state.only = $('only').checked;
    show_all();
  });
  on('leaves', 'change', () => {
    state.leaves = $('leaves').checked;
    show_all();
  });
  on('axis', 'change', () => {
    state.axis = +$('axis').value;
    show_all();
  });
  on('cut', 'input', () => {
    state.cut = +$('cut').value;
    show_cells();
    remember();
  });
  on('color', 'change', () => {
    state.color = $('color').value;
    show_all();
  });
  on('opacity', 'input', () => {
    state.opacity = +$('opacity').value;
    show_cells();
    remember();
  });
  on('step', 'input', () => {
    play(false);
    go_to(+$('step').value);
  });
  on('ray', 'change', () => {
    play(false);
    state.ray = +$('ray').value;
    state.step = 0;
    show_all();
  });
  for (const [id, key] of [
           ['first', 'Home'], ['back', 'ArrowLeft'], ['play', ' '], ['forward', 'ArrowRight'], ['last', 'End']]) {
    on(id, 'click', () => keys[key][0]());
  }
  const seek = (event) => {
    if (event.buttons) {
      play(false);
      go_to(step_at(walk(), event.clientX));
    }
  };
  on('time', 'pointerdown', seek);
  on('time', 'pointermove', seek);
  on('table', 'click', (event) => {
    const row = event.target.closest('tr[data-index]');
    if (row) choose_structure(+row.dataset.index);
  });
  let width = innerWidth;
  addEventListener('resize', () => {
    if (innerWidth !== width) show_charts();
    width = innerWidth;
  });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', show_all);
}

function begin() {
  $('title').innerHTML = 'Sightline <small></small>';
  $('title').firstElementChild.textContent =
      `${data.scene}, ${commas(data.triangles)} triangle${data.triangles === 1 ? '' : 's'}`;
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
  $('keys').innerHTML = '<dl>' +
      Object.values(keys).filter((key) => key[1]).map((key) => `<dt><b>${key[1]}</b></dt><dd>${key[2]}</dd>`).join('') +
      '</dl>drag to turn, wheel to come closer, right button to shift';
  try {
    space = new Space($('canvas'));
    space.on_turn = () => {
      if (structure().cells.kind[0] === 1) show_cells();
    };
  } catch (error) {
    $('trouble').hidden = false;
    $('trouble').textContent = `This browser draws nothing in space (WebGL: ${error.message}); all else works.`;
  }
  listen();
  recall(location.hash);
}

window.sightline = {
  state,
  data,
  picture: () => space.picture(),
  go_to,
  set_depth
};
begin();
