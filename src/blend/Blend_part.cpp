// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_part.h"

#include "blend/mirror_images.h"

#include <algorithm>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

const Eigen::Matrix3Xi& Blend_part::triangles(int surface) const
{
  return morph ? morph->triangles(surface) : unmatched->triangles();
}

Points Blend_part::points(int surface, double t, double remaining) const
{
  Points result = morph->points(surface, t, remaining);
  return is_reflected ? mirrored(std::move(result)) : std::move(result);
}

Points Blend_part::remaining_points(double remaining) const
{
  Points result = unmatched->points(remaining);
  return is_reflected ? mirrored(std::move(result)) : std::move(result);
}

Point Blend_part::remaining_place(const Point& p, double remaining) const
{
  return is_reflected ? mirrored(unmatched->place(mirrored(p), remaining)) : unmatched->place(p, remaining);
}

Points Blend_part::end_points(int end) const { return morph ? points(end, end) : remaining_points(1); }

void Blend_part::add_trees()
{
  for (int at_end : {0, 1}) {
    if (unmatched && end() != at_end) continue;
    const int surface = end_surface(at_end);
    std::optional<Tree>& tree = trees[std::size_t(surface)];
    tree = tree_of(end_points(at_end), triangles(surface));
    rests[std::size_t(surface)].emplace(end_points(at_end), triangles(surface));
    size = std::max(size, tree->box().diagonal().norm());
  }
}

std::vector<std::size_t> parts_of(const std::vector<Blend_part>& parts, int end, std::size_t given)
{
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if ((end == 0 ? parts[i].task.source : parts[i].task.target) == given) result.push_back(i);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
