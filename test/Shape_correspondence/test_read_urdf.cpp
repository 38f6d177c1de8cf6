// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_files.h"
#include "program.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>

#include <Eigen/Geometry>

#include <catch2/catch.hpp>

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;

namespace {

std::string link_of(const std::string& name, const std::string& geometry, const std::string& origin = "",
                    const std::string& more = "")
{
  return "<link name=\"" + name + "\"><collision><geometry><box size=\"9 9 9\"/></geometry></collision><visual>" +
         origin + "<geometry>" + geometry + "</geometry>" + more + "</visual></link>\n";
}

std::string joint(const std::string& parent, const std::string& child, const std::string& origin)
{
  return "<joint name=\"to_" + child + "\" type=\"revolute\"><parent link=\"" + parent + "\"/><child link=\"" + child +
         "\"/>" + origin + "</joint>\n";
}

std::string robot(const std::string& elements)
{
  return "<?xml version=\"1.0\"?><robot name=\"r\">" + elements + "</robot>";
}

const std::string box = "<box size=\"2 4 6\"/>";

std::pair<Point, Point> extent(const Segmented_shape& shape, std::size_t part)
{
  const Points& points = shape.parts().at(part).mesh.points;
  return {points.rowwise().minCoeff(), points.rowwise().maxCoeff()};
}

std::string refused(const std::string& elements)
{
  const Temporary_folder folder;
  const std::string file = folder.write("r.urdf", robot(elements));
  const std::string message = complaint([&] { IO::read_segmented_shape(file); });
  CHECK_THAT(message, Contains("r.urdf"));
  return message;
}

} // namespace

TEST_CASE("The links of a robot are parts, where its joints put them, with z up")
{
  const Temporary_folder folder;
  const std::string file = folder.write(
      "r.urdf", robot(joint("base", "arm", "<origin xyz=\"10 0 0\" rpy=\"0 0 1.5707963267948966\"/>") +
                      joint("arm", "hand", "<origin xyz=\"5 0 0\"/>") + link_of("base", box) +
                      "<link name=\"empty\"/>" + joint("base", "empty", "") +
                      link_of("arm", box, "<origin xyz=\"0 0 1\"/>") + link_of("hand", "<sphere radius=\"1\"/>") +
                      joint("hand", "tip", "<origin rpy=\"1.5707963267948966 0 0\"/>") +
                      link_of("tip", "<cylinder radius=\"1\" length=\"8\"/>")));
  const Segmented_shape shape = IO::read_segmented_shape(file);
  CHECK(shape.up() == Point::UnitZ());
  REQUIRE(shape.parts().size() == 4);
  CHECK(shape.parts()[0].name == "base");
  CHECK(extent(shape, 0).first.isApprox(Point(-1, -2, -3)));
  CHECK(extent(shape, 0).second.isApprox(Point(1, 2, 3)));
  CHECK(extent(shape, 1).first.isApprox(Point(8, -1, -2))); // the joint maps x to y
  CHECK(extent(shape, 1).second.isApprox(Point(12, 1, 4)));
  CHECK((extent(shape, 2).first + extent(shape, 2).second).isApprox(2 * Point(10, 5, 0)));
  CHECK((extent(shape, 3).second - extent(shape, 3).first).isApprox(Point(8, 2, 2), 1e-2));
  for (const Shape_part& part : shape.parts()) { // faces are oriented outwards
    double volume = 0;
    for (const auto& t : part.mesh.triangles.colwise())
      volume += part.mesh.points.col(t[0]).dot(part.mesh.points.col(t[1]).cross(part.mesh.points.col(t[2])));
    CHECK(volume > 0);
  }
  CHECK_THAT(run("parts " + quoted(file)).out, Contains("4 parts; z up"));
}

