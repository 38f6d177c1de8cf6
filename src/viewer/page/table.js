// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {element, setBreakable} from './dom.js';

// A table whose rows choose things, can be searched, and may fold further rows.

/** Lets a row, or a cell, choose a key: by pointing, by a click, by Enter and Space. */
function choosing(box, key, selection) {
  box.tabIndex = 0;
  box.onmouseenter = () => selection.hover(key);
  box.onmouseleave = () => selection.hover(null);
  box.onclick = event => { event.stopPropagation(); selection.pin(key); };
  box.onkeydown = event => {
    if (event.target !== box || (event.key !== 'Enter' && event.key !== ' ')) return;
    event.preventDefault(); // else the page scrolls
    selection.pin(key);
  };
}

/** A cell: a text, or {text, title, span, key, small}, where `small` is a second line. */
function addCell(tr, cell, column, selection) {
  const {text, title, span, key, small} = typeof cell === 'string' ? {text: cell} : cell, td = element('td', '', tr);
  td.className = (column && column.kind) || '';
  setBreakable(text, td);
  if (title) td.title = title;
  if (span) td.colSpan = span;
  if (small) element('small', small, td);
  if (key !== undefined) choosing(td, key, selection);
}

/**
 * Fills a table.
 * @param columns [{text, kind, span}]; the kind may be `narrow`
 * @param rows [{key, colour (of a style sheet, or none), cells, rows, words}]; a row is chosen by its key, if it has one, and
 * folds its `rows`, if it has any. `words` are searched, too
 * @param search the input element whose text rows must contain, or null
 * @returns {light(keys), paint(colours, unsure, partly), hide(keys)}: functions that mark the rows of a set of keys, or none for
 * null; that colour rows by a map of keys, hatch those of a set, and of another set in part; that hide the rows of a set of keys
 */
export function fillTable(table, columns, rows, selection, search) {
  table.replaceChildren();
  const spread = columns.flatMap(column => Array(column.span || 1).fill(column)), head = element('tr', '', element('thead', '', table)), body = element('tbody', '', table), made = [];
  element('th', '', head).className = 'mark';
  for (const column of columns) {
    const cell = element('th', '', head);
    cell.className = column.kind || '';
    if (column.span) cell.colSpan = column.span;
    setBreakable(column.text, cell);
  }
  /** @returns the keys in a row and all below it */
  function add(row, depth, parent) {
    const tr = element('tr', '', body), mark = element('td', '', tr), swatch = row.colour ? element('i', '', mark) : null;
    if (swatch) swatch.style.backgroundColor = row.colour;
    tr.className = depth ? 'part' : '';
    tr.style.setProperty('--depth', depth);
    let column = 0;
    for (const cell of row.cells) {
      addCell(tr, cell, spread[column], selection);
      column += cell.span || 1;
    }
    if (row.key !== undefined) choosing(tr, row.key, selection);
    const item = {tr, swatch, parent, key: row.key, isOpen: false, button: null, keys: new Set(row.key === undefined ? [] : [row.key])};
    item.text = row.cells.map(cell => cell.text || cell).concat(row.words || []).join('\n').toLowerCase();
    for (const cell of row.cells) if (cell.key !== undefined) item.keys.add(cell.key);
    made.push(item);
    if (!row.rows || !row.rows.length) return item;
    item.button = element('button', '', mark);
    item.button.onclick = event => { event.stopPropagation(); item.isOpen = !item.isOpen; showRows(); };
    for (const below of row.rows.map(inner => add(inner, depth + 1, item))) {
      for (const key of below.keys) item.keys.add(key);
      item.text += '\n' + below.text;
    }
    return item;
  }
  let hidden = new Set(), words = [];
  const showRows = () => {
    for (const row of made) {
      const isSought = !row.parent || words.every(word => row.parent.text.includes(word));
      const isHidden = hidden.has(row.key);
      row.tr.hidden = isHidden || (row.parent ? row.parent.tr.hidden || !row.parent.isOpen || !isSought : !words.every(word => row.text.includes(word)));
      if (!row.button) continue;
      row.button.textContent = row.isOpen ? '▾' : '▸';
      row.button.ariaExpanded = row.isOpen;
      row.button.ariaLabel = row.isOpen ? 'hide the parts' : 'show the parts';
    }
    return made.filter(row => !row.tr.hidden && !row.parent);
  };
  for (const row of rows) add(row, 0, null);
  showRows();
  if (search) {
    search.value = '';
    search.oninput = () => {
      words = search.value.toLowerCase().split(/\s+/).filter(word => word);
      let left = showRows();
      const inner = made.filter(row => row.key !== undefined && row.parent === left[0] && words.every(word => row.text.includes(word)));
      if (left.length === 1 && inner.length === 1) left = inner;
      selection.hover(words.length && left.length === 1 ? left[0].key : null);
    };
  }
  return {
    light(keys) {
      for (const row of made) {
        const isLit = keys !== null && [...row.keys].some(key => keys.has(key));
        row.tr.classList.toggle('lit', isLit);
        row.tr.setAttribute('aria-selected', isLit);
      }
    },
    paint(colours, unsure = new Set(), partly = new Set()) {
      for (const row of made) {
        if (!row.swatch || !colours.has(row.key)) continue;
        row.swatch.style.backgroundColor = colours.get(row.key);
        row.swatch.classList.toggle('unsure', unsure.has(row.key));
        row.swatch.classList.toggle('partly', partly.has(row.key));
      }
    },
    hide(keys) { hidden = keys; showRows(); },
  };
}
