// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/schedules.h"

#include "base/for_each_index.h"
#include "base/quantized.h"
#include "blend/blend_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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
Blend_quality quality_of(const Blend_structure& blend, const Blend_schedule& schedule, int samples)
{
  const Task_times times = times_of(schedule);
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
  /// New parts are there before old ones go.
  std::array<double, 2> times_of(const Blend_part& part) const
  {
    const double length = (is_exchange() ? 0.5 : 1) * (times[1] - times[0]);
    if (part.end() == 0) return {times[1] - length, times[1]};
    return {times[0], times[0] + length};
  }
};

using Timed_groups = std::map<std::size_t, Timed_group>;

Timed_groups groups_of(const std::vector<Blend_part>& parts)
{
  Timed_groups result;
  for (const Blend_part& part : parts) {
    if (part.morph) continue;
    Timed_group& group = result[part.group];
    group.is_at[std::size_t(part.end())] = true;
    group.height += part.mesh.points.row(1).mean() * part.size;
    group.size += part.size;
  }
  return result;
}

/// One group after the other, each so quickly that old and new parts are hardly seen together: first those that go,
/// then those that are exchanged, in the middle of the time, then those that come; of these, from the ground up or from
/// the top down.
Timed_groups in_turn(Timed_groups groups, bool from_the_ground)
{
  constexpr double first = 0.15, last = 0.75, longest = 0.08;
  using Order = std::map<Steps, std::vector<std::size_t>>; // by height: what is as high changes at one time
  std::array<Order, 3> kinds;
  for (const auto& [number, group] : groups) {
    const Steps height = quantized(group.height / group.size);
    Order& kind = kinds[group.is_exchange() ? 1 : group.is_at[0] ? 0 : 2];
    kind[from_the_ground ? height : -height].push_back(number);
  }
  const bool has_exchanges = !kinds[1].empty();
  std::vector<Order> turns;
  for (Order& kind : kinds)
    if (has_exchanges || !kind.empty()) turns.push_back(std::move(kind));
  const double share = (last - first) / double(turns.size());
  for (std::size_t turn = 0; turn < turns.size(); ++turn) {
    const double step = share / double(turns[turn].size()), half = std::min(longest, step) / 2;
    double middle = first + double(turn) * share - step / 2;
    for (const auto& [height, numbers] : turns[turn]) {
      middle += step;
      double at = middle;
      if (std::abs(at - 0.5) < half) at = at < 0.5 ? 0.5 - half : 0.5 + half; // half-way, all are whole
      for (std::size_t number : numbers)
        groups[number].times = {at - half, at + half};
    }
  }
  return groups;
}

Blend_schedule schedule(const char* name, const std::vector<Blend_part>& parts, const Timed_groups& groups)
{
  Blend_schedule result{name, {}, {}};
  for (const Blend_part& part : parts) {
    result.tasks.push_back(part.task);
    const std::array<double, 2> times = part.morph ? std::array{0., 1.} : groups.at(part.group).times_of(part);
    result.tasks.back().begin = times[0];
    result.tasks.back().end = times[1];
  }
  return result;
}

} // namespace

Task_times times_of(const Blend_schedule& schedule)
{
  Task_times result;
  for (const Blend_task& task : schedule.tasks)
    result.push_back({task.begin, task.end});
  return result;
}

std::vector<Blend_schedule> plausible_schedules(const std::vector<Blend_part>& parts)
{
  const Timed_groups groups = groups_of(parts);
  return {schedule("from the ground up", parts, in_turn(groups, true)),
          schedule("from the top down", parts, in_turn(groups, false))};
}

void rank(std::vector<Blend_schedule>& schedules, const Blend_structure& blend, const Blend_options& options)
{
  constexpr double alike = 0.25;                    // of costs
  std::vector<std::pair<Steps, std::size_t>> order; // by cost; what is not rated comes last
  for (std::size_t s = 0; s < schedules.size(); ++s)
    order.emplace_back(std::numeric_limits<Steps>::max(), s);
  for (std::size_t s = 0; s < schedules.size(); ++s) {
    if (options.progress && !options.progress(double(s) / double(schedules.size()))) break;
    schedules[s].quality = quality_of(blend, schedules[s], options.samples);
    order[s].first = std::llround(cost_of(schedules[s].quality, blend) / alike);
  }
  std::sort(order.begin(), order.end());
  std::vector<Blend_schedule> ranked;
  for (const auto& [cost, s] : order)
    ranked.push_back(std::move(schedules[s]));
  schedules = std::move(ranked);
}

} // namespace CGAL::Shape_correspondence::internal
