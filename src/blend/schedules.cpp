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
    if (parts[i].is_matched()) continue;
    Timed_group& group = result[groups[i]];
    group.is_at[std::size_t(parts[i].end())] = true;
    group.height += parts[i].mesh.points.row(1).mean() * parts[i].size;
    group.size += parts[i].size;
  }
  return result;
}

/// One group after the other, each so quickly that old and new parts are hardly seen together: first those that go,
/// then those that are exchanged, then those that come; of these, from the ground up or from the top down.
void put_in_turn(Timed_groups& groups, bool from_the_ground)
{
  constexpr double longest = 0.08, exchange = 0.004;
  constexpr std::array<double, 4> bounds = {0.15, 0.35, 0.55, 0.75}; // of the times of each kind
  std::array<std::map<Steps, std::vector<Timed_group*>>, 3> kinds;   // by height: what is as high changes at one time
  for (auto& [number, group] : groups) {
    const Steps height = quantized(group.height / group.size);
    kinds[group.is_exchange() ? 1 : group.is_at[0] ? 0 : 2][from_the_ground ? height : -height].push_back(&group);
  }
  for (std::size_t kind : {0u, 1u, 2u}) {
    const double step = (bounds[kind + 1] - bounds[kind]) / double(std::max<std::size_t>(kinds[kind].size(), 1));
    double middle = bounds[kind] + step / 2;
    for (const auto& [height, changing] : kinds[kind]) {
      const double length = std::min(kind == 1 ? exchange : longest, step);
      double start = kind == 1 ? middle - length : middle - length / 2;
      if (start < 0.5 && start + length > 0.5) start = middle < 0.5 ? 0.5 - length : 0.5; // half-way, all are whole
      for (Timed_group* group : changing)
        group->times = {start, start + length};
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
