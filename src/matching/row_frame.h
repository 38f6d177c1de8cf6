// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "matching/Shape_layout.h"

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

constexpr std::size_t no_part = std::size_t(-1);

// Is the group a row of `minimum_repetition` parts or more?
bool is_row(const Part_group& group);

// The parts of a row and its frame (the rails and posts around slats): the connected parts in its plane, farther and
// farther away. \param main_surface the part that is the shape's main surface, or `no_part`
std::vector<std::size_t> row_with_frame(const std::vector<std::size_t>& row, const Aligned_shape& shape,
                                        const Shape_layout& layout, std::size_t main_surface,
                                        const std::vector<char>& is_in_chain);

} // namespace CGAL::Shape_correspondence::internal
