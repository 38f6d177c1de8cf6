// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Shape_appearance.h>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A mesh with a colour of every vertex.
struct Coloured_mesh
{
  Part_mesh mesh;
  Points colours;                  ///< linear, a vertex a column
  std::vector<int> triangle_given; ///< by triangle, the one that it is a piece of
};

/// A part whose triangles are divided until no edge is longer than `longest_edge`, as far as that makes at most 200 000
/// of them, with its textures as colours of the vertices. \pre the textures are decoded
Coloured_mesh coloured_mesh(const Part_mesh& mesh, const Shape_appearance& appearance, std::size_t part,
                            const Eigen::Vector3d& neutral, double longest_edge);

} // namespace CGAL::Shape_correspondence::internal
