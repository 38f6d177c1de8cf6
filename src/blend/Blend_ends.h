// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/mirror_images.h"

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A shape that is blended, as it is given.
struct Blend_input
{
  const Structural_graph& graph;
  const Segmented_shape& shape;
  int quarter_turns;
};

/// The shapes at the ends of a blend in their common frame, by end: of height 1, and turned so that they look alike.
struct Blend_ends
{
  explicit Blend_ends(const std::array<Blend_input, 2>& inputs);

  bool are_symmetric = true; ///< both have the mirror plane x = 0
  std::array<std::vector<Part_mesh>, 2> meshes;
  std::array<Charted_shape, 2> charted;
  std::array<Mirror_images, 2> images; ///< none if the ends are not symmetric
  std::array<double, 2> ground;        ///< its height
  std::array<double, 2> widest_gap;    ///< that it takes to join all parts

private:
  void add(const Blend_input& input, std::size_t end);
};

} // namespace CGAL::Shape_correspondence::internal
