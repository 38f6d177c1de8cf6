// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <algorithm>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// The values at `t` in [0, 1] of the basis of a B-spline with `n` control points and clamped uniform knots; cubic, or
/// of the highest degree that so few points have (recurrence of Cox and de Boor).
inline Eigen::VectorXd b_spline_basis(int n, double t)
{
  const int degree = std::min(3, n - 1), inner = n - degree;
  const auto knot = [&](int i) { return std::min(1.0, std::max(0.0, double(i - degree) / inner)); };
  const int span = degree + std::min(inner - 1, static_cast<int>(t * inner));
  std::vector<double> values(n + degree + 1, 0.0);
  values[span] = 1;
  for (int k = 1; k <= degree; ++k)
    for (int i = 0; i < n + degree - k; ++i) {
      const double left = knot(i + k) - knot(i), right = knot(i + k + 1) - knot(i + 1);
      const double from_left = left > 0 ? (t - knot(i)) / left * values[i] : 0;
      const double from_right = right > 0 ? (knot(i + k + 1) - t) / right * values[i + 1] : 0;
      values[i] = from_left + from_right;
    }
  return Eigen::Map<Eigen::VectorXd>(values.data(), n);
}

/// A rational B-spline sheet: control points row by row; a curve is a sheet of one column.
struct B_spline
{
  Points points;
  Eigen::VectorXd weights;
  int rows = 0, cols = 0;

  Point operator()(double u, double v) const
  {
    const Eigen::VectorXd in_u = b_spline_basis(rows, u), in_v = b_spline_basis(cols, v);
    Point sum = Point::Zero();
    double total = 0;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < cols; ++j) {
        const double weight = in_u[i] * in_v[j] * weights[i * cols + j];
        sum += weight * points.col(i * cols + j);
        total += weight;
      }
    return sum / total;
  }
};

} // namespace CGAL::Shape_correspondence::IO
