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
#include <set>
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
Blend_quality quality_of(const Blend_structure& blend, const std::vector<Blend_task>& tasks, int samples)
{
  std::vector<Blend_quality> qualities(static_cast<std::size_t>(samples));
  for_each_index<CGAL::Parallel_if_available_tag>(qualities.size(), [&](std::size_t i) {
    qualities[i] = check(In_between_shape(blend, tasks, double(i + 1) / (samples + 1))).quality;
  });
  return std::accumulate(qualities.begin(), qualities.end(), Blend_quality(), worst);
}

/// Parts that change at one time, and when.
struct Timed_group
{
  std::array<bool, 2> is_at = {false, false}; ///< by end
  bool has_matched = false;                   ///< a part that is at both
  double height = 0, size = 0;                ///< sums over its unmatched parts, of heights times sizes and of sizes
  std::array<double, 2> times = {0, 0};

  bool is_exchange() const { return is_at[0] && is_at[1]; }
  /// Its height among all groups, in the order in which they change.
  Steps level(bool from_the_ground) const { return quantized(from_the_ground ? height / size : -height / size); }
};

using Timed_groups = std::map<std::size_t, Timed_group>;
using Levels = std::map<Steps, std::vector<Timed_group*>>;

Timed_groups timed_groups(const Blend_structure& blend)
{
  Timed_groups result;
  for (std::size_t i = 0; i < blend.parts.size(); ++i) {
    const Blend_part& part = blend.parts[i];
    Timed_group& group = result[blend.groups[i]];
    for (int end : {0, 1})
      group.is_at[std::size_t(end)] |= part.is_at(end);
    group.has_matched |= part.is_matched();
    if (part.is_matched()) continue;
    group.height += part.mesh.points.row(1).mean() * part.size;
    group.size += part.size;
  }
  return result;
}

/// What is exchanged changes when surfaces of matched parts do, or in two halves, the one before that and the other one
/// after it: as much as can be, by size, in the lesser half. The default of `Blend_options::samples` sees all of it.
void exchange(Timed_groups& groups, Blend_order order)
{
  constexpr double instant = 0.004, first = 0.35, second = 0.55, least_half = 0.15;
  const auto change_at = [&](Timed_group& group, double time) { group.times = {time - instant, time}; };
  Levels levels;
  double all = 0;
  for (auto& [number, group] : groups) {
    if (!group.is_exchange()) continue;
    change_at(group, Part_morph::change);
    if (group.has_matched) continue;
    levels[group.level(order == Blend_order::FROM_THE_GROUND)].push_back(&group);
    all += group.size;
  }
  Steps last_of_first = 0;
  double sum = 0, lesser = 0;
  for (const auto& [level, changing] : levels) {
    for (const Timed_group* group : changing)
      sum += group->size;
    const double half = std::min(sum, all - sum);
    if (quantized(half) > quantized(lesser)) lesser = half, last_of_first = level;
  }
  if (order == Blend_order::AT_ONE_TIME || lesser < least_half * all) return;
  for (const auto& [level, changing] : levels)
    for (Timed_group* group : changing)
      change_at(*group, level <= last_of_first ? first : second);
}

/// What touches exchanged parts goes with the first of them and comes with the last. \return the groups that do
std::set<std::size_t> go_with_exchanged(const Blend_structure& blend, Timed_groups& groups)
{
  std::set<std::size_t> result;
  for (const auto& [pair, gaps] : blend.touches)
    for (std::size_t i : {0u, 1u}) {
      const std::size_t number = blend.groups[pair[i]];
      Timed_group& group = groups.at(number);
      const Timed_group& other = groups.at(blend.groups[pair[1 - i]]);
      if (group.is_exchange() || !other.is_exchange() || blend.parts[pair[1 - i]].is_matched()) continue;
      const bool is_first = result.insert(number).second;
      const bool is_better = group.is_at[0] ? other.times < group.times : other.times > group.times;
      if (is_first || is_better) group.times = other.times;
    }
  return result;
}

/// All others go before exchanges, one after the other, or come after them, each so quickly that it is hardly seen
/// small.
void come_and_go(Timed_groups& groups, const std::set<std::size_t>& with_exchanged, bool from_the_ground)
{
  constexpr double longest = 0.08;
  constexpr std::array<std::array<double, 2>, 2> bounds = {{{0.15, 0.35}, {0.55, 0.75}}}; // of all times, by end
  std::array<Levels, 2> turns;                                                            // by end
  for (auto& [number, group] : groups)
    if (!group.is_exchange() && with_exchanged.count(number) == 0)
      turns[group.is_at[0] ? 0 : 1][group.level(from_the_ground)].push_back(&group);
  for (std::size_t end : {0u, 1u}) {
    const double step = (bounds[end][1] - bounds[end][0]) / double(std::max<std::size_t>(turns[end].size(), 1));
    double middle = bounds[end][0] + step / 2;
    const double length = std::min(longest, step);
    for (const auto& [level, changing] : turns[end]) {
      for (Timed_group* group : changing)
        group->times = {middle - length / 2, middle + length / 2};
      middle += step;
    }
  }
}

} // namespace

const std::vector<std::string>& schedule_names()
{
  static const std::vector<std::string> names = {"from the ground up", "from the top down", "at one time"};
  return names;
}

std::vector<Blend_task> tasks_in_order(const Blend_structure& blend, Blend_order order)
{
  Timed_groups groups = timed_groups(blend);
  exchange(groups, order);
  come_and_go(groups, go_with_exchanged(blend, groups), order != Blend_order::FROM_THE_TOP);
  std::vector<Blend_task> result;
  for (std::size_t i = 0; i < blend.parts.size(); ++i) {
    result.push_back(blend.parts[i].task);
    const std::array<double, 2> all = {0, 1};
    const auto& [begin, end] = blend.parts[i].is_matched() ? all : groups.at(blend.groups[i]).times;
    result.back().begin = begin;
    result.back().end = end;
  }
  return result;
}

bool have_same_times(const std::vector<Blend_task>& a, const std::vector<Blend_task>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Blend_task& task, const Blend_task& other) {
    return task.begin == other.begin && task.end == other.end;
  });
}

std::vector<Blend_schedule> ranked_schedules(const Blend_structure& blend, const Blend_options& options)
{
  std::vector<Blend_schedule> result;
  for (const std::string& name : schedule_names())
    result.push_back({name, tasks_in_order(blend, Blend_order(result.size())), {}});
  for (auto schedule = result.begin(); schedule != result.end(); ++schedule) {
    if (options.progress && !options.progress(double(schedule - result.begin()) / double(result.size()))) return result;
    const auto known = std::find_if(result.begin(), schedule, [&](const Blend_schedule& other) {
      return have_same_times(other.tasks, schedule->tasks);
    });
    schedule->quality = known != schedule ? known->quality : quality_of(blend, schedule->tasks, options.samples);
  }
  // Old parts beside new ones are worse than a jump if they come apart.
  const auto rank = [&](const Blend_schedule& schedule) {
    const bool is_mixed = schedule.name != result.back().name;
    return std::pair(is_mixed && schedule.quality.apart > Shape_blend::apart_tolerance,
                     number_of_faults(schedule.quality, blend));
  };
  std::vector<Blend_schedule> ranked = result;
  std::stable_sort(ranked.begin(), ranked.end(),
                   [&](const Blend_schedule& a, const Blend_schedule& b) { return rank(a) < rank(b); });
  return ranked;
}

} // namespace CGAL::Shape_correspondence::internal
