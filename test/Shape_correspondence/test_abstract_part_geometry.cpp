#include "abstraction_error.h"
#include "part_meshes.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>

#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include <cmath>
#include <map>
#include <string>
#include <vector>

// Which curve or sheet represents a part; limits, options and copies are in test_abstract_part.cpp.

using namespace part_meshes;
using Method = Abstraction_report::Method;

TEST_CASE("A leg becomes a curve along its axis")
{
  const Part_abstraction part = abstraction_of(leg);
  REQUIRE_FALSE(part.is_sheet());
  CHECK_FALSE(part.is_closed_curve());
  CHECK(part.report.method == Method::PRISM);
  CHECK(part.report.repair == Abstraction_report::Repair::NONE);
  CHECK(part.volume == Approx(0.01));
  CHECK(part.hull_volume == Approx(0.01));
  CHECK(part.area == Approx(0.42));
  CHECK(part.surface.cols() == 256);
  CHECK(part.hull.cols() == 8);
  const Points& points = part.control_points();
  REQUIRE(points.cols() == 16);
  CHECK((points.row(0).array() - 0.05).abs().maxCoeff() < 1e-6);
  CHECK((points.row(2).array() - 0.05).abs().maxCoeff() < 1e-6);
  CHECK(points(1, 0) == Approx(0).margin(1e-6));
  CHECK(points(1, 15) == Approx(1));
}

TEST_CASE("A tapered leg with corners becomes the line through its middle without flow")
{
  Part_mesh tapered = box({-0.06, 0, -0.06}, {0.06, 1, 0.06});
  for (Eigen::Index v = 0; v < 8; ++v) {
    const double width = 1 - 0.5 * tapered.points(1, v);
    tapered.points(0, v) *= width;
    tapered.points(2, v) *= width;
  }
  const Part_abstraction part = abstraction_of(tapered);
  REQUIRE_FALSE(part.is_sheet());
  CHECK(part.report.method == Method::MEDIAL_AXIS);
  CHECK(part.report.iterations == 0);
  const Points& points = part.control_points();
  CHECK(points.row(0).cwiseAbs().maxCoeff() < 0.005);
  CHECK(points.row(2).cwiseAbs().maxCoeff() < 0.005);
  CHECK(points(1, 0) < 0.02);
  CHECK(points(1, 15) > 0.98);
}

TEST_CASE("A plate becomes a sheet that reaches its rim")
{
  const Part_abstraction part = abstraction_of(plate);
  REQUIRE(part.is_sheet());
  CHECK(part.report.method == Method::PRISM);
  CHECK(part.report.residual == 0);
  CHECK(part.report.coverage == 1);
  CHECK_FALSE(part.report.branching);
  const Points& points = part.control_points();
  REQUIRE(points.cols() == 64);
  CHECK((points.row(1).array() - 0.03).abs().maxCoeff() < 0.02);
  CHECK(points.row(0).minCoeff() == Approx(0).margin(0.02));
  CHECK(points.row(0).maxCoeff() == Approx(1).margin(0.02));
  CHECK(points.row(2).maxCoeff() == Approx(0.8).margin(0.02));
  const Sheet& sheet = std::get<Sheet>(part.geometry);
  CHECK(sheet(0, 1).x() > sheet(0, 0).x() + 0.9);
}

TEST_CASE("A ring becomes a closed curve")
{
  const Part_abstraction part = abstraction_of(torus(1, 0.1));
  REQUIRE(part.is_closed_curve());
  CHECK(part.control_points().cols() == 32); // one full turn has twice as many points as a straight curve
  const Points points = sample(part, 200);
  CHECK((points.colwise().norm().array() - 1).abs().maxCoeff() < 0.015); // includes midpoints of segments
  CHECK(points.row(1).cwiseAbs().maxCoeff() < 0.01);
}

TEST_CASE("The report calls a ball a blob")
{
  const Part_mesh ball = torus_like(24, 24, [](double u, double v) {
    return Point(std::cos(u) * (1 + 1e-6 - std::cos(v)) / 2, std::sin(v) / 2 + v / 6.3,
                 std::sin(u) * (1 - std::cos(v)) / 2);
  });
  const Part_abstraction part = abstraction_of(box({0, 0, 0}, {1, 1, 1}));
  CHECK_FALSE(part.is_sheet());
  CHECK(part.report.blob);
  CHECK(abstraction_of(ball).control_points().allFinite());
  const Part_abstraction block = abstraction_of(box({0, 0, 0}, {1, 0.8, 0.7}));
  CHECK(block.report.blob);
  CHECK_FALSE(block.report.is_fallback());
}

