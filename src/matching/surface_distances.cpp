// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/surface_distances.h"

namespace CGAL::Shape_correspondence::internal {

namespace {

void make_room(Eigen::ArrayXd& numbers, Eigen::Index count)
{
  if (numbers.size() < count) numbers.resize(count);
}

} // namespace

// The values of a part begin at an even place, as they would in memory of their own: how Eigen adds numbers up depends
// on the address of the first.
Point_distances::Point_distances(const Normalized_shape& from, const Normalized_shape& to)
    : from_(from), sums_(Eigen::Index(from.surfaces.size()), Eigen::Index(to.surfaces.size()))
{
  Eigen::Index size = 0;
  for (const Surface& surface : from.surfaces) {
    begin_.push_back(size);
    size += (surface.rows() * sums_.cols() + 1) / 2 * 2;
  }
  values_.resize(size);
}

void Point_distances::set_squared(std::size_t part, std::size_t other, const Eigen::ArrayXd& squared)
{
  Eigen::Map<Eigen::ArrayXd> distances(values_.data() + place(part, other), count(part));
  distances = squared.head(count(part)).sqrt();
  sums_(Eigen::Index(part), Eigen::Index(other)) = distances.sum();
}

Surface_distances::Surface_distances(const Normalized_shape& a, const Normalized_shape& b)
    : a_from_b(a, b), b_from_a(b, a)
{
  Eigen::ArrayXd p_from_q, q_from_p;
  const Nearest_squared_kernel& kernel = nearest_squared_kernel();
  for (std::size_t i = 0; i < a.lanes.size(); ++i)
    for (std::size_t j = 0; j < b.lanes.size(); ++j) {
      const Point_lanes &p = a.lanes[i], &q = b.lanes[j];
      make_room(p_from_q, p.padded());
      make_room(q_from_p, q.padded());
      kernel.run(p, q, p_from_q.data(), q_from_p.data());
      a_from_b.set_squared(i, j, p_from_q);
      b_from_a.set_squared(j, i, q_from_p);
    }
}

double chamfer(const Point_distances& a_from_b, const Point_distances& b_from_a, std::size_t i, std::size_t j)
{
  return (a_from_b.mean(i, j) + b_from_a.mean(j, i)) / 2;
}

double chamfer(const Point_distances& a_from_b, const Point_distances& b_from_a, std::size_t i,
               const std::vector<std::size_t>& parts)
{
  Eigen::ArrayXd nearest = a_from_b.of(i, parts[0]);
  double sum = 0, n = 0;
  for (std::size_t j : parts) {
    nearest = nearest.min(a_from_b.of(i, j));
    sum += b_from_a.sum(j, i);
    n += double(b_from_a.count(j));
  }
  return (nearest.mean() + sum / n) / 2;
}

} // namespace CGAL::Shape_correspondence::internal
