// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Deformation_energy.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace CGAL::Shape_correspondence;

TEST_CASE("Eq. 1 by hand")
{
  CHECK(deformation_energy({1, 10, 100}, {}) == Approx(1 + 0.6 * 10 + 0.4 * 100));
  CHECK(deformation_energy({1, 10, 100}, {0, 0}) == Approx(0.4 * 100));
  CHECK(deformation_energy({1, 10, 100, 1000}, {0.6, 0.4, 0}) == Approx(0.6 + 0.4 * 10 + 1000));
}

TEST_CASE("Eq. 2 by hand: the cosine of the angle by which a rod turns")
{
  CHECK(rod_rotation({2, 0, 0}, {5, 0, 0}) == 1);
  CHECK(rod_rotation({2, 0, 0}, {3, 3 * std::sqrt(3), 0}) == Approx(0.5));
  CHECK(rod_rotation({2, 0, 0}, {0, 0, 1}) == 0);
  CHECK(rod_rotation({2, 0, 0}, {-1, 1, 0}) == 0); // a rotation beyond a right angle
  CHECK(rod_rotation({0, 0, 0}, {0, 1, 0}) == 1);
  CHECK(rod_rotation({2, 0, 0}, {0, 0, 0}) == 0);
}

TEST_CASE("Eq. 3 by hand: from the mean squared cosine of the rods")
{
  CHECK(distortion_energy(1) == 0);
  CHECK(distortion_energy(1 + 1e-7) == 0); // above 1 by rounding in single precision
  CHECK(distortion_energy(0) == 1);
  CHECK(distortion_energy((0.25 + 1) / 2) == Approx(1 - std::sqrt(1.25 / 2)));
}

TEST_CASE("Eq. 4 by hand, with its sign turned")
{
  CHECK(connectedness_energy(1, 0.5, 4) == 0);
  CHECK(connectedness_energy(1, 1, 4) == 0);
  CHECK(connectedness_energy(1, 2, 4) == 0.5);
  CHECK(connectedness_energy(1, 9, 4) == 1);
  CHECK(connectedness_energy(0, 1, 0) == 1);
}

TEST_CASE("Eq. 5 by hand")
{
  CHECK(split_energy({1, 1, 1}) == 0);
  CHECK(split_energy({1, 0.5}) == Approx(1 - std::sqrt(1.25 / 2)));
  CHECK(split_energy({}) == 0);
}
