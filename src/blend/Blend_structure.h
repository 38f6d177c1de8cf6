// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_stage.h"
#include "blend/Growth.h"
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
  std::vector<std::optional<Growth>> growths; ///< for each part, defined if it is unmatched
  /// For each part, the least number of contacts from it to a part that carries others, since it morphs, corresponds
  /// without morphing, or stands on the ground: 0 for such a part, and 1 for one that is connected to none.
  std::vector<int> depths;
  std::array<std::optional<Space_warp>, 2> warps; ///< defined for ends with unmatched parts
  /// For each part, how it follows the warp of its end; defined if it is unmatched.
  std::vector<std::optional<Straight_motion>> motions;
  std::array<double, 2> supports; ///< numbers of parts on the ground

private:
  const Part_chart& chart_of(std::size_t unmatched) const;
  std::vector<Point> holds(std::size_t unmatched) const;
  Points contacts(std::size_t unmatched) const;
  void set_motions(int end);
};

} // namespace CGAL::Shape_correspondence::internal
