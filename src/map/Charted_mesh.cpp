// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map/Charted_mesh.h"

#include <Eigen/LU>

#include <algorithm>
#include <limits>

namespace CGAL::Shape_correspondence::internal {
namespace {

Eigen::Vector3d barycentric(const Point& p, const contacts::Triangle& t)
{
  const Point u = t[1] - t[0], v = t[2] - t[0], w = p - t[0];
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(), uw = u.dot(w), vw = v.dot(w);
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 1e-14 * uu * vv)) { // projects to the longest side of a needle
    const int far = uu >= vv ? 1 : 2;
    const double along = std::max(uu, vv) > 0 ? clamped_to_unit((far == 1 ? uw / uu : vw / vv)) : 0;
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    result[0] = 1 - along;
    result[far] = along;
    return result;
  }
  const double a = clamped_to_unit((vv * uw - uv * vw) / determinant);
  const double b = std::min(clamped_to_unit((uu * vw - uv * uw) / determinant), 1 - a);
  return {1 - a - b, a, b};
}

constexpr double facing = 0.5; // least cosine of a normal and a direction that it faces; each normal faces one at least

/// The six coordinate directions of a chart: +x, -x, +y, -y, +z, -z.
Point direction(std::size_t side) { return (side % 2 ? -1. : 1.) * Point::Unit(Eigen::Index(side / 2)); }

} // namespace

Charted_mesh charted_mesh(const Part_mesh& mesh, const Part_chart& chart, double longest_edge)
{
  constexpr std::size_t most_triangles = 20000; // limit beyond which a fine mesh is not subdivided
  constexpr int most_rounds = 8;
  Subdivision fine(mesh.points, mesh.triangles);
  std::vector<Point> k;
  bool changed = true;
  for (int round = 0; changed; ++round) {
    for (std::size_t i = k.size(); i < fine.number_of_points(); ++i)
      k.push_back(chart.coordinates(fine.point(int(i))));
    changed = round < most_rounds && fine.number_of_triangles() < most_triangles && fine.split_edges([&](int a, int b) {
      return (k[std::size_t(a)] - k[std::size_t(b)]).norm() > longest_edge ? 0.5 : -1;
    });
  }
  Charted_mesh result{fine.points(), fine.triangles(), {}, {}};
  result.coordinates.resize(3, result.points.cols());
  result.offsets.resize(3, result.points.cols());
  for (Eigen::Index i = 0; i < result.points.cols(); ++i) {
    const Point& at = k[std::size_t(i)];
    result.coordinates.col(i) = at;
    result.offsets.col(i) = chart.frame(at).inverse() * (result.points.col(i) - chart(at));
  }
  return result;
}

Charted_mesh finely_charted(const Part_mesh& mesh, Part_chart& chart, double longest_edge)
{
  const Charted_mesh result = charted_mesh(mesh, chart, longest_edge);
  chart = chart.centred(result.points);
  return charted_mesh({result.points, result.triangles}, chart, std::numeric_limits<double>::infinity());
}

Points chart_normals(const Charted_mesh& mesh)
{
  Points result = Points::Zero(3, mesh.coordinates.cols());
  const Point middle = mesh.coordinates.rowwise().mean();
  double outwards = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Eigen::Vector3i corners = mesh.triangles.col(t);
    const Point a = mesh.coordinates.col(corners[0]), b = mesh.coordinates.col(corners[1]);
    const Point c = mesh.coordinates.col(corners[2]), normal = (b - a).cross(c - a);
    outwards += normal.dot((a + b + c) / 3 - middle);
    for (int i = 0; i < 3; ++i)
      result.col(corners[i]) += normal;
  }
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const double length = result.col(i).norm();
    result.col(i) *= length > 1e-12 ? (outwards < 0 ? -1 : 1) / length : 0;
  }
  return result;
}

Mesh_place nearest_place(const contacts::Triangle_tree& tree, const Point& p)
{
  Point nearest = p;
  double squared = std::numeric_limits<double>::infinity();
  std::size_t triangle = 0;
  tree.improve_nearest(p, nearest, squared, triangle);
  return {Eigen::Index(tree.given_number(triangle)), barycentric(nearest, tree.triangles()[triangle])};
}

Place_finder::Place_finder(const Points& coordinates, const Eigen::Matrix3Xi& triangles, const Points& normals)
    : coordinates_(coordinates), triangles_(triangles), normals_(normals), all_(tree_of(coordinates, triangles))
{
  for (std::size_t side = 0; side < 6; ++side) {
    std::vector<contacts::Triangle> list;
    for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
      Point normal = Point::Zero();
      for (int i = 0; i < 3; ++i)
        normal += normals.col(triangles(i, t));
      if (normal.dot(direction(side)) < facing * normal.norm()) continue;
      list.push_back(triangle_of(coordinates, triangles, t));
      numbers_[side].push_back(t);
    }
    if (!list.empty()) facing_[side].emplace(std::move(list));
  }
}

Mesh_place Place_finder::operator()(const Point& p, const Point& normal) const
{
  constexpr double far = 1;       // distance in coordinates beyond which normals do not count
  constexpr double averse = -0.2; // cosine of normals below which they are on different sides of a part
  const Mesh_place nearest = nearest_place(all_, p);
  if (normal.dot(nearest.of(normals_, triangles_)) >= averse) return nearest;
  Mesh_place best = nearest;
  double least = far * far;
  for (std::size_t side = 0; side < 6; ++side) {
    if (!facing_[side] || normal.dot(direction(side)) < facing) continue;
    Mesh_place place = nearest_place(*facing_[side], p);
    place.triangle = numbers_[side][std::size_t(place.triangle)];
    const double squared = (place.of(coordinates_, triangles_) - p).squaredNorm();
    if (squared < least) least = squared, best = place;
  }
  return best;
}

} // namespace CGAL::Shape_correspondence::internal
