// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {$, element, setBreakable} from '../../src/viewer/page/dom.js';
import {exampleFiles} from './examples.js';
import {unpacked} from './unpacked.js';

// The page that chooses two models, runs the program on them, and shows the pages that it writes.

const modelFormats = /\.(obj|ply|off|stl|gltf|glb|dae|fbx|3ds|dxf|ac|json)$/i;
const largestInput = 256 << 20; // bytes of all files of a model
const mostFiles = 5000;
const categories = ['airplane', 'bed', 'car', 'chair', 'lamp', 'plant', 'shelf', 'sofa', 'table', 'velocipede'];

const embedded = id => document.getElementById(id).textContent;

// The program

class Cancelled extends Error {}

/** The program, in a thread of its own, which is started anew after it was cancelled. */
class Program {
  constructor() {
    this.code = new Blob([embedded('module'), '\n', embedded('worker')], {type: 'text/javascript'});
    this.folders = new Map();
    this.start();
  }

  start() {
    const url = URL.createObjectURL(this.code), worker = new Worker(url);
    this.worker = worker;
    worker.onmessage = ({data}) => {
      if (data.total !== undefined) return this.waiting && this.waiting.onProgress(data);
      this.end(data.failure === undefined ? null : new Error(data.failure), data);
    };
    worker.onerror = event => this.end(new Error(event.message || 'the program cannot be started in this browser'));
    worker.postMessage({program: embedded('program')});
    for (const [folder, files] of this.folders) worker.postMessage({folder, files});
  }

  /** Gives the program a folder of files, [[path, bytes]], in place of the one of that name. */
  put(folder, files) {
    this.folders.set(folder, files);
    this.worker.postMessage({folder, files});
  }

  /** Runs a command. @returns {Promise} of {files, memory}; it fails with what the program complains of */
  run(given, outputs, onProgress = () => {}) {
    return new Promise((resolve, reject) => {
      this.waiting = {resolve, reject, onProgress};
      this.worker.postMessage({arguments: given, outputs});
    });
  }

  end(error, data) {
    const {waiting} = this;
    this.waiting = null;
    if (error) this.restart(); // what is left of it cannot be trusted
    if (!waiting) return;
    if (error) waiting.reject(/memory|RangeError|out of bounds/i.test(error.message)
        ? new Error('The models take more memory than this browser gives; simplify them.') : error);
    else if (data.status !== 0) waiting.reject(new Error(complaint(data.errors)));
    else waiting.resolve(data);
  }

  restart() {
    this.worker.terminate();
    this.start();
  }

  cancel() {
    const {waiting} = this;
    this.waiting = null;
    this.restart();
    if (waiting) waiting.reject(new Cancelled());
  }
}

/** What the program says at its end, without its name and what it says of a command line. */
function complaint(text) {
  const lines = text.trim().split('\n').map(line => line.replace(/^shape_correspondence: /, '').replace(/; try 'shape_correspondence .*'$/, ''));
  return lines.filter(line => !line.startsWith('note: ')).join('\n') || 'The program ended without a result.';
}

// Files

/** The files of what was dropped, [[path, File]]; folders with all that is in them. */
async function filesOfEntry(entry, folder = '') {
  if (entry.isFile) return [[folder + entry.name, await new Promise((resolve, reject) => entry.file(resolve, reject))]];
  const reader = entry.createReader(), result = [];
  for (let entries; (entries = await new Promise((resolve, reject) => reader.readEntries(resolve, reject))).length;)
    for (const inner of entries) {
      result.push(...await filesOfEntry(inner, `${folder}${entry.name}/`));
      if (result.length > mostFiles) throw new Error(`${entry.name}: it has more than ${mostFiles} files; choose the folder of one model`);
    }
  return result;
}

function droppedFiles(transfer) {
  const items = [...transfer.items].filter(item => item.kind === 'file').map(item => [item.webkitGetAsEntry && item.webkitGetAsEntry(), item.getAsFile()]);
  return Promise.all(items.map(([entry, file]) => entry ? filesOfEntry(entry) : [[file.name, file]])).then(lists => lists.flat());
}

const chosenFiles = input => [...input.files].map(file => [file.webkitRelativePath || file.name, file]);