TEST_CASE("A curve reaches both ends of a flat bar")
{
  const Part_abstraction part = abstraction_of(box({0, 0, 0}, {0.06, 0.38, 0.02}));
  REQUIRE_FALSE(part.is_sheet());
  CHECK(part.control_points().row(1).minCoeff() < 0.01);
  CHECK(part.control_points().row(1).maxCoeff() > 0.37);
}

TEST_CASE("A long part is a sheet if it is a blade, a curve if it is a slat")
{
  CHECK(abstraction_of(box({0, 0, 0}, {1, 0.014, 0.15})).is_sheet());
  CHECK_FALSE(abstraction_of(box({0, 0, 0}, {1, 0.04, 0.14})).is_sheet());
  CHECK_FALSE(abstraction_of(box({0, 0, 0}, {1, 0.003, 0.04})).is_sheet());
}

TEST_CASE("A wing is a sheet, also a thick one that gets narrower towards its tips")
{
  const double chord = 2, thickness = 0.26, tip = 0.6;
  const int corners = 12;
  Part_mesh wing;
  wing.points.resize(3, 3 * corners + 2);
  for (int section = 0; section < 3; ++section) {
    const double scale = section == 1 ? 0.5 : 0.5 * tip;
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * EIGEN_PI * k / corners;
      wing.points.col(section * corners + k) =
          Point(5 * (section - 1), scale * thickness * std::sin(angle), scale * chord * std::cos(angle));
    }
  }
  const int left = 3 * corners, right = left + 1; // midpoints of the tips
  wing.points.col(left) = -5 * Point::UnitX();
  wing.points.col(right) = 5 * Point::UnitX();
  wing.triangles.resize(3, 6 * corners);
  for (int k = 0; k < corners; ++k) {
    const int l = (k + 1) % corners, m = corners, n = 2 * corners;
    wing.triangles.middleCols(6 * k, 6) << left, k, k, k + m, k + m, right, //
        l, l, l + m, l + m, l + n, k + n,                                   //
        k, l + m, k + m, l + n, k + n, l + n;
  }
  const Part_abstraction part = abstraction_of(wing);
  CHECK(part.is_sheet());
  CHECK_FALSE(part.report.branching);
  CHECK(part.report.coverage > 0.9);
}

TEST_CASE("A box that is open in front has an axis to the front, also where its skeleton is a point")
{
  const double wall = 1.3;
  for (double depth : {30., 35., 41.}) {
    CAPTURE(depth);
    const auto without_front = [](const Part_mesh& mesh) {
      Part_mesh result{mesh.points, mesh.triangles.leftCols(10)};
      result.triangles.col(2) = mesh.triangles.col(10);
      result.triangles.col(3) = mesh.triangles.col(11);
      return result;
    };
    const Part_mesh outside = box({0, 0, 0}, {50, 48, depth}),
                    inside = box({wall, wall, wall}, {50 - wall, 48 - wall, depth});
    Part_mesh open_box =
        joined(without_front(outside), without_front({inside.points, inside.triangles.colwise().reverse()}));
    open_box.triangles.conservativeResize(3, 28);
    const int front[] = {4, 5, 7, 6, 4};
    for (int k = 0; k < 4; ++k) {
      const int a = front[k], b = front[k + 1], b_inside = b + 8, a_inside = a + 8;
      open_box.triangles.middleCols(20 + 2 * k, 2) << a, a, b, b_inside, b_inside, a_inside;
    }
    const Part_abstraction part = abstraction_of(open_box);
    REQUIRE_FALSE(part.is_sheet());
    CHECK(part.report.method == Method::AXIS);
    const Points& points = part.control_points();
    const Point direction = (points.rightCols(1) - points.leftCols(1)).normalized();
    CHECK(std::abs(direction.z()) > 0.99);
  }
}

TEST_CASE("A disc is a sheet across its axle, however long that is")
{
  const double out = 0.055, in = 0.009;
  const Part_abstraction part = abstraction_of(turned(
      {{0, -0.05}, {in, -0.05}, {in, -0.01}, {out, -0.008}, {out, 0.008}, {in, 0.01}, {in, 0.05}, {0, 0.05}}, 20));
  REQUIRE(part.is_sheet());
  CHECK(part.control_points().row(1).cwiseAbs().maxCoeff() < 0.012);
  CHECK(part.control_points().row(0).maxCoeff() > 0.05);
}

