// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_pace.h"

#include "base/for_each_index.h"
#include "blend/ease.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// The area that moves between two shapes, times how far.
double change_between(const In_between_shape& a, const In_between_shape& b)
{
  double result = 0;
  for (std::size_t part = 0; part < a.number_of_parts(); ++part) {
    if (!a.is_there(part) && !b.is_there(part)) continue;
    const int surface = a.is_there(part) ? a.surface(part) : b.surface(part);
    const Points way = b.points(part, surface) - a.points(part, surface);
    result += a.part(part).rests[std::size_t(surface)].extent().area * way.colwise().norm().mean();
  }
  return result;
}

} // namespace

Blend_pace::Blend_pace(const Blend_structure& blend, const Task_times& times) : times_(times)
{
  constexpr std::size_t steps = 32;
  constexpr double least = 0.2; // of the mean change in a step, so that nothing is skipped
  std::vector<std::unique_ptr<In_between_shape>> shapes(steps + 1);
  for_each_index<CGAL::Parallel_if_available_tag>(shapes.size(), [&](std::size_t i) {
    shapes[i] = std::make_unique<In_between_shape>(blend, times, double(i) / steps);
  });
  std::vector<double> changes(steps);
  for (std::size_t i = 0; i < steps; ++i)
    changes[i] = change_between(*shapes[i], *shapes[i + 1]);
  const double all = std::accumulate(changes.begin(), changes.end(), 0.);
  done_.push_back(0);
  for (double change : changes)
    done_.push_back(done_.back() + least / steps + (all > 0 ? change / all : 1. / steps));
  const double sum = done_.back();
  for (double& done : done_)
    done /= sum;
}

double Blend_pace::moment(double t) const
{
  const auto after = std::upper_bound(done_.begin() + 1, done_.end() - 1, t);
  const double low = *(after - 1), share = (t - low) / (*after - low);
  return (double(after - done_.begin() - 1) + share) / double(done_.size() - 1);
}

double Blend_pace::time_of(std::size_t task, double progress) const
{
  const auto [begin, end] = times_[task];
  return time(begin + internal::time_of(progress) * (end - begin));
}

double Blend_pace::time(double moment) const
{
  const double at = moment * double(done_.size() - 1);
  const auto before = std::min(std::size_t(at), done_.size() - 2);
  return done_[before] + (at - double(before)) * (done_[before + 1] - done_[before]);
}

} // namespace CGAL::Shape_correspondence::internal