/** The models among files: every folder is one, and so is every file of a format that is read. [{name, path, files}] */
function modelsAmong(files) {
  const folders = new Map(), single = [], others = [];
  for (const [path, file] of files) {
    const name = path.split('/')[0];
    if (name !== path) folders.set(name, [...folders.get(name) || [], [path, file]]);
    else (modelFormats.test(path) ? single : others).push([path, file]);
  }
  return [...[...folders].map(([name, inner]) => folderModel(name, inner)),
          ...single.map(([path, file]) => ({name: path, path, files: [[path, file], ...others]}))];
}

/** A folder with one model file is that file with what it names; else its files are the parts. */
function folderModel(name, files) {
  const models = files.filter(([path]) => modelFormats.test(path) && !/\.json$/i.test(path));
  if (!models.length) throw new Error(`${name}: there is no model in the folder; it needs a mesh file for every part, or one model file`);
  return {name, path: models.length === 1 ? models[0][0] : name, files};
}

/** The bytes of the files of a model. */
async function read({name, path, files}) {
  const size = files.reduce((sum, [, file]) => sum + file.size, 0);
  if (size > largestInput) throw new Error(`${name}: it has ${Math.round(size / (1 << 20))} MB; at most ${largestInput >> 20} MB are read. Simplify the model.`);
  return {name, path, files: await Promise.all(files.map(async ([inner, file]) => [inner, new Uint8Array(await file.arrayBuffer())]))};
}

// The page

const titles = {source: 'First model', target: 'Second model', match: 'Match', blend: 'Blend'}; // of what is shown
const sides = ['source', 'target'], chosen = {source: null, target: null}, shown = new Map();
const program = new Program();
const firstExample = {source: 'chair_four_legged', target: 'chair_swivel'}; // that the page opens with
let examples = null, isWorking = false, isExample = false;

const examplesByName = () => examples = examples || unpacked(embedded('examples')).then(exampleFiles);

function addChoice(parent, text, choices, hint) {
  const label = element('label', text, parent), select = element('select', '', label);
  label.className = 'option';
  label.title = hint;
  for (const [value, name] of choices) element('option', name, select).value = value;
  return select;
}

function addFileButton(parent, text, attributes, take) {
  const label = element('label', text, parent), input = element('input', '', label);
  label.className = 'file';
  Object.assign(input, {type: 'file', ...attributes});
  input.onchange = () => attempt(() => take(chosenFiles(input)).finally(() => { input.value = ''; }));
}

const cards = Object.fromEntries(sides.map(side => {
  const root = $('#' + side), card = {root, heading: element('h2', titles[side], root),
                                      told: element('small', 'not chosen yet', root)};
  const choices = element('div', '', root);
  choices.className = 'choices';
  addFileButton(choices, 'File', {multiple: true}, files => chooseOne(side, files));
  if ('webkitdirectory' in HTMLInputElement.prototype) addFileButton(choices, 'Folder', {webkitdirectory: true}, files => chooseOne(side, files));
  const example = element('select', '', choices);
  example.ariaLabel = `example as the ${side}`;
  element('option', 'or an example', example).value = '';
  for (const name of embedded('example-names').split(' ')) element('option', name.replace(/_/g, ' '), example).value = name;
  example.onchange = () => example.value && attempt(async () => choose(side, {name: example.value, path: example.value, files: (await examplesByName())[example.value]}));
  card.example = example;
  card.up = addChoice(root, 'upright axis', [['', 'automatic'], ['x', 'x'], ['y', 'y'], ['z', 'z']], 'Which axis of the file is up');
  card.up.onchange = () => chosen[side] && attempt(() => preview(side));
  card.pieces = element('details', '', root);
  card.pieces.hidden = true;
  root.ondragover = event => { event.preventDefault(); root.classList.add('dropping'); };
  root.ondragleave = () => root.classList.remove('dropping');
  root.ondrop = event => {
    event.preventDefault();
    event.stopPropagation();
    stopDropping();
    const files = droppedFiles(event.dataTransfer);
    attempt(async () => takeDropped(side, await files));
  };
  return [side, card];
}));

