#include <CGAL/Shape_correspondence/Shape_frame.h>

#include <Eigen/Geometry>

#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <vector>

using namespace CGAL::Shape_correspondence;

namespace {

void add_box(std::vector<Point>& points, const Point& low, const Point& high, int n = 10)
{
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) {
        for (const double side : {0., 1.}) {
          Point f;
          f[axis] = side;
          f[(axis + 1) % 3] = double(i) / n;
          f[(axis + 2) % 3] = double(j) / n;
          points.push_back(low + f.cwiseProduct(high - low));
        }
      }
    }
  }
}

Points to_matrix(const std::vector<Point>& points)
{
  Points result(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.col(static_cast<Eigen::Index>(i)) = points[i];
  }
  return result;
}

/// A seat, a back at its rear, and four legs: symmetric in x only.
Points chair()
{
  std::vector<Point> points;
  add_box(points, {-0.3, 0.45, -0.25}, {0.3, 0.5, 0.25});
  add_box(points, {-0.28, 0.5, -0.25}, {0.28, 1, -0.2});
  for (const double x : {-0.27, 0.27}) {
    for (const double z : {-0.22, 0.22}) {
      add_box(points, {x - 0.02, 0, z - 0.02}, {x + 0.02, 0.45, z + 0.02});
    }
  }
  return to_matrix(points);
}

Points table()
{
  std::vector<Point> points;
  add_box(points, {-0.6, 0.9, -0.4}, {0.6, 1, 0.4}, 14);
  add_box(points, {-0.05, 0, -0.05}, {0.05, 0.9, 0.05});
  return to_matrix(points);
}

Points turned(const Points& points, double angle)
{
  return Eigen::AngleAxisd(angle, Point::UnitY()).toRotationMatrix() * points;
}

} // namespace

TEST_CASE("The frame of a chair stands as the chair does")
{
  const Shape_frame frame = compute_shape_frame(chair(), Point::UnitY());
  CHECK(frame.mirror_x);
  CHECK_FALSE(frame.mirror_z);
  CHECK(frame.axes.isApprox(Eigen::Matrix3d::Identity(), 1e-6));
  CHECK(frame.origin.norm() < 1e-6);
  CHECK(frame.height == Approx(1));
}

TEST_CASE("A table has two mirror planes")
{
  const Shape_frame frame = compute_shape_frame(table(), Point::UnitY());
  CHECK(frame.mirror_x);
  CHECK(frame.mirror_z);
  CHECK(frame.axes.isApprox(Eigen::Matrix3d::Identity(), 1e-6));
}

TEST_CASE("A shape without mirror plane has a frame")
{
  std::vector<Point> points;
  add_box(points, {0, 0, 0}, {3, 1, 1});
  add_box(points, {2, 0, 1}, {3, 2, 2});
  add_box(points, {0.2, 1, 0.1}, {0.5, 3, 0.4});
  const Shape_frame frame = compute_shape_frame(to_matrix(points), Point::UnitY());
  CHECK_FALSE(frame.mirror_x);
  CHECK_FALSE(frame.mirror_z);
  CHECK(frame.axes.isApprox(Eigen::Matrix3d::Identity(), 1e-6));
}

TEST_CASE("The frame moves with the shape")
{
  const Points in_frame = compute_shape_frame(chair(), Point::UnitY()).to_frame(chair());
  for (const double angle : {0.3, -0.7, 1.2}) {
    const Points moved = (7.5 * turned(chair(), angle)).colwise() + Point(3, -20, 11);
    const Shape_frame frame = compute_shape_frame(moved, Point::UnitY());
    CHECK(frame.axes.determinant() == Approx(1));
    CHECK(frame.to_frame(moved).isApprox(in_frame, 1e-6));
    CHECK(frame.to_world(frame.to_frame(moved)).isApprox(moved, 1e-9));
  }
}

