// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_parts.h"
#include "shape/first_in_place.h"
#include "shape/meshes.h"

namespace CGAL::Shape_correspondence::IO {

Part_mesh weld(const std::vector<Point>& corners, std::vector<std::size_t>* kept)
{
  const double* coordinates = corners.empty() ? nullptr : corners[0].data();
  const Eigen::Map<const Points> points(coordinates, 3, Eigen::Index(corners.size()));
  const std::vector<int> first = internal::first_in_place(points);
  std::vector<int> vertex(corners.size(), -1);
  std::vector<int> used; // corner that stands for each vertex
  std::vector<int> triangles;
  for (std::size_t t = 0; t + 2 < corners.size(); t += 3) {
    const Eigen::Vector3i c(first[t], first[t + 1], first[t + 2]);
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
    if (kept) kept->push_back(t / 3);
    for (int corner : c) {
      if (vertex[corner] < 0) {
        vertex[corner] = static_cast<int>(used.size());
        used.push_back(corner);
      }
      triangles.push_back(vertex[corner]);
    }
  }
  Part_mesh mesh;
  mesh.points = points(Eigen::indexing::all, used);
  mesh.triangles = Eigen::Map<const Eigen::Matrix3Xi>(triangles.data(), 3, Eigen::Index(triangles.size() / 3));
  return mesh;
}

Part_appearance looks_of(const Part_appearance& all, const std::vector<std::size_t>& triangles)
{
  const std::size_t needed = triangles.empty() ? 1 : triangles.back() + 1; // of attributes that the file has
  Part_appearance result;
  for (std::size_t t : triangles) {
    if (all.materials.size() >= needed) result.materials.push_back(all.materials[t]);
    for (std::size_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
      if (all.coordinates.size() >= 3 * needed) result.coordinates.push_back(all.coordinates[corner]);
      if (all.colours.size() >= 3 * needed) result.colours.push_back(all.colours[corner]);
    }
  }
  return result;
}

void add_looks(const Part_appearance& more, std::size_t more_triangles, std::size_t triangles, Part_appearance& all)
{
  const auto append = [](auto& to, std::size_t before, const auto& from, std::size_t count, const auto& none) {
    if (to.empty() && from.empty()) return;
    to.resize(before, none);
    to.insert(to.end(), from.begin(), from.end());
    to.resize(before + count, none);
  };
  append(all.materials, triangles, more.materials, more_triangles, -1);
  append(all.coordinates, 3 * triangles, more.coordinates, 3 * more_triangles, Eigen::Vector2f(0, 0));
  append(all.colours, 3 * triangles, more.colours, 3 * more_triangles, Eigen::Vector3f(1, 1, 1));
}

std::pair<Part_mesh, Part_appearance> joined_parts(const Segmented_shape& shape, const Shape_appearance& appearance,
                                                   const std::vector<std::size_t>& parts)
{
  std::vector<const Part_mesh*> meshes;
  std::size_t triangles = 0;
  Part_appearance looks;
  for (std::size_t part : parts) {
    meshes.push_back(&shape.parts()[part].mesh);
    const auto more = std::size_t(meshes.back()->triangles.cols());
    add_looks(part < appearance.parts.size() ? appearance.parts[part] : Part_appearance(), more, triangles, looks);
    triangles += more;
  }
  return {internal::joined(meshes), std::move(looks)};
}

} // namespace CGAL::Shape_correspondence::IO
