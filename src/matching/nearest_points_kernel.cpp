// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Compiled with -fno-rounding-math, without which compilers do not vectorize comparisons.

#include "matching/nearest_points_kernel.h"

#include "base/target_clones.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Shape_correspondence::internal {

CGAL_SHAPE_CORRESPONDENCE_CLONED
void find_nearest(const Point_lanes& p, const Point_lanes& q, double* p_from_q, double* __restrict q_from_p)
{
  constexpr int lanes = Point_lanes::block_lanes;
  constexpr int at_once = 4; // number of points of p compared at a time
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::fill_n(q_from_p, q.padded(), infinity);
  const double *px = p[0], *py = p[1], *pz = p[2], *qx = q[0], *qy = q[1], *qz = q[2];
  const Eigen::Index count = p.count(), padded = q.padded();
  for (Eigen::Index first = 0; first < count; first += at_once) {
    double least[at_once][lanes];
    std::fill_n(&least[0][0], at_once * lanes, infinity);
    for (Eigen::Index block = 0; block < padded; block += lanes) {
      for (int k = 0; k < lanes; ++k) {
        const double x = qx[block + k], y = qy[block + k], z = qz[block + k];
        double nearest = q_from_p[block + k];
#pragma GCC unroll 4
        for (int i = 0; i < at_once; ++i) {
          const double dx = x - px[first + i], dy = y - py[first + i], dz = z - pz[first + i];
          const double squared = dx * dx + dy * dy + dz * dz;
          least[i][k] = squared < least[i][k] ? squared : least[i][k]; // false for padding, where the distance is NaN
          nearest = squared < nearest ? squared : nearest;
        }
        q_from_p[block + k] = nearest;
      }
    }
    for (int i = 0; i < at_once; ++i) {
      for (int half = lanes / 2; half > 0; half /= 2)
        for (int k = 0; k < half; ++k)
          least[i][k] = std::min(least[i][k], least[i][k + half]);
      p_from_q[first + i] = std::sqrt(least[i][0]);
    }
  }
  for (Eigen::Index k = 0; k < padded; ++k)
    q_from_p[k] = std::sqrt(q_from_p[k]);
}

} // namespace CGAL::Shape_correspondence::internal
