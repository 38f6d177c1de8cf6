// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"
#include "map/Charted_mesh.h"

#include <Eigen/LU>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

struct Blend_stage;

/// How the space around one of the shapes moves on the way to the other one: with the surfaces of matched parts, with
/// the boxes around parts that correspond but do not morph, with the box around the whole, and smoothly between these.
/// Unmatched parts ride on it, so that they hold on to what they touch.
///
/// Along each axis the motion is a smoothing spline with the kernel -|r|, the smoothest in space, through *controls*.
/// Distances along the two other axes count less, so that what is straight along an axis stays so. It is evaluated at
/// the nodes of a lattice, between which motions are trilinear.
class Space_warp
{
public:
  /// \param unlike pairs that correspond but do not morph
  Space_warp(const Blend_stage& stage, const std::vector<Blend_part>& parts, const Part_pairs& unlike, int end);

  /// How the nodes have moved at `t`.
  /// \param surfaces of this end, by part, where they are at `t`; those of unmatched parts are not read
  Points ways(const std::vector<Blend_part>& parts, const std::vector<Points>& surfaces, double t) const;
  /// Points of the shape when the nodes have moved.
  Points moved(const Points& points, const Points& ways) const;

private:
  /// A point that moves to a known place, as nearly as the smoothing allows.
  struct Control
  {
    Point at, at_other_end;                 ///< the latter of a point of a box
    Point smoothing;                        ///< by axis, over the height
    std::size_t part = Blend_task::no_part; ///< matched, if it is on one
    Mesh_place place = {};                  ///< on its surface of this end
  };

  void add_box(const std::array<contacts::Box, 2>& boxes, int cells, const Point& smoothing);
  void add_surfaces(const Blend_stage& stage, const std::vector<Blend_part>& parts);
  void add_surface_point(const std::vector<Blend_part>& parts, std::size_t given, const Point& near);
  void add_sets(const Blend_stage& stage, const Part_pairs& unlike);

  int end_;
  contacts::Box box_;    ///< around the shape
  Eigen::Array3i cells_; ///< of the lattice, by axis
  std::vector<Control> controls_;
  std::array<Eigen::PartialPivLU<Eigen::MatrixXd>, 3> solvers_; ///< by axis
  std::array<Eigen::MatrixXd, 3> node_kernels_;                 ///< by axis
};

} // namespace CGAL::Shape_correspondence::internal
