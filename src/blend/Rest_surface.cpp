// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Rest_surface.h"

#include "base/eigen_system.h"
#include "shape/first_in_place.h"
#include "shape/triangle_distance.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Normals with the doubled areas as lengths, by triangle.
Points doubled_normals(const Points& points, const Eigen::Matrix3Xi& triangles)
{
  Points result(3, triangles.cols());
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    result.col(t) = contacts::area_vector(triangle_of(points, triangles, t));
  }
  return result;
}

double squared_longest_edge(const contacts::Triangle& corners)
{
  const auto& [a, b, c] = corners;
  return std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
}

} // namespace

Rest_surface::Rest_surface(const Points& points, const Eigen::Matrix3Xi& triangles)
    : triangles_(triangles), longest_(triangles.cols())
{
  constexpr double smooth = 0.5; // cosine of the angle between normals
  constexpr double least_thickness =
      1e-9; // volume over area, in square roots of areas: else both sides are in one place
  find_edges(points);
  extent_ = extent(points);
  is_closed_ = is_closed_ && std::abs(extent_.volume) > least_thickness * std::pow(extent_.area, 1.5);
  const Points normals = doubled_normals(points, triangles_);
  const Eigen::VectorXd areas = normals.colwise().norm();
  const auto turns = [&](const Edge& edge) {
    return normals.col(edge[0]).dot(normals.col(edge[1])) < smooth * areas[edge[0]] * areas[edge[1]];
  };
  smooth_.erase(std::remove_if(smooth_.begin(), smooth_.end(), turns), smooth_.end());
  for (Eigen::Index t = 0; t < triangles_.cols(); ++t)
    longest_[t] = squared_longest_edge(triangle_of(points, triangles_, t));
  constexpr int samples = 24;
  double passed = 0, next = 0;
  for (Eigen::Index t = 0; t < areas.size(); ++t)
    for (passed += areas[t]; next < passed; next += areas.sum() / samples)
      chosen_.push_back(t);
}

/// Sets all edges between two triangles, and whether there are no others. Points in one place are one.
void Rest_surface::find_edges(const Points& points)
{
  const std::vector<int> places = first_in_place(points);
  std::map<std::pair<int, int>, std::vector<int>> sides; // by ends, the triangles
  for (int t = 0; t < int(triangles_.cols()); ++t)
    for (int i = 0; i < 3; ++i) {
      const int a = places[std::size_t(triangles_(i, t))], b = places[std::size_t(triangles_((i + 1) % 3, t))];
      sides[std::minmax(a, b)].push_back(t);
    }
  for (const auto& [ends, triangles] : sides) {
    if (triangles.size() == 2) smooth_.push_back({triangles[0], triangles[1]});
    is_closed_ = is_closed_ && triangles.size() % 2 == 0;
  }
}

Surface_extent Rest_surface::extent(const Points& points) const
{
  Surface_extent result;
  const Points normals = doubled_normals(points, triangles_);
  const Point middle = points.rowwise().mean();
  Points centred(3, triangles_.cols());
  for (Eigen::Index t = 0; t < triangles_.cols(); ++t) {
    const double area = normals.col(t).norm() / 2;
    const Point centre = contacts::centre(triangle_of(points, triangles_, t)) - middle;
    result.area += area;
    result.volume += normals.col(t).dot(centre) / 6;
    centred.col(t) = std::sqrt(area) * centre;
  }
  if (!(result.area > 0)) return result;
  result.spreads = (eigen_system(scatter_matrix(centred)).values / result.area).cwiseMax(0).cwiseSqrt();
  return result;
}

double Rest_surface::torn_area(const Points& points, const Surface_extent& extent) const
{
  constexpr double folded = -0.5;       // cosine of the angle between normals
  constexpr double least_spread = 1e-4; // of the shape's height
  constexpr double most_stretch = 3;    // of an edge, over that of the whole surface
  const Points normals = doubled_normals(points, triangles_);
  const Eigen::VectorXd areas = normals.colwise().norm() / 2;
  std::vector<char> is_torn(std::size_t(triangles_.cols()), 0);
  for (const Edge& edge : smooth_) {
    const auto [a, b] = edge;
    if (normals.col(a).dot(normals.col(b)) < folded * 4 * areas[a] * areas[b])
      is_torn[std::size_t(areas[a] < areas[b] ? a : b)] = 1;
  }
  const Eigen::Vector3d least = Eigen::Vector3d::Constant(least_spread);
  const double growth =
      most_stretch *
      std::max(1., extent.spreads.cwiseMax(least).cwiseQuotient(extent_.spreads.cwiseMax(least)).maxCoeff());
  double result = 0;
  for (Eigen::Index t = 0; t < areas.size(); ++t)
    if (is_torn[std::size_t(t)] ||
        squared_longest_edge(triangle_of(points, triangles_, t)) > growth * growth * longest_[t])
      result += areas[t];
  return result;
}

Points Rest_surface::samples(const Points& points) const
{
  Points result(3, Eigen::Index(chosen_.size()));
  for (std::size_t i = 0; i < chosen_.size(); ++i)
    result.col(Eigen::Index(i)) = contacts::centre(triangle_of(points, triangles_, chosen_[i]));
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
