// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "abstraction/curve_and_sheet_geometry.h"
#include "base/directions.h"
#include "base/eigen_system.h"
#include "base/planar_hull.h"

#include <CGAL/Shape_correspondence/Part_abstraction.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

struct Fitted_sheet
{
  Sheet sheet;
  double residual = 0; ///< root mean square distance of the medial axis from the sheet
};

/// The plane of a sheet, given by a centre and orthonormal axes (columns), the normal last.
struct Sheet_plane
{
  Point centre;
  Eigen::Matrix3d axes;

  Points to_plane(const Points& points) const { return axes.transpose() * (points.colwise() - centre); }
  Points to_space(const Points& points) const { return (axes * points).colwise() + centre; }
};

/// Variances of points along their principal axes, the largest first.
inline Eigen::Vector3d principal_variances(const Points& points)
{
  const Points centred = points.colwise() - points.rowwise().mean();
  return eigen_system(scatter_matrix(centred) / points.cols()).values.reverse().cwiseMax(1e-300);
}

/// The plane through points, with axes along their principal axes; if the points have no preferred direction in the
/// plane, with axes that depend on the normal alone. Neither the axes nor their signs depend on rounding.
inline Sheet_plane principal_plane(const Points& points)
{
  const double round = 0.999; // least ratio of the two variances in the plane that counts as equal
  const Point centre = points.rowwise().mean();
  const Eigen_system system = eigen_system(scatter_matrix(points.colwise() - centre));
  const Point normal = with_fixed_sign(system.vectors.col(0));
  const bool is_round = system.values[1] > round * system.values[2];
  Sheet_plane result;
  result.centre = centre;
  result.axes.col(0) = is_round ? some_normal(normal) : with_fixed_sign(system.vectors.col(2));
  result.axes.col(1) = normal.cross(result.axes.col(0));
  result.axes.col(2) = normal;
  return result;
}

inline Planar_points project(const Points& points)
{
  Planar_points result;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    result.push_back(points.col(i).head<2>());
  return result;
}

/// Rotates the axes in the plane to the sides of the least rectangle around the projected points of a surface.
inline void turn_to_rectangle(Sheet_plane& plane, const Points& surface)
{
  const Eigen::Vector2d side = least_rectangle_direction(planar_hull(project(plane.to_plane(surface))));
  Eigen::Matrix3d turned = plane.axes;
  turned.col(0) = side.x() * plane.axes.col(0) + side.y() * plane.axes.col(1);
  turned.col(1) = -side.y() * plane.axes.col(0) + side.x() * plane.axes.col(1);
  plane.axes = turned;
}

using Outline_corners = std::array<std::size_t, 4>;

inline double quadrilateral_area(const Planar_points& outline, const Outline_corners& c)
{
  return 0.5 * std::abs(cross(outline[c[2]] - outline[c[0]], outline[c[3]] - outline[c[1]]));
}

/// The largest quadrilateral of an outline's vertices: for each first diagonal, the farthest vertices on either side.
inline Outline_corners largest_quadrilateral(const Planar_points& outline)
{
  // On a smooth outline, every n-th vertex suffices.
  const std::size_t most_vertices = 60;
  const std::size_t n = outline.size(), step = 1 + n / most_vertices;
  Outline_corners result{0, 0, 0, 0};
  for (std::size_t a = 0; a < n; a += step) {
    for (std::size_t c = a + step; c < n; c += step) {
      Outline_corners corners{a, a, c, c};
      double right = 0, left = 0;
      for (std::size_t k = 0; k < n; k += step) {
        const double side = cross(outline[c] - outline[a], outline[k] - outline[a]);
        if (side < right) {
          right = side;
          corners[1] = k;
        } else if (side > left) {
          left = side;
          corners[3] = k;
        }
      }
      if (quadrilateral_area(outline, corners) > (1 + 1e-6) * quadrilateral_area(outline, result)) result = corners;
    }
  }
  return result;
}

