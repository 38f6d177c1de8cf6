// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Charted_mesh.h"
#include "map/Piece_pair.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <array>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The vertices that represent the surfaces of a shape's parts.
std::vector<const Points*> mesh_surfaces(const Segmented_shape& shape);

/// The entire surfaces of both parts of a pair, in the charts between which their pieces are mapped.
struct Surface_pair
{
  Pair_charts charts;
  std::array<Charted_mesh, 2> meshes; ///< with the triangles and vertices of the parts
};

Surface_pair surface_pair(const Piece_pair& pair, const std::array<Charted_shape, 2>& shapes,
                          const std::array<const Part_mesh*, 2>& meshes);

} // namespace CGAL::Shape_correspondence::internal
