// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_part.h"

#include "blend/mirror_images.h"

#include <algorithm>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

const Eigen::Matrix3Xi& Blend_part::triangles(int surface) const
{
  return morph ? morph->triangles(surface) : mesh.triangles;
}

Points Blend_part::points(int surface, double progress) const
{
  if (!morph) return mesh.points;
  Points result = morph->points(surface, progress);
  return is_reflected ? mirrored(std::move(result)) : result;
}

Carried_point Blend_part::carried(int at_end, const Point& p) const
{
  const Point own = is_reflected ? mirrored(p) : p;
  const Point k = morph->coordinates(at_end, own), offset = own - morph->place(k, at_end);
  return {{k, k}, {offset, offset}};
}

Carried_point Blend_part::carried(const Point& source, const Point& target) const
{
  const Carried_point from = carried(0, source), to = carried(1, target);
  return {{from.coordinates[0], to.coordinates[1]}, {from.offsets[0], to.offsets[1]}};
}

Point Blend_part::place(const Carried_point& p, double progress) const
{
  const auto between = [&](const std::array<Point, 2>& ends) -> Point {
    return (1 - progress) * ends[0] + progress * ends[1];
  };
  const Point result = morph->place(between(p.coordinates), progress) + between(p.offsets);
  return is_reflected ? mirrored(result) : result;
}

void append(Part_mesh& all, const Part_mesh& mesh)
{
  const Eigen::Index points = all.points.cols(), triangles = all.triangles.cols();
  all.points.conservativeResize(3, points + mesh.points.cols());
  all.points.rightCols(mesh.points.cols()) = mesh.points;
  all.triangles.conservativeResize(3, triangles + mesh.triangles.cols());
  all.triangles.rightCols(mesh.triangles.cols()) = mesh.triangles.array() + int(points);
}

void Blend_part::set_ends()
{
  stands = true;
  height = 0;
  for (int surface = 0; surface < number_of_surfaces(); ++surface) {
    const auto change = [&](int number) { return morph->changes()[std::size_t(number)]; };
    const double time = surface == 0                         ? 0
                        : surface + 1 < number_of_surfaces() ? (change(surface - 1) + change(surface)) / 2
                                                             : 1;
    const Points at_rest = points(surface, time);
    trees.push_back(tree_of(at_rest, triangles(surface)));
    rests.emplace_back(at_rest, triangles(surface));
  }
  for (int at_end : {0, 1}) {
    if (!is_at(at_end)) continue;
    const Points points = end_points(at_end);
    size = std::max(size, trees[std::size_t(end_surface(at_end))].box().diagonal().norm());
    height += points.row(1).mean() / (morph ? 2 : 1);
    foot[std::size_t(at_end)] = points.row(1).minCoeff();
    stands = stands && foot[std::size_t(at_end)] <= on_ground;
  }
  if (!morph) foot[std::size_t(1 - end())] = foot[std::size_t(end())];
}

std::vector<std::size_t> parts_of(const std::vector<Blend_part>& parts, int end, std::size_t given)
{
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Blend_task& task = parts[i].task;
    const std::vector<std::size_t>& others = end == 0 ? task.other_sources : task.other_targets;
    if ((end == 0 ? task.source : task.target) == given ||
        std::find(others.begin(), others.end(), given) != others.end())
      result.push_back(i);
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
