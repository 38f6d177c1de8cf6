// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"
#include "blend/Blend_stage.h"
#include "map/Charted_mesh.h"
#include "map/Part_chart.h"

#include <Eigen/LU>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

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
  /// A point whose motion is known; the warp approximates it.
  struct Control
  {
    Point at, at_other_end;                 ///< `at_other_end` is defined for points of boxes
    Point smoothing;                        ///< by axis, over the height: the larger, the farther the warp may miss it
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
  std::array<Eigen::PartialPivLU<Eigen::MatrixXd>, 3> solvers_; ///< of the equations for the coefficients, by axis
  std::array<Eigen::MatrixXd, 3> node_kernels_; ///< by axis, from coefficients to displacements of the nodes
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

/// How an unmatched part comes and goes: it grows from the line through the places where it is attached, along its own
/// curve or sheet, and soon has its full thickness.
class Growth
{
public:
  /// \param chart the chart of the part \param points its vertices
  /// \param holds the places from which it grows, at least one: contacts with other parts, or its foot
  Growth(const Part_chart& chart, const Points& points, const std::vector<Point>& holds);

  /// The points when a share, in [0, 1], of the part has grown.
  Points points(double share) const;

private:
  Point from(double at) const;

  Part_chart chart_;
  Points points_;
  Points coordinates_, offsets_; ///< of the points in the chart, see `Charted_mesh`
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
  /// For each part, the least number of contacts on a way to a carrying part, which is a part that morphs, corresponds
  /// without morphing, or stands on the ground: 0 for a carrying part, 1 for a part that no contacts connect to one.
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

/// The surfaces of the parts of a blend at a time strictly between its ends. Parts and surfaces are given by index.
///
/// *Layout*: matched parts move linearly from their places at one end to those at the other. Unmatched parts follow the
/// warps of the ends. Then the whole is stretched vertically to stand with the interpolated height.
struct In_between_shape
{
  /// \param tasks the tasks with their times; if empty, all parts of both ends are present in full size
  In_between_shape(const Blend_structure& blend, const std::vector<Blend_task>& tasks, double t);

  const Blend_structure& blend;
  double time;
  std::vector<int> surfaces;  ///< for each part, the index of its present surface, or -1
  std::vector<Points> points; ///< for each part, the points of its present surface

  bool is_there(std::size_t part) const { return surfaces[part] >= 0; }
  /// The interpolated height of the whole.
  double due_height() const
  {
    return (1 - time) * blend.stage.boxes[0].max().y() + time * blend.stage.boxes[1].max().y();
  }
  /// The points of a surface of a part at this time, even if it is not the present one.
  Points points_of(std::size_t part, int surface) const;
  /// The surfaces of the parts that are present.
  std::vector<Seen_surface> seen() const;
  Blend_quality quality() const;

private:
  Points grown(std::size_t part, const std::vector<Blend_task>& tasks);
  void place_unmatched(const std::vector<Blend_task>& tasks);
  void fill_the_height();
  void stretch(Points& surface) const { surface.row(1) = (scale_ * surface.row(1)).array() + shift_; }

  double scale_ = 1, shift_ = 0; ///< scale and offset of the vertical stretch
};

} // namespace CGAL::Shape_correspondence::internal
