// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "deformed_parts.h"
#include "hand_made_graphs.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace CGAL::Shape_correspondence;
using namespace hand_made;

TEST_CASE("Curve to curve: ends matched by proximity, whatever the direction of either")
{
  const Sampled_part up = sampled(curve("a", {0, 0, 0}, {0, 1, 0}));
  const Sampled_part far = sampled(curve("b", {5, 3, 0}, {5.2, 5, 0})),
                     reversed = sampled(curve("b", {5.2, 5, 0}, {5, 3, 0}));
  CHECK(deform_to_fit(up, far).isApprox(far.samples));
  CHECK(deform_to_fit(up, reversed).isApprox(far.samples));
}

TEST_CASE("Sheet to sheet: corners keep their places under all eight layouts")
{
  const Sampled_part seat = sampled(sheet("a", {0, 0, 0}, {2, 0, 0}, {0, 0, 1}));
  const std::vector<Part_abstraction> layouts = {
      sheet("b", {9, 1, 0}, {3, 0, 0}, {0, 0, 1}),  sheet("b", {12, 1, 0}, {-3, 0, 0}, {0, 0, 1}),
      sheet("b", {9, 1, 1}, {3, 0, 0}, {0, 0, -1}), sheet("b", {12, 1, 1}, {-3, 0, 0}, {0, 0, -1}),
      sheet("b", {9, 1, 0}, {0, 0, 1}, {3, 0, 0}),  sheet("b", {12, 1, 0}, {0, 0, 1}, {-3, 0, 0}),
      sheet("b", {9, 1, 1}, {0, 0, -1}, {3, 0, 0}), sheet("b", {12, 1, 1}, {0, 0, -1}, {-3, 0, 0})};
  const Points expected = sampled(layouts[0]).samples;
  for (const Part_abstraction& layout : layouts)
    CHECK(deform_to_fit(seat, sampled(layout)).isApprox(expected));
}

TEST_CASE("Curve to sheet: the curve runs along the side it is nearest to in direction, and back")
{
  const Sampled_part slat = sampled(curve("a", {0, 0, 0}, {0, 1, 0}));
  const Sampled_part back = sampled(sheet("b", {-1, 0, 0}, {2, 0, 0}, {0, 1, 0}));
  const Points widened = deform_to_fit(slat, back);
  REQUIRE(widened.cols() == 36);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      CHECK(widened(1, i * 6 + j) == Approx(i / 5.0)); // heights do not change
  const Points narrowed = deform_to_fit(back, slat);
  for (int i = 0; i < 36; ++i)
    CHECK(narrowed(1, i) == Approx(back.samples(1, i)));
}

TEST_CASE("Closed curves start where they fit best")
{
  const auto ring = [](double first_angle, int direction) {
    Part_abstraction part;
    Curve curve;
    curve.closed = true;
    curve.points.resize(3, 12);
    for (int i = 0; i < 12; ++i) {
      const double a = first_angle + direction * i * EIGEN_PI / 6;
      curve.points.col(i) = Point(std::cos(a), std::sin(a), 0);
    }
    part.geometry = curve;
    return part;
  };
  const Sampled_part a = sampled(ring(0, 1));
  for (int step = 0; step < 6; ++step)
    for (int direction : {1, -1})
      CHECK((deform_to_fit(a, sampled(ring(step * EIGEN_PI / 3, direction))) - a.samples).norm() < 1e-9);
}

TEST_CASE("By extremities: ends and corners take their places, and the part keeps its bow")
{
  Part_abstraction bow = curve("a", {0, 0, 0}, {1, 0, 0});
  std::get<Curve>(bow.geometry).points = points({{0, 0, 0}, {.5, .4, 0}, {1, 0, 0}});
  const Sampled_part source = sampled(bow), target = sampled(curve("b", {5, 1, 0}, {5, 3, 0}));
  const Points moved = deform_to_fit(source, target, Deform_to_fit::EXTREMITIES);
  for (int end : {0, 5})
    CHECK(moved.col(end).isApprox(target.samples.col(end)));
  for (int i = 0; i < 6; ++i) {
    const Point straight = (moved.col(0) * (5 - i) + moved.col(5) * i) / 5,
                chord = (source.samples.col(0) * (5 - i) + source.samples.col(5) * i) / 5;
    CHECK((moved.col(i) - straight - (source.samples.col(i) - chord)).norm() < 1e-12);
  }
  // A curve becomes a sheet that bends across it; a flat sheet becomes the other sheet
  const Sampled_part flat = sampled(sheet("b", {0, 1, 0}, {2, 0, 0}, {0, 0, 2})),
                     other = sampled(sheet("c", {5, 1, 0}, {3, 0, 0}, {0, 0, 1}));
  CHECK(deform_to_fit(flat, other, Deform_to_fit::EXTREMITIES).isApprox(deform_to_fit(flat, other)));
  const Points widened = deform_to_fit(source, flat, Deform_to_fit::EXTREMITIES);
  REQUIRE(widened.cols() == 36);
  for (int corner : {0, 5, 30, 35})
    CHECK(widened(1, corner) == Approx(1));
  CHECK(widened(1, 2 * 6) == Approx(1 + source.samples(1, 2)));
}
