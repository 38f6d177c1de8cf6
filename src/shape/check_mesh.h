// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <string>

namespace CGAL::Shape_correspondence::internal {

/// Throws `Invalid_input`, naming the part, if a coordinate is not finite or beyond 1e15, an index is not that of a
/// vertex, or a vertex has more than `most_triangles_of_vertex` triangles.
void check_triangles(const std::string& part, const Part_mesh& mesh);

/// Checks the same, and throws `Invalid_input`, too, if the mesh has no area.
void check_mesh(const std::string& part, const Part_mesh& mesh);

} // namespace CGAL::Shape_correspondence::internal
