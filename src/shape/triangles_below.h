// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// For each triangle of `on_it`, a mesh on the surface of `mesh`, such as a piece of it: the triangle of `mesh` with
/// the same corners, or else the one nearest to its centre. O(n log n).
/// \pre `mesh` has a triangle
std::vector<std::size_t> triangles_below(const Part_mesh& mesh, const Part_mesh& on_it);

} // namespace CGAL::Shape_correspondence::internal
