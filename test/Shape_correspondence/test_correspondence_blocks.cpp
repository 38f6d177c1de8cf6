// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/correspondence_blocks.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

using namespace CGAL::Shape_correspondence;

namespace {

using Parts = std::vector<std::size_t>;
using Sides = std::array<Parts, 2>;

Correspondence of_pairs(std::vector<Part_correspondence> pairs, std::vector<std::string> source_roles = {},
                        std::vector<std::string> target_roles = {})
{
  Correspondence result;
  std::sort(pairs.begin(), pairs.end(), is_before);
  result.pairs = std::move(pairs);
  result.source_roles = std::move(source_roles);
  result.target_roles = std::move(target_roles);
  return result;
}

std::vector<Sides> sides(const std::vector<Correspondence_block>& blocks)
{
  std::vector<Sides> result;
  for (const Correspondence_block& block : blocks)
    result.push_back({block.source, block.target});
  return result;
}

void add_all(const Parts& source, const Parts& target, double confidence, std::vector<Part_correspondence>& pairs)
{
  for (std::size_t s : source)
    for (std::size_t t : target)
      pairs.push_back({s, t, confidence});
}

/// A chair with a back of three bars, a seat, and two legs with casters, connected by uncertain pairs.
Correspondence bridged_chair()
{
  std::vector<Part_correspondence> pairs;
  add_all({0, 1, 2}, {0, 1}, .8, pairs);
  add_all({3}, {2}, .9, pairs);
  add_all({4, 5}, {3, 4, 5}, .7, pairs);
  pairs.push_back({2, 2, .3}); // back and seat
  pairs.push_back({3, 3, .3}); // seat and leg
  return of_pairs(std::move(pairs));
}

} // namespace

TEST_CASE("One to one, one to several and several to one are blocks with their operations and mean confidences")
{
  const auto blocks = correspondence_blocks(of_pairs({{0, 3, .9}, {1, 0, .5}, {1, 1, .7}, {2, 2, .6}, {4, 2, .4}}));
  REQUIRE(sides(blocks) == std::vector<Sides>{{Parts{0}, Parts{3}}, {Parts{1}, Parts{0, 1}}, {Parts{2, 4}, Parts{2}}});
  CHECK(blocks[0].operation == Operation::MATCH);
  CHECK(blocks[1].operation == Operation::SPLIT);
  CHECK(blocks[2].operation == Operation::MERGE);
  CHECK(blocks[0].confidence == Approx(.9));
  CHECK(blocks[1].confidence == Approx(.6));
  CHECK(blocks[2].confidence == Approx(.5));
  CHECK(blocks[1].role.empty());
  CHECK(correspondence_blocks({}).empty());
}

TEST_CASE("Weak bridges do not connect blocks")
{
  const auto blocks = correspondence_blocks(bridged_chair());
  REQUIRE(sides(blocks) ==
          std::vector<Sides>{{Parts{0, 1, 2}, Parts{0, 1}}, {Parts{3}, Parts{2}}, {Parts{4, 5}, Parts{3, 4, 5}}});
  CHECK(blocks[0].operation == Operation::MERGE);
  CHECK(blocks[2].operation == Operation::DUPLICATE);
  CHECK(blocks[0].confidence == Approx(.8)); // mean of the pairs within the block
}

TEST_CASE("A chain of equally confident pairs is one block, and so are two sets of parts with all their pairs")
{
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  const auto chain =
      correspondence_blocks(of_pairs({{0, 0, unknown}, {1, 0, unknown}, {1, 1, unknown}, {2, 2, unknown}}));
  REQUIRE(sides(chain) == std::vector<Sides>{{Parts{0, 1}, Parts{0, 1}}, {Parts{2}, Parts{2}}});
  CHECK(chain[0].operation == Operation::MATCH);
  CHECK(std::isnan(chain[0].confidence));
  // Casters whose pairs have different confidences
  std::vector<Part_correspondence> pairs;
  for (std::size_t s = 0; s < 5; ++s)
    for (std::size_t t = 0; t < 6; ++t)
      pairs.push_back({s, t, .55 + .01 * double((7 * s + 5 * t) % 11)});
  CHECK(correspondence_blocks(of_pairs(pairs)).size() == 1);
}

