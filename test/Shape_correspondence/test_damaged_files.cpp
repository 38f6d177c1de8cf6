// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Truncated and malicious files: each is read, or gives an error that names it, within moments.

#include "hand_made_graphs.h"
#include "io/system/run_program.h"
#include "model_files.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>

#include <catch2/catch.hpp>

#include <csignal>
#include <sys/stat.h>

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;

namespace {

/// The error when reading the file, which must name it.
std::string read_complaint(const std::string& file)
{
  const std::string message = complaint([&] { IO::read_segmented_shape(file); });
  if (!message.empty()) CHECK_THAT(message, Contains(file));
  return message;
}

std::string ply(const std::string& format, const std::string& vertices, const std::string& list,
                const std::string& faces)
{
  return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " + faces + "\nproperty list " +
         list + " vertex_indices\nend_header\n";
}

std::string json_complaint(const std::string& text)
{
  return complaint([&] {
    std::istringstream in(text);
    IO::read_structural_graph_json(in, "g.json");
  });
}

std::string repeated(const std::string& text, std::size_t times)
{
  std::string result;
  for (std::size_t i = 0; i < times; ++i)
    result += text;
  return result;
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  REQUIRE(text.find(from) != std::string::npos);
  return text.replace(text.find(from), from.size(), to);
}

} // namespace

TEST_CASE("A model that is cut off anywhere is read or refused")
{
  const Temporary_folder folder;
  const std::string vertices = box_vertices(0, 0, 0, 1, 2, 3, ""), faces = box_faces(0, "4 ");
  std::string binary = ply("binary_little_endian", "8", "uchar int", "6");
  for (int i = 0; i < 24; ++i) {
    const double x = (i % 3 == 0 ? i / 3 & 1 : i % 3 == 1 ? i / 6 & 1 : i / 12);
    binary.append(reinterpret_cast<const char*>(&x), sizeof x);
  }
  for (int f = 0; f < 6; ++f) {
    const int corners[] = {f, 0, 7};
    binary += '\x03';
    binary.append(reinterpret_cast<const char*>(corners), sizeof corners);
  }
  std::string stl(84, ' ');
  stl[80] = 2, stl[81] = stl[82] = stl[83] = 0;
  stl += std::string(100, '\x3F');
  const std::pair<std::string, std::string> models[] = {
      {"a.ply", ply("ascii", "8", "uchar int", "6") + vertices + faces},
      {"b.ply", binary},
      {"a.off", "OFF\n8 6 0\n" + vertices + faces},
      {"a.stl", stl},
      {"a.obj", obj_table()}};
  for (const auto& [name, text] : models)
    for (std::size_t size = 0; size <= text.size(); ++size) {
      INFO(name << " of " << size << " bytes");
      const std::string message = read_complaint(folder.write(name, text.substr(0, size)));
      if (size == text.size() && name != "a.stl") CHECK(message.empty());
      if (size + 3 < text.size() && name != "a.obj") CHECK(!message.empty());
    }
}

TEST_CASE("Counts beyond the size of the file are refused before memory is allocated for them")
{
  const Temporary_folder folder;
  const auto refused = [&](const std::string& name, const std::string& text) {
    return read_complaint(folder.write(name, text));
  };
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    CHECK_THAT(refused("a.ply", ply(format, "4000000000", "uchar int", "1") + "0 0 0"), Contains("too short"));
    CHECK_THAT(refused("a.ply", ply(format, "18446744073709551615", "uchar int", "1") + "0 0 0"),
               Contains("too short"));
  }
  CHECK_THAT(refused("a.ply", ply("ascii", "1", "uint int", "1") + "0 0 0 4294967295 0"), Contains("4294967295"));
  CHECK_THAT(refused("a.ply", ply("ascii", "1", "uint int", "1") + "0 0 0 -1 0"), Contains("list of -1"));
  CHECK_THAT(refused("a.off", "OFF\n2000000000 1 0\n0 0 0\n"), Contains("2000000000"));
  CHECK_THAT(refused("a.off", "OFF\n1 1 0\n0 0 0\n1000000000 0\n"), Contains("1000000000"));
  CHECK_THAT(refused("a.off", std::string("OFF BINARY\n\0\0\0\1\0\0\0\1\0\0\0\0", 23)), Contains("is binary"));
  CHECK_THAT(refused("a.stl", std::string(80, ' ') + std::string(4, '\x7F') + std::string(50, '\0')),
             Contains("more than the file holds"));
}

