// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/Shape_features.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <vector>

using namespace CGAL::Shape_correspondence;

namespace {

internal::Boxes random_boxes(Eigen::Index parts)
{
  std::mt19937 random(7);
  const auto number = [&](Eigen::Index, Eigen::Index) { return double(random()) / double(std::mt19937::max()); };
  internal::Boxes result;
  result.low = Eigen::ArrayX3d::NullaryExpr(parts, 3, number);
  result.high = result.low + Eigen::ArrayX3d::NullaryExpr(parts, 3, number);
  return result;
}

} // namespace

TEST_CASE("The closeness of ends of boxes is the same in a shape of many parts as in one of few")
{
  constexpr double width = 0.2;
  constexpr Eigen::Index many = 201, few = 57; // more and fewer boxes than are cached
  const internal::Boxes boxes = random_boxes(many);
  const internal::Closeness all(boxes, width), first({boxes.low.topRows(few), boxes.high.topRows(few)}, width);
  std::vector<Eigen::Index> parts; // of the first ones, in another order and with a repeated one
  for (Eigen::Index part = few; part-- > 0;)
    parts.push_back(part == 1 ? 3 : part);
  Eigen::ArrayXd a, b;
  for (int axis = 0; axis < 3; ++axis)
    for (Eigen::Index end = 0; end < 2 * few; ++end) {
      all.of_end(axis, end, parts, a);
      first.of_end(axis, end, parts, b);
      const double here = (end % 2 == 0 ? boxes.low : boxes.high)(end / 2, axis);
      REQUIRE(a.size() == 2 * few);
      for (Eigen::Index other = 0; other < 2 * few; ++other) {
        REQUIRE(a[other] == b[other]);
        const double there = (other % 2 == 0 ? boxes.low : boxes.high)(parts[std::size_t(other / 2)], axis);
        REQUIRE(a[other] == Approx(std::exp(-std::pow((there - here) / width, 2) / 2)));
      }
    }
}
