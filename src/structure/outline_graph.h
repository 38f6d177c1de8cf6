// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <array>
#include <cstddef>
#include <set>

namespace CGAL::Shape_correspondence::internal {

/// A structural graph for uses that need only the surfaces of parts, such as roles. It saves abstraction, which takes
/// most time: every part is a group, abstracted by the diagonal of its bounding box.
Structural_graph outline_graph(const Segmented_shape& shape);
/// \param shape with canonical surfaces \param touching pairs of parts that are in contact
Structural_graph outline_graph(const Segmented_shape& shape, const Shape_frame& frame,
                               const std::set<std::array<std::size_t, 2>>& touching);

} // namespace CGAL::Shape_correspondence::internal
