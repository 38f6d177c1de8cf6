#include "part_meshes.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/parameters.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <boost/property_map/function_property_map.hpp>

#include <catch2/catch.hpp>

#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

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

TEST_CASE("Meshes that cannot be used are refused with the name of the part")
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
  mesh = part_meshes::bipyramid(10000);
  CHECK(message_of("fan", mesh) == "");
  mesh = part_meshes::bipyramid(10001);
  CHECK_THAT(message_of("fan", mesh),
             Catch::Contains("part 'fan': vertex 10001 has 10001 triangles, of at most 10000"));
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

TEST_CASE("Meshes become the parts of a shape")
{
  const auto shape = Segmented_shape::from_meshes(std::map<std::string, Mesh>{{"a", strip()}, {"b", strip()}}, "pair");
  REQUIRE(shape.parts().size() == 2);
  CHECK(shape.parts()[0].mesh.points.cols() == 6);
  CHECK(shape.parts()[0].mesh.triangles.cols() == 4);
}

TEST_CASE("The segments of a mesh, given by an id for each face, become the parts of a shape")
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

TEST_CASE("Segments are named by a range or a map")
{
  Mesh mesh = strip();
  auto ids = mesh.add_property_map<Mesh::Face_index, int>("f:segment", 1).first;
  ids[Mesh::Face_index(2)] = 0;
  const auto names = [](const Segmented_shape& shape) {
    return std::pair(shape.parts()[0].name, shape.parts()[1].name);
  };
  const std::pair<std::string, std::string> expected("seat", "leg");

  const auto range = parameters::part_names(std::vector<std::string>{"seat", "leg"});
  CHECK(names(Segmented_shape::from_segmentation(mesh, ids, range)) == expected);
  const auto map = parameters::part_names(std::map<int, std::string>{{0, "seat"}, {1, "leg"}});
  const Segmented_shape shape = Segmented_shape::from_segmentation(mesh, ids, "stool", Point::UnitZ(), map);
  CHECK(names(shape) == expected);
  CHECK(shape.name() == "stool");
  CHECK(shape.up() == Point::UnitZ());

  const auto too_few = parameters::part_names(std::vector<std::string>{"seat"});
  CHECK_THROWS_WITH(Segmented_shape::from_segmentation(mesh, ids, too_few), Catch::Contains("segment 1"));
}

TEST_CASE("Points are those of the vertex point map")
{
  Mesh mesh = strip();
  const auto ids = mesh.add_property_map<Mesh::Face_index, int>("f:segment", 0).first;
  const auto moved = mesh.add_property_map<Mesh::Vertex_index, Mesh::Point>("v:moved").first;
  for (auto v : mesh.vertices())
    moved[v] = mesh.point(v) + Mesh::Point::R::Vector_3(0, 0, 5);
  const auto vertex_points = CGAL::parameters::vertex_point_map(moved);

  const auto height = [](const Segmented_shape& shape) { return shape.parts()[0].mesh.points.row(2).minCoeff(); };
  CHECK(height(Segmented_shape::from_segmentation(mesh, ids, vertex_points)) == 5);
  const std::vector<std::string> names{"all"};
  const auto both = parameters::part_names(names).vertex_point_map(moved);
  const Segmented_shape named = Segmented_shape::from_segmentation(mesh, ids, both);
  CHECK(height(named) == 5);
  CHECK(named.parts()[0].name == "all");

  // Parts that are views of one mesh share its point map
  using View = CGAL::Face_filtered_graph<Mesh>;
  const std::map<std::string, View> views{{"view", View(mesh, 0, ids)}};
  CHECK(height(Segmented_shape::from_meshes(views, "views", Point::UnitY(), vertex_points)) == 5);
  Segmented_shape shape;
  shape.add_mesh("part", mesh, vertex_points);
  CHECK(height(shape) == 5);
}

TEST_CASE("Any face graph and any kernel will do")
{
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Polyhedron = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
  const Mesh mesh = strip();
  Polyhedron polyhedron;
  CGAL::copy_face_graph(mesh, polyhedron);
  using Face = boost::graph_traits<Polyhedron>::face_descriptor;
  const auto sides = boost::make_function_property_map<Face>([](Face face) { return face->is_triangle() ? 0 : 1; });
  const Segmented_shape shape = Segmented_shape::from_segmentation(polyhedron, sides);
  REQUIRE(shape.parts().size() == 2);
  CHECK(shape.parts()[0].mesh.triangles.cols() == 2);
  CHECK(shape.parts()[1].mesh.points.cols() == 4);
}

TEST_CASE("A mesh without faces is no shape")
{
  Mesh mesh;
  const auto ids = mesh.add_property_map<Mesh::Face_index, int>("f:segment", 0).first;
  CHECK_THROWS_WITH(Segmented_shape::from_segmentation(mesh, ids, "void"), Catch::Contains("'void'"));
}
