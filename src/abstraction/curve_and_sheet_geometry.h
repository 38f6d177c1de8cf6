// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/clamped.h"
#include "shape/oriented_box.h"

#include <CGAL/Shape_correspondence/Part_abstraction.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL::Shape_correspondence {
namespace internal {

/// The index of a cell of a uniform subdivision, and the position within it, in [0, 1].
struct Cell_position
{
  int cell;
  double fraction;
};

inline Cell_position locate_cell(double parameter, int cells)
{
  const double x = clamped_to_unit(parameter) * cells;
  const int cell = clamped_cell(x, cells - 1);
  return {cell, x - cell};
}

/// Number of segments of a curve; the last segment of a closed one leads back to its first point.
inline Eigen::Index number_of_segments(const Curve& curve)
{
  return curve.closed ? curve.points.cols() : curve.points.cols() - 1;
}

inline Point segment_end(const Curve& curve, Eigen::Index segment)
{
  return curve.points.col((segment + 1) % curve.points.cols());
}

/// Arc length from the first control point to each one; for a closed curve, the total length is appended.
inline std::vector<double> arc_lengths(const Curve& curve)
{
  std::vector<double> result{0.};
  for (Eigen::Index s = 0; s < number_of_segments(curve); ++s)
    result.push_back(result.back() + (segment_end(curve, s) - curve.points.col(s)).norm());
  return result;
}

inline Point point_at_length(const Curve& curve, const std::vector<double>& lengths, double length)
{
  const auto after = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, length);
  const auto segment = std::size_t(after - lengths.begin()) - 1;
  const double extent = lengths[segment + 1] - lengths[segment];
  const double f = extent > 0 ? clamped_to_unit((length - lengths[segment]) / extent) : 0.;
  const auto s = Eigen::Index(segment);
  return (1 - f) * curve.points.col(s) + f * segment_end(curve, s);
}

/// Parameter in [0, 1] of the point of a segment nearest to p.
inline double nearest_on_segment(const Point& a, const Point& b, const Point& p)
{
  const double squared_length = (b - a).squaredNorm();
  return squared_length > 0 ? clamped_to_unit((p - a).dot(b - a) / squared_length) : 0.;
}

inline Eigen::Vector2d nearest_parameter_on_curve(const Curve& curve, const Point& p)
{
  const std::vector<double> lengths = arc_lengths(curve);
  double best = std::numeric_limits<double>::infinity();
  double length = 0;
  for (Eigen::Index s = 0; s < number_of_segments(curve); ++s) {
    const Point a = curve.points.col(s);
    const Point b = segment_end(curve, s);
    const double f = nearest_on_segment(a, b, p);
    const double distance = ((1 - f) * a + f * b - p).squaredNorm();
    if (distance < best) {
      best = distance;
      const auto i = std::size_t(s);
      length = lengths[i] + f * (lengths[i + 1] - lengths[i]);
    }
  }
  return {lengths.back() > 0 ? length / lengths.back() : 0., 0.};
}

/// Barycentric coordinates (along b - a and c - a) of the point of a triangle nearest to p.
inline Eigen::Vector2d nearest_on_triangle(const Point& a, const Point& b, const Point& c, const Point& p)
{
  Eigen::Matrix<double, 3, 2> edges;
  edges << b - a, c - a;
  const Eigen::Matrix2d gram = edges.transpose() * edges;
  if (gram.determinant() > 1e-14 * gram.trace() * gram.trace()) {
    const Eigen::Vector2d inside = gram.inverse() * (edges.transpose() * (p - a));
    if (inside.minCoeff() >= 0 && inside.sum() <= 1) return inside;
  }
  const double ab = nearest_on_segment(a, b, p);
  const double ac = nearest_on_segment(a, c, p);
  const double bc = nearest_on_segment(b, c, p);
  const Eigen::Vector2d candidates[] = {{ab, 0.}, {0., ac}, {1 - bc, bc}};
  const auto distance = [&](const Eigen::Vector2d& x) { return (a + edges * x - p).squaredNorm(); };
  return *std::min_element(std::begin(candidates), std::end(candidates),
                           [&](const auto& x, const auto& y) { return distance(x) < distance(y); });
}

