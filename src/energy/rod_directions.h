// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/Sample_lanes.h"

namespace CGAL::Shape_correspondence::internal {

// What the rods from one sample to others have in common.
struct Rod_row
{
  int directionless = 0;
  float longest_squared = 0;
};

// Writes the directions of the rods from a sample of `from` to the first `count` samples of `to`, a block after the
// other. The same bits on every machine.
Rod_row write_rod_directions(const Sample_lanes& from, int sample, const Sample_lanes& to, int count, Rod_block* rods);

} // namespace CGAL::Shape_correspondence::internal
