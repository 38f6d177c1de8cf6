// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is chosen: by hovering for as long as one hovers, by a click or a tap until the next one. A key names what is
// chosen; null: nothing.

export class Selection {
  /** @param change is called with the key that is chosen now */
  constructor(change) {
    this.pinned = this.hovered = null;
    this.change = change;
  }
  get key() { return this.hovered !== null ? this.hovered : this.pinned; }
  hover(key) {
    if (key === this.hovered) return;
    this.hovered = key;
    this.change(this.key);
  }
  /** The same again lets it go. */
  pin(key) {
    this.pinned = key === this.pinned ? null : key;
    this.hovered = null;
    this.change(this.key);
  }
  clear() {
    this.pinned = this.hovered = null;
    this.change(null);
  }
}
