#include <catch2/catch.hpp>

#include "abstraction_error.h"
#include "damaged_meshes.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/abstract_part.h>

#include <Eigen/Geometry>

#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

using namespace CGAL::Shape_correspondence;
using Method = Abstraction_report::Method;

namespace {

Part_mesh box(const Point& low, const Point& high)
{
  Part_mesh result;
  result.points.resize(3, 8);
  for (int v = 0; v < 8; ++v) {
    result.points.col(v) << (v & 1 ? high : low).x(), (v & 2 ? high : low).y(), (v & 4 ? high : low).z();
  }
  result.triangles.resize(3, 12);
  result.triangles << 0, 3, 4, 7, 0, 5, 2, 7, 0, 6, 1, 7, //
      2, 1, 5, 6, 1, 4, 6, 3, 4, 2, 3, 5,                 //
      3, 0, 7, 4, 5, 0, 7, 2, 6, 0, 7, 1;
  return result;
}

/// A closed surface over a grid that wraps around in both directions; `f` of two angles.
template <typename Function>
Part_mesh torus_like(int n, int m, const Function& f)
{
  Part_mesh result;
  result.points.resize(3, n * m);
  result.triangles.resize(3, 2 * n * m);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      const int a = i * m + j, b = (i + 1) % n * m + j, c = (i + 1) % n * m + (j + 1) % m, d = i * m + (j + 1) % m;
      result.points.col(a) = f(2 * EIGEN_PI * i / n, 2 * EIGEN_PI * j / m);
      result.triangles.col(2 * a) << a, b, c;
      result.triangles.col(2 * a + 1) << a, c, d;
    }
  }
  return result;
}

Part_mesh torus(double radius, double thickness)
{
  return torus_like(40, 12, [=](double u, double v) {
    const double r = radius + thickness * std::cos(v);
    return Point(r * std::cos(u), thickness * std::sin(v), r * std::sin(u));
  });
}

/// A closed surface of revolution about y through points (radius, height), from the axis to the axis.
Part_mesh turned(const std::vector<Eigen::Vector2d>& profile, int n = 24)
{
  const int rings = int(profile.size());
  Part_mesh result;
  result.points.resize(3, rings * n);
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < n; ++j) {
      const double angle = 2 * EIGEN_PI * j / n, radius = profile[std::size_t(i)].x();
      result.points.col(i * n + j) << radius * std::cos(angle), profile[std::size_t(i)].y(), radius * std::sin(angle);
      if (i + 1 < rings) {
        const int a = i * n + j, b = i * n + (j + 1) % n;
        triangles.emplace_back(a, a + n, b + n);
        triangles.emplace_back(a, b + n, b);
      }
    }
  }
  result.triangles.resize(3, Eigen::Index(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    result.triangles.col(Eigen::Index(t)) = triangles[t];
  }
  return result;
}

/// A plate of a thickness about half a cylinder of radius 1, `width` along its axis y.
Part_mesh half_pipe(double width, double thickness)
{
  const int n = 24;
  Part_mesh result;
  result.points.resize(3, 4 * (n + 1));
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i <= n; ++i) {
    const double angle = EIGEN_PI * i / n;
    for (int k = 0; k < 4; ++k) {
      const double r = 1 + (k == 1 || k == 2 ? 0.5 : -0.5) * thickness;
      result.points.col(4 * i + k) << r * std::cos(angle), k < 2 ? 0 : width, r * std::sin(angle);
      const int a = 4 * i + k, b = 4 * i + (k + 1) % 4;
      if (i < n) {
        triangles.emplace_back(a, b, b + 4);
        triangles.emplace_back(a, b + 4, a + 4);
      }
    }
  }
  triangles.insert(triangles.end(),
                   {{0, 2, 1}, {0, 3, 2}, {4 * n, 4 * n + 1, 4 * n + 2}, {4 * n, 4 * n + 2, 4 * n + 3}});
  result.triangles.resize(3, Eigen::Index(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    result.triangles.col(Eigen::Index(t)) = triangles[t];
  }
  return result;
}

