// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Correspondences of shapes that the training of roles does not have.
#include "labelled_furniture.h"
#include "matching/cross_validate_roles.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace CGAL::Shape_correspondence;
using namespace labelled_furniture;
using namespace CGAL::Shape_correspondence::internal;
using Catch::Matchers::Contains;

namespace {

std::vector<Validation_shape> validation_shapes(const std::deque<Furniture>& shapes)
{
  std::vector<Validation_shape> result;
  for (const Furniture& shape : shapes) {
    result.push_back({{&shape.graph, shape.category, shape.labels, 1}, shape.category + " maker"});
  }
  return result;
}

// All pairs of shapes of a category among the first ones.
std::vector<Validation_pair> pairs_of_category(const std::deque<Furniture>& shapes, std::size_t count)
{
  std::vector<Validation_pair> result;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      if (shapes[i].category == shapes[j].category) result.push_back({i, j});
  return result;
}

} // namespace

TEST_CASE("Pairs of shapes that the training did not see")
{
  const std::vector<Validation_shape> shapes = validation_shapes(examples());
  const std::vector<Validation_pair> all = pairs_of_category(examples(), shapes.size());
  const Role_validation validation(shapes, all, {}, {});
  REQUIRE(validation.pairs().size() == all.size());
  for (const Validated_pair& pair : validation.pairs()) {
    const std::string& category = examples()[pair.shapes[0]].category;
    CHECK((pair.category.empty() || pair.category == category));
    // Labels of what the training has seen the like of are right
    if (!pair.category.empty()) CHECK(pair.joined.f1() == 1);
    CHECK(pair.judged.size() == pair.joined.matched);
    const auto count = [&](bool Judged_pair::*what) {
      return std::size_t(std::count_if(pair.judged.begin(), pair.judged.end(),
                                       [&](const Judged_pair& judged) { return judged.*what; }));
    };
    CHECK(count(&Judged_pair::is_right) == pair.joined.right);
    CHECK(count(&Judged_pair::has_one_role) == pair.joined.right_coarse);
  }
  // Nothing speaks against the labels, so they count for no less than usual
  const Role_model model = validation.model();
  for (const Category_roles& category : model.data().categories)
    CHECK(category.weights[SAME_LABEL] >= usual_pair_weights()[SAME_LABEL]);
}

TEST_CASE("Shapes that are turned by any angle are matched as those that face the front")
{
  const std::vector<Validation_shape> shapes = validation_shapes(examples());
  std::vector<Validation_pair> chairs;
  for (const Validation_pair& pair : pairs_of_category(examples(), shapes.size()))
    if (shapes[pair[0]].labelled.category == "chair") chairs.push_back(pair);
  Validation_options options;
  options.turns = Validation_turns::ANY;
  options.fronts = Validation_fronts::AUTO;
  SECTION("of which any front is as likely") {}
  SECTION("by multiples of 90°, of which the given front is the likeliest")
  {
    options.turns = Validation_turns::QUARTERS;
    options.fronts = Validation_fronts::LIKELY;
    options.category_is_told = true;
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

TEST_CASE("What was left out of the training is not known")
{
  const std::vector<Validation_shape> shapes = validation_shapes(examples());
  const std::vector<Validation_pair> pairs{{0, 2}, {1, 3}};
  for (const Left_out left_out : {Left_out::SOURCES, Left_out::CATEGORY}) { // each category is of one source
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

TEST_CASE("Few examples: the training sees so many shapes of the category, and neither of the pair")
{
  const std::vector<Validation_shape> shapes = validation_shapes(examples());
  const std::vector<Validation_pair> pairs{{0, 2}, {1, 3}};
  Validation_options options;
  options.left_out = Left_out::CATEGORY;
  options.category_is_told = true;
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
  // As many as there are: the same as with the shapes left out alone
  options.left_out = Left_out::SHAPES;
  options.examples = 3;
  const Role_validation few(shapes, pairs, options, {});
  options.examples.reset();
  const Role_validation all(shapes, pairs, options, {});
  for (std::size_t i = 0; i < pairs.size(); ++i)
    CHECK(few.pairs()[i].joined.right == all.pairs()[i].joined.right);
}
