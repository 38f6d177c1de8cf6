// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "texture/vertex_colours.h"
#include "map/Subdivision.h"
#include "texture/Looks_sampler.h"

#include <CGAL/Shape_correspondence/transfer_appearance.h>

namespace CGAL::Shape_correspondence::internal {
namespace {

constexpr std::size_t most_triangles = 200000;

/// The looks of triangles that are numbered: the number as the material.
Part_appearance numbered(std::size_t triangles)
{
  Part_appearance result;
  for (std::size_t t = 0; t < triangles; ++t) {
    result.materials.push_back(int(t));
    for (const auto& corner : {Eigen::Vector2f(0, 0), Eigen::Vector2f(1, 0), Eigen::Vector2f(0, 1)})
      result.coordinates.push_back(corner);
  }
  return result;
}

} // namespace

Coloured_mesh coloured_mesh(const Part_mesh& mesh, const Shape_appearance& appearance, std::size_t part,
                            const Eigen::Vector3d& neutral, double longest_edge)
{
  Subdivision fine(mesh.points, mesh.triangles);
  while (fine.number_of_triangles() * 4 <= most_triangles && fine.split_edges([&](int a, int b) {
    return (fine.point(a) - fine.point(b)).norm() > longest_edge ? 0.5 : -1;
  })) {
  }
  Coloured_mesh result;
  result.mesh = {fine.points(), fine.triangles()};
  result.colours = neutral.replicate(1, result.mesh.points.cols());
  // Where each corner lies in the given triangles
  const Part_appearance places = appearance_on(mesh, numbered(std::size_t(mesh.triangles.cols())), result.mesh);
  result.triangle_given = places.materials;
  const Looks_sampler looks(appearance, neutral);
  for (Eigen::Index t = 0; t < result.mesh.triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector2d at = places.coordinates[std::size_t(3 * t + k)].cast<double>();
      const Eigen::Vector3d weights(1 - at.x() - at.y(), at.x(), at.y());
      result.colours.col(result.mesh.triangles(k, t)) =
          looks(part, std::size_t(result.triangle_given[std::size_t(t)]), weights);
    }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
