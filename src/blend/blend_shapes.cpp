// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"
#include "base/quantized.h"
#include "blend/Blend_ends.h"
#include "blend/blend_quality.h"
#include "blend/in_between_steps.h"
#include "map/check_model.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

Task_times times_of(const Blend_schedule& schedule)
{
  Task_times result;
  for (const Blend_task& task : schedule.tasks)
    result.push_back({task.begin, task.end});
  return result;
}

/// When each kind of task takes place.
struct Schedule_plan
{
  const char* name;
  std::array<double, 2> morph, shrink, grow;
  double from_the_ground; ///< by how much what is highest comes later than what is lowest
};

std::vector<Blend_schedule> plausible_schedules(const std::vector<Blend_part>& parts)
{
  // What vanishes, or comes, may be all that joins others: it is there until contacts of the other end have come about
  static constexpr Schedule_plan plans[] = {{"all at once", {0, 1}, {0, 1}, {0, 1}, 0},
                                            {"shrink, then grow", {0, 1}, {0, 0.5}, {0.5, 1}, 0},
                                            {"one after the other", {0.25, 0.75}, {0, 0.5}, {0.5, 1}, 0},
                                            {"shrink, morph, grow", {1. / 3, 2. / 3}, {0, 1. / 3}, {2. / 3, 1}, 0},
                                            {"from the ground up", {0, 0.6}, {0, 0.5}, {0.5, 1}, 0.4}};
  std::vector<Blend_schedule> result;
  for (const Schedule_plan& plan : plans) {
    result.emplace_back();
    result.back().name = plan.name;
    for (const Blend_part& part : parts) {
      Blend_task task = part.task;
      const double delay = part.morph ? plan.from_the_ground * std::clamp(part.height, 0., 1.) : 0;
      const auto& times = part.morph ? plan.morph : task.type == Blend_task_type::SHRINK ? plan.shrink : plan.grow;
      task.begin = times[0] + delay;
      task.end = times[1] + delay;
      result.back().tasks.push_back(task);
    }
  }
  return result;
}

Blend_quality worst(const Blend_quality& a, const Blend_quality& b)
{
  return {std::max(a.gap, b.gap), std::max(a.apart, b.apart), std::max(a.asymmetry, b.asymmetry),
          std::max(a.ground, b.ground)};
}

/// The worst of some in-between shapes at even times.
Blend_quality worst_quality(const Blend_structure& blend, const Blend_schedule& schedule, int samples)
{
  const Task_times times = times_of(schedule);
  std::vector<Blend_quality> qualities(static_cast<std::size_t>(samples));
  for_each_index<CGAL::Parallel_if_available_tag>(qualities.size(), [&](std::size_t i) {
    qualities[i] = quality(in_between_shape(blend, times, double(i + 1) / double(qualities.size() + 1)));
  });
  return std::accumulate(qualities.begin(), qualities.end(), Blend_quality(), worst);
}

/// What schedules are ranked by, the less the better.
long cost_of(const Blend_quality& quality, const Blend_structure& blend)
{
  return quantized(quality.gap + quality.apart + std::max(0., quality.asymmetry - end_asymmetry(blend)) +
                   quality.ground);
}

/// \param costs by schedule
std::vector<Blend_schedule> ranked(const std::vector<Blend_schedule>& schedules, const std::vector<long>& costs)
{
  std::vector<std::size_t> order(schedules.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return costs[a] < costs[b]; });
  std::vector<Blend_schedule> result;
  for (std::size_t s : order)
    result.push_back(schedules[s]);
  return result;
}

} // namespace

Shape_blend::Shape_blend(const Structural_graph& source, const Segmented_shape& source_shape,
                         const Structural_graph& target, const Segmented_shape& target_shape,
                         const Correspondence& correspondence, const Blend_options& options)
{
  check_model(source, source_shape);
  check_model(target, target_shape);
  const std::array<Blend_input, 2> inputs = {Blend_input{source, source_shape, 0},
                                             Blend_input{target, target_shape, correspondence.target_quarter_turns}};
  blend_ = std::make_shared<const Blend_structure>(inputs, correspondence, options.contact_tolerance);
  schedules_ = plausible_schedules(blend_->parts);
  std::vector<long> costs(schedules_.size(), std::numeric_limits<long>::max());
  for (std::size_t s = 0; s < schedules_.size(); ++s) {
    if (options.progress && !options.progress(double(s) / double(schedules_.size()))) break;
    schedules_[s].quality = worst_quality(*blend_, schedules_[s], options.samples);
    costs[s] = cost_of(schedules_[s].quality, *blend_);
  }
  schedules_ = ranked(schedules_, costs);
}

Segmented_shape Shape_blend::operator()(double t) const
{
  if (t <= 0) return blend_->shapes[0];
  if (t >= 1) return blend_->shapes[1];
  const In_between_shape shape = in_between_shape(*blend_, times_of(schedules_[0]), t);
  Segmented_shape result(blend_->shapes[0].name() + '~' + blend_->shapes[1].name(), blend_->up(t));
  for (std::size_t part = 0; part < shape.number_of_parts(); ++part)
    if (shape.is_there(part))
      result.add_part(shape.part(part).name,
                      {blend_->to_world(shape.points(part), t), shape.part(part).triangles(shape.surface(part))});
  return result;
}

Blend_check Shape_blend::check(double t) const
{
  if (t > 0 && t < 1) return internal::check(in_between_shape(*blend_, times_of(schedules_[0]), t));
  Blend_check result;
  result.quality.asymmetry = blend_->end_asymmetry[t <= 0 ? 0 : 1];
  return result;
}

std::vector<Blend_surface> Shape_blend::surfaces() const
{
  std::vector<Blend_surface> result;
  for (std::size_t i = 0; i < blend_->parts.size(); ++i) {
    const Blend_part& part = blend_->parts[i];
    const Blend_task& task = schedules_[0].tasks[i];
    if (!part.morph) {
      const bool shrinks = task.type == Blend_task_type::SHRINK;
      result.push_back({part.name, task, part.triangles(0), shrinks ? 0 : task.begin, shrinks ? task.end : 1});
      continue;
    }
    const double change = part.morph->switch_time();
    const double at = change <= 0 ? 0 : change >= 1 ? 1 : task.begin + change * (task.end - task.begin);
    result.push_back({part.name, task, part.triangles(0), 0, at});
    result.push_back({part.name, task, part.triangles(1), at, 1});
  }
  return result;
}

std::vector<Points> Shape_blend::points(double t) const
{
  std::vector<Points> result;
  const In_between_shape shape = in_between_shape(*blend_, times_of(schedules_[0]), t);
  for (std::size_t part = 0; part < shape.number_of_parts(); ++part)
    for (int surface = 0; surface < (shape.part(part).morph ? 2 : 1); ++surface)
      result.push_back(blend_->to_world(shape.points(part, surface), t));
  return result;
}

} // namespace CGAL::Shape_correspondence