Part_mesh joined(const Part_mesh& a, const Part_mesh& b)
{
  Part_mesh result;
  result.points.resize(3, a.points.cols() + b.points.cols());
  result.points << a.points, b.points;
  result.triangles.resize(3, a.triangles.cols() + b.triangles.cols());
  result.triangles << a.triangles, (b.triangles.array() + int(a.points.cols())).matrix();
  return result;
}

Part_mesh without_triangles(const Part_mesh& mesh, Eigen::Index count)
{
  return {mesh.points, mesh.triangles.rightCols(mesh.triangles.cols() - count)};
}

Part_mesh moved(const Part_mesh& mesh, const Eigen::Matrix3d& linear, const Point& offset)
{
  return {(linear * mesh.points).colwise() + offset, mesh.triangles};
}

Part_abstraction abstraction_of(const Part_mesh& mesh) { return abstract_part({"part", mesh}); }

bool same_bits(const Part_abstraction& a, const Part_abstraction& b)
{
  return a.geometry.index() == b.geometry.index() && a.control_points() == b.control_points() &&
         a.surface == b.surface && a.hull == b.hull && a.volume == b.volume && a.hull_volume == b.hull_volume &&
         a.area == b.area && a.report.method == b.report.method && a.report.iterations == b.report.iterations &&
         a.report.residual == b.report.residual;
}

const Part_mesh leg = box({0, 0, 0}, {0.1, 1, 0.1});
const Part_mesh plate = box({0, 0, 0}, {1, 0.06, 0.8});

} // namespace

TEST_CASE("A leg becomes a curve along its axis")
{
  const Part_abstraction part = abstraction_of(leg);
  REQUIRE_FALSE(part.is_sheet());
  CHECK_FALSE(part.is_closed_curve());
  CHECK(part.report.method == Method::SKELETON);
  CHECK(part.report.repair == Abstraction_report::Repair::NONE);
  CHECK(part.volume == Approx(0.01));
  CHECK(part.hull_volume == Approx(0.01));
  CHECK(part.area == Approx(0.42));
  CHECK(part.surface.cols() == 256);
  CHECK(part.hull.cols() == 8);
  const Points& points = part.control_points();
  REQUIRE(points.cols() == 16);
  CHECK((points.row(0).array() - 0.05).abs().maxCoeff() < 0.02);
  CHECK((points.row(2).array() - 0.05).abs().maxCoeff() < 0.02);
  CHECK(points(1, 0) < 0.08);
  CHECK(points(1, 15) > 0.92);
}

TEST_CASE("A plate becomes a sheet that reaches its rim")
{
  const Part_abstraction part = abstraction_of(plate);
  REQUIRE(part.is_sheet());
  CHECK(part.report.method == Method::MEDIAL_AXIS);
  CHECK(part.report.residual < 0.02);
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
  const Points& points = part.control_points();
  CHECK((points.colwise().norm().array() - 1).abs().maxCoeff() < 0.05);
  CHECK(points.row(1).cwiseAbs().maxCoeff() < 0.05);
}

