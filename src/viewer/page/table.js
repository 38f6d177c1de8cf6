// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {element} from './dom.js';

// A table whose rows choose things and can be searched.

/** Text that may be broken after the signs that names are made of. */
function addBreakable(text, cell) {
  text.split(/(?<=[_./-])/).forEach((piece, k) => cell.append(...(k ? [document.createElement('wbr')] : []), piece));
}

/**
 * @param heading [{text, kind}] of the columns; the kind may be `narrow`, or `narrow minor`: not shown on a phone
 * @param rows [{key, colour (of a style sheet), cells}]; a row is chosen by its key
 * @param search the input element whose text rows must contain, or null
 * @returns {light(keys)} marks the rows of keys, a set or null
 */
export function fillTable(table, heading, rows, selection, search) {
  table.replaceChildren();
  const head = element('tr', '', element('thead', '', table)), body = element('tbody', '', table);
  const addCell = (tag, text, row, column) => {
    const cell = element(tag, '', row);
    cell.className = heading[column].kind || '';
    addBreakable(text, cell);
  };
  element('th', '', head);
  heading.forEach((column, k) => addCell('th', column.text, head, k));
  const made = rows.map(row => {
    const tr = element('tr', '', body);
    element('i', '', element('td', '', tr)).style.background = row.colour;
    row.cells.forEach((cell, k) => addCell('td', cell, tr, k));
    tr.tabIndex = 0;
    tr.onmouseenter = () => selection.hover(row.key);
    tr.onmouseleave = () => selection.hover(null);
    tr.onclick = () => selection.pin(row.key);
    tr.onkeydown = event => { if (event.key === 'Enter') selection.pin(row.key); };
    return {tr, key: row.key, text: row.cells.join('\n').toLowerCase()};
  });
  if (search) {
    search.value = '';
    search.oninput = () => {
      const words = search.value.toLowerCase().split(/\s+/).filter(word => word);
      for (const row of made) row.tr.hidden = !words.every(word => row.text.includes(word));
      const left = made.filter(row => !row.tr.hidden);
      selection.hover(words.length && left.length === 1 ? left[0].key : null);
    };
  }
  return {
    light(keys) {
      for (const row of made) row.tr.classList.toggle('lit', keys !== null && keys.has(row.key));
    },
  };
}
