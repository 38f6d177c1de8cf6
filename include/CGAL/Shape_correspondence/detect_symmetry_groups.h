// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_DETECT_SYMMETRY_GROUPS_H
#define CGAL_SHAPE_CORRESPONDENCE_DETECT_SYMMETRY_GROUPS_H

#include <CGAL/Shape_correspondence/Structural_graph.h>

namespace CGAL {
namespace Shape_correspondence {

/// Options of `detect_symmetry_groups()`.
struct Symmetry_options
{
  double tolerance = 0.05; ///< how far a part may be from its image, over the part's diagonal
  bool enabled = true;     ///< false: every part is a group of its own (`--no-symmetry`)
};

/// Gathers parts into symmetry groups (paper, section 3): congruent parts that a rotation about a vertical axis, a
/// translation, or a reflection carries into each other. Of several explanations the one that covers most parts wins,
/// then the one that comes first in the list rotation (complete, order >= 3), translation (3 or more), reflection.
/// Groups come in the order of their first part, volumes and hulls filled in. O(parts²).
std::vector<Part_group> detect_symmetry_groups(const std::vector<Part_abstraction>& parts, const Shape_frame& frame,
                                               const Symmetry_options& options = {});

} // namespace Shape_correspondence
} // namespace CGAL

#ifndef CGAL_SHAPE_CORRESPONDENCE_COMPILED
#include <CGAL/Shape_correspondence/internal/detect_symmetry_groups_impl.h>
#endif

#endif // CGAL_SHAPE_CORRESPONDENCE_DETECT_SYMMETRY_GROUPS_H
