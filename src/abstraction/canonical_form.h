// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "abstraction/curve_and_sheet_geometry.h"
#include "base/generic_direction.h"

#include <CGAL/Shape_correspondence/Part_abstraction.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A mesh that does not depend on the order of vertices and triangles, nor on rounding noise: coordinates are rounded
/// to a grid, equal vertices merged, duplicates removed, vertices and triangles sorted along a direction.
inline Part_mesh canonical_mesh(const Part_mesh& mesh, double grid)
{
  using Key = std::array<double, 4>; // position along the direction, then coordinates
  const Point direction = generic_direction();
  std::map<Key, int> vertices;
  const auto key = [&](Eigen::Index v) {
    const auto snap = [grid](double x) { return std::round(x / grid) * grid + 0.; };
    const Point p(snap(mesh.points(0, v)), snap(mesh.points(1, v)), snap(mesh.points(2, v)));
    return Key{direction.dot(p), p.x(), p.y(), p.z()};
  };
  for (Eigen::Index t = 0; t < mesh.triangles.size(); ++t)
    vertices.emplace(key(mesh.triangles.data()[t]), 0);
  Part_mesh result;
  result.points.resize(3, Eigen::Index(vertices.size()));
  int count = 0;
  std::vector<double> places;
  for (auto& [position, index] : vertices) {
    places.push_back(position[0]);
    result.points.col(count) << position[1], position[2], position[3];
    index = count++;
  }
  using Triangle_key = std::pair<double, std::array<int, 3>>; // position of the centre, then sorted corners
  std::map<Triangle_key, std::array<int, 3>> triangles;       // corners in their orientation
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    std::array<int, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = vertices.at(key(mesh.triangles(Eigen::Index(k), t)));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    std::array<int, 3> sorted = corners;
    std::sort(sorted.begin(), sorted.end());
    if (sorted[0] != sorted[1] && sorted[1] != sorted[2]) {
      const auto place_of = [&](std::size_t k) { return places[std::size_t(sorted[k])]; };
      const double place = place_of(0) + place_of(1) + place_of(2);
      const auto [known, is_new] = triangles.emplace(Triangle_key(place, sorted), corners);
      if (!is_new) known->second = std::min(known->second, corners);
    }
  }
  if (triangles.empty()) {
    // The mesh is thinner than the grid.
    const double finer = 1e-4, finest = 1e-20;
    return grid > finest ? canonical_mesh(mesh, finer * grid) : mesh;
  }
  result.triangles.resize(3, Eigen::Index(triangles.size()));
  Eigen::Index t = 0;
  for (const auto& [sorted, corners] : triangles)
    result.triangles.col(t++) << corners[0], corners[1], corners[2];
  return result;
}

/// The coordinate axis of the largest component; of nearly equal components, y, then x.
inline int dominant_axis(const Point& direction)
{
  const double nearly = 0.98;
  const double longest = direction.cwiseAbs().maxCoeff();
  for (int axis : {1, 0, 2})
    if (std::abs(direction[axis]) >= nearly * longest) return axis;
  return 1;
}

inline bool points_backwards(const Point& direction) { return direction[dominant_axis(direction)] < 0; }

/// Orients a curve: an open one runs up, else to the side, else to the front; a closed one starts at its foremost point
/// and turns counter-clockwise about its longest axis.
inline void make_canonical(Curve& curve)
{
  const Eigen::Index n = curve.points.cols();
  if (!curve.closed) {
    if (points_backwards(curve.points.col(n - 1) - curve.points.col(0)))
      curve.points = curve.points.rowwise().reverse().eval();
    return;
  }
  // Oblique to the axes, so that no two points of a regular ring tie
  const Point front(0.13, 0.29, 1.);
  const std::vector<double> lengths = arc_lengths(curve);
  Point turn = Point::Zero();
  for (Eigen::Index i = 0; i < n; ++i)
    turn += curve.points.col(i).cross(curve.points.col((i + 1) % n));
  if (points_backwards(turn)) curve.points = curve.points.rowwise().reverse().eval();
  const int fine = 1024;
  const Points dense = sample(curve, fine);
  Eigen::Index start = 0;
  (front.transpose() * dense).maxCoeff(&start);
  Curve turned = curve;
  turned.points.resize(3, fine);
  for (Eigen::Index i = 0; i < fine; ++i)
    turned.points.col(i) = dense.col((start + i) % fine);
  curve.points = sample(turned, int(n));
}

inline Sheet transposed(const Sheet& sheet)
{
  Sheet result = sheet;
  std::swap(result.rows, result.cols);
  for (int i = 0; i < sheet.rows; ++i) {
    for (int j = 0; j < sheet.cols; ++j)
      result.points.col(j * sheet.rows + i) = sheet.points.col(i * sheet.cols + j);
  }
  return result;
}

inline Point row_direction(const Sheet& sheet) { return sheet(1, 0) + sheet(1, 1) - sheet(0, 0) - sheet(0, 1); }
inline Point col_direction(const Sheet& sheet) { return sheet(0, 1) + sheet(1, 1) - sheet(0, 0) - sheet(1, 0); }

/// Orients a sheet: v runs to the side (or to the front, if the sheet does not extend sideways), u up or to the front.
inline void make_canonical(Sheet& sheet)
{
  const Point along_u = row_direction(sheet).normalized(), along_v = col_direction(sheet).normalized();
  const double u_side = std::abs(along_u.x()), v_side = std::abs(along_v.x());
  const bool side_decides = std::max(u_side, v_side) > 0.2 && std::abs(u_side - v_side) > 0.02;
  if (side_decides ? u_side > v_side : std::abs(along_u.z()) > std::abs(along_v.z()) + 0.02) sheet = transposed(sheet);
  const Eigen::Index rows = sheet.rows, cols = sheet.cols;
  if (points_backwards(row_direction(sheet))) {
    Sheet flipped = sheet;
    for (Eigen::Index i = 0; i < rows; ++i)
      flipped.points.middleCols(i * cols, cols) = sheet.points.middleCols((rows - 1 - i) * cols, cols);
    sheet = flipped;
  }
  if (points_backwards(col_direction(sheet))) {
    for (Eigen::Index i = 0; i < rows; ++i)
      sheet.points.middleCols(i * cols, cols) = sheet.points.middleCols(i * cols, cols).rowwise().reverse().eval();
  }
}

} // namespace CGAL::Shape_correspondence::internal
