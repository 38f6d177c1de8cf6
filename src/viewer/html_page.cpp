// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "viewer/html_page.h"
#include "viewer/html_text.h"

#include <ostream>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr const char* page_style = R"page(#view { flex: 1 1 60%; position: relative; min-width: 0; }
canvas { position: absolute; width: 100%; height: 100%; touch-action: none; cursor: grab; }
#side { flex: 0 1 38%; max-width: 44em; overflow: auto; border-left: 1px solid #ccc; padding: 0 1em; box-sizing: border-box; }
label { margin-right: 1em; white-space: nowrap; }
#tip { position: absolute; display: none; pointer-events: none; max-width: 26em; background: #fffffff0; border: 1px solid #999;
  border-radius: 4px; padding: .3em .6em; }
#tip b { display: block; }
@media (max-width: 700px) { body { flex-direction: column; } #side { max-width: none; border: 0; flex: 1 1 45%; } }
)page";

constexpr const char* page_body = R"page(<div id="view"><canvas></canvas><div id="tip"></div></div>
<div id="side"><h1></h1><div id="notes"></div><p id="roles"></p><table></table></div>
)page";

constexpr const char* page_script = R"page(const bytes = s => Uint8Array.from(atob(s), c => c.charCodeAt(0)).buffer;

document.title = data.title;
$('h1').textContent = data.title;
for (const note of data.notes) element('p', note, $('#notes'));

// The table
const rows = [];
if (data.heading.length) {
  const head = element('tr', '', element('thead', '', $('table')));
  element('th', '', head);
  for (const cell of data.heading) element('th', cell, head);
  const body = element('tbody', '', $('table'));
  for (const row of data.rows) {
    const tr = element('tr', '', body);
    element('i', '', element('td', '', tr)).style.background = row.colour;
    for (const cell of row.cells) element('td', cell, tr);
    tr.onmouseenter = () => light(row.things);
    tr.onmouseleave = () => light([]);
    rows.push([tr, new Set(row.things)]);
  }
}

// The picture
const canvas = $('canvas');
const gl = canvas.getContext('webgl', {antialias: true, preserveDrawingBuffer: true});
if (!gl || !gl.getExtension('OES_element_index_uint')) element('p', 'The picture needs WebGL, which this browser does not offer.', $('#notes'));
const roles = [...new Set(data.layers.map(l => l.role))];
const shown = new Set(roles);
let lit = new Set(), frame = 0;
function light(things) {
  lit = new Set(things);
  for (const [tr, own] of rows) tr.className = things.some(t => own.has(t)) ? 'lit' : '';
  redraw();
}
for (const role of roles) {
  const box = element('input', '', element('label', '', $('#roles')));
  box.type = 'checkbox';
  box.checked = true;
  box.after(' ' + role);
  box.onchange = () => { box.checked ? shown.add(role) : shown.delete(role); redraw(); };
}

const vertexShader = `attribute vec3 position, normal; uniform mat4 view, projection; varying vec3 n;
void main() { n = mat3(view) * normal; gl_Position = projection * view * vec4(position, 1.0); }`;
const fragmentShader = `precision mediump float; uniform vec4 colour; uniform float flat_; varying vec3 n;
void main() { vec3 m = normalize(n); if (!gl_FrontFacing) m = -m;
  float light = 0.35 + 0.5 * max(dot(m, normalize(vec3(0.4, 0.7, 1.0))), 0.0) + 0.2 * (0.5 + 0.5 * m.y);
  gl_FragColor = vec4(mix(colour.rgb * light, colour.rgb, flat_), colour.a); }`;
function program() {
  const p = gl.createProgram();
  for (const [type, source] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(p, shader);
  }
  gl.bindAttribLocation(p, 0, 'position');
  gl.bindAttribLocation(p, 1, 'normal');
  gl.linkProgram(p);
  gl.useProgram(p);
  return p;
}
const buffer = (target, data) => { const b = gl.createBuffer(); gl.bindBuffer(target, b); gl.bufferData(target, data, gl.STATIC_DRAW); return b; };
const low = [1e30, 1e30, 1e30], high = [-1e30, -1e30, -1e30];
const prog = program();
const uniform = Object.fromEntries(['view', 'projection', 'colour', 'flat_'].map(u => [u, gl.getUniformLocation(prog, u)]));
const layers = data.layers.map(l => {
  const points = new Float32Array(bytes(l.points)), indices = new Uint32Array(bytes(l.triangles));
  for (let i = 0; i < points.length; ++i) {
    low[i % 3] = Math.min(low[i % 3], points[i]);
    high[i % 3] = Math.max(high[i % 3], points[i]);
  }
  return {...l, count: indices.length, points: buffer(gl.ARRAY_BUFFER, points),
    normals: buffer(gl.ARRAY_BUFFER, new Float32Array(bytes(l.normals))), triangles: buffer(gl.ELEMENT_ARRAY_BUFFER, indices)};
});
// See-through layers come last.
layers.sort((a, b) => (a.colour[3] < 1) - (b.colour[3] < 1));

