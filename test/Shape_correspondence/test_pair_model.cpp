// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// The probability that a pair of parts is right, from what is known of it.
#include "labelled_furniture.h"
#include "roles/pair_model.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace CGAL::Shape_correspondence;
using namespace labelled_furniture;
using namespace CGAL::Shape_correspondence::internal;

TEST_CASE("The set of pairs of greatest expected F1")
{
  const auto taken = [](const std::vector<double>& p) {
    return pairs_of_greatest_expected_f1(Eigen::Map<const Eigen::ArrayXd>(p.data(), Eigen::Index(p.size())));
  };
  // Expected right: 1.7. One pair: 2 (0.9) / (1 + 1.7) = 0.667; two: 3 / 3.7 = 0.811; three: 3.4 / 4.7 = 0.723
  CHECK(taken({0.6, 0.2, 0.9}) == std::vector<char>{1, 0, 1});
  // Expected right: 0.9. One: 0.6 / 1.9; two: 1.2 / 2.9; three: 1.8 / 3.9 is the most: equals are taken together
  CHECK(taken({0.3, 0.3, 0.3}) == std::vector<char>{1, 1, 1});
  // No set is better than that of the first pair: 2 / 2.02
  CHECK(taken({0.01, 1, 0.01}) == std::vector<char>{0, 1, 0});
  CHECK(taken({}).empty());
}

TEST_CASE("Weights of the terms are those that the examples are likeliest with")
{
  // Right in 3 of 4 pairs that have the term, in 1 of 4 that have not: logits log 3 and -log 3, so the weight is 2 log
  // 3
  Judged_terms example;
  example.terms = Pair_terms::Zero(8, PAIR_TERM_COUNT);
  example.terms.col(CONSTANT).setOnes();
  example.terms.col(SAME_LABEL).head(4).setOnes();
  example.is_right.resize(8);
  example.is_right << 1, 1, 1, 0, 1, 0, 0, 0;
  const Pair_weights none = Pair_weights::Zero(),
                     weights = fitted_weights<PAIR_TERM_COUNT>({{&example, 8}}, none, none.Constant(1e-4));
  CHECK(weights[SAME_LABEL] == Approx(2 * std::log(3)).epsilon(0.01));
  CHECK(weights[CONSTANT] == Approx(-std::log(3)).epsilon(0.01));
  CHECK(weights[VOTES_AGREE] == 0);
  CHECK(probabilities(example.terms, weights)[0] == Approx(0.75).epsilon(0.01));
  // Examples that a term tells apart without fault have finite weights
  example.is_right << 1, 1, 1, 1, 0, 0, 0, 0;
  CHECK(fitted_weights<PAIR_TERM_COUNT>({{&example, 8}}, none, none.Constant(1e-4)).allFinite());
  // A charge that outweighs the examples leaves what was expected
  const Pair_weights expected = usual_pair_weights();
  CHECK((fitted_weights<PAIR_TERM_COUNT>({{&example, 8}}, expected, Pair_weights::Constant(1e6)) - expected).norm() <
        1e-4);
  CHECK((fitted_weights<PAIR_TERM_COUNT>({}, expected, Pair_weights::Ones()) - expected).norm() < pair_weight_unit);
}

TEST_CASE("Confidences are fitted to how often pairs of a probability are right")
{
  // Of pairs of a probability of .9, three quarters are right; of those of .5, a quarter
  Judged_confidences judged;
  judged.terms.resize(8, CONFIDENCE_TERM_COUNT);
  for (int k = 0; k < 8; ++k)
    judged.terms.row(k) = confidence_terms(k < 4 ? 0.9 : 0.5);
  judged.is_right.resize(8);
  judged.is_right << 1, 1, 1, 0, 1, 0, 0, 0;
  const Confidence_weights none = Confidence_weights::Zero(),
                           weights = fitted_weights<CONFIDENCE_TERM_COUNT>({{&judged, 8}}, none, none.Constant(1e-4));
  CHECK(confidence(0.9, weights) == Approx(0.75).epsilon(0.01));
  CHECK(confidence(0.5, weights) == Approx(0.25).epsilon(0.01));
  // What is certain or impossible stays so, and the usual weights change nothing
  CHECK(confidence(0, weights) == 0);
  CHECK(confidence(1, weights) == 1);
  CHECK(confidence(0.3, usual_confidence_weights()) == Approx(0.3));
}
