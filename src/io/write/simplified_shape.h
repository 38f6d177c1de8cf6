// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <cstddef>

namespace CGAL::Shape_correspondence::IO {

/// The shape with fewer triangles, for pictures: edges are collapsed as in Lindstrom and Turk 1998, and every part
/// keeps its share of the triangles.
/// \param most_triangles about as many are left; a part keeps those that give it a shape, though
Segmented_shape simplified_shape(const Segmented_shape& shape, std::size_t most_triangles);

/// The number of its triangles.
std::size_t number_of_triangles(const Segmented_shape& shape);

} // namespace CGAL::Shape_correspondence::IO
