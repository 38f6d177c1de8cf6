// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/Sample_lanes.h"

#include <vector>

namespace CGAL::Shape_correspondence::internal {

// What rods have in common.
struct Rod_rows
{
  int directionless = 0;
  float shortest_squared, longest_squared; // of their lengths
};

// Writes the directions of rods in rows, a block after the other: from the samples `first` to `last` of `from`, in its
// own order, to the first `count` samples of `to`.
using Rod_writer = Rod_rows (*)(const Sample_lanes& from, int first, int last, const Sample_lanes& to, int count,
                                Rod_block* rods);

// Those that this machine can run, the fastest one last. All write the same bits.
std::vector<Rod_writer> available_rod_writers();

} // namespace CGAL::Shape_correspondence::internal
