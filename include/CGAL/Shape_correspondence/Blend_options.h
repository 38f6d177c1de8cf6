// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_BLEND_OPTIONS_H
#define CGAL_SHAPE_CORRESPONDENCE_BLEND_OPTIONS_H

#include <functional>
#include <string>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceOptions
/// The size of in-between shapes. The two models may be in different units.
enum class Blend_size {
  BLEND,  ///< from the source's size to the target's, by equal factors in equal times
  SOURCE, ///< the source's size; the target is scaled to its height
  TARGET, ///< the target's size; the source is scaled to its height
  SAME    ///< height 1; both are scaled
};

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `Shape_blend`.
struct Blend_options
{
  /// Largest gap between parts in contact in the source or target, as a fraction of the height, in [0, 1].
  double contact_tolerance = 0.02;
  int samples = 7; ///< number of in-between shapes by which a schedule is rated, 1 to 1000
  /// Pairs of lower confidence, in [0, 1], are not morphed: their parts shrink and grow. By default, those that are
  /// more probably wrong than right.
  double min_confidence = 0.5;
  Blend_size size = Blend_size::BLEND; ///< size of the in-between shapes
  std::string schedule;                ///< name of the schedule to use; empty: the best one
  /// Called with the fraction done, in [0, 1], during the search for the steps in which parts are exchanged, and before
  /// a schedule is rated; `false` ends both, and the schedule `in two steps` is used with the best steps so far.
  std::function<bool(double)> progress;
};

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_BLEND_OPTIONS_H
