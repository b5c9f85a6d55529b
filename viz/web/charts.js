// Charts as SVG, drawn to the width that there is.

function svg(parent, name, attributes, text) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text !== undefined) element.textContent = text;
  parent.append(element);
  return element;
}

function blank(id, height) {
  const chart = document.getElementById(id), width = Math.max(260, chart.parentElement.clientWidth - 24);
  chart.replaceChildren();
  chart.setAttribute('viewBox', `0 0 ${width} ${height}`);
  chart.setAttribute('height', height);
  return {chart, width, height};
}

// Round numbers from `least` to `most`, about `count` of them.
function ticks(most, count, least = 0) {
  const raw = (most - least) / count, power = 10 ** Math.floor(Math.log10(raw || 1));
  const step = power * [1, 2, 5, 10].find((k) => k * power >= raw), all = [];
  for (let k = Math.ceil(least / step); k * step <= most; ++k) all.push(+(k * step).toPrecision(12));
  return all;
}

// How many rays took how much work; a line marks the ray whose walk is shown.
function draw_work(structure, own_work) {
  const {chart, width, height} = blank('work', 230), left = 52, bottom = 42, top = 30;
  const edges = data.work_edges, sum = structure.work.reduce((a, b) => a + b, 0) || 1;
  const shares = structure.work.map((n) => 100 * n / sum), most = Math.max(...shares);
  const used = edges.length - 1, step = (width - left - 8) / used;
  const y = (share) => height - bottom - share / most * (height - bottom - top);
  for (const share of ticks(most, 4)) {
    svg(chart, 'line', {class: 'grid', x1: left, x2: width, y1: y(share), y2: y(share)});
    svg(chart, 'text', {x: left - 6, y: y(share) + 5, 'text-anchor': 'end'}, `${share} %`);
  }
  shares.forEach((share, i) => {
    const bar = svg(chart, 'rect', {
      x: left + i * step + 1,
      y: y(share),
      width: Math.max(1, step - 2),
      height: height - bottom - y(share),
      fill: css('--leaf')
    });
    svg(bar, 'title', {}, `${edges[i]} to ${edges[i + 1] - 1} steps: ${share.toFixed(1)} % of rays`);
  });
  const every = Math.ceil((edges[used] > 9999 ? 68 : 44) / step);
  for (let i = 0; i < used; i += every) {
    svg(chart, 'text', {x: left + i * step, y: height - bottom + 17, 'text-anchor': 'middle'}, commas(edges[i]));
  }
  svg(chart, 'text', {x: left, y: height - 6}, 'nodes, leaves and candidates of a ray');
  svg(chart, 'text', {x: 0, y: 13}, 'share of rays');
  let place = edges.findLastIndex((edge) => edge <= own_work);
  place = Math.min(Math.max(place, 0), used - 1);
  const within = Math.min(1, (own_work - edges[place]) / (edges[place + 1] - edges[place])),
        x = left + (place + within) * step;
  svg(chart, 'line', {x1: x, x2: x, y1: top - 4, y2: height - bottom, stroke: css('--now'), 'stroke-width': 2.5});
  const is_right = x > width - 130;
  svg(chart, 'text',
      {class: 'strong', x: is_right ? x - 5 : Math.max(x + 5, 105), y: 13, 'text-anchor': is_right ? 'end' : 'start'},
      `this ray: ${commas(own_work)}`);
}

// Inner cells and leaves of each depth, on a logarithmic scale.
function draw_depths(structure, depth) {
  const {chart, width, height} = blank('depths', 230), left = 66, bottom = 42, top = 30;
  const all = structure.depths, octaves = Math.max(1, Math.ceil(Math.log10(Math.max(...all.flat()) + 1)));
  const y = (n) => height - bottom - (n > 0 ? (Math.log10(n) + 0.15) / (octaves + 0.15) : 0) * (height - bottom - top);
  for (let power = 0; power <= octaves; ++power) {
    svg(chart, 'line', {class: 'grid', x1: left, x2: width, y1: y(10 ** power), y2: y(10 ** power)});
    svg(chart, 'text', {x: left - 6, y: y(10 ** power) + 5, 'text-anchor': 'end'}, commas(10 ** power));
  }
  const step = Math.min(60, (width - left - 8) / all.length), thin = Math.max(1, step * 0.42);
  svg(chart, 'rect', {
    x: left,
    y: top - 6,
    width: (depth + 1) * step,
    height: height - bottom - top + 6,
    fill: css('--now'),
    opacity: 0.12
  });
  all.forEach((counts, i) => {
    counts.forEach((n, k) => {
      const bar = svg(chart, 'rect', {
        x: left + i * step + step * 0.06 + k * thin,
        y: y(n),
        width: thin,
        height: height - bottom - y(n),
        fill: css(k ? '--leaf' : '--candidate')
      });
      svg(bar, 'title', {}, `depth ${i}: ${commas(n)} ${k ? 'leaves' : 'inner cells'}`);
    });
  });
  const every = Math.ceil(26 / step);
  for (let i = 0; i < all.length; i += every) {
    svg(chart, 'text', {x: left + (i + 0.5) * step, y: height - bottom + 17, 'text-anchor': 'middle'}, i);
  }
  svg(chart, 'text', {x: left, y: height - 6}, 'depth; the root has 0');
  svg(chart, 'text', {x: 0, y: 13}, 'cells');
  document.getElementById('depths-legend').innerHTML =
      '<b class=mark style="background:var(--candidate)"></b>inner cells' +
      '<b class=mark style="background:var(--leaf)"></b>leaves; shaded: the depths that the slider shows';
}

const lanes = {
  top: 26,
  bottom: 72,
  left: 66
};

