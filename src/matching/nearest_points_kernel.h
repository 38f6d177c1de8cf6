// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/vector_functions.h"

#include <Eigen/Core>

#include <algorithm>
#include <limits>
#include <vector>

// Nearest points of two sets in vectors as wide as the machine has. A squared distance is x² + y² + z² in that order,
// without fused operations, and a least one is the same in any order: every width gives the same bits. Own code, since
// Eigen is compiled for one set of instructions; `benchmark_search` measures the match by parts.

namespace CGAL::Shape_correspondence::internal {

// Points, coordinate by coordinate, padded with points at infinity.
class Point_lanes
{
public:
  static constexpr Eigen::Index widest = 8;

  explicit Point_lanes(const Eigen::ArrayX3d& points)
      : count_(points.rows()), coordinates_((points.rows() + widest - 1) / widest * widest, 3)
  {
    coordinates_.setConstant(std::numeric_limits<double>::infinity());
    coordinates_.topRows(count_) = points;
  }

  Eigen::Index count() const { return count_; }
  Eigen::Index padded() const { return coordinates_.rows(); }
  const double* operator[](int axis) const { return coordinates_.col(axis).data(); }

private:
  Eigen::Index count_;
  Eigen::ArrayX3d coordinates_;
};

template <int Width>
using Double_vector = typename Vector_of<double, Width, alignof(double)>::type;

// The least of the numbers of a vector.
template <int Width>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE double least_of(const Double_vector<Width>& numbers)
{
  if constexpr (Width == 1) {
    return *reinterpret_cast<const double*>(&numbers);
  } else {
    using Half = Double_vector<Width / 2>;
    const Half low = *reinterpret_cast<const Half*>(&numbers), high = *(reinterpret_cast<const Half*>(&numbers) + 1);
    const Half least = low < high ? low : high;
    return least_of<Width / 2>(least);
  }
}

// The least squared distance of every point of `p` from `q`, and of every point of `q` from `p`; both at once, since
// they need the same distances. There is room for the padding.
template <int Width>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void nearest_squared(const Point_lanes& p, const Point_lanes& q,
                                                             double* p_from_q, double* q_from_p)
{
  using Vector = Double_vector<Width>;
  constexpr int at_once = 4; // points of p
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::fill_n(q_from_p, q.padded(), infinity);
  // Copies of the pointers: the compiler cannot know that writing results leaves the members alone
  const double *px = p[0], *py = p[1], *pz = p[2], *qx = q[0], *qy = q[1], *qz = q[2];
  const Eigen::Index count = p.count(), padded = q.padded();
  for (Eigen::Index k = 0; k < count; k += at_once) {
    Vector least[at_once], x_of[at_once], y_of[at_once], z_of[at_once];
    for (int i = 0; i < at_once; ++i) {
      least[i] = Vector{} + infinity;
      x_of[i] = Vector{} + px[k + i];
      y_of[i] = Vector{} + py[k + i];
      z_of[i] = Vector{} + pz[k + i];
    }
    for (Eigen::Index j = 0; j < padded; j += Width) {
      const Vector x = *reinterpret_cast<const Vector*>(qx + j), y = *reinterpret_cast<const Vector*>(qy + j);
      const Vector z = *reinterpret_cast<const Vector*>(qz + j);
      Vector nearest = *reinterpret_cast<Vector*>(q_from_p + j);
      for (int i = 0; i < at_once; ++i) {
        const Vector dx = x - x_of[i], dy = y - y_of[i], dz = z - z_of[i];
        const Vector squared = dx * dx + dy * dy + dz * dz;
        least[i] = squared < least[i] ? squared : least[i]; // not for padding, where it is not a number
        nearest = squared < nearest ? squared : nearest;
      }
      *reinterpret_cast<Vector*>(q_from_p + j) = nearest;
    }
    for (int i = 0; i < at_once; ++i)
      p_from_q[k + i] = least_of<Width>(least[i]);
  }
}

struct Nearest_squared_kernel
{
  const char* name; // of the vector instructions
  void (*run)(const Point_lanes& p, const Point_lanes& q, double* p_from_q, double* q_from_p);
};

#define CGAL_SHAPE_CORRESPONDENCE_NEAREST(name, instructions, bytes)                                                   \
  CGAL_SHAPE_CORRESPONDENCE_TARGET(instructions)                                                                       \
  void nearest_squared_##name(const Point_lanes& p, const Point_lanes& q, double* p_from_q, double* q_from_p)          \
  {                                                                                                                    \
    nearest_squared<vector_width<double>(bytes)>(p, q, p_from_q, q_from_p);                                            \
  }                                                                                                                    \
  constexpr Nearest_squared_kernel nearest_squared_kernel_##name{#name, nearest_squared_##name};
CGAL_SHAPE_CORRESPONDENCE_FOR_INSTRUCTIONS(CGAL_SHAPE_CORRESPONDENCE_NEAREST)
#undef CGAL_SHAPE_CORRESPONDENCE_NEAREST

// The kernels that this machine can run, the fastest one last.
inline std::vector<Nearest_squared_kernel> available_nearest_squared_kernels()
{
  return runnable<Nearest_squared_kernel>(CGAL_SHAPE_CORRESPONDENCE_VERSIONS(nearest_squared_kernel_));
}

inline const Nearest_squared_kernel& nearest_squared_kernel()
{
  static const Nearest_squared_kernel fastest = available_nearest_squared_kernels().back();
  return fastest;
}

} // namespace CGAL::Shape_correspondence::internal
