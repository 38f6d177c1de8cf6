// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/Sample_lanes.h"

namespace CGAL::Shape_correspondence::internal {

// What rods have in common.
struct Rod_rows
{
  int directionless = 0;
  float longest_squared = 0;
};

// Writes the directions of rods in rows, a block after the other: from the samples `first` to `last` of `from`, of
// which each `repeats` in a row are the same, to the first `count` samples of `to`. The same bits on every machine.
Rod_rows write_rod_directions(const Sample_lanes& from, int first, int last, int repeats, const Sample_lanes& to,
                              int count, Rod_block* rods);

} // namespace CGAL::Shape_correspondence::internal
