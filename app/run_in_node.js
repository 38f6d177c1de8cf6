#!/usr/bin/env node
// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// The program as the page runs it, but from a shell and on the files of this machine:
// run_in_node.js build-wasm/app/shape_correspondence_browser.js COMMAND [options] INPUTS...

const fs = require('fs'), path = require('path');
const [file, ...given] = process.argv.slice(2);
const ofTheModule = new Set(['dev', 'proc', 'sys']);

const wasmBinary = fs.readFileSync(file.replace(/js$/, 'wasm'));

require(path.resolve(file))({wasmBinary}).then(program => {
  const {FS} = program;
  for (const name of fs.readdirSync('/')) {
    const folder = '/' + name;
    if (ofTheModule.has(name) || !fs.statSync(folder).isDirectory()) continue;
    if (!FS.analyzePath(folder).exists) FS.mkdir(folder);
    FS.mount(FS.filesystems.NODEFS, {root: folder}, folder);
  }
  FS.chdir(process.cwd());
  process.exitCode = program.callMain(given);
});
