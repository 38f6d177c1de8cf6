// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/In_between_cache.h"

#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

std::size_t number_of_points(const In_between_shape& shape)
{
  Eigen::Index result = 0;
  for (std::size_t part = 0; part < shape.number_of_parts(); ++part)
    result += shape.points(part).cols();
  return std::size_t(result);
}

} // namespace

In_between_cache::In_between_cache(std::shared_ptr<const Blend_structure> blend, Task_times times)
    : blend_(std::move(blend)), times_(std::move(times))
{}

std::shared_ptr<const In_between_shape> In_between_cache::at(double t)
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (const auto found = shapes_.find(t); found != shapes_.end()) return found->second;
  }
  auto made = std::make_shared<const In_between_shape>(*blend_, times_, t);
  const std::size_t points = number_of_points(*made);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (points_ + points > most_points) return made;
  const auto [kept, is_new] = shapes_.emplace(t, std::move(made));
  if (is_new) points_ += points;
  return kept->second;
}

} // namespace CGAL::Shape_correspondence::internal