TEST_CASE("A file that the reader of its type refuses is not passed to another reader")
{
  const Temporary_folder folder;
  // A complete STL model, which assimp reads under any name
  const std::string stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                          "endloop\nendfacet\nfacet normal 0 1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                          "vertex 0 0 1\nendloop\nendfacet\nendsolid a\n";
  CHECK_THAT(read_complaint(folder.write("a.ply", stl)), Contains("does not begin with 'ply'"));
  CHECK_THAT(read_complaint(folder.write("a.off", stl)), Contains("does not begin with the word OFF"));
  CHECK_THAT(read_complaint(folder.write("a.obj", stl)), Contains("no face"));
  CHECK_THAT(read_complaint(folder.write("a.stl", obj_table())), Contains("cannot be read as an STL model"));
}

TEST_CASE("Coordinates beyond 1e15 are refused, those at it are not")
{
  const Temporary_folder folder;
  const auto box = [](double size) { return obj_box("o a", 0, 0, 0, 0, size, size, size); };
  CHECK(read_complaint(folder.write("a.obj", box(1e15))).empty());
  CHECK(read_complaint(folder.write("a.obj", box(1e-12))).empty());
  CHECK_THAT(read_complaint(folder.write("a.obj", box(1.01e15))), Contains("1e15") && Contains("'a'"));
  std::ostringstream good;
  IO::write_structural_graph_json(good, hand_made::table());
  CHECK(json_complaint(good.str()).empty());
  CHECK_THAT(json_complaint(replaced(good.str(), "\"points\":[[", "\"points\":[[1e200,0,0],[")), Contains("1e50"));
  CHECK_THAT(json_complaint(replaced(good.str(), "\"points\":[[", "\"points\":[[1e16,0,0],[")), Contains("1e15"));
}

TEST_CASE("Pipes and devices are refused before anything waits for them")
{
  const Temporary_folder folder;
  for (const char* name : {"a.obj", "a.glb"})
    REQUIRE(mkfifo(folder.path(name).c_str(), 0600) == 0);
  alarm(60); // kills a test that waits for more than a minute
  CHECK_THAT(read_complaint(folder.path("a.obj")), Contains("pipe"));
  CHECK_THAT(read_complaint(folder.path("a.glb")), Contains("pipe"));
  fs::create_symlink("/dev/zero", folder.path("endless.obj"));
  CHECK_THAT(read_complaint(folder.path("endless.obj")), Contains("device"));
  for (const char* buffer : {"a.obj", "/dev/zero"})
    CHECK_THAT(
        read_complaint(folder.write(
            "a.gltf", std::string(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":")") + buffer +
                          R"("}],"bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,)" +
                          R"("componentType":5126,"count":3,"type":"VEC3"}],"meshes":[{"primitives":)" +
                          R"([{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}]})")),
        Contains("cannot be read") || Contains("is not there"));
  alarm(0);
}

TEST_CASE("Paths without a file are refused, and the message says why")
{
  const Temporary_folder folder;
  fs::create_symlink("loop.obj", folder.path("loop.obj"));
  CHECK_THAT(read_complaint(folder.path("missing.obj")), Contains("no such file"));
  CHECK_THAT(read_complaint(folder.path("loop.obj")), Contains("symbolic links"));
  CHECK_THAT(read_complaint(folder.path(std::string(300, 'x') + ".obj")), Contains("too long"));
  CHECK_THAT(read_complaint(folder.write("chair", "o seat")), Contains("no extension"));
  CHECK_THAT(json_complaint(""), Contains("empty"));
  CHECK_THAT(json_complaint("[1,"), Contains("not a JSON document (parse error"));
}

