'use strict';
// What the page is told, and how cells become lines.

const data = JSON.parse(document.getElementById('data').textContent);
const types = {
  u8: Uint8Array,
  u16: Uint16Array,
  u32: Uint32Array,
  i32: Int32Array,
  f32: Float32Array
};

// {name_u8: base64, ...} as {name: typed array, ...}; what is no array stays.
function unpacked(packed) {
  const all = {};
  for (const [key, value] of Object.entries(packed)) {
    const [, name, type] = key.match(/^(\w+)_([uif]\d+)$/) ?? [];
    if (!type) {
      all[key] = value;
      continue;
    }
    const text = atob(value), bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
    all[name] = new types[type](bytes.buffer);
  }
  return all;
}

// A polyhedron as it stands in `shape` from `at`: vertices and faces.
function polyhedron(shape, at) {
  const [vertex_count, face_count] = [shape[at], shape[at + 1]], faces = [];
  let place = at + 2 + 3 * vertex_count;
  for (let i = 0; i < face_count; ++i) {
    faces.push(Array.from(shape.subarray(place + 1, place + 1 + shape[place])));
    place += 1 + shape[place];
  }
  return {vertex: (i) => [0, 1, 2].map((axis) => shape[at + 2 + 3 * i + axis]), faces, length: place - at};
}

// Cells of unpacked arrays, with the place of each one's shape.
function with_places(cells) {
  cells.place = new Uint32Array(cells.kind.length);
  let at = 0;
  for (let i = 0; i < cells.kind.length; ++i) {
    cells.place[i] = at;
    at += [6, 4, 8][cells.kind[i]] ?? polyhedron(cells.shape, at).length;
  }
  return cells;
}

const box_edges = [0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 1, 3, 4, 6, 5, 7, 0, 4, 1, 5, 2, 6, 3, 7];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (v, length) => {
  const n = length / Math.hypot(...v);
  return v.map((x) => x * n);
};
const box_corner =
    (shape, at, i) => [shape[at + (i & 1 ? 3 : 0)], shape[at + (i & 2 ? 4 : 1)], shape[at + (i & 4 ? 5 : 2)]];

function push_circle(out, center, axis, radius) {
  const steps = 24, x = scaled(cross(Math.abs(axis[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0], axis), radius);
  const y = scaled(cross(axis, x), radius);
  for (let i = 0; i < steps; ++i) {
    for (const angle of [i, i + 1].map((k) => 2 * Math.PI * k / steps)) {
      for (let k = 0; k < 3; ++k) out.push(center[k] + Math.cos(angle) * x[k] + Math.sin(angle) * y[k]);
    }
  }
}

function push_cylinder(out, s) {
  const center = s.slice(0, 3), axis = s.slice(3, 6),
        ends = [-s[7], s[7]].map((half) => center.map((c, k) => c + half * axis[k]));
  const from = out.length;
  for (const end of ends) push_circle(out, end, axis, s[6]);
  const ring = (out.length - from) / 2;
  for (let side = 0; side < 4; ++side) {
    for (const end of [0, 1])
      for (let k = 0; k < 3; ++k) out.push(out[from + end * ring + side * 36 + k]);
  }
}

function push_polyhedron(out, solid) {
  const seen = new Set();
  for (const face of solid.faces) {
    face.forEach((a, i) => {
      const b = face[(i + 1) % face.length], key = Math.min(a, b) * 65536 + Math.max(a, b);
      if (!seen.has(key)) out.push(...solid.vertex(a), ...solid.vertex(b));
      seen.add(key);
    });
  }
}

// Appends the ends of a cell's lines, three numbers a point. Of a sphere the circle that faces `axis`, or three.
function push_outline(out, cells, i, axis) {
  const {shape} = cells, at = cells.place[i];
  if (cells.kind[i] === 0) {
    for (const corner of box_edges) out.push(...box_corner(shape, at, corner));
  } else if (cells.kind[i] === 1) {
    const axes = axis ? [axis] : [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    for (const around of axes) push_circle(out, shape.subarray(at, at + 3), around, shape[at + 3]);
  } else if (cells.kind[i] === 2) {
    push_cylinder(out, Array.from(shape.subarray(at, at + 8)));
  } else {
    push_polyhedron(out, polyhedron(shape, at));
  }
}

// All outlines: ends of lines, where each cell's begin, and its extent along the axes.
function outlines(cells, axis) {
  const points = [], first = new Uint32Array(cells.kind.length + 1), extent = new Float32Array(6 * cells.kind.length);
  for (let i = 0; i < cells.kind.length; ++i) {
    push_outline(points, cells, i, axis);
    first[i + 1] = points.length;
    for (let k = 0; k < 3; ++k) {
      let lo = Infinity, hi = -Infinity;
      for (let p = first[i] + k; p < first[i + 1]; p += 3) lo = Math.min(lo, points[p]), hi = Math.max(hi, points[p]);
      if (cells.kind[i] === 1) {
        const [center, radius] = [cells.shape[cells.place[i] + k], cells.shape[cells.place[i] + 3]];
        lo = center - radius, hi = center + radius;
      }
      extent[6 * i + k] = lo, extent[6 * i + 3 + k] = hi;
    }
  }
  return {points: Float32Array.from(points), first, extent};
}

const prepared = new Map();

// A structure's arrays, made when it is first looked at.
function structure_at(index) {
  if (!prepared.has(index)) {
    const raw = data.structures[index];
    const cells = with_places(unpacked(raw.cells));
    const walks = raw.walks.map((walk) => {
      const all = unpacked(walk);
      all.cells = with_places(unpacked(walk.cells));
      all.steps = unpacked(walk.steps);
      all.totals = totals(all.steps);
      return all;
    });
    prepared.set(index, {...raw, cells, walks});
  }
  return prepared.get(index);
}

// Outlines; spheres are drawn anew when the view has turned.
function lines_toward(structure, axis) {
  const key = structure.cells.kind[0] === 1 && axis ? axis.map((x) => x.toFixed(3)).join() : 'all';
  if (structure.lines_key !== key) Object.assign(structure, {lines: outlines(structure.cells, axis), lines_key: key});
  return structure.lines;
}

// Counters after each step: nodes, leaves, candidates, culled.
function totals(steps) {
  const sums = new Uint32Array(4 * (steps.kind.length + 1));
  for (let i = 0; i < steps.kind.length; ++i) {
    for (let k = 0; k < 4; ++k) sums[4 * (i + 1) + k] = sums[4 * i + k] + (steps.kind[i] === k);
    sums[4 * (i + 1) + 2] += steps.skipped[i];
  }
  return sums;
}
const counters_at = (walk, step) => Array.from(walk.totals.subarray(4 * (step + 1), 4 * (step + 2)));

// Cells on the stack after a step, the next to be taken up first.
function stack_at(walk, step) {
  const all = [];
  for (let i = 0; i < walk.since.length; ++i)
    if (walk.since[i] <= step && step < walk.until[i]) all.push(i);
  return all.sort((a, b) => walk.until[a] - walk.until[b]);
}

function hit_at(walk, step) {
  for (let i = Math.min(step, walk.steps.kind.length - 1); i >= 0; --i)
    if (walk.steps.flags[i] & 2) return i;
  return -1;
}

const digits = (x) => Number.isFinite(x) ? String(+x.toPrecision(6)) : '∞';
const commas = (n) => n.toLocaleString('en');
const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const is_dark = () => matchMedia('(prefers-color-scheme: dark)').matches;
