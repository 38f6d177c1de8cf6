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

/// A mesh in the coordinates of a chart.
struct Charted_mesh
{
  Points points; ///< in space
  Eigen::Matrix3Xi triangles;
  Points coordinates; ///< in the chart
  Points offsets;     ///< from where the chart has the coordinates to the points, in its frames
};

/// Subdivides a mesh until its edges are short in the chart, so that it can be bent.
Charted_mesh charted_mesh(const Part_mesh& mesh, const Part_chart& chart, double longest_edge);

/// The same, in a chart that is centred on the way.
Charted_mesh finely_charted(const Part_mesh& mesh, Part_chart& chart, double longest_edge);

/// Unit normals of the vertices in the chart, outwards on the whole; zero where there is none.
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

/// The place on a mesh nearest to a point.
Mesh_place nearest_place(const contacts::Triangle_tree& tree, const Point& p);

/// A mesh in its chart, to find the place of a point of another mesh in the same coordinates.
class Place_finder
{
public:
  /// \param normals of the vertices
  Place_finder(const Points& coordinates, const Eigen::Matrix3Xi& triangles, const Points& normals);

  /// The nearest place; on a thin part the one on the same side, by normals.
  Mesh_place operator()(const Point& p, const Point& normal) const;

private:
  const Points& coordinates_;
  const Eigen::Matrix3Xi& triangles_;
  const Points& normals_;
  contacts::Triangle_tree all_;
  std::array<std::optional<contacts::Triangle_tree>, 6> facing_; ///< of triangles that face the six directions
  std::array<std::vector<Eigen::Index>, 6> numbers_;
};

} // namespace CGAL::Shape_correspondence::internal
