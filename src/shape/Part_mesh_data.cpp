// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/internal/part_mesh.h>

#include <cstddef>

namespace CGAL::Shape_correspondence::internal {

namespace {

template <typename Matrix, typename Column>
Matrix as_matrix(const std::vector<Column>& columns)
{
  Matrix result(3, Eigen::Index(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i)
    result.col(Eigen::Index(i)) = columns[i];
  return result;
}

} // namespace

int Part_mesh_data::add_point(double x, double y, double z)
{
  points_.emplace_back(x, y, z);
  return int(points_.size()) - 1;
}

void Part_mesh_data::add_polygon(const std::vector<int>& corners)
{
  for (std::size_t k = 2; k < corners.size(); ++k)
    triangles_.emplace_back(corners[0], corners[k - 1], corners[k]);
}

Points Part_mesh_data::points() const { return as_matrix<Points>(points_); }

Eigen::Matrix3Xi Part_mesh_data::triangles() const { return as_matrix<Eigen::Matrix3Xi>(triangles_); }

} // namespace CGAL::Shape_correspondence::internal
