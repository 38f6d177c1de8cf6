// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "box_shapes.h"
#include "generated_shapes.h"
#include "roles/up_by_roles.h"
#include "shape/Shape_in_frame.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/estimate_up.h>

#include <Eigen/Geometry>

#include <catch2/catch.hpp>

using namespace CGAL::Shape_correspondence;

namespace {

/// The shape with y mapped to the axis `up` by a cyclic permutation, then moved and scaled.
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
      CHECK(estimate_up(moved(shape, up)).up == Point::Unit(up));
      CHECK(estimate_up(moved(shape, up, 1e-3, {5, -7, 2})).up == Point::Unit(up));
      CHECK(estimate_up(moved(shape, up, 1e12)).up == Point::Unit(up));
    }
  }
}

TEST_CASE("Of axes that are as good as one another the first of y, z, x is up")
{
  Segmented_shape cube;
  cube.add_part("cube", box_shapes::box(Point::Zero(), Point::Ones()));
  CHECK(estimate_up(cube).up == Point::UnitY());
}

TEST_CASE("The estimate of the upright axis has a confidence, and takes prior odds into account")
{
  Segmented_shape cube;
  cube.add_part("cube", box_shapes::box(Point::Zero(), Point::Ones()));
  CHECK(estimate_up(cube).confidence == Approx(1. / 3).margin(0.03));
  CHECK(estimate_up(cube, 8).confidence == Approx(0.8).margin(0.03));

  const Segmented_shape chair = generated_shapes::shape_of(generated_shapes::gen::models()[0].make());
  CHECK(estimate_up(chair).confidence > 0.9);
  const Up_estimate lying = estimate_up(moved(chair, 2), 20);
  CHECK(lying.up == Point::UnitZ());
  CHECK(lying.confidence < estimate_up(moved(chair, 2)).confidence);
  CHECK(estimate_up(moved(chair, 2), 1e30).up == Point::UnitY());
}

TEST_CASE("The upright axis of one shape helps to estimate that of another of its kind")
{
  // A plate may be a table top or a board on the wall
  Segmented_shape flat, high;
  flat.add_part("plate", box_shapes::box(Point::Zero(), {1, 0.1, 1}));
  high.add_part("plate", box_shapes::box(Point::Zero(), {1, 1, 0.1}));
  const auto known = estimate_up_of_pair(flat, high, {true, false});
  CHECK(known[0].up == Point::UnitY());
  CHECK(known[0].confidence == Approx(1));
  CHECK(known[1].up == Point::UnitZ());
  CHECK(known[1].confidence > estimate_up(high).confidence);

  const Segmented_shape chair = generated_shapes::shape_of(generated_shapes::gen::models()[0].make());
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const auto found = estimate_up_of_pair(moved(chair, a), moved(chair, b), {false, false}, 4.5);
      CHECK(found[0].up == Point::Unit(a));
      CHECK(found[1].up == Point::Unit(b));
    }
}

TEST_CASE("Roles tell the upright axis of chairs and tables, however they lie and whichever axis was taken to be up")
{
  Structure_options options;
  options.abstraction.abstractor = Bounding_box_abstraction();
  const auto roles = IO::shipped_role_model();
  for (const auto& model : generated_shapes::gen::models()) {
    const generated_shapes::gen::Assembly assembly = model.make();
    if (assembly.name.rfind("chair_", 0) != 0 && assembly.name.rfind("table_", 0) != 0) continue;
    for (int up = 0; up < 3; ++up)
      for (int taken : {1, 2}) {
        CAPTURE(assembly.name, up, taken);
        Segmented_shape shape = moved(generated_shapes::shape_of(assembly), up);
        shape.set_up(Point::Unit(taken));
        const internal::Up_by_roles found =
            internal::up_by_roles(build_structural_graph(shape, options), internal::frames_by_axis(shape), *roles);
        CHECK(found.axis == std::size_t(up));
        CHECK(found.is_nearer);
      }
  }
}

TEST_CASE("Without a category roles tell no upright axis")
{
  Structure_options options;
  options.abstraction.abstractor = Bounding_box_abstraction();
  const Segmented_shape shape = generated_shapes::shape_of(generated_shapes::gen::models()[0].make());
  const internal::Up_by_roles found =
      internal::up_by_roles(build_structural_graph(shape, options), internal::frames_by_axis(shape), Role_model());
  CHECK(!found.is_nearer);
  CHECK(!found.is_clear);
}
