// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// The laboratory: weights fitted to pairs of shapes, cross-validated correspondences, and intervals of scores.
#include "experiments/intervals.h"
#include "experiments/role_validation.h"
#include "labelled_furniture.h"

#include <CGAL/Shape_correspondence/train_role_model.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace CGAL::Shape_correspondence;
using namespace labelled_furniture;
using namespace CGAL::Shape_correspondence::experiments;

namespace {

std::vector<Validation_shape> validation_shapes(const std::deque<Furniture>& shapes)
{
  std::vector<Validation_shape> result;
  for (const Furniture& shape : shapes) {
    result.push_back({{&shape.graph, shape.category, shape.labels, 1}, shape.category + " maker"});
  }
  return result;
}

std::vector<Shape_pair> pairs_of_category(const std::deque<Furniture>& shapes, std::size_t count)
{
  std::vector<Shape_pair> result;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      if (shapes[i].category == shapes[j].category) result.push_back({i, j});
  return result;
}

} // namespace

TEST_CASE("Weights are fitted to pairs of shapes, each matched as by a model that has seen neither")
{
  const std::vector<Validation_shape> shapes = validation_shapes(examples());
  const Role_validation validation(shapes, pairs_of_category(examples(), shapes.size()), {}, {});
  const Role_model_data usual = Role_model_access::data(train_role_model(labelled(examples()))),
                        fitted = Role_model_access::data(validation.fitted_model());
  for (std::size_t c = 0; c < usual.categories.size(); ++c) {
    CHECK(fitted.categories[c].examples.size() == usual.categories[c].examples.size());
    const Pair_weights& weights = fitted.categories[c].weights;
    CHECK(weights != usual.categories[c].weights);
    // Geometry alone matches chairs rightly, so that roles gain nothing; for shelves, no example contradicts the
    // labels, so that equal labels get more weight than usual
    CHECK(uses_roles(weights) == (fitted.categories[c].name == "shelf"));
    if (uses_roles(weights)) CHECK(weights[SAME_LABEL] > usual_pair_weights()[SAME_LABEL]);
  }
}

TEST_CASE("Pairs of shapes that the training did not see are matched rightly where their category is recognized")
{
  const std::vector<Validation_shape> shapes = validation_shapes(examples());
  const std::vector<Shape_pair> all = pairs_of_category(examples(), shapes.size());
  const Role_validation validation(shapes, all, {}, {});
  REQUIRE(validation.pairs().size() == all.size());
  for (const Validated_pair& pair : validation.pairs()) {
    const std::string& category = examples()[pair.shapes[0]].category;
    CHECK((pair.category.empty() || pair.category == category));
    // Labels are right for shapes similar to those of the training
    if (!pair.category.empty()) CHECK(pair.joined.f1() == 1);
    CHECK(pair.judged.size() == pair.joined.matched);
    const auto count = [&](bool Judged_pair::*what) {
      return std::size_t(std::count_if(pair.judged.begin(), pair.judged.end(),
                                       [&](const Judged_pair& judged) { return judged.*what; }));
    };
    CHECK(count(&Judged_pair::is_right) == pair.joined.right);
    CHECK(count(&Judged_pair::has_one_role) == pair.joined.right_coarse);
  }
}

TEST_CASE("Shapes that are turned by any angle are matched as those that face the front")
{
  std::vector<Validation_shape> shapes = validation_shapes(examples());
  std::vector<Shape_pair> chairs;
  for (const Shape_pair& pair : pairs_of_category(examples(), shapes.size()))
    if (shapes[pair[0]].labelled.category == "chair") chairs.push_back(pair);
  Validation_options options;
  options.turns = Validation_turns::ANY;
  options.fronts = Validation_fronts::AUTO;
  SECTION("whose fronts are all equally likely") {}
  SECTION("one of which is generated")
  {
    const std::size_t generated = chairs.back()[1];
    shapes[generated].labelled.is_generated = true;
    chairs.erase(std::remove_if(chairs.begin(), chairs.end(),
                                [&](const Shape_pair& pair) { return pair[0] == generated || pair[1] == generated; }),
                 chairs.end());
    REQUIRE(!chairs.empty());
  }
  SECTION("by multiples of 90°, of which the given front is the likeliest")
  {
    options.turns = Validation_turns::QUARTERS;
    options.fronts = Validation_fronts::LIKELY;
    options.category_known = true;
  }
  const Role_validation validation(shapes, chairs, options, {});
  int known = 0;
  for (const Validated_pair& pair : validation.pairs())
    if (!pair.category.empty()) {
      ++known;
      CHECK(pair.category == "chair");
      CHECK(pair.joined.f1() == 1);
    }
  CHECK(known > 0);
}

