// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/recognize_prism.h"
#include "abstraction/fit_sheet.h"
#include "base/directions.h"
#include "base/planar_hull.h"
#include "shape/triangle_distance.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Limits of a prism's volume over that of the extrusion of its outline. Edges may be rounded; the 2 % that may be
/// missing bound the offset of the axis from the middle, over the thickness.
constexpr double least_filled = 0.98, most_filled = 1.001;

/// Normal of each triangle, of length twice its area.
Points area_vectors(const Part_mesh& mesh)
{
  Points result(3, mesh.triangles.cols());
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    result.col(t) = contacts::area_vector(triangle_of(mesh, t));
  return result;
}

/// The normal direction with the largest total area.
/// \param candidates indices of normals, those of the largest triangles first
Point largest_face_normal(const Points& normals, const std::vector<Eigen::Index>& candidates)
{
  const std::size_t most_candidates = 8; // enough, since the largest triangles are in the largest faces
  const double parallel = 0.9999;        // least cosine of the angle between normals of one direction
  Point result = Point::Zero();
  double largest = 0;
  for (std::size_t i = 0; i < std::min(candidates.size(), most_candidates); ++i) {
    const Point direction = normals.col(candidates[i]).normalized();
    const Eigen::ArrayXd along = (direction.transpose() * normals).array().abs().transpose();
    const double area = (along > parallel * normals.colwise().norm().transpose().array()).select(along, 0.).sum();
    const double clearly = 1 + 1e-6;
    if (area > clearly * largest) {
      largest = area;
      result = direction;
    }
  }
  return result;
}

/// Orthogonal axes of a part: the normal of its largest face, that of the largest face perpendicular to it, and their
/// cross product. The axis of a prism is among them.
std::optional<std::array<Point, 3>> face_axes(const Part_mesh& mesh)
{
  const double right_angle = 0.01; // largest cosine of the angle between perpendicular normals
  const Points normals = area_vectors(mesh);
  std::vector<Eigen::Index> order(std::size_t(normals.cols()));
  std::iota(order.begin(), order.end(), Eigen::Index(0));
  const Eigen::RowVectorXd areas = normals.colwise().norm();
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index s, Eigen::Index t) { return areas[s] > areas[t]; });
  const Point first = largest_face_normal(normals, order);
  const auto is_askew = [&](Eigen::Index t) { return std::abs(first.dot(normals.col(t))) > right_angle * areas[t]; };
  order.erase(std::remove_if(order.begin(), order.end(), is_askew), order.end());
  Point second = largest_face_normal(normals, order);
  second = (second - first.dot(second) * first).eval();
  if (!(first.norm() > 0) || !(second.norm() > 0)) return std::nullopt;
  second.normalize();
  return std::array<Point, 3>{first, second, first.cross(second)};
}

/// The extrusion of a part's outline in the direction of an axis.
class Extrusion
{
public:
  Extrusion(const Points& points, const Point& axis)
  {
    plane_.centre = points.rowwise().mean();
    plane_.axes.col(2) = axis;
    plane_.axes.col(0) = some_normal(axis);
    plane_.axes.col(1) = axis.cross(plane_.axes.col(0));
    turn_to_rectangle(plane_, points);
    const Points turned = plane_.to_plane(points);
    low_ = turned.rowwise().minCoeff();
    high_ = turned.rowwise().maxCoeff();
    outline_ = planar_hull(project(turned));
    measure_outline();
  }

  double height() const { return extent(2); }
  double length() const { return std::max(extent(0), extent(1)); } ///< longer side of the outline
  double width() const { return std::min(extent(0), extent(1)); }  ///< shorter side of the outline
  double volume() const { return area_ * height(); }

  Curve axis(int n) const
  {
    Points ends(3, 2);
    ends.col(0) << centroid_, low_.z();
    ends.col(1) << centroid_, high_.z();
    return {sample(Curve{plane_.to_space(ends), false}, n), false};
  }

  Sheet middle_layer(int n) const
  {
    Sheet result = flat_grid(outline_, n);
    result.points.row(2).setConstant(0.5 * (low_.z() + high_.z()));
    result.points = plane_.to_space(result.points);
    return result;
  }

private:
  double extent(int k) const { return high_[k] - low_[k]; }

  void measure_outline()
  {
    for (std::size_t i = 0; i < outline_.size(); ++i) {
      const Eigen::Vector2d &a = outline_[i], &b = outline_[(i + 1) % outline_.size()];
      area_ += 0.5 * cross(a, b);
      centroid_ += cross(a, b) / 6 * (a + b);
    }
    centroid_ /= std::max(area_, 1e-300);
  }

  Sheet_plane plane_;
  Point low_, high_;
  Planar_points outline_;
  double area_ = 0; ///< area of the outline
  Eigen::Vector2d centroid_ = Eigen::Vector2d::Zero();
};

// Proportions at which the medial axis leaves no doubt, found with boxes of 221 proportions and cylinders of 68; prisms
// in between are left to the medial axis.

bool is_clearly_long(const Extrusion& e)
{
  const double strip_width = 0.08; // largest length over the height, for any thickness
  // Largest length of a rod, over the height, and least width, over the length: many boards have 0.2
  const double rod_width = 0.17, rod_thickness = 0.199;
  return e.length() < strip_width * e.height() ||
         (e.length() < rod_width * e.height() && e.width() > rod_thickness * e.length());
}

bool is_clearly_flat(const Extrusion& e)
{
  const double plate_width = 0.23, plate_thickness = 0.3;  // least width over the length; largest height over the width
  const double blade_width = 0.11, blade_thickness = 0.12; // the same for a blade
  return (e.width() > plate_width * e.length() && e.height() < plate_thickness * e.width()) ||
         (e.width() > blade_width * e.length() && e.height() < blade_thickness * e.width());
}

} // namespace

std::optional<std::variant<Curve, Sheet>> recognize_prism(const Part_mesh& mesh, double volume, int curve_points,
                                                          int sheet_points)
{
  const std::optional<std::array<Point, 3>> axes = face_axes(mesh);
  if (!axes) return std::nullopt;
  for (const Point& axis : *axes) {
    const Extrusion extrusion(mesh.points, axis);
    const double filled = volume / extrusion.volume();
    if (!(filled > least_filled && filled < most_filled)) continue;
    if (is_clearly_long(extrusion)) return extrusion.axis(curve_points);
    if (is_clearly_flat(extrusion)) return extrusion.middle_layer(sheet_points);
  }
  return std::nullopt;
}

} // namespace CGAL::Shape_correspondence::internal
