// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/Hull_planes.h"
#include "base/eigen_system.h"
#include "shape/convex_hull_mesh.h"

#include <Eigen/Geometry>

namespace CGAL::Shape_correspondence::internal {
namespace {

constexpr double flat = 1e-6; // thickness over width of points of which the hull is rounding noise

/// The points, and copies of them to both sides in every direction in which they are thinner than `thickness`.
Points thickened(const Points& points, double thickness)
{
  const Point middle = points.rowwise().mean();
  const Eigen::Matrix3d axes = eigen_system(scatter_matrix(points.colwise() - middle)).vectors;
  Points result = points;
  for (int k = 0; k < 3; ++k) {
    const Point axis = axes.col(k);
    const Eigen::RowVectorXd along = axis.transpose() * (points.colwise() - middle);
    if (along.maxCoeff() - along.minCoeff() > flat * thickness) continue;
    const Points thin = result;
    result.resize(3, 2 * thin.cols());
    result << thin.colwise() + thickness / 2 * axis, thin.colwise() - thickness / 2 * axis;
  }
  return result;
}

} // namespace

Hull_planes::Hull_planes(const Points& points, double thickness)
{
  const Halfedge_mesh hull = convex_hull_mesh(thickened(points, thickness));
  const auto faces = Eigen::Index(hull.number_of_faces());
  normals_.resize(3, faces);
  offsets_.resize(faces);
  Eigen::Index k = 0;
  for (const auto face : hull.faces()) {
    const auto h = hull.halfedge(face);
    const Point a = to_point(hull.point(hull.source(h))), b = to_point(hull.point(hull.target(h))),
                c = to_point(hull.point(hull.target(hull.next(h))));
    normals_.col(k) = (b - a).cross(c - a).normalized();
    offsets_[k] = normals_.col(k).dot(a);
    ++k;
  }
}

double Hull_planes::share_inside(const Points& points, double tolerance) const
{
  Eigen::Index inside = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    inside += ((normals_.transpose() * points.col(i) - offsets_).array() <= tolerance).all();
  return double(inside) / double(points.cols());
}

} // namespace CGAL::Shape_correspondence::internal
