// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_files.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>

#include <Eigen/Geometry>

#include <catch2/catch.hpp>

#include <cmath>

using namespace CGAL::Shape_correspondence;
using namespace std::string_literals;
using namespace model_files;
using Catch::Matchers::Contains;

namespace {

std::vector<std::string> names(const Segmented_shape& shape)
{
  std::vector<std::string> result;
  for (const Shape_part& part : shape.parts())
    result.push_back(part.name);
  return result;
}

using Names = std::vector<std::string>;

double volume(const Part_mesh& mesh)
{
  double sum = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    sum += mesh.points.col(mesh.triangles(0, t))
               .dot(mesh.points.col(mesh.triangles(1, t)).cross(mesh.points.col(mesh.triangles(2, t))));
  return sum / 6;
}

std::string read_complaint(const std::string& path)
{
  return complaint([&] { IO::read_segmented_shape(path); });
}

const std::string off_box = "OFF\n8 6 0\n" + box_vertices(0, 0, 0, 1, 2, 3, "") + box_faces(0, "4 ");

std::string ply_box(const std::string& list = "property list uchar int vertex_indices")
{
  return "ply\nformat ascii 1.0\nelement vertex 8\nproperty double x\nproperty double y\nproperty double z\n"
         "element face 6\n" +
         list + "\nend_header\n" + box_vertices(0, 0, 0, 1, 2, 3, "") + box_faces(0, "4 ");
}

std::string stl_solid(const std::string& name, double x)
{
  std::ostringstream out;
  out << "solid " << name << "\n";
  const double p[4][3] = {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, {x, 0, 1}};
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  for (const auto& face : faces) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (int v : face)
      out << "vertex " << p[v][0] << ' ' << p[v][1] << ' ' << p[v][2] << '\n';
    out << "endloop\nendfacet\n";
  }
  out << "endsolid " << name << "\n";
  return out.str();
}

const std::string collada = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g" name="g"><mesh>
<source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array><technique_common>
<accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s">
<node id="low" name="low"><instance_geometry url="#g"/></node>
<node id="high" name="high"><translate>0 0 5</translate><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";

} // namespace

TEST_CASE("Objects and groups of an OBJ file are parts")
{
  const Temporary_folder folder;
  const Names expected{"top", "leg_1", "leg_2", "leg_3", "leg_4"};
  for (const char* keyword : {"o ", "g "}) {
    const Segmented_shape shape = IO::read_segmented_shape(folder.write("table.obj", obj_table(keyword)));
    CHECK(shape.name() == "table");
    CHECK(names(shape) == expected);
    for (const Shape_part& part : shape.parts()) {
      CHECK(part.mesh.points.cols() == 8);
      CHECK(part.mesh.triangles.cols() == 12);
    }
    CHECK(volume(shape.parts()[0].mesh) == Approx(0.05));
  }
}

TEST_CASE("Groups inside objects are parts, by both names where groups share one")
{
  const Temporary_folder folder;
  const std::string inside = obj_box("o chair\ng seat", 0, 0, 0, 0, 1, 1, 1) + obj_box("g back", 1, 0, 1, 0, 1, 1, 1);
  CHECK(names(IO::read_segmented_shape(folder.write("a.obj", inside))) == Names{"seat", "back"});
  const std::string shared = obj_box("o left\ng wood", 0, 0, 0, 0, 1, 1, 1) +
                             obj_box("o right\ng wood", 1, 2, 0, 0, 1, 1, 1) + obj_box("g top", 2, 0, 1, 0, 3, 1, 1);
  CHECK(names(IO::read_segmented_shape(folder.write("b.obj", shared))) == Names{"left/wood", "right/wood", "top"});
}

TEST_CASE("An OBJ file without objects is one part with the file's name")
{
  const Temporary_folder folder;
  CHECK(names(IO::read_segmented_shape(folder.write("leg.obj", obj_box("# no name", 0, 0, 0, 0, 1, 1, 1)))) ==
        Names{"leg"});
}

