// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "box_shapes.h"
#include "hand_made_graphs.h"
#include "page_documents.h"

#include <CGAL/Shape_correspondence/IO/write_collection_html.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <sstream>

using namespace CGAL::Shape_correspondence;
using namespace page_documents;
using nlohmann::json;

namespace {

json glb_json(const std::string& page)
{
  const std::string glb = from_base64(document_of(page, "collection.glb"));
  std::size_t size = 0;
  for (int k = 3; k >= 0; --k)
    size = size << 8 | static_cast<unsigned char>(glb.at(12 + std::size_t(k)));
  return json::parse(glb.substr(20, size));
}

} // namespace

TEST_CASE("The page holds all shapes, their clusters, the tree and the maps, and needs no network")
{
  const std::vector<Structural_graph> graphs{hand_made::chair(), hand_made::table()};
  IO::Collection collection;
  collection.shapes = {{"a </script>", "a.obj", {"1", "2", "3", "4", "5", "6"}},
                       {"b", "b.obj", {"1", "2", "3", "4", "5"}}};
  collection.energy = [](std::size_t i, std::size_t j) { return i == j ? 0 : i < j ? .25 : .5; };
  collection.medoid = 1;
  collection.tree = {{0, 1}};
  collection.co_analysis = {{{0, Co_analysis::none, 1, 1, 1, 1}, {0, 1, 1, 1, 1}}, 2, 5, 0};
  std::ostringstream out;
  const std::vector<Shape_pair_map> maps{{0, 1, {{{0, 0, .756}}}}, {1, 0, {{{0, 0, .756}}}}};
  IO::write_collection_html(
      out, collection, [&](std::size_t i) { return graphs[i]; }, maps);
  const std::string page = out.str();
  CHECK(page.find("<!DOCTYPE html>") == 0);
  CHECK(page.find("<script src=") == std::string::npos);
  std::ostringstream same;
  IO::write_collection_json(same, collection);
  json shown = json::parse(same.str());
  for (const char* large : {"bridge_count", "bridges", "co_analysis", "clusters", "energies"})
    shown.erase(large);
  CHECK(json::parse(document_of(page, "collection")) == shown);
  const json stored = json::parse(document_of(page, "maps"));
  CHECK(stored["total"] == 2);
  CHECK(stored["operations"][0] == "match");
  CHECK(stored["labels"][1].size() == 5);
  CHECK(stored["maps"].dump() == R"({"0,1":[0.25,0.5,[[[0],[0],0,76]]]})");

  const json glb = glb_json(page);
  const json& roots = glb["scenes"][0]["nodes"];
  REQUIRE(roots.size() == 2);
  const auto material = [&](std::size_t shape, std::size_t part) {
    const json& root = glb["nodes"][roots[shape].get<std::size_t>()];
    const json& node = glb["nodes"][root["children"][part].get<std::size_t>()];
    const json& primitive = glb["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0];
    return glb["materials"][primitive["material"].get<std::size_t>()]["name"].get<std::string>();
  };
  CHECK(material(0, 0) == "cluster_1");
  CHECK(material(0, 1) == "none");
  CHECK(material(0, 2) == "cluster_2");
  CHECK(material(1, 0) == "cluster_1");
}

TEST_CASE("The page shows surfaces where there are models, of few triangles each")
{
  const std::vector<Structural_graph> graphs{hand_made::chair(), hand_made::chair()};
  const std::vector<std::string> names(6, "part");
  IO::Collection collection;
  collection.shapes = {{"a", "a.obj", names}, {"b", "b.obj", names}};
  collection.energy = [](std::size_t, std::size_t) { return 0; };
  collection.tree = {{0, 1}};
  collection.co_analysis = {{{0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}}, 1, 6, 0};
  const auto model = [&](std::size_t i) {
    std::optional<Segmented_shape> result;
    if (i == 1) return result;
    result.emplace("a");
    for (int part = 0; part < 6; ++part)
      result->add_part("part " + std::to_string(part), box_shapes::box(Point::Zero(), Point::Ones(), 0, 80));
    return result;
  };
  std::ostringstream out;
  IO::write_collection_html(
      out, collection, [&](std::size_t i) { return graphs[i]; }, {}, model);
  const json glb = glb_json(out.str());
  std::size_t triangles[2] = {0, 0};
  for (std::size_t shape : {0, 1}) {
    const json& root = glb["nodes"][glb["scenes"][0]["nodes"][shape].get<std::size_t>()];
    CHECK(root["extras"]["layer"] == (shape == 0 ? "surfaces" : "curves and sheets"));
    for (const json& child : root["children"]) {
      const json& mesh = glb["meshes"][glb["nodes"][child.get<std::size_t>()]["mesh"].get<std::size_t>()];
      triangles[shape] +=
          glb["accessors"][mesh["primitives"][0]["indices"].get<std::size_t>()]["count"].get<std::size_t>() / 3;
    }
  }
  CHECK(triangles[0] <= 200000); // the model has 460800
  CHECK(triangles[0] > 1000);
  CHECK(triangles[1] > 0);
}

TEST_CASE("Of very many shapes the page shows some of every branch of the tree, and says so")
{
  const Structural_graph chair = hand_made::chair();
  const std::size_t n = 2 * IO::largest_pictured + 5, half = n / 2;
  IO::Collection collection;
  collection.energy = [&](std::size_t i, std::size_t j) {
    return std::abs(double(i) - double(j)) / double(n) + ((i < half) != (j < half) ? 10 : 0);
  };
  for (std::size_t i = 0; i < n; ++i) {
    collection.shapes.push_back({"shape " + std::to_string(i), "", {"1", "2", "3", "4", "5", "6"}});
    collection.co_analysis.labels.push_back({0, 0, 0, 0, 0, 0});
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
  const std::string page = out.str();
  const json data = json::parse(document_of(page, "collection")), stored = json::parse(document_of(page, "maps"));
  CHECK(stored["total"] == n);
  CHECK(stored["maps"].size() == 1);
  CHECK(data["shapes"].size() == IO::largest_pictured);
  CHECK(data["spanning_tree"].size() + 1 == IO::largest_pictured);
  CHECK(data["medoid"]["shape"] == "shape " + std::to_string(collection.medoid));
  std::size_t first_half = 0;
  for (const json& shape : data["shapes"])
    first_half += std::stoul(shape["name"].get<std::string>().substr(6)) < half;
  CHECK(page.size() < 10 * IO::largest_pictured * 1000); // 10 kB for each shape
  CHECK(first_half > IO::largest_pictured / 3);
  CHECK(first_half < 2 * IO::largest_pictured / 3);
}