TEST_CASE("Legs that also resemble their neighbours stay apart")
{
  const auto blocks = correspondence_blocks(of_pairs({{0, 0, .9}, {0, 1, .4}, {1, 1, .9}, {2, 2, .9}, {2, 1, .4}}));
  CHECK(sides(blocks) == std::vector<Sides>{{Parts{0}, Parts{0}}, {Parts{1}, Parts{1}}, {Parts{2}, Parts{2}}});
}

TEST_CASE("Every part that corresponds to any is in one block, however unsure it is")
{
  const auto blocks = correspondence_blocks(of_pairs({{0, 0, .9}, {0, 1, .9}, {1, 0, .9}, {1, 1, .9}, {2, 1, .05}}));
  CHECK(sides(blocks) == std::vector<Sides>{{Parts{0, 1, 2}, Parts{0, 1}}});
}

TEST_CASE("Pairs of different roles count half, and a block has the role of most of its parts")
{
  // A seat that corresponds to a back with more confidence than to the other seat
  const std::vector<Part_correspondence> pairs{{0, 0, .6}, {0, 1, .7}, {1, 1, .7}};
  const auto blocks = correspondence_blocks(of_pairs(pairs, {"seat", "back"}, {"seat", "back"}));
  REQUIRE(sides(blocks) == std::vector<Sides>{{Parts{0}, Parts{0}}, {Parts{1}, Parts{1}}});
  CHECK(blocks[0].role == "seat");
  CHECK(blocks[1].role == "back");
  CHECK(correspondence_blocks(of_pairs(pairs)).size() == 1);
  const auto mixed = correspondence_blocks(of_pairs({{0, 0, .6}, {1, 0, .6}}, {"leg", "bar"}, {"leg"}));
  CHECK(mixed[0].role == "leg");
  const auto even = correspondence_blocks(of_pairs({{0, 0, .6}}, {"leg"}, {"bar"}));
  CHECK(even[0].role == "bar");
}

TEST_CASE("Segments of curves are cut or joined")
{
  Part_correspondence first{0, 0}, second{0, 1};
  first.source_segment = {0, 2};
  second.source_segment = {1, 2};
  CHECK(correspondence_blocks(of_pairs({first, second}))[0].operation == Operation::CUT);
  CHECK(correspondence_blocks(of_pairs({inverse(first), inverse(second)}))[0].operation == Operation::JOIN);
}

TEST_CASE("Blocks do not depend on the order of parts or on which shape is the source")
{
  std::mt19937 random(7);
  const auto draw = [&](int n) { return int(random() % unsigned(n)); };
  for (int run = 0; run < 50; ++run) {
    const std::size_t n = 6;
    std::vector<Part_correspondence> pairs, moved, turned;
    Parts order(n);
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::shuffle(order.begin(), order.end(), random);
    for (std::size_t s = 0; s < n; ++s)
      for (std::size_t t = 0; t < n; ++t)
        if (draw(3) == 0) {
          pairs.push_back({s, t, .1 * draw(10)});
          moved.push_back({order[s], order[t], pairs.back().confidence});
          turned.push_back(inverse(pairs.back()));
        }
    const std::vector<Sides> wanted = sides(correspondence_blocks(of_pairs(pairs)));
    std::vector<Sides> got = sides(correspondence_blocks(of_pairs(turned))), numbered;
    for (Sides& block : got)
      std::swap(block[0], block[1]);
    std::sort(got.begin(), got.end());
    CHECK(got == wanted);
    for (Sides block : wanted) {
      for (Parts& parts : block) {
        for (std::size_t& part : parts)
          part = order[part];
        std::sort(parts.begin(), parts.end());
      }
      numbered.push_back(block);
    }
    std::sort(numbered.begin(), numbered.end());
    CHECK(sides(correspondence_blocks(of_pairs(moved))) == numbered);
  }
}
