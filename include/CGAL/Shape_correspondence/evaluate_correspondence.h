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
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceEvaluation
/// How well a correspondence agrees with the ground truth; all shares are between 0 and 1.
struct Correspondence_score
{
  std::size_t matched = 0;      ///< pairs of the correspondence
  std::size_t expected = 0;     ///< pairs of the ground truth
  std::size_t right = 0;        ///< pairs that are in both
  std::size_t right_coarse = 0; ///< pairs of the correspondence that have equal coarse labels

  double precision() const;        ///< right / matched; 0 if nothing is matched
  double recall() const;           ///< right / expected; if nothing is expected, 1 where nothing is matched and else 0
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
  std::string category;       ///< of both shapes, such as `chair`
  std::string source;         ///< name of the source shape, within its category
  std::string target;         ///< name of the target shape, within its category
  Correspondence_score score; ///< the score
};

/// \ingroup PkgShapeCorrespondenceEvaluation
/// A mean and its confidence interval.
struct Estimate
{
  double mean = 0; ///< the mean
  double low = 0;  ///< lower end of the confidence interval
  double high = 0; ///< upper end of the confidence interval
};

/// \ingroup PkgShapeCorrespondenceEvaluation
/// Means over the correspondences of a category, or over categories.
struct Mean_score
{
  std::size_t correspondences = 0; ///< how many there are
  std::size_t empty = 0;           ///< correspondences without a pair
  Estimate precision;              ///< of `Correspondence_score::precision()`
  Estimate recall;                 ///< of `Correspondence_score::recall()`
  Estimate f1;                     ///< of `Correspondence_score::f1()`
  Estimate coarse_precision;       ///< of `Correspondence_score::coarse_precision()`
};

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `mean_scores()`.
struct Evaluation_options
{
  int resamples = 1000;     ///< samples of the bootstrap, at least 1
  double confidence = 0.95; ///< confidence level of the intervals, in (0, 1)
  std::uint64_t seed = 0;   ///< seed of the random numbers
};

/// \ingroup PkgShapeCorrespondenceEvaluation
/// Mean scores by category and over all categories.
struct Evaluation
{
  std::vector<std::pair<std::string, Mean_score>> categories; ///< by name
  Mean_score mean;                                            ///< every category weighs the same
};

/// \ingroup PkgShapeCorrespondenceEvaluation
/// Means of scores by category and over categories. The F1 of a category is the mean of its correspondences' F1.
///
/// The intervals are those of a bootstrap over shapes: correspondences that share a shape are not independent, so
/// shapes are drawn with replacement, and the weight of a correspondence is the product of the numbers of times that
/// its two shapes are drawn (A. Owen, *The pigeonhole bootstrap*, 2007). For only two shapes, the interval is a single
/// point. The same seed gives the same result. O(resamples × correspondences).
/// \throw Invalid_input if there are no scores, or options are out of range
Evaluation mean_scores(const std::vector<Scored_correspondence>& scores, const Evaluation_options& options = {});

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_EVALUATE_CORRESPONDENCE_H
