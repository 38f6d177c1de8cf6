// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Part_morph.h"
#include "blend/Rest_surface.h"
#include "map/Charted_mesh.h"
#include "map/matched_members.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

struct Blend_stage;

/// A point that goes with a part, as it is at either end.
struct Carried_point
{
  std::array<Point, 2> coordinates; ///< in the part's own coordinates, by end
  std::array<Point, 2> offsets;     ///< from where the part has the coordinates to the point, by end
};

/// A part of the shapes in between: what becomes of one part, of a piece of one, or of several together. If it is
/// matched, it has surfaces that follow each other; if not, one. Ends are numbered: 0 is the source, 1 the target.
struct Blend_part
{
  using Tree = contacts::Triangle_tree;
  static constexpr double on_ground = 0.02; ///< of the height: what is no higher stands on the ground

  std::string name;
  Blend_task task;
  std::shared_ptr<const Part_morph> morph; ///< of a matched part
  Part_mesh mesh;                          ///< of another one, which shrinks or grows
  std::size_t group = 0;                   ///< of the latter, those that come or go at one time
  double height = 0;                       ///< of its middle, at the ends' mean
  std::size_t image = Blend_task::no_part; ///< its mirror image, where the blend is to be symmetric
  bool is_reflected = false;               ///< computed as the image's image, in its charts
  bool stands = false;                     ///< on the ground, at all ends that have it
  std::array<double, 2> foot = {0, 0};     ///< by end, how high its lowest point is
  double needless_turn = 0;                ///< of a matched part, beyond the least one, in radians
  std::vector<Tree> trees;                 ///< by surface; of those at the ends, there
  std::vector<Rest_surface> rests;         ///< by surface
  double size = 0;                         ///< the longer diagonal of the boxes of its surfaces

  /// How high the lowest point of one that stands is due.
  double due_foot(double progress) const { return (1 - progress) * foot[0] + progress * foot[1]; }
  bool has_image() const { return image != Blend_task::no_part; }
  /// Of an unmatched part: the end that has it.
  int end() const { return task.type == Blend_task_type::SHRINK ? 0 : 1; }
  /// Of an unmatched part: its number at that end.
  std::size_t given() const { return end() == 0 ? task.source : task.target; }
  /// Whether an end has it.
  bool is_at(int at_end) const { return morph || end() == at_end; }

  const Eigen::Matrix3Xi& triangles(int surface) const;
  int number_of_surfaces() const { return morph ? morph->number_of_surfaces() : 1; }
  /// \param progress of a matched part, its own time
  Points points(int surface, double progress) const;

  /// A point of a matched part as it is at an end, or at both.
  Carried_point carried(int end, const Point& p) const;
  Carried_point carried(const Point& source, const Point& target) const;
  Point place(const Carried_point& p, double progress) const;

  /// The surface at an end and its points there. \pre the end has the part
  int end_surface(int at_end) const { return at_end * (number_of_surfaces() - 1); }
  Points end_points(int at_end) const { return points(end_surface(at_end), at_end); }

  /// Sets what follows from the surfaces: trees, rests, size, height and feet.
  void set_ends();
};

/// What becomes of a part of an end, or of pieces of it.
std::vector<std::size_t> parts_of(const std::vector<Blend_part>& parts, int end, std::size_t given);

/// The parts of a blend that are matched: one for every two parts, or pieces or sets of parts, that correspond or are
/// left over alike and, if the ends are symmetric, for their mirror images.
/// \param unlike gets the pairs that correspond but do not morph
std::vector<Blend_part> matched_parts(const Blend_stage& stage, const Correspondence& correspondence,
                                      Part_pairs& unlike);

/// Adds the surface of another part to one.
void append(Part_mesh& all, const Part_mesh& mesh);

inline contacts::Box box_of(const Points& points) { return {points.rowwise().minCoeff(), points.rowwise().maxCoeff()}; }

} // namespace CGAL::Shape_correspondence::internal
