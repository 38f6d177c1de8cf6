// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"
#include "model_files.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_formats.h>

#include <boost/property_tree/xml_parser.hpp>

#include <catch2/catch.hpp>

#include <map>
#include <sstream>

using namespace CGAL::Shape_correspondence;
using Catch::Matchers::Contains;

namespace {

std::string curve_node(const std::string& id, const std::string& points)
{
  return "<node><id>" + id + "</id><type>CURVE</type>" + points + "</node>\n";
}

std::string point(double x, double y, double z)
{
  std::ostringstream out;
  out << "<point>" << x << ' ' << y << ' ' << z << "</point>";
  return out.str();
}

std::string leg(const std::string& id, double x, double y)
{
  return curve_node(id, point(x, y, 0) + point(x, y, 0.3) + point(x, y, 0.6) + point(x, y, 0.9));
}

/// A table, z up: a bilinear top and four legs.
std::string table_xml(const std::string& more = "")
{
  std::string top = "<node><id>top</id><type>Sheet</type><mesh>meshes/top.obj</mesh>"
                    "<controls><c>2</c><c>3</c></controls>";
  for (const double x : {-1.0, 1.0})
    for (const double y : {-0.5, 0.0, 0.5})
      top += point(x, y, 0.9);
  top += "<weights>1 1 1 1 1 1 </weights></node>\n";
  const std::string edge = "<edge><id>e</id><type>POINT_EDGE</type><n>top</n><n>a</n>"
                           "<coord><uv>1 1 0 0</uv></coord><coord><uv>1 0 0 0</uv></coord></edge>\n";
  return "<?xml version=\"1.0\"?>\n<document>\n" + top + leg("a", 1, 0.5) + leg("b", -1, 0.5) + leg("c", 1, -0.5) +
         leg("d", -1, -0.5) + edge + "<edge><n>top</n><n>b</n></edge><edge><n>top</n><n>c</n></edge>" +
         "<edge><n>top</n><n>d</n></edge>\n" + more + "</document>\n";
}

Structural_graph read(const std::string& text)
{
  std::istringstream in(text);
  return IO::read_structural_graph_xml(in, "table.xml");
}

std::string complaint_of(const std::string& text)
{
  return model_files::complaint([&] { read(text); });
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  return text.replace(text.find(from), from.size(), to);
}

} // namespace

TEST_CASE("A structure graph in XML is read")
{
  const Structural_graph graph = read(table_xml());
  CHECK(is_valid_structural_graph(graph, true));
  const Shape_structure& shape = structure(graph);
  REQUIRE(shape.parts.size() == 5);
  CHECK(shape.parts[0].name == "top");
  CHECK(shape.parts[0].is_sheet());
  CHECK((std::get<Sheet>(shape.parts[0].geometry)(0.5, 0.5) - Point(0, 0, 0.9)).norm() < 1e-12);
  CHECK((std::get<Curve>(shape.parts[1].geometry)(0.5) - Point(1, 0.5, 0.45)).norm() < 1e-12);
  CHECK(shape.frame.axes.col(1).isApprox(Point::UnitZ()));
  REQUIRE(shape.contacts.size() == 4);
  CHECK(shape.contacts[0].parameters[0].isApprox(Eigen::Vector2d(1, 1)));
  CHECK(shape.contacts[0].parameters[1].x() == Approx(1));
  CHECK(shape.contacts[1].parameters[1].x() == Approx(1)); // where they are nearest
  CHECK(num_vertices(graph) == 2);                         // the legs are found to be one group
}

TEST_CASE("Edges between the same nodes are one contact with the places of all, in either order")
{
  const std::string edge = "<edge><n>a</n><n>top</n><coord><uv>0.25 0 0 0</uv><uv>0.5 0 0 0</uv></coord>"
                           "<coord><uv>0 0 0 0</uv><uv>0 1 0 0</uv></coord></edge>";
  const Structural_graph graph = read(table_xml(edge + "<edge><n>top</n><n>b</n></edge>"));
  const std::vector<Contact>& contacts = structure(graph).contacts;
  REQUIRE(contacts.size() == 4);
  REQUIRE(contacts[0].further.size() == 2);
  CHECK(contacts[0].further[0][0].isApprox(Eigen::Vector2d(0, 0))); // on the top
  CHECK(contacts[0].further[0][1].x() == Approx(0.25));             // along the leg
  CHECK(contacts[0].further[1][0].isApprox(Eigen::Vector2d(0, 1)));
  CHECK(contacts[0].further[1][1].x() == Approx(0.5));
  CHECK(contacts[1].further.size() == 1);
}

