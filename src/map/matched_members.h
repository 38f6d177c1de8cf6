// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Charted_shape.h"

#include <CGAL/Shape_correspondence/Part_correspondence.h>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Parts of both shapes that pairs connect.
struct Connected_parts
{
  std::vector<std::size_t> source, target;
};

/// \param sources,targets the numbers of parts
std::vector<Connected_parts> connected_parts(const Part_pairs& pairs, std::size_t sources, std::size_t targets);

/// Which part becomes which. Where one part corresponds to several, it becomes all of them, or all of them become it,
/// as the pairs say. Of sets of several parts on either side, a method may have paired every part with every other:
/// their members are matched by their places, which are those of the surfaces at hand.
Part_pairs matched_members(const Charted_shape& source, const Charted_shape& target, const Part_pairs& pairs);

} // namespace CGAL::Shape_correspondence::internal
