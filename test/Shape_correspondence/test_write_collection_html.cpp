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
  const std::vector<Shape_pair_map> maps{{0, 1, {{{0, 0, .756}}}}, {1, 0, {{{0, 0, .756}}}}};
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

TEST_CASE("Of very many shapes the page shows some from every branch of the tree, and says so")
{
  const Structural_graph chair = hand_made::chair();
  const std::size_t n = 2 * IO::largest_pictured + 5, half = n / 2;
  IO::Collection collection;
  const auto distance = [&](std::size_t i, std::size_t j) { // two far chains
    return std::abs(double(i) - double(j)) / double(n) + ((i < half) != (j < half) ? 10 : 0);
  };
  collection.energies.resize(Eigen::Index(n), Eigen::Index(n));
  for (std::size_t i = 0; i < n; ++i) {
    collection.shapes.push_back({"shape " + std::to_string(i), "", {"1", "2", "3", "4", "5", "6"}});
    collection.co_analysis.labels.push_back({0, 0, 0, 0, 0, 0});
    for (std::size_t j = 0; j < n; ++j)
      collection.energies(Eigen::Index(i), Eigen::Index(j)) = distance(i, j);
    if (i > 0) collection.tree.emplace_back(i - 1, i);
  }
  collection.co_analysis.number_of_labels = 1;
  collection.medoid = half + 7;
  std::size_t drawn = 0;
  std::ostringstream out;
  const std::vector<Shape_pair_map> maps{{collection.medoid, collection.medoid, {{{0, 0, 1}}}}};
  const auto graph = [&](std::size_t) {
    ++drawn;
    return chair;
  };
  IO::write_collection_html(out, collection, graph, maps);
  CHECK(drawn == IO::largest_pictured);
  const std::string page = out.str(), begin = "id=\"data\">";
  const std::size_t at = page.find(begin) + begin.size();
  const json data = json::parse(page.substr(at, page.find("</script>", at) - at));
  CHECK(data["total"] == n);
  CHECK(data["shapes"].size() == IO::largest_pictured);
  CHECK(data["tree"].size() + 1 == IO::largest_pictured);
  CHECK(data["maps"].size() == 1);
  const std::size_t medoid = data["medoid"];
  CHECK(data["shapes"][medoid]["name"] == "shape " + std::to_string(collection.medoid));
  std::size_t first_half = 0;
  for (const json& shape : data["shapes"])
    first_half += std::stoul(shape["name"].get<std::string>().substr(6)) < half;
  CHECK(first_half > IO::largest_pictured / 3);
  CHECK(first_half < 2 * IO::largest_pictured / 3);
  CHECK(data["notes"].back().get<std::string>().find("Shown are 1000") == 0);
}