TEST_CASE("A carcass of thin walls that is flat as a whole is a sheet")
{
  // The stairs of a loft bed, open at the back.
  const double wall = 0.012;
  Part_mesh stairs;
  for (int k = 0; k < 4; ++k) {
    const double left = 0.3 * k, right = 1.2, low = 0.3 * k, high = 0.3 * (k + 1), depth = 0.5;
    stairs = joined(stairs, box({left, high - wall, 0}, {right, high, depth}));
    stairs = joined(stairs, box({left, low - wall, 0}, {left + wall, high, depth}));
    stairs = joined(stairs, box({left, low - wall, 0}, {right, high, wall}));
  }
  const Part_abstraction part = abstraction_of(stairs);
  REQUIRE(part.is_sheet());
  CHECK(part.control_points().row(0).maxCoeff() > 1.1);
  CHECK(part.control_points().row(1).maxCoeff() > 1.1);
  CHECK((part.control_points().row(2).array() - 0.25).abs().maxCoeff() < 0.01);
}

TEST_CASE("A part of spread arms is no blade")
{
  const Part_mesh cross =
      joined(joined(box({-0.03, 0, -0.03}, {0.03, 1, 0.03}), box({-0.35, 0, -0.03}, {0.35, 0.03, 0.03})),
             box({-0.03, 0, -0.35}, {0.03, 0.03, 0.35}));
  CHECK_FALSE(abstraction_of(cross).is_sheet());
}

TEST_CASE("A flat part of many arms or bars becomes a sheet, not a curve through some of them")
{
  SECTION("a propeller")
  {
    Part_mesh propeller;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Matrix3d turn = Eigen::AngleAxisd(k * EIGEN_PI / 3, Point::UnitZ()).toRotationMatrix();
      propeller = joined(propeller, moved(box({-1, -0.05, -0.02}, {1, 0.05, 0.02}), turn, Point(0, 0, 0.001 * k)));
    }
    const Part_abstraction part = abstraction_of(propeller);
    REQUIRE(part.is_sheet());
    CHECK(part.control_points().row(0).minCoeff() < -0.95);
    CHECK(part.control_points().row(1).maxCoeff() > 0.8);
    CHECK(part.report.branching);
    CHECK(part.report.coverage < 0.7);
  }
  SECTION("the star base of an office chair")
  {
    Part_mesh star;
    for (int k = 0; k < 5; ++k) {
      const Eigen::Matrix3d turn = Eigen::AngleAxisd(k * 2 * EIGEN_PI / 5, Point::UnitY()).toRotationMatrix();
      star = joined(star, moved(box({0, -0.03, -0.03}, {1, 0.03, 0.03}), turn, Point(0, 0.001 * k, 0)));
    }
    const Part_abstraction part = abstraction_of(star);
    CHECK(part.report.branching);
    CHECK(part.report.coverage < 0.7);
  }
  SECTION("a pedal: a cage with bars across")
  {
    Part_mesh pedal = joined(box({0, 0, 0}, {1, 0.2, 0.06}), box({0, 0, 0.64}, {1, 0.2, 0.7}));
    for (double x : {0., 0.31, 0.63, 0.94}) {
      pedal = joined(pedal, box({x, 0.05, 0}, {x + 0.06, 0.15, 0.7}));
    }
    CHECK(abstraction_of(pedal).is_sheet());
  }
}

TEST_CASE("A tyre that is open inside is a ring, also with spokes")
{
  std::vector<Eigen::Vector2d> profile;
  for (int i = 0; i <= 8; ++i) {
    const double angle = (i / 8. - 0.5) * 1.3 * EIGEN_PI;
    profile.emplace_back(1 + 0.06 * std::cos(angle), 0.06 * std::sin(angle));
  }
  Part_mesh wheel = turned(profile, 32);
  for (int k = 0; k < 8; ++k) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(k * EIGEN_PI / 8, Point::UnitY()).toRotationMatrix();
    wheel = joined(wheel, moved(box({-1, -0.01, -0.01}, {1, 0.01, 0.01}), turn, Point::Zero()));
  }
  const Part_abstraction part = abstraction_of(wheel);
  REQUIRE(part.is_closed_curve());
  CHECK((part.control_points().colwise().norm().array() - 1).abs().maxCoeff() < 0.08);
}