TEST_CASE("Given groups are kept, and their symmetry is found")
{
  const Structural_graph graph = read(table_xml("<group><n>a</n><n>b</n></group><group><n>c</n><n>d</n></group>"));
  REQUIRE(num_vertices(graph) == 3);
  CHECK(graph[0].parts == std::vector<std::size_t>{1, 2});
  CHECK(graph[0].symmetry.type == Symmetry_type::REFLECTION);
  CHECK(std::abs(graph[0].symmetry.direction.x()) == Approx(1));
}

TEST_CASE("Curves are cubic B-splines with clamped knots")
{
  // Four control points are a Bézier curve: its middle is (p + 3 q + 3 r + s) / 8
  const std::string bent = point(0, 0, 0) + point(0, 0, 8) + point(8, 0, 8) + point(8, 0, 0);
  std::string text = table_xml();
  text = replaced(text, "</document>", curve_node("bow", bent) + "<edge><n>bow</n><n>a</n></edge></document>");
  const Structural_graph graph = read(text);
  const Curve& bow = std::get<Curve>(structure(graph).parts[5].geometry);
  CHECK((bow.points.col(0) - Point(0, 0, 0)).norm() < 1e-12);
  CHECK((bow.points.col(16) - Point(4, 0, 6)).norm() < 1e-12);
  CHECK((bow.points.col(32) - Point(8, 0, 0)).norm() < 1e-12);
}

TEST_CASE("What is wrong with an XML document is said")
{
  const std::string good = table_xml();
  CHECK(complaint_of(good).empty());
  CHECK_THAT(complaint_of("no XML"), Contains("table.xml"));
  CHECK_THAT(complaint_of("<other/>"), Contains("<document>"));
  CHECK_THAT(complaint_of("<document/>"), Contains("fewer than two"));
  CHECK_THAT(complaint_of(replaced(good, "<id>a</id>", "")), Contains("node 2") && Contains("<id>"));
  CHECK_THAT(complaint_of(replaced(good, "<id>b</id>", "<id>a</id>")), Contains("node 3") && Contains("earlier"));
  CHECK_THAT(complaint_of(replaced(good, "Sheet", "Blob")), Contains("BLOB"));
  CHECK_THAT(complaint_of(replaced(good, "<c>3</c>", "<c>4</c>")), Contains("2 x 4"));
  CHECK_THAT(complaint_of(replaced(good, "<c>3</c>", "<c>x</c>")), Contains("numbers"));
  CHECK_THAT(complaint_of(replaced(good, "<point>1 0.5 0</point>", "<point>1 0.5</point>")), Contains("three numbers"));
  CHECK_THAT(complaint_of(replaced(good, "1 1 1 1 1 1", "1 1")), Contains("weights"));
  CHECK_THAT(complaint_of(replaced(good, "<n>a</n>", "<n>x</n>")), Contains("edge 1") && Contains("'x'"));
  CHECK_THAT(complaint_of(replaced(good, "<n>a</n>", "")), Contains("join two"));
  CHECK_THAT(complaint_of(table_xml("<group></group>")), Contains("group 1"));
  CHECK_THAT(complaint_of(table_xml("<group><n>a</n></group><group><n>a</n></group>")), Contains("already"));
}

TEST_CASE("GraphML and DOT name the groups and count the contacts")
{
  const Structural_graph graph = read(table_xml());
  std::ostringstream graphml, dot;
  IO::write_structural_graph_graphml(graphml, graph);
  IO::write_structural_graph_dot(dot, graph);
  CHECK_THAT(dot.str(), Contains("graph G {") && Contains("c, d, a, b") && Contains("contacts=4") && Contains("--"));

  std::istringstream in(graphml.str());
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(in, tree);
  std::map<std::string, int> count;
  for (const auto& child : tree.get_child("graphml.graph"))
    ++count[child.first];
  CHECK(count["node"] == 2);
  CHECK(count["edge"] == 1);
  CHECK_THAT(graphml.str(), Contains("reflection") && Contains("c, d, a, b"));
}
