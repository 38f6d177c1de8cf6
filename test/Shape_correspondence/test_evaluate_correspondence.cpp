// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/evaluate_correspondence.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>

// Every number here is worked out by hand.

using namespace CGAL::Shape_correspondence;

namespace {

/// Scores whose precision and recall are `right` of `matched` and of `expected`.
Scored_correspondence scored(const std::string& category, const std::string& source, const std::string& target,
                             std::size_t right, std::size_t matched, std::size_t expected)
{
  return {category, source, target, {matched, expected, right, matched}};
}

std::array<double, 3> values(const Estimate& e) { return {e.mean, e.low, e.high}; }

} // namespace

TEST_CASE("Fine labels decide where all parts have them and both sides share half of the smaller set")
{
  const std::vector<Part_label> chair{{"leg", "front"}, {"leg", "back"}, {"seat", ""}};
  // {front, back} and {front, middle, rear} share 1 of 2: enough
  const Ground_truth half = ground_truth(chair, {{"leg", "front"}, {"leg", "middle"}, {"leg", "rear"}, {"back", ""}});
  CHECK(half.pairs == Part_pairs{{0, 0}});
  CHECK(half.coarse_pairs == Part_pairs{{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}, {1, 2}});
  // they share none: every leg with every leg
  const Ground_truth none = ground_truth(chair, {{"leg", "middle"}, {"seat", "cushion"}});
  CHECK(none.pairs == Part_pairs{{0, 0}, {1, 0}, {2, 1}});
  // one leg without a fine label
  const Ground_truth open = ground_truth(chair, {{"leg", ""}, {"leg", "front"}});
  CHECK(open.pairs == open.coarse_pairs);
  CHECK(open.pairs == Part_pairs{{0, 0}, {0, 1}, {1, 0}, {1, 1}});
  // {front, back, left} and {front, x, y} share 1 of 3: not half
  const Ground_truth third = ground_truth({{"leg", "front"}, {"leg", "back"}, {"leg", "left"}},
                                          {{"leg", "front"}, {"leg", "x"}, {"leg", "y"}});
  CHECK(third.pairs.size() == 9);
  // the same fine label on several parts is one in the set
  const Ground_truth twins =
      ground_truth({{"wheel", "rear"}, {"wheel", "rear"}, {"wheel", "front"}}, {{"wheel", "rear"}, {"wheel", "front"}});
  CHECK(twins.pairs == Part_pairs{{0, 0}, {1, 0}, {2, 1}});
}

TEST_CASE("The truth is the same from both sides, and no pair crosses coarse labels")
{
  const std::vector<Part_label> a{{"leg", "front"}, {"leg", "back"}, {"seat", ""}, {"arm", "left"}};
  const std::vector<Part_label> b{{"seat", "pad"}, {"leg", "back"}, {"back", "left"}, {"leg", "front"}};
  Part_pairs turned;
  for (const auto& [i, j] : ground_truth(b, a).pairs)
    turned.emplace_back(j, i);
  std::sort(turned.begin(), turned.end());
  CHECK(ground_truth(a, b).pairs == turned);
  CHECK(turned == Part_pairs{{0, 3}, {1, 1}, {2, 0}});
  CHECK_THROWS_AS(ground_truth({{"", "front"}}, b), Invalid_input);
}

TEST_CASE("Precision, recall, F1 and coarse precision")
{
  const Ground_truth truth{{{0, 0}, {1, 1}, {2, 2}, {2, 3}}, {{0, 0}, {0, 1}, {1, 0}, {1, 1}, {2, 2}, {2, 3}}};
  // right: (1, 1), (2, 2); wrong but coarse: (0, 1); wrong: (3, 0), (3, 1); listed twice: (1, 1)
  const Correspondence_score s = evaluate_correspondence({{3, 1}, {1, 1}, {2, 2}, {0, 1}, {1, 1}, {3, 0}}, truth);
  CHECK(s.matched == 5);
  CHECK(s.expected == 4);
  CHECK(s.right == 2);
  CHECK(s.precision() == Approx(.4));
  CHECK(s.recall() == Approx(.5));
  CHECK(s.f1() == Approx(4. / 9));
  CHECK(s.coarse_precision() == Approx(.6));
}

