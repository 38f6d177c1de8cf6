// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/clamped.h"

#include <cmath>

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