TEST_CASE("A ball is called a blob")
{
  const Part_mesh ball = torus_like(24, 24, [](double u, double v) {
    return Point(std::cos(u) * (1 + 1e-6 - std::cos(v)) / 2, std::sin(v) / 2 + v / 6.3,
                 std::sin(u) * (1 - std::cos(v)) / 2);
  });
  const Part_abstraction part = abstraction_of(box({0, 0, 0}, {1, 1, 1}));
  CHECK_FALSE(part.is_sheet());
  CHECK(part.report.blob);
  CHECK(abstraction_of(ball).control_points().allFinite());
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

TEST_CASE("Arms that spread make no blade")
{
  const Part_mesh cross =
      joined(joined(box({-0.03, 0, -0.03}, {0.03, 1, 0.03}), box({-0.35, 0, -0.03}, {0.35, 0.03, 0.03})),
             box({-0.03, 0, -0.35}, {0.03, 0.03, 0.35}));
  CHECK_FALSE(abstraction_of(cross).is_sheet());
}

TEST_CASE("A compact body of revolution becomes a curve along its axis")
{
  const Point axis = Point(0.3, 0.8, -0.5).normalized();
  const Eigen::Matrix3d tilt = Eigen::Quaterniond::FromTwoVectors(Point::UnitY(), axis).toRotationMatrix();
  const auto check = [&](const std::vector<Eigen::Vector2d>& profile, double height) {
    const Part_abstraction part = abstraction_of(moved(turned(profile), tilt, Point(1, 2, 3)));
    REQUIRE_FALSE(part.is_sheet());
    CHECK(part.report.method == Method::REVOLUTION_AXIS);
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
    CHECK(part.report.method == Method::REVOLUTION_AXIS);
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
    CHECK(part.control_points().row(1).minCoeff() < 0.1);
    CHECK(part.control_points().row(1).maxCoeff() > 0.9);
  }
}

TEST_CASE("Limits lead to the bounding box, and the report says so")
{
  Abstraction_options options;
  options.time_limit = 0;
  const Part_abstraction late = abstract_part({"leg", leg}, options);
  CHECK(late.report.time_limit);
  CHECK(late.report.method == Method::BOUNDING_BOX);
  CHECK(late.report.is_fallback());
  CHECK(late.report.fallback == "it needs more time than allowed");
  CHECK_FALSE(late.is_sheet());
  CHECK(abstract_part({"plate", plate}, options).is_sheet());
  options = {};
  options.maximum_iterations = 0;
  CHECK(abstract_part({"leg", leg}, options).report.method == Method::BOUNDING_BOX);
}

TEST_CASE("The number of control points is an option")
{
  Abstraction_options options;
  options.curve_points = 5;
  options.sheet_points = 3;
  CHECK(abstract_part({"leg", leg}, options).control_points().cols() == 5);
  CHECK(abstract_part({"plate", plate}, options).control_points().cols() == 9);
}

TEST_CASE("The same part gives the same bits whatever is on the heap")
{
  // A shape on which collapses in another order give another skeleton.
  const Part_mesh mesh = joined(torus(1, 0.25), box({0.9, -0.1, -0.1}, {2.4, 0.1, 0.1}));
  const Part_abstraction first = abstraction_of(mesh);
  std::vector<std::unique_ptr<char[]>> churn;
  for (int round = 0; round < 3; ++round) {
    for (std::size_t k = 0; k < 20000; ++k) {
      churn.push_back(std::make_unique<char[]>(16 + (k * 7919 + std::size_t(round) * 104729) % 400));
    }
    for (std::size_t k = 0; k < churn.size(); k += 2 + k % 3) {
      churn[k].reset();
    }
    CHECK(same_bits(first, abstraction_of(mesh)));
    CHECK(same_bits(abstraction_of(plate), abstraction_of(plate)));
  }
}

TEST_CASE("The order of vertices and triangles in the file does not matter")
{
  Part_mesh reversed;
  reversed.points = plate.points.rowwise().reverse();
  reversed.triangles = (7 - plate.triangles.rowwise().reverse().array()).matrix();
  CHECK(same_bits(abstraction_of(plate), abstraction_of(reversed)));
}

TEST_CASE("Parts of a shape")
{
  Segmented_shape shape("stool");
  const Eigen::Matrix3d mirror = Point(-1, 1, 1).asDiagonal();
  const Part_mesh bent =
      moved(leg, (Eigen::Matrix3d() << 1, 0.3, 0, 0, 1, 0, 0, 0.1, 1).finished(), Point(0.3, 0, 0.1));
  shape.add_part("seat", box({-0.5, 1, -0.4}, {0.5, 1.06, 0.4}));
  shape.add_part("right", bent);
  shape.add_part("left", moved(bent, mirror, Point::Zero()));
  shape.add_part("behind", moved(bent, Eigen::Matrix3d::Identity(), Point(0, 0, -0.4)));
  shape.add_part("turned", moved(bent, Eigen::AngleAxisd(2.2, Point::UnitY()).toRotationMatrix(), Point(0, 0, 0.2)));
  Shape_frame frame;
  frame.height = 1.06;

  const std::vector<Part_abstraction> parts = abstract_parts(shape, frame);
  REQUIRE(parts.size() == 5);
  CHECK(parts[0].is_sheet());
  CHECK(parts[2].name == "left");

  SECTION("copies are congruent")
  {
    int copies = 0;
    for (const Part_abstraction& part : parts) {
      copies += part.report.method == Method::COPY;
    }
    CHECK(copies == 3);
    CHECK((mirror * parts[1].control_points()).isApprox(parts[2].control_points(), 1e-5));
    CHECK((parts[1].control_points().colwise() - Point(0, 0, 0.4)).isApprox(parts[3].control_points(), 1e-5));
    CHECK(parts[4].volume == Approx(0.01));
    CHECK(parts[4].area == Approx(parts[1].area));
  }
  SECTION("parallel is the same to the bit")
  {
    const std::vector<Part_abstraction> parallel = abstract_parts<CGAL::Parallel_tag>(shape, frame);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      CHECK(same_bits(parts[i], parallel[i]));
    }
  }
  SECTION("a shape that is turned, moved and scaled gives the same in its frame")
  {
    Shape_frame other = frame;
    other.axes = Eigen::AngleAxisd(0.8, Point::UnitY()).toRotationMatrix();
    other.origin = Point(5, -3, 2);
    other.height = 3 * frame.height;
    Segmented_shape moved_shape("stool");
    for (const Shape_part& part : shape.parts()) {
      moved_shape.add_part(part.name, {other.to_world(frame.to_frame(part.mesh.points)), part.mesh.triangles});
    }
    const std::vector<Part_abstraction> others = abstract_parts(moved_shape, other);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      CHECK(other.to_frame(others[i].control_points()).isApprox(frame.to_frame(parts[i].control_points()), 1e-9));
      CHECK(others[i].volume == Approx(27 * parts[i].volume));
      CHECK(others[i].report.iterations == parts[i].report.iterations);
    }
  }
}

