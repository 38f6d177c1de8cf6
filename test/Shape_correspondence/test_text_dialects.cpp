// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_files.h"
#include "program.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/IO/read_part_labels.h>
#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>

#include <Eigen/Geometry>

#include <catch2/catch.hpp>

#include <cstdint>
#include <cstring>
#include <functional>

// Text files of models, or files that may be text, as written by other programs.

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using namespace std::string_literals;
using Catch::Matchers::Contains;

namespace {

using Names = std::vector<std::string>;

const std::string mark = "\xEF\xBB\xBF"; // byte order mark

Names names(const Segmented_shape& shape)
{
  Names result;
  for (const Shape_part& part : shape.parts())
    result.push_back(part.name);
  return result;
}

struct Read
{
  Segmented_shape shape;
  Shape_appearance looks;
  std::vector<std::string> warnings;
};

Read read(const std::string& path)
{
  Read result;
  result.shape = IO::read_shape_and_appearance(path, result.looks, Point::UnitY(), &result.warnings);
  return result;
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

void check_same(const Segmented_shape& a, const Segmented_shape& b)
{
  REQUIRE(names(a) == names(b));
  for (std::size_t i = 0; i < a.parts().size(); ++i) {
    CHECK(a.parts()[i].mesh.points == b.parts()[i].mesh.points);
    CHECK(a.parts()[i].mesh.triangles == b.parts()[i].mesh.triangles);
  }
}

const std::string off_numbers = box_vertices(0, 0, 0, 1, 2, 3, "") + box_faces(0, "4 ");
const std::string off_box = "OFF\n8 6 0\n" + off_numbers;
const std::string ply_box = "ply\nformat ascii 1.0\ncomment by hand\nobj_info none\nelement vertex 8\n"
                            "property double x\nproperty double y\nproperty double z\nelement face 6\n"
                            "property list uchar int vertex_indices\nend_header\n" +
                            off_numbers;

/// A tetrahedron at a given place as STL text. \param keyword returns a spelling of a keyword of the format
std::string text_solid(const std::string& name, double x, const std::function<std::string(std::string)>& keyword)
{
  std::ostringstream out;
  out << keyword("solid ") << name << '\n';
  const double p[4][3] = {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, {x, 0, 1}};
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  for (const auto& face : faces) {
    out << keyword("facet normal 0 0 0\nouter loop\n");
    for (int v : face)
      out << keyword("vertex ") << p[v][0] << ' ' << p[v][1] << ' ' << p[v][2] << '\n';
    out << keyword("endloop\nendfacet\n");
  }
  out << keyword("endsolid ") << name << '\n';
  return out.str();
}

std::string text_solid(const std::string& name, double x)
{
  return text_solid(name, x, [](const std::string& word) { return word; });
}

/// The tetrahedron as a binary file. \param count number of triangles in its header
std::string binary_solid(const std::string& header, float x, std::uint32_t count = 4)
{
  std::string result = header;
  result.resize(80, ' ');
  const auto append = [&](const auto& number) { result.append(reinterpret_cast<const char*>(&number), sizeof number); };
  append(count);
  const float p[4][3] = {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, {x, 0, 1}};
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  for (const auto& face : faces) {
    for (float normal : {0.f, 0.f, 1.f})
      append(normal);
    for (int v : face)
      for (float coordinate : p[v])
        append(coordinate);
    append(std::uint16_t(0));
  }
  return result;
}

} // namespace

TEST_CASE("Byte order marks and line ends of all systems change nothing, in any text format")
{
  const Temporary_folder folder;
  const std::string obj = replaced(obj_table(), "o top\n", "mtllib a.mtl\no top\nusemtl red\n") + "usemtl blue\n" +
                          obj_box("o foot", 5, 0, -1, 0, 1, 1, 1);
  const std::string mtl = "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1 # sky\n";
  folder.write("a.mtl", mtl);
  const std::string stl = text_solid("seat", 0) + text_solid("back", 5);
  for (const auto& [file, text] :
       {std::pair("m.obj"s, obj), {"m.off"s, off_box}, {"m.ply"s, ply_box}, {"m.stl"s, stl}}) {
    const Read plain = read(folder.write(file, text));
    for (const std::string& end : {"\n"s, "\r\n"s, "\r"s})
      for (const std::string& before : {""s, mark}) {
        CAPTURE(file, end, before);
        folder.write("a.mtl", before + replaced(mtl, "\n", end));
        const Read other = read(folder.write(file, before + replaced(text, "\n", end)));
        check_same(other.shape, plain.shape);
        CHECK(other.looks.warnings.empty());
        REQUIRE(other.looks.materials.size() == plain.looks.materials.size());
        for (std::size_t i = 0; i < plain.looks.materials.size(); ++i)
          CHECK(other.looks.materials[i].colour == plain.looks.materials[i].colour);
      }
  }
  for (const char* first : {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "o leg\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"})
    CHECK(names(IO::read_segmented_shape(folder.write("leg.obj", mark + first))) == Names{"leg"});
  folder.write("c/labels.json", mark + R"({"parts": [{"name": "seat", "coarse": "seat"}]})");
  CHECK(IO::read_part_labels(folder.path("c"))[0].parts == Names{"seat"});
}

TEST_CASE("Text in UTF-16 is refused with what to do, or left out where it is a library")
{
  const Temporary_folder folder;
  const auto wide = [](const std::string& text) {
    std::string result = "\xFF\xFE";
    for (char c : text)
      (result += c) += '\0';
    return result;
  };
  for (const char* name : {"a.obj", "a.off", "a.ply", "a.stl", "a.dae"})
    CHECK_THAT(complaint([&] { IO::read_segmented_shape(folder.write(name, wide("solid a\nfacet\n"))); }),
               Contains(name) && Contains("UTF-16"));
  CHECK_THAT(complaint([&] { IO::read_part_labels(folder.write("c/labels.json", wide("{}"))); }), Contains("UTF-16"));
  folder.write("a.mtl", wide("newmtl red\n"));
  CHECK_THAT(read(folder.write("b.obj", "mtllib a.mtl\n" + obj_table())).looks.warnings.at(0),
             Contains("a.mtl") && Contains("UTF-16"));
}

TEST_CASE("A binary PLY file with a header of any line ends is read from its first byte")
{
  const Temporary_folder folder;
  const auto append = [](auto number, std::string& text) {
    text.append(reinterpret_cast<const char*>(&number), sizeof number);
  };
  std::string bytes;
  append(2.0f, bytes);
  bytes[0] = '\n'; // looks like the end of a line
  for (float coordinate : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f})
    append(coordinate, bytes);
  bytes += '\3';
  for (int vertex : {0, 1, 2})
    append(vertex, bytes);
  for (const std::string& end : {"\n"s, "\r\n"s, "\r"s}) {
    const std::string header = replaced("ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
                                        "property float y\nproperty float z\nelement face 1\n"
                                        "property list uchar int vertex_indices\nend_header\n",
                                        "\n", end);
    const Part_mesh mesh = IO::read_segmented_shape(folder.write("a.ply", header + bytes)).parts()[0].mesh;
    CHECK(mesh.points(0, 0) == Approx(2));
    CHECK(mesh.points.col(2) == Point(0, 0, 1));
  }
}