TEST_CASE("Visuals of a link are one part, of meshes that many links may use, with their colours")
{
  const Temporary_folder folder;
  folder.write("meshes/cube.obj", obj_box("o cube", 0, 0, 0, 0, 1, 1, 1));
  const std::string mesh = "<mesh filename=\"package://any/meshes/cube.obj\" scale=\"2 1 1\"/>";
  const std::string two =
      "<link name=\"base\"><visual><geometry>" + mesh + "</geometry><material name=\"red\"/></visual>" +
      "<visual><origin xyz=\"9 0 0\"/><geometry><mesh filename=\"meshes/cube.obj\"/></geometry></visual></link>";
  const std::string text = robot("<material name=\"red\"><color rgba=\"1 0 0 1\"/></material>" + two +
                                 joint("base", "arm", "<origin xyz=\"0 0 5\"/>") + link_of("arm", mesh));
  const std::string file = folder.write("r.urdf", text);
  Shape_appearance looks;
  const Segmented_shape shape = IO::read_shape_and_appearance(file, looks);
  REQUIRE(shape.parts().size() == 2);
  CHECK(shape.parts()[0].mesh.triangles.cols() == 24);
  CHECK(extent(shape, 0).second.isApprox(Point(10, 1, 1)));
  CHECK(extent(shape, 1).second.isApprox(Point(2, 1, 6)));
  const std::vector<int>& materials = looks.parts[0].materials;
  REQUIRE(materials.size() == 24);
  REQUIRE(materials[0] >= 0);
  CHECK(looks.materials[std::size_t(materials[0])].colour.isApprox(Eigen::Vector4d(1, 0, 0, 1)));
  CHECK(materials[12] == -1);
  CHECK(IO::read_segmented_shape(folder.path("")).parts().size() == 2);
  // Files in folders above are read only if allowed
  std::string packaged = text;
  const std::string plain = "\"meshes/";
  packaged.replace(packaged.find(plain), plain.size(), "\"model://any/meshes/");
  const std::string below = folder.write("robots/r.urdf", packaged);
  CHECK_THAT(complaint([&] { IO::read_segmented_shape(below); }),
             Contains("link 'base'") && Contains("cube.obj") && Contains("`Reading_options::allow_outside_files`"));
  folder.write("package/meshes/cube.obj", obj_box("o cube", 0, 0, 0, 0, 1, 1, 1));
  const std::string in_package = folder.write("package/urdf/r.urdf", packaged);
  CHECK_FALSE(complaint([&] { IO::read_segmented_shape(in_package); }).empty());
  CHECK(IO::read_segmented_shape(folder.path("package")).parts().size() == 2);
  CHECK_THAT(run("parts " + quoted(folder.path("package"))).out, Contains("2 parts; z up"));
  IO::Reading_options anywhere;
  anywhere.allow_outside_files = true;
  CHECK(IO::read_segmented_shape(below, Point::UnitY(), nullptr, anywhere).parts().size() == 2);
}

