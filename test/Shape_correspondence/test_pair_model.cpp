// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// The probability that a pair of parts is right, from roles and geometry.
#include "labelled_furniture.h"
#include "roles/pair_model.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace CGAL::Shape_correspondence;
using namespace labelled_furniture;
using namespace CGAL::Shape_correspondence::internal;

TEST_CASE("The set of pairs of greatest expected F1 is taken")
{
  const auto taken = [](const std::vector<double>& p) {
    return pairs_of_greatest_expected_f1(Eigen::Map<const Eigen::ArrayXd>(p.data(), Eigen::Index(p.size())));
  };
  // Expected right pairs: 1.7. F1 of one: 2 (0.9) / (1 + 1.7) = 0.667; two: 3 / 3.7 = 0.811; three: 3.4 / 4.7 = 0.723
  CHECK(taken({0.6, 0.2, 0.9}) == std::vector<char>{1, 0, 1});
  // Expected number of right pairs: 0.9. F1 of one pair: 0.6 / 1.9; two: 1.2 / 2.9; three: 1.8 / 3.9, the largest
  CHECK(taken({0.3, 0.3, 0.3}) == std::vector<char>{1, 1, 1});
  // No set is better than the first pair alone: 2 / 2.02
  CHECK(taken({0.01, 1, 0.01}) == std::vector<char>{0, 1, 0});
  CHECK(taken({}).empty());
}
