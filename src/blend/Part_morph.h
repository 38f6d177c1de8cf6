// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Chart_outline.h"
#include "map/Piece_pair.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <array>
#include <cstddef>

namespace CGAL::Shape_correspondence::internal {

/// Straight charts of the boxes of two surfaces. A box has the axes of the world unless a part's own axes make it much
/// smaller; axes are paired by the least rotation over the symmetries of boxes.
/// \param own_axes rotations to the axes of the surfaces
Pair_charts pair_boxes(const std::array<const Points*, 2>& surfaces, const std::array<Eigen::Matrix3d, 2>& own_axes);

/// The morph of the surface of a part to that of its counterpart. At any time there is one surface, first that of the
/// source, then that of the target: both ends are exact, and closed if the inputs are.
class Part_morph
{
public:
  virtual ~Part_morph() = default;

  static constexpr double change = 0.45; ///< time when the target's surface replaces the source's

  /// The surface that is present at time `t`: 0, the source's, or 1.
  int surface(double t) const { return t < change ? 0 : 1; }
  const Eigen::Matrix3Xi& triangles(int surface) const { return triangles_[std::size_t(surface)]; }
  /// The points of a surface at time `t`, even if it is not the present one.
  virtual Points points(int surface, double t) const = 0;

protected:
  std::array<Eigen::Matrix3Xi, 2> triangles_; ///< indexed by end
};

/// A morph in boxes: the source's surface, in chart coordinates relative to the part's outline, moves smoothly to the
/// target's; then the target's surface takes over from where it lies on the source's.
class Laid_morph : public Part_morph
{
public:
  /// \param charts the charts of both ends, between which the surfaces move
  Laid_morph(const Pair_charts& charts, const Part_mesh& source, const Part_mesh& target);

  Points points(int surface, double t) const override;
  /// Distance between the two surfaces, in coordinates from -1 to 1 relative to outlines: the root mean square over the
  /// surface that is farther from the other.
  /// \param at_change whether to compare them when one replaces the other rather than at the ends
  double misfit(bool at_change) const;

private:
  struct Moving_surface
  {
    /// Moves the surface, at its end `when`, onto the surface `onto`.
    void lay(std::size_t when, const Moving_surface& onto, const std::array<Eigen::Matrix3Xi, 2>& triangles);

    Points normals;                             ///< in chart coordinates
    std::array<Points, 2> coordinates, offsets; ///< indexed by end; relative to the outlines in the charts
  };

  // Members by end
  std::array<Part_chart, 2> charts_;
  std::array<Chart_outline, 2> outlines_;
  std::array<Moving_surface, 2> surfaces_;
};

} // namespace CGAL::Shape_correspondence::internal
