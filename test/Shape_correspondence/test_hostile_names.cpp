// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Names are arbitrary text: every output format must contain them as plain names.

#include "box_shapes.h"
#include "hand_made_graphs.h"
#include "io/system/quoting.h"
#include "page_documents.h"
#include "program.h"
#include "viewer/pages.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/IO/matrix_files.h>
#include <CGAL/Shape_correspondence/IO/parts_json.h>
#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_formats.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/IO/write_glb.h>
#include <CGAL/Shape_correspondence/IO/write_html.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <boost/property_tree/xml_parser.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <tuple>

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Names = std::vector<std::string>;

namespace {

/// Fifty different names.
Names hostile_names()
{
  return {"a\nv 9 9 9\nf 1 2 3",
          "a\r\no b",
          "a\tb",
          "\x1B[31mred\x1B[0m",
          "\x1B]0;title\x07",
          std::string("nul\0nul", 7),
          "\x7F",
          "\x08\x08\x08",
          "T\xFCr", // Latin-1
          "T\xF6r",
          "T\xC3\xBCr, too",  // UTF-8
          "\xE2\x82",         // truncated
          "\xC0\xAF",         // overlong encoding
          "\xED\xA0\x80",     // a surrogate
          "\xF4\x90\x80\x80", // beyond Unicode
          "\xC2\x9B"
          "31m",              // a control character of two bytes
          "\xE2\x80\xAEgel",  // a right-to-left override
          "\xE2\x80\xA8line", // a line separator
          "\xEF\xBB\xBF"
          "bom",
          "\xEF\xBF\xBE",     // a noncharacter
          "\xF0\x9F\xAA\x91", // a chair
          "\"",
          "a\" b=\"c",
          "'",
          "back\\",
          "\\",
          "\\\"",
          "\\n",
          "#",
          "a #b",
          "Leg#2",
          "%",
          "%41",
          "%0A",
          " blank",
          "blank ",
          " ",
          "a,b",
          "a;b",
          "=1+1",
          "<script>alert(1)</script>",
          "</script><b>",
          "]]>",
          "<!--",
          "&amp;",
          "&#0;",
          "end_header",
          "../../etc/passwd",
          "-o",
          std::string(300, 'x')};
}

std::string name_of_part(std::size_t i) { return hostile_names()[i]; }

Segmented_shape boxes()
{
  Segmented_shape shape("<b>\n\x1B[0m\"\\");
  for (std::size_t i = 0; i < hostile_names().size(); ++i)
    shape.add_part(name_of_part(i), box_shapes::box(Point(2. * double(i), 0, 0), Point::Ones()));
  return shape;
}

/// A chain of parts, each a group of its own.
Structural_graph chain()
{
  std::vector<Point> places;
  std::vector<std::array<std::size_t, 2>> contacts;
  for (std::size_t i = 0; i < hostile_names().size(); ++i) {
    places.push_back({double(i), 0, 0});
    if (i > 0) contacts.push_back({i - 1, i});
  }
  Structural_graph graph = hand_made::point_graph(places, contacts);
  for (std::size_t i = 0; i < places.size(); ++i) {
    Part_abstraction& part = structure(graph).parts[i];
    part = hand_made::curve(name_of_part(i), places[i], places[i] + Point(0, 1, 0));
  }
  structure(graph).name = "<b>\n\x1B[0m\"\\";
  structure(graph).warnings = {"part '\x1B[31m' is odd"};
  return graph;
}

Names in_utf8(const Names& names)
{
  Names result;
  for (const std::string& name : names)
    result.push_back(IO::utf8_text(name));
  return result;
}

Names part_names(const Segmented_shape& shape)
{
  Names result;
  for (const Shape_part& part : shape.parts())
    result.push_back(part.name);
  return result;
}

template <typename Write>
std::string text_of_output(const Write& write)
{
  std::ostringstream out;
  write(out);
  return out.str();
}

std::size_t count(const std::string& text, const std::string& what)
{
  std::size_t result = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++result;
  return result;
}

bool has_control(const std::string& text)
{
  return std::any_of(text.begin(), text.end(), [](unsigned char c) { return (c < ' ' && c != '\n') || c == 0x7F; });
}

std::string decoded(const std::string& text)
{
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size() && std::isxdigit(text[i + 1]) && std::isxdigit(text[i + 2])) {
      result += char(std::stoi(text.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else
      result += text[i];
  }
  return result;
}

} // namespace

TEST_CASE("There are fifty hostile names, which differ as UTF-8, too")
{
  const Names names = in_utf8(hostile_names());
  CHECK(names.size() == 50);
  CHECK(std::set<std::string>(names.begin(), names.end()).size() == 50);
  CHECK(names[8] == "T\xC3\xBCr");
  for (const std::string& name : names)
    CHECK(IO::utf8_text(name) == name);
}

TEST_CASE("OBJ and PLY: names read back, nothing is injected")
{
  const Temporary_folder folder;
  const Segmented_shape shape = boxes();
  const std::string obj = text_of_output([&](std::ostream& out) { IO::write_segmented_shape_obj(out, shape); });
  const Segmented_shape read = IO::read_segmented_shape(folder.write("a.obj", obj));
  REQUIRE(read.parts().size() == 50);
  CHECK(part_names(read) == in_utf8(hostile_names()));
  for (std::size_t i = 0; i < 50; ++i)
    CHECK(read.parts()[i].mesh.triangles.cols() == shape.parts()[i].mesh.triangles.cols());
  CHECK(part_names(read)[30] == "Leg#2");

  const std::string ply = text_of_output([&](std::ostream& out) { IO::write_segmented_shape_ply(out, shape); });
  const Segmented_shape of_ply = IO::read_segmented_shape(folder.write("a.ply", ply));
  REQUIRE(of_ply.parts().size() == 50);
  CHECK(of_ply.parts()[7].mesh.triangles.cols() == shape.parts()[7].mesh.triangles.cols());
  CHECK(part_names(of_ply) == in_utf8(hostile_names()));
  std::istringstream header(ply.substr(0, ply.find("\nend_header\n") + 1));
  std::size_t comments = 0;
  for (std::string line; std::getline(header, line);) {
    const std::string begin = "comment part " + std::to_string(comments) + " ";
    if (line.compare(0, begin.size(), begin) == 0)
      CHECK(decoded(line.substr(begin.size())) == in_utf8(hostile_names())[comments++]);
  }
  CHECK(comments == 50);
}

TEST_CASE("JSON: the graph and the result read back")
{
  const Structural_graph graph = chain();
  std::istringstream in(text_of_output([&](std::ostream& out) { IO::write_structural_graph_json(out, graph); }));
  const Structural_graph read = IO::read_structural_graph_json(in, "g.json");
  Names names;
  for (const Part_abstraction& part : structure(read).parts)
    names.push_back(part.name);
  CHECK(names == in_utf8(hostile_names()));

  const Temporary_folder folder;
  const Correspondence c = find_correspondence(read, read);
  const std::string file = folder.write("r.json", text_of_output([&](std::ostream& out) {
                                          IO::write_correspondence_json(out, c, read, read, "a\nb", "\xFC", {});
                                        }));
  const Correspondence again = IO::correspondence_of(IO::read_correspondence_json(file), read, read, file);
  REQUIRE(again.pairs.size() == c.pairs.size());
  for (std::size_t i = 0; i < c.pairs.size(); ++i)
    CHECK((again.pairs[i].source == c.pairs[i].source && again.pairs[i].target == c.pairs[i].target));
}

TEST_CASE("Graphviz: every name is one string")
{
  const std::string dot = text_of_output([](std::ostream& out) { IO::write_structural_graph_dot(out, chain()); });
  CHECK_FALSE(has_control(dot));
  Names labels;
  const std::string begin = "[label=\"";
  for (std::size_t at = dot.find(begin); at != std::string::npos; at = dot.find(begin, at)) {
    std::string label;
    for (at += begin.size(); dot[at] != '"'; ++at) {
      const bool is_escaped = dot[at] == '\\';
      at += is_escaped ? 1 : 0;
      label += is_escaped && dot[at] == 'n' ? '\n' : dot[at];
    }
    labels.push_back(decoded(label));
    CHECK(dot.compare(at, 11, "\", solidity") == 0);
  }
  CHECK(labels == in_utf8(hostile_names()));
  CHECK(count(dot, "\n") == 50 + 49 + 2);
}

TEST_CASE("GraphML is well-formed, and holds the names")
{
  const std::string text = text_of_output([](std::ostream& out) { IO::write_structural_graph_graphml(out, chain()); });
  CHECK_FALSE(has_control(text.substr(0, text.find('\t')))); // one name has a tab
  std::istringstream in(text);
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(in, tree);
  std::set<std::string> data;
  for (const auto& [tag, node] : tree.get_child("graphml.graph"))
    if (tag == "node")
      for (const auto& [key, value] : node)
        if (key == "data") data.insert(decoded(value.data()));
  for (const std::string& name : in_utf8(hostile_names())) {
    INFO(name);
    CHECK(data.count(name) == 1);
  }
}

TEST_CASE("CSV: every name is one field")
{
  const Names names = hostile_names();
  const Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(50, 50);
  const std::string csv = text_of_output([&](std::ostream& out) { IO::write_csv(out, matrix, names); });
  Names fields(1);
  bool in_quotes = false;
  for (std::size_t i = 0; i < csv.size() && (in_quotes || csv.compare(i, 2, "\r\n") != 0); ++i) {
    if (csv[i] == '"' && in_quotes && csv[i + 1] == '"')
      fields.back() += csv[++i];
    else if (csv[i] == '"')
      in_quotes = !in_quotes;
    else if (csv[i] == ',' && !in_quotes)
      fields.emplace_back();
    else
      fields.back() += csv[i];
  }
  fields.erase(fields.begin());
  Names expected = in_utf8(names);
  for (std::string& name : expected) // a quote precedes names that a spreadsheet would take for formulas
    if (std::string("=+-@\t\r").find(name[0]) != std::string::npos) name.insert(0, "'");
  CHECK(fields == expected);
}

TEST_CASE("GLB and web pages hold the names in their JSON")
{
  const Structural_graph graph = chain();
  const std::string glb = text_of_output([&](std::ostream& out) { IO::write_structural_graph_glb(out, graph); });
  const std::string json = glb.substr(20, std::size_t(static_cast<unsigned char>(glb[12])) +
                                              (std::size_t(static_cast<unsigned char>(glb[13])) << 8) +
                                              (std::size_t(static_cast<unsigned char>(glb[14])) << 16));
  const std::string nodes = nlohmann::json::parse(json).dump();
  const std::string page = text_of_output([&](std::ostream& out) { IO::write_structural_graph_html(out, graph); });
  Structural_graph harmless = graph;
  for (std::size_t i = 0; i < 50; ++i)
    structure(harmless).parts[i].name = "part " + std::to_string(i);
  structure(harmless).name = "shape";
  const std::string other = text_of_output([&](std::ostream& out) { IO::write_structural_graph_html(out, harmless); });
  CHECK(count(page, "<") == count(other, "<"));
  const std::string data = nlohmann::json::parse(page_documents::document_of(page, "graph")).dump();
  CHECK(page_documents::from_base64(page_documents::document_of(page, "graph.glb")) == glb);
  for (const std::string& name : in_utf8(hostile_names())) {
    INFO(name);
    CHECK(nodes.find(nlohmann::json(name).dump()) != std::string::npos);
    CHECK(data.find(nlohmann::json(name).dump()) != std::string::npos);
  }
}

TEST_CASE("Lists of pieces and their parts read back")
{
  const Temporary_folder folder;
  Segmented_shape objects("<b>");
  for (const std::string& name : in_utf8(hostile_names())) // in UTF-8, as readers of files give them
    objects.add_part(name, box_shapes::box(Point(2. * double(objects.parts().size()), 0, 0), Point::Ones()));
  const Part_split split = split_parts(objects);
  const std::string file =
      folder.write("p.json", text_of_output([&](std::ostream& out) { IO::write_parts_json(out, split); }));
  CHECK(part_names(IO::split_parts_by_json(objects, file).shape) == in_utf8(hostile_names()));
}

TEST_CASE("Pages of matches and of parts hold the names in their JSON, and nothing else")
{
  const auto page_of_match = [](const Structural_graph& graph, const std::string& file) {
    const Correspondence c = find_correspondence(graph, graph);
    return text_of_output([&](std::ostream& out) {
      IO::write_page(out, IO::match_page({c}, graph, graph, nullptr, nullptr, file, file, {}));
    });
  };
  const auto page_of_parts = [](const Segmented_shape& objects, const std::string& title) {
    IO::Parts_sheet sheet(2);
    sheet.add(title, objects, split_parts(objects), {}, title);
    sheet.add(title, title);
    return text_of_output([&](std::ostream& out) { sheet.write(out); });
  };
  const std::string evil = "</script><b>\x1B\xFC\"";
  Structural_graph graph = chain(), harmless = graph;
  structure(graph).name = evil;
  Segmented_shape harmless_boxes("shape");
  for (std::size_t i = 0; i < 50; ++i) {
    structure(harmless).parts[i].name = "part " + std::to_string(i);
    harmless_boxes.add_part("part " + std::to_string(i), boxes().parts()[i].mesh);
  }
  structure(harmless).name = "shape";
  const std::tuple<const char*, std::string, std::string> pages[] = {
      {"match", page_of_match(graph, evil), page_of_match(harmless, "file")},
      {"parts", page_of_parts(boxes(), evil), page_of_parts(harmless_boxes, "file")}};
  for (const auto& [document, page, other] : pages) {
    INFO(document);
    CHECK(count(page, "<") == count(other, "<"));
    CHECK((IO::utf8_text(page) == page));
    const std::string data = nlohmann::json::parse(page_documents::document_of(page, document)).dump();
    for (const std::string& name : in_utf8(hostile_names())) {
      INFO(name);
      CHECK(data.find(nlohmann::json(name).dump()) != std::string::npos);
    }
  }
}

TEST_CASE("The terminal gets no control characters, by results, warnings and errors")
{
  const Temporary_folder folder;
  const std::string graph = quoted(folder.write(
      "g\x1B.json", text_of_output([](std::ostream& out) { IO::write_structural_graph_json(out, chain()); })));
  for (const std::string& arguments :
       {"graph " + graph, "match " + graph + " " + graph, "match " + graph + " missing\x1B",
        "match " + graph + " " + graph + " --source-parts \x1B"}) {
    INFO(arguments);
    const Run result = run(arguments);
    CHECK_FALSE(has_control(result.out + result.error));
    CHECK(result.out.size() + result.error.size() > 20);
  }
}

TEST_CASE("blend takes the program's own result for parts with names in Latin-1")
{
  const Temporary_folder folder;
  std::string text = obj_table();
  for (std::size_t at = text.find("leg_"); at != std::string::npos; at = text.find("leg_", at))
    text.replace(at, 4,
                 "F\xFC\xDF"
                 "e_");
  const std::string model = quoted(folder.write("T\xFCr.obj", text)), result = quoted(folder.path("r.json"));
  CHECK(run("match " + model + " " + model + " --json " + result).status == 0);
  const Run blend =
      run("blend " + model + " " + model + " --match " + result + " --frames 2 -o " + quoted(folder.path("f")));
  INFO(blend.error);
  CHECK(blend.status == 0);
}