TEST_CASE("The axis of a block is the one along which it differs most from the other two")
{
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.4, Point::UnitY()).toRotationMatrix();
  const auto direction_of = [&](const Point& extents) {
    const Part_abstraction part = abstraction_of(moved(box(-0.5 * extents, 0.5 * extents), turn, Point(1, 2, 3)));
    REQUIRE_FALSE(part.is_sheet());
    CHECK(part.report.blob);
    const Points& points = part.control_points();
    CHECK((points.rowwise().mean() - Point(1, 2, 3)).norm() < 0.01);
    return Point(turn.transpose() * (points.rightCols<1>() - points.leftCols<1>()));
  };
  CHECK(direction_of({1, 0.5, 1}).cwiseAbs().isApprox(Point(0, 0.5, 0), 0.02));
  CHECK(direction_of({1, 0.6, 0.6}).cwiseAbs().isApprox(Point(1, 0, 0), 0.02));
  CHECK(direction_of({0.95, 1, 0.97}).cwiseAbs().isApprox(Point(0, 1, 0), 0.02)); // nearly a cube: upright axis
  CHECK(abstraction_of(box({0, 0, 0}, {1, 0.38, 1})).is_sheet());                 // a thick cushion, not a block
}

TEST_CASE("A thick cushion becomes a sheet, a wheel of that thickness keeps its axis")
{
  const std::pair<Point, double> cushions[] = {
      {{0.6, 0.25, 0.5}, 4}, {{0.6, 0.28, 0.6}, 4}, {{0.5, 0.22, 0.45}, 3}, {{0.6, 0.25, 0.42}, 6}};
  for (const auto& [size, exponent] : cushions) {
    INFO(size.transpose() << ", exponent " << exponent);
    const Part_abstraction part = abstraction_of(cushion(size, exponent));
    REQUIRE(part.is_sheet());
    CHECK(part.report.method == Method::MEDIAL_AXIS);
    CHECK(part.control_points().row(1).cwiseAbs().maxCoeff() < 0.05);
    CHECK(part.control_points().row(0).maxCoeff() > 0.4 * size.x());
  }
  const Part_abstraction wheel = abstraction_of(cushion({0.6, 0.25, 0.6}, 2));
  CHECK_FALSE(wheel.is_sheet());
  CHECK(wheel.report.method == Method::AXIS);
}

TEST_CASE("A compact body of revolution becomes a curve along its axis")
{
  const Point axis = Point(0.3, 0.8, -0.5).normalized();
  const Eigen::Matrix3d tilt = Eigen::Quaterniond::FromTwoVectors(Point::UnitY(), axis).toRotationMatrix();
  const auto check = [&](const std::vector<Eigen::Vector2d>& profile, double height) {
    const Part_abstraction part = abstraction_of(moved(turned(profile), tilt, Point(1, 2, 3)));
    REQUIRE_FALSE(part.is_sheet());
    CHECK(part.report.method == Method::AXIS);
    CHECK(part.report.blob);
    const Points& points = part.control_points();
    const Point along = points.col(15) - points.col(0);
    CHECK(std::abs(along.dot(axis)) == Approx(height).epsilon(0.03));
    CHECK(along.cross(axis).norm() < 0.03 * height);
    CHECK((points.col(7) - Point(1, 2, 3)).cross(axis).norm() < 0.02);
  };
  SECTION("a wheel") { check({{0, 0}, {0.5, 0}, {0.5, 0.4}, {0, 0.4}}, 0.4); }
  SECTION("a bell, whose principal axes say nothing")
  {
    check({{0, 0}, {0.3, 0}, {0.45, -0.3}, {0.5, -0.55}, {0.48, -0.55}, {0.43, -0.3}, {0.28, -0.02}, {0, -0.02}}, 0.55);
  }
  SECTION("a tube, which is said to be one")
  {
    const double r = 0.5, wall = 0.02, h = 0.4;
    const Part_abstraction part = abstraction_of(torus_like(32, 4, [=](double u, double v) {
      const int corner = int(std::lround(2 * v / EIGEN_PI));
      const double radius = r + (corner == 1 || corner == 2 ? wall : 0.);
      return Point(radius * std::cos(u), corner < 2 ? 0 : h, radius * std::sin(u));
    }));
    CHECK(part.report.tube);
    CHECK_FALSE(part.report.blob);
    CHECK(part.report.method == Method::AXIS);
    CHECK(part.control_points().row(1).maxCoeff() == Approx(h).epsilon(0.05));
    CHECK(part.control_points().row(0).cwiseAbs().maxCoeff() < 0.02);
  }
  SECTION("but a disc is a sheet")
  {
    CHECK(abstraction_of(moved(turned({{0, 0}, {0.5, 0}, {0.5, 0.1}, {0, 0.1}}), tilt, Point::Zero())).is_sheet());
  }
}

