// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "texture/Texture_layout.h"

#include <functional>

namespace CGAL::Shape_correspondence::internal {

/// The linear colour of a point of a part's triangle, by barycentric coordinates. Called from several threads.
using Colour_of_point =
    std::function<Eigen::Vector3d(std::size_t part, std::size_t triangle, const Eigen::Vector3d& weights)>;

/// Paints the triangles of a layout into a picture; every pixel is the mean of `samples`² points. Colours go on past
/// the borders of triangles by `margin` pixels; all other pixels have the colour `background`.
Image bake(const Texture_layout& layout, int size, int margin, int samples, const Eigen::Vector3d& background,
           const Colour_of_point& colour);

} // namespace CGAL::Shape_correspondence::internal
