// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_BLEND_SCHEDULE_H
#define CGAL_SHAPE_CORRESPONDENCE_BLEND_SCHEDULE_H

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceMaps
/// What may happen to a part during a blend.
enum class Blend_task_type {
  MORPH,  ///< a part becomes another
  SPLIT,  ///< a piece of a part becomes another part
  MERGE,  ///< a part, or a piece of it, becomes a piece of another
  SHRINK, ///< a part without counterpart vanishes where it touches the others
  GROW    ///< the inverse of `SHRINK`
};

/// \ingroup PkgShapeCorrespondenceMaps
/// Why the surface of a part does not become that of its counterpart, but is *exchanged* for it on the way.
enum class Blend_exchange {
  NONE, ///< it is not
  TORN, ///< it would be torn or folded
  THIN  ///< it would be far thinner than at both ends
};

/// \ingroup PkgShapeCorrespondenceMaps
/// What happens to one part, and when.
struct Blend_task
{
  static constexpr std::size_t no_part = std::size_t(-1); ///< index of a part where there is none

  Blend_task_type type = Blend_task_type::MORPH;  ///< what happens
  std::size_t source = no_part;                   ///< index of the source part, if there is one
  std::size_t target = no_part;                   ///< index of the target part, if there is one
  double begin = 0;                               ///< time of the blend, in [0, 1], at which it begins
  double end = 1;                                 ///< time of the blend, in [0, 1], at which it ends
  Blend_exchange exchange = Blend_exchange::NONE; ///< whether surfaces are exchanged, and why
};

/// \ingroup PkgShapeCorrespondenceMaps
/// Measures of an in-between shape against the ends of the blend, the source and the target; 0 is best. Lengths are
/// fractions of the shape's height.
struct Blend_quality
{
  double gap = 0;       ///< by how much a contact of parts that stay is wider than at the ends, at most
  double apart = 0;     ///< how far connected components came apart, at most, before they were reconnected
  double asymmetry = 0; ///< root mean square distance from the mirror image, if both ends have a mirror plane in common
  double ground = 0;    ///< how far a part that stands on the ground at both ends is off its height there, at most
  double thinning = 0;  ///< by what fraction a part is thinner than where it is thinnest at the ends, at most
  double area = 0;      ///< by what fraction the surface is larger than at the end where it is larger
  double volume = 0;    ///< the same for the volume of closed parts
  double torn = 0;      ///< share of the surface that is folded over, or stretched far more than its part
  double overlap = 0;   ///< share of the surface that is inside closed parts, but not inside them at either end
  double wobble = 0;    ///< how much farther a part that is the same at both ends moves than those it touches, at most
};

/// \ingroup PkgShapeCorrespondenceMaps
/// Whether an in-between shape is within the tolerances of `Shape_blend`.
struct Blend_check
{
  Blend_quality quality;           ///< the measures
  std::vector<std::string> faults; ///< which tolerances are exceeded, and at which parts, in whole sentences
};

/// \ingroup PkgShapeCorrespondenceMaps
/// A plausible order of the tasks of a blend.
struct Blend_schedule
{
  std::string name;              ///< one of `Shape_blend::schedule_names()`
  std::vector<Blend_task> tasks; ///< the tasks and their times
  Blend_quality quality;         ///< the largest measures of the in-between shapes by which it is rated
};

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_BLEND_SCHEDULE_H
