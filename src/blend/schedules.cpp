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

/// Rates a layout by shapes in between, the worst of each measure.
Blend_quality quality_of(const Blend_structure& blend, const Blend_layout& layout, int samples)
{
  std::vector<Blend_quality> qualities(static_cast<std::size_t>(samples));
  for_each_index<CGAL::Parallel_if_available_tag>(qualities.size(), [&](std::size_t i) {
    qualities[i] = quality(In_between_shape(blend, layout, double(i + 1) / (samples + 1)));
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
/// then those that are exchanged, then those that come; of these, from the ground up or from
/// the top down. Exchanges alone are in the middle of the time.
void put_in_turn(Timed_groups& groups, bool from_the_ground)
{
  constexpr double first = 0.15, last = 0.75, longest = 0.08, exchange = 0.004;
  using Order = std::map<Steps, std::vector<std::size_t>>; // by height: what is as high changes at one time
  std::array<Order, 3> kinds;
  for (const auto& [number, group] : groups) {
    const Steps height = quantized(group.height / group.size);
    const std::size_t kind = group.is_exchange() ? 1 : group.is_at[0] ? 0 : 2;
    kinds[kind][from_the_ground ? height : -height].push_back(number);
  }
  const bool has_exchanges = !kinds[1].empty();
  std::size_t steps = 0;
  for (const Order& kind : kinds)
    steps += std::max(kind.size(), std::size_t(has_exchanges));
  const double step = (last - first) / double(std::max<std::size_t>(steps, 1));
  double begin = first;
  for (const Order& kind : kinds) {
    double middle = begin + step / 2;
    for (const auto& [height, numbers] : kind) {
      for (std::size_t number : numbers) {
        Timed_group& group = groups[number];
        const double length = std::min(group.is_exchange() ? exchange : longest, step);
        double start = group.is_exchange() ? middle - length : middle - length / 2;
        if (start < 0.5 && start + length > 0.5) start = middle < 0.5 ? 0.5 - length : 0.5; // half-way, all are whole
        group.times = {start, start + length};
      }
      middle += step;
    }
    begin += step * double(std::max(kind.size(), std::size_t(has_exchanges)));
  }
}

Blend_schedule schedule_of(const Blend_layout& layout, const std::vector<Blend_part>& parts)
{
  Blend_schedule result{layout.name, {}, {}};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    result.tasks.push_back(parts[i].task);
    result.tasks.back().begin = layout.times[i][0];
    result.tasks.back().end = layout.times[i][1];
  }
  return result;
}

/// The largest share of the parts, by their sizes, that comes or goes at one time.
double largest_change(const Blend_schedule& schedule, const std::vector<Blend_part>& parts)
{
  std::map<Steps, double> changes;
  double all = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    all += parts[i].size * (parts[i].is_matched() ? 2 : 1);
    if (!parts[i].is_matched()) changes[quantized(schedule.tasks[i].begin)] += parts[i].size;
  }
  double result = 0;
  for (const auto& [time, change] : changes)
    result = std::max(result, change / all);
  return result;
}

/// Whether shapes are as good as others by all measures but the volume, which all have that change at once.
bool is_as_good(const Blend_quality& quality, const Blend_quality& other)
{
  constexpr double much = 1.1;
  for (const Blend_measure& measure : blend_measures())
    if (measure.value != &Blend_quality::volume &&
        quality.*measure.value > std::max(measure.tolerance, much * other.*measure.value))
      return false;
  return true;
}

} // namespace

Task_times times_in_turn(const std::vector<Blend_part>& parts, const std::vector<std::size_t>& groups,
                         bool from_the_ground)
{
  Timed_groups timed = timed_groups(parts, groups);
  put_in_turn(timed, from_the_ground);
  Task_times result;
  for (std::size_t i = 0; i < parts.size(); ++i)
    result.push_back(parts[i].is_matched() ? std::array{0., 1.} : timed.at(groups[i]).times);
  return result;
}

std::vector<Blend_schedule> ranked_schedules(const Blend_structure& blend, const Blend_options& options)
{
  constexpr double less = 0.1; // of the parts
  std::vector<Blend_schedule> result;
  for (const Blend_layout& layout : blend.layouts)
    result.push_back(schedule_of(layout, blend.parts));
  std::rotate(result.begin(), result.end() - 1, result.end()); // without bodies
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (options.progress && !options.progress(double(i) / double(result.size()))) return result;
    result[i].quality = quality_of(blend, blend.layout(result[i].name), options.samples);
  }
  Blend_schedule &in_chains = result[0], &from_the_ground = result[1];
  const double change = largest_change(from_the_ground, blend.parts);
  if (change < largest_change(in_chains, blend.parts) - less && is_as_good(from_the_ground.quality, in_chains.quality))
    std::swap(in_chains, from_the_ground);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
