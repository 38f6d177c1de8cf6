// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Part_chart.h"
#include "shape/Triangle_tree.h"

#include <CGAL/Shape_correspondence/Points.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A mesh under subdivision. An edge is split in all of its triangles alike, so that a closed mesh stays closed.
class Subdivision
{
public:
  Subdivision(const Points& points, const Eigen::Matrix3Xi& triangles)
      : points_(points.cols()), triangles_(triangles.cols())
  {
    for (std::size_t i = 0; i < points_.size(); ++i)
      points_[i] = points.col(Eigen::Index(i));
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      triangles_[t] = {triangles(0, Eigen::Index(t)), triangles(1, Eigen::Index(t)), triangles(2, Eigen::Index(t))};
  }

  std::size_t number_of_points() const { return points_.size(); }
  std::size_t number_of_triangles() const { return triangles_.size(); }
  const Point& point(int i) const { return points_[std::size_t(i)]; }
  const std::array<int, 3>& corners(std::size_t triangle) const { return triangles_[triangle]; }

  void move(int i, const Point& to) { points_[std::size_t(i)] = to; }

  int add_point(const Point& p)
  {
    points_.push_back(p);
    return int(points_.size()) - 1;
  }

  void add_triangle(const std::array<int, 3>& corners) { triangles_.push_back(corners); }

  template <typename Test>
  void remove_triangles_if(const Test& test)
  {
    triangles_.erase(std::remove_if(triangles_.begin(), triangles_.end(), test), triangles_.end());
  }

  /// Splits every edge (a, b), a < b, at the fraction `where(a, b)` from a to b, if that is between 0 and 1.
  /// \return whether any edge was split
  template <typename Where>
  bool split_edges(const Where& where)
  {
    std::map<std::pair<int, int>, int> middles; // for each edge, the point that splits it; -1: none
    const auto middle = [&](int a, int b) {
      const std::pair<int, int> edge = std::minmax(a, b);
      const auto [known, is_new] = middles.try_emplace(edge, -1);
      if (!is_new) return known->second;
      const double f = where(edge.first, edge.second);
      if (f > 0 && f < 1) {
        known->second = int(points_.size());
        points_.push_back((1 - f) * point(edge.first) + f * point(edge.second));
      }
      return known->second;
    };
    std::vector<std::array<int, 3>> result;
    for (std::array<int, 3> t : triangles_) {
      std::array<int, 3> m;
      for (int i = 0; i < 3; ++i)
        m[std::size_t(i)] = middle(t[std::size_t(i)], t[std::size_t((i + 1) % 3)]);
      split(t, m, result);
    }
    const bool any = result.size() > triangles_.size();
    triangles_.swap(result);
    return any;
  }

  Points points() const
  {
    Points result(3, Eigen::Index(points_.size()));
    for (std::size_t i = 0; i < points_.size(); ++i)
      result.col(Eigen::Index(i)) = points_[i];
    return result;
  }

  Eigen::Matrix3Xi triangles() const
  {
    Eigen::Matrix3Xi result(3, Eigen::Index(triangles_.size()));
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      result.col(Eigen::Index(t)) << triangles_[t][0], triangles_[t][1], triangles_[t][2];
    return result;
  }

private:
  /// Splits a triangle. \param m for each edge from corner i to i + 1, the point that splits it, or -1
  static void split(std::array<int, 3> t, std::array<int, 3> m, std::vector<std::array<int, 3>>& result)
  {
    const auto is_split = [&](int i) { return m[std::size_t(i)] >= 0; };
    const int count = is_split(0) + is_split(1) + is_split(2);
    const auto rotate = [&] {
      std::rotate(t.begin(), t.begin() + 1, t.end());
      std::rotate(m.begin(), m.begin() + 1, m.end());
    };
    if (count == 0) {
      result.push_back(t);
    } else if (count == 1) {
      while (!is_split(0))
        rotate();
      result.insert(result.end(), {{t[0], m[0], t[2]}, {m[0], t[1], t[2]}});
    } else if (count == 2) {
      while (is_split(2))
        rotate();
      result.insert(result.end(), {{m[0], t[1], m[1]}, {t[0], m[0], m[1]}, {t[0], m[1], t[2]}});
    } else {
      result.insert(result.end(), {{t[0], m[0], m[2]}, {m[0], t[1], m[1]}, {m[2], m[1], t[2]}, {m[0], m[1], m[2]}});
    }
  }

  std::vector<Point> points_;
  std::vector<std::array<int, 3>> triangles_;
};

/// A mesh with the coordinates of its points in a chart.
struct Charted_mesh
{
  Points points; ///< positions in space
  Eigen::Matrix3Xi triangles;
  Points coordinates; ///< positions in the chart
  Points offsets;     ///< vectors from the chart's points at `coordinates` to `points`, in the chart's frames
};

/// Subdivides a mesh until its edges are short in the chart, so that it can be bent.
Charted_mesh charted_mesh(const Part_mesh& mesh, const Part_chart& chart, double longest_edge);

/// Subdivides a mesh like `charted_mesh()`, and charts it in the chart's centred version, which replaces `chart`.
Charted_mesh finely_charted(const Part_mesh& mesh, Part_chart& chart, double longest_edge);

/// Unit normals of the vertices in chart coordinates, oriented outwards as a whole; zero where undefined.
Points chart_normals(const Charted_mesh& mesh);

/// A point on a triangle of a mesh.
struct Mesh_place
{
  Eigen::Index triangle = 0;
  Eigen::Vector3d weights = Eigen::Vector3d::Zero(); ///< barycentric coordinates

  Point of(const Points& values, const Eigen::Matrix3Xi& triangles) const
  {
    return values.col(triangles(0, triangle)) * weights[0] + values.col(triangles(1, triangle)) * weights[1] +
           values.col(triangles(2, triangle)) * weights[2];
  }
};

Mesh_place nearest_place(const contacts::Triangle_tree& tree, const Point& p);

/// Finds locations on a mesh for points of another mesh given in the same chart coordinates.
class Place_finder
{
public:
  Place_finder(const Points& coordinates, const Eigen::Matrix3Xi& triangles, const Points& normals);

  /// The nearest location; on a thin part the nearest one on the same side, by normals.
  Mesh_place operator()(const Point& p, const Point& normal) const;

private:
  const Points& coordinates_;
  const Eigen::Matrix3Xi& triangles_;
  const Points& normals_;
  contacts::Triangle_tree all_;
  /// Trees of the triangles that face each of the six directions.
  std::array<std::optional<contacts::Triangle_tree>, 6> facing_;
  std::array<std::vector<Eigen::Index>, 6> numbers_; ///< indices of these triangles in the mesh
};

} // namespace CGAL::Shape_correspondence::internal
