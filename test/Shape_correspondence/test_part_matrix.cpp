// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "collection/part_matrix.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <catch2/catch.hpp>

#include <vector>

using namespace CGAL::Shape_correspondence;

TEST_CASE("The matrix has the mean of both directions, parts numbered shape after shape")
{
  const std::vector<Shape_pair_map> maps{
      {0, 1, {{{0, 0, .8}, {1, 1, .5}}}}, {1, 0, {{{0, 0, .4}}}}, {1, 2, {{{1, 0, .3}}}}};
  const Part_matrix matrix = part_matrix({2, 2, 1}, maps, 0);
  CHECK(matrix.first == std::vector<std::size_t>{0, 2, 4, 5});
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(5, 5);
  expected(0, 2) = expected(2, 0) = .6;
  expected(1, 3) = expected(3, 1) = .25;
  expected(3, 4) = expected(4, 3) = .3;
  CHECK(Eigen::MatrixXd(matrix.confidences).isApprox(expected));
  CHECK(matrix.rejected == 0);
}

TEST_CASE("A map of a shape that does not exist is refused")
{
  CHECK_THROWS_AS(part_matrix({1, 1}, {{0, 2, {{{0, 0, 1}}}}}, 0), Invalid_input);
}
