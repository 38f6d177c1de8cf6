// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Chart_outline.h"
#include "map/Piece_pair.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <array>
#include <cstddef>

namespace CGAL::Shape_correspondence::internal {

/// Straight charts of the boxes of two surfaces. A box has the axes of the world unless a part's own ones make it much
/// smaller; axes are paired for the least rotation over the symmetries of boxes.
/// \param own_axes of the surfaces, rotations
Pair_charts pair_boxes(const std::array<const Points*, 2>& surfaces, const std::array<Eigen::Matrix3d, 2>& own_axes);

/// How the surface of a part becomes that of its counterpart. There is one surface at any time, first that of the
/// source, then that of the target: both ends are exact, and closed if the inputs are.
///
/// The source's surface, in coordinates of its chart relative to the part's outline there, moves onto the target's,
/// smoothly over the surface; then that takes over from where it lies on the first.
class Part_morph
{
public:
  /// \param charts of both ends, between which the surfaces are on the way
  Part_morph(const Pair_charts& charts, const Part_mesh& source, const Part_mesh& target);

  static constexpr double change = 0.45; ///< when the target's surface takes over from the source's

  /// The surface that there is at `t`: 0, the source's, or 1.
  int surface(double t) const { return t < change ? 0 : 1; }
  const Eigen::Matrix3Xi& triangles(int surface) const { return surfaces_[std::size_t(surface)].triangles; }
  /// The points of a surface at `t`, also where it is not the one that there is.
  Points points(int surface, double t) const;
  /// How far both surfaces are from each other, in coordinates from -1 to 1 relative to outlines: the root mean square
  /// over the one that is farther from the other.
  /// \param at_change where the one takes over from the other, not at their ends
  double misfit(bool at_change) const;

private:
  struct Moving_surface
  {
    /// Moves the surface, from where or to where it moves, onto where another one moves to.
    void lay(std::size_t when, const Moving_surface& onto);

    Eigen::Matrix3Xi triangles;
    Points normals;                             ///< in coordinates
    std::array<Points, 2> coordinates, offsets; ///< relative to outlines in charts; from, to
  };

  // By end
  std::array<Part_chart, 2> charts_;
  std::array<Chart_outline, 2> outlines_;
  std::array<Moving_surface, 2> surfaces_;
};

} // namespace CGAL::Shape_correspondence::internal
