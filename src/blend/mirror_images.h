// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Shape_look.h"
#include "map/Piece_pair.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

inline Point mirrored(Point p)
{
  p.x() = -p.x();
  return p;
}

/// Root mean square distance of some points of surfaces, mirrored in x = 0, from surfaces.
double mirror_residual(const std::vector<const Points*>& surfaces, const Tree_pointers& trees);

/// By part, its mirror image in x = 0, if it has one: a part that is its own image has itself.
using Mirror_images = std::vector<std::optional<std::size_t>>;
Mirror_images mirror_images(const std::vector<const Points*>& parts, const std::vector<contacts::Triangle_tree>& trees);

/// Adds the mirror image of every pair that has one: what a part becomes, its image becomes the image of.
void add_mirrored(Part_pairs& pairs, const Mirror_images& source, const Mirror_images& target);

} // namespace CGAL::Shape_correspondence::internal