TEST_CASE("OBJ: a backslash at the end of a comment or a name does not continue the line, one in numbers does")
{
  const Temporary_folder folder;
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const Segmented_shape plain = IO::read_segmented_shape(folder.write("a.obj", "o leg\n" + triangle + "f 1 2 3\n"));
  for (const std::string& text :
       {"o leg\n# C:\\models\\\n" + triangle + "f 1 2 3\n", "# from C:\\\no leg\n" + triangle + "f 1 2 3\n",
        "o leg\nusemtl C:\\tmp\\\n" + triangle + "f 1 2 3\n", "mtllib C:\\tmp\\\no leg\n" + triangle + "f 1 2 3\n",
        "o leg\nv 0 0 0 # first \\\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"s, "o leg\n" + triangle + "f 1 2 3 \\\n",
        "o leg\n" + triangle + "f 1 \\\n2 \\\r\n 3\n", "o leg\nv 0 \\\n0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\\\n\n"s,
        "o leg\n" + triangle + "f 1 2 3 \\\no \n"})
    check_same(IO::read_segmented_shape(folder.write("a.obj", text)), plain);
  CHECK(names(IO::read_segmented_shape(folder.write("a.obj", "o leg\\\n" + triangle + "f 1 2 3\n"))) == Names{"leg\\"});
  folder.write("a.mtl", "newmtl wood\\\nKd 1 0 0\n# C:\\\nnewmtl oak # old\nKd 0 1 0\n");
  const Read looks = read(folder.write("a.obj", "mtllib a.mtl\n" + triangle +
                                                    "o a\nusemtl wood\\\nf 1 2 3\no b\nusemtl oak # old\nf 1 2 3\n"));
  CHECK(looks.looks.materials.at(0).colour == Eigen::Vector4d(1, 0, 0, 1));
  CHECK(looks.looks.materials.at(1).colour == Eigen::Vector4d(0, 1, 0, 1));
}

