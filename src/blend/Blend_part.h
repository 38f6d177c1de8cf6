// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Part_morph.h"
#include "blend/Rest_surface.h"
#include "blend/Unmatched_part.h"
#include "map/Charted_mesh.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

struct Blend_ends;
struct Blend_input;

/// Where an unmatched part is attached to another part of the blend.
struct Attachment
{
  std::size_t part;
  int surface;
  Mesh_place place;
  Point at;       ///< at the end that has the unmatched part
  Point vanished; ///< at the other end, but for how what it is attached to may be stretched
};

/// A part of the shapes in between: what becomes of one part, or a piece of one. If it is matched, it has two surfaces,
/// one after the other; if not, one. Ends are numbered: 0 is the source, 1 the target.
struct Blend_part
{
  using Tree = contacts::Triangle_tree;

  std::string name;
  Blend_task task;
  std::shared_ptr<const Part_morph> morph;          ///< of a matched part
  std::shared_ptr<const Unmatched_part> unmatched;  ///< or else of one that shrinks or grows
  std::vector<Attachment> attachments;              ///< of the latter
  double height = 0;                                ///< of its middle, at the ends' mean
  std::size_t image = Blend_task::no_part;          ///< its mirror image, where the blend is to be symmetric
  bool is_reflected = false;                        ///< computed as the image's image, in its charts
  bool stands = false;                              ///< on the ground, at both ends
  std::array<double, 2> foot = {0, 0};              ///< of one that stands, how high it is above the ground, by end
  std::array<std::optional<Tree>, 2> trees;         ///< by surface, at an end; to be moved
  std::array<std::optional<Rest_surface>, 2> rests; ///< by surface, at that end
  std::array<bool, 2> holds = {false, false};       ///< by surface, whether unmatched parts are attached to it
  double size = 1e-6;                               ///< of the larger one of its surfaces; never less

  bool is_exchange() const { return morph && morph->is_exchange(); }
  bool has_image() const { return image != Blend_task::no_part; }
  /// Of an unmatched one, the end that has it.
  int end() const { return task.source == Blend_task::no_part ? 1 : 0; }

  const Eigen::Matrix3Xi& triangles(int surface) const;
  /// Of a matched one, at a time of its task.
  /// \param remaining how much there is of the surface
  Points points(int surface, double t, double remaining = 1) const;
  /// Of an unmatched one, as much as there is of it.
  Points remaining_points(double remaining) const;
  /// Where a point of an unmatched one is then.
  Point remaining_place(const Point& p, double remaining) const;

  /// The surface at an end and its points there. \pre the end has the part
  int end_surface(int end) const { return morph ? end : 0; }
  Points end_points(int end) const;

  /// Sets trees, rests and size. \pre it has all else
  void add_trees();
};

/// What becomes of a part of an end, or of pieces of it.
std::vector<std::size_t> parts_of(const std::vector<Blend_part>& parts, int end, std::size_t given);

/// The parts of a blend that become each other: one for every two parts, or pieces of parts, that correspond and, if
/// the ends are symmetric, for their mirror images.
std::vector<Blend_part> matched_parts(const Blend_ends& ends, const Correspondence& correspondence);

/// Adds the parts of both ends that become no part: what touches matched parts first, then what touches that.
void add_unmatched_parts(const std::array<Blend_input, 2>& inputs, const Blend_ends& ends,
                         std::vector<Blend_part>& parts);

/// Leaves out attachments that go far apart though they are near each other on the part, those first that do so most:
/// what is there is connected by other ways at the other end. Mirror images go together; one is always left.
/// \param size of the part
std::vector<Attachment> without_diverging(std::vector<Attachment> attachments, double size);

inline contacts::Box box_of(const Points& points) { return {points.rowwise().minCoeff(), points.rowwise().maxCoeff()}; }

} // namespace CGAL::Shape_correspondence::internal
