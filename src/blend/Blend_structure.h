// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"
#include "blend/Blend_stage.h"
#include "blend/Space_warp.h"
#include "blend/Unmatched_chain.h"
#include "blend/touches.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// By two parts, the share of the first one's surface that is inside the second one.
using Overlaps = std::map<std::array<std::size_t, 2>, double>;

/// A part's surface, to find what is inside of it.
struct Seen_surface
{
  std::size_t part;
  Points samples; ///< evenly over it
  const contacts::Triangle_tree* tree;
  bool is_closed;
  bool looks_outwards; ///< its triangles
};

/// The overlaps of closed parts, those that are 0 left out.
Overlaps overlaps_of(const std::vector<Seen_surface>& surfaces);

/// The volume of the convex hull of surfaces; 0 of what is flat.
double hull_volume(const std::vector<const Points*>& surfaces);

/// What shapes in between are compared with at an end.
struct End_look
{
  End_look(const std::vector<Blend_part>& parts, int end);

  double volume = 0;   ///< of closed parts
  double hull = 0;     ///< volume of the convex hull
  double supports = 0; ///< number of parts that stand on the ground
  Overlaps overlaps;
};

/// What a blend is made of: its parts, which of them touch and go together, and what both shapes have at large. Lengths
/// are over the height, on the stage; arrays are by end.
class Blend_structure
{
public:
  Blend_structure(const std::array<Blend_input, 2>& inputs, const Correspondence& correspondence,
                  const Blend_options& options);

  std::array<Segmented_shape, 2> shapes; ///< in the world, moved onto the stage
  std::vector<Blend_part> parts;
  std::vector<Touch> touches;
  std::array<std::optional<Space_warp>, 2> warps; ///< where there are unmatched parts
  std::vector<Unmatched_chain> chains;
  std::vector<std::size_t> groups;              ///< by part: parts of one group come and go at one time
  bool is_symmetric = false;                    ///< both shapes have the mirror plane x = 0
  std::array<contacts::Box, 2> boxes;           ///< of the shapes
  std::array<double, 2> end_asymmetry = {0, 0}; ///< `Blend_quality::asymmetry`
  std::array<double, 2> widest_gap;             ///< that it takes to join all parts
  std::vector<End_look> looks;                  ///< by end

  /// From the stage to the world when a share of the change of size is done: sizes change by equal factors in equal
  /// times.
  Points to_world(const Points& points, double done) const;

private:
  Blend_structure(const std::array<Blend_input, 2>& inputs, const Blend_stage& stage,
                  const Correspondence& correspondence, const Blend_options& options);

  Eigen::Matrix3d axes_; ///< of the stage in the world
  std::array<double, 2> heights_;
};

} // namespace CGAL::Shape_correspondence::internal
