// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/hull.h"
#include "abstraction/bounding_box.h"
#include "base/eigen_system.h"
#include "base/planar_hull.h"
#include "shape/convex_hull_mesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Hull vertices of points that lie in a plane: those of the rectangle or polygon in it.
Convex_hull flat_hull(const Points& points, const Oriented_box& box)
{
  Planar_points flat;
  const Points turned = box.axes.transpose() * (points.colwise() - box.centre);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    flat.push_back(turned.col(i).head<2>());
  }
  const Planar_points outline = planar_hull(flat);
  Convex_hull result;
  result.vertices.resize(3, static_cast<Eigen::Index>(outline.size()));
  for (std::size_t i = 0; i < outline.size(); ++i) {
    result.vertices.col(static_cast<Eigen::Index>(i)) = box.centre + box.axes.leftCols<2>() * outline[i];
  }
  return result;
}

/// The thinnest direction of points decides whether they are flat: a hull of rounding noise has no volume.
Oriented_box thinnest_box(const Points& points)
{
  const Points centred = points.colwise() - points.rowwise().mean();
  return box_along(points, eigen_system(scatter_matrix(centred)).vectors);
}

/// The vertices of a hull and its volume, both from a sorted mesh: the algorithm's output is ordered by addresses.
Convex_hull measured_hull(const Halfedge_mesh& mesh)
{
  using Key = std::array<double, 3>;
  const auto key = [&](Halfedge_mesh::Vertex_index v) {
    return Key{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()};
  };
  std::map<Key, int> order;
  for (auto v : mesh.vertices()) {
    order[key(v)] = 0;
  }
  Convex_hull result;
  result.vertices.resize(3, static_cast<Eigen::Index>(order.size()));
  int count = 0;
  for (auto& [position, index] : order) {
    result.vertices.col(count) << position[0], position[1], position[2];
    index = count++;
  }
  std::vector<std::vector<int>> faces;
  for (auto f : mesh.faces()) {
    faces.emplace_back();
    for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) {
      faces.back().push_back(order.at(key(v)));
    }
    std::rotate(faces.back().begin(), std::min_element(faces.back().begin(), faces.back().end()), faces.back().end());
  }
  std::sort(faces.begin(), faces.end());
  const Point apex = result.vertices.col(0);
  for (const auto& face : faces) {
    for (std::size_t k = 2; k < face.size(); ++k) {
      const Point a = result.vertices.col(face[0]) - apex, b = result.vertices.col(face[k - 1]) - apex,
                  c = result.vertices.col(face[k]) - apex;
      result.volume += a.dot(b.cross(c)) / 6;
    }
  }
  result.volume = std::abs(result.volume);
  return result;
}

} // namespace

Convex_hull convex_hull(const Points& points)
{
  const double thinnest = 1e-6;
  if (points.cols() == 0) {
    return {};
  }
  const Oriented_box box = thinnest_box(points);
  if (box.extents[2] <= thinnest * box.extents[0]) {
    return flat_hull(points, box);
  }
  return measured_hull(convex_hull_mesh(points));
}

} // namespace CGAL::Shape_correspondence::internal
