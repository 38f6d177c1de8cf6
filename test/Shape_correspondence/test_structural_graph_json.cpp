// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"
#include "model_files.h"
#include "structure/align_shapes.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>

using namespace CGAL::Shape_correspondence;
using Catch::Matchers::Contains;
using nlohmann::json;

namespace {

std::string written(const Structural_graph& graph)
{
  std::ostringstream out;
  IO::write_structural_graph_json(out, graph);
  return out.str();
}

Structural_graph read(const std::string& text, const Structure_options& options = {})
{
  std::istringstream in(text);
  return IO::read_structural_graph_json(in, "chair.json", options);
}

/// The error for a chair modified by `change`.
template <typename Change>
std::string complaint_after(Change&& change)
{
  json document = json::parse(written(hand_made::chair()));
  change(document);
  return model_files::complaint([&] { read(document.dump()); });
}

/// A graph with numbers that use all 53 bits of a double's significand.
Structural_graph crooked(const Structural_graph& graph)
{
  Structural_graph result = hand_made::moved(graph, 0.3, 1 / 3.0, Point(std::sqrt(2.0), 1e-17, -1e9));
  std::size_t i = 0;
  for (Part_abstraction& part : structure(result).parts) {
    part.volume = std::exp(-1.0 * i);
    part.hull_volume = std::exp(-0.9 * i);
    part.area = std::sqrt(1.0 + i++);
    part.report.residual = 1 / 7.0;
    part.report.method = i % 2 ? Abstraction_report::Method::MEDIAL_AXIS : Abstraction_report::Method::AXIS;
    part.report.repair = Abstraction_report::Repair::HOLES;
    part.report.tube = true;
    part.surface = 1e3 / 7 * Points::Random(3, surface_samples + 5);
  }
  return result;
}

bool same_parts(const Part_abstraction& a, const Part_abstraction& b)
{
  return a.name == b.name && a.is_sheet() == b.is_sheet() && a.is_closed_curve() == b.is_closed_curve() &&
         a.control_points() == b.control_points() && a.volume == b.volume && a.hull_volume == b.hull_volume &&
         a.area == b.area && a.surface.leftCols(surface_samples) == b.surface && a.report.method == b.report.method &&
         a.report.repair == b.report.repair && a.report.residual == b.report.residual &&
         a.report.tube == b.report.tube && a.report.blob == b.report.blob;
}

bool same_groups(const Part_group& a, const Part_group& b)
{
  return a.parts == b.parts && a.volume == b.volume && a.hull_volume == b.hull_volume &&
         a.symmetry.type == b.symmetry.type && a.symmetry.direction == b.symmetry.direction &&
         a.symmetry.order == b.symmetry.order &&
         (a.symmetry.type == Symmetry_type::NONE || a.symmetry.point == b.symmetry.point);
}

} // namespace

TEST_CASE("A graph that is written and read is the same to the bit")
{
  for (const Structural_graph& graph : {crooked(hand_made::chair()), crooked(hand_made::slatted_chair())}) {
    const std::string text = written(graph);
    const Structural_graph back = read(text);
    const Shape_structure &a = structure(graph), &b = structure(back);
    CHECK(a.name == b.name);
    CHECK(a.frame.origin == b.frame.origin);
    CHECK(a.frame.axes == b.frame.axes);
    CHECK(a.frame.height == b.frame.height);
    CHECK(a.frame.mirror_x == b.frame.mirror_x);
    REQUIRE(a.parts.size() == b.parts.size());
    for (std::size_t i = 0; i < a.parts.size(); ++i)
      CHECK(same_parts(a.parts[i], b.parts[i]));
    REQUIRE(num_vertices(graph) == num_vertices(back));
    for (std::size_t v = 0; v < num_vertices(graph); ++v)
      CHECK(same_groups(graph[v], back[v]));
    REQUIRE(a.contacts.size() == b.contacts.size());
    for (std::size_t i = 0; i < a.contacts.size(); ++i) {
      CHECK(a.contacts[i].parts == b.contacts[i].parts);
      CHECK(a.contacts[i].parameters == b.contacts[i].parameters);
    }
    CHECK(written(back) == text);
  }
}

