// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Damaged inputs of every format: the error names the file and, after a semicolon, a remedy.

#include "hand_made_graphs.h"
#include "io/system/input_file.h"
#include "model_files.h"
#include "program.h"

#include <CGAL/Shape_correspondence/IO/read_part_labels.h>
#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/IO/role_model.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <regex>

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;

namespace {

const std::vector<std::string> imperatives{
    "add",    "be",       "check",  "choose", "convert",     "copy", "correct", "cut",  "describe",
    "divide", "get",      "give",   "give",   "install",     "join", "leave",   "make", "match",
    "name",   "put",      "remove", "rename", "repair",      "run",  "save",    "say",  "scale",
    "send",   "simplify", "take",   "train",  "triangulate", "try",  "use",     "write"};

/// Whether the last clause of a message is a remedy, which begins with an imperative.
bool says_what_to_do(const std::string& message)
{
  const std::size_t at = message.rfind("; ");
  if (at == std::string::npos || !IO::has_remedy(message)) return false;
  const std::string clause = message.substr(at + 2), word = clause.substr(0, clause.find_first_of(" ,:"));
  return std::count(imperatives.begin(), imperatives.end(), word) > 0;
}

std::string ply(const std::string& format)
{
  return "ply\nformat " + format +
         " 1.0\nelement vertex 8\nproperty double x\nproperty double y\nproperty double z\n"
         "element face 6\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string ascii_stl()
{
  return "solid box\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
         "endsolid box\n";
}

std::string bytes_of(double x) { return std::string(reinterpret_cast<const char*>(&x), sizeof x); }

std::string binary_ply()
{
  std::string text = ply("binary_little_endian");
  std::istringstream vertices(box_vertices(0, 0, 0, 1, 1, 1, ""));
  for (double x; vertices >> x;)
    text += bytes_of(x);
  std::istringstream faces(box_faces(0, ""));
  for (int corner = 0, i = 0; faces >> corner; ++i) {
    if (i % 4 == 0) text += char(4);
    text.append(reinterpret_cast<const char*>(&corner), sizeof corner);
  }
  return text;
}

std::string gltf()
{
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"name":"a"}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":36}],)"
         R"("buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
         R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
}

std::string glb()
{
  std::string text = gltf();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const auto number = [](std::size_t n) {
    const auto value = std::uint32_t(n);
    return std::string(reinterpret_cast<const char*>(&value), sizeof value);
  };
  return "glTF" + number(2) + number(20 + text.size()) + number(text.size()) + "JSON" + text;
}

/// A text with one random change: truncated, or a token replaced.
std::string damaged(const std::string& text, std::mt19937& random)
{
  const std::vector<std::string> tokens{"nan", "-1", "1e400", "99999", "x", "", "{", "]", "\"", "<", "0.5", "null"};
  const auto below = [&](std::size_t n) { return std::size_t(random() % n); };
  const std::size_t begin = below(text.size());
  if (below(4) == 0) return text.substr(0, begin);
  const std::size_t end = std::min(text.find_first_of(" \n,:<>]}", begin + 1), text.size());
  return text.substr(0, begin) + tokens[below(tokens.size())] + text.substr(end);
}

} // namespace

TEST_CASE("The remedies of the table say what to do, and are added where there is none")
{
  for (const char* remedy :
       {IO::remedy::correct_text, IO::remedy::save_again, IO::remedy::check_kind, IO::remedy::check_name,
        IO::remedy::check_permissions, IO::remedy::make_smaller, IO::remedy::save_as_other_format,
        IO::remedy::install_again, IO::remedy::write_elsewhere}) {
    CHECK(says_what_to_do(IO::with_remedy("a: it is 'x; y'", remedy)));
    CHECK(IO::with_remedy("a: it is bad; repair it", remedy) == "a: it is bad; repair it");
  }
}

TEST_CASE("Messages of the library name no switch of the program, and its errors say what to do")
{
  const fs::path sources = fs::path(SHAPE_CORRESPONDENCE_DATA_DIR).parent_path() / "src";
  const std::regex literals("\"([^\"\\\\\n]|\\\\.)*\""), switches("(\"|[ (`])--[a-z]");
  const std::regex errors("throw Invalid_input\\(([^;]|; )*\\);");
  const std::regex remedies(
      "; |must|between|needs?[ \"]|at (least|most)|too_many_parts|numbered from 0|\\((fault|text\\.str\\(\\)|what)\\)");
  for (const auto& entry : fs::recursive_directory_iterator(sources)) {
    const std::string room = *fs::relative(entry.path(), sources).begin();
    const bool is_source = entry.path().extension() == ".cpp" || entry.path().extension() == ".h";
    if (!is_source || room == "cli" || room == "io" || room == "import" || entry.path().stem() == "image_file")
      continue;
    const std::string text = text_of(entry.path());
    INFO(entry.path());
    for (std::sregex_iterator literal(text.begin(), text.end(), literals), end; literal != end; ++literal)
      CHECK_FALSE(std::regex_search(literal->str(), switches));
    for (std::sregex_iterator error(text.begin(), text.end(), errors), end; error != end; ++error) {
      INFO(error->str());
      CHECK(std::regex_search(error->str(), remedies));
    }
  }
}

