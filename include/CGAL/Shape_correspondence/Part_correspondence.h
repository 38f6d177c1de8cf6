// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_PART_CORRESPONDENCE_H
#define CGAL_SHAPE_CORRESPONDENCE_PART_CORRESPONDENCE_H

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

/// Which of several equally long segments of a curve (paper, section 5, cutting); of one: the whole part. As small as
/// it is since sets of shapes keep millions of pairs.
struct Curve_segment
{
  short index = 0, count = 1;

  bool is_whole_part() const { return count == 1; }

  friend bool operator==(const Curve_segment& a, const Curve_segment& b)
  {
    return a.index == b.index && a.count == b.count;
  }
};

/// A part of the source and a part of the target that correspond, by their indices in the shapes.
struct Part_correspondence
{
  std::size_t source = 0, target = 0;
  /// How probable it is, between 0 and 1. Not a number where the method does not tell.
  double confidence = std::numeric_limits<double>::quiet_NaN();
  /// What of either part corresponds, where the search cuts curves.
  Curve_segment source_segment = {}, target_segment = {};

  bool has_confidence() const { return !std::isnan(confidence); }

  /// Equal also where neither has a confidence.
  friend bool operator==(const Part_correspondence& a, const Part_correspondence& b)
  {
    const bool same_confidence = a.has_confidence() ? a.confidence == b.confidence : !b.has_confidence();
    return a.source == b.source && a.target == b.target && same_confidence && a.source_segment == b.source_segment &&
           a.target_segment == b.target_segment;
  }
};

/// The order in which pairs are listed: by source, then target.
inline bool is_before(const Part_correspondence& a, const Part_correspondence& b)
{
  return a.source != b.source ? a.source < b.source : a.target < b.target;
}

/// The same with source and target swapped.
inline Part_correspondence inverse(const Part_correspondence& pair)
{
  return {pair.target, pair.source, pair.confidence, pair.target_segment, pair.source_segment};
}

/// Indices of a source part and a target part.
using Part_pairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// The pairs of a correspondence or a part map without what else is known of them.
inline Part_pairs part_pairs(const std::vector<Part_correspondence>& pairs)
{
  Part_pairs result;
  for (const Part_correspondence& pair : pairs)
    result.emplace_back(pair.source, pair.target);
  return result;
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_PART_CORRESPONDENCE_H