TEST_CASE("Nothing matched, nothing expected")
{
  const Ground_truth one{{{0, 0}}, {{0, 0}}}, none;
  const Correspondence_score silent = evaluate_correspondence({}, one);
  CHECK(silent.precision() == 0);
  CHECK(silent.recall() == 0);
  CHECK(silent.f1() == 0);
  CHECK(silent.coarse_precision() == 0);
  CHECK(evaluate_correspondence({}, none).recall() == 1);
  CHECK(evaluate_correspondence({}, none).f1() == 0);
  CHECK(evaluate_correspondence({{0, 0}}, none).recall() == 0);
}

TEST_CASE("Means are of results within a category, and of categories")
{
  // F1: 1 and 0 in the one category, 2/3 in the other
  const Evaluation e = mean_scores(
      {scored("table", "c", "d", 1, 1, 2), scored("chair", "a", "b", 2, 2, 2), scored("chair", "a", "c", 0, 0, 3)});
  REQUIRE(e.categories.size() == 2);
  CHECK(e.categories[0].first == "chair");
  const Mean_score &chair = e.categories[0].second, &table = e.categories[1].second;
  CHECK(chair.correspondences == 2);
  CHECK(chair.empty == 1);
  CHECK(chair.f1.mean == Approx(.5));
  CHECK(table.recall.mean == Approx(.5));
  CHECK(table.f1.mean == Approx(2. / 3));
  CHECK(e.mean.correspondences == 3);
  CHECK(e.mean.empty == 1);
  CHECK(e.mean.precision.mean == Approx(.75));
  CHECK(e.mean.f1.mean == Approx(7. / 12));
}

TEST_CASE("Intervals come from drawing shapes")
{
  // Of three shapes with the pairs ab (1), ac (1), bc (0): a draw that has all gives 2/3, {a, a, b} gives ab alone: 1,
  // {b, b, c} gives 0; every draw of a pair or more gives one of these
  const std::vector<Scored_correspondence> three{scored("x", "a", "b", 1, 1, 1), scored("x", "a", "c", 1, 1, 1),
                                                 scored("x", "b", "c", 0, 1, 1)};
  const Evaluation e = mean_scores(three);
  CHECK(e.categories[0].second.f1.mean == Approx(2. / 3));
  CHECK(e.categories[0].second.f1.low == 0);
  CHECK(e.categories[0].second.f1.high == 1);
  CHECK(values(e.mean.f1) == values(e.categories[0].second.f1));
  // Draws of all three, of a and b, of a and c, and of b and c are as many each, so a quarter of them give 0
  Evaluation_options half;
  half.confidence = .4; // from the .3 to the .7 quantile
  CHECK(mean_scores(three, half).mean.f1.low == Approx(2. / 3));
  CHECK(mean_scores(three, half).mean.f1.high == 1);
}

TEST_CASE("Intervals are reproducible, shrink with evidence, and cover the mean")
{
  std::vector<Scored_correspondence> few, many;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < i; ++j) {
      const Scored_correspondence s =
          scored("x", std::to_string(i), std::to_string(j), std::size_t((i * 7 + j * 3) % 5), 4, 4);
      many.push_back(s);
      if (i < 6) few.push_back(s);
    }
  const Estimate wide = mean_scores(few).mean.recall, narrow = mean_scores(many).mean.recall;
  CHECK(narrow.high - narrow.low < wide.high - wide.low);
  CHECK(narrow.low < narrow.mean);
  CHECK(narrow.mean < narrow.high);
  CHECK(values(mean_scores(many).mean.recall) == values(narrow));
  Evaluation_options other;
  other.seed = 1;
  CHECK(values(mean_scores(many, other).mean.recall) != values(narrow));
  CHECK(mean_scores(many, other).mean.recall.mean == narrow.mean);
  // Of two shapes there is one mean
  CHECK(values(mean_scores({scored("x", "a", "b", 1, 2, 2)}).mean.precision) == std::array<double, 3>{.5, .5, .5});
}

TEST_CASE("Options and scores that make no sense are refused")
{
  const std::vector<Scored_correspondence> scores{scored("x", "a", "b", 1, 1, 1)};
  CHECK_THROWS_AS(mean_scores({}), Invalid_input);
  for (const Evaluation_options& options :
       {Evaluation_options{0, .95, 0}, Evaluation_options{10, 0, 0}, Evaluation_options{10, 1, 0}})
    CHECK_THROWS_AS(mean_scores(scores, options), Invalid_input);
}
