// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"
#include "blend/End_look.h"
#include "blend/contact_constraints.h"

#include <CGAL/Shape_correspondence/Shape_frame.h>

#include <array>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// What a blend is made of, whatever its schedule: its parts, the contacts that are to be kept, and what both shapes
/// have at large. Lengths are over the height, in the common frame of both shapes; arrays are by end.
class Blend_structure
{
public:
  Blend_structure(const std::array<Blend_input, 2>& inputs, const Correspondence& correspondence,
                  const Blend_options& options);

  std::array<Segmented_shape, 2> shapes; ///< as they are given, or of the size that is asked for
  std::vector<Blend_part> parts;
  std::vector<Contact_constraint> contacts;
  bool is_symmetric = false;           ///< both shapes have the mirror plane x = 0
  std::array<double, 2> end_asymmetry; ///< `Blend_quality::asymmetry`
  std::array<double, 2> ground;        ///< its height
  std::array<double, 2> widest_gap;    ///< that it takes to join all parts
  std::vector<End_look> looks;         ///< by end

  /// From the common frame to the place that the shape has at `t`: its size changes by equal factors in equal times,
  /// as if it were scaled about a point in space.
  Points to_world(const Points& points, double t) const;
  Point up(double t) const;

private:
  Blend_structure(const std::array<Blend_input, 2>& inputs, const Blend_ends& ends,
                  const Correspondence& correspondence, const Blend_options& options);
  void set_size(Blend_size size);

  std::array<Shape_frame, 2> frames_; ///< turned so that both shapes look alike
};

} // namespace CGAL::Shape_correspondence::internal