/// The extreme points of an outline along the diagonals of its bounding box, counter-clockwise from the lower left.
inline Outline_corners diagonal_corners(const Planar_points& outline)
{
  Eigen::Array2d low = outline[0], high = low;
  for (const auto& p : outline) {
    low = low.min(p.array());
    high = high.max(p.array());
  }
  const Eigen::Array2d extent = (high - low).max(1e-300);
  const Eigen::Array2d diagonals[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  Outline_corners result{};
  for (std::size_t c = 0; c < 4; ++c) {
    const auto reach = [&](std::size_t i) { return (outline[i].array() / extent * diagonals[c]).sum(); };
    for (std::size_t i = 1; i < outline.size(); ++i)
      if (reach(i) > reach(result[c]) + 1e-6) result[c] = i;
  }
  return result;
}

/// The four corners of an outline: its extreme points along the diagonals, or for a skew outline, such as that of a
/// swept wing, the corners of its largest quadrilateral, starting with the one nearest to the lower left.
inline Outline_corners outline_corners(const Planar_points& outline)
{
  const double clearly = 1.03; // least area of a skew outline's largest quadrilateral, over that of its extreme points
  const Outline_corners along_diagonals = diagonal_corners(outline);
  Outline_corners largest = largest_quadrilateral(outline);
  if (quadrilateral_area(outline, largest) < clearly * quadrilateral_area(outline, along_diagonals))
    return along_diagonals;
  const Eigen::Vector2d start = outline[along_diagonals[0]];
  const auto nearer = [&](std::size_t a, std::size_t b) {
    return (outline[a] - start).norm() < (outline[b] - start).norm();
  };
  std::rotate(largest.begin(), std::min_element(largest.begin(), largest.end(), nearer), largest.end());
  return largest;
}

/// `n` points, evenly spaced on a closed outline from one of its vertices to another.
inline Planar_points outline_side(const Planar_points& outline, std::size_t from, std::size_t to, int n)
{
  std::vector<Point> chain;
  for (std::size_t i = from;; i = (i + 1) % outline.size()) {
    chain.emplace_back(outline[i].x(), outline[i].y(), 0.);
    if (i == to) break;
  }
  chain.push_back(chain.back()); // a side may be a single point
  Curve curve;
  curve.points.resize(3, Eigen::Index(chain.size()));
  for (std::size_t i = 0; i < chain.size(); ++i)
    curve.points.col(Eigen::Index(i)) = chain[i];
  return project(sample(curve, n));
}

/// A grid of `n` by `n` points in the plane whose boundary follows an outline (a Coons patch). Rows run along y.
inline Sheet flat_grid(const Planar_points& outline, int n)
{
  const auto corners = outline_corners(outline);
  const Planar_points bottom = outline_side(outline, corners[0], corners[1], n);
  const Planar_points right = outline_side(outline, corners[1], corners[2], n);
  const Planar_points top = outline_side(outline, corners[2], corners[3], n);
  const Planar_points left = outline_side(outline, corners[3], corners[0], n);
  Sheet result;
  result.rows = result.cols = n;
  result.points = Points::Zero(3, Eigen::Index(n) * n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double u = i / (n - 1.), v = j / (n - 1.);
      const auto at = [n](const Planar_points& side, int k, bool backwards) -> Eigen::Vector2d {
        return side[std::size_t(backwards ? n - 1 - k : k)];
      };
      const Eigen::Vector2d between_rows = (1 - u) * at(bottom, j, false) + u * at(top, j, true);
      const Eigen::Vector2d between_cols = (1 - v) * at(left, i, true) + v * at(right, i, false);
      const Eigen::Vector2d between_corners = (1 - u) * ((1 - v) * outline[corners[0]] + v * outline[corners[1]]) +
                                              u * ((1 - v) * outline[corners[3]] + v * outline[corners[2]]);
      result.points.col(i * n + j).head<2>() = between_rows + between_cols - between_corners;
    }
  }
  return result;
}

/// The control points that the bilinear map of a sheet combines at a parameter, with their weights.
inline std::array<std::pair<Eigen::Index, double>, 4> bilinear_weights(const Sheet& sheet,
                                                                       const Eigen::Vector2d& parameter)
{
  const Cell_position row = locate_cell(parameter[0], sheet.rows - 1);
  const Cell_position col = locate_cell(parameter[1], sheet.cols - 1);
  const Eigen::Index first = row.cell * sheet.cols + col.cell;
  return {{{first, (1 - row.fraction) * (1 - col.fraction)},
           {first + 1, (1 - row.fraction) * col.fraction},
           {first + sheet.cols, row.fraction * (1 - col.fraction)},
           {first + sheet.cols + 1, row.fraction * col.fraction}}};
}

/// The matrix of the quadratic form that sums the squared second differences of a grid's values: a bending energy.
inline Eigen::MatrixXd bending_form(int rows, int cols)
{
  const Eigen::Index size = Eigen::Index(rows) * cols;
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(size, size);
  const auto add = [&](std::initializer_list<std::pair<int, double>> terms) {
    for (const auto& [a, x] : terms) {
      for (const auto& [b, y] : terms)
        result(a, b) += x * y;
    }
  };
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < cols; ++j) {
      const int k = i * cols + j;
      if (i > 0 && i + 1 < rows) add({{k - cols, 1.}, {k, -2.}, {k + cols, 1.}});
      if (j > 0 && j + 1 < cols) add({{k - 1, 1.}, {k, -2.}, {k + 1, 1.}});
      if (i + 1 < rows && j + 1 < cols) {
        const double twist = std::sqrt(2.);
        add({{k, twist}, {k + 1, -twist}, {k + cols, -twist}, {k + cols + 1, twist}});
      }
    }
  }
  return result;
}

