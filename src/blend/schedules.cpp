// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/schedules.h"

#include "base/for_each_index.h"
#include "base/quantized.h"
#include "blend/blend_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

Blend_quality worst(const Blend_quality& a, const Blend_quality& b)
{
  Blend_quality result;
  for (const Blend_measure& measure : blend_measures())
    result.*measure.value = std::max(a.*measure.value, b.*measure.value);
  return result;
}

/// Rates a schedule by shapes in between, the worst of each measure.
Blend_quality quality_of(const Blend_structure& blend, const Task_times& times, int samples)
{
  std::vector<Blend_quality> qualities(static_cast<std::size_t>(samples));
  for_each_index<CGAL::Parallel_if_available_tag>(qualities.size(), [&](std::size_t i) {
    qualities[i] = quality(In_between_shape(blend, times, double(i + 1) / (samples + 1)));
  });
  return std::accumulate(qualities.begin(), qualities.end(), Blend_quality(), worst);
}

/// Parts that come or go at one time, and when.
struct Timed_group
{
  std::array<bool, 2> is_at = {false, false}; ///< by end
  double height = 0, size = 0;                ///< sums over its parts, of heights times sizes and of sizes
  std::array<double, 2> times = {0, 0};

  bool is_exchange() const { return is_at[0] && is_at[1]; }
};

using Timed_groups = std::map<std::size_t, Timed_group>;

Timed_groups timed_groups(const std::vector<Blend_part>& parts, const std::vector<std::size_t>& groups)
{
  Timed_groups result;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Timed_group& group = result[groups[i]];
    for (int end : {0, 1})
      group.is_at[std::size_t(end)] |= parts[i].is_at(end);
    if (parts[i].is_matched()) continue;
    group.height += parts[i].mesh.points.row(1).mean() * parts[i].size;
    group.size += parts[i].size;
  }
  return result;
}

/// What is exchanged changes when surfaces of matched parts do. Before that go the others, one after the other, after
/// it they come, from the ground up or from the top down, each so quickly that it is hardly seen small.
void put_in_turn(Timed_groups& groups, bool from_the_ground)
{
  constexpr double longest = 0.08, instant = 0.004;
  constexpr std::array<std::array<double, 2>, 2> bounds = {{{0.15, 0.35}, {0.55, 0.75}}}; // of all times, by end
  std::array<std::map<Steps, std::vector<Timed_group*>>, 2> turns; // by end and height: as high is at one time
  for (auto& [number, group] : groups) {
    group.times = {Part_morph::change - instant, Part_morph::change};
    if (group.is_exchange()) continue;
    const Steps height = quantized(group.height / group.size);
    turns[group.is_at[0] ? 0 : 1][from_the_ground ? height : -height].push_back(&group);
  }
  for (std::size_t end : {0u, 1u}) {
    const double step = (bounds[end][1] - bounds[end][0]) / double(std::max<std::size_t>(turns[end].size(), 1));
    double middle = bounds[end][0] + step / 2;
    const double length = std::min(longest, step);
    for (const auto& [height, changing] : turns[end]) {
      for (Timed_group* group : changing)
        group->times = {middle - length / 2, middle + length / 2};
      middle += step;
    }
  }
}

Blend_schedule schedule_of(const std::string& name, const Blend_structure& blend, const Task_times& times)
{
  Blend_schedule result{name, {}, {}};
  for (std::size_t i = 0; i < times.size(); ++i) {
    result.tasks.push_back(blend.parts[i].task);
    result.tasks.back().begin = times[i][0];
    result.tasks.back().end = times[i][1];
  }
  return result;
}

/// How many measures are over their tolerance.
std::ptrdiff_t number_of_faults(const Blend_quality& quality)
{
  const auto& measures = blend_measures();
  return std::count_if(measures.begin(), measures.end(),
                       [&](const Blend_measure& measure) { return quality.*measure.value > measure.tolerance; });
}

} // namespace

const std::vector<std::string>& schedule_names()
{
  static const std::vector<std::string> names = {"from the ground up", "from the top down"};
  return names;
}

Task_times times_in_turn(const Blend_structure& blend, bool from_the_ground)
{
  Timed_groups timed = timed_groups(blend.parts, blend.groups);
  put_in_turn(timed, from_the_ground);
  Task_times result;
  for (std::size_t i = 0; i < blend.parts.size(); ++i)
    result.push_back(blend.parts[i].is_matched() ? std::array{0., 1.} : timed.at(blend.groups[i]).times);
  return result;
}

Task_times times_of(const Blend_schedule& schedule)
{
  Task_times result;
  for (const Blend_task& task : schedule.tasks)
    result.push_back({task.begin, task.end});
  return result;
}

std::vector<Blend_schedule> ranked_schedules(const Blend_structure& blend, const Blend_options& options)
{
  std::vector<Blend_schedule> result;
  for (const std::string& name : schedule_names())
    result.push_back(schedule_of(name, blend, times_in_turn(blend, result.empty())));
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (options.progress && !options.progress(double(i) / double(result.size()))) return result;
    result[i].quality = quality_of(blend, times_of(result[i]), options.samples);
  }
  std::stable_sort(result.begin(), result.end(), [](const Blend_schedule& a, const Blend_schedule& b) {
    return number_of_faults(a.quality) < number_of_faults(b.quality);
  });
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
