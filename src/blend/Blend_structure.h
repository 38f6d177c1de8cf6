// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"
#include "blend/Blend_stage.h"
#include "blend/End_look.h"
#include "blend/contacts_to_keep.h"

#include <array>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// What a blend is made of, whatever its schedule: its parts, the contacts that are to be kept, and what both shapes
/// have at large. Lengths are over the height, on the stage; arrays are by end.
class Blend_structure
{
public:
  Blend_structure(const std::array<Blend_input, 2>& inputs, const Correspondence& correspondence,
                  const Blend_options& options);

  std::array<Segmented_shape, 2> shapes; ///< in the world, moved onto the stage
  std::vector<Blend_part> parts;
  std::vector<Kept_contact> contacts;
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
