// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Seen_surface.h"

#include <CGAL/Shape_correspondence/Blend_options.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A shape that is blended, as it is given.
struct Blend_input
{
  const Structural_graph& graph;
  const Segmented_shape& shape;
  int quarter_turns;
};

inline Point mirrored(const Point& p) { return {-p.x(), p.y(), p.z()}; }

/// Root mean square distance of some points of surfaces, mirrored in x = 0, from surfaces.
double mirror_residual(const std::vector<const Points*>& surfaces, const Tree_pointers& trees);

/// By part, its mirror image in x = 0, if it has one: a part that is its own image has itself.
using Mirror_images = std::vector<std::optional<std::size_t>>;

/// Both shapes on one stage, by end, 0 the source and 1 the target: they stand on the ground, y = 0, the middles of
/// their boxes above the origin, of height 1, turned so that they look alike. A shape with a mirror plane has it at
/// x = 0.
struct Blend_stage
{
  Blend_stage(const std::array<Blend_input, 2>& inputs, Blend_size size);
  Blend_stage(const Blend_stage&) = delete;
  Blend_stage& operator=(const Blend_stage&) = delete;

  bool are_symmetric;                     ///< both have the mirror plane x = 0
  std::array<Structural_graph, 2> graphs; ///< with the frames of the stage
  std::array<std::vector<Part_mesh>, 2> meshes;
  std::array<Charted_shape, 2> charted;
  std::array<Mirror_images, 2> images; ///< none if the ends are not symmetric
  std::array<contacts::Box, 2> boxes;  ///< of the shapes
  std::array<double, 2> widest_gap;    ///< that it takes to join all parts
  std::array<double, 2> heights;       ///< of the shapes in the world
  /// As they are given, but in the world at these heights, in the axes of the source.
  std::array<Segmented_shape, 2> shapes;

  /// Adds the mirror image of every pair that has one: what a part becomes, its image becomes the image of.
  void add_mirrored(Part_pairs& pairs) const;
  /// From the stage to the world when a share of the change of size is done: sizes change by equal factors in equal
  /// times.
  Points to_world(const Points& points, double done) const;

private:
  Segmented_shape moved(const Blend_input& input, const Point& up, std::size_t end) const;
  void add(const Blend_input& input, std::size_t end);
};

} // namespace CGAL::Shape_correspondence::internal