TEST_CASE("OBJ: a group that is named again continues if it uses its earlier vertices, or else is another part")
{
  const Temporary_folder folder;
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n", far = "v 5 0 0\nv 6 0 0\nv 5 1 0\n";
  const std::string other = "g other\nv 9 0 0\nv 9 1 0\nv 9 0 1\nf -1 -2 -3\n";
  for (const char* object : {"", "o seat\n"}) {
    const Read again = read(
        folder.write("a.obj", object + square + "g seat\nusemtl a\nf 1 2 3\n" + other + "g seat\nusemtl b\nf 1 3 4\n"));
    CHECK(names(again.shape) == Names{"seat", "other"});
    CHECK(again.shape.parts()[0].mesh.triangles.cols() == 2);
    CHECK(again.looks.parts[0].materials.size() == 2);
  }
  CHECK(names(IO::read_segmented_shape(folder.write("a.obj", square + "g seat\nf 1 2 3 4\ng seat\n" + far +
                                                                 "f 5 6 7\n"))) == Names{"seat", "seat#2"});
  // A third group, which has vertices of both, joins them
  CHECK(names(IO::read_segmented_shape(
            folder.write("a.obj", square + far + "g seat\nf 1 2 3 4\ng seat\nf 5 6 7\ng seat\nf 1 5 6\n" + other))) ==
        Names{"seat", "other"});
  // The same holds for several objects with the same name
  CHECK(names(IO::read_segmented_shape(folder.write(
            "a.obj", square + far + "o leg\nf 1 2 3\no top\nf 5 6 7\no leg\nf 1 3 4\n"))) == Names{"leg", "top"});
}

TEST_CASE("OBJ: groups of an object that share vertices name its faces, others are parts")
{
  const Temporary_folder folder;
  const auto box_of_sides = [](const std::string& name, int index, double y) {
    std::string result = "o " + name + '\n' + box_vertices(0, y, 0, 1, 1, 1, "v ");
    std::istringstream faces(box_faces(8 * index + 1, "f "));
    int side = 0;
    for (std::string face; std::getline(faces, face);)
      result += "g " + name + "_side" + std::to_string(side++) + '\n' + face + '\n';
    return result;
  };
  CHECK(names(IO::read_segmented_shape(
            folder.write("a.obj", box_of_sides("seat", 0, 0) + box_of_sides("back", 1, 1)))) == Names{"seat", "back"});
  // An object of separate groups in contact, and one whose groups are regions of a surface
  CHECK(names(IO::read_segmented_shape(folder.write(
            "a.obj", obj_box("o chair\ng seat", 0, 0, 0, 0, 1, 1, 1) + obj_box("g back", 1, 0, 1, 0, 1, 1, 1) +
                         box_of_sides("table", 2, 7)))) == Names{"seat", "back", "table"});
  // The groups of the only object, which is one surface, are kept, since there are no other parts
  CHECK(names(IO::read_segmented_shape(folder.write("a.obj", box_of_sides("seat", 0, 0)))).size() == 6);
}

