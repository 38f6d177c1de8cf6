#include <CGAL/Shape_correspondence/Part_abstraction.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace CGAL::Shape_correspondence;

namespace {

/// An L of lengths 1 and 3.
Curve corner()
{
  Curve result;
  result.points.resize(3, 3);
  result.points << 0, 1, 1, 0, 0, 3, 0, 0, 0;
  return result;
}

Curve square()
{
  Curve result;
  result.points.resize(3, 4);
  result.points << 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  result.closed = true;
  return result;
}

/// A saddle over [0, 2] x [0, 3], three by two control points.
Sheet saddle()
{
  Sheet result;
  result.rows = 3;
  result.cols = 2;
  result.points.resize(3, 6);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 2; ++j) {
      result.points.col(i * 2 + j) = Point(i, 3 * j, (i - 1) * (j == 0 ? 1 : -1));
    }
  }
  return result;
}

Part_abstraction part(std::variant<Curve, Sheet> geometry)
{
  Part_abstraction result;
  result.geometry = std::move(geometry);
  return result;
}

} // namespace

TEST_CASE("A curve's parameter is the fraction of its length")
{
  CHECK(corner()(0).isApprox(Point(0, 0, 0)));
  CHECK(corner()(0.125).isApprox(Point(0.5, 0, 0)));
  CHECK(corner()(0.5).isApprox(Point(1, 1, 0)));
  CHECK(corner()(1).isApprox(Point(1, 3, 0)));
  CHECK(corner()(2).isApprox(Point(1, 3, 0)));
  CHECK(square()(0.875).isApprox(Point(0, 0.5, 0)));
  CHECK(square()(1).isApprox(square()(0)));
}

TEST_CASE("Samples are evenly spaced")
{
  const Points open = sample(corner(), 5);
  CHECK(open.col(0).isApprox(Point(0, 0, 0)));
  CHECK(open.col(1).isApprox(Point(1, 0, 0)));
  CHECK(open.col(4).isApprox(Point(1, 3, 0)));
  const Points closed = sample(square(), 8);
  REQUIRE(closed.cols() == 8);
  CHECK(closed.col(7).isApprox(Point(0, 0.5, 0)));
  const Points grid = sample(saddle(), 5);
  REQUIRE(grid.cols() == 25);
  CHECK(grid.col(1).isApprox(saddle()(0, 0.25)));
  CHECK(grid.col(5).isApprox(Point(0.5, 0, -0.5)));
  CHECK(grid.col(24).isApprox(Point(2, 3, -1)));
  CHECK(sample(part(saddle()), 3).cols() == 9);
}

TEST_CASE("The nearest parameter is where the nearest point is")
{
  const Part_abstraction curve = part(corner());
  CHECK(nearest_parameter(curve, Point(0.5, -2, 1))[0] == Approx(0.125));
  CHECK(nearest_parameter(curve, Point(5, 9, 0))[0] == Approx(1));
  CHECK(nearest_parameter(part(square()), Point(-1, 0.5, 0))[0] == Approx(0.875));
  const Part_abstraction sheet = part(saddle());
  CHECK(nearest_parameter(sheet, Point(-4, -4, 0)).isApprox(Eigen::Vector2d(0, 0)));
  for (const Eigen::Vector2d& x : {Eigen::Vector2d(0.3, 0.8), Eigen::Vector2d(0.7, 0.2), Eigen::Vector2d(0.5, 0.5)}) {
    CHECK((nearest_parameter(sheet, evaluate(sheet, x)) - x).norm() < 1e-6);
  }
}

TEST_CASE("No point of a fine grid is nearer than the nearest one")
{
  const Part_abstraction sheet = part(saddle());
  const Points fine = sample(saddle(), 200);
  for (int k = 0; k < 50; ++k) {
    const Point p(std::fmod(0.37 * k, 3.) - 0.5, std::fmod(0.61 * k, 4.) - 0.5, std::fmod(0.83 * k, 3.) - 1.5);
    const double found = (evaluate(sheet, nearest_parameter(sheet, p)) - p).norm();
    const double best = (fine.colwise() - p).colwise().norm().minCoeff();
    CHECK(found < best + 0.01);
  }
}

TEST_CASE("Degenerate curves and sheets have values")
{
  Curve point;
  point.points = Points::Ones(3, 2);
  CHECK(point(0.5).isApprox(Point(1, 1, 1)));
  CHECK(sample(point, 4).allFinite());
  CHECK(nearest_parameter(part(point), Point::Zero()).allFinite());
  Sheet flat;
  flat.rows = flat.cols = 2;
  flat.points = Points::Ones(3, 4);
  CHECK(nearest_parameter(part(flat), Point::Zero()).allFinite());
}

TEST_CASE("Abstractions are sheets, or open or closed curves")
{
  CHECK(part(saddle()).is_sheet());
  CHECK_FALSE(part(corner()).is_sheet());
  CHECK_FALSE(part(corner()).is_closed_curve());
  CHECK(part(square()).is_closed_curve());
  CHECK(part(saddle()).control_points().cols() == 6);
}

TEST_CASE("Solidity is at most one, and one where it is unknown")
{
  CHECK(solidity(1, 4) == 0.25);
  CHECK(solidity(5, 4) == 1);
  CHECK(solidity(0, 4) == 1);
  CHECK(solidity(1, 0) == 1);
}