const home = {yaw: 0.5, pitch: 0.3, zoom: 1, x: 0, y: 0};
const camera = {...home};
const size = Math.hypot(...high.map((h, i) => h - low[i])) || 1, middle = high.map((h, i) => (h + low[i]) / 2);
const times = (turn, v) => turn.map(r => r[0] * v[0] + r[1] * v[1] + r[2] * v[2]);
function rotation(yaw, pitch) {
  const [cy, sy, cp, sp] = [Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)];
  return [[cy, 0, -sy], [-sy * sp, cp, -cy * sp], [sy * cp, sp, cy * cp]];
}
const turnedCorners = [...Array(8).keys()].map(k =>
  times(rotation(home.yaw, home.pitch), high.map((h, i) => (k >> i & 1 ? h : low[i]) - middle[i])));
function matrices() {
  const turn = rotation(camera.yaw, camera.pitch);
  const angle = 0.5, aspect = canvas.width / canvas.height, f = 1 / Math.tan(angle / 2);
  // From home, the whole box is in view
  const fit = Math.max(...turnedCorners.map(([x, y, z]) => z + f * Math.max(Math.abs(x) / aspect, Math.abs(y))));
  const distance = camera.zoom * 1.03 * (fit > 0 ? fit : 1);
  const move = times(turn, middle).map((m, i) => [camera.x, camera.y, -distance][i] - m);
  const near = Math.max(distance - size, 0.01 * distance), far = distance + size;
  return {view: [0, 1, 2].flatMap(c => [turn[0][c], turn[1][c], turn[2][c], 0]).concat(move, 1), distance, f,
    projection: [f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0]};
}
function draw(ids) {
  const m = matrices();
  gl.viewport(0, 0, canvas.width, canvas.height);
  gl.clearColor(...(ids ? [0, 0, 0, 0] : [1, 1, 1, 1]));
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.enable(gl.DEPTH_TEST);
  gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
  gl.uniformMatrix4fv(uniform.view, false, m.view);
  gl.uniformMatrix4fv(uniform.projection, false, m.projection);
  gl.uniform1f(uniform.flat_, ids ? 1 : 0);
  for (const l of layers) {
    if (!shown.has(l.role) || (ids && l.thing < 0)) continue;
    const clear = !ids && l.colour[3] < 1;
    clear ? gl.enable(gl.BLEND) : gl.disable(gl.BLEND);
    gl.depthMask(!clear);
    let colour = l.colour;
    if (ids) colour = [(l.thing + 1) % 256 / 255, (l.thing + 1 >> 8) / 255, 0, 1];
    else if (lit.has(l.thing)) colour = [...colour.slice(0, 3).map(c => 0.4 * c + 0.6), clear ? 0.75 : 1];
    else if (lit.size) colour = [...colour.slice(0, 3).map(c => 0.5 * c + 0.25), clear ? 0.6 * colour[3] : 1];
    gl.uniform4fv(uniform.colour, colour);
    gl.bindBuffer(gl.ARRAY_BUFFER, l.points);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, l.normals);
    gl.enableVertexAttribArray(1);
    gl.vertexAttribPointer(1, 3, gl.FLOAT, false, 0, 0);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, l.triangles);
    gl.drawElements(gl.TRIANGLES, l.count, gl.UNSIGNED_INT, 0);
  }
  gl.depthMask(true);
}
function redraw() {
  if (!frame) frame = requestAnimationFrame(() => { frame = 0; draw(false); });
}
function thingAt(event) {
  const box = canvas.getBoundingClientRect(), pixel = new Uint8Array(4), ratio = canvas.width / box.width;
  draw(true);
  gl.readPixels((event.clientX - box.left) * ratio, canvas.height - 1 - (event.clientY - box.top) * ratio, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  draw(false);
  return pixel[0] + 256 * pixel[1] - 1;
}
function point(event) {
  const thing = data.things[thingAt(event)], tip = $('#tip');
  tip.style.display = thing ? 'block' : 'none';
  if ((thing ? thing.index : -1) !== ([...lit][0] ?? -1)) light(thing ? [thing.index] : []);
  if (!thing) return;
  tip.replaceChildren();
  element('b', thing.name, tip);
  for (const [key, value] of thing.details) element('div', key + ': ' + value, tip);
  const box = $('#view').getBoundingClientRect();
  tip.style.left = Math.min(event.clientX - box.left + 14, box.width - tip.offsetWidth - 4) + 'px';
  tip.style.top = Math.min(event.clientY - box.top + 14, box.height - tip.offsetHeight - 4) + 'px';
}
data.things.forEach((t, i) => t.index = i);
canvas.onpointerdown = e => canvas.setPointerCapture(e.pointerId);
canvas.onpointermove = e => {
  if (!e.buttons) return point(e);
  $('#tip').style.display = 'none';
  if (e.buttons === 1 && !e.shiftKey) {
    camera.yaw -= e.movementX * 0.008;
    camera.pitch = Math.max(-1.55, Math.min(1.55, camera.pitch + e.movementY * 0.008));
  } else {
    const m = matrices(), step = 2 * m.distance / m.f / canvas.clientHeight;
    camera.x += e.movementX * step;
    camera.y -= e.movementY * step;
  }
  redraw();
};
canvas.onpointerleave = () => { $('#tip').style.display = 'none'; light([]); };
canvas.oncontextmenu = e => e.preventDefault();
canvas.ondblclick = () => { Object.assign(camera, home); redraw(); };
canvas.addEventListener('wheel', e => { e.preventDefault(); camera.zoom = Math.max(0.05, Math.min(5, camera.zoom * Math.exp(e.deltaY * 0.001))); redraw(); }, {passive: false});
new ResizeObserver(() => {
  canvas.width = canvas.clientWidth * devicePixelRatio;
  canvas.height = canvas.clientHeight * devicePixelRatio;
  draw(false);
}).observe(canvas);
)page";

