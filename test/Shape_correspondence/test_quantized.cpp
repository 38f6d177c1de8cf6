// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/quantized.h"

#include <catch2/catch.hpp>

#include <limits>

using CGAL::Shape_correspondence::internal::comparison_grid;
using CGAL::Shape_correspondence::internal::quantized;

TEST_CASE("Numbers go to the nearest step of the grid, half a step away from zero")
{
  CHECK(quantized(0) == 0);
  CHECK(quantized(3.4 * comparison_grid) == 3);
  CHECK(quantized(-3.6 * comparison_grid) == -4);
  CHECK(quantized(0.5 * comparison_grid) == 1);
  CHECK(quantized(-0.5 * comparison_grid) == -1);
  CHECK(quantized(1e9) == 1'000'000'000'000'000);
}

TEST_CASE("Numbers beyond the grid become its last step, in 64 bits")
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  static_assert(sizeof(quantized(0)) == 8, "more than a `long` has on some machines");
  for (double beyond : {1e13, 1e300, infinity}) {
    CHECK(quantized(beyond) == 9'000'000'000'000'000'000);
    CHECK(quantized(-beyond) == -9'000'000'000'000'000'000);
  }
  CHECK(quantized(std::numeric_limits<double>::quiet_NaN()) == quantized(-infinity));
}