function time_scales(walk, width, height) {
  const {t, far, kind, flags} = walk.steps, values = [];
  // The root may have no entry of its own: then it stands at the lower end.
  for (let i = 0; i < t.length; ++i) {
    if ((kind[i] !== 2 || flags[i]) && (i > 0 || t.length === 1)) values.push(t[i]);
    if (Number.isFinite(far[i])) values.push(far[i]);
  }
  const lo = values.reduce((a, b) => Math.min(a, b), Infinity), hi = values.reduce((a, b) => Math.max(a, b), -Infinity);
  const span = hi > lo ? hi - lo : Math.abs(hi) || 1, from = lo - 0.04 * span;
  return {
    from,
    span: 1.1 * span,
    x: (i) => lanes.left + (i + 0.5) * (width - lanes.left - 12) / Math.max(1, t.length),
    y: (value) => Number.isFinite(value) ?
        height - lanes.bottom - Math.max(0, value - from) / (1.1 * span) * (height - lanes.bottom - lanes.top - 14) :
        lanes.top,
  };
}

// Mark of one kind as one path: circle, square, stroke, cross.
function mark(kind, x, y, size) {
  const s = size;
  return [
    `M${x - s} ${y}a${s} ${s} 0 1 0 ${2 * s} 0a${s} ${s} 0 1 0 ${- 2 * s} 0`,
    `M${x - s} ${y - s}h${2 * s}v${2 * s}h${- 2 * s}z`, `M${x} ${y - s}l${s} ${s}l${- s} ${s}l${- s} ${- s}z`,
    `M${x - s} ${y - s}l${2 * s} ${2 * s}M${x + s} ${y - s}l${- 2 * s} ${2 * s}`
  ][kind];
}

const kind_colors = ['--visit', '--leaf', '--candidate', '--cull'];
const kind_names = ['inner node', 'leaf', 'triangle', 'dropped'];

function draw_time(walk) {
  const {chart, width, height} = blank('time', 250), {t, far, kind, flags} = walk.steps, count = t.length;
  if (count === 0) {
    svg(chart, 'text', {x: 0, y: 40}, 'The ray meets no cell at all.');
    return;
  }
  const {x, y, from, span} = time_scales(walk, width, height), floor = height - lanes.bottom;
  for (const value of ticks(from + span, 4, from)) {
    const at = y(value);
    svg(chart, 'line', {class: 'grid', x1: lanes.left, x2: width, y1: at, y2: at});
    svg(chart, 'text', {x: lanes.left - 6, y: at + 5, 'text-anchor': 'end'}, value);
  }
  svg(chart, 'text', {x: 0, y: 13}, 't, in lengths of the direction');
  svg(chart, 'text', {x: lanes.left - 6, y: floor + 25, 'text-anchor': 'end'}, 'missed');
  const paths = ['', '', '', ''], size = Math.max(1, Math.min(5, (width - lanes.left) / count * 0.45));
  let limit = '', missed = '', hits = '';
  for (let i = 0; i < count; ++i) {
    const at = x(i);
    if (kind[i] === 2 && !flags[i])
      missed += `M${at} ${floor + 15}v11`;
    else
      paths[kind[i]] += mark(kind[i], at, y(t[i]), size);
    if (flags[i] & 2) hits += mark(0, at, y(t[i]), size + 4);
    limit += i === 0 ? `M${at} ${y(far[i])}` : `H${at}V${y(far[i])}`;
  }
  svg(chart, 'path', {d: limit, fill: 'none', stroke: css('--ink'), 'stroke-width': 1.6, 'stroke-dasharray': '6 3'});
  svg(chart, 'path', {d: missed, stroke: css('--candidate'), 'stroke-width': Math.max(1, Math.min(3, size))});
  paths.forEach((d, k) => svg(chart, 'path', {
                  d,
                  fill: k === 3 ? 'none' : css(kind_colors[k]),
                  stroke: css(kind_colors[k]),
                  'stroke-width': k === 3 ? 2 : 1
                }));
  svg(chart, 'path', {d: hits, fill: 'none', stroke: css('--ink'), 'stroke-width': 2.5});
  for (const i of ticks(count, width / 90)) {
    if (i < 1 || i > count || i % 1) continue;
    svg(chart, 'text', {x: x(i - 1), y: height - 22, 'text-anchor': 'middle'}, commas(i));
  }
  svg(chart, 'text', {x: lanes.left, y: height - 4}, 'step');
  svg(chart, 'line', {id: 'now', y1: lanes.top - 6, y2: floor + 28, stroke: css('--now'), 'stroke-width': 2.5});
  document.getElementById('time-legend').innerHTML = kind_names
                                                         .map((name, k) => `<b class="mark ${k === 0 ? 'round' : ''}"
    style="background:var(${kind_colors[k]})"></b>${name}${k === 3 ? ' unopened (cross)' : ''}`)
                                                         .join('') +
      '<b class="mark round" style="border:2px solid var(--ink)"></b>nearest hit so far' +
      '<b class="mark bar" style="background:var(--ink)"></b>far limit (dashed), at first ∞';
}

function move_now(walk, step) {
  const now = document.getElementById('now');
  if (!now) return;
  const chart = document.getElementById('time'), x = time_scales(walk, chart.viewBox.baseVal.width, 250).x(step);
  now.setAttribute('x1', x), now.setAttribute('x2', x);
}

function step_at(walk, client_x) {
  const chart = document.getElementById('time'), box = chart.getBoundingClientRect();
  const share = ((client_x - box.left) * chart.viewBox.baseVal.width / box.width - lanes.left) /
      (chart.viewBox.baseVal.width - lanes.left - 12);
  return Math.max(0, Math.min(walk.steps.kind.length - 1, Math.floor(share * walk.steps.kind.length)));
}
