#include "abstraction/medial_poles.h"
#include "part_meshes.h"

#include <catch2/catch.hpp>

// Medial balls, which touch a surface from inside.

using namespace part_meshes;

namespace {

Part_mesh ring()
{
  Part_mesh result = torus(1, 0.3);
  result.triangles.row(1).swap(result.triangles.row(2));
  return result;
}

} // namespace

TEST_CASE("The poles of a ring are on the circle in its middle")
{
  const double thickness = 0.3;
  const Points poles = internal::medial_poles(ring());
  for (const auto& pole : poles.colwise()) {
    REQUIRE(std::abs(std::hypot(pole.x(), pole.z()) - 1) < 0.1 * thickness);
    REQUIRE(std::abs(pole.y()) < 0.1 * thickness);
  }
}

TEST_CASE("A pole does not depend on the vertex that its ball is expected to touch")
{
  const Part_mesh mesh = ring();
  const Points normals = internal::vertex_normals(mesh);
  const internal::Nearest_points vertices(mesh.points);
  const double largest = 2.6;
  for (Eigen::Index v = 0; v < mesh.points.cols(); v += 7) {
    const internal::Medial_pole pole = internal::medial_pole(vertices, mesh.points, v, normals.col(v), largest, -1);
    REQUIRE(pole.touched >= 0);
    for (Eigen::Index likely = 0; likely < mesh.points.cols(); likely += 11) {
      const internal::Medial_pole other =
          internal::medial_pole(vertices, mesh.points, v, normals.col(v), largest, likely);
      REQUIRE((other.centre - pole.centre).norm() < 1e-5);
    }
  }
}

TEST_CASE("Every vertex of a ring but the first has an earlier neighbour")
{
  const Part_mesh mesh = ring();
  const std::vector<Eigen::Index> earlier = internal::earlier_neighbours(mesh);
  CHECK(earlier[0] == -1);
  for (std::size_t v = 1; v < earlier.size(); ++v) {
    REQUIRE(earlier[v] >= 0);
    REQUIRE(earlier[v] < Eigen::Index(v));
  }
}