/// The numbers in the bytes of another type.
template <typename Number, typename Matrix>
std::string base64_of(const Matrix& matrix)
{
  std::string bytes(sizeof(Number) * static_cast<std::size_t>(matrix.size()), '\0');
  Eigen::Map<Eigen::Matrix<Number, 3, Eigen::Dynamic>>(reinterpret_cast<Number*>(&bytes[0]), 3, matrix.cols()) =
      matrix.template cast<Number>();
  return base64(bytes);
}

} // namespace

Html_page::Html_page(const std::string& title)
{
  data_["title"] = title;
  for (const char* list : {"notes", "things", "layers", "heading", "rows"})
    data_[list] = Json::array();
}

void Html_page::add_note(const std::string& note) { data_["notes"].push_back(note); }

int Html_page::add_thing(const std::string& name, const std::vector<std::pair<std::string, std::string>>& details)
{
  Json list = Json::array();
  for (const auto& [key, value] : details)
    list.push_back(Json::array({key, value}));
  data_["things"].push_back({{"name", name}, {"details", list}});
  return static_cast<int>(data_["things"].size()) - 1;
}

void Html_page::add_layer(int thing, const std::string& role, const Drawn_mesh& mesh, const Colour& colour,
                          double alpha, const Point& translation)
{
  if (mesh.triangles.cols() == 0) return;
  const std::array<double, 3> c = screen_colour(colour);
  data_["layers"].push_back({{"thing", thing},
                             {"role", role},
                             {"colour", {c[0], c[1], c[2], alpha}},
                             {"points", base64_of<float>((mesh.points.colwise() + translation).eval())},
                             {"normals", base64_of<float>(mesh.normals)},
                             {"triangles", base64_of<std::uint32_t>(mesh.triangles)}});
}

void Html_page::set_table_heading(const std::vector<std::string>& cells) { data_["heading"] = cells; }

void Html_page::add_row(const std::vector<int>& things, const Colour& colour, const std::vector<std::string>& cells)
{
  data_["rows"].push_back({{"things", things}, {"colour", css_colour(colour)}, {"cells", cells}});
}

void Html_page::write(std::ostream& out) const { write_page(out, "", page_style, page_body, data_, page_script); }

} // namespace CGAL::Shape_correspondence::IO
