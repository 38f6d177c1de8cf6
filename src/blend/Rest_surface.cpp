// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Rest_surface.h"

#include "base/eigen_system.h"
#include "blend/Surface_smoother.h"

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
    const Point a = points.col(triangles(0, t)), b = points.col(triangles(1, t)), c = points.col(triangles(2, t));
    result.col(t) = (b - a).cross(c - a);
  }
  return result;
}

double squared_longest_edge(const Points& points, const Eigen::Vector3i& corners)
{
  const Point a = points.col(corners[0]), b = points.col(corners[1]), c = points.col(corners[2]);
  return std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
}

} // namespace

Rest_surface::Rest_surface(const Points& points, const Eigen::Matrix3Xi& triangles)
    : triangles_(triangles), longest_(triangles.cols())
{
  constexpr double smooth = 0.5; // cosine of the angle between normals
  find_edges(points);
  extent_ = extent(points);
  const Points normals = doubled_normals(points, triangles_).colwise().normalized();
  const auto turns = [&](const Edge& edge) { return normals.col(edge.from).dot(normals.col(edge.to)) < smooth; };
  smooth_.erase(std::remove_if(smooth_.begin(), smooth_.end(), turns), smooth_.end());
  for (Eigen::Index t = 0; t < triangles_.cols(); ++t)
    longest_[t] = squared_longest_edge(points, triangles_.col(t));
  constexpr int samples = 24;
  const Eigen::VectorXd areas = doubled_normals(points, triangles_).colwise().norm();
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
    const Point centre =
        (points.col(triangles_(0, t)) + points.col(triangles_(1, t)) + points.col(triangles_(2, t))) / 3 - middle;
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
    const double cosine = normals.col(edge.from).dot(normals.col(edge.to));
    if (cosine < folded * 4 * areas[edge.from] * areas[edge.to])
      is_torn[std::size_t(areas[edge.from] < areas[edge.to] ? edge.from : edge.to)] = 1;
  }
  const Eigen::Vector3d least = Eigen::Vector3d::Constant(least_spread);
  const double growth =
      most_stretch *
      std::max(1., extent.spreads.cwiseMax(least).cwiseQuotient(extent_.spreads.cwiseMax(least)).maxCoeff());
  double result = 0;
  for (Eigen::Index t = 0; t < areas.size(); ++t)
    if (is_torn[std::size_t(t)] || squared_longest_edge(points, triangles_.col(t)) > growth * growth * longest_[t])
      result += areas[t];
  return result;
}

Points Rest_surface::samples(const Points& points) const
{
  Points result(3, Eigen::Index(chosen_.size()));
  for (std::size_t i = 0; i < chosen_.size(); ++i) {
    const auto corners = triangles_.col(chosen_[i]);
    result.col(Eigen::Index(i)) = (points.col(corners[0]) + points.col(corners[1]) + points.col(corners[2])) / 3;
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