/// The parameter of the point of a sheet's cell nearest to p, by Gauss-Newton steps from a parameter in the cell.
inline Eigen::Vector2d refine_in_cell(const Sheet& sheet, Eigen::Vector2d parameter, int row, int col, const Point& p)
{
  const Eigen::Array2d cells(sheet.rows - 1, sheet.cols - 1);
  const Eigen::Array2d low = Eigen::Array2d(row, col) / cells;
  const Eigen::Array2d high = Eigen::Array2d(row + 1, col + 1) / cells;
  const auto corner = [&](int i, int j) -> Point { return sheet.points.col((row + i) * sheet.cols + col + j); };
  const int most_rounds = 8;
  for (int round = 0; round < most_rounds; ++round) {
    const Eigen::Array2d f = (parameter.array() - low) * cells;
    Eigen::Matrix<double, 3, 2> derivative;
    derivative.col(0) = ((1 - f[1]) * (corner(1, 0) - corner(0, 0)) + f[1] * (corner(1, 1) - corner(0, 1))) * cells[0];
    derivative.col(1) = ((1 - f[0]) * (corner(0, 1) - corner(0, 0)) + f[0] * (corner(1, 1) - corner(1, 0))) * cells[1];
    const Eigen::Matrix2d gram = derivative.transpose() * derivative;
    if (!(gram.determinant() > 1e-14 * gram.trace() * gram.trace())) return parameter;
    const Point offset = p - sheet(parameter[0], parameter[1]);
    const Eigen::Vector2d step = gram.inverse() * (derivative.transpose() * offset);
    const auto stepped = [&](double fraction) -> Eigen::Vector2d {
      return (parameter + fraction * step).array().max(low).min(high);
    };
    double reach = 1;
    while (reach > 0.1 && !((p - sheet(stepped(reach)[0], stepped(reach)[1])).squaredNorm() < offset.squaredNorm()))
      reach *= 0.5;
    if (reach < 0.1) return parameter;
    parameter = stepped(reach);
  }
  return parameter;
}

/// A start for `refine_in_cell()`: the nearest point of one of a cell's two triangles.
struct Cell_candidate
{
  double distance; ///< squared distance from the point
  Eigen::Vector2d parameter;
  int row, col;
};

inline bool operator<(const Cell_candidate& a, const Cell_candidate& b)
{
  return std::tie(a.distance, a.row, a.col, a.parameter[0], a.parameter[1]) <
         std::tie(b.distance, b.row, b.col, b.parameter[0], b.parameter[1]);
}

inline void add_cell_candidates(const Sheet& sheet, int i, int j, const Point& p,
                                std::vector<Cell_candidate>& candidates)
{
  const auto corner = [&](int row, int col) -> Point { return sheet.points.col(row * sheet.cols + col); };
  for (const bool far_half : {false, true}) {
    const int i0 = far_half ? i + 1 : i, j0 = far_half ? j + 1 : j;
    const int sign = far_half ? -1 : 1;
    const Eigen::Vector2d x = nearest_on_triangle(corner(i0, j0), corner(i0 + sign, j0), corner(i0, j0 + sign), p);
    const Eigen::Vector2d at((i0 + sign * x[0]) / (sheet.rows - 1), (j0 + sign * x[1]) / (sheet.cols - 1));
    candidates.push_back({(sheet(at[0], at[1]) - p).squaredNorm(), at, i, j});
  }
}

/// A cell, and the distance of its bounding box from a point: a lower bound of the cell's distance.
struct Cell_distance
{
  double distance;
  int row, col;
};

