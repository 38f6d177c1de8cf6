#include "abstraction/repair.h"
#include "abstraction/reproducible_flow.h"
#include "abstraction/skeletonize.h"
#include "part_meshes.h"

#include <CGAL/boost/graph/helpers.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

// CGAL's mean curvature flow as an abstractor.

using namespace part_meshes;
using Method = Abstraction_report::Method;

namespace {

Part_abstraction flow_abstraction_of(const Part_mesh& mesh, Abstraction_kind kind = Abstraction_kind::AUTOMATIC)
{
  Abstraction_options options;
  options.abstractor = Mean_curvature_abstraction();
  options.kind = kind;
  return abstract_part({"part", mesh}, options);
}

/// The points of a skeleton in lexicographic order.
std::vector<std::vector<double>> sorted(const Points& points)
{
  std::vector<std::vector<double>> result;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    result.push_back({points(0, i), points(1, i), points(2, i)});
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace

TEST_CASE("The flow step by step gives the skeleton of CGAL's contraction at once")
{
  const internal::Deadline deadline(1e9);
  const Part_mesh solid = internal::remeshed(torus(1, 0.2), 0.1, deadline);
  internal::Flow flow(internal::to_halfedge_mesh(solid));
  internal::Flow::Skeleton expected;
  flow(expected);
  Points expected_points(3, static_cast<Eigen::Index>(num_vertices(expected)));
  for (std::size_t v = 0; v < num_vertices(expected); ++v) {
    expected_points.col(static_cast<Eigen::Index>(v)) = internal::to_point(expected[v].point);
  }

  internal::Stepwise_flow stepwise(solid, 300, deadline);
  stepwise.run_to_volume(0.02);
  const Part_mesh meso_skeleton = stepwise.meso_skeleton();
  CHECK(meso_skeleton.triangles.cols() > 0);
  CHECK(stepwise.area_kept() < 0.5);
  stepwise.run_to_convergence();
  CHECK(sorted(stepwise.curve_skeleton().points) == sorted(expected_points));
}

TEST_CASE("The converged skeleton of a leg is a curve, which the flow has shortened")
{
  const Part_abstraction part = flow_abstraction_of(leg);
  REQUIRE_FALSE(part.is_sheet());
  CHECK(part.report.method == Method::SKELETON);
  CHECK(part.report.iterations > 0);
  CHECK_FALSE(part.report.is_fallback());
  const Points& points = part.control_points();
  REQUIRE(points.cols() == 16);
  CHECK((points.row(0).array() - 0.05).abs().maxCoeff() < 0.01);
  CHECK((points.row(2).array() - 0.05).abs().maxCoeff() < 0.01);
  const double length = points.row(1).maxCoeff() - points.row(1).minCoeff();
  CHECK(length > 0.85);
  CHECK(length < 0.99);
  CHECK(part.volume == Approx(0.01));
}

TEST_CASE("A plate becomes a sheet on the meso-skeleton")
{
  const Part_abstraction part = flow_abstraction_of(plate);
  REQUIRE(part.is_sheet());
  CHECK(part.report.method == Method::MESO_SKELETON);
  CHECK(part.report.residual < 0.01);
  const Points& points = part.control_points();
  REQUIRE(points.cols() == 64);
  CHECK((points.row(1).array() - 0.03).abs().maxCoeff() < 0.01);
  // The flow shrinks a surface at its rims, so the sheet is smaller than the plate
  const double length = points.row(0).maxCoeff() - points.row(0).minCoeff();
  const double width = points.row(2).maxCoeff() - points.row(2).minCoeff();
  CHECK(length > 0.7);
  CHECK(length < 0.95);
  CHECK(width > 0.5);
  CHECK(width < 0.76);
}

TEST_CASE("A narrow plate becomes a sheet, a rod of the same length does not; a wheel becomes its axle")
{
  const Part_mesh slat = box({0, 0, 0}, {1, 0.18, 0.02});
  CHECK(flow_abstraction_of(slat).is_sheet());
  CHECK_FALSE(flow_abstraction_of(box({0, 0, 0}, {1, 0.18, 0.15})).is_sheet());

  const Part_mesh wheel = turned({{0, 0}, {0.5, 0}, {0.5, 0.44}, {0, 0.44}});
  const Part_abstraction axle = flow_abstraction_of(wheel);
  REQUIRE_FALSE(axle.is_sheet());
  CHECK(axle.report.method == Method::AXIS);
  const Points& points = axle.control_points();
  const Point extent = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).eval();
  CHECK(extent.maxCoeff() == Approx(0.44).margin(1e-6));
  CHECK(extent.sum() == Approx(0.44).margin(1e-6)); // along one axis
}

TEST_CASE("A ring becomes a closed curve, a cube a blob")
{
  const Part_abstraction ring = flow_abstraction_of(torus(1, 0.1));
  REQUIRE(ring.is_closed_curve());
  CHECK(ring.report.method == Method::SKELETON);
  CHECK((sample(ring, 200).colwise().norm().array() - 1).abs().maxCoeff() < 0.05);

  const Part_abstraction cube = flow_abstraction_of(box({0, 0, 0}, {1, 1, 1}));
  CHECK_FALSE(cube.is_sheet());
  CHECK(cube.report.blob);
  CHECK(cube.report.method == Method::AXIS);
}

TEST_CASE("Kinds can be forced on the flow, and its limits lead to the bounding box")
{
  CHECK(flow_abstraction_of(leg, Abstraction_kind::SHEET).report.method == Method::MESO_SKELETON);
  CHECK(flow_abstraction_of(plate, Abstraction_kind::CURVE).report.method == Method::SKELETON);
  Abstraction_options options;
  options.abstractor = Mean_curvature_abstraction();
  options.maximum_iterations = 0;
  const Part_abstraction part = abstract_part({"leg", leg}, options);
  CHECK(part.report.method == Method::BOUNDING_BOX);
  CHECK(part.report.fallback == "the flow needs more iterations than allowed");
}

TEST_CASE("The flow gives the same bits again")
{
  const Part_mesh mesh = joined(torus(1, 0.25), box({0.9, -0.1, -0.1}, {2.4, 0.1, 0.1}));
  const Part_abstraction first = flow_abstraction_of(mesh);
  std::vector<std::string> churn; // changes the addresses of later allocations
  for (std::size_t k = 0; k < 5000; ++k) {
    churn.emplace_back(16 + k * 7919 % 400, 'x');
  }
  CHECK(flow_abstraction_of(mesh).control_points() == first.control_points());
}
