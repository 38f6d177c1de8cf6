// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_EVALUATE_CORRESPONDENCE_H
#define CGAL_SHAPE_CORRESPONDENCE_EVALUATE_CORRESPONDENCE_H

#include <CGAL/Shape_correspondence/ground_truth.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceEvaluation
/// The agreement of a correspondence with the ground truth; all shares are in [0, 1].
struct Correspondence_score
{
  std::size_t matched = 0;      ///< number of pairs of the correspondence
  std::size_t expected = 0;     ///< number of pairs of the ground truth
  std::size_t right = 0;        ///< number of pairs that are in both
  std::size_t right_coarse = 0; ///< number of pairs of the correspondence with equal coarse labels

  double precision() const;        ///< right / matched; 0 if nothing is matched
  double recall() const;           ///< right / expected; if nothing is expected, 1 if nothing is matched and else 0
  double f1() const;               ///< harmonic mean of precision and recall; 0 if both are 0
  double coarse_precision() const; ///< right_coarse / matched; 0 if nothing is matched
};

/// \ingroup PkgShapeCorrespondenceEvaluation
/// Scores a correspondence, given its `part_pairs()`; a pair that is listed twice counts once.
Correspondence_score evaluate_correspondence(Part_pairs pairs, const Ground_truth& truth);

/// \ingroup PkgShapeCorrespondenceEvaluation
/// The score of a correspondence of two shapes of a category.
struct Scored_correspondence
{
  std::string category;       ///< category of both shapes, such as `chair`
  std::string source;         ///< name of the source shape, within its category
  std::string target;         ///< name of the target shape, within its category
  Correspondence_score score; ///< the score
};

/// \ingroup PkgShapeCorrespondenceEvaluation
/// Means over the correspondences of a category, or over categories.
struct Mean_score
{
  std::size_t correspondences = 0; ///< number of correspondences
  double precision = 0;            ///< mean of `Correspondence_score::precision()`
  double recall = 0;               ///< mean of `Correspondence_score::recall()`
  double f1 = 0;                   ///< mean of `Correspondence_score::f1()`
};

/// \ingroup PkgShapeCorrespondenceEvaluation
/// Mean scores by category and over all categories.
struct Evaluation
{
  std::vector<std::pair<std::string, Mean_score>> categories; ///< sorted by name
  Mean_score mean;                                            ///< mean over categories, which weigh the same
};

/// \ingroup PkgShapeCorrespondenceEvaluation
/// The means of scores by category and over categories. The F1 of a category is the mean of its correspondences' F1.
/// \throw Invalid_input if there are no scores
Evaluation mean_scores(const std::vector<Scored_correspondence>& scores);

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_EVALUATE_CORRESPONDENCE_H
