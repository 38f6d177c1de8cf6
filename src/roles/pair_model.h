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
  EXCESS,         // cost, less the least cost of the source part, plus cost, less the least cost of the target part
  CONSTANT,       // 1
  PAIR_TERM_COUNT
};

// One row for each pair of parts, source by source.
using Pair_terms = Eigen::Matrix<double, Eigen::Dynamic, PAIR_TERM_COUNT>;
// Weights of the terms in the logit of the probability that a pair is right.
using Pair_weights = Eigen::Matrix<double, PAIR_TERM_COUNT, 1>;

// Whether labels or votes have weight; if not, shapes of the category are matched by geometry alone.
inline bool uses_roles(const Pair_weights& weights) { return weights.head<GEOMETRIC_PAIR>().any(); }

// Weights for categories with too few pairs to fit weights to: fitted to the labelled shapes of the package's role
// model, each pair matched with neither shape in the training (`weights` in data/roles/manifest.json).
Pair_weights usual_pair_weights();

// The weights for a category with this number of labelled shapes: the fewer there are, the less the labels count, and
// the more the geometric match does.
Pair_weights usual_pair_weights(std::size_t labelled_shapes);

// The `EXCESS` of every pair. \param costs of substituting parts: source × target
Eigen::MatrixXd excess_of_pairs(const Eigen::MatrixXd& costs);

// The probabilities that the pairs are right. \param evidence added to the logits; empty: none
Eigen::ArrayXd probabilities(const Pair_terms& terms, const Pair_weights& weights, const Eigen::ArrayXd& evidence = {});

// For each pair, whether it is one of the most probable pairs, taken as many as give the greatest expected F1,
// 2 Σ taken p / (number taken + Σ all p): many if parts are recognized well, else few. O(n log n).
std::vector<char> pairs_of_greatest_expected_f1(const Eigen::ArrayXd& probabilities);

// Calibration of confidences: the probability that a matched pair is right has the logit of its probability times the
// slope, plus the offset. The pairs that are matched are the most probable ones, so that fewer of them are right than
// their probabilities say.
enum Confidence_term : int { SLOPE, OFFSET, CONFIDENCE_TERM_COUNT };
using Confidence_weights = Eigen::Matrix<double, CONFIDENCE_TERM_COUNT, 1>;

inline Confidence_weights usual_confidence_weights() { return {1, 0}; }

constexpr double least_doubt = 1e-3; // least distance of a confidence from 0 and 1, for finite logits

// The factors of the calibration's weights for a pair of this probability: its logit, and 1.
Eigen::Matrix<double, 1, CONFIDENCE_TERM_COUNT> confidence_terms(double probability);

// The calibrated confidence of a pair; probabilities 0 and 1 stay.
double confidence(double probability, const Confidence_weights& weights);

constexpr double pair_weight_unit = 1e-6; // unit of the weights of terms in a file

} // namespace CGAL::Shape_correspondence::internal