TEST_CASE("A sheet goes along a part that is bent")
{
  const Part_abstraction part = abstraction_of(half_pipe(1.5, 0.06));
  REQUIRE(part.is_sheet());
  CHECK(part.report.residual < 0.02);
  const Points& points = part.control_points();
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    CHECK(std::hypot(points(0, i), points(2, i)) == Approx(1).margin(0.08));
  }
  CHECK(points.row(0).minCoeff() < -0.9);
  CHECK(points.row(0).maxCoeff() > 0.9);
  CHECK(points.row(1).maxCoeff() - points.row(1).minCoeff() == Approx(1.5).margin(0.1));
}

TEST_CASE("Open and badly made parts get an abstraction")
{
  SECTION("an open box is closed")
  {
    const Part_abstraction part = abstraction_of(without_triangles(leg, 2));
    CHECK(part.report.repair == Abstraction_report::Repair::HOLES);
    CHECK(part.volume == Approx(0.01));
    CHECK_FALSE(part.is_sheet());
  }
  SECTION("turned triangles")
  {
    Part_mesh mesh = leg;
    for (int t = 0; t < 12; t += 5) {
      std::swap(mesh.triangles(0, t), mesh.triangles(1, t));
    }
    CHECK(abstraction_of(mesh).volume == Approx(0.01));
  }
  SECTION("one edge of three faces")
  {
    Part_mesh fin;
    fin.points.resize(3, 3);
    fin.points << 0, 0, -0.3, 0, 1, 0.5, 0, 0, 0;
    fin.triangles.resize(3, 1);
    fin.triangles << 0, 1, 2;
    const Part_abstraction part = abstraction_of(joined(leg, fin));
    CHECK(part.control_points().allFinite());
    CHECK(part.volume > 0);
  }
  SECTION("two components")
  {
    const Part_abstraction part = abstraction_of(joined(leg, box({0.2, 0, 0}, {0.3, 1, 0.1})));
    CHECK(part.report.several_components);
    CHECK(part.volume == Approx(0.02));
    CHECK(part.hull_volume == Approx(0.03));
  }
  SECTION("a single triangle")
  {
    Part_mesh mesh = leg;
    mesh.triangles = mesh.triangles.leftCols(1).eval();
    const Part_abstraction part = abstraction_of(mesh);
    CHECK(part.control_points().allFinite());
    CHECK(part.hull_volume == 0);
    CHECK(solidity(part.volume, part.hull_volume) == 1);
  }
  SECTION("a needle")
  {
    const Part_abstraction part = abstraction_of(box({0, 0, 0}, {1e-9, 1, 1e-9}));
    CHECK_FALSE(part.is_sheet());
    CHECK(part.control_points().row(1).minCoeff() == Approx(0).margin(1e-9));
    CHECK(part.control_points().row(1).maxCoeff() == Approx(1));
  }
}

TEST_CASE("Fewer triangles give nearly the same curve")
{
  Abstraction_options options;
  options.triangles = 500;
  const Part_abstraction coarse = abstract_part({"leg", leg}, options);
  CHECK((coarse.control_points() - abstraction_of(leg).control_points()).colwise().norm().maxCoeff() < 0.04);
}

TEST_CASE("Mid-lines and mid-surfaces of the models are found")
{
  std::vector<double> deviations;
  for (const char* model : {"chair_four_legged", "chair_swivel", "stool", "table_pedestal", "bed_slatted", "lamp_desk",
                            "airplane_twin_engine"}) {
    const std::string folder = std::string(SHAPE_CORRESPONDENCE_DATA_DIR) + "/" + model;
    const Segmented_shape shape = IO::read_segmented_shape(folder + "/parts");
    const std::map<std::string, Part_abstraction> stated = benchmark::stated_abstractions(folder);
    const Structural_graph graph = build_structural_graph<CGAL::Parallel_if_available_tag>(shape);
    const std::vector<Part_abstraction>& found = structure(graph).parts;
    REQUIRE(found.size() == stated.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      INFO(model << ", " << found[i].name);
      const Part_abstraction& expected = stated.at(found[i].name);
      CHECK(benchmark::same_kind(found[i], expected));
      for (double d : benchmark::deviations(found[i], expected))
        deviations.push_back(d / benchmark::diagonal(shape.parts()[i].mesh.points));
    }
  }
  CHECK(benchmark::quantile(deviations, 0.5) < 0.01);
  CHECK(benchmark::quantile(deviations, 0.95) < 0.04);
}
