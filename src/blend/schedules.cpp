// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/schedules.h"

#include "base/for_each_index.h"
#include "base/quantized.h"
#include "blend/blend_quality.h"
#include "blend/in_between_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// When each kind of task takes place, before idle time is taken out.
struct Schedule_plan
{
  const char* name;
  std::array<double, 2> morph, shrink, grow;
  double from_the_ground; ///< by how much what is highest comes later than what is lowest
};

/// How much one sees of a task: how far corners of the part's box move, times its size.
double visible_change(const Blend_part& part)
{
  if (!part.morph) return part.size * part.size / 2;
  const contacts::Box &from = part.trees[0]->box(), &to = part.trees[1]->box();
  return part.size * ((to.min() - from.min()).norm() + (to.max() - from.max()).norm()) / 2;
}

/// Gives intervals between begins and ends of tasks lengths by how much changes in them, half, and half by the lengths
/// that they have, unless next to nothing changes: idle time is taken out.
void use_all_time(std::vector<Blend_task>& tasks, const std::vector<Blend_part>& parts)
{
  constexpr double little = 0.02; // of all change: less gets less than the time that it has
  std::vector<double> times = {0, 1};
  for (const Blend_task& task : tasks)
    times.insert(times.end(), {task.begin, task.end});
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::vector<double> changes(times.size() - 1, 0);
  double sum = 0;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const double change = visible_change(parts[i]);
    sum += change;
    for (std::size_t k = 0; k < changes.size(); ++k)
      if (times[k] >= tasks[i].begin && times[k + 1] <= tasks[i].end)
        changes[k] += change * (times[k + 1] - times[k]) / (tasks[i].end - tasks[i].begin);
  }
  if (!(sum > 0)) return;
  std::vector<double> used(times.size(), 0);
  for (std::size_t k = 0; k < changes.size(); ++k) {
    const double share = changes[k] / sum, length = times[k + 1] - times[k];
    used[k + 1] = used[k] + (length * std::min(1., share / little) + share) / 2;
  }
  const auto moved = [&](double time) {
    const auto at = std::size_t(std::lower_bound(times.begin(), times.end(), time) - times.begin());
    return at + 1 == times.size() ? 1 : used[at] / used.back();
  };
  constexpr double shortest = 1e-3; // so that a task that changes nothing has a time, too
  for (Blend_task& task : tasks) {
    task.begin = std::min(moved(task.begin), 1 - shortest);
    task.end = std::max(moved(task.end), task.begin + shortest);
  }
}

Blend_quality worst(const Blend_quality& a, const Blend_quality& b)
{
  Blend_quality result;
  for (double Blend_quality::*measure :
       {&Blend_quality::gap, &Blend_quality::apart, &Blend_quality::asymmetry, &Blend_quality::ground,
        &Blend_quality::thinning, &Blend_quality::area, &Blend_quality::volume, &Blend_quality::torn,
        &Blend_quality::overlap, &Blend_quality::wobble})
    result.*measure = std::max(a.*measure, b.*measure);
  return result;
}

/// What schedules are ranked by, the less the better: the sum of all measures, each over its tolerance.
long cost_of(const Blend_quality& quality, const Blend_structure& blend)
{
  const double asymmetry = std::max(0., quality.asymmetry - end_asymmetry(blend));
  return quantized((quality.gap + quality.apart) / Shape_blend::contact_tolerance +
                   asymmetry / Shape_blend::symmetry_tolerance + quality.ground / Shape_blend::ground_tolerance +
                   quality.thinning / Shape_blend::thinning_tolerance + quality.area / Shape_blend::area_tolerance +
                   quality.volume / Shape_blend::volume_tolerance + quality.torn / Shape_blend::torn_tolerance +
                   quality.overlap / Shape_blend::overlap_tolerance + quality.wobble / Shape_blend::wobble_tolerance);
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

  const std::vector<long>& costs() const { return costs_; }

private:
  static constexpr long not_judged = std::numeric_limits<long>::max();

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
      qualities[i] = quality(in_between_shape(blend_, times, double(samples[i] + 1) / (options_.samples + 1)));
    });
    Blend_quality& result = schedules_[schedule].quality;
    result = std::accumulate(qualities.begin(), qualities.end(), result, worst);
    costs_[schedule] = cost_of(result, blend_);
  }

  const Blend_structure& blend_;
  const Blend_options& options_;
  std::vector<Blend_schedule>& schedules_;
  std::vector<long> costs_;
};

/// The lowest and the highest corner of the box of every part.
Points box_corners(const In_between_shape& shape)
{
  Points result(3, Eigen::Index(2 * shape.number_of_parts()));
  for (std::size_t part = 0; part < shape.number_of_parts(); ++part) {
    const Points& points = shape.is_there(part) ? shape.points(part) : shape.points(part, 0);
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
    use_all_time(result.back().tasks, parts);
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

double schedule_distance(const Blend_structure& blend, const Blend_schedule& a, const Blend_schedule& b, int samples)
{
  double farthest = 0;
  for (int i = 1; i <= samples; ++i) {
    const double t = double(i) / (samples + 1);
    const Points difference =
        box_corners(in_between_shape(blend, times_of(a), t)) - box_corners(in_between_shape(blend, times_of(b), t));
    farthest = std::max(farthest, std::sqrt(difference.squaredNorm() / double(difference.cols())));
  }
  return farthest;
}

} // namespace CGAL::Shape_correspondence::internal