TEST_CASE("Documents nested deeply are refused")
{
  const Temporary_folder folder;
  for (std::size_t depth : {101u, 200000u}) {
    CHECK_THAT(json_complaint(repeated("[", depth)), Contains("deeper than 100"));
    CHECK_THAT(json_complaint(repeated("{\"]]\":", depth)), Contains("deeper than 100"));
    for (const char* text : {"<a>", "<a><!--</a></a>--><?x </a>?><b x='/>'/>"})
      CHECK_THAT(read_complaint(folder.write("a.urdf", repeated(text, depth))), Contains("deeper than 100"));
  }
}

TEST_CASE("Documents of so many values that they would need over 2 GB of memory are refused before they are parsed")
{
  for (const auto& [value, times] : {std::pair(R"({"":0},)", 11000000), {"[[[]]],", 10000000}, {R"("a",)", 21000000}})
    CHECK_THAT(json_complaint("[" + repeated(value, std::size_t(times)) + "0]"), Contains("more than 2 GB of memory"));
  CHECK_THAT(json_complaint("[" + repeated("0.12345,", 1000000) + "0]"), !Contains("memory"));
}

TEST_CASE("Whole numbers beyond their range, and a million parts, are refused")
{
  std::ostringstream good;
  IO::write_structural_graph_json(good, hand_made::table());
  CHECK_THAT(json_complaint(replaced(good.str(), "\"version\": 1", "\"version\": 4294967297")), Contains("beyond"));
  CHECK_THAT(json_complaint(replaced(good.str(), "\"version\": 1", "\"version\": 18446744073709551615")),
             Contains("beyond"));
  const std::string head = R"({"format": "shape_correspondence/graph", "version": 1, "parts": [0)";
  CHECK_THAT(json_complaint(head + repeated(",0", 999999) + "]}"), Contains("1000000 parts") && Contains("at most"));
  std::string objects = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 100000; ++i)
    objects += "o " + std::to_string(i) + "\nf 1 2 3\n";
  const Temporary_folder folder;
  CHECK_THAT(read_complaint(folder.write("a.obj", objects)), Contains("100000 parts"));
}

TEST_CASE("A grid of more points than an int can count is refused, also if most of them are missing")
{
  constexpr std::size_t cols = 65536, rows_added = 65534; // with the two rows that the table's grid has, 2^32 points
  std::ostringstream good;
  IO::write_structural_graph_json(good, hand_made::table());
  const std::string grid = "\"grid\":[", first_row = "[[0,0,0]" + repeated(",[0,0,0]", cols - 1) + "],";
  CHECK_THAT(json_complaint(replaced(good.str(), grid, grid + first_row + repeated("0,", rows_added - 1))),
             Contains("grid[1] is not an array"));
}

TEST_CASE(
    "A program that reads a file and is missing, crashes, hangs or is another one is an error that names the file")
{
  const Temporary_folder folder;
  const std::string model = folder.write("a.fbx", "x"), program = folder.path("import");
  setenv("SHAPE_CORRESPONDENCE_IMPORT", program.c_str(), 1);
  const auto complaint_of = [&](const std::string& script) {
    folder.write("import", "#!/bin/sh\n" + script + "\n");
    fs::permissions(program, fs::perms::owner_all);
    return read_complaint(model);
  };
  CHECK_THAT(read_complaint(model), Contains(model) && Contains(program) && Contains("cannot be started"));
  CHECK_THAT(complaint_of("kill -SEGV $$"), Contains(model) && Contains("makes its reader crash (Segm"));
  CHECK_THAT(complaint_of("kill -XCPU $$"), Contains("60 seconds of processor time"));
  CHECK_THAT(complaint_of("exit 3"), Contains("2 GB of memory"));
  CHECK_THAT(complaint_of("exit 1"), Contains("makes its reader crash"));
  CHECK_THAT(complaint_of("echo hello"), Contains("another version"));
  const std::string begin = "printf 'shape_correspondence import 5\\n";
  CHECK_THAT(complaint_of(begin + "e%s is refused' \"$2\""), Contains(model + ": inside is refused"));
  CHECK_THAT(complaint_of(begin + "c12345678'"), Contains("damaged"));
  // The started program has no other open file and no input, and its standard error is discarded
  const std::string listing = "[ -z \"$(cat)\" ] && echo unheard >&2 && ls /proc/self/fd | tr '\\n' ' '";
  // 3 is the folder that `ls` itself opens
  CHECK(IO::run_program("/bin/sh", {"-c", listing}, std::chrono::seconds(10)).output == "0 1 2 3 ");
  const IO::Program_run run =
      IO::run_program("/bin/sh", {"-c", "echo a; exec sleep 60"}, std::chrono::milliseconds(200));
  CHECK(run.took_too_long);
  CHECK(run.output == "a\n");
  unsetenv("SHAPE_CORRESPONDENCE_IMPORT");
  CHECK_THAT(read_complaint(model), Contains(model) && Contains("extension"));
}

