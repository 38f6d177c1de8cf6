// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/In_between_shape.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A measure of a shape, and the parts where it is worst.
struct Worst_parts
{
  double value = 0;
  std::array<std::size_t, 2> parts{}; ///< the same twice where it is a measure of one
};

/// What one sees of an in-between shape, as in `Blend_quality`.
struct Visible_quality
{
  Worst_parts thinning, area, volume, torn, overlap, wobble;
};

Visible_quality visible_quality(const In_between_shape& shape, const In_between_shape::Trees& trees);

/// What is over the tolerances of `Shape_blend`, in whole sentences.
std::vector<std::string> visible_faults(const Visible_quality& quality, const In_between_shape& shape);

/// A part's name, in quotes.
std::string quoted(const In_between_shape& shape, std::size_t part);

/// A number for a sentence.
std::string two_digits(double value);

} // namespace CGAL::Shape_correspondence::internal