TEST_CASE("OBJ: a vertex may have a colour or a weight after its coordinates, and ZBrush writes colours in comments")
{
  const Temporary_folder folder;
  const std::string face = "f 1 2 3\n";
  const auto colours = [&](const std::string& text) {
    return read(folder.write("a.obj", "o leg\n" + text + face)).looks.parts.at(0).colours;
  };
  const Eigen::Vector3f red(1, 0, 0), blue(0, 0, 1), white(1, 1, 1);
  using Colours = std::vector<Eigen::Vector3f>;
  CHECK(colours("v 0 0 0 1 0 0\nv 1 0 0 1.0 0 0 1\nv 0 1 0 0 0 1\n") == Colours{red, red, blue});
  CHECK(colours("v 0 0 0 255 0 0\nv 1 0 0 0 0 255\nv 0 1 0\n") == Colours{red, blue, white});
  CHECK(colours("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\n").empty());
  CHECK(colours("#MRGB fff00000ff0000FF\nv 0 0 0\nv 1 0 0\nv 0 1 0\n#MRGB ff00ff00\n").at(0).x() > 0.8);
  CHECK(colours("v 0 0 0\nv 1 0 0\nv 0 1 0\n#MRGB ffff0000ff0000ff\n") == Colours{red, blue, white});
}

TEST_CASE("OFF: headers of all kinds, comments, colours of vertices and faces")
{
  const Temporary_folder folder;
  const Segmented_shape plain = IO::read_segmented_shape(folder.write("m.off", off_box));
  for (const char* header :
       {"OFF8 6 0\n", "OFF 8 6 0\n", "OFF\n# by hand\n\n8 6\n", "off\n8 6 12 # edges\n", "OFF\n8\n6\n12\n", "8 6 0\n",
        "NOFF\n8 6 0\n", "STOFF8 6 0\n", "nOFF 3\n8 6 0\n", "nOFF\n3\n8 6 0\n"})
    check_same(IO::read_segmented_shape(folder.write("m.off", header + off_numbers)), plain);
  check_same(IO::read_segmented_shape(folder.write("m.off", "OFF8 6 0\n" + replaced(off_numbers, "\n", " # here\n\n"))),
             plain);
  const auto mesh = [&](const std::string& text) {
    return IO::read_segmented_shape(folder.write("t.off", text)).parts().at(0).mesh;
  };
  CHECK(mesh("4OFF\n3 1 0\n0 0 0 1\n2 0 0 2\n0 4 0 2\n3 0 1 2\n").points.col(2) == Point(0, 2, 0));
  for (const char* text : {"4OFF\n5 1 0 1\n0 0 0 1\n", "nOFF 4\n3 1 0\n", "4nOFF 3\n3 1 0\n"})
    CHECK_THAT(complaint([&] { mesh(text); }), Contains("not three-dimensional"));
  CHECK_THAT(complaint([&] { mesh("OOFF\n3 1 0\n"); }), Contains("OFF"));

  const Eigen::Vector3f red(1, 0, 0), blue(0, 0, 1);
  const auto colours = [&](const std::string& text) {
    return read(folder.write("t.off", text)).looks.parts.at(0).colours;
  };
  using Colours = std::vector<Eigen::Vector3f>;
  const Colours expected{red, blue, blue};
  CHECK(colours("COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 0 255 255\n0 1 0 0 0 255 255\n3 0 1 2\n") == expected);
  // The header does not announce the colours
  CHECK(colours("OFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 0 0 255\n0 1 0 0 0 255\n3 0 1 2\n") == expected);
  CHECK(colours("COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 0 0 1 1\n0 1 0 0 0 1 1\n3 0 1 2\n") == expected);
  CHECK(colours("CNOFF\n3 1 0\n0 0 0 0 0 1 1 0 0\n1 0 0 0 0 1 0 0 1\n0 1 0 0 0 1 0 0 1\n3 0 1 2\n") == expected);
  CHECK(colours("NCOFF\n3 1 0\n0 0 0 255 0 0 9 0 0 1\n1 0 0 0 0 255 9 0 0 1\n0 1 0 0 0 255 9 0 0 1\n3 0 1 2\n") ==
        expected); // written by MeshLab
  CHECK(colours("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1 0 0\n") == Colours{red, red, red});
  CHECK(colours("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0 255\n") == Colours{red, red, red});
  CHECK(colours("OFF\n3 1 0\n0 0 0 .5 .5 .5\n1 0 0 .5 .5 .5\n0 1 0 .5 .5 .5\n3 0 1 2 7\n").empty());
}