TEST_CASE("OBJ dialects: line ends, texture and normal indices, negative indices, names with blanks")
{
  const Temporary_folder folder;
  const std::string text = "mtllib a.mtl\r\no front leg \r\nv 0 0 0 1 0 0\r\nv +1 0 0\r\nv 0 1e0 0\r\nvt 0 0\r\n"
                           "usemtl wood\r\nf 1/1 2/1 \\\r\n3/1\r\nf -3//1 -2//1 -1//1 # again\r\n";
  const Segmented_shape shape = IO::read_segmented_shape(folder.write("a.OBJ", text));
  REQUIRE(names(shape) == Names{"front leg"});
  CHECK(shape.parts()[0].mesh.triangles.cols() == 2);
  CHECK(shape.parts()[0].mesh.points.col(2) == Point(0, 1, 0));
}

TEST_CASE("Coordinates keep double precision")
{
  const Temporary_folder folder;
  const double far = 123456.789012345;
  const std::string vertices = box_vertices(far, 0, 0, 1, 1, 1, "v ") + box_faces(1, "f ");
  CHECK(IO::read_segmented_shape(folder.write("a.obj", vertices)).parts()[0].mesh.points.row(0).minCoeff() == far);
  const std::string off = "OFF\n8 6 0\n" + box_vertices(far, 0, 0, 1, 1, 1, "") + box_faces(0, "4 ");
  CHECK(IO::read_segmented_shape(folder.write("a.off", off)).parts()[0].mesh.points.row(0).minCoeff() == far);
}

TEST_CASE("Concave faces are triangulated, vertices at the same place welded")
{
  const Temporary_folder folder;
  // An L-shape of area 3 from above and from below; the last vertex repeats the first
  const std::string text = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\n"
                           "f 1 2 3 4 5 6\nf 4 3 2 7 6 5\n";
  const Part_mesh mesh = IO::read_segmented_shape(folder.write("l.obj", text)).parts()[0].mesh;
  CHECK(mesh.points.cols() == 6);
  REQUIRE(mesh.triangles.cols() == 8);
  double area = 0, signed_area = 0;
  for (int t = 0; t < 8; ++t) {
    const Point a = mesh.points.col(mesh.triangles(0, t));
    const double z = (mesh.points.col(mesh.triangles(1, t)) - a).cross(mesh.points.col(mesh.triangles(2, t)) - a).z();
    area += std::abs(z) / 2;
    signed_area += z / 2;
  }
  CHECK(area == Approx(6));
  CHECK(signed_area == Approx(0).margin(1e-12));
}

TEST_CASE("OFF, PLY, STL and COLLADA are read with their parts, names and volumes")
{
  const Temporary_folder folder;
  for (const std::string& file : {folder.write("box.off", off_box), folder.write("box.ply", ply_box()),
                                  folder.write("other.ply", ply_box("property list uchar ushort vertex_indices"))}) {
    INFO(file);
    const Segmented_shape shape = IO::read_segmented_shape(file);
    REQUIRE(shape.parts().size() == 1);
    CHECK(shape.parts()[0].mesh.points.cols() == 8);
    CHECK(volume(shape.parts()[0].mesh) == Approx(6));
  }
  const Segmented_shape stl = IO::read_segmented_shape(folder.write("a.stl", stl_solid("a", 0) + stl_solid("b", 9)));
  CHECK(names(stl) == Names{"a", "b"});
  CHECK(stl.parts()[1].mesh.points.cols() == 4);
  const Segmented_shape dae = IO::read_segmented_shape(folder.write("a.dae", collada));
  REQUIRE(names(dae) == Names{"low", "high"});
  // The file has z up, and is rotated to y up
  CHECK(dae.parts()[1].mesh.points.row(1).minCoeff() == Approx(5));
  CHECK(dae.parts()[1].mesh.points.row(1).maxCoeff() == Approx(6));
}

TEST_CASE("COLLADA parts are named as their nodes, not by their identifiers")
{
  const Temporary_folder folder;
  std::string text = collada;
  text.replace(text.find("name=\"low\""), 10, "name=\"Seat of oak\"");
  CHECK(names(IO::read_segmented_shape(folder.write("a.dae", text))) == Names{"Seat of oak", "high"});
}

