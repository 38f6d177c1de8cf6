// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is chosen: while the pointer is over it, or from a click or a tap until the next one. It is given by a key; null:
// nothing.

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
  /** Chooses a key by a click; releases it if it is chosen already. */
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