TEST_CASE("Of the files that a model names, only those in its folder are read, unless others are allowed")
{
  const Temporary_folder folder;
  fs::create_directories(folder.path("m/parts"));
  folder.write("m/in.obj", "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n");
  std::string floats;
  for (float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f})
    floats.append(reinterpret_cast<const char*>(&x), sizeof x);
  folder.write("out.bin", floats);
  const auto gltf = [&](const std::string& uri) {
    return folder.write(
        "m/a.gltf",
        R"({"asset":{"version":"2.0"},"buffers":[{"uri":")" + uri +
            R"(","byteLength":36}],"bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,)"
            R"("count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
            R"("nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0})");
  };
  IO::Reading_options outside;
  outside.allow_outside_files = true;
  const std::string file = gltf("../out.bin");
  CHECK(!read_complaint(file).empty());
  CHECK(IO::read_segmented_shape(file, Point::UnitY(), nullptr, outside).parts().size() == 1);
  fs::create_symlink(folder.path("out.bin"), folder.path("m/linked.bin"));
  CHECK(!read_complaint(gltf("linked.bin")).empty());
  fs::copy(folder.path("out.bin"), folder.path("m/own.bin"));
  CHECK(read_complaint(gltf("own.bin")).empty());
}

TEST_CASE("Counts that a file states take no memory before the counted data is read")
{
  const Temporary_folder folder;
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uint double vertex_indices\nend_header\n";
  const std::string count("\x00\x00\x10\x00", 4), rest(1 << 20, '\0'); // 2^20 doubles are announced, 2^17 are present
  CHECK_THAT(read_complaint(folder.write("a.ply", header + count + rest)), Contains("a list of 1048576 numbers"));
  const std::string large = folder.write("large.obj", "o a\n");
  fs::resize_file(large, std::uintmax_t(3) << 30);
  CHECK_THAT(read_complaint(large), Contains("larger than 2 GB"));
}

TEST_CASE("A small COLLADA file of a thousand million instances is an error within seconds")
{
  std::string nodes;
  for (int level = 0; level < 9; ++level) {
    const std::string next = level == 8 ? "<instance_geometry url=\"#g\"/>"
                                        : repeated("<instance_node url=\"#n" + std::to_string(level + 1) + "\"/>", 10);
    nodes += "<node id=\"n" + std::to_string(level) + "\">" + next + "</node>\n";
  }
  const Temporary_folder folder;
  const std::string file = folder.write(
      "a.dae", R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 1 0</float_array>
<technique_common><accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/>
</vertices><triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry>
</library_geometries><library_nodes>)" +
                   nodes + R"(</library_nodes><library_visual_scenes><visual_scene id="s"><node id="r">
<instance_node url="#n0"/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene>
</COLLADA>)");
  CHECK(!read_complaint(file).empty());
}

TEST_CASE("A COLLADA file of many instances of one mesh is refused with what to do")
{
  constexpr int triangles = 1500, nodes = 1990;
  const Temporary_folder folder;
  const std::string file = folder.write(
      "a.dae",
      R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 1 0</float_array>
<technique_common><accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/>
</vertices><triangles count=")" +
          std::to_string(triangles) + R"("><input semantic="VERTEX" source="#v" offset="0"/><p>)" +
          repeated("0 1 2 ", triangles) +
          R"(</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s">)" +
          repeated("<node><instance_geometry url=\"#g\"/></node>\n", nodes) +
          R"(</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)");
  CHECK_THAT(read_complaint(file), Contains("a.dae") && Contains("use the same meshes") && Contains("simplify"));
}
