// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/participants.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

Matching_problem::Shared_shape participating(Matching_problem::Shared_shape shape,
                                             const std::vector<std::size_t>& chosen)
{
  if (chosen.empty()) return shape;
  std::vector<char> is_kept(shape->parts.size(), 0);
  for (std::size_t part : chosen) {
    const auto found = std::find(shape->original.begin(), shape->original.end(), part);
    if (found == shape->original.end())
      throw Invalid_input("find_correspondence: there is no part number " + std::to_string(part) +
                          " to choose, the shape has " + std::to_string(shape->parts.size()) + " parts");
    is_kept[std::size_t(found - shape->original.begin())] = 1;
  }
  return std::make_shared<Deformable_shape>(restricted(*shape, is_kept));
}

std::vector<std::size_t> participants(const Matching_problem::Shared_shape& shape,
                                      const std::vector<std::size_t>& chosen, int maximum_parts)
{
  if (maximum_parts == 0) return chosen;
  const Matching_problem::Shared_shape all = participating(shape, chosen);
  return restricted(*all, most_prominent_parts(*all, std::size_t(maximum_parts))).original;
}

Matching_problem::Shared_shape regrouped(const Matching_problem::Shared_shape& shape,
                                         const std::vector<std::vector<std::size_t>>& sets)
{
  return sets.empty() ? shape : std::make_shared<Deformable_shape>(shape->regrouped(sets));
}

} // namespace CGAL::Shape_correspondence::internal