const options = {
  method: addChoice($('#options'), 'method', [['', 'automatic'], ['paper', 'of the paper (beam search)'], ['exact', 'exact search, least energy']],
                    'How correspondences are found'),
  category: addChoice($('#options'), 'category', [['', 'automatic'], ...categories.map(name => [name, name])], 'What both models are; by it the roles of parts are known'),
  front: addChoice($('#options'), 'front', [['', 'automatic'], ['given', 'as in the files'], ['likely', 'turned by roles of parts'], ['auto', 'any side']],
                   'Which sides of the models may be their fronts'),
  parts: addChoice($('#options'), 'parts of a file', [['', 'automatic'], ['file', 'objects of the file'], ['components', 'loose pieces'], ['segments', 'segments']],
                   'How parts are made of a model file; files of a folder are parts as they are'),
};
options.method.onchange = () => { options.category.disabled = options.method.value !== ''; update(); };
options.parts.onchange = () => attempt(async () => {
  for (const side of sides.filter(one => chosen[one])) {
    chosen[side].parts = null;
    await preview(side);
  }
});
options.category.onchange = options.front.onchange = () => update();

function stopDropping() {
  document.body.classList.remove('dropping');
  for (const side of sides) cards[side].root.classList.remove('dropping');
}
document.ondragover = event => { event.preventDefault(); document.body.classList.add('dropping'); };
document.ondragleave = event => { if (!event.relatedTarget) stopDropping(); };
document.ondrop = event => {
  event.preventDefault();
  stopDropping();
  const files = droppedFiles(event.dataTransfer);
  attempt(async () => takeDropped(null, await files));
};

// What is dragged over the shown page would be that page's: a shield takes it, until the mouse moves without dragging
const shield = $('#shield'), protect = () => { shield.hidden = false; };
shield.onpointermove = shield.onpointerdown = () => { shield.hidden = true; };
$('#shown').onmouseleave = document.documentElement.onmouseleave = protect;

/** Two models are source and target; one goes where it was dropped, or where none is yet. */
async function takeDropped(side, files) {
  const models = modelsAmong(files);
  if (models.length === 2) return chooseBoth(models);
  return chooseOne(side || (chosen.source && !chosen.target ? 'target' : 'source'), files);
}

async function chooseBoth(models) {
  const read_models = await Promise.all(models.map(read));
  leaveExample();
  for (const side of sides) chosen[side] = null;
  for (const [i, side] of sides.entries()) await choose(side, read_models[i]);
}

/** A pair of examples, matched, so that one sees at once what the page does. */
async function openExample() {
  const files = await examplesByName();
  if (sides.some(side => chosen[side])) return;
  isExample = true;
  for (const side of sides) put(side, {name: firstExample[side], path: firstExample[side], files: files[firstExample[side]]});
  await match();
}

/** The example makes way for models that one chooses. */
function leaveExample() {
  if (!isExample) return;
  isExample = false;
  shown.clear();
  for (const side of sides) forget(side);
}

async function chooseOne(side, files) {
  const models = modelsAmong(files);
  if (models.length === 2) return chooseBoth(models);
  if (!models.length) throw new Error('There is no model among these files; models are OBJ, PLY, STL, OFF or JSON files, or folders of them.');
  if (models.length > 2) throw new Error(`These are ${models.length} models; choose one or two, or a folder whose files are the parts of one.`);
  return choose(side, await read(models[0]));
}

/** @param model {name, path, files: [[path, bytes]]} */
async function choose(side, model) {
  leaveExample();
  put(side, model);
  try {
    await preview(side);
  } catch (error) {
    forget(side);
    throw error;
  }
  if (sides.every(one => chosen[one])) await match();
}

function put(side, model) {
  chosen[side] = {...model, parts: null};
  for (const name of [side, 'match', 'blend']) shown.delete(name);
  const card = cards[side];
  setBreakable(model.name, card.heading);
  card.told.textContent = model.files.length === 1 ? 'a file' : `${model.files.length} files`;
  card.root.classList.add('chosen');
  card.example.value = '';
  card.pieces.hidden = true;
  program.put(side, model.files);
  update();
}

/** A model that cannot be used is as none. */
function forget(side) {
  chosen[side] = null;
  const card = cards[side];
  card.heading.textContent = titles[side];
  card.told.textContent = 'not chosen yet';
  card.root.classList.remove('chosen');
  update();
}

