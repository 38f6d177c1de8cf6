#include "abstraction/Wrap_oracle.h"
#include "part_meshes.h"

#include <catch2/catch.hpp>

#ifdef CGAL_SHAPE_CORRESPONDENCE_HAS_WRAP_ORACLE

#include <CGAL/Alpha_wrap_3/internal/Triangle_soup_oracle.h>

#include <random>
#include <vector>

// The oracle for wraps gives the same results as CGAL's exact one.

using namespace part_meshes;

namespace {

using internal::contacts::Triangle;
using Kernel = internal::Mesh_kernel;
using Exact_oracle = CGAL::Alpha_wraps_3::internal::Triangle_soup_oracle<Kernel>;

Point random_point(std::mt19937& random, double size)
{
  std::uniform_real_distribution<double> coordinate(-size, size);
  const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
  return {x, y, z};
}

/// Corners of a random tetrahedron of positive volume.
std::array<Point, 4> random_corners(std::mt19937& random, double size)
{
  const Point middle = random_point(random, 1.5);
  std::array<Point, 4> result;
  for (Point& corner : result) {
    corner = middle + random_point(random, size);
  }
  if ((result[1] - result[0]).cross(result[2] - result[0]).dot(result[3] - result[0]) < 0) {
    std::swap(result[2], result[3]);
  }
  return result;
}

} // namespace

TEST_CASE("A tetrahedron meets the triangles that CGAL says")
{
  std::mt19937 random(1);
  int met = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::array<Point, 4> corners = random_corners(random, 1);
    const Triangle t{random_point(random, 1.5), random_point(random, 1.5), random_point(random, 1.5)};
    const Kernel::Tetrahedron_3 exact(internal::to_mesh_point(corners[0]), internal::to_mesh_point(corners[1]),
                                      internal::to_mesh_point(corners[2]), internal::to_mesh_point(corners[3]));
    const Kernel::Triangle_3 exact_triangle(internal::to_mesh_point(t[0]), internal::to_mesh_point(t[1]),
                                            internal::to_mesh_point(t[2]));
    const internal::Solid_tetrahedron tetrahedron(corners);
    const bool expected = CGAL::do_intersect(exact, exact_triangle);
    REQUIRE(tetrahedron.meets(t) == expected);
    REQUIRE((!expected || tetrahedron.may_meet(internal::contacts::box_of(t))));
    met += expected;
  }
  CHECK(met > 2000);
  CHECK(met < 18000);
}

TEST_CASE("A tetrahedron meets what touches it, and what is inside")
{
  const internal::Solid_tetrahedron tetrahedron({Point::Zero(), Point::UnitX(), Point::UnitY(), Point::UnitZ()});
  const Point apart = -Point::Ones();
  CHECK(tetrahedron.meets({Point::Zero(), Point(-1, 0, 0), apart}));
  CHECK(tetrahedron.meets({Point(.1, .1, .1), Point(.2, .1, .1), Point(.1, .2, .1)}));
  CHECK(tetrahedron.meets({Point(-9, -9, .1), Point(9, -9, .1), Point(0, 20, .1)}));
  CHECK_FALSE(tetrahedron.meets({Point(.4, .4, .4), Point(2, .4, .4), Point(.4, 2, .4)}));
  CHECK_FALSE(tetrahedron.meets({Point(-1e-6, 0, 0), Point(-1, 0, 0), apart}));
}

TEST_CASE("The nearest points and the crossings of the offset surface are CGAL's")
{
  const Part_mesh mesh = torus(1, 0.3);
  const internal::Wrap_oracle oracle(internal::triangles_of(mesh));
  Exact_oracle exact;
  const internal::Triangle_soup soup = internal::to_soup(mesh);
  exact.add_triangle_soup(soup.points, soup.triangles);
  CHECK(oracle.bbox() == exact.bbox());
  const auto ball = oracle.geom_traits().construct_ball_3_object();
  const double offset = 0.01;
  std::mt19937 random(2);
  int crossed = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto p = internal::to_mesh_point(random_point(random, 1.5));
    const auto q = internal::to_mesh_point(random_point(random, 1.5));
    const double expected = exact.squared_distance(p);
    REQUIRE(oracle.squared_distance(p) == Approx(expected).margin(1e-12));
    REQUIRE(CGAL::squared_distance(p, oracle.closest_point(p)) == Approx(expected).margin(1e-12));
    for (double squared : {0.9 * expected, 1.1 * expected}) {
      auto make_ball = ball;
      REQUIRE(oracle.do_intersect(make_ball(p, squared)) == (squared > expected));
    }
    internal::Mesh_point crossing, exact_crossing;
    const bool is_crossed = exact.first_intersection(p, q, exact_crossing, offset);
    REQUIRE(oracle.first_intersection(p, q, crossing, offset) == is_crossed);
    if (is_crossed) {
      REQUIRE(CGAL::squared_distance(crossing, exact_crossing) < 1e-12);
      ++crossed;
    }
  }
  CHECK(crossed > 200);
}

#endif
