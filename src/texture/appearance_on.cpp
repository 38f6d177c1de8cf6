// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_parts.h"
#include "map/Charted_mesh.h"
#include "texture/Looks_sampler.h"

#include <CGAL/Shape_correspondence/transfer_appearance.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace CGAL::Shape_correspondence {
namespace {

using Corners = std::array<std::array<double, 3>, 3>;

/// The corners of a triangle in orientation order, the lexicographically least first, to compare triangles.
Corners corners_of(const Part_mesh& mesh, Eigen::Index t)
{
  Corners result;
  for (std::size_t k = 0; k < 3; ++k)
    std::copy_n(mesh.points.col(mesh.triangles(Eigen::Index(k), t)).data(), 3, result[k].data());
  std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
  return result;
}

/// Barycentric coordinates of the projection of a point to the plane of a triangle, also outside of the triangle.
Eigen::Vector3d plane_coordinates(const Point& p, const internal::contacts::Triangle& triangle)
{
  const auto& [a, b, c] = triangle;
  const Point normal = internal::contacts::area_vector(triangle);
  const double squared = normal.squaredNorm();
  if (!(squared > 0)) return {1, 0, 0};
  const double of_a = (c - b).cross(p - b).dot(normal) / squared, of_b = (a - c).cross(p - c).dot(normal) / squared;
  return {of_a, of_b, 1 - of_a - of_b};
}

} // namespace

Part_appearance appearance_on(const Part_mesh& mesh, const Part_appearance& appearance, const Part_mesh& on_it)
{
  Part_appearance result;
  if (appearance.empty() || mesh.triangles.cols() == 0) return result;
  const internal::contacts::Triangle_tree tree = internal::tree_of(mesh.points, mesh.triangles);
  std::map<Corners, Eigen::Index> known;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    known.emplace(corners_of(mesh, t), t);
  for (Eigen::Index t = 0; t < on_it.triangles.cols(); ++t) {
    const auto same = known.find(corners_of(on_it, t));
    const Eigen::Index lies_on =
        same != known.end()
            ? same->second
            : internal::nearest_place(tree, internal::contacts::centre(internal::triangle_of(on_it, t))).triangle;
    const auto triangle = std::size_t(lies_on);
    if (!appearance.materials.empty()) result.materials.push_back(appearance.materials[triangle]);
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d weights =
          plane_coordinates(on_it.points.col(on_it.triangles(k, t)), internal::triangle_of(mesh, lies_on));
      if (!appearance.coordinates.empty())
        result.coordinates.push_back(internal::value_at<float>(appearance.coordinates, triangle, weights));
      if (appearance.colours.empty()) continue;
      const Eigen::Vector3d inside = weights.cwiseMax(0) / weights.cwiseMax(0).sum();
      result.colours.push_back(internal::value_at<float>(appearance.colours, triangle, inside));
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
