// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_stage.h"
#include "blend/Seen_surface.h"
#include "blend/Space_warp.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Two parts of a blend that touch at one of the ends or at both.
using Touch = std::array<std::size_t, 2>;

/// The structure of a blend: its parts, which of them touch, and properties of both shapes. Lengths are relative to the
/// height, on the stage; arrays are indexed by end.
class Blend_structure
{
public:
  Blend_structure(const std::array<Blend_input, 2>& inputs, const Correspondence& correspondence,
                  const Blend_options& options);

  Blend_stage stage;
  std::vector<Blend_part> parts; ///< the matched parts come first
  Part_pairs unlike;             ///< pairs of the given parts that correspond but do not morph
  std::vector<Touch> touches;
  std::vector<Point> roots;                       ///< for each part, the point that it shrinks to if it is unmatched
  std::array<std::optional<Space_warp>, 2> warps; ///< defined for ends with unmatched parts
  std::array<double, 2> supports;                 ///< numbers of parts on the ground

  /// The points of an unmatched part scaled about its root by `remaining`, in [0, 1].
  Points shrunk(std::size_t part, double remaining) const
  {
    return (remaining * (parts[part].mesh.points.colwise() - roots[part])).colwise() + roots[part];
  }
};

} // namespace CGAL::Shape_correspondence::internal