/// Smooth values, one column for each control point of a flat grid, that approximate given values at points in its
/// plane.
inline Eigen::MatrixXd smooth_values(const Sheet& grid, const Points& points, const Eigen::MatrixXd& values)
{
  const double smoothness = 0.05; // weight of the bending energy relative to the points
  // Weight of the value 0, for control points that neither the points nor the bending energy determine
  const double ridge = 1e-9;
  const Eigen::Index n = grid.points.cols();
  Eigen::MatrixXd form = Eigen::MatrixXd::Zero(n, n);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, values.rows());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Point foot(points(0, i), points(1, i), 0.);
    const auto weights = bilinear_weights(grid, nearest_parameter_on_sheet(grid, foot));
    for (const auto& [a, x] : weights) {
      for (const auto& [b, y] : weights)
        form(a, b) += x * y;
      right.row(a) += x * values.col(i).transpose();
    }
  }
  const double points_per_cell = double(points.cols()) / double(n);
  form += smoothness * points_per_cell * bending_form(grid.rows, grid.cols);
  form.diagonal().array() += ridge * points_per_cell;
  return form.ldlt().solve(right).transpose();
}

/// The values, clamped row by row to the extent of `range`: extrapolation of a strongly curved sheet has no bound.
inline Eigen::MatrixXd clamped(const Eigen::MatrixXd& values, const Eigen::MatrixXd& range)
{
  Eigen::MatrixXd result = values;
  for (Eigen::Index k = 0; k < values.rows(); ++k)
    result.row(k) = values.row(k).cwiseMax(range.row(k).minCoeff()).cwiseMin(range.row(k).maxCoeff());
  return result;
}

/// At most `limit` of the points, evenly picked.
inline Points thin_out(const Points& points, Eigen::Index limit)
{
  if (points.cols() <= limit) return points;
  Points result(3, limit);
  for (Eigen::Index i = 0; i < limit; ++i)
    result.col(i) = points.col(i * points.cols() / limit);
  return result;
}

/// Root mean square distance of points from a sheet.
inline double sheet_residual(const Sheet& sheet, const Points& points)
{
  const Eigen::Index most_measured = 150; // largest number of points whose distances are measured
  const Points measured = thin_out(points, most_measured);
  double sum = 0;
  for (Eigen::Index i = 0; i < measured.cols(); ++i) {
    const Eigen::Vector2d nearest = nearest_parameter_on_sheet(sheet, measured.col(i));
    sum += (sheet(nearest[0], nearest[1]) - measured.col(i)).squaredNorm();
  }
  return std::sqrt(sum / double(measured.cols()));
}

constexpr Eigen::Index most_fitted_points = 600; // largest number of points of a medial axis to which a sheet is fitted

/// Fits a sheet to a medial axis as a height field over a plane: the boundary is the outline of the part in this plane,
/// the heights those of the axis.
/// \param surface points of the part's surface that span its hull
inline Fitted_sheet fit_sheet(Sheet_plane plane, const Points& axis, const Points& surface, int n)
{
  const Points medial = thin_out(axis, most_fitted_points);
  turn_to_rectangle(plane, surface);
  const Points in_plane = plane.to_plane(medial);
  Fitted_sheet result;
  result.sheet = flat_grid(planar_hull(project(plane.to_plane(surface))), n);
  result.sheet.points.row(2) = clamped(smooth_values(result.sheet, in_plane, in_plane.row(2)), in_plane.row(2));
  result.sheet.points = plane.to_space(result.sheet.points);
  result.residual = sheet_residual(result.sheet, medial);
  return result;
}

/// Fits a sheet to a medial axis as a height field over its principal plane.
inline Fitted_sheet fit_sheet(const Points& axis, const Points& surface, int n)
{
  return fit_sheet(principal_plane(thin_out(axis, most_fitted_points)), axis, surface, n);
}

/// A flat sheet in a given plane, bounded by the outline of the part in this plane.
inline Fitted_sheet fit_flat_sheet(const Sheet_plane& plane, const Points& axis, const Points& surface, int n)
{
  Fitted_sheet result;
  result.sheet = flat_grid(planar_hull(project(plane.to_plane(surface))), n);
  result.sheet.points = plane.to_space(result.sheet.points);
  result.residual = sheet_residual(result.sheet, axis);
  return result;
}

/// Fits a sheet to a medial axis that is bent too much for a height field: its boundary is the outline of a planar
/// layout of the axis, offset to the part's surface.
/// \param layout coordinates of the axis in the plane
/// \param margin distance between the rim of the axis and that of the part
inline Fitted_sheet fit_bent_sheet(const Points& axis, const Points& layout, double margin, const Points& surface,
                                   int n)
{
  Sheet_plane plane{Point::Zero(), Eigen::Matrix3d::Identity()};
  turn_to_rectangle(plane, layout);
  const Points turned = plane.to_plane(layout);
  Planar_points outline = planar_hull(project(turned));
  for (Eigen::Vector2d& corner : outline)
    corner += margin * corner.normalized();
  Fitted_sheet result;
  result.sheet = flat_grid(outline, n);
  const Points medial = thin_out(axis, most_fitted_points);
  result.sheet.points = clamped(smooth_values(result.sheet, thin_out(turned, most_fitted_points), medial), surface);
  result.residual = sheet_residual(result.sheet, medial);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
