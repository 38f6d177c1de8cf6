// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Chart_outline.h"
#include "map/Piece_pair.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Straight charts of the boxes of two surfaces, along the longest axis. A box has the axes of the world unless a
/// part's own axes make it much smaller; axes are paired by the least rotation over the symmetries of boxes.
/// \param own_axes rotations to the axes of the surfaces
/// \param much ratio of volumes below which a box is much smaller
Pair_charts pair_boxes(const std::array<const Points*, 2>& surfaces, const std::array<Eigen::Matrix3d, 2>& own_axes,
                       double much = 0.45); // a square turned by 45 degrees is above it

/// The morph of the surface of a part to that of its counterpart. At any time there is one surface, first that of the
/// source, then that of the target: both ends are exact, and closed if the inputs are.
///
/// A *stand-in*, the surface of the outlines of cross-sections, moves evenly from the source to the target. The
/// source's surface slides onto it, but for details that both have, and then onto the target's surface, which has slid
/// onto the source's and takes over.
class Part_morph
{
public:
  /// Length of edges, in coordinates from -1 to 1, to which meshes are subdivided so that they can be bent. It is no
  /// part of 2, which rounding would decide.
  static constexpr double fine = 0.3;

  /// \param charts the charts of both ends, of curves, along which the sections are
  Part_morph(const Pair_charts& charts, const Part_mesh& source, const Part_mesh& target, double longest_edge = fine);

  static constexpr double change = 0.45; ///< time when the target's surface replaces the source's

  /// The surface that is present at time `t`: 0, the source's, or 1.
  int surface(double t) const { return t < change ? 0 : 1; }
  const Eigen::Matrix3Xi& triangles(int surface) const { return surfaces_[std::size_t(surface)].triangles; }
  /// The points of a surface at time `t`, even if it is not the present one.
  Points points(int surface, double t) const;

  /// Root mean square distance of the surfaces from the stand-in at their ends, over their diagonals: the larger one.
  double error() const { return error_; }
  /// Likewise, of the surfaces from each other when one replaces the other, before they slide onto each other.
  double misfit() const { return misfit_; }
  /// Whether the stand-in describes both parts well enough, and the surface half-way is no rougher, and covers neither
  /// more nor less, than both ends.
  bool is_faithful() const;

private:
  struct Sliding_surface
  {
    Eigen::Matrix3Xi triangles;
    Points places;  ///< on the stand-in, in relative coordinates
    Points offsets; ///< from there to the surface at its end, in the frames of the chart
    Points details; ///< likewise, what the offsets have in common with those of the other surface
    Points meets;   ///< likewise, from there to the other surface, at the change
  };

  void add(const Part_chart& chart, const Part_mesh& mesh, double longest_edge);
  void meet();
  bool looks_alike() const;

  // Members by end
  std::array<Part_chart, 2> charts_;
  std::vector<Chart_outline> outlines_;
  std::vector<Sliding_surface> surfaces_;
  double error_ = 0, misfit_ = 0;
};

/// The morph in one of several pairs of charts in which the stand-in is the best; null if none is faithful. Its meshes
/// are subdivided no more than it takes.
std::shared_ptr<const Part_morph> best_morph(const std::vector<Pair_charts>& charts, const Part_mesh& source,
                                             const Part_mesh& target);

} // namespace CGAL::Shape_correspondence::internal