TEST_CASE("AC3D, DXF and glTF: nodes are parts, also two of one mesh, moved and mirrored")
{
  const Temporary_folder folder;
  const std::string surfaces =
      "numsurf 4\n"
      "SURF 0x0\nmat 0\nrefs 3\n0 0 0\n2 0 0\n1 0 0\nSURF 0x0\nmat 0\nrefs 3\n0 0 0\n1 0 0\n3 0 0\n"
      "SURF 0x0\nmat 0\nrefs 3\n0 0 0\n3 0 0\n2 0 0\nSURF 0x0\nmat 0\nrefs 3\n1 0 0\n2 0 0\n3 0 0\n";
  const auto object = [&](const std::string& name, const std::string& place) {
    return "OBJECT poly\nname \"" + name + "\"\n" + place + "numvert 4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n" + surfaces +
           "kids 0\n";
  };
  const Segmented_shape ac = IO::read_segmented_shape(
      folder.write("a.ac", "AC3Db\nMATERIAL \"m\" rgb 1 1 1 amb 1 1 1 emis 0 0 0 spec 0 0 0 shi 0 trans 0\n"
                           "OBJECT world\nkids 2\n" +
                               object("wing", "") + object("tail", "loc 5 0 0\n")));
  REQUIRE(names(ac) == Names{"wing", "tail"});
  CHECK(ac.parts()[1].mesh.points.row(0).minCoeff() == Approx(5));

  const auto face = [](const std::string& layer, double x) {
    std::ostringstream out;
    out << "0\n3DFACE\n8\n" << layer << "\n";
    const double corners[4][3] = {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, {x, 1, 0}};
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 3; ++i)
        out << 10 * (i + 1) + k << '\n' << corners[k][i] << '\n';
    return out.str();
  };
  CHECK_FALSE(IO::read_segmented_shape(folder.write("a.dxf", "0\nSECTION\n2\nENTITIES\n" + face("A", 0) + face("B", 3) +
                                                                 "0\nENDSEC\n0\nEOF\n"))
                  .parts()
                  .empty());

  // One triangle with positions (0,0,0), (1,0,0), (0,1,0) in base 64
  const Segmented_shape gltf = IO::read_segmented_shape(
      folder.write("a.gltf", R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
 "nodes": [{"name": "left", "mesh": 0}, {"name": "frame", "scale": [-1, 1, 1], "children": [2]}, {"name": "right", "mesh": 0}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}],
 "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})"));
  REQUIRE(names(gltf) == Names{"left", "right"});
  CHECK(gltf.parts()[0].mesh.points.row(0).maxCoeff() == 1);
  CHECK(gltf.parts()[1].mesh.points.row(0).minCoeff() == -1);
}

TEST_CASE("Faces of fewer than three corners, and parts without area, are left out and counted")
{
  const Temporary_folder folder;
  const std::string text = obj_box("o leg", 0, 0, 0, 0, 1, 1, 1) + "f 1 2\nf 3\no line\nf 1 2 2\n";
  std::vector<std::string> warnings;
  const Segmented_shape shape = IO::read_segmented_shape(folder.write("a.obj", text), Point::UnitY(), &warnings);
  CHECK(names(shape) == Names{"leg"});
  CHECK(shape.parts()[0].mesh.triangles.cols() == 12);
  REQUIRE(warnings.size() == 2);
  CHECK_THAT(warnings[0], Contains("fewer than three corners") && Contains("2"));
  CHECK_THAT(warnings[1], Contains("Parts without a surface were left out: 1 ('line')."));
  CHECK(names(IO::read_segmented_shape(folder.write("a.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n"))) ==
        Names{"a"});
}

TEST_CASE("Parts of one name get numbers")
{
  const Temporary_folder folder;
  std::string text;
  for (int i = 0; i < 4; ++i)
    text += obj_box(i == 2 ? "o leg#2" : "o leg", i, 2 * i, 0, 0, 1, 1, 1);
  CHECK(names(IO::read_segmented_shape(folder.write("a.obj", text))) == Names{"leg", "leg#3", "leg#2", "leg#4"});
  folder.write("twice/leg.obj", obj_box("o leg", 0, 0, 0, 0, 1, 1, 1));
  folder.write("twice/leg.off", off_box);
  CHECK(names(IO::read_segmented_shape(folder.path("twice"))) == Names{"leg", "leg#2"});
}

