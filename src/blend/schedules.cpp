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
#include <numeric>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// When each kind of task takes place. What the shape needs is the last to go and the first to come.
struct Schedule_plan
{
  const char* name;
  std::array<double, 2> morph, shrink, grow;
  double from_the_ground; ///< by how much what is highest comes later than what is lowest
};

std::array<double, 2> reversed(const std::array<double, 2>& times) { return {1 - times[1], 1 - times[0]}; }

Blend_quality worst(const Blend_quality& a, const Blend_quality& b)
{
  Blend_quality result;
  for (const Blend_measure& measure : blend_measures())
    result.*measure.value = std::max(a.*measure.value, b.*measure.value);
  return result;
}

/// Judges schedules. The cost of a schedule by some of the samples is no more than by all of them, so that one that is
/// worse by the sample in the middle than another one is by all need not be judged further.
class Schedule_judge
{
public:
  Schedule_judge(const Blend_structure& blend, const Blend_options& options, std::vector<Blend_schedule>& schedules)
      : blend_(blend), options_(options), schedules_(schedules), costs_(schedules.size(), not_judged)
  {}

  void judge()
  {
    const auto middle = std::size_t((options_.samples - 1) / 2);
    for (std::size_t s = 0; s < schedules_.size(); ++s) {
      if (!goes_on(s)) return;
      add_samples(s, {middle});
    }
    std::vector<std::size_t> others(std::size_t(options_.samples));
    std::iota(others.begin(), others.end(), std::size_t(0));
    others.erase(others.begin() + std::ptrdiff_t(middle));
    std::vector<char> is_judged(schedules_.size(), 0);
    for (std::size_t count = 0; count < schedules_.size(); ++count) {
      const auto best = std::size_t(std::min_element(costs_.begin(), costs_.end()) - costs_.begin());
      std::size_t next = best;
      if (is_judged[best]) {
        if (!options_.rank_all) return;
        next = std::size_t(std::find(is_judged.begin(), is_judged.end(), 0) - is_judged.begin());
      }
      if (!goes_on(schedules_.size() + count * others.size())) return;
      add_samples(next, others);
      is_judged[next] = 1;
    }
  }

  const std::vector<Steps>& costs() const { return costs_; }

private:
  static constexpr double alike = 0.25; // of costs: among schedules as good, the first one, which has no idle time
  static constexpr Steps not_judged = std::numeric_limits<Steps>::max();

  /// \param done samples
  bool goes_on(std::size_t done) const
  {
    return !options_.progress || options_.progress(double(done) / double(schedules_.size() * options_.samples));
  }

  void add_samples(std::size_t schedule, const std::vector<std::size_t>& samples)
  {
    const Task_times times = times_of(schedules_[schedule]);
    std::vector<Blend_quality> qualities(samples.size());
    for_each_index<CGAL::Parallel_if_available_tag>(samples.size(), [&](std::size_t i) {
      qualities[i] = quality(In_between_shape(blend_, times, double(samples[i] + 1) / (options_.samples + 1)));
    });
    Blend_quality& result = schedules_[schedule].quality;
    result = std::accumulate(qualities.begin(), qualities.end(), result, worst);
    costs_[schedule] = std::llround(cost_of(result, blend_) / alike);
  }

  const Blend_structure& blend_;
  const Blend_options& options_;
  std::vector<Blend_schedule>& schedules_;
  std::vector<Steps> costs_;
};

/// The lowest and the highest corner of the box of every part.
Points box_corners(const In_between_shape& shape)
{
  Points result(3, Eigen::Index(2 * shape.number_of_parts()));
  for (std::size_t part = 0; part < shape.number_of_parts(); ++part) {
    const Points points = shape.points(part, shape.is_there(part) ? shape.surface(part) : 0);
    result.col(Eigen::Index(2 * part)) = points.rowwise().minCoeff();
    result.col(Eigen::Index(2 * part + 1)) = points.rowwise().maxCoeff();
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
  static constexpr Schedule_plan plans[] = {{"all at once", {0, 1}, {0, 1}, {0, 1}, 0},
                                            {"shrink, then grow", {0, 1}, {0, 0.6}, {0.4, 1}, 0},
                                            {"one after the other", {0.1, 0.9}, {0, 0.6}, {0.4, 1}, 0},
                                            {"shrink, morph, grow", {0.15, 0.85}, {0, 0.55}, {0.45, 1}, 0},
                                            {"from the ground up", {0, 0.7}, {0, 0.7}, {0.3, 1}, 0.3}};
  std::vector<Blend_schedule> result;
  for (const Schedule_plan& plan : plans) {
    result.emplace_back();
    result.back().name = plan.name;
    for (const Blend_part& part : parts) {
      Blend_task task = part.task;
      const auto morphs = bool(part.morph);
      const bool is_unlike = !morphs && task.obstacle != Blend_obstacle::NONE; // all change at once
      const double delay = morphs ? plan.from_the_ground * std::clamp(part.height, 0., 1.) : 0;
      std::array<double, 2> times = is_unlike                              ? std::array<double, 2>{0, 1}
                                    : morphs                               ? plan.morph
                                    : task.type == Blend_task_type::SHRINK ? plan.shrink
                                                                           : plan.grow;
      if (!is_unlike && !morphs && part.is_needed) times = reversed(times);
      task.begin = times[0] + delay;
      task.end = times[1] + delay;
      result.back().tasks.push_back(task);
    }
  }
  return result;
}

void rank(std::vector<Blend_schedule>& schedules, const Blend_structure& blend, const Blend_options& options)
{
  Schedule_judge judge(blend, options, schedules);
  judge.judge();
  std::vector<std::size_t> order(schedules.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return judge.costs()[a] < judge.costs()[b]; });
  std::vector<Blend_schedule> ranked;
  for (std::size_t s : order)
    ranked.push_back(std::move(schedules[s]));
  schedules = std::move(ranked);
}

double schedule_distance(const Blend_structure& blend, const Task_times& a, const Task_times& b, int samples)
{
  double farthest = 0;
  for (int i = 1; i <= samples; ++i) {
    const double t = double(i) / (samples + 1);
    const Points difference = box_corners(In_between_shape(blend, a, t)) - box_corners(In_between_shape(blend, b, t));
    farthest = std::max(farthest, std::sqrt(difference.squaredNorm() / double(difference.cols())));
  }
  return farthest;
}

} // namespace CGAL::Shape_correspondence::internal