TEST_CASE("PLY: triangle strips, as text and in bytes, with and without signs")
{
  const Temporary_folder folder;
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n5 0 0\n5 1 0\n5 0 1\n";
  const auto header = [](const std::string& format, const std::string& type, int strips) {
    return "ply\nformat " + format + " 1.0\nelement vertex 7\nproperty float x\nproperty float y\nproperty float z\n" +
           "element tristrips " + std::to_string(strips) + "\nproperty list int " + type +
           " vertex_indices\nend_header\n";
  };
  const auto check = [&](const std::string& text) {
    const Part_mesh mesh = IO::read_segmented_shape(folder.write("s.ply", text)).parts().at(0).mesh;
    REQUIRE(mesh.triangles.cols() == 3);
    double area = 0;
    for (int t = 0; t < 2; ++t) {
      const Point a = mesh.points.col(mesh.triangles(0, t));
      area += (mesh.points.col(mesh.triangles(1, t)) - a).cross(mesh.points.col(mesh.triangles(2, t)) - a).z() / 2;
    }
    CHECK(area == Approx(1)); // both have the same orientation
  };
  check(header("ascii", "int", 1) + vertices + "8 0 1 2 3 -1 4 5 6\n");
  check(header("ascii", "int", 2) + vertices + "5 0 1 2 3 -1\n3 4 5 6\n");
  for (const char* type : {"int", "uint"}) {
    std::string bytes = header("binary_little_endian", type, 1);
    const auto append = [&](auto number) { bytes.append(reinterpret_cast<const char*>(&number), sizeof number); };
    std::istringstream numbers(vertices);
    for (float number = 0; numbers >> number;)
      append(number);
    for (int number : {8, 0, 1, 2, 3, -1, 4, 5, 6})
      append(number);
    check(bytes);
  }
}

TEST_CASE("PLY: every face has its own of several textures")
{
  const Temporary_folder folder;
  const std::string head = "ply\nformat ascii 1.0\ncomment TextureFile a.png\ncomment TextureFile the b.png\n"
                           "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
  const Read by_faces = read(folder.write(
      "a.ply", head + "element face 3\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
                      "property int texnumber\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2 6 0 0 1 0 0 1 1\n"
                      "3 0 1 3 6 0 0 1 0 0 1 0\n3 0 2 3 6 0 0 1 0 0 1 7\n"));
  CHECK(by_faces.looks.parts.at(0).materials == std::vector<int>{1, 0, -1});
  REQUIRE(by_faces.looks.textures.size() == 2);
  CHECK(by_faces.looks.textures[1].name == "the b.png");
  const Read by_vertices = read(folder.write(
      "b.ply", head + "property float s\nproperty float t\nproperty int texnumber\nelement face 2\n"
                      "property list uchar int vertex_indices\nend_header\n0 0 0 0 0 1\n1 0 0 1 0 0\n0 1 0 0 1 0\n"
                      "0 0 1 1 1 0\n3 0 1 2\n3 1 2 3\n"));
  CHECK(by_vertices.looks.parts.at(0).materials == std::vector<int>{1, 0});
}

