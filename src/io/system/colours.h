// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/clamped.h"

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The conversion of an sRGB channel to linear light, clamped to [0, 1], and its inverse (IEC 61966-2-1).
inline double linear_of_srgb(double srgb)
{
  const double x = clamped_to_unit(srgb);
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

inline double srgb_of_linear(double linear)
{
  const double x = clamped_to_unit(linear);
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

} // namespace CGAL::Shape_correspondence::internal

namespace CGAL::Shape_correspondence::IO {

/// Linear red, green and blue in [0, 1], as in glTF.
using Colour = Eigen::Vector3d;

/// `n` colours as different as possible, the first ones most, also with red-green colour blindness; none is grey.
std::vector<Colour> distinct_colours(std::size_t n);

/// The colours of things by their roles: the first thing of a role has the colour of the role, which is the same in all
/// pictures, and further ones have shades of it. Things without a role have colours that are as different as possible.
std::vector<Colour> colours_of_roles(const std::vector<std::string>& roles);

/// The colour of a role, which other roles of its category do not have.
Colour role_colour(const std::string& role);

/// The colour in the notation of style sheets: #rrggbb in sRGB.
std::string css_colour(const Colour& linear);

/// The conversion of an sRGB colour to linear light, clamped to [0, 1], and its inverse.
inline Colour linear_colour(const Colour& srgb) { return srgb.unaryExpr(&internal::linear_of_srgb); }
inline Colour srgb_colour(const Colour& linear) { return linear.unaryExpr(&internal::srgb_of_linear); }

inline Colour grey() { return Colour(0.45, 0.45, 0.45); }

} // namespace CGAL::Shape_correspondence::IO
