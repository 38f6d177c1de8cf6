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

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceMaps
/// Kinds of changes of a part during a blend.
enum class Blend_task_type {
  MORPH,   ///< a part morphs to its counterpart
  SPLIT,   ///< a piece of a part morphs to another part
  MERGE,   ///< a part, or a piece of it, morphs to a piece of another
  SHRINK,  ///< a part without counterpart, or that cannot morph to it, shrinks to where it is attached
  GROW,    ///< the inverse of `SHRINK`
  EXCHANGE ///< a part replaces an unmatched part in the same place
};

/// \ingroup PkgShapeCorrespondenceMaps
/// The reason why a part does not morph to its counterpart.
enum class Blend_obstacle {
  NONE, ///< none: the part morphs, or has no counterpart
  TORN, ///< the part's surface is too different from that of its counterpart
  /// The part, or another one with the same counterpart, would move far, come off what it touches, or be cut into
  /// pieces of other proportions.
  UNLIKE
};

/// \ingroup PkgShapeCorrespondenceMaps
/// The change of a part, or a piece of one, and its times. With an obstacle, the part shrinks and its counterpart
/// grows.
struct Blend_task
{
  static constexpr std::size_t no_part = std::size_t(-1); ///< index for "no part"

  Blend_task_type type = Blend_task_type::MORPH;  ///< kind of change
  std::size_t source = no_part;                   ///< index of the source part, or `no_part`
  std::size_t target = no_part;                   ///< index of the target part, or `no_part`
  double begin = 0;                               ///< time of the blend, in [0, 1], at which the change begins
  double end = 1;                                 ///< time of the blend, in [0, 1], at which the change ends
  Blend_obstacle obstacle = Blend_obstacle::NONE; ///< why the part does not morph
};

/// \ingroup PkgShapeCorrespondenceMaps
/// Measures of an in-between shape, by which schedules are rated; 0 is best.
struct Blend_quality
{
  double support = 0; ///< 1 - parts on the ground / their number interpolated from both ends, at least 0
  /// Widest gap that has to be bridged to join all parts, minus the wider one of the same gaps of source and target,
  /// over the height; 0 if the difference is less than .005.
  double apart = 0;
};

/// \ingroup PkgShapeCorrespondenceMaps
/// A plausible order of the tasks of a blend.
struct Blend_schedule
{
  std::string name;              ///< one of `Shape_blend::schedule_names()`
  std::vector<Blend_task> tasks; ///< the tasks and their times
  Blend_quality quality;         ///< largest measures over its `Blend_options::samples` in-between shapes
};

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_BLEND_SCHEDULE_H
