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

/// The motion of the space around one of the shapes on the way to the other: it follows the surfaces of matched parts,
/// the boxes around parts that correspond but do not morph, and the box around the whole shape, and is smooth in
/// between. Unmatched parts follow it, so that they stay in contact with their neighbours.
///
/// Along each axis the motion is a smoothing spline with the kernel -|r|, biharmonic in space, through *control
/// points*. Distances along the two other axes count less, so that lines along an axis stay straight. It is evaluated
/// at the nodes of a lattice and interpolated trilinearly between them.
class Space_warp
{
public:
  /// \param unlike pairs of parts that correspond but do not morph
  Space_warp(const Blend_stage& stage, const std::vector<Blend_part>& parts, const Part_pairs& unlike, int end);

  /// The displacements of the nodes at time `t`.
  /// \param surfaces surfaces of this end, by part, at time `t`; those of unmatched parts are not read
  Points ways(const std::vector<Blend_part>& parts, const std::vector<Points>& surfaces, double t) const;
  /// Points of the shape, displaced by the interpolated displacements of the nodes.
  Points moved(const Points& points, const Points& ways) const;

private:
  /// A point whose motion is known, approximated to within the smoothing.
  struct Control
  {
    Point at, at_other_end;                 ///< `at_other_end` is defined for points of boxes
    Point smoothing;                        ///< length along each axis, relative to the shape's height
    std::size_t part = Blend_task::no_part; ///< the matched part that it is on, if any
    Mesh_place place = {};                  ///< location on the part's surface at this end
  };

  void add_box(const std::array<contacts::Box, 2>& boxes, int cells, const Point& smoothing);
  void add_surfaces(const Blend_stage& stage, const std::vector<Blend_part>& parts);
  void add_surface_point(const std::vector<Blend_part>& parts, std::size_t given, const Point& near);
  void add_sets(const Blend_stage& stage, const Part_pairs& unlike);

  int end_;
  contacts::Box box_;    ///< bounding box of the shape
  Eigen::Array3i cells_; ///< number of cells of the lattice, by axis
  std::vector<Control> controls_;
  std::array<Eigen::PartialPivLU<Eigen::MatrixXd>, 3> solvers_; ///< indexed by axis
  std::array<Eigen::MatrixXd, 3> node_kernels_;                 ///< indexed by axis
};

/// How an unmatched part follows a warp: by the simplest of three motions that keep it at its contacts. It is stretched
/// along the axes of the world; or turned, and stretched along its own axes; or bent as space is. Straight and flat
/// parts stay so under the first two.
class Straight_motion
{
public:
  /// \param contacts places of contacts of the part
  /// \param stands whether the last contact is its foot on the ground
  /// \param ways displacements of the warp's nodes half-way through the blend, which decide the kind of motion
  Straight_motion(const Part_chart& chart, const Points& contacts, bool stands, const Space_warp& warp,
                  const Points& ways);

  Points moved(const Points& points, const Space_warp& warp, const Points& ways) const;

private:
  enum class Kind { STRETCH, TURN, FREE };
  using Affine = Eigen::Matrix<double, 3, 4>;

  Affine fitted(const Space_warp& warp, const Points& ways) const;

  Kind kind_ = Kind::STRETCH;
  Eigen::Matrix3d axes_; ///< axes of the part's chart
  Points samples_;       ///< a lattice in the part's chart, then the contacts
  bool stands_;
};

} // namespace CGAL::Shape_correspondence::internal
