// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_parts.h"
#include "shape/Triangle_tree.h"

#include <CGAL/Shape_correspondence/transfer_appearance.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace CGAL::Shape_correspondence {
namespace {

using Corners = std::array<double, 9>;

/// The corners of a triangle, the least first, in their order: equal for equal triangles of one orientation.
Corners corners_of(const Part_mesh& mesh, Eigen::Index t, int& first)
{
  const auto point = [&](int k) { return mesh.points.col(mesh.triangles(k % 3, t)); };
  const auto is_less = [&](int a, int b) {
    const auto p = point(a), q = point(b);
    return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
  };
  first = 0;
  for (int k : {1, 2})
    if (is_less(k, first)) first = k;
  Corners result;
  for (std::ptrdiff_t k = 0; k < 3; ++k)
    std::copy_n(point(first + int(k)).data(), 3, result.data() + 3 * k);
  return result;
}

/// Barycentric coordinates in the plane of a triangle, also outside of it.
Eigen::Vector3d plane_coordinates(const Point& p, const internal::contacts::Triangle& triangle)
{
  const auto& [a, b, c] = triangle;
  const Point normal = internal::contacts::area_vector(triangle);
  const double squared = normal.squaredNorm();
  if (!(squared > 0)) return {1, 0, 0};
  const double of_a = (c - b).cross(p - b).dot(normal) / squared, of_b = (a - c).cross(p - c).dot(normal) / squared;
  return {of_a, of_b, 1 - of_a - of_b};
}

template <typename Vector>
Vector mean_of(const std::vector<Vector>& values, std::size_t triangle, const Eigen::Vector3d& weights)
{
  Vector result = Vector::Zero();
  for (std::size_t k = 0; k < 3; ++k)
    result += float(weights[Eigen::Index(k)]) * values[3 * triangle + k];
  return result;
}

/// Finds the triangle of a mesh that another one lies on: itself, or the nearest one.
class Triangle_finder
{
public:
  explicit Triangle_finder(const Part_mesh& mesh) : tree_(internal::tree_of(mesh.points, mesh.triangles))
  {
    for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
      int first = 0;
      const Corners corners = corners_of(mesh, t, first);
      known_.emplace(corners, t);
    }
  }

  Eigen::Index operator()(const Part_mesh& other, Eigen::Index t) const
  {
    int first = 0;
    const auto found = known_.find(corners_of(other, t, first));
    if (found != known_.end()) return found->second;
    const internal::contacts::Triangle corners = internal::triangle_of(other, t);
    const Point middle = (corners[0] + corners[1] + corners[2]) / 3;
    Point nearest = middle;
    double squared = std::numeric_limits<double>::infinity();
    std::size_t triangle = 0;
    tree_.improve_nearest(middle, nearest, squared, triangle);
    return Eigen::Index(tree_.given_number(triangle));
  }

private:
  internal::contacts::Triangle_tree tree_;
  std::map<Corners, Eigen::Index> known_;
};

} // namespace

Part_appearance appearance_on(const Part_mesh& mesh, const Part_appearance& appearance, const Part_mesh& on_it)
{
  Part_appearance result;
  if (appearance.empty() || mesh.triangles.cols() == 0) return result;
  const Triangle_finder finder(mesh);
  for (Eigen::Index t = 0; t < on_it.triangles.cols(); ++t) {
    const Eigen::Index found = finder(on_it, t);
    const auto triangle = std::size_t(found);
    const internal::contacts::Triangle corners = internal::triangle_of(mesh, found);
    if (!appearance.materials.empty()) result.materials.push_back(appearance.materials[triangle]);
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d weights = plane_coordinates(on_it.points.col(on_it.triangles(k, t)), corners);
      if (!appearance.coordinates.empty())
        result.coordinates.push_back(mean_of(appearance.coordinates, triangle, weights));
      if (appearance.colours.empty()) continue;
      const Eigen::Vector3d inside = weights.cwiseMax(0) / weights.cwiseMax(0).sum();
      result.colours.push_back(mean_of(appearance.colours, triangle, inside));
    }
  }
  return result;
}

Shape_appearance appearance_of_parts(const Segmented_shape& objects, const Shape_appearance& appearance,
                                     const Part_split& split)
{
  Shape_appearance result{appearance.materials, appearance.textures, {}, appearance.warnings};
  result.parts.resize(split.shape.parts().size());
  if (appearance.parts.empty()) return result;
  std::vector<std::set<std::size_t>> objects_of(result.parts.size());
  for (const Model_piece& piece : split.pieces)
    if (piece.part != no_part) objects_of[piece.part].insert(piece.object);
  for (std::size_t part = 0; part < result.parts.size(); ++part) {
    const auto [mesh, looks] =
        IO::joined_parts(objects, appearance, {objects_of[part].begin(), objects_of[part].end()});
    result.parts[part] = appearance_on(mesh, looks, split.shape.parts()[part].mesh);
  }
  return result;
}

} // namespace CGAL::Shape_correspondence
