// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/evaluate_correspondence.h>

#include <catch2/catch.hpp>

#include <algorithm>

// All numbers here were computed by hand.

using namespace CGAL::Shape_correspondence;

namespace {

/// A score with precision `right` / `matched` and recall `right` / `expected`.
Scored_correspondence scored(const std::string& category, const std::string& source, const std::string& target,
                             std::size_t right, std::size_t matched, std::size_t expected)
{
  return {category, source, target, {matched, expected, right, matched}};
}

} // namespace

TEST_CASE("Fine labels decide where all parts have them and both sides share half of the smaller set")
{
  const std::vector<Part_label> chair{{"leg", "front"}, {"leg", "back"}, {"seat", ""}};
  // {front, back} and {front, middle, rear} share 1 of 2, which suffices
  const Ground_truth half = ground_truth(chair, {{"leg", "front"}, {"leg", "middle"}, {"leg", "rear"}, {"back", ""}});
  CHECK(half.pairs == Part_pairs{{0, 0}});
  CHECK(half.coarse_pairs == Part_pairs{{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}, {1, 2}});
  // No fine label is shared: every leg corresponds to every leg
  const Ground_truth none = ground_truth(chair, {{"leg", "middle"}, {"seat", "cushion"}});
  CHECK(none.pairs == Part_pairs{{0, 0}, {1, 0}, {2, 1}});
  // One leg has no fine label
  const Ground_truth open = ground_truth(chair, {{"leg", ""}, {"leg", "front"}});
  CHECK(open.pairs == open.coarse_pairs);
  CHECK(open.pairs == Part_pairs{{0, 0}, {0, 1}, {1, 0}, {1, 1}});
  // {front, back, left} and {front, x, y} share 1 of 3, less than half
  const Ground_truth third = ground_truth({{"leg", "front"}, {"leg", "back"}, {"leg", "left"}},
                                          {{"leg", "front"}, {"leg", "x"}, {"leg", "y"}});
  CHECK(third.pairs.size() == 9);
  // A fine label of several parts counts once
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
  // Right: (1, 1), (2, 2); right coarse label only: (0, 1); wrong: (3, 0), (3, 1); listed twice: (1, 1)
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
  // F1 is 1 and 0 in one category, 2/3 in the other
  const Evaluation e = mean_scores(
      {scored("table", "c", "d", 1, 1, 2), scored("chair", "a", "b", 2, 2, 2), scored("chair", "a", "c", 0, 0, 3)});
  REQUIRE(e.categories.size() == 2);
  CHECK(e.categories[0].first == "chair");
  const Mean_score &chair = e.categories[0].second, &table = e.categories[1].second;
  CHECK(chair.correspondences == 2);
  CHECK(chair.f1 == Approx(.5));
  CHECK(table.recall == Approx(.5));
  CHECK(table.f1 == Approx(2. / 3));
  CHECK(e.mean.correspondences == 3);
  CHECK_THROWS_AS(mean_scores({}), Invalid_input);
  CHECK(e.mean.precision == Approx(.75));
  CHECK(e.mean.f1 == Approx(7. / 12));
}
