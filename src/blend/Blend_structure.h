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

/// Two parts of a blend that touch at an end, or at both.
using Touch = std::array<std::size_t, 2>;

/// What a blend is made of: its parts, which of them touch and go together, and what both shapes have at large. Lengths
/// are over the height, on the stage; arrays are by end.
class Blend_structure
{
public:
  Blend_structure(const std::array<Blend_input, 2>& inputs, const Correspondence& correspondence,
                  const Blend_options& options);

  Blend_stage stage;
  std::vector<Blend_part> parts; ///< those that are matched come first
  Part_pairs unlike;             ///< pairs of the given parts that correspond but do not morph
  std::vector<Touch> touches;
  std::vector<Point> roots;                       ///< by part, if it is not matched: what it shrinks to
  std::array<std::optional<Space_warp>, 2> warps; ///< where there are unmatched parts
  std::array<double, 2> supports;                 ///< number of parts on the ground

  /// The points of an unmatched part when a share of it remains, in [0, 1].
  Points shrunk(std::size_t part, double remaining) const
  {
    return (remaining * (parts[part].mesh.points.colwise() - roots[part])).colwise() + roots[part];
  }
};

} // namespace CGAL::Shape_correspondence::internal
