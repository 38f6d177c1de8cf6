#include "abstraction/repair.h"
#include "abstraction/skeletonize.h"
#include "damaged_meshes.h"
#include "part_meshes.h"

#include "shape/convex_hull.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <CGAL/Timer.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace part_meshes;
using Method = Abstraction_report::Method;

namespace {

bool same_bits(const Part_abstraction& a, const Part_abstraction& b)
{
  return a.geometry.index() == b.geometry.index() && a.control_points() == b.control_points() &&
         a.surface == b.surface && a.hull == b.hull && a.volume == b.volume && a.hull_volume == b.hull_volume &&
         a.area == b.area && a.report.method == b.report.method && a.report.iterations == b.report.iterations &&
         a.report.residual == b.report.residual;
}

/// Allocates and frees memory, so that later allocations get other addresses.
class Heap_churn
{
public:
  void turn_over(int round, std::size_t blocks = 20000)
  {
    for (std::size_t k = 0; k < blocks; ++k) {
      blocks_.push_back(std::make_unique<char[]>(16 + (k * 7919 + std::size_t(round) * 104729) % 400));
    }
    for (std::size_t k = 0; k < blocks_.size(); k += 2 + (k + std::size_t(round)) % 3) {
      blocks_[k].reset();
    }
  }

private:
  std::vector<std::unique_ptr<char[]>> blocks_;
};

/// A cup whose rim goes up and down, so that its hole has many equally good fillings.
Part_mesh cup(int corners)
{
  Part_mesh result;
  result.points.resize(3, 2 * corners + 1);
  result.points.col(2 * corners) = Point::Zero();
  result.triangles.resize(3, 3 * corners);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * EIGEN_PI * i / corners;
    result.points.col(i) = Point(std::cos(angle), 0, std::sin(angle));
    result.points.col(corners + i) = result.points.col(i) + (i % 3 == 0 ? 2.25 : 2) * Point::UnitY();
    const int j = (i + 1) % corners;
    result.triangles.middleCols(3 * i, 3) << i, i, 2 * corners, corners + i, corners + j, i, corners + j, j, j;
  }
  return result;
}

/// A clock that advances by a second at every reading, independent of the speed of the machine.
struct Looked_at_clock
{
  std::shared_ptr<int> looks = std::make_shared<int>(0);

  double operator()() const { return (*looks)++; }
};

/// Checks that work which reads the clock at least `least_looks` times stops at the first reading after its limit.
template <typename Work>
void check_that_it_stops(int least_looks, const Work& work)
{
  const Looked_at_clock whole;
  work(internal::Deadline(1e9, whole));
  REQUIRE(*whole.looks >= least_looks);
  for (int limit : {0, *whole.looks / 2, *whole.looks - 1}) {
    const Looked_at_clock clock;
    CHECK_THROWS_AS(work(internal::Deadline(limit, clock)), internal::Out_of_time);
    CHECK(*clock.looks == limit + 1);
  }
}

} // namespace

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
  CHECK(abstract_part({"ring", torus(1, 0.1)}, options).report.method == Method::BOUNDING_BOX);
  CHECK(abstract_part({"leg", leg}, options).report.method == Method::PRISM); // a prism, which needs no flow
}

TEST_CASE("Long steps check the time limit repeatedly, and stop when it is reached")
{
  const Part_mesh solid = internal::remeshed(leg, 0.05, internal::Deadline(1e9));
  SECTION("a wrap")
  {
    Part_mesh shelves; // no component dominates, so that all are wrapped
    for (int k = 0; k < 6; ++k) {
      shelves = joined(shelves, without_triangles(moved(plate, Eigen::Matrix3d::Identity(), Point(0, 0.2 * k, 0)), 2));
    }
    check_that_it_stops(100, [&](const internal::Deadline& deadline) {
      const internal::Repaired_part repaired = internal::repair_part(shelves, deadline);
      CHECK(repaired.repair == Abstraction_report::Repair::WRAP);
    });
  }
  SECTION("filling holes")
  {
    const int n = 40, period = 10, window = 4;
    Part_mesh mesh = torus_like(n, n, [](double u, double v) {
      const double r = 1 + 0.4 * std::cos(v);
      return Point(r * std::cos(u), 0.4 * std::sin(v), r * std::sin(u));
    });
    Eigen::Index kept = 0;
    for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
      if (t / 2 / n % period >= window || t / 2 % n % period >= window) {
        mesh.triangles.col(kept++) = mesh.triangles.col(t).eval();
      }
    }
    mesh.triangles.conservativeResize(3, kept);
    check_that_it_stops(16, [&](const internal::Deadline& deadline) {
      const internal::Repaired_part repaired = internal::repair_part(mesh, deadline);
      CHECK(repaired.repair == Abstraction_report::Repair::HOLES);
    });
  }
  SECTION("remeshing")
  {
    check_that_it_stops(50, [&](const internal::Deadline& deadline) { internal::remeshed(solid, 0.1, deadline); });
  }
  SECTION("the flow")
  {
    check_that_it_stops(9, [&](const internal::Deadline& deadline) {
      internal::Stepwise_flow flow(solid, 300, deadline);
      flow.run_to_convergence();
    });
  }
}