TEST_CASE("Every error about a damaged file says what to do with it")
{
  const Temporary_folder folder;
  const std::vector<std::pair<std::string, std::string>> files{
      {"a.obj", obj_table()},
      {"a.off", "OFF\n8 6 0\n" + box_vertices(0, 0, 0, 1, 1, 1, "") + box_faces(0, "4 ")},
      {"a.ply", ply("ascii") + box_vertices(0, 0, 0, 1, 1, 1, "") + box_faces(0, "4 ")},
      {"b.ply", binary_ply()},
      {"a.stl", ascii_stl()},
      {"b.stl", std::string(84, '\1')},
      {"a.gltf", gltf()},
      {"a.glb", glb()},
      {"a.json", graph_text(hand_made::chair())},
      {"labels.json", R"({"category": "chair", "parts": {"leg": "leg", "seat": {"coarse": "seat", "fine": "s"}}})"}};
  std::mt19937 random(1);
  for (const auto& [name, text] : files) {
    std::size_t errors = 0;
    for (int i = 0; i < 300; ++i) {
      const std::string file = folder.write(name, damaged(text, random));
      const std::string message = complaint([&, &name = name] {
        std::ifstream in(file, std::ios::binary);
        if (name == "a.json")
          IO::read_structural_graph_json(in, file);
        else if (name == "labels.json")
          IO::read_part_labels(file);
        else
          IO::read_segmented_shape(file);
      });
      if (message.empty()) continue;
      ++errors;
      INFO(message);
      CHECK_THAT(message, Contains(name));
      CHECK(says_what_to_do(message));
    }
    INFO(name);
    CHECK(errors > 20);
  }
}

TEST_CASE("Every error of the program says what to do")
{
  const Temporary_folder folder;
  const std::string table = folder.write("table.obj", obj_table()),
                    graph = folder.write("graph.json", graph_text(hand_made::chair()));
  const auto file = [&](const std::string& name, const std::string& text) { return quoted(folder.write(name, text)); };
  fs::create_directory(folder.path("none"));
  const std::string none = quoted(folder.path("none")), missing = quoted(folder.path("missing"));
  for (const std::string& arguments : std::vector<std::string>{
           "graph " + missing,
           "graph " + none,
           "graph " + file("a.txt", "text"),
           "graph " + file("a.fbx", "Kaydara FBX Binary"),
           "graph " + file("a.dae", "<COLLADA>"),
           "graph " + file("a.3ds", "MM"),
           "graph " + file("empty.obj", ""),
           "graph " + file("wide.obj", "\xFF\xFEv"),
           "graph " + file("deep.json", std::string(200, '[')),
           "graph " + quoted(table) + " --parts-from " + file("parts.json", "{}"),
           "graph " + quoted(table) + " -o " + none,
           "graph " + quoted(table) + " --json /dev/full",
           "match " + quoted(graph) + " " + quoted(graph) + " --pin a=b",
           "match " + quoted(graph) + " " + quoted(graph) + " --search paths",
           "match " + quoted(graph) + " " + quoted(graph) + " --roles " + file("roles", "x"),
           "match " + quoted(graph) + " " + missing,
           "blend " + quoted(graph) + " " + quoted(graph) + " -o " + quoted(folder.path("blend")),
           "blend " + quoted(table) + " " + quoted(table) + " -o " + quoted(folder.path("")),
           "evaluate " + file("match.json", "{\"format\": 3}") + " --labels " + none,
           "evaluate " + none + " --labels " + none,
           "collection " + quoted(table),
           "collection " + none + " --json -",
           "collection " + quoted(table) + " " + file("bad.obj", "v 1 2 x") + " --json -",
           "label " + quoted(table) + " --roles " + missing,
           "parts --all " + none,
           "parts " + file("cut.ply", "ply\nformat ascii 1.0\n"),
           "transfer " + quoted(table) + " " + quoted(table) + " -o " + quoted(folder.path("t.glb")),
           "roles train " + none + " -o " + quoted(folder.path("model")),
           "paint"}) {
    const Run result = run(arguments);
    INFO(arguments + "\n" + result.error);
    CHECK(result.status != 0);
    CHECK_THAT(result.error, !Contains("unexpected"));
    std::istringstream lines(result.error);
    std::string line, last;
    while (std::getline(lines, line))
      if (line.find("note: ") == std::string::npos) last = line;
    CHECK((says_what_to_do(last) || last.find("Try '") != std::string::npos));
  }
}
