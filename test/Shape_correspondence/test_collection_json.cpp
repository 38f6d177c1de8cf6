// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/IO/collection_json.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <sstream>

using namespace CGAL::Shape_correspondence;
using nlohmann::json;

TEST_CASE("All that is found out about a collection is in its JSON, by names")
{
  IO::Collection collection;
  collection.shapes = {{"a", "a.obj", {"seat", "leg"}}, {"b", "b.obj", {"top"}}, {"c", "c.json", {"x", "y"}}};
  const Eigen::Matrix3d energies = (Eigen::Matrix3d() << 0, 1, 9, 3, 0, 1, 7, 1, 0).finished();
  collection.energy = [energies](std::size_t i, std::size_t j) { return energies(Eigen::Index(i), Eigen::Index(j)); };
  collection.medoid = 1;
  collection.tree = {{0, 1}, {1, 2}};
  collection.bridges = {{0, 2, {{{0, 1, 2}, 2}, 9, {{{1, 0, .5}}}}}};
  collection.bridge_count = 1;
  collection.co_analysis = {{{0, 1}, {0}, {Co_analysis::none, 1}}, 2, 5, 4};
  collection.co_analysis_shape_pairs = 3;
  collection.warnings = {"careful"};
  std::ostringstream out;
  IO::write_collection_json(out, collection);
  const json result = json::parse(out.str());
  CHECK(result["format"] == "shape_correspondence/collection");
  CHECK(result["version"] == 1);
  CHECK(result["shapes"][2] == json({{"name", "c"}, {"file", "c.json"}, {"parts", {"x", "y"}}}));
  CHECK(result["medoid"] == json({{"shape", "b"}, {"mean_distance", 1.5}}));
  CHECK(result["spanning_tree"][1] == json({{"shapes", {"b", "c"}}, {"distance", 1.}}));
  const json& bridge = result["bridges"][0];
  CHECK(bridge["chain"] == json({"a", "b", "c"}));
  CHECK(bridge["energy"] == 2);
  CHECK(bridge["direct_energy"] == 9);
  CHECK(bridge["pairs"] == json::array({json::array({"leg", "x"})}));
  CHECK(result["bridge_count"] == 1);
  CHECK(result["clusters"][0]["label"] == 0);
  CHECK(result["clusters"][0]["parts"].dump() == R"([["a","seat"],["b","top"]])");
  CHECK(result["clusters"][1]["parts"].dump() == R"([["a","leg"],["c","y"]])");
  CHECK(result["co_analysis"] == json({{"shape_pairs", 3}, {"part_pairs", 5}, {"rejected_part_pairs", 4}}));
  CHECK(result["energies"] == json({{0., 1., 9.}, {3., 0., 1.}, {7., 1., 0.}}));
  CHECK(result["warnings"] == json({"careful"}));
}

TEST_CASE("The nearest shapes with their pairs of parts by names")
{
  IO::Nearest_in_collection found;
  found.query = {"q", "q.obj", {"top", "leg"}};
  found.shapes = {{"a", "a.obj", {"seat"}}, {"b", "b.obj", {"x", "y"}}};
  found.nearest.shapes = {{1, .25, {{{0, 1, .5}, {1, 0, 1}}}, "chair"}};
  found.nearest.evaluations = 2;
  std::ostringstream out;
  IO::write_nearest_json(out, found);
  const json result = json::parse(out.str());
  CHECK(result["format"] == "shape_correspondence/nearest");
  CHECK(result["query"] == "q.obj");
  CHECK(result["evaluations"] == 2);
  CHECK(result["nearest"][0]["name"] == "b");
  CHECK(result["category"] == "");
  CHECK(result["nearest"][0]["category"] == "chair");
  CHECK(result["nearest"][0]["distance"] == .25);
  CHECK(result["nearest"][0]["pairs"].dump() == R"([["top","y"],["leg","x"]])");
}
