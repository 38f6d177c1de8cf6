#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <limits>
#include <map>

using namespace CGAL::Shape_correspondence;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

namespace {

Part_mesh one_triangle()
{
  Part_mesh mesh;
  mesh.points.resize(3, 3);
  mesh.points << 0, 1, 0, 0, 0, 1, 0, 0, 0;
  mesh.triangles.resize(3, 1);
  mesh.triangles << 0, 1, 2;
  return mesh;
}

/// Two triangles and a quadrilateral in a row.
Mesh strip()
{
  using P = Mesh::Point;
  Mesh mesh;
  const auto a = mesh.add_vertex(P(0, 0, 0)), b = mesh.add_vertex(P(1, 0, 0)), c = mesh.add_vertex(P(1, 1, 0)),
             d = mesh.add_vertex(P(0, 1, 0)), e = mesh.add_vertex(P(2, 0, 0)), f = mesh.add_vertex(P(2, 1, 0));
  mesh.add_face(a, b, c);
  mesh.add_face(a, c, d);
  mesh.add_face(b, e, f, c);
  return mesh;
}

std::string message_of(const std::string& name, const Part_mesh& mesh)
{
  Segmented_shape shape;
  try {
    shape.add_part(name, mesh);
  } catch (const Invalid_input& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("Parts are kept in their order")
{
  Segmented_shape shape("chair", Point(0, 0, 2));
  shape.add_part("seat", one_triangle());
  shape.add_part("leg", one_triangle());
  CHECK(shape.name() == "chair");
  CHECK(shape.up() == Point(0, 0, 1));
  REQUIRE(shape.parts().size() == 2);
  CHECK(shape.parts()[1].name == "leg");
  CHECK(shape.parts()[1].mesh.points == one_triangle().points);
}

TEST_CASE("What cannot be used is refused by name")
{
  CHECK(message_of("leg", one_triangle()) == "");
  Part_mesh mesh = one_triangle();
  mesh.points(1, 2) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(message_of("leg", mesh), Catch::Contains("part 'leg'") && Catch::Contains("vertex 2"));
  mesh.points(1, 2) = std::numeric_limits<double>::infinity();
  CHECK_THAT(message_of("leg", mesh), Catch::Contains("finite"));
  mesh = one_triangle();
  mesh.triangles(2, 0) = 3;
  CHECK_THAT(message_of("leg", mesh), Catch::Contains("triangle 0 refers to vertex 3 of 3"));
  mesh.triangles(2, 0) = -1;
  CHECK_THAT(message_of("leg", mesh), Catch::Contains("vertex -1"));
  mesh = one_triangle();
  mesh.triangles.resize(3, 0);
  CHECK_THAT(message_of("leg", mesh), Catch::Contains("no triangles"));
  mesh = one_triangle();
  mesh.points.col(2) << 2, 0, 0;
  CHECK_THAT(message_of("leg", mesh), Catch::Contains("zero area"));
  CHECK_THAT(message_of("", one_triangle()), Catch::Contains("name is empty"));
  CHECK_THROWS_AS(Segmented_shape("chair", Point::Zero()), Invalid_input);
}

TEST_CASE("A name cannot be given twice")
{
  Segmented_shape shape;
  shape.add_part("leg", one_triangle());
  CHECK_THROWS_AS(shape.add_part("leg", one_triangle()), Invalid_input);
  CHECK(shape.parts().size() == 1);
}

TEST_CASE("A part may be tiny or far away")
{
  Part_mesh mesh = one_triangle();
  mesh.points *= 1e-9;
  CHECK(message_of("crumb", mesh) == "");
}

TEST_CASE("Shapes of meshes")
{
  const auto shape = Segmented_shape::from_meshes(std::map<std::string, Mesh>{{"a", strip()}, {"b", strip()}}, "pair");
  REQUIRE(shape.parts().size() == 2);
  CHECK(shape.parts()[0].mesh.points.cols() == 6);
  CHECK(shape.parts()[0].mesh.triangles.cols() == 4);
}

TEST_CASE("Shapes of a mesh with segment ids")
{
  Mesh mesh = strip();
  auto ids = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment", 7).first;
  ids[Mesh::Face_index(2)] = 3;
  const Segmented_shape shape = Segmented_shape::from_segmentation(mesh, ids, "strip");
  REQUIRE(shape.parts().size() == 2);
  CHECK(shape.parts()[0].name == "segment_3");
  CHECK(shape.parts()[0].mesh.points.cols() == 4);
  CHECK(shape.parts()[0].mesh.triangles.cols() == 2);
  CHECK(shape.parts()[1].name == "segment_7");
  CHECK(shape.parts()[1].mesh.points.row(0).maxCoeff() == 1);
}