/** The parts of a model by hand: which of its pieces are in which part. @param list as the program writes it */
function showPieces(side, list) {
  const {pieces: root} = cards[side], rows = [];
  root.replaceChildren();
  root.hidden = false;
  element('summary', `Parts by hand: ${new Set(list.pieces.map(piece => piece.part)).size} of ${list.pieces.length} pieces`, root);
  element('p', 'Choose pieces, then join them to one part or separate them. Pieces with one name are one part.', root);
  const grid = element('div', '', root), buttons = element('div', '', root);
  grid.className = 'pieces';
  buttons.className = 'choices';
  for (const {piece, part} of list.pieces) {
    const label = element('label', '', grid), box = element('input', '', label), name = element('input', '', grid);
    box.type = 'checkbox';
    setBreakable(piece, element('span', '', label));
    Object.assign(name, {value: part, ariaLabel: `part of ${piece}`});
    rows.push({piece, box, name});
  }
  const change = rename => attempt(() => {
    const taken = rows.filter(row => row.box.checked);
    if (rename && !taken.length) throw new Error('Choose pieces first.');
    if (rename) rename(taken);
    chosen[side].parts = {...list, pieces: rows.map(({piece, name}) => ({piece, part: name.value}))};
    return preview(side);
  });
  const add = (text, rename) => { element('button', text, buttons).onclick = () => change(rename); };
  add('Join', taken => taken.forEach(row => { row.name.value = taken[0].name.value; }));
  add('Separate', taken => taken.forEach(row => { row.name.value = row.piece; }));
  add('Use names', null);
}

const pathOf = side => `${side}/${chosen[side].path}`;
const partsMode = () => options.parts.value ? ['--parts', options.parts.value] : [];
const byHand = (side, option) => chosen[side].parts ? [option, `${side}_parts/parts.json`] : [];

/** How the models are read. */
function readingOptions() {
  return [...sides.flatMap(side => [...cards[side].up.value ? [`--${side}-up`, cards[side].up.value] : [], ...byHand(side, `--${side}-parts-from`)]),
          ...partsMode()];
}

function matchOptions() {
  const method = {'': [], paper: ['--paper'], exact: ['--search', 'exact']}[options.method.value];
  const category = options.category.value && !options.category.disabled ? ['--category', options.category.value] : [];
  return [...method, ...category, ...options.front.value ? ['--front', options.front.value] : [], ...readingOptions()];
}

/** Shows the parts of a model. Graph files have none to show. */
async function preview(side) {
  for (const name of ['match', 'blend']) shown.delete(name);
  if (/\.json$/i.test(chosen[side].path)) return update();
  const up = cards[side].up.value, outputs = ['parts.html', 'parts.json'];
  if (chosen[side].parts) program.put(side + '_parts', [['parts.json', new TextEncoder().encode(JSON.stringify(chosen[side].parts))]]);
  const {files} = await work('Reading', () => program.run(
      ['parts', pathOf(side), ...up ? ['--up', up] : [], ...partsMode(), ...byHand(side, '--parts-from'), '--html', outputs[0], '--parts-json', outputs[1],
       '--quiet'], outputs, tell));
  showPieces(side, JSON.parse(new TextDecoder().decode(files[1])));
  show(side, files[0]);
}

async function match() {
  const begin = performance.now(), outputs = ['match.html', 'match.json', 'match.glb'];
  const {files, memory} = await work('Matching', () => program.run(
      ['match', pathOf('source'), pathOf('target'), '--html', outputs[0], '--json', outputs[1], '--glb', outputs[2],
       '--cache', 'cache', '--progress', 'always', ...matchOptions()], outputs, tell));
  shown.delete('blend');
  show('match', files[0], [['match.html', files[0]], ['match.json', files[1]], ['match.glb', files[2]]]);
  document.body.dataset.seconds = (performance.now() - begin) / 1000;
  document.body.dataset.memory = memory;
}

async function blend() {
  const outputs = ['blend.html', 'blend.json'];
  const {files} = await work('Blending', () => program.run(
      ['blend', pathOf('source'), pathOf('target'), '--match', 'match.json', '--output', outputs[0], '--json', outputs[1],
       '--cache', 'cache', '--progress', 'always', ...readingOptions()], outputs, tell));
  show('blend', files[0], [['blend.html', files[0]], ['blend.json', files[1]], ['blend.glb', saveAnimation]]);
}

async function saveAnimation() {
  const {files} = await work('Writing', () => program.run(
      ['blend', pathOf('source'), pathOf('target'), '--match', 'match.json', '--output', 'blend.glb', '--cache', 'cache',
       '--progress', 'always', ...readingOptions()], ['blend.glb'], tell));
  return files[0];
}