TEST_CASE("STL: keywords in capitals or on one line, several solids, and concatenated files are read")
{
  const Temporary_folder folder;
  const auto shape = [&](const std::string& text) { return read(folder.write("m.stl", text)); };
  const auto check = [&](const std::string& text, const Names& parts) {
    CAPTURE(text.substr(0, 100));
    const Read model = shape(text);
    CHECK(names(model.shape) == parts);
    CHECK(model.warnings.empty());
    for (const Shape_part& part : model.shape.parts())
      CHECK(part.mesh.triangles.cols() == 4);
  };
  const auto upper = [](std::string text) {
    for (char& c : text)
      c = char(std::toupper(c));
    return text;
  };
  check(text_solid("a", 0, upper) + text_solid("b", 5, upper), {"a", "b"});
  check(text_solid("a", 0) + text_solid("a", 5), {"a", "a#2"});
  check(text_solid("", 0) + text_solid("", 5), {"part_1", "part_2"});
  check(replaced(replaced(text_solid("a", 0), "endloop\n", "endloop "), "outer loop\n", "outer loop "), {"a"});
  check("\n\n" + text_solid("a", 0) + "\0\0\0"s, {"a"});
  check(text_solid("a", 0).substr(8), {"m"}); // the text without its first line
  check(binary_solid("solid by a program", 0), {"m"});
  check(binary_solid("seat", 0) + binary_solid("back", 5), {"seat", "back"});
  check(binary_solid("by X", 0) + binary_solid("by X", 5), {"part_1", "part_2"});
  check(binary_solid("seat", 0) + text_solid("back", 5), {"part_1", "back"});
  check(text_solid("back", 5) + binary_solid("seat", 0), {"back", "part_2"});
  check(binary_solid("zeros", 0) + std::string(37, '\0'), {"m"});
}

TEST_CASE("STL: parts of a file that are left out, or differ from its header, are reported")
{
  const Temporary_folder folder;
  const auto warning = [&](const std::string& text) {
    const Read model = read(folder.write("m.stl", text));
    REQUIRE(model.shape.parts().size() == 1);
    CHECK(model.shape.parts()[0].mesh.triangles.cols() == 4);
    return model.warnings.size() == 1 ? model.warnings[0] : "";
  };
  CHECK_THAT(warning(binary_solid("solid x", 0) + "written by a program"), Contains("20 bytes"));
  CHECK_THAT(warning(text_solid("x", 0) + "written by a program\n"), Contains("Lines") && Contains("1"));
  for (std::uint32_t count : {0u, 0xFFFFFFFFu, 3u})
    CHECK_THAT(warning(binary_solid("x", 0, count)), Contains("says") && Contains("4 were read"));
  CHECK_THAT(complaint([&] { read(folder.write("m.stl", binary_solid("x", 0, 5))); }), Contains("cut off"));
  CHECK_THAT(complaint([&] { read(folder.write("m.stl", "solid x\nendsolid x\n")); }), Contains("no triangle"));
}

TEST_CASE("Hidden files and folders are no parts, models or shapes, for any command")
{
  const Temporary_folder folder;
  const std::string junk = "\0\5\x16\7"s;
  for (const char* shape : {"chairs/a", "chairs/b"}) {
    const std::string parts = std::string(shape) + "/";
    folder.write(parts + "seat.obj", obj_box("o seat", 0, 0, 1, 0, 1, 1, 1));
    folder.write(parts + "leg.obj", obj_box("o leg", 0, 0, 0, 0, .2, 1, .2));
    for (const char* hidden : {"._leg.obj", ".old.obj", ".DS_Store", "Thumbs.db", "__MACOSX/._leg.obj"})
      folder.write(parts + hidden, junk);
  }
  folder.write("chairs/__MACOSX/a/._leg.obj", junk);
  folder.write("chairs/.git/x.obj", junk);
  CHECK(names(IO::read_segmented_shape(folder.path("chairs/a"))) == Names{"leg", "seat"});
  const std::string chairs = quoted(folder.path("chairs"));
  const Run all = run("parts " + chairs + " --all");
  CHECK(all.status == 0);
  CHECK(all.error.empty());
  const Run collection = run("collection " + chairs + " --abstraction boxes --json -");
  INFO(collection.error);
  CHECK(collection.status == 0);
  CHECK_THAT(collection.error, !Contains("MACOSX"));
}