TEST_CASE("Names in Latin-1 become UTF-8 without loss")
{
  const Temporary_folder folder;
  const std::string text = obj_box("o T\xFCr", 0, 0, 0, 0, 1, 1, 1) + obj_box("o T\xF6r", 1, 2, 0, 0, 1, 1, 1);
  CHECK(names(IO::read_segmented_shape(folder.write("a.obj", text))) == Names{"T\xC3\xBCr", "T\xC3\xB6r"});
}

TEST_CASE("PLY: all encodings and number types, faces among other lists")
{
  const Temporary_folder folder;
  const std::string header = "comment binary\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                             "property list uchar short more\nelement face 1\nproperty uchar red\n"
                             "property list uint uchar vertex_index\nend_header\n";
  const auto binary = [&](bool little) {
    std::string bytes =
        std::string("ply\nformat ") + (little ? "binary_little_endian" : "binary_big_endian") + " 1.0\n" + header;
    const auto append = [&](const void* number, std::size_t size) {
      std::string all(static_cast<const char*>(number), size);
      bytes += little ? all : std::string(all.rbegin(), all.rend());
    };
    for (int v = 0; v < 3; ++v) {
      for (int i = 0; i < 3; ++i) {
        const float x = v == i + 1 ? 2.5f : 0.f;
        append(&x, sizeof x);
      }
      bytes += '\x01';
      const short more = 7;
      append(&more, sizeof more);
    }
    bytes += '\x80';
    const unsigned three = 3;
    append(&three, sizeof three);
    return bytes + std::string("\x00\x01\x02", 3);
  };
  for (bool little : {true, false}) {
    const Part_mesh mesh = IO::read_segmented_shape(folder.write("a.ply", binary(little))).parts()[0].mesh;
    REQUIRE(mesh.triangles.cols() == 1);
    CHECK(mesh.points.col(1) == Point(2.5, 0, 0));
    CHECK(mesh.points.col(2) == Point(0, 2.5, 0));
  }
}

TEST_CASE("The mesh files of a folder are parts")
{
  const Temporary_folder folder;
  folder.write("chair/parts/b.obj", obj_box("o x", 0, 0, 0, 0, 1, 1, 1) + obj_box("o y", 1, 2, 0, 0, 1, 1, 1));
  folder.write("chair/parts/a.off", off_box);
  folder.write("chair/parts/a.mtl", "newmtl wood");
  folder.write("chair/labels.json", "{}");
  for (const char* name : {"chair", "chair/", "chair/parts", "chair/parts/"}) {
    const Segmented_shape shape = IO::read_segmented_shape(folder.path(name), Point::UnitZ());
    CHECK(shape.name() == "chair");
    CHECK(shape.up() == Point::UnitZ());
    REQUIRE(names(shape) == Names{"a", "b"});
    CHECK(shape.parts()[1].mesh.points.cols() == 16);
  }
}

