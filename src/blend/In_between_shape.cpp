// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/In_between_shape.h"

#include <algorithm>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// How much of a task is done, from 0 to 1; some are done in an instant.
double share_done(const Blend_task& task, double time)
{
  return time >= task.end ? 1 : std::max(0., (time - task.begin) / (task.end - task.begin));
}

} // namespace

In_between_shape::In_between_shape(const Blend_structure& blend, const std::vector<Blend_task>& tasks, double t)
    : blend(blend), time(t), surfaces(blend.parts.size(), -1), points(blend.parts.size())
{
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Blend_part& part = blend.parts[i];
    if (!part.is_matched()) continue;
    surfaces[i] = part.morph->surface(t);
    points[i] = part.points(surfaces[i], t);
  }
  place_unmatched(tasks);
  fill_the_height();
}

Points In_between_shape::points_of(std::size_t part, int surface) const
{
  if (surface == surfaces[part] || !blend.parts[part].is_matched()) return points[part];
  Points result = blend.parts[part].points(surface, time);
  stretch(result);
  return result;
}

std::vector<Seen_surface> In_between_shape::seen() const
{
  std::vector<Seen_surface> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (is_there(i)) result.emplace_back(blend.parts, i, surfaces[i], points[i]);
  return result;
}

Blend_quality In_between_shape::quality() const
{
  constexpr double touching = 0.005; // tolerance for gaps wider than at the ends, over the height
  const std::vector<Seen_surface> surfaces = seen();
  const double due = (1 - time) * blend.supports[0] + time * blend.supports[1];
  Blend_quality result;
  if (due > 0) result.support = std::max(0., 1 - number_of_supports(surfaces) / due);
  Tree_pointers trees;
  for (const Seen_surface& surface : surfaces)
    trees.push_back(&surface.tree);
  const auto& [source, target] = blend.stage.widest_gap;
  const double at_ends = std::max(source, target), widest = widest_gap(trees, at_ends + touching);
  if (widest > at_ends + touching) result.apart = widest - at_ends;
  return result;
}

/// The points of an unmatched part as far as it has grown, at its place in the shape of its end.
Points In_between_shape::grown(std::size_t part, const std::vector<Blend_task>& tasks)
{
  constexpr double least_remaining = 1e-6; // share below which a part counts as gone, since its surface has no area
  const int end = blend.parts[part].end();
  // Without tasks, old parts have not begun to shrink, and new ones have finished growing
  const double done = tasks.empty() ? end : share_done(tasks[part], time), share = end == 0 ? 1 - done : done;
  if (share > least_remaining) surfaces[part] = 0;
  return blend.growths[part]->points(share);
}

/// Places unmatched parts by the warps of space.
void In_between_shape::place_unmatched(const std::vector<Blend_task>& tasks)
{
  for (int end : {0, 1}) {
    const auto& warp = blend.warps[std::size_t(end)];
    if (!warp) continue;
    std::vector<Points> at_end = points; // the surfaces of this end at this time
    for (std::size_t i = 0; i < at_end.size(); ++i)
      if (blend.parts[i].is_matched() && surfaces[i] != end) at_end[i] = blend.parts[i].points(end, time);
    const Points ways = warp->ways(blend.parts, at_end, time); // displacements of the warp's nodes
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!blend.parts[i].is_matched() && blend.parts[i].end() == end)
        points[i] = blend.motions[i]->moved(grown(i, tasks), *warp, ways);
  }
}

/// Stretches the shape vertically so that it stands on the ground and has the interpolated height.
void In_between_shape::fill_the_height()
{
  constexpr double most = 2;     // largest factor; more would be needed only while both old and new parts are half gone
  constexpr double least = 1e-6; // height below which the shape is not stretched
  contacts::Box all;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (is_there(i)) all.extend(box_of(points[i]));
  if (all.isEmpty()) return;
  const double height = all.sizes().y(), due = std::min(due_height(), most * height);
  if (height > least) scale_ = due / height;
  shift_ = due / 2 - scale_ * all.center().y();
  for (Points& surface : points)
    stretch(surface);
}

} // namespace CGAL::Shape_correspondence::internal
