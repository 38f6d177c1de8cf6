// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/surface_distances.h"

namespace CGAL::Shape_correspondence::internal {

namespace {

Point_distances room_for_distances(const Normalized_shape& from, const Normalized_shape& to)
{
  Point_distances result;
  for (const Surface& surface : from.surfaces)
    result.emplace_back(surface.rows(), Eigen::Index(to.surfaces.size()));
  return result;
}

} // namespace

double chamfer(const Point_lanes& p, const Point_lanes& q)
{
  Eigen::ArrayXd p_from_q(p.padded()), q_from_p(q.padded());
  nearest_squared_kernel().run(p, q, p_from_q.data(), q_from_p.data());
  return (p_from_q.head(p.count()).sqrt().mean() + q_from_p.head(q.count()).sqrt().mean()) / 2;
}

void point_distances(const Normalized_shape& a, const Normalized_shape& b, Point_distances& a_from_b,
                     Point_distances& b_from_a)
{
  a_from_b = room_for_distances(a, b);
  b_from_a = room_for_distances(b, a);
  Eigen::ArrayXd p_from_q, q_from_p;
  for (std::size_t i = 0; i < a.lanes.size(); ++i)
    for (std::size_t j = 0; j < b.lanes.size(); ++j) {
      const Point_lanes &p = a.lanes[i], &q = b.lanes[j];
      p_from_q.resize(p.padded());
      q_from_p.resize(q.padded());
      nearest_squared_kernel().run(p, q, p_from_q.data(), q_from_p.data());
      a_from_b[i].col(Eigen::Index(j)) = p_from_q.head(p.count()).sqrt();
      b_from_a[j].col(Eigen::Index(i)) = q_from_p.head(q.count()).sqrt();
    }
}

double chamfer(const Point_distances& a_from_b, const Point_distances& b_from_a, std::size_t i, std::size_t j)
{
  return (a_from_b[i].col(Eigen::Index(j)).mean() + b_from_a[j].col(Eigen::Index(i)).mean()) / 2;
}

double chamfer(const Point_distances& a_from_b, const Point_distances& b_from_a, std::size_t i,
               const std::vector<std::size_t>& parts)
{
  Eigen::ArrayXd nearest = a_from_b[i].col(Eigen::Index(parts[0]));
  double sum = 0, n = 0;
  for (std::size_t j : parts) {
    nearest = nearest.min(a_from_b[i].col(Eigen::Index(j)));
    sum += b_from_a[j].col(Eigen::Index(i)).sum();
    n += double(b_from_a[j].rows());
  }
  return (nearest.mean() + sum / n) / 2;
}

} // namespace CGAL::Shape_correspondence::internal