inline std::vector<Cell_distance> cells_by_distance(const Sheet& sheet, const Point& p)
{
  std::vector<Cell_distance> result;
  result.reserve(std::size_t(sheet.rows - 1) * std::size_t(sheet.cols - 1));
  for (int i = 0; i + 1 < sheet.rows; ++i) {
    for (int j = 0; j + 1 < sheet.cols; ++j) {
      const auto near = sheet.points.middleCols<2>(i * sheet.cols + j);
      const auto far = sheet.points.middleCols<2>((i + 1) * sheet.cols + j);
      const Point low = near.cwiseMin(far).rowwise().minCoeff(), high = near.cwiseMax(far).rowwise().maxCoeff();
      const Point outside = (low - p).cwiseMax(p - high).cwiseMax(0.);
      result.push_back({outside.norm(), i, j});
    }
  }
  std::sort(result.begin(), result.end(), [](const Cell_distance& a, const Cell_distance& b) {
    return std::tie(a.distance, a.row, a.col) < std::tie(b.distance, b.row, b.col);
  });
  return result;
}

/// The parameter of a sheet's point nearest to p. In twisted cells the best start need not lead to it, so that several
/// are refined.
inline Eigen::Vector2d nearest_parameter_on_sheet(const Sheet& sheet, const Point& p)
{
  const std::size_t most_refined = 4;
  const double rounding = 1e-9 * (sheet.points.cwiseAbs().maxCoeff() + p.cwiseAbs().maxCoeff());
  std::vector<Cell_candidate> candidates;
  for (const Cell_distance& cell : cells_by_distance(sheet, p)) {
    if (candidates.size() == most_refined && cell.distance > std::sqrt(candidates.back().distance) + rounding) break;
    add_cell_candidates(sheet, cell.row, cell.col, p, candidates);
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(candidates.begin() + std::ptrdiff_t(std::min(most_refined, candidates.size())), candidates.end());
  }
  for (Cell_candidate& c : candidates) {
    c.parameter = refine_in_cell(sheet, c.parameter, c.row, c.col, p);
    c.distance = (sheet(c.parameter[0], c.parameter[1]) - p).squaredNorm();
  }
  return std::min_element(candidates.begin(), candidates.end(),
                          [](const auto& a, const auto& b) { return a.distance < b.distance; })
      ->parameter;
}

} // namespace internal

} // namespace CGAL::Shape_correspondence

namespace CGAL::Shape_correspondence::internal {

/// The line through the centre of a box along one of its axes.
inline Curve medial_curve(const Oriented_box& box, int control_points, Eigen::Index axis = 0)
{
  Curve result;
  result.points.resize(3, control_points);
  for (int i = 0; i < control_points; ++i) {
    const double t = i / (control_points - 1.) - 0.5;
    result.points.col(i) = box.centre + t * box.extents[axis] * box.axes.col(axis);
  }
  return result;
}

/// The axis of a box, as of a square prism, whose extent differs most from the other two; for a cube, the upright one.
inline Eigen::Index distinct_axis(const Oriented_box& box)
{
  const double alike = 0.9; // least ratio of the shortest to the longest extent of a cube
  Eigen::Index result = box.extents[0] * box.extents[2] > box.extents[1] * box.extents[1] ? 0 : 2;
  if (box.extents[2] > alike * box.extents[0]) box.axes.row(1).cwiseAbs().maxCoeff(&result);
  return result;
}

inline Sheet medial_sheet(const Oriented_box& box, int n)
{
  Sheet result;
  result.rows = result.cols = n;
  result.points.resize(3, Eigen::Index(n) * n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double u = i / (n - 1.) - 0.5, v = j / (n - 1.) - 0.5;
      result.points.col(i * n + j) =
          box.centre + u * box.extents[0] * box.axes.col(0) + v * box.extents[1] * box.axes.col(1);
    }
  }
  return result;
}

inline bool is_flat(const Eigen::Vector3d& extents)
{
  return extents[1] > 0.2 * extents[0] && extents[2] < 0.5 * extents[1];
}

inline bool is_compact(const Eigen::Vector3d& extents)
{
  return extents[1] > 0.2 * extents[0] && extents[2] >= 0.5 * extents[1];
}

} // namespace CGAL::Shape_correspondence::internal
