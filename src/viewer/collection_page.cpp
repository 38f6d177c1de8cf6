// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "viewer/collection_page.h"
#include "viewer/html_text.h"

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr const char* collection_style =
    R"page(#all { flex: 1 1 55%; overflow: auto; padding: 0 1em 1em; min-width: 0; }
#pair { flex: 1 1 45%; overflow: auto; border-left: 1px solid #ccc; padding: 0 1em; box-sizing: border-box; }
h2 { font-size: 1.05em; margin: 1em 0 .3em; }
#grid { display: grid; grid-template-columns: repeat(auto-fill, minmax(128px, 1fr)); gap: 8px; }
.shape { border: 2px solid #ddd; border-radius: 6px; padding: 2px; cursor: pointer; text-align: center; font-size: 12px; background: #fff;
  overflow-wrap: anywhere; line-height: 1.2; font-family: inherit; color: inherit; }
.shape canvas { width: 112px; height: 112px; }
.shape.medoid { border-color: #c90; background: #fff8e0; }
.shape.medoid::before { content: "\2605 medoid"; color: #960; display: block; }
.shape:not(.medoid)::before { content: "\00a0"; display: block; }
.chosen { outline: 3px solid #06c; }
svg image { cursor: pointer; }
svg text { font-size: 11px; fill: #555; }
#views { display: flex; }
#views figure { flex: 1; margin: 0; min-width: 0; text-align: center; overflow-wrap: anywhere; }
#views canvas { width: 100%; aspect-ratio: 1; touch-action: none; cursor: grab; }
@media (max-width: 800px) { body { flex-direction: column; } #pair { border: 0; } }
)page";

constexpr const char* collection_body =
    R"page(<div id="all"><h1></h1><div id="notes"></div><div id="grid"></div><h2>Spanning tree</h2>
<p>The shortest way to join the shapes, the medoid as its root; numbers are distances.</p><div id="tree"></div></div>
<div id="pair"><h1>Match</h1><p id="told">Click two shapes.</p><div id="views"></div><table></table></div>
)page";

constexpr const char* collection_script = R"page(const svgNS = 'http://www.w3.org/2000/svg';
const svg = (tag, attributes, parent) => {
  const e = document.createElementNS(svgNS, tag);
  for (const [key, value] of Object.entries(attributes)) e.setAttribute(key, value);
  parent.append(e);
  return e;
};
const n = data.shapes.length, grey = '#9a9a9a';
const shown = x => x === undefined || Number.isNaN(x) ? '?' : x.toPrecision(3);

// Drawing: quads of sheets and strokes of curves, the far ones first
const home = {yaw: 0.5, pitch: 0.3};
function draw(canvas, shape, colours, camera, lit) {
  const g = canvas.getContext('2d'), size = canvas.width;
  const [cy, sy, cp, sp] = [Math.cos(camera.yaw), Math.sin(camera.yaw), Math.cos(camera.pitch), Math.sin(camera.pitch)];
  const turned = p => {
    const x = p[0] * cy - p[2] * sy, z = p[0] * sy + p[2] * cy;
    return [x, p[1] * cp - z * sp, p[1] * sp + z * cp];
  };
  const scale = 0.47 * size / shape.radius, things = [];
  shape.parts.forEach((part, index) => {
    const points = part.points.map(turned);
    if (part.columns) {
      const rows = points.length / part.columns;
      for (let r = 0; r + 1 < rows; ++r)
        for (let c = 0; c + 1 < part.columns; ++c) {
          const k = r * part.columns + c;
          things.push({index, quad: true, corners: [points[k], points[k + 1], points[k + part.columns + 1], points[k + part.columns]]});
        }
    } else
      for (let k = 0; k + 1 < points.length; ++k) things.push({index, quad: false, corners: [points[k], points[k + 1]]});
  });
  for (const t of things) t.depth = t.corners.reduce((sum, p) => sum + p[2], 0) / t.corners.length;
  things.sort((a, b) => a.depth - b.depth);
  g.clearRect(0, 0, size, size);
  g.lineCap = g.lineJoin = 'round';
  for (const t of things) {
    t.screen = t.corners.map(p => [size / 2 + scale * p[0], size / 2 - scale * p[1]]);
    let light = 1;
    if (t.quad) {
      const [a, b, c] = t.corners, u = b.map((x, i) => x - a[i]), v = c.map((x, i) => x - a[i]);
      const m = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      light = 0.6 + 0.4 * Math.abs(0.3 * m[0] + 0.6 * m[1] + 0.75 * m[2]) / (Math.hypot(...m) || 1);
    }
    const strong = !lit || lit.has(t.index);
    const rgb = [1, 3, 5].map(k => parseInt(colours[t.index].slice(k, k + 2), 16)).map(x => Math.round(strong ? light * x : 200 + 0.2 * x));
    g.beginPath();
    t.screen.forEach((p, i) => i ? g.lineTo(...p) : g.moveTo(...p));
    g.strokeStyle = g.fillStyle = `rgb(${rgb})`;
    if (t.quad) { g.closePath(); g.fill(); g.lineWidth = size / 400; } else g.lineWidth = size / 32;
    g.stroke();
  }
  return things;
}
function partAt(things, x, y, width) {
  for (let k = things.length - 1; k >= 0; --k) {
    const s = things[k].screen;
    if (things[k].quad) {
      let inside = false;
      for (let i = 0, j = 3; i < 4; j = i++)
        if (s[i][1] > y !== s[j][1] > y && x < (s[j][0] - s[i][0]) * (y - s[i][1]) / (s[j][1] - s[i][1]) + s[i][0]) inside = !inside;
      if (inside) return things[k].index;
    } else {
      const [a, b] = s, dx = b[0] - a[0], dy = b[1] - a[1];
      const t = Math.max(0, Math.min(1, ((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy || 1)));
      if (Math.hypot(x - a[0] - t * dx, y - a[1] - t * dy) < width) return things[k].index;
    }
  }
  return -1;
}

// The grid
$('h1').textContent = `Collection of ${data.total} shapes`;
for (const note of data.notes) element('p', note, $('#notes'));
const pictures = data.shapes.map((shape, i) => {
  const button = element('button', '', $('#grid')), canvas = element('canvas', '', button);
  button.className = 'shape' + (i === data.medoid ? ' medoid' : '');
  button.title = shape.name;
  canvas.width = canvas.height = 224;
  draw(canvas, shape, shape.parts.map(p => p.label < 0 ? grey : data.colours[p.label]), home);
  element('div', shape.name, button);
  button.onclick = () => choose(i);
  return canvas;
});
const buttons = [...document.querySelectorAll('.shape')];

// The tree: the root on the left, a row a leaf
{
  const near = data.shapes.map(() => []);
  const distance = {};
  for (const [a, b, d] of data.tree) { near[a].push(b); near[b].push(a); distance[`${a},${b}`] = distance[`${b},${a}`] = d; }
  const place = [], cell = {w: 130, h: 84, size: 64};
  const stack = [[data.medoid, -1, 0, false]];
  let rows = 0, depth = 0;
  while (stack.length) {
    const [i, parent, d, after] = stack.pop(), children = near[i].filter(c => c !== parent);
    depth = Math.max(depth, d);
    if (after) { place[i] = {x: d, y: (place[children[0]].y + place[children[children.length - 1]].y) / 2, parent}; continue; }
    if (!children.length) { place[i] = {x: d, y: rows++, parent}; continue; }
    stack.push([i, parent, d, true]);
    for (const c of children.slice().reverse()) stack.push([c, i, d + 1, false]);
  }
  const root = svg('svg', {width: (depth + 1) * cell.w + 30, height: rows * cell.h + 8, id: 'tree_picture'}, $('#tree'));
  const at = i => [place[i].x * cell.w + cell.size / 2 + 30, place[i].y * cell.h + cell.size / 2 + 4];
  data.shapes.forEach((shape, i) => {
    if (place[i].parent < 0) return;
    const [x, y] = at(i), [px, py] = at(place[i].parent), mx = (x + px) / 2;
    svg('path', {d: `M${px} ${py}C${mx} ${py} ${mx} ${y} ${x} ${y}`, fill: 'none', stroke: '#888', 'stroke-width': 1.5}, root);
    svg('text', {x: x - cell.size / 2 - 2, y: y - 5, 'text-anchor': 'end'}, root).textContent = shown(distance[`${i},${place[i].parent}`]);
  });
  data.shapes.forEach((shape, i) => {
    const [x, y] = at(i), medoid = i === data.medoid;
    svg('rect', {x: x - cell.size / 2, y: y - cell.size / 2, width: cell.size, height: cell.size, rx: 5, fill: medoid ? '#fff8e0' : '#fff',
      stroke: medoid ? '#c90' : '#ccc', 'stroke-width': medoid ? 3 : 1}, root);
    const picture = svg('image', {x: x - cell.size / 2 + 2, y: y - cell.size / 2 + 2, width: cell.size - 4, height: cell.size - 4, href: pictures[i].toDataURL()}, root);
    svg('title', {}, picture).textContent = shape.name;
    picture.onclick = () => choose(i);
    svg('text', {x, y: y + cell.size / 2 + 12, 'text-anchor': 'middle'}, root).textContent = shape.name.length > 18 ? shape.name.slice(0, 17) + '\u2026' : shape.name;
  });
}

// Two shapes
let chosen = [], camera = {...home};
function choose(i) {
  chosen = chosen.length === 1 && chosen[0] !== i ? [chosen[0], i] : [i];
  buttons.forEach((b, k) => b.classList.toggle('chosen', chosen.includes(k)));
  chosen.length === 2 ? match(...chosen) : ($('#told').textContent = `${data.shapes[i].name}: click another shape.`);
}
function match(a, b) {
  const swap = a > b, known = data.maps[swap ? `${b},${a}` : `${a},${b}`];
  const pairs = (known ? known.pairs : []).map(([s, t, c]) => swap ? [t, s, c] : [s, t, c]);
  const [A, B] = [data.shapes[a], data.shapes[b]], parent = A.parts.concat(B.parts).map((p, i) => i);
  const root = i => parent[i] === i ? i : root(parent[i]);
  for (const [s, t] of pairs) parent[root(A.parts.length + t)] = root(s);
  const roots = [...new Set(pairs.map(([s]) => root(s)))].sort((x, y) => x - y);
  const colour = i => { const k = roots.indexOf(root(i)); return k < 0 ? grey : data.colours[k % data.colours.length]; };
  const sides = [[A, 0], [B, A.parts.length]].map(([shape, first]) => ({shape, first, colours: shape.parts.map((p, i) => colour(first + i))}));
  $('#told').textContent = known ? `Energy ${shown(known.energies[+swap])} from left to right, ${shown(known.energies[+!swap])} from right to left.`
    : 'The page holds the matches of near shapes only; the command match shows this one.';
  $('#views').replaceChildren();
  $('table').replaceChildren();
  const rows = [];
  let lit = null;
  function light(r) {
    lit = r < 0 ? null : r;
    rows.forEach(([tr, own]) => tr.className = own === lit ? 'lit' : '');
    redraw();
  }
  for (const side of sides) {
    const figure = element('figure', '', $('#views')), canvas = element('canvas', '', figure);
    element('figcaption', side.shape.name, figure);
    canvas.width = canvas.height = 600;
    side.canvas = canvas;
    canvas.onpointerdown = e => canvas.setPointerCapture(e.pointerId);
    canvas.onpointermove = e => {
      if (e.buttons) {
        camera.yaw -= e.movementX * 0.01;
        camera.pitch = Math.max(-1.55, Math.min(1.55, camera.pitch + e.movementY * 0.01));
        return redraw();
      }
      const box = canvas.getBoundingClientRect(), scale = canvas.width / box.width;
      const part = partAt(side.things, (e.clientX - box.left) * scale, (e.clientY - box.top) * scale, 12);
      canvas.title = part < 0 ? '' : side.shape.parts[part].name;
      light(part < 0 ? -1 : root(side.first + part));
    };
    canvas.onpointerleave = () => light(-1);
    canvas.ondblclick = () => { camera = {...home}; redraw(); };
  }
  function redraw() {
    for (const side of sides) {
      const parts = lit === null ? null : new Set(side.shape.parts.map((p, i) => i).filter(i => root(side.first + i) === lit));
      side.things = draw(side.canvas, side.shape, side.colours, camera, parts);
    }
  }
  redraw();
  if (!known) return;
  const head = element('tr', '', element('thead', '', $('table'))), body = element('tbody', '', $('table'));
  for (const text of ['', A.name, B.name, 'confidence']) element('th', text, head);
  const row = (fill, cells, own) => {
    const tr = element('tr', '', body);
    element('i', '', element('td', '', tr)).style.background = fill;
    for (const cell of cells) element('td', cell, tr);
    if (own === undefined) return;
    tr.onmouseenter = () => light(own);
    tr.onmouseleave = () => light(-1);
    rows.push([tr, own]);
  };
  for (const r of roots) {
    const of = pairs.filter(([s]) => root(s) === r), names = (shape, k) => [...new Set(of.map(p => p[k]))].map(i => shape.parts[i].name).join(', ');
    row(colour(r), [names(A, 0), names(B, 1), shown(of.reduce((sum, p) => sum + p[2], 0) / of.length / 100)], r);
  }
  const rest = (shape, first) => shape.parts.filter((p, i) => !roots.includes(root(first + i))).map(p => p.name).join(', ');
  if (rest(A, 0) || rest(B, A.parts.length)) row(grey, [rest(A, 0), rest(B, A.parts.length), '-']);
}
)page";

} // namespace

void write_collection_page(std::ostream& out, const Json& data)
{
  write_page(out, "Collection of shapes", collection_style, collection_body, data, collection_script);
}

} // namespace CGAL::Shape_correspondence::IO