TEST_CASE("Contacts of several regions are several entries")
{
  json document = json::parse(written(hand_made::chair()));
  const std::size_t contacts = document["contacts"].size();
  json again = document["contacts"][1];
  std::swap(again["parts"][0], again["parts"][1]);
  again["parameters"] = json::parse("[[0.25], [0.5, 0.75]]");
  document["contacts"].push_back(again);
  const Structural_graph graph = read(document.dump());
  REQUIRE(structure(graph).contacts.size() == contacts);
  const Contact& contact = structure(graph).contacts[1];
  REQUIRE(contact.further.size() == 1);
  CHECK(contact.further[0][0] == Eigen::Vector2d(0.5, 0.75));
  CHECK(contact.further[0][1] == Eigen::Vector2d(0.25, 0));
  CHECK(json::parse(written(graph))["contacts"].size() == contacts + 1);
}

TEST_CASE("The keys are those of the format")
{
  const json document = json::parse(written(hand_made::chair()));
  CHECK(document["format"] == "shape_correspondence/graph");
  CHECK(document["version"] == 1);
  CHECK(document["name"] == "chair");
  CHECK(document["up"] == json::array({0.0, 1.0, 0.0}));
  const json& seat = document["parts"][0];
  CHECK(seat["type"] == "sheet");
  CHECK(seat["grid"][1][0] == json::array({0.25, 0.5, -0.25}));
  const json& leg = document["parts"][2];
  CHECK(leg["type"] == "curve");
  CHECK(leg["closed"] == false);
  CHECK(leg["points"].size() == 2);
  CHECK_FALSE(leg.contains("surface")); // its surface is unknown
  CHECK(leg["abstraction"]["method"] == "given");
  CHECK(leg["abstraction"]["repair"] == "none");
  CHECK(leg["abstraction"]["coverage"] == 1.0);
  CHECK(leg["abstraction"]["flags"] == json::array());
  const json& legs = document["groups"][2];
  CHECK(legs["parts"] == json::array({"leg front left", "leg front right"}));
  CHECK(legs["symmetry"] == "reflection");
  CHECK(legs["plane"]["normal"] == json::array({1.0, 0.0, 0.0}));
  CHECK(document["groups"][0]["symmetry"] == "self");
  const json& contact = document["contacts"][1];
  CHECK(contact["parts"] == json::array({"seat", "leg front left"}));
  CHECK(contact["parameters"] == json::parse("[[1.0, 1.0], [1.0]]"));
}

TEST_CASE("The method of abstraction is written by its name, and older names are read, too")
{
  using Method = Abstraction_report::Method;
  const std::pair<const char*, Method> names[] = {{"skeleton", Method::SKELETON},
                                                  {"meso_skeleton", Method::MESO_SKELETON},
                                                  {"medial_axis", Method::MEDIAL_AXIS},
                                                  {"axis", Method::AXIS},
                                                  {"prism", Method::PRISM},
                                                  {"bounding_box", Method::BOUNDING_BOX},
                                                  {"copy", Method::COPY},
                                                  {"given", Method::GIVEN}};
  for (const auto& [name, method] : names) {
    Structural_graph graph = hand_made::chair();
    structure(graph).parts[0].report.method = method;
    const std::string text = written(graph);
    CHECK(json::parse(text)["parts"][0]["abstraction"]["method"] == name);
    CHECK(structure(read(text)).parts[0].report.method == method);
  }
  json document = json::parse(written(hand_made::chair()));
  const auto method_of = [&](const char* older_method, const char* fitted_to) {
    document["parts"][0]["abstraction"]["method"] = older_method;
    document["parts"][0]["abstraction"]["fitted_to"] = fitted_to;
    return structure(read(document.dump())).parts[0].report.method;
  };
  CHECK(method_of("meso_skeleton", "medial_axis") == Method::MEDIAL_AXIS);
  CHECK(method_of("skeleton", "revolution_axis") == Method::AXIS);
  CHECK_THAT(complaint_after([](json& d) { d["parts"][0]["abstraction"]["method"] = "magic"; }),
             Contains("parts[0].abstraction.method") && Contains("medial_axis"));
}

TEST_CASE("Missing entries are detected from the surfaces, unknown ones ignored")
{
  json document = json::parse(written(hand_made::chair()));
  for (const char* key : {"groups", "contacts", "frame", "up", "warnings"})
    document.erase(key);
  document["parts"][0].erase("volume");
  document["parts"][0].erase("abstraction");
  document["colour"] = "red";
  document["parts"][1]["mesh"] = "parts/back.obj";
  const Structural_graph graph = read(document.dump());
  CHECK(structure(graph).parts.size() == 6);
  CHECK(structure(graph).frame.axes.col(1) == Point::UnitY());
  CHECK(structure(graph).contacts.size() >= 5);
  CHECK(is_valid_structural_graph(graph));
}

