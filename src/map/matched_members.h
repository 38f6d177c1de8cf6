// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Charted_shape.h"

#include <CGAL/Shape_correspondence/Part_correspondence.h>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Parts of both shapes that are connected by pairs.
struct Connected_parts
{
  std::vector<std::size_t> source, target;
};

/// \param sources, targets numbers of parts
std::vector<Connected_parts> connected_parts(const Part_pairs& pairs, std::size_t sources, std::size_t targets);

/// The pairs of parts that are mapped to each other. If one part corresponds to several, these are the given pairs. If
/// several parts correspond to several, where a method may have paired every part with every other, they are matched by
/// the positions of their surfaces.
Part_pairs matched_members(const Charted_shape& source, const Charted_shape& target, const Part_pairs& pairs);

} // namespace CGAL::Shape_correspondence::internal
