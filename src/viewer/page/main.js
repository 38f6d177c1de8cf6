// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {showCollection} from './collection_page.js';
import {$} from './dom.js';
import {showGraph} from './graph_page.js';
import {showMatch} from './match_page.js';
import {showParts} from './parts_page.js';

// Shows the documents that the page has.

const pages = {match: showMatch, graph: showGraph, collection: showCollection, parts: showParts};

pages[Object.keys(pages).find(id => document.getElementById(id))]();
document.addEventListener('pointerdown', event => { if (!event.target.closest('#show')) $('#show').open = false; });
if (!$('#tools').children.length) $('#show').hidden = true;
addEventListener('message', ({data}) => { if (data === 'turn') $('#stage').stage.turnSlowly(); }); // from a page around this one
requestAnimationFrame(() => requestAnimationFrame(() => { // drawn by now
  document.body.dataset.ready = Math.round(performance.now()); // milliseconds since the page was opened
}));