TEST_CASE("Errors in a URDF file are reported with their link and a remedy")
{
  CHECK_THAT(refused(""), Contains("no link") && Contains("add <visual>"));
  CHECK_THAT(refused(link_of("a", box) + link_of("a", box)), Contains("link 'a' is there twice"));
  CHECK_THAT(refused(link_of("a", box) + link_of("b", box)),
             Contains("link 'b' is not joined") && Contains("add a joint"));
  CHECK_THAT(refused(link_of("a", box) + joint("a", "b", "")),
             Contains("joint 'to_b' has the child 'b', which is no link"));
  CHECK_THAT(refused(link_of("a", box) + link_of("b", box) + joint("a", "b", "") + joint("b", "a", "")),
             Contains("in a circle"));
  CHECK_THAT(refused(link_of("a", box) + joint("a", "a", "")), Contains("in a circle"));
  CHECK_THAT(refused(link_of("a", box) + link_of("b", box) + joint("a", "b", "") + joint("a", "b", "")),
             Contains("link 'b' is the child of two joints"));
  CHECK_THAT(refused(link_of("a", "<box size=\"1 2\"/>")),
             Contains("link 'a' has a <box> with size='1 2'") && Contains("3 numbers"));
  CHECK_THAT(refused(link_of("a", "<box size=\"1 2 nan\"/>")), Contains("link 'a' has a <box> with size="));
  CHECK_THAT(refused(link_of("a", "<box size=\"${w} 2 3\"/>")), Contains("xacro"));
  CHECK_THAT(refused("<xacro:property name=\"w\" value=\"2\"/>" + link_of("a", box)), Contains("xacro"));
  const std::vector<std::pair<std::string, std::string>> incomplete{
      {"<cylinder length=\"1\"/>", "<cylinder> without radius; write radius="},
      {"<cylinder radius=\"1\"/>", "<cylinder> without length; write length="},
      {"<cylinder radius=\"-1\" length=\"1\"/>", "radius='-1', which has no surface; write lengths over 0"},
      {"<sphere/>", "<sphere> without radius; write radius="},
      {"<sphere radius=\"1 2\"/>", "radius='1 2', which is not a number"},
      {"<box/>", "<box> without size; write size="},
      {"<box size=\"0 1 1\"/>", "size='0 1 1', which has no surface"},
      {"<mesh/>", "<mesh> without filename; write filename="},
      {"<mesh filename=\"b.obj\" scale=\"0 1 1\"/>", "scale='0 1 1', which leaves no surface"},
      {"<box size=\"1 1 1\"/></geometry><origin xyz=\"1 2\"/><geometry>", "<origin> with xyz='1 2'"}};
  for (const auto& [geometry, message] : incomplete)
    CHECK_THAT(refused(link_of("a", box) + joint("a", "b", "") + link_of("b", geometry)),
               Contains("link 'b' has a ") && Contains(message) && !Contains("--allow"));
  CHECK_THAT(refused("<link/>"), Contains("a <link> has no name"));
  CHECK_THAT(refused(link_of("a", box) + "<visual/>"), Contains("<visual> is in no link"));
  CHECK_THAT(refused(link_of("a", "<capsule radius=\"1\"/>")),
             Contains("link 'a'") && Contains("replace it by a mesh"));
  CHECK_THAT(refused(link_of("a", "<mesh filename=\"none.stl\"/>")), Contains("link 'a' has the mesh 'none.stl'"));
  CHECK_THAT(refused(link_of("a", "<mesh filename=\"r.urdf\"/>")), Contains("of a format that is not read"));
  const Temporary_folder folder;
  CHECK_THAT(complaint([&] { IO::read_segmented_shape(folder.write("s.urdf", "<sdf/>")); }), Contains("no <robot>"));
  CHECK_THAT(complaint([&] { IO::read_segmented_shape(folder.write("s.urdf", "<robot>")); }), Contains("not an XML"));
  folder.write("bad.obj", "v 0 0 x\n");
  CHECK_THAT(complaint([&] {
               IO::read_segmented_shape(folder.write("t.urdf", robot(link_of("a", "<mesh filename=\"bad.obj\"/>"))));
             }),
             Contains("t.urdf: link 'a': ") && Contains("bad.obj, line 1"));
}

TEST_CASE("Meshes of robots keep their coordinates, whichever axis their file says is up")
{
  const Temporary_folder folder;
  const auto collada = [](const std::string& axis) {
    return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>)" +
           axis + R"(</up_axis></asset>
<library_geometries><geometry id="g" name="g"><mesh>
<source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 0 2 0 0 0 3</float_array><technique_common>
<accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n" name="n"><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
  };
  const std::string file = folder.write("r.urdf", robot(link_of("a", "<mesh filename=\"a.dae\"/>")));
  for (const char* axis : {"X_UP", "Y_UP", "Z_UP"}) {
    CAPTURE(axis);
    folder.write("a.dae", collada(axis));
    const Segmented_shape shape = IO::read_segmented_shape(file);
    CHECK(extent(shape, 0).first.isZero(1e-6));
    CHECK(extent(shape, 0).second.isApprox(Point(1, 2, 3), 1e-6));
  }
}
