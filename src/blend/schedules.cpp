// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/schedules.h"

#include "base/for_each_index.h"
#include "base/quantized.h"
#include "blend/part_changes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Rates a schedule by shapes in between, the worst of each measure.
Blend_quality quality_of(const Blend_structure& blend, const std::vector<Blend_task>& tasks, int samples)
{
  std::vector<Blend_quality> qualities(static_cast<std::size_t>(samples));
  for_each_index<CGAL::Parallel_if_available_tag>(qualities.size(), [&](std::size_t i) {
    qualities[i] = In_between_shape(blend, tasks, double(i + 1) / (samples + 1)).check().quality;
  });
  Blend_quality worst;
  for (const Blend_quality& quality : qualities)
    for (const Blend_measure& measure : blend_measures())
      worst.*measure.value = std::max(worst.*measure.value, quality.*measure.value);
  return worst;
}

/// What is not exchanged goes before exchanges, one set after the other from the ground up, or comes after them, each
/// so quickly that it is hardly seen small.
void come_and_go(const Blend_structure& blend, const std::vector<Part_change>& changes, std::vector<Blend_task>& tasks)
{
  constexpr double longest = 0.08;
  constexpr double bounds[2][2] = {{0.15, 0.35}, {0.55, 0.75}};             // of all times, by end
  std::vector<Eigen::Vector4d> sums(tasks.size(), Eigen::Vector4d::Zero()); // by set: middles times sizes, and sizes
  for (std::size_t i = 0; i < tasks.size(); ++i)
    sums[changes[i].set] += blend.parts[i].size * blend.parts[i].trees[0].box().center().homogeneous();
  std::array<std::map<Steps, std::vector<Blend_task*>>, 2> turns; // by end and height
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const Blend_part& part = blend.parts[i];
    if (part.is_matched() || changes[i].step != Exchange_step::NONE) continue;
    turns[std::size_t(part.end())][quantized(sums[changes[i].set].hnormalized().y())].push_back(&tasks[i]);
  }
  for (std::size_t end : {0u, 1u}) {
    const double step = (bounds[end][1] - bounds[end][0]) / double(std::max<std::size_t>(turns[end].size(), 1));
    const double length = std::min(longest, step);
    double middle = bounds[end][0] + step / 2;
    for (const auto& [height, turn] : turns[end]) {
      for (Blend_task* task : turn) {
        task->begin = middle - length / 2;
        task->end = middle + length / 2;
      }
      middle += step;
    }
  }
}

/// The tasks with their times. What is exchanged changes when surfaces of matched parts do, or in two steps, the one
/// before that and the other one after it: the default of `Blend_options::samples` sees all of it.
std::vector<Blend_task> timed_tasks(const Blend_structure& blend, const std::vector<Part_change>& changes,
                                    bool at_one_time)
{
  constexpr double instant = 0.004, first = 0.35, second = 0.55;
  const bool has_steps = !at_one_time && std::any_of(changes.begin(), changes.end(), [](const Part_change& change) {
    return change.step == Exchange_step::FIRST;
  });
  std::vector<Blend_task> result;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    result.push_back(blend.parts[i].task);
    const Exchange_step step = changes[i].step;
    if (step == Exchange_step::NONE) continue;
    result.back().end = !has_steps ? Part_morph::change : step == Exchange_step::FIRST ? first : second;
    result.back().begin = result.back().end - instant;
  }
  come_and_go(blend, changes, result);
  return result;
}

} // namespace

bool have_same_times(const std::vector<Blend_task>& a, const std::vector<Blend_task>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Blend_task& task, const Blend_task& other) {
    return task.begin == other.begin && task.end == other.end;
  });
}

std::vector<Blend_schedule> ranked_schedules(const Blend_structure& blend, const Blend_options& options)
{
  constexpr double most_apart = 0.05; // over the height: what comes off by more is worse than a jump
  const std::vector<Part_change> changes = part_changes(blend);
  std::vector<Blend_schedule> result;
  for (const std::string& name : Shape_blend::schedule_names())
    result.push_back({name, timed_tasks(blend, changes, !result.empty()), {}});
  Blend_schedule &in_steps = result[0], &at_once = result[1];
  if (options.progress && !options.progress(0)) return result;
  in_steps.quality = quality_of(blend, in_steps.tasks, options.samples);
  if (have_same_times(in_steps.tasks, at_once.tasks)) {
    at_once.quality = in_steps.quality;
    return result;
  }
  if (options.progress && !options.progress(0.5)) return result;
  at_once.quality = quality_of(blend, at_once.tasks, options.samples);
  if (in_steps.quality.apart > most_apart) std::swap(in_steps, at_once);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
