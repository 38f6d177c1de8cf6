// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_DETECT_SYMMETRY_GROUPS_H
#define CGAL_SHAPE_CORRESPONDENCE_DETECT_SYMMETRY_GROUPS_H

#include <CGAL/Shape_correspondence/Structural_graph.h>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `detect_symmetry_groups()`.
struct Symmetry_options
{
  double tolerance = 0.05; ///< largest distance of a part from its image, as a fraction of the diagonal of the part
  bool enabled = true;     ///< whether to detect groups; otherwise every part is a single group
  bool reflection = true;  ///< whether to detect reflections
  bool rotation = true;    ///< whether to detect rotations
  bool translation = true; ///< whether to detect translations
};

/// \ingroup PkgShapeCorrespondenceGraph
/// Detects the symmetry groups of parts (paper, section 3): congruent parts that are images of each other under one
/// symmetry. Two parts are congruent if the image of one and the other agree in hull, surface points, area and volume
/// within the tolerance; their meshes may differ. In rings, rows, and pairs under a rotation or translation, the widths
/// in all directions must agree as well, except for wheels, whose hubs may differ. Noise of 0.5 % of the shape's
/// diagonal on the vertices does not change the groups. Of overlapping groups, the one with the most parts is taken; of
/// those with equally many, the first in this list:
/// 1. a star: a complete ring of 3 parts or more about a vertical or horizontal axis that extend to the axis
///    (the feet of an office chair, the blades of a propeller);
/// 2. four parts that are images of each other in two orthogonal vertical planes (the legs of a table): a reflection
///    in the plane that mirrors more of the shape, with the parts listed pair by pair, the front pair first;
/// 3. any other complete ring of 3 parts or more about a vertical axis, of 5 or more about a horizontal one;
/// 4. a row: 3 parts or more in a line, their steps within 30 % of the mean one: a translation;
/// 5. a pair mirrored in a vertical plane that mirrors most of the shape (the arms of a chair);
/// 6. a pair under half a turn about an axis in such a plane (the cranks of a bicycle): a rotation of order 2;
/// 7. a pair under a translation (the wheels of a bicycle, one drawer above another);
/// 8. a pair mirrored in the vertical plane midway between the two.
///
/// A shape longer than 1.5 times its width has two ends that differ in meaning (the head and the foot of a bed). Two
/// parts at different ends are a pair only if they are wheels, or if a third part lies above both (the aprons under a
/// table's top), or if the plane midway is the shape's only mirror plane (the wings of an aeroplane).
///
/// Any other part is a single group: `SELF`, with the normal of its mirror plane as direction, or `NONE`. Members are
/// ordered along the generator: of a pair, the one with the larger x (z) in the frame first; of a ring, by angle; of a
/// row, along the vector. Groups are ordered by their first part; their volumes and hull volumes are set. The result
/// does not depend on the order of the parts, nor on the shape's pose. O(n²) comparisons of hulls for n parts. Rows are
/// followed from ordered pairs of congruent parts, at most ten million pairs in all rounds of finding groups, such as
/// those of 1000 parts in ten rounds. After that, only the rows of the earlier rounds, the longest ones, are groups.
/// \param parts the abstractions of the shape's parts
/// \param frame the frame of the shape
/// \param options the kinds of symmetry to detect, and the tolerance
/// \param warnings receives a sentence if not all rows were looked for; may be null
std::vector<Part_group> detect_symmetry_groups(const std::vector<Part_abstraction>& parts, const Shape_frame& frame,
                                               const Symmetry_options& options = {},
                                               std::vector<std::string>* warnings = nullptr);

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_DETECT_SYMMETRY_GROUPS_H
