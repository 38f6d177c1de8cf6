// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/meshes.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/alpha_wrap_3.h>

#include <Eigen/Geometry>

#include <cstddef>

namespace CGAL::Shape_correspondence {
namespace {

/// All parts, without triangles that have no area.
internal::Triangle_soup soup_of(const Segmented_shape& shape)
{
  internal::Triangle_soup result;
  for (const Shape_part& part : shape.parts()) {
    const std::size_t first = result.points.size();
    for (Eigen::Index i = 0; i < part.mesh.points.cols(); ++i)
      result.points.push_back(internal::to_mesh_point(part.mesh.points.col(i)));
    for (Eigen::Index t = 0; t < part.mesh.triangles.cols(); ++t) {
      const Eigen::Vector3i corners = part.mesh.triangles.col(t);
      const Point a = part.mesh.points.col(corners[0]), b = part.mesh.points.col(corners[1]);
      const Point c = part.mesh.points.col(corners[2]);
      if (!((b - a).cross(c - a).squaredNorm() > 0)) continue;
      result.triangles.push_back(
          {first + std::size_t(corners[0]), first + std::size_t(corners[1]), first + std::size_t(corners[2])});
    }
  }
  return result;
}

double diagonal_of(const Segmented_shape& shape)
{
  Eigen::AlignedBox3d box;
  for (const Shape_part& part : shape.parts())
    box.extend(Eigen::AlignedBox3d(part.mesh.points.rowwise().minCoeff(), part.mesh.points.rowwise().maxCoeff()));
  return box.diagonal().norm();
}

} // namespace

Part_mesh Shape_blend::solid(double t, double detail) const
{
  constexpr double least_detail = 0.001;
  constexpr double offset = 0.1; // of the wrap from the surface, over the detail
  if (!(detail >= least_detail && detail <= 1))
    throw Invalid_input("Shape_blend: the detail of a solid must be between 0.001 and 1");
  const Segmented_shape shape = (*this)(t);
  const internal::Triangle_soup soup = soup_of(shape);
  const double alpha = detail * diagonal_of(shape);
  internal::Halfedge_mesh result;
  CGAL::alpha_wrap_3(soup.points, soup.triangles, alpha, offset * alpha, result);
  if (!CGAL::is_closed(result) || !CGAL::Polygon_mesh_processing::is_outward_oriented(result))
    throw Invalid_input("Shape_blend: the shape at this time has no closed surface around it");
  return internal::to_part_mesh(result);
}

} // namespace CGAL::Shape_correspondence
