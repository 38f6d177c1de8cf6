// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/srgb.h"

#include <Eigen/Core>

#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// Linear red, green and blue in [0, 1], as in glTF.
using Colour = Eigen::Vector3d;

/// `n` colours as different as possible, the first ones most, also with red-green colour blindness; none is grey.
std::vector<Colour> distinct_colours(std::size_t n);

/// The conversion of an sRGB colour to linear light, clamped to [0, 1], and its inverse.
inline Colour linear_colour(const Colour& srgb) { return srgb.unaryExpr(&internal::linear_of_srgb); }
inline Colour srgb_colour(const Colour& linear) { return linear.unaryExpr(&internal::srgb_of_linear); }

inline Colour grey() { return Colour(0.45, 0.45, 0.45); }

} // namespace CGAL::Shape_correspondence::IO
