// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_GROUND_TRUTH_H
#define CGAL_SHAPE_CORRESPONDENCE_GROUND_TRUTH_H

#include <CGAL/Shape_correspondence/Part_correspondence.h>

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceEvaluation
/// The label of a part: coarse (`leg`) and fine (`leg_front_left`).
struct Part_label
{
  std::string coarse; ///< the role of the part
  std::string fine;   ///< fine label; empty: none
};

/// \ingroup PkgShapeCorrespondenceEvaluation
/// The corresponding parts of two labelled shapes.
struct Ground_truth
{
  Part_pairs pairs;        ///< corresponding parts, sorted, each pair once
  Part_pairs coarse_pairs; ///< parts of equal coarse label, sorted, each pair once; include `pairs`
};

/// \ingroup PkgShapeCorrespondenceEvaluation
/// The pairs of parts that correspond according to the labels of all parts. Parts correspond if their coarse labels are
/// equal. Their fine labels must be equal as well if every part of both shapes with that coarse label has a fine one,
/// and at least half of the fine labels of the shape with fewer of them occur in the other. O(n m) for n and m parts.
/// \throw Invalid_input if a coarse label is empty
Ground_truth ground_truth(const std::vector<Part_label>& source, const std::vector<Part_label>& target);

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_GROUND_TRUTH_H
