// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Part_chart.h"
#include "shape/Triangle_tree.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <array>
#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

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
  std::array<std::vector<Eigen::Index>, 6> numbers_;
};

} // namespace CGAL::Shape_correspondence::internal
