// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

import {element, setBreakable} from './dom.js';

// A table whose rows choose things, can be searched, and may fold the parts that they are about.

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

/** The rows of the parts of a row, hidden, and the button that shows them. */
function addParts(row, mark, columns, tr, selection) {
  const button = element('button', '▸', mark), rows = [];
  const lists = columns.map((_, k) => row.parts[k] || []);
  for (let i = 0; i < Math.max(...lists.map(list => list.length)); ++i) {
    const line = document.createElement('tr');
    line.className = 'part';
    line.hidden = true;
    element('td', '', line);
    columns.forEach((column, k) => {
      const cell = element('td', '', line), part = lists[k][i];
      cell.className = column.kind || '';
      if (!part) return;
      setBreakable(part.name, cell);
      choosing(cell, part.key, selection);
    });
    rows.push(line);
  }
  tr.after(...rows);
  const show = isShown => {
    rows.forEach(line => { line.hidden = !isShown; });
    button.textContent = isShown ? '▾' : '▸';
    button.ariaExpanded = isShown;
    button.ariaLabel = isShown ? 'hide the parts' : 'show the parts';
  };
  button.onclick = event => { event.stopPropagation(); show(rows[0].hidden); };
  show(false);
  return show;
}

/**
 * @param columns [{text, kind}]; the kind may be `narrow`, or `narrow minor`: not shown in narrow windows
 * @param rows [{key, colour (of a style sheet), cells, parts, words}]; a row is chosen by its key. `parts` may be missing;
 * else for each column whose cell stands for several parts {name, key} of each. `words` are searched, too
 * @param search the input element whose text rows must contain, or null
 * @returns {light(keys), paint(colours), hide(keys)}: marks the rows of keys, a set or null; sets the colours of rows, a
 * map by key; hides the rows of keys, a set
 */
export function fillTable(table, columns, rows, selection, search) {
  table.replaceChildren();
  const head = element('tr', '', element('thead', '', table)), body = element('tbody', '', table);
  element('th', '', head).className = 'mark';
  for (const column of columns) {
    const cell = element('th', '', head);
    cell.className = column.kind || '';
    setBreakable(column.text, cell);
  }
  const made = rows.map(row => {
    const tr = element('tr', '', body), mark = element('td', '', tr), swatch = element('i', '', mark);
    swatch.style.background = row.colour;
    row.cells.forEach((text, k) => {
      const cell = element('td', '', tr);
      cell.className = columns[k].kind || '';
      setBreakable(text, cell);
    });
    choosing(tr, row.key, selection);
    const fold = row.parts ? addParts(row, mark, columns, tr, selection) : () => {};
    return {tr, swatch, fold, key: row.key, text: row.cells.concat(row.words || []).join('\n').toLowerCase()};
  });
  let unsure = new Set(), words = [];
  const showRows = () => {
    for (const row of made) {
      row.tr.hidden = unsure.has(row.key) || !words.every(word => row.text.includes(word));
      if (row.tr.hidden) row.fold(false);
    }
    return made.filter(row => !row.tr.hidden);
  };
  if (search) {
    search.value = '';
    search.oninput = () => {
      words = search.value.toLowerCase().split(/\s+/).filter(word => word);
      const left = showRows();
      selection.hover(words.length && left.length === 1 ? left[0].key : null);
    };
  }
  return {
    light(keys) {
      for (const row of made) {
        const isLit = keys !== null && keys.has(row.key);
        row.tr.classList.toggle('lit', isLit);
        row.tr.setAttribute('aria-selected', isLit);
      }
    },
    paint(colours) { for (const row of made) row.swatch.style.background = colours.get(row.key); },
    hide(keys) { unsure = keys; showRows(); },
  };
}
