// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "texture/raster.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Shape_appearance.h>

#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Where the triangles of all parts lie in a square picture, in pixels, by part and triangle.
using Texture_layout = std::vector<std::vector<Flat_triangle>>;

/// The layout by the texture coordinates of a shape; none if a part has none, they are outside of [0, 1], or triangles
/// overlap, so that a pixel would have to have several colours.
std::optional<Texture_layout> given_layout(const Segmented_shape& shape, const Shape_appearance& appearance, int size);

/// A new layout: charts of connected triangles that face alike along the axes of `frame`, a rotation; projected along
/// them, and packed at one scale, `margin` pixels from each other's margins.
Texture_layout new_layout(const Segmented_shape& shape, const Eigen::Matrix3d& frame, int size, int margin);

} // namespace CGAL::Shape_correspondence::internal