TEST_CASE("Turned by more than a quarter, a chair's frame is the same up to a half turn")
{
  const Points in_frame = compute_shape_frame(chair(), Point::UnitY()).to_frame(chair());
  const Points moved = turned(chair(), 2.5);
  const Points found = compute_shape_frame(moved, Point::UnitY()).to_frame(moved);
  CHECK(found.isApprox(turned(in_frame, EIGEN_PI), 1e-6));
}

TEST_CASE("Any direction may be up")
{
  const Eigen::Matrix3d tilt =
      Eigen::Quaterniond::FromTwoVectors(Point::UnitY(), Point(0.3, -0.2, 0.9).normalized()).toRotationMatrix();
  const Shape_frame frame = compute_shape_frame(tilt * chair(), tilt * Point::UnitY());
  CHECK(frame.axes.isApprox(tilt, 1e-6));
  CHECK(frame.to_frame(tilt * chair()).isApprox(chair(), 1e-6));
}

TEST_CASE("A square table is seen along its sides")
{
  std::vector<Point> points;
  add_box(points, {-0.5, 0.9, -0.5}, {0.5, 1, 0.5}, 14);
  const Points square = turned(to_matrix(points), 0.2);
  const Shape_frame frame = compute_shape_frame(square, Point::UnitY());
  CHECK(frame.mirror_x);
  CHECK(frame.mirror_z);
  CHECK(frame.axes.isApprox(Eigen::AngleAxisd(0.2, Point::UnitY()).toRotationMatrix(), 1e-6));
}

TEST_CASE("A disc on four legs is seen with the legs in the corners")
{
  std::vector<Point> points;
  constexpr int around = 64;
  for (int i = 0; i < around; ++i)
    for (int ring = 0; ring <= 8; ++ring) {
      const double angle = 2 * EIGEN_PI * i / around, radius = ring / 16.;
      points.emplace_back(radius * std::cos(angle), 1, radius * std::sin(angle));
    }
  for (const double x : {-.3, .3})
    for (const double z : {-.3, .3})
      add_box(points, {x - .02, 0, z - .02}, {x + .02, .95, z + .02});
  for (const double angle : {0., .2, -.6}) {
    INFO(angle);
    const Shape_frame frame = compute_shape_frame(turned(to_matrix(points), angle), Point::UnitY());
    CHECK(frame.mirror_x);
    CHECK(frame.mirror_z);
    CHECK(frame.axes.isApprox(Eigen::AngleAxisd(angle, Point::UnitY()).toRotationMatrix(), 1e-6));
  }
}

TEST_CASE("The mirror plane of points spread at random is found, though most directions that are tried have none")
{
  // A kite, symmetric in x. Its rectangle of least area is parallel to one of its sides.
  std::mt19937_64 random(7);
  const auto draw = [&] { return double(random() >> 11) / double(1ull << 53); };
  std::vector<Point> points;
  while (points.size() < 1500) {
    const Point p(2 * draw() - 1, 0.3 * draw(), 3 * draw());
    if (std::abs(p.x()) < (p.z() < 2.6 ? p.z() / 2.6 : (3 - p.z()) / 0.4)) points.push_back(p);
  }
  for (const double angle : {0., 0.3, -0.5}) {
    INFO(angle);
    const Shape_frame frame = compute_shape_frame(turned(to_matrix(points), angle), Point::UnitY());
    CHECK(frame.mirror_x);
    CHECK_FALSE(frame.mirror_z);
    CHECK(frame.axes.isApprox(Eigen::AngleAxisd(angle, Point::UnitY()).toRotationMatrix(), 0.05));
  }
}

TEST_CASE("Flat and tiny shapes have a frame")
{
  Points line(3, 2);
  line << 0, 4, 0, 0, 0, 0;
  const Shape_frame flat = compute_shape_frame(line, Point::UnitY());
  CHECK(flat.height == Approx(4));
  CHECK(flat.axes.allFinite());
  const Shape_frame point = compute_shape_frame(Points::Ones(3, 1), Point::UnitY());
  CHECK(point.height == 1);
  CHECK(point.axes.isApprox(Eigen::Matrix3d::Identity()));
  CHECK(point.origin.isApprox(Point(1, 1, 1)));
}