TEST_CASE("Parts in no group of the file become groups of their own")
{
  json document = json::parse(written(hand_made::chair()));
  document["groups"].erase(0);
  const Structural_graph graph = read(document.dump());
  REQUIRE(num_vertices(graph) == 4);
  CHECK(graph[3].parts == std::vector<std::size_t>{0});
}

TEST_CASE("Without symmetry the groups of the file are not taken")
{
  Structure_options options;
  options.symmetry.enabled = false;
  CHECK(num_vertices(read(written(hand_made::chair()), options)) == 6);
}

TEST_CASE("Malformed graphs are refused with the place and the reason")
{
  CHECK_THAT(complaint_after([](json& d) { d["format"] = "other"; }), Contains("chair.json: format"));
  CHECK_THAT(complaint_after([](json& d) { d["version"] = 2; }), Contains("version") && Contains("2"));
  CHECK_THAT(complaint_after([](json& d) { d.erase("parts"); }), Contains("\"parts\""));
  CHECK_THAT(complaint_after([](json& d) { d = json::array(); }), Contains("not an object"));
  CHECK_THAT(complaint_after([](json& d) { d["parts"] = json::array({d["parts"][0]}); }), Contains("fewer than two"));
  CHECK_THAT(complaint_after([](json& d) { d["parts"][2]["points"][1][0] = "x"; }),
             Contains("parts[2].points[1][0] is not a number"));
  CHECK_THAT(complaint_after([](json& d) { d["parts"][2]["points"][1] = {1, 2}; }), Contains("parts[2].points[1]"));
  CHECK_THAT(complaint_after([](json& d) { d["parts"][2]["points"] = json::parse("[[0, 0, 0]]"); }),
             Contains("fewer than 2 points"));
  CHECK_THAT(complaint_after([](json& d) { d["parts"][2]["points"] = json::parse("[[0, 0, 0], [0, 0, 0]]"); }),
             Contains("same place"));
  CHECK_THAT(complaint_after([](json& d) { d["parts"][0]["grid"][1].erase(0); }), Contains("parts[0].grid[1]"));
  CHECK_THAT(complaint_after([](json& d) { d["parts"][0]["type"] = "solid"; }), Contains("curve, sheet"));
  CHECK_THAT(complaint_after([](json& d) { d["parts"][1]["name"] = "seat"; }), Contains("parts[1].name"));
  CHECK_THAT(complaint_after([](json& d) { d["parts"][1]["volume"] = -1; }), Contains("negative"));
  CHECK_THAT(complaint_after([](json& d) { d["groups"][0]["parts"][0] = "lid"; }), Contains("no part has that name"));
  CHECK_THAT(complaint_after([](json& d) { d["groups"][0]["parts"][0] = "back"; }), Contains("groups[1].parts[0]"));
  CHECK_THAT(complaint_after([](json& d) { d["groups"][2].erase("plane"); }), Contains("\"plane\""));
  CHECK_THAT(complaint_after([](json& d) { d["contacts"][0]["parts"][1] = "lid"; }), Contains("contacts[0].parts[1]"));
  CHECK_THAT(complaint_after([](json& d) { d["contacts"][0]["parts"][1] = "seat"; }), Contains("same part twice"));
  CHECK_THAT(complaint_after([](json& d) { d["contacts"][1]["parameters"][1][0] = 1.5; }), Contains("between 0 and 1"));
  CHECK_THAT(complaint_after([](json& d) { d["contacts"][1]["parameters"][0] = {0.5}; }), Contains("parameters[0]"));
  CHECK_THAT(complaint_after([](json& d) { d["up"] = {0, 0, 1}; }), Contains("frame.up"));
  CHECK_THAT(complaint_after([](json& d) { d["frame"]["height"] = 0; }), Contains("frame.height"));
  for (const char* text : {"", "{", "[1, NaN]", "hello", "{\"format\": 1e999}"}) {
    INFO(text);
    CHECK_THAT(model_files::complaint([&] { read(text); }), Contains("chair.json"));
  }
}