TEST_CASE("Progress counts all parts")
{
  Segmented_shape shape;
  shape.add_part("a", leg);
  shape.add_part("b", moved(leg, Eigen::Matrix3d::Identity(), Point(1, 0, 0)));
  std::vector<std::size_t> calls;
  Abstraction_options options;
  options.progress = [&](std::size_t done, std::size_t total) {
    CHECK(total == 2);
    calls.push_back(done);
  };
  abstract_parts<CGAL::Parallel_tag>(shape, {}, options);
  CHECK(calls == std::vector<std::size_t>{1, 2});
}

TEST_CASE("Surface points are spread evenly and include corners")
{
  const Points points = sample_surface(box({0, 0, 0}, {1, 1, 1}), 200);
  REQUIRE(points.cols() == 200);
  CHECK(points.rowwise().minCoeff() == Point(0, 0, 0));
  CHECK(points.rowwise().maxCoeff() == Point(1, 1, 1));
  for (int i = 0; i < 200; ++i) {
    const double on_face = std::min(points.col(i).minCoeff(), (1 - points.col(i).array()).minCoeff());
    CHECK(std::abs(on_face) < 1e-12);
    Eigen::RowVectorXd distances = (points.colwise() - points.col(i)).colwise().norm();
    distances[i] = 1;
    CHECK(distances.minCoeff() > 0.05);
    CHECK(distances.minCoeff() < 0.35);
  }
}

TEST_CASE("Hull volumes")
{
  CHECK(convex_hull_volume(leg.points) == Approx(0.01));
  CHECK(convex_hull_volume(leg.points.leftCols(4)) == 0);
  CHECK(convex_hull_volume(leg.points.leftCols(2)) == 0);
  CHECK(convex_hull_volume(Points(3, 0)) == 0);
}

