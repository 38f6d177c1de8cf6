// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Part_morph.h"
#include "blend/Rest_surface.h"
#include "map/Charted_mesh.h"
#include "map/matched_members.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

struct Blend_stage;

/// A part of the shapes in between: what becomes of one part, or of a piece of one. If it is matched, it has two
/// surfaces that follow each other; if not, one. Ends are numbered: 0 is the source, 1 the target.
struct Blend_part
{
  static constexpr double on_ground = 0.02; ///< of the height: what is no higher stands on the ground

  std::string name;
  Blend_task task;
  std::shared_ptr<const Part_morph> morph;    ///< of a matched part
  Part_mesh mesh;                             ///< of another one, which shrinks or grows
  std::vector<contacts::Triangle_tree> trees; ///< by surface, at its end
  std::vector<Rest_surface> rests;            ///< by surface
  double size = 0;                            ///< the longer diagonal of the boxes of its surfaces

  bool is_matched() const { return bool(morph); }
  /// Of an unmatched part: the end that has it.
  int end() const { return task.type == Blend_task_type::SHRINK ? 0 : 1; }
  /// Its number at an end that has it.
  std::size_t given(int at_end) const { return at_end == 0 ? task.source : task.target; }
  /// Whether an end has it.
  bool is_at(int at_end) const { return given(at_end) != Blend_task::no_part; }

  const Eigen::Matrix3Xi& triangles(int surface) const { return morph ? morph->triangles(surface) : mesh.triangles; }
  int number_of_surfaces() const { return morph ? 2 : 1; }
  /// \param progress of a matched part, its own time
  Points points(int surface, double progress) const { return morph ? morph->points(surface, progress) : mesh.points; }

  /// The surface at an end and its points there. \pre the end has the part
  int end_surface(int at_end) const { return morph ? at_end : 0; }
  Points end_points(int at_end) const { return points(end_surface(at_end), at_end); }
  const contacts::Triangle_tree& end_tree(int at_end) const { return trees[std::size_t(end_surface(at_end))]; }

  /// Sets what follows from the surfaces: trees, rests and size.
  void set_ends();
};

/// What becomes of a part of an end, or of pieces of it.
std::vector<std::size_t> parts_of(const std::vector<Blend_part>& parts, int end, std::size_t given);

/// The parts of a blend. First those that are matched: one for every two parts, or pieces of parts, that correspond or
/// are left over alike and, if the ends are symmetric, for their mirror images. Then the others, those of the source
/// first.
/// \param unlike gets the pairs that correspond but do not morph
std::vector<Blend_part> blend_parts(const Blend_stage& stage, const Correspondence& correspondence, Part_pairs& unlike);

inline contacts::Box box_of(const Points& points) { return {points.rowwise().minCoeff(), points.rowwise().maxCoeff()}; }

} // namespace CGAL::Shape_correspondence::internal
