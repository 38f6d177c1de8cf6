// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_stage.h"
#include "blend/Space_warp.h"
#include "map/Part_chart.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// How an unmatched part comes and goes: it grows from the line through the places where it is held, along its own
/// curve or sheet, and is soon as thick as it will be.
class Growth
{
public:
  /// \param chart the chart of the part
  /// \param holds where it is held, at least one place
  Growth(const Part_chart& chart, const Points& points, const std::vector<Point>& holds);

  /// The points when a share, in [0, 1], has grown.
  Points points(double share) const;

private:
  Point from(double at) const;

  Part_chart chart_;
  Points points_;
  Points coordinates_, offsets_; ///< in the chart, and from there to the points in the chart's frames
  int axis_ = 0;                 ///< coordinate along which the places are farthest apart
  std::vector<Point> stations_;  ///< coordinates of the line's ends and bends, sorted along the axis
};

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
  /// For each part, the number of parts between it and what carries it: what morphs, is exchanged, or stands on the
  /// ground.
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
