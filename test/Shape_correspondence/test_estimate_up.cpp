// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "box_shapes.h"
#include "generated_shapes.h"

#include <CGAL/Shape_correspondence/estimate_up.h>

#include <Eigen/Geometry>

#include <catch2/catch.hpp>

using namespace CGAL::Shape_correspondence;

namespace {

/// The shape with its axes renamed: y becomes the axis of that number; then moved and scaled.
Segmented_shape moved(const Segmented_shape& shape, int up, double scale = 1, const Point& by = Point::Zero())
{
  Eigen::Matrix3d axes;
  for (int k = 0; k < 3; ++k)
    axes.col(k) = Point::Unit((up + k + 2) % 3);
  Segmented_shape result;
  for (Shape_part part : shape.parts()) {
    part.mesh.points = ((scale * axes * part.mesh.points).colwise() + by).eval();
    result.add_part(part.name, part.mesh);
  }
  return result;
}

} // namespace

TEST_CASE("The models of data/ are found to stand as they do, whichever axis is up")
{
  for (const auto& model : generated_shapes::gen::models()) {
    const generated_shapes::gen::Assembly assembly = model.make();
    const Segmented_shape shape = generated_shapes::shape_of(assembly);
    for (int up = 0; up < 3; ++up) {
      CAPTURE(assembly.name, up);
      CHECK(estimate_up(moved(shape, up)) == Point::Unit(up));
      CHECK(estimate_up(moved(shape, up, 1e-3, {5, -7, 2})) == Point::Unit(up));
      CHECK(estimate_up(moved(shape, up, 1e12)) == Point::Unit(up));
    }
  }
}

TEST_CASE("Of axes that are as good as one another the first of y, z, x is up")
{
  Segmented_shape cube;
  cube.add_part("cube", box_shapes::box(Point::Zero(), Point::Ones()));
  CHECK(estimate_up(cube) == Point::UnitY());
}