TEST_CASE("Shapes left out of the training are unknown to the model")
{
  const std::vector<Validation_shape> shapes = validation_shapes(examples());
  const std::vector<Shape_pair> pairs{{0, 2}, {1, 3}};
  for (const Left_out left_out : {Left_out::SOURCES, Left_out::CATEGORY}) { // each category has one source
    Validation_options options;
    options.left_out = left_out;
    const Role_validation validation(shapes, pairs, options, {});
    for (const Validated_pair& pair : validation.pairs()) {
      CHECK(pair.category.empty());
      CHECK(pair.joined.right == pair.geometric.right);
      CHECK(pair.joined.matched == pair.geometric.matched);
    }
  }
}

TEST_CASE("The training sees the given number of examples of the category, and neither shape of the pair")
{
  const std::vector<Validation_shape> shapes = validation_shapes(examples());
  const std::vector<Shape_pair> pairs{{0, 2}, {1, 3}};
  Validation_options options;
  options.left_out = Left_out::CATEGORY;
  options.category_known = true;
  for (const std::size_t count : {1u, 3u, 100u}) {
    options.examples = count;
    const Role_validation validation(shapes, pairs, options, {});
    for (const Validated_pair& pair : validation.pairs()) {
      CHECK(pair.category == shapes[pair.shapes[0]].labelled.category);
      CHECK(pair.labels_joined == 1);
    }
  }
  options.examples.reset();
  const Role_validation unseen(shapes, pairs, options, {});
  for (const Validated_pair& pair : unseen.pairs())
    CHECK(pair.category.empty());
  // Three examples are all that there are, so the result is that of leaving out the shapes of the pair only
  options.left_out = Left_out::SHAPES;
  options.examples = 3;
  const Role_validation few(shapes, pairs, options, {});
  options.examples.reset();
  const Role_validation all(shapes, pairs, options, {});
  for (std::size_t i = 0; i < pairs.size(); ++i)
    CHECK(few.pairs()[i].joined.right == all.pairs()[i].joined.right);
}

TEST_CASE("Confidence intervals come from drawing shapes with replacement")
{
  // Three shapes with the pairs ab (1), ac (1), bc (0): a draw of all gives 2/3, {a, a, b} has ab alone and gives 1,
  // {b, b, c} gives 0; every draw with a pair gives one of these
  const auto scored = [](const char* source, const char* target, std::size_t right) {
    return Scored_correspondence{"x", source, target, {1, 1, right, right}};
  };
  const std::vector<Scored_correspondence> three{scored("a", "b", 1), scored("a", "c", 1), scored("b", "c", 0)};
  const Estimate f1 = mean_estimates(three).categories[0].second.f1;
  CHECK(f1.mean == Approx(2. / 3));
  CHECK(f1.low == 0);
  CHECK(f1.high == 1);
  // The paired difference of equal scores is 0, and with two shapes every draw that has a pair gives the same mean
  CHECK(mean_estimates(three, three).mean.f1.high == 0);
  CHECK(mean_estimates({three[0]}).mean.recall.low == 1);
}

TEST_CASE("Fitted weights of terms maximize the likelihood of the examples")
{
  // Right in 3 of 4 pairs with the term, in 1 of 4 without: logits log 3 and -log 3, so the weight is 2 log 3
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
  // Examples that a term separates perfectly give finite weights
  example.is_right << 1, 1, 1, 1, 0, 0, 0, 0;
  CHECK(fitted_weights<PAIR_TERM_COUNT>({{&example, 8}}, none, none.Constant(1e-4)).allFinite());
  // A penalty that outweighs the examples keeps the expected weights
  const Pair_weights expected = usual_pair_weights();
  CHECK((fitted_weights<PAIR_TERM_COUNT>({{&example, 8}}, expected, Pair_weights::Constant(1e6)) - expected).norm() <
        1e-4);
  CHECK((fitted_weights<PAIR_TERM_COUNT>({}, expected, Pair_weights::Ones()) - expected).norm() < pair_weight_unit);
}

TEST_CASE("Confidences are fitted to the share of correct pairs at each probability")
{
  // Of pairs with probability .9, three quarters are right; with .5, a quarter
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
  // Certain and impossible pairs keep their probability, and the usual weights change nothing
  CHECK(confidence(0, weights) == 0);
  CHECK(confidence(1, weights) == 1);
  CHECK(confidence(0.3, usual_confidence_weights()) == Approx(0.3));
}