/** Files of models as people know them, without the folders that the program finds them in. */
function named(text) {
  return text.replace(/\b(source|target)\//g, '');
}

function tell({label, unit, done, total}) {
  const [bar, text] = $('#work').children;
  if (done > 0) Object.assign(bar, {max: total, value: done});
  text.textContent = named(`${$('#work').dataset.what}: ${label}, ${unit}${done} of ${total}`);
}

/** Does what the program is needed for, one after the other. */
async function work(what, action) {
  const root = $('#work'), [bar, text] = root.children;
  isWorking = true;
  root.dataset.what = what;
  bar.removeAttribute('value');
  text.textContent = what + '…';
  update();
  try {
    return await action();
  } finally {
    isWorking = false;
    update();
  }
}

/** Does something that may fail; then the page says why. */
async function attempt(action) {
  if (isWorking && isExample && !shown.has('match')) { // what one chooses comes first
    program.cancel();
    await new Promise(done => setTimeout(done));
  }
  if (isWorking) return;
  tellError('');
  try {
    await action();
  } catch (error) {
    if (!(error instanceof Cancelled)) tellError(error.message || String(error));
  }
}

function tellError(text) {
  $('#error').textContent = named(text);
  $('#error').hidden = !text;
}

/** Shows a page that the program wrote. @param saves [[name, bytes or what makes them]] */
function show(name, page, saves = []) {
  shown.set(name, {url: URL.createObjectURL(new Blob([page], {type: 'text/html'})), saves});
  select(name);
  if (saves.length && !isExample && matchMedia('(max-width: 800px)').matches) $('#results').scrollIntoView(); // it is below the buttons
}

function select(name) {
  Object.assign($('#shown'), {src: shown.get(name).url, onload: () => {
    document.body.dataset.shown = name;
    if (isExample && name === 'match') $('#shown').contentWindow.postMessage('turn', '*');
  }});
  $('#shown').dataset.name = name;
  delete document.body.dataset.shown;
  update();
}

function save(name, bytes) {
  const link = element('a', '', document.body);
  Object.assign(link, {href: URL.createObjectURL(new Blob([bytes])), download: name});
  link.click();
  link.remove();
}

/** Brings buttons and tabs in line with what there is. */
function update() {
  const hasBoth = sides.every(side => chosen[side]), current = $('#shown').dataset.name;
  $('#match').disabled = isWorking || !hasBoth;
  $('#blend').disabled = isWorking || !shown.has('match');
  const saved = shown.get('blend') || shown.get('match'), next = !hasBoth ? '' : !shown.has('match') ? 'match' : shown.has('blend') ? 'save' : 'blend';
  for (const name of ['match', 'blend', 'save']) $('#' + name).classList.toggle('next', name === next);
  $('#save').disabled = !saved;
  $('#save').onclick = () => save(...saved.saves[0]);
  $('#next').textContent = isExample ? 'This is an example. Drop two models of yours anywhere on the page.' : hasBoth || isWorking ? '' : sides.some(side => chosen[side]) ? 'Choose the other model, too.' : 'Choose two models first.';
  $('#cancel').hidden = $('#work').hidden = !isWorking;
  for (const control of document.querySelectorAll('section select, section input, section button, #options select'))
    control.disabled = isWorking || (control === options.category && options.method.value !== '');
  $('#shown').hidden = !shown.has(current);
  $('#empty').hidden = shown.has(current);
  $('#tabs').hidden = shown.size < 2;
  $('#tabs').replaceChildren();
  for (const name of Object.keys(titles).filter(title => shown.has(title))) {
    const tab = element('button', titles[name], $('#tabs'));
    tab.role = 'tab';
    tab.ariaSelected = String(name === current);
    tab.onclick = () => select(name);
  }
  const saves = ['match', 'blend'].flatMap(name => shown.has(name) ? shown.get(name).saves : []);
  $('#saves').replaceChildren();
  $('#saves').hidden = !saves.length;
  if (saves.length) element('span', 'Files:', $('#saves'));
  for (const [name, content] of saves) {
    const button = element('button', name, $('#saves'));
    button.disabled = isWorking && typeof content === 'function';
    button.onclick = () => attempt(async () => save(name, typeof content === 'function' ? await content() : content));
  }
  $('#command').textContent = hasBoth ? ['shape_correspondence match', chosen.source.path, chosen.target.path, ...matchOptions(), '--html match.html'].join(' ')
    : 'shape_correspondence match FIRST SECOND --html match.html';
}

$('#match').onclick = () => attempt(match);
$('#blend').onclick = () => attempt(blend);
$('#cancel').onclick = () => program.cancel();
update();
attempt(openExample);
document.body.dataset.ready = Math.round(performance.now()); // milliseconds since the page was opened
