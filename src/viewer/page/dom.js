// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Elements of the page. Text from files is only ever set as text.

export const $ = selector => document.querySelector(selector);

/** Appends an element. */
export function element(tag, text, parent) {
  const result = document.createElement(tag);
  if (text) result.textContent = text;
  parent.append(result);
  return result;
}

/** Sets the text of an element; it may be broken after the signs that names are made of. */
export function setBreakable(text, parent) {
  parent.replaceChildren();
  text.split(/(?<=[_./#-])/).forEach((piece, k) => parent.append(...(k ? [document.createElement('wbr')] : []), piece));
}

/** The JSON document with an id in the page, parsed; null if there is none. */
export function documentOf(id) {
  const script = document.getElementById(id);
  return script ? JSON.parse(script.textContent) : null;
}

/** A check box with a label. @param hint is shown beside the pointer @param change is called with whether it is set */
export function addSwitch(parent, text, hint, isSet, change) {
  const label = element('label', '', parent), box = element('input', '', label);
  box.type = 'checkbox';
  box.checked = isSet;
  label.append(' ' + text);
  label.title = hint;
  box.onchange = () => change(box.checked);
  return box;
}

/** Tabs of narrow windows, the first one open. @param tabs [[name, text]] @returns a function that opens a tab by its name */
export function addTabs(tabs) {
  const buttons = tabs.map(([name, text]) => {
    const button = element('button', text, $('#tabs'));
    button.role = 'tab';
    button.onclick = () => open(name);
    return button;
  });
  const open = chosen => {
    document.body.dataset.tab = chosen;
    tabs.forEach(([name], i) => { buttons[i].ariaSelected = String(name === chosen); });
  };
  open(tabs[0][0]);
  return open;
}

/** Notes in a folded list, since there may be many. @param what end of the heading: what the notes are about */
export function addWarnings(parent, warnings = [], what = '') {
  warnings = [...new Set(warnings)].filter(Boolean);
  if (!warnings.length) return;
  const details = element('details', '', parent);
  element('summary', (warnings.length === 1 ? '1 note' : `${warnings.length} notes`) + what, details);
  for (const warning of warnings) element('p', warning, details);
}

/** The linear light of a colour #rrggbb. */
export function linearColour(text) {
  return [1, 3, 5].map(k => parseInt(text.slice(k, k + 2), 16) / 255).map(c => c <= 0.04045 ? c / 12.92 : Math.pow((c + 0.055) / 1.055, 2.4));
}

/** A colour in linear light, in the notation of style sheets. */
export function cssColour(colour) {
  return 'rgb(' + colour.slice(0, 3).map(c => {
    const value = Math.max(0, Math.min(1, c));
    return Math.round(255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * Math.pow(value, 1 / 2.4) - 0.055));
  }).join(', ') + ')';
}

/** The note beside the pointer: a title, and lines. */
export const tip = {
  show(x, y, title, lines) {
    const box = $('#tip');
    box.replaceChildren();
    setBreakable(title, element('b', '', box));
    for (const line of lines) setBreakable(line, element('div', '', box));
    box.style.display = 'block';
    box.style.left = Math.max(4, Math.min(x + 14, innerWidth - box.offsetWidth - 4)) + 'px';
    box.style.top = Math.max(4, Math.min(y + 14, innerHeight - box.offsetHeight - 4)) + 'px';
  },
  hide() { $('#tip').style.display = 'none'; },
};
