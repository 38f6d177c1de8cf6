// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"

#include <CGAL/Shape_correspondence/IO/write_html.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <set>
#include <sstream>

using namespace CGAL::Shape_correspondence;
using nlohmann::json;

namespace {

/// The scene that a page shows.
json scene_of(const std::string& page)
{
  const std::string begin = "id=\"data\">", end = "</script>";
  const std::size_t from = page.find(begin) + begin.size();
  return json::parse(page.substr(from, page.find(end, from) - from));
}

std::string graph_page(const Structural_graph& graph)
{
  std::ostringstream out;
  IO::write_structural_graph_html(out, graph);
  return out.str();
}

} // namespace

TEST_CASE("The page of a graph needs no network")
{
  const std::string page = graph_page(hand_made::chair());
  CHECK(page.find("<!DOCTYPE html>") == 0);
  CHECK(page.find("http") == std::string::npos);
  CHECK(page.find("src=") == std::string::npos);
  CHECK(page.find("import ") == std::string::npos);
}

TEST_CASE("The page of a graph shows every part, a colour a group, and the contacts")
{
  const Structural_graph graph = hand_made::chair();
  const json scene = scene_of(graph_page(graph));
  const std::size_t parts = structure(graph).parts.size();
  CHECK(scene["things"].size() == parts);
  CHECK(scene["rows"].size() == parts);
  REQUIRE(scene["layers"].size() == parts + 1);
  CHECK(scene["layers"].back()["role"] == "contacts");
  std::set<std::string> colours;
  for (const json& row : scene["rows"])
    colours.insert(row["colour"].get<std::string>());
  CHECK(colours.size() == num_vertices(graph));
}

TEST_CASE("Names and warnings cannot break out of the page")
{
  Structural_graph graph = hand_made::chair();
  const std::string evil = "</script><script>alert('\"&\")</script>";
  structure(graph).name = structure(graph).parts[0].name = evil;
  structure(graph).warnings = {evil};
  const std::string page = graph_page(graph);
  CHECK(page.find("<script>alert") == std::string::npos);
  const json scene = scene_of(page);
  CHECK(scene["title"] == evil);
  CHECK(scene["notes"][1] == "Warning: " + evil);
}

TEST_CASE("A fallback shows its reason")
{
  Structural_graph graph = hand_made::chair();
  structure(graph).parts[0].report.fallback = "it is too hard";
  CHECK(graph_page(graph).find("it is too hard") != std::string::npos);
}

TEST_CASE("The page of a correspondence has a row a match, in the colour of its parts")
{
  const Structural_graph graph = hand_made::chair();
  const Correspondence correspondence = find_correspondence(graph, graph);
  std::ostringstream out;
  IO::write_correspondence_html(out, correspondence, graph, graph);
  const json scene = scene_of(out.str());
  const std::size_t parts = structure(graph).parts.size();
  CHECK(scene["layers"].size() == 2 * parts);
  std::size_t shown = 0;
  for (const json& row : scene["rows"])
    shown += row["things"].size();
  CHECK(shown == 2 * parts);
  CHECK(scene["heading"].size() == 2);
}
