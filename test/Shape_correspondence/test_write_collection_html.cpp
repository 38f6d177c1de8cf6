// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"

#include <CGAL/Shape_correspondence/IO/write_collection_html.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <sstream>

using namespace CGAL::Shape_correspondence;
using nlohmann::json;

TEST_CASE("The page holds all shapes, their clusters, the tree and the maps, and needs no network")
{
  const std::vector<Structural_graph> graphs{hand_made::chair(), hand_made::table()};
  IO::Collection collection;
  collection.shapes = {{"a </script>", "a.obj", {"1", "2", "3", "4", "5", "6"}},
                       {"b", "b.obj", {"1", "2", "3", "4", "5"}}};
  collection.energies.resize(2, 2);
  collection.energies << 0, .25, .5, 0;
  collection.medoid = 1;
  collection.tree = {{0, 1}};
  collection.co_analysis = {{{0, Co_analysis::none, 1, 1, 1, 1}, {0, 1, 1, 1, 1}}, 2, 5, 0};
  std::ostringstream out;
  const std::vector<Shape_pair_map> maps{{0, 1, {{{0, 0}}, {.756}}}, {1, 0, {{{0, 0}}, {.756}}}};
  IO::write_collection_html(
      out, collection, [&](std::size_t i) { return graphs[i]; }, maps);
  const std::string page = out.str();
  CHECK(page.find("<!DOCTYPE html>") == 0);
  CHECK(page.find("src=\"http") == std::string::npos);
  const std::string begin = "id=\"data\">";
  const std::size_t at = page.find(begin) + begin.size();
  const json data = json::parse(page.substr(at, page.find("</script>", at) - at));
  CHECK(data["medoid"] == 1);
  CHECK(data["tree"].dump() == "[[0,1,0.375]]");
  CHECK(data["maps"].dump() == R"({"0,1":{"energies":[0.25,0.5],"pairs":[[0,0,76]]}})");
  REQUIRE(data["shapes"].size() == 2);
  CHECK(data["shapes"][0]["name"] == "a </script>");
  const json& parts = data["shapes"][1]["parts"];
  REQUIRE(parts.size() == 5);
  CHECK(parts[0]["name"] == "top");
  CHECK(parts[0]["label"] == 0);
  CHECK(parts[0]["columns"] == 4);
  CHECK(parts[0]["points"].size() == 16);
  CHECK(parts[1]["columns"] == 0);
  CHECK(parts[1]["points"].size() == 9);
  // The table is a cube: its corners are half a diagonal, 500 steps, from its middle
  CHECK(data["shapes"][1]["radius"].get<double>() == Approx(500).margin(1));
  CHECK(parts[1]["points"][0].dump() == "[-289,-289,-289]");
  CHECK(data["colours"].size() >= 2);
}
