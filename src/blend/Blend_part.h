// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Part_morph.h"
#include "map/Charted_mesh.h"
#include "map/Piece_pair.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

struct Blend_stage;

/// A part of the in-between shapes: a part of an end, or a piece of one. A matched part has two surfaces, mapped to
/// each other; an unmatched part has one. Ends are numbered 0 (the source) and 1 (the target).
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
