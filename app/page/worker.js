// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs the program, whose files are in memory, in a thread of its own. A message is {program}, the module packed as text,
// {folder, files}, which makes a folder anew, or {arguments, outputs}, which is answered by {status, errors, files, memory}
// and before by any number of {label, unit, done, total}.

const maximumOfErrors = 100000; // characters that are kept

/** Texts of a stream of bytes; a progress bar is written over and over, each time behind `\r`. */
class Stream {
  constructor(report) {
    this.report = report;
    this.clear();
  }
  clear() {
    this.bytes = [];
    this.text = '';
  }
  put(byte) {
    if (byte === 13 || byte === 10) this.flush();
    if (byte !== 13) this.bytes.push(byte);
  }
  flush() {
    const line = new TextDecoder().decode(new Uint8Array(this.bytes)), bar = /^\x1b\[K(?:\[[#.]*\] (.*): (.* )?(\d+) of (\d+).*)?$/.exec(line);
    this.bytes = [];
    if (!bar) this.text = (this.text + line).slice(-maximumOfErrors);
    else if (bar[1]) this.report({label: bar[1], unit: bar[2] || '', done: Number(bar[3]), total: Number(bar[4])});
  }
}

const errors = new Stream(message => postMessage(message));
let starting = null;

async function start(packed) {
  const wasmBinary = await unpacked(packed), program = await shapeCorrespondence({wasmBinary, stdin: () => null, stdout: () => {}, stderr: byte => errors.put(byte)});
  program.FS.mkdir('/work');
  program.FS.chdir('/work');
  return program;
}

function removeTree(fs, path) {
  if (!fs.analyzePath(path).exists) return;
  if (!fs.isDir(fs.stat(path).mode)) return fs.unlink(path);
  for (const name of fs.readdir(path)) if (name !== '.' && name !== '..') removeTree(fs, `${path}/${name}`);
  fs.rmdir(path);
}

function put(fs, path, bytes) {
  path.split('/').slice(0, -1).reduce((folder, name) => {
    if (!fs.analyzePath(folder + name).exists) fs.mkdir(folder + name);
    return folder + name + '/';
  }, '');
  fs.writeFile(path, bytes);
}

function run(program, {arguments: given, outputs}) {
  errors.clear();
  for (const path of outputs) removeTree(program.FS, path);
  const status = program.callMain(given);
  errors.flush();
  const files = status === 0 ? outputs.map(path => program.FS.readFile(path)) : [];
  postMessage({status, errors: errors.text, files, memory: program.HEAPU8.length}, files.map(file => file.buffer));
}

onmessage = async ({data}) => {
  try {
    if (data.program) starting = start(data.program);
    const program = await starting;
    if (data.folder) {
      removeTree(program.FS, data.folder);
      for (const [path, bytes] of data.files) put(program.FS, `${data.folder}/${path}`, bytes);
    }
    if (data.arguments) run(program, data);
  } catch (error) {
    postMessage({failure: String(error)});
  }
};