TEST_CASE("Kinds can be forced, of all parts and of single ones")
{
  Abstraction_options options;
  options.kind = Abstraction_kind::SHEET;
  const Part_abstraction sheet = abstract_part({"leg", leg}, options);
  CHECK(sheet.is_sheet());
  CHECK_FALSE(sheet.report.is_fallback());
  CHECK(sheet.control_points().row(1).maxCoeff() == Approx(1).margin(0.02));
  options.part_kinds["leg"] = Abstraction_kind::CURVE;
  CHECK_FALSE(abstract_part({"leg", leg}, options).is_sheet());
  options.kind = Abstraction_kind::CURVE;
  CHECK_FALSE(abstract_part({"plate", plate}, options).is_sheet());

  SECTION("copies of another kind are no copies")
  {
    Segmented_shape shape;
    shape.add_part("leg", leg);
    shape.add_part("other", moved(leg, Eigen::Matrix3d::Identity(), Point(1, 0, 0)));
    options.part_kinds["other"] = Abstraction_kind::SHEET;
    const std::vector<Part_abstraction> parts = abstract_parts(shape, {}, options);
    CHECK_FALSE(parts[0].is_sheet());
    CHECK(parts[1].is_sheet());
  }
}

TEST_CASE("A copy of a part that got its bounding box says so")
{
  Segmented_shape shape;
  shape.add_part("leg", leg);
  shape.add_part("other", moved(leg, Eigen::Matrix3d::Identity(), Point(1, 0, 0)));
  Abstraction_options options;
  options.time_limit = 0;
  const std::vector<Part_abstraction> parts = abstract_parts(shape, {}, options);
  const std::size_t copy = parts[0].report.method == Method::COPY ? 0 : 1;
  CHECK(parts[copy].report.copy_of == parts[1 - copy].name);
  CHECK(parts[copy].report.is_fallback());
  CHECK(parts[copy].report.fallback == parts[1 - copy].report.fallback);
}

TEST_CASE("Another abstractor can be put in place of the skeletonizer")
{
  Abstraction_options options;
  SECTION("bounding boxes")
  {
    options.abstractor = Bounding_box_abstraction();
    const Part_abstraction part = abstract_part({"plate", plate}, options);
    CHECK(part.is_sheet());
    CHECK(part.report.method == Method::BOUNDING_BOX);
    CHECK_FALSE(part.report.is_fallback()); // it was asked for
    CHECK(part.hull_volume == Approx(0.048));
    options.kind = Abstraction_kind::CURVE;
    CHECK_FALSE(abstract_part({"plate", plate}, options).is_sheet());
  }
  SECTION("one of our own")
  {
    options.abstractor = [](const Shape_part& part, const Abstraction_options&) {
      Part_abstraction result;
      result.geometry = Curve{part.mesh.points.leftCols(2), false};
      return result;
    };
    const Part_abstraction part = abstract_part({"leg", leg}, options);
    CHECK(part.name == "leg");
    CHECK(part.control_points().cols() == 2);
    CHECK(part.report.method == Method::GIVEN);
    CHECK(part.area == Approx(0.42));
    CHECK(part.surface.cols() == 256);
  }
  SECTION("one that returns nonsense is found out")
  {
    options.abstractor = [](const Shape_part&, const Abstraction_options&) { return Part_abstraction(); };
    CHECK_THROWS_WITH(abstract_part({"leg", leg}, options),
                      "part 'leg': the abstractor returned too few points; correct it or use another one");
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
    const std::vector<Part_abstraction> found = abstract_parts<CGAL::Parallel_if_available_tag>(shape, {});
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

TEST_CASE("Damaged parts get a valid abstraction or an error that names them")
{
  Abstraction_options options;
  options.time_limit = 5;
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    Segmented_shape shape;
    try {
      shape.add_part("damaged", damaged_meshes::damaged_mesh(seed, 1500));
    } catch (const Invalid_input& error) {
      CHECK(std::string(error.what()).find("'damaged'") != std::string::npos);
      continue;
    }
    const Part_abstraction part = abstract_part(shape.parts()[0], options);
    CHECK(part.control_points().cols() >= 2);
    CHECK(part.control_points().allFinite());
    CHECK(part.surface.allFinite());
  }
}
