// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Charted_mesh.h"
#include "map/Part_chart.h"
#include "map/Piece_pair.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Straight charts (`Part_chart`) of the boxes of two surfaces. A box has the axes of the world unless a part's own
/// axes make it much smaller; axes are paired by the least rotation over the symmetries of boxes.
/// \param own_axes rotations to the axes of the surfaces
/// \param much ratio of volumes below which a box is much smaller
Pair_charts pair_boxes(const std::array<const Points*, 2>& surfaces, const std::array<Eigen::Matrix3d, 2>& own_axes,
                       double much = 0.45); // less than 1/2, the ratio of a square turned by 45 degrees

/// The morph of the surface of a part to that of its counterpart. At any time there is one surface, first that of the
/// source, then that of the target: both ends are exact, and closed if the inputs are.
///
/// Either surface moves with the space of its chart. If the morph *bends*, the surface also changes smoothly in the
/// chart, so that in the large the outlines of its cross-sections become those of the other surface; details keep their
/// shape. Just before the change, the first surface slides half-way to the second one, which is near; the second one
/// starts from there.
class Part_morph
{
public:
  /// \param charts the charts of both ends; cross-sections are perpendicular to their first coordinate
  /// \param bends whether surfaces change in their charts, too
  Part_morph(const Pair_charts& charts, const Part_mesh& source, const Part_mesh& target, bool bends);

  static constexpr double change = 0.45; ///< time when the target's surface replaces the source's

  /// The surface that is present at time `t`: 0, the source's, or 1.
  int surface(double t) const { return t < change ? 0 : 1; }
  const Eigen::Matrix3Xi& triangles(int surface) const { return surfaces_[std::size_t(surface)].triangles; }
  /// The points of a surface at time `t`, even if it is not the present one.
  Points points(int surface, double t) const;

  /// Root mean square distance of a surface from the other one at the change, over its diagonal; the larger value of
  /// the two surfaces.
  double misfit() const { return misfit_; }
  /// Root mean square change of the edges of a surface by bending, until the change, over their lengths; the larger
  /// value of the two surfaces; 0 without bending.
  double strain() const { return strain_; }
  /// Misfit plus weighted strain, by which morphs are compared: 0 if surfaces keep their shapes and fit each other.
  double effort() const
  {
    constexpr double of_strain = 0.15; // weight of the strain, over that of the misfit
    return misfit_ + of_strain * strain_;
  }
  /// Whether the effort is small and, at the change, both surfaces cover similar shares of their bounding rectangles.
  bool is_faithful() const;
  /// Lets the surfaces meet half-way between each other at the change.
  void meet();

private:
  struct Moving_surface
  {
    Eigen::Matrix3Xi triangles;
    Points places;  ///< chart coordinates of the vertices, relative to the outline
    Points offsets; ///< vectors from the chart's points at `places` to the vertices, in the frames of the surface's end
    Points meets;   ///< vectors from the vertices to where the surfaces meet at the change, in the chart's frames
  };

  double strain_of(std::size_t end, const Charted_mesh& mesh) const;
  void add(std::size_t end, const Part_mesh& mesh);
  contacts::Triangle_tree tree_at_change(std::size_t surface) const;

  // Arrays indexed by end: 0 is the source, 1 the target
  std::array<Part_chart, 2> charts_;
  std::array<Chart_outline, 2> outlines_;
  std::vector<Moving_surface> surfaces_; ///< empty if the strain is too large
  double misfit_ = 0, strain_ = 0;
};

/// The morph of least effort in one of several pairs of charts; null if none is faithful.
/// \param charts groups of pairs: straight charts that differ by their first axis, or one pair of charts along curves
std::shared_ptr<const Part_morph> best_morph(const std::vector<std::vector<Pair_charts>>& charts,
                                             const Part_mesh& source, const Part_mesh& target);

struct Blend_stage;

/// A part of the in-between shapes: a part of the source or the target, or a piece of one. A matched part has two
/// surfaces, mapped to each other; an unmatched part has one. Ends are numbered 0 (the source) and 1 (the target).
struct Blend_part
{
  /// Height up to which a part counts as standing on the ground, over the height of the shape.
  static constexpr double on_ground = 0.02;

  std::string name;
  Blend_task task;
  std::shared_ptr<const Part_morph> morph;    ///< defined for matched parts
  Part_mesh mesh;                             ///< defined for unmatched parts, which shrink or grow
  std::vector<contacts::Triangle_tree> trees; ///< indexed by surface, at the surface's end of the blend
  double change =
      0; ///< how much a matched part changes its proportions and position, if more than little; see `Difference`
  double size = 0; ///< the greater of the diagonals of the surfaces' bounding boxes

  bool is_matched() const { return bool(morph); }
  /// The end that has the part. \pre the part is unmatched
  int end() const { return task.type == Blend_task_type::SHRINK ? 0 : 1; }
  /// Index of the part at an end. \pre the end has the part
  std::size_t given(int at_end) const { return at_end == 0 ? task.source : task.target; }
  bool is_at(int at_end) const { return given(at_end) != Blend_task::no_part; }

  const Eigen::Matrix3Xi& triangles(int surface) const { return morph ? morph->triangles(surface) : mesh.triangles; }
  int number_of_surfaces() const { return morph ? 2 : 1; }
  /// The points of a surface. \param progress time of the morph in [0, 1]; ignored for unmatched parts
  Points points(int surface, double progress) const { return morph ? morph->points(surface, progress) : mesh.points; }

  /// The surface of the part at an end, and its points there. \pre the end has the part
  int end_surface(int at_end) const { return morph ? at_end : 0; }
  Points end_points(int at_end) const { return points(end_surface(at_end), at_end); }
  const contacts::Triangle_tree& end_tree(int at_end) const { return trees[std::size_t(end_surface(at_end))]; }

  /// Sets the members that are derived from the surfaces: `trees` and `size`.
  void set_ends();
};

/// Indices of the blend's parts that come from a given part of an end, or from pieces of it.
std::vector<std::size_t> parts_of(const std::vector<Blend_part>& parts, int end, std::size_t given);

/// The parts of a blend. Matched parts come first: one for every pair of parts, or pieces of parts, that correspond or
/// are similar leftovers and, if both ends are symmetric, for their mirror images; then unmatched parts, the source's
/// first.
/// \param unlike receives the pairs that correspond but do not morph
std::vector<Blend_part> blend_parts(const Blend_stage& stage, const Correspondence& correspondence, Part_pairs& unlike);

inline contacts::Box box_of(const Points& points) { return {points.rowwise().minCoeff(), points.rowwise().maxCoeff()}; }

} // namespace CGAL::Shape_correspondence::internal
