// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Rest_surface.h"

#include "shape/first_in_place.h"
#include "shape/triangle_distance.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Normals of triangles, of length twice the area.
Points doubled_normals(const Points& points, const Eigen::Matrix3Xi& triangles)
{
  Points result(3, triangles.cols());
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    result.col(t) = contacts::area_vector(triangle_of(points, triangles, t));
  return result;
}

double squared_longest_edge(const contacts::Triangle& corners)
{
  const auto& [a, b, c] = corners;
  return std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
}

/// Extents of the bounding box of points, at least `least`.
Point sizes_of(const Points& points)
{
  constexpr double least = 1e-4; // ratio to the shape's height
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).cwiseMax(least);
}

} // namespace

Rest_surface::Rest_surface(const Points& points, const Eigen::Matrix3Xi& triangles)
    : triangles_(triangles), sizes_(sizes_of(points)), longest_(triangles.cols())
{
  constexpr double smooth = 0.5; // cosine of the angle between normals
  constexpr int samples = 24;
  const Points normals = doubled_normals(points, triangles_);
  const Eigen::VectorXd areas = normals.colwise().norm();
  const std::vector<int> places = first_in_place(points);
  std::map<std::pair<int, int>, std::vector<int>>
      sides; // triangles at each edge, by the vertices of the edge, with coincident vertices merged
  double passed = 0, next = 0;
  for (int t = 0; t < int(triangles_.cols()); ++t) {
    longest_[t] = squared_longest_edge(triangle_of(points, triangles_, t));
    for (passed += areas[t]; next < passed; next += areas.sum() / samples)
      chosen_.push_back(t);
    for (int i = 0; i < 3; ++i) {
      const int a = places[std::size_t(triangles_(i, t))], b = places[std::size_t(triangles_((i + 1) % 3, t))];
      sides[std::minmax(a, b)].push_back(t);
    }
  }
  for (const auto& [edge, there] : sides) {
    if (there.size() != 2) continue;
    const int a = there[0], b = there[1];
    if (normals.col(a).dot(normals.col(b)) >= smooth * areas[a] * areas[b]) smooth_.push_back({a, b});
  }
}

double Rest_surface::area(const Points& points) const
{
  double result = 0; // summed one by one: the order of Eigen's sum depends on the processor
  for (Eigen::Index t = 0; t < triangles_.cols(); ++t)
    result += contacts::area_vector(triangle_of(points, triangles_, t)).norm() / 2;
  return result;
}

double Rest_surface::torn_area(const Points& points) const
{
  constexpr double folded = -0.5;    // cosine of the angle between normals
  constexpr double most_stretch = 3; // stretch of an edge, over that of the whole surface
  const Points normals = doubled_normals(points, triangles_);
  const Eigen::VectorXd areas = normals.colwise().norm(); // twice the areas
  std::vector<char> is_torn(std::size_t(triangles_.cols()), 0);
  for (const auto& [a, b] : smooth_)
    if (normals.col(a).dot(normals.col(b)) < folded * areas[a] * areas[b])
      is_torn[std::size_t(areas[a] < areas[b] ? a : b)] = 1;
  const double growth = sizes_of(points).cwiseQuotient(sizes_).maxCoeff(), most = most_stretch * std::max(1., growth);
  double result = 0;
  for (Eigen::Index t = 0; t < areas.size(); ++t)
    if (is_torn[std::size_t(t)] || squared_longest_edge(triangle_of(points, triangles_, t)) > most * most * longest_[t])
      result += areas[t] / 2;
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