TEST_CASE("Bad models are refused with file, part and reason")
{
  const Temporary_folder folder;
  const auto refused = [&](const std::string& name, const std::string& text) {
    const std::string file = folder.write(name, text), message = read_complaint(file);
    CHECK_THAT(message, Contains(file));
    return message;
  };
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  CHECK_THAT(refused("empty.obj", ""), Contains("empty"));
  CHECK_THAT(refused("wide.obj", "\xFF\xFEv\0 \0"s), Contains("UTF-16"));
  CHECK_THAT(refused("wide.ac", "\xFE\xFF\0A"s), Contains("UTF-16"));
  CHECK_THAT(refused("empty.glb", ""), Contains("empty"));
  CHECK_THAT(refused("text.obj", "Dear reader,\nthis is no model.\n"), Contains("not a Wavefront OBJ"));
  CHECK_THAT(refused("points.obj", triangle), Contains("no face"));
  for (const char* name : {"t.ply", "t.off", "t.stl", "t.glb", "t.gltf", "t.dae"})
    CHECK_THAT(refused(name, "Dear reader,\nthis is no model.\n"),
               Contains("cannot be read") || Contains("no face") || Contains("not a JSON document"));
  CHECK_THAT(refused("a.docx", "text"), Contains(".docx") && Contains("OBJ"));
  for (const char* point : {"nan 0 0", "0 nan 0", "0 0 nan", "0 0 -inf"})
    CHECK_THAT(refused("nan.obj", "o seat\n" + triangle + "f 1 2 3\no leg\nv " + point + "\nf 1 2 4\n"),
               Contains("'leg'") && Contains("finite"));
  CHECK_THAT(refused("nan.off", "OFF\n3 1 0\nnan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), Contains("nan.off"));
  CHECK_THAT(refused("range.obj", "o leg\n" + triangle + "f 1 2 4\n"), Contains("line 5") && Contains("'leg'"));
  CHECK_THAT(refused("zero.obj", triangle + "f 0 1 2\n"), Contains("line 4"));
  CHECK_THAT(refused("range.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"), Contains("range.off"));
  CHECK_THAT(refused("flat.obj", "o leg\n" + triangle + "f 1 2 2\n"), Contains("'leg'"));
  CHECK_THAT(refused("thin.obj", "o leg\nv 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), Contains("'leg'"));
  CHECK_THAT(refused("number.obj", "v 0 zero 0\n"), Contains("line 1") && Contains("'zero'"));
  CHECK_THAT(read_complaint(folder.path("missing.obj")), Contains("missing.obj") && Contains("no such file"));
}

TEST_CASE("Bad folders are refused")
{
  const Temporary_folder folder;
  fs::create_directories(folder.path("none"));
  CHECK_THAT(read_complaint(folder.path("none")), Contains("none") && Contains("no part"));
  folder.write("bad/leg.obj", obj_box("o leg", 0, 0, 0, 0, 1, 1, 1));
  folder.write("bad/seat.obj", "");
  CHECK_THAT(read_complaint(folder.path("bad")), Contains("seat.obj"));
}

TEST_CASE("In an OBJ of one object that is one piece materials are parts, in one of several pieces they are not")
{
  const Temporary_folder folder;
  // A strip of two squares that share an edge
  const std::string strip = "o strip\nv 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\n";
  const std::string squares = "usemtl wood\nf 1 2 5 4\nusemtl brass\nf 2 3 6 5\n";
  const Segmented_shape divided = IO::read_segmented_shape(folder.write("strip.obj", strip + squares));
  REQUIRE(divided.parts().size() == 2);
  CHECK(divided.parts()[0].name == "wood");
  CHECK(divided.parts()[1].name == "brass");
  CHECK(divided.parts()[1].mesh.triangles.cols() == 2);

  const std::string far = "v 0 0 5\nv 1 0 5\nv 1 1 5\nv 0 1 5\n";
  CHECK(IO::read_segmented_shape(folder.write("loose.obj", strip + far + squares + "f 7 8 9 10\n")).parts().size() ==
        1);
  CHECK(IO::read_segmented_shape(folder.write("named.obj", strip + squares + far + "o other\nf 7 8 9 10\n"))
            .parts()
            .size() == 2);
}

TEST_CASE("Polygons of many corners become triangles in their plane, without a corner that is in many of them")
{
  constexpr int corners = 20000;
  for (const double inner : {1., 0.5}) { // convex, and star-shaped
    std::ostringstream obj;
    obj.precision(17);
    double area = 0;
    for (int i = 0; i < corners; ++i) {
      const double radius = i % 2 ? inner : 1, angle = 2 * EIGEN_PI * i / corners;
      obj << "v " << radius * std::cos(angle) << ' ' << radius * std::sin(angle) << " 3\n";
      area += inner * std::sin(2 * EIGEN_PI / corners) / 2;
    }
    obj << 'f';
    for (int i = 1; i <= corners; ++i)
      obj << ' ' << i;
    const Temporary_folder folder;
    const Part_mesh mesh = IO::read_segmented_shape(folder.write("a.obj", obj.str() + '\n')).parts()[0].mesh;
    REQUIRE(mesh.triangles.cols() == corners - 2);
    Eigen::VectorXi degrees = Eigen::VectorXi::Zero(corners);
    double sum = 0, turned = 0;
    for (const auto& t : mesh.triangles.colwise()) {
      const Point a = mesh.points.col(t[0]), b = mesh.points.col(t[1]), c = mesh.points.col(t[2]);
      const double twice = (b - a).cross(c - a).z();
      sum += std::abs(twice) / 2;
      turned += twice / 2;
      for (int corner : t)
        ++degrees[corner];
    }
    CHECK(sum == Approx(area));
    CHECK(turned == Approx(area));
    CHECK(degrees.maxCoeff() < 1000);
  }
}
