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
  MORPH,   ///< a part becomes another
  SPLIT,   ///< a piece of a part becomes another part
  MERGE,   ///< a part, or a piece of it, becomes a piece of another
  SHRINK,  ///< a part without counterpart, or without a map onto it, shrinks to where it is held
  GROW,    ///< the inverse of `SHRINK`
  EXCHANGE ///< such a part becomes another in the same place
};

/// \ingroup PkgShapeCorrespondenceMaps
/// Why a part does not become its counterpart.
enum class Blend_obstacle {
  NONE,  ///< it does, or has no counterpart
  TORN,  ///< it would be torn or folded, or has quite another surface
  UNLIKE ///< it, or what else becomes the same part, would have to change its proportions, to travel or to be cut up
         ///< too much
};

/// \ingroup PkgShapeCorrespondenceMaps
/// What happens to one part, or a piece of one, and when. Where there is an obstacle, the part shrinks, and
/// its counterpart grows.
struct Blend_task
{
  static constexpr std::size_t no_part = std::size_t(-1); ///< index of a part where there is none

  Blend_task_type type = Blend_task_type::MORPH;  ///< what happens
  std::size_t source = no_part;                   ///< index of the source part, if there is one
  std::size_t target = no_part;                   ///< index of the target part, if there is one
  double begin = 0;                               ///< time of the blend, in [0, 1], at which it begins
  double end = 1;                                 ///< time of the blend, in [0, 1], at which it ends
  Blend_obstacle obstacle = Blend_obstacle::NONE; ///< if there is one
};

/// \ingroup PkgShapeCorrespondenceMaps
/// Measures of an in-between shape, by which schedules are rated; 0 is best.
struct Blend_quality
{
  double support = 0; ///< share by which fewer parts stand on the ground than between the ends
  double apart = 0; ///< by how much wider gaps than at the ends it takes to join all parts, over the height; 0 if less
                    ///< than .005
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
