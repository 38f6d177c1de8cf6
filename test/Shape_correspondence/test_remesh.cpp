#include "abstraction/Closed_triangulation.h"
#include "abstraction/curve_and_sheet_geometry.h"
#include "abstraction/repair.h"
#include "abstraction/surface_samples.h"
#include "part_meshes.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <vector>

// Splitting and collapsing edges, and the remeshing built on them.

using namespace part_meshes;

namespace {

/// Whether opposite halfedges have each other as opposites, and the halfedges around every vertex form a cycle.
bool is_consistent(const internal::Closed_triangulation& mesh)
{
  for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
    if (mesh.is_removed(h)) {
      continue;
    }
    const int o = mesh.opposite(h);
    if (mesh.is_removed(o) || mesh.opposite(o) != h || mesh.source(o) != mesh.target(h)) {
      return false;
    }
  }
  for (int v = 0; v < mesh.number_of_vertices(); ++v) {
    int around = 0;
    if (!mesh.is_removed_vertex(v) && (!mesh.for_each_out(v, [&](int h) {
          return mesh.source(h) == v && ++around <= mesh.degree(v);
        }) || around != mesh.degree(v))) {
      return false;
    }
  }
  return true;
}

Eigen::Index euler_characteristic(const Part_mesh& mesh) { return mesh.points.cols() - mesh.triangles.cols() / 2; }

double largest_distance_from_box(const Points& points, const Point& half)
{
  double result = 0;
  for (Eigen::Index v = 0; v < points.cols(); ++v) {
    const Point beyond = points.col(v).cwiseAbs() - half;
    result = std::max(result, std::abs(beyond.maxCoeff()));
  }
  return result;
}

} // namespace

TEST_CASE("Edges can be split and collapsed in any order")
{
  internal::Closed_triangulation mesh(leg);
  REQUIRE(is_consistent(mesh));
  std::mt19937 random(1);
  int splits = 0, collapses = 0;
  for (int step = 0; step < 5000; ++step) {
    const int h = static_cast<int>(random() % static_cast<unsigned>(mesh.number_of_halfedges()));
    if (mesh.is_removed(h)) {
      continue;
    }
    const unsigned choice = random() % 2;
    if (choice == 0 && splits < collapses + 40) {
      mesh.split(h);
      ++splits;
    } else if (choice == 1 && mesh.can_collapse(h)) {
      mesh.collapse(h);
      ++collapses;
    }
    REQUIRE(is_consistent(mesh));
  }
  CHECK(std::min(splits, collapses) > 100);
  CHECK(euler_characteristic(mesh.mesh()) == 2);
}

TEST_CASE("The smallest closed mesh cannot be made smaller")
{
  Part_mesh tetrahedron;
  tetrahedron.points = Points(3, 4);
  tetrahedron.points << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
  tetrahedron.triangles.resize(3, 4);
  tetrahedron.triangles << 0, 0, 0, 1, 2, 1, 3, 2, 1, 3, 2, 3;
  const internal::Closed_triangulation mesh(tetrahedron);
  REQUIRE(is_consistent(mesh));
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    CHECK_FALSE(mesh.can_collapse(h));
}

TEST_CASE("A remeshed box keeps its faces, its edges and its volume")
{
  const Point half(1, 0.25, 0.1);
  const double length = 0.1;
  const Part_mesh solid = box(-half, half);
  const Part_mesh mesh = internal::remeshed(solid, length, internal::Deadline(1e9));
  CHECK(euler_characteristic(mesh) == 2);
  CHECK(largest_distance_from_box(mesh.points, half) < 1e-9);
  CHECK(internal::surface_area(mesh) == Approx(internal::surface_area(solid)).epsilon(0.1));
  CHECK((mesh.points.rowwise().maxCoeff() - half).cwiseAbs().maxCoeff() < 0.02);
  std::vector<double> lengths;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    for (int k = 0; k < 3; ++k) {
      lengths.push_back(
          (mesh.points.col(mesh.triangles(k, t)) - mesh.points.col(mesh.triangles((k + 1) % 3, t))).norm());
    }
  }
  std::sort(lengths.begin(), lengths.end());
  CHECK(lengths[lengths.size() / 2] == Approx(length).epsilon(0.25));
  CHECK(lengths.back() < 2 * length);
}

TEST_CASE("Remeshing keeps a handle and is the same in every run")
{
  const Part_mesh mesh = internal::remeshed(torus(1, 0.2), 0.1, internal::Deadline(1e9));
  CHECK(euler_characteristic(mesh) == 0);
  CHECK(mesh.points == internal::remeshed(torus(1, 0.2), 0.1, internal::Deadline(1e9)).points);
}
