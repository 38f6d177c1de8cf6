// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_part.h"

#include "blend/Blend_stage.h"
#include "blend/mirror_images.h"

#include <algorithm>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

const Eigen::Matrix3Xi& Blend_part::triangles(int surface) const
{
  return morph ? morph->triangles(surface) : thinning->triangles();
}

Points Blend_part::points(int surface, double progress, double remaining) const
{
  Points result = morph ? morph->points(surface, progress, remaining) : thinning->points(remaining);
  return is_reflected ? mirrored(std::move(result)) : std::move(result);
}

Carried_point Blend_part::carried(int at_end, const Point& p) const
{
  const Point own = is_reflected ? mirrored(p) : p;
  if (!morph) return {{own, own}, {Point::Zero(), Point::Zero()}};
  const Point k = morph->coordinates(at_end, own), offset = own - morph->place(k, at_end);
  return {{k, k}, {offset, offset}};
}

Carried_point Blend_part::carried(const Point& source, const Point& target) const
{
  const Carried_point from = carried(0, source), to = carried(1, target);
  return {{from.coordinates[0], to.coordinates[1]}, {from.offsets[0], to.offsets[1]}};
}

Point Blend_part::place(const Carried_point& p, double progress, double remaining) const
{
  const auto between = [&](const std::array<Point, 2>& ends) -> Point {
    return (1 - progress) * ends[0] + progress * ends[1];
  };
  const Point result = morph ? Point(morph->place(between(p.coordinates), progress) + between(p.offsets))
                             : thinning->place(p.coordinates[0], remaining);
  return is_reflected ? mirrored(result) : result;
}

void Blend_part::set_ends()
{
  stands = true;
  height = 0;
  for (int at_end : {0, 1}) {
    if (!is_at(at_end)) continue;
    const auto surface = std::size_t(end_surface(at_end));
    const Points points = end_points(at_end);
    trees[surface] = tree_of(points, triangles(int(surface)));
    rests[surface].emplace(points, triangles(int(surface)));
    size = std::max(size, trees[surface]->box().diagonal().norm());
    height += points.row(1).mean() / (morph ? 2 : 1);
    foot[std::size_t(at_end)] = points.row(1).minCoeff();
    stands = stands && foot[std::size_t(at_end)] <= on_ground;
  }
  if (!morph) foot[std::size_t(1 - end())] = foot[std::size_t(end())];
}

std::vector<std::size_t> parts_of(const std::vector<Blend_part>& parts, int end, std::size_t given)
{
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if ((end == 0 ? parts[i].task.source : parts[i].task.target) == given) result.push_back(i);
  return result;
}

void add_unmatched_parts(const Blend_stage& stage, const std::vector<Exchange_set>& sets,
                         std::vector<Blend_part>& parts)
{
  for (int end : {0, 1}) {
    const auto e = std::size_t(end);
    const Shape_structure& shape = structure(stage.graphs[e]);
    for (std::size_t part = 0; part < shape.parts.size(); ++part) {
      if (!parts_of(parts, end, part).empty()) continue;
      Blend_part result;
      const std::string& name = shape.parts[part].name;
      result.name = end == 0 ? name + '~' : '~' + name;
      result.task.type = end == 0 ? Blend_task_type::SHRINK : Blend_task_type::GROW;
      (end == 0 ? result.task.source : result.task.target) = part;
      std::size_t charted = part;
      if (const std::size_t image = stage.images[e][part]; image == part) {
        result.image = parts.size();
      } else if (image != Mirror_images::none) {
        const std::vector<std::size_t> made = parts_of(parts, end, image);
        if (!made.empty() && parts[made[0]].thinning) {
          result.image = made[0];
          parts[result.image].image = parts.size();
          result.is_reflected = true;
          charted = image;
        }
      }
      result.ridden = stage.boxes;
      const auto set = std::find_if(sets.begin(), sets.end(), [&](const Exchange_set& other) {
        return std::binary_search(other.parts[e].begin(), other.parts[e].end(), part);
      });
      if (set != sets.end()) {
        result.ridden = set->boxes;
        result.task.exchange = set->reason;
      }
      Part_mesh mesh = stage.meshes[e][part];
      if (result.is_reflected) mesh.points = mirrored(std::move(mesh.points));
      result.thinning = std::make_shared<Thinning_part>(shape.parts[charted],
                                                        stage.to_stage(end, shape.parts[charted].control_points()),
                                                        stage.charted[e].charts[charted], mesh);
      result.set_ends();
      parts.push_back(std::move(result));
    }
  }
}

} // namespace CGAL::Shape_correspondence::internal
