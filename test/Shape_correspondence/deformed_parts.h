// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SHAPE_CORRESPONDENCE_TEST_DEFORMED_PARTS_H
#define SHAPE_CORRESPONDENCE_TEST_DEFORMED_PARTS_H

#include "energy/Structural_rods.h"

#include <CGAL/Shape_correspondence/Part_abstraction.h>

#include <cstddef>
#include <vector>

namespace hand_made {

using namespace CGAL::Shape_correspondence;

inline Sampled_part sampled(const Part_abstraction& part)
{
  Sampled_part result;
  result.kind = part.is_sheet()          ? Sampled_part::Kind::SHEET
                : part.is_closed_curve() ? Sampled_part::Kind::CLOSED_CURVE
                                         : Sampled_part::Kind::CURVE;
  result.samples = sample(part, samples_per_side);
  result.centroid = result.samples.rowwise().mean();
  return result;
}

} // namespace hand_made

#endif // SHAPE_CORRESPONDENCE_TEST_DEFORMED_PARTS_H
