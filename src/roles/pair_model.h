// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// Terms of the logistic model of a pair of parts; all are the same with source and target swapped.
enum Pair_term : int {
  SAME_LABEL,     // 1 or 0: the parts correspond by the likeliest labels of all parts, as by `ground_truth()`
  SAME_ROLE,      // 1 or 0: the likeliest roles of the two parts are the same
  VOTES_AGREE,    // cosine of the votes for the roles of the two parts
  GEOMETRIC_PAIR, // 1 or 0: the geometric match has the pair
  EXCESS,         // cost over that of the best pair of either part, summed over both
  CONSTANT,       // 1
  PAIR_TERM_COUNT
};

// One row per pair of parts, source by source.
using Pair_terms = Eigen::Matrix<double, Eigen::Dynamic, PAIR_TERM_COUNT>;
// Weights of the terms in the logit of the probability that a pair is right.
using Pair_weights = Eigen::Matrix<double, PAIR_TERM_COUNT, 1>;

// Whether labels and votes count; if not, shapes of the category are matched by geometry alone.
inline bool uses_roles(const Pair_weights& weights) { return weights.head<GEOMETRIC_PAIR>().any(); }

// Fitted to the labelled shapes that the role model of the package was learned from, each pair of shapes matched with
// neither in the training (`weights` in data/roles/manifest.json); where there are too few pairs to fit weights to.
Pair_weights usual_pair_weights();

// The weights for a category of which so many shapes are labelled: the fewer there are, the less the labels count, and
// the more the geometric match does.
Pair_weights usual_pair_weights(std::size_t labelled_shapes);

// The excess of every pair.
Eigen::MatrixXd excess_of_pairs(const Eigen::MatrixXd& costs);

// The probabilities that the pairs are right. \param evidence added to the logits; empty: none
Eigen::ArrayXd probabilities(const Pair_terms& terms, const Pair_weights& weights, const Eigen::ArrayXd& evidence = {});

// For each pair, whether it is taken. Those taken, the most probable ones, have the greatest expected F1: many where
// the parts are told well, few where they are not. O(n log n).
std::vector<char> pairs_of_greatest_expected_f1(const Eigen::ArrayXd& probabilities);

// Calibration of confidences: the probability that a matched pair is right has the logit of its probability times the
// slope, plus the offset. The pairs that are matched are the most probable ones, so that fewer of them are right than
// their probabilities say.
enum Confidence_term : int { SLOPE, OFFSET, CONFIDENCE_TERM_COUNT };
using Confidence_weights = Eigen::Matrix<double, CONFIDENCE_TERM_COUNT, 1>;

inline Confidence_weights usual_confidence_weights() { return {1, 0}; }

constexpr double least_doubt = 1e-3; // distance of a confidence from 0 and 1, which keeps its logit finite

// The terms of the calibration of a pair of this probability.
Eigen::Matrix<double, 1, CONFIDENCE_TERM_COUNT> confidence_terms(double probability);

// The calibrated confidence; 0 and 1 stay.
double confidence(double probability, const Confidence_weights& weights);

constexpr double pair_weight_unit = 1e-6; // unit of weights in a file

} // namespace CGAL::Shape_correspondence::internal
