// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_PART_CORRESPONDENCE_H
#define CGAL_SHAPE_CORRESPONDENCE_PART_CORRESPONDENCE_H

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceCorrespondence
/// One of several equally long segments of a curve (paper, section 5, cutting); the whole part if there is only one.
/// The types are small, since sets of shapes keep millions of pairs.
struct Curve_segment
{
  short index = 0; ///< position along the curve, from 0 on
  short count = 1; ///< number of segments of the curve

  /// Whether the part is not cut.
  bool is_whole_part() const { return count == 1; }

  /// Whether index and count are equal.
  friend bool operator==(const Curve_segment& a, const Curve_segment& b)
  {
    return a.index == b.index && a.count == b.count;
  }
};

/// \ingroup PkgShapeCorrespondenceCorrespondence
/// A part of the source and a part of the target that correspond, by their indices in the shapes.
struct Part_correspondence
{
  std::size_t source = 0; ///< the source part
  std::size_t target = 0; ///< the target part
  /// Probability that the pair is right, in [0, 1]; NaN if the method does not compute it.
  double confidence = std::numeric_limits<double>::quiet_NaN();
  Curve_segment source_segment = {}; ///< segment of the source part, if the search cut it
  Curve_segment target_segment = {}; ///< segment of the target part, if the search cut it

  /// Whether the method computes a confidence.
  bool has_confidence() const { return !std::isnan(confidence); }

  /// Whether all members are equal; NaN confidences count as equal.
  friend bool operator==(const Part_correspondence& a, const Part_correspondence& b)
  {
    const bool same_confidence = a.has_confidence() ? a.confidence == b.confidence : !b.has_confidence();
    return a.source == b.source && a.target == b.target && same_confidence && a.source_segment == b.source_segment &&
           a.target_segment == b.target_segment;
  }
};

/// \ingroup PkgShapeCorrespondenceCorrespondence
/// The order of pairs in lists: by source, then target.
inline bool is_before(const Part_correspondence& a, const Part_correspondence& b)
{
  return a.source != b.source ? a.source < b.source : a.target < b.target;
}

/// \ingroup PkgShapeCorrespondenceCorrespondence
/// The pair with source and target swapped.
inline Part_correspondence inverse(const Part_correspondence& pair)
{
  return {pair.target, pair.source, pair.confidence, pair.target_segment, pair.source_segment};
}

/// \ingroup PkgShapeCorrespondenceCorrespondence
/// Pairs of a source part and a target part, by their indices.
using Part_pairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// \ingroup PkgShapeCorrespondenceCorrespondence
/// The pairs of a correspondence or a part map as pairs of indices.
inline Part_pairs part_pairs(const std::vector<Part_correspondence>& pairs)
{
  Part_pairs result;
  for (const Part_correspondence& pair : pairs)
    result.emplace_back(pair.source, pair.target);
  return result;
}

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_PART_CORRESPONDENCE_H
