// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/schedules.h"
#include "base/for_each_index.h"
#include "blend/Blend_part.h"
#include "blend/Blend_structure.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// How much of a task is done, from 0 to 1; some are done in an instant.
double share_done(const Blend_task& task, double time)
{
  return time >= task.end ? 1 : std::max(0., (time - task.begin) / (task.end - task.begin));
}

/// Rates a schedule by its in-between shapes: the worst value of each measure.
Blend_quality quality_of(const Blend_structure& blend, const std::vector<Blend_task>& tasks, int samples)
{
  std::vector<Blend_quality> qualities(static_cast<std::size_t>(samples));
  for_each_index<CGAL::Parallel_if_available_tag>(qualities.size(), [&](std::size_t i) {
    qualities[i] = In_between_shape(blend, tasks, double(i + 1) / (samples + 1)).quality();
  });
  Blend_quality worst;
  for (const auto& [support, apart] : qualities)
    worst = {std::max(worst.support, support), std::max(worst.apart, apart)};
  return worst;
}

/// The tasks with their times. Exchanged parts change about half-way or, in two steps, before and after that, one place
/// after the other: new parts replace old ones in an instant, since half-grown ones leave the shape broken. Unmatched
/// parts that are not exchanged vanish before the first step, parts before those that carry them, or grow after the
/// second step, in the inverse order.
std::vector<Blend_task> timed_tasks(const Blend_structure& blend, const std::vector<Exchange>& exchanges,
                                    bool at_one_time)
{
  constexpr double middle = Part_morph::change, first = 0.36, second = 0.58; // times of the exchanges
  constexpr double spread = second - first, spread_of_step = 0.04; // durations from the first to the last place
  constexpr double vanishing = 0.15, vanished = 0.3, growing = 0.62, grown = 0.77; // times of the other unmatched parts
  const auto is_first = [](const Exchange& exchange) { return exchange.step == Exchange_step::FIRST; };
  const bool has_steps = std::any_of(exchanges.begin(), exchanges.end(), is_first);
  const auto time_of = [&](const Exchange& exchange) {
    if (!has_steps) return middle + (exchange.order - 0.5) * spread;
    if (at_one_time) return middle;
    return (is_first(exchange) ? first : second) + (exchange.order - 0.5) * spread_of_step;
  };
  std::array<int, 2> deepest = {1, 1}; // indexed by end
  for (std::size_t i = 0; i < exchanges.size(); ++i)
    if (const Blend_part& part = blend.parts[i]; !part.is_matched() && exchanges[i].step == Exchange_step::NONE)
      deepest[std::size_t(part.end())] = std::max(deepest[std::size_t(part.end())], blend.depths[i]);
  const double going = (vanished - vanishing) / deepest[0], coming = (grown - growing) / deepest[1];
  std::vector<Blend_task> result;
  for (std::size_t i = 0; i < exchanges.size(); ++i) {
    const Blend_part& part = blend.parts[i];
    Blend_task task = part.task;
    if (exchanges[i].step != Exchange_step::NONE) {
      task.begin = task.end = time_of(exchanges[i]);
    } else if (!part.is_matched()) {
      const int before = std::max(0, blend.depths[i] - 1);
      task.begin = part.end() == 0 ? vanished - (before + 1) * going : growing + before * coming;
      task.end = task.begin + (part.end() == 0 ? going : coming);
    }
    result.push_back(task);
  }
  return result;
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

bool have_same_times(const std::vector<Blend_task>& a, const std::vector<Blend_task>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Blend_task& task, const Blend_task& other) {
    return task.begin == other.begin && task.end == other.end;
  });
}

std::vector<Blend_schedule> ranked_schedules(const Blend_structure& blend, const Blend_options& options)
{
  // Limits of `Blend_quality::apart` and `support`, beyond which it is better to exchange all parts at one time
  constexpr double most_apart = 0.05, most_missing = 0.6;
  bool goes_on = true;
  const auto go_on = [&](double done) { return goes_on = goes_on && (!options.progress || options.progress(done)); };
  const std::vector<Exchange> exchanges = exchange_steps(blend, [&](double done) { return go_on(done / 2); });
  std::vector<Blend_schedule> result;
  for (const std::string& name : Shape_blend::schedule_names())
    result.push_back({name, timed_tasks(blend, exchanges, !result.empty()), {}});
  Blend_schedule &in_steps = result[0], &at_once = result[1];
  if (!go_on(0.5)) return result;
  in_steps.quality = quality_of(blend, in_steps.tasks, options.samples);
  if (have_same_times(in_steps.tasks, at_once.tasks)) {
    at_once.quality = in_steps.quality;
    return result;
  }
  if (!go_on(0.75)) return result;
  at_once.quality = quality_of(blend, at_once.tasks, options.samples);
  if (in_steps.quality.apart > most_apart || in_steps.quality.support > most_missing) std::swap(in_steps, at_once);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