TEST_CASE("The number of control points is an option")
{
  Abstraction_options options;
  options.curve_points = 5;
  options.sheet_points = 3;
  CHECK(abstract_part({"leg", leg}, options).control_points().cols() == 5);
  CHECK(abstract_part({"plate", plate}, options).control_points().cols() == 9);
}

TEST_CASE("A hole is filled alike whatever is on the heap")
{
  const internal::Deadline deadline(1e9);
  for (int corners = 17; corners < 30; ++corners) {
    const Part_mesh mesh = cup(corners);
    Heap_churn churn;
    const internal::Repaired_part first = internal::repair_part(mesh, deadline);
    REQUIRE(first.repair == Abstraction_report::Repair::HOLES);
    for (int round = 0; round < 20; ++round) {
      churn.turn_over(round, 2000);
      const internal::Repaired_part again = internal::repair_part(mesh, deadline);
      CHECK(again.mesh.points == first.mesh.points);
      CHECK(again.mesh.triangles == first.mesh.triangles);
    }
  }
}

TEST_CASE("The same part gives the same bits whatever is on the heap")
{
  // A shape for which another order of edge collapses gives another skeleton.
  const Part_mesh mesh = joined(torus(1, 0.25), box({0.9, -0.1, -0.1}, {2.4, 0.1, 0.1}));
  const Part_abstraction first = abstraction_of(mesh);
  Heap_churn churn;
  for (int round = 0; round < 3; ++round) {
    churn.turn_over(round);
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

TEST_CASE("Volumes of convex hulls, which are 0 for flat, collinear and empty sets of points")
{
  CHECK(convex_hull_volume(leg.points) == Approx(0.01));
  CHECK(convex_hull_volume(leg.points.leftCols(4)) == 0);
  CHECK(convex_hull_volume(leg.points.leftCols(2)) == 0);
  CHECK(convex_hull_volume(Points(3, 0)) == 0);
}

TEST_CASE("Hulls of large polygons are found in nearly linear time, also where all corners are exactly in two planes")
{
  constexpr int sides = 10000;
  Points prism(3, 2 * sides);
  for (int i = 0; i < 2 * sides; ++i) {
    const double angle = 2 * EIGEN_PI * (i / 2) / sides;
    prism.col(i) << std::cos(angle), i % 2, std::sin(angle);
  }
  CGAL::Timer timer;
  timer.start();
  CHECK(convex_hull_volume(prism) == Approx(EIGEN_PI));
  CHECK(timer.time() < 20);    // processor time in seconds; a quadratic algorithm takes minutes
  Points grid(3, 2 * 51 * 51); // points of a box, only the corners of which are on its hull
  for (int i = 0; i < grid.cols(); ++i)
    grid.col(i) << i / 2 % 51, i % 2, i / 102;
  CHECK(internal::convex_hull(grid).vertices.cols() == 8);
  CHECK(convex_hull_volume(grid) == Approx(2500));
}

TEST_CASE("Abstraction by curves or sheets can be forced for all parts and for single parts")
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

TEST_CASE("A copy of a part that was replaced by its bounding box is reported, too")
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
    CHECK_FALSE(part.report.is_fallback()); // requested explicitly
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

TEST_CASE("A hole is filled whose corners coincide in the plane that it is projected to")
{
  // A hole in a damaged table, on which CGAL's planar filling crashes, depending on the first corner.
  Points hole(3, 4);
  hole << -.5, -.4, -.5, -.4, .7, 0, 0, 0, -.5, .4, .4, .5;
  const Point apex(-.45, .35, -2);
  for (int begin = 0; begin < 8; ++begin) {
    const bool backwards = begin >= 4;
    Part_mesh cone{Points(3, 5), Eigen::Matrix3Xi(3, 4)};
    for (int i = 0; i < 4; ++i) {
      const int next = (i + 1) % 4;
      cone.points.col(i) = hole.col((i + begin) % 4);
      cone.triangles.col(i) << (backwards ? i : next), (backwards ? next : i), 4;
    }
    cone.points.col(4) = apex;
    const internal::Deadline deadline(1e9);
    CHECK_NOTHROW(internal::repair_part(cone, deadline));
  }
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
