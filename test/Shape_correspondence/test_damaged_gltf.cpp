// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gltf_models.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <numeric>
#include <random>

using namespace gltf_models;
using Catch::Matchers::Contains;

namespace {

/// The error for a tetrahedron with a value changed or removed.
std::string refused_with(const std::string& place, const json& value)
{
  Model model = tetrahedron();
  model.document[json::json_pointer(place)] = value;
  const std::string message = refused(model.glb());
  CHECK_THAT(message, Contains("input.glb"));
  return message;
}

} // namespace

TEST_CASE("Errors in a glTF document are reported with their place")
{
  CHECK(refused(tetrahedron().glb()).empty());
  CHECK_THAT(refused_with("/asset/version", "3.0"), Contains("version '3.0'"));
  CHECK_THAT(refused_with("/asset/version", 1), Contains("needs glTF 1.0"));
  CHECK_THAT(refused_with("/extensionsRequired/0", "EXT_unheard_of"), Contains("'EXT_unheard_of'"));
  CHECK_THAT(refused_with("/scene", 1), Contains("scene is 1, but there are 1 scenes"));
  CHECK_THAT(refused_with("/scenes/0/nodes/0", 4294967296), Contains("scenes[0].nodes[0] is beyond"));
  CHECK_THAT(refused_with("/scenes/0/nodes/1", 0), Contains("scenes[0].nodes has more nodes than there are"));
  CHECK_THAT(refused_with("/nodes/0/children", json::array({0})), Contains("nodes[0] is in the tree"));
  CHECK_THAT(refused_with("/nodes/0/mesh", -1), Contains("nodes[0].mesh is -1"));
  CHECK_THAT(refused_with("/nodes/0/matrix", {1, 2}), Contains("a matrix of 16 numbers"));
  CHECK_THAT(refused_with("/nodes/0/rotation", {1, 2, 3}), Contains("quaternion"));
  CHECK_THAT(refused_with("/nodes/0/translation", {1, 2, 1e300}), Contains("1e50"));
  CHECK_THAT(refused_with("/meshes/0/primitives/0/mode", 7), Contains("mode is 7"));
  CHECK_THAT(refused_with("/meshes/0/primitives/0/mode", 0), Contains("no triangle"));
  CHECK_THAT(refused_with("/meshes/0/primitives/0/material", 0), Contains("0 materials"));
  CHECK_THAT(refused_with("/meshes/0/primitives/0/attributes/POSITION", 2), Contains("2 accessors"));
  CHECK_THAT(refused_with("/meshes/0/primitives/0/attributes/POSITION", 1), Contains("VEC3 is expected"));
  CHECK_THAT(refused_with("/meshes/0/primitives/0/attributes/COLOR_0", 1), Contains("VEC3 is expected"));
  CHECK_THAT(refused_with("/accessors/0/count", 5), Contains("accessors[0] has 5 elements"));
  CHECK_THAT(refused_with("/accessors/0/count", 2147483647), Contains("200 million"));
  CHECK_THAT(refused_with("/accessors/0/count", -1), Contains("negative"));
  CHECK_THAT(refused_with("/accessors/0/count", 3), Contains("'seat'") && Contains("one of the 3"));
  CHECK_THAT(refused_with("/accessors/0/byteOffset", 2147483647), Contains("holds"));
  CHECK_THAT(refused_with("/accessors/0/bufferView", "0"), Contains("not a whole number"));
  CHECK_THAT(refused_with("/accessors/0/componentType", 5124), Contains("5124"));
  CHECK_THAT(refused_with("/bufferViews/0/byteStride", 11), Contains("byteStride"));
  CHECK_THAT(refused_with("/bufferViews/0/byteStride", 2147483647), Contains("holds"));
  CHECK_THAT(refused_with("/bufferViews/0/byteLength", 2000), Contains("bufferViews[0] ends beyond"));
  CHECK_THAT(refused_with("/bufferViews/0/buffer", 1), Contains("1 buffers"));
  Model model = tetrahedron();
  model.document["accessors"][0].erase("bufferView");
  CHECK_THAT(refused(model.glb()), Contains("without compression"));
  const auto with_buffer = [](const std::string& uri) {
    json document = tetrahedron().document;
    document["buffers"] = {{{"byteLength", 72}, {"uri", uri}}};
    return refused(document.dump());
  };
  CHECK_THAT(with_buffer("data:application/octet-stream;base64,AAAA"), Contains("only 3"));
  CHECK_THAT(with_buffer("data:application/octet-stream;base64,A*AA"), Contains("only 0"));
  CHECK_THAT(with_buffer("data:,AAAA"), Contains("only 0"));
  CHECK_THAT(with_buffer(std::string("a\0b", 3)), Contains("'a?b', which it names, is not there"));
  CHECK_THAT(with_buffer(std::string(100000, 'a')), Contains("aaa...', which it names"));
  CHECK_THAT(with_buffer("missing.bin"), Contains("'missing.bin', which it names, is not there"));
  CHECK_THAT(refused(tetrahedron().document.dump()), Contains("0 buffers"));
  Model infinite = tetrahedron();
  infinite.bytes.replace(0, 4, std::string("\0\0\x80\x7F", 4));
  CHECK_THAT(complaint([&] { infinite.read(); }), Contains("'seat'") && Contains("finite"));
}

TEST_CASE("Cycles of nodes are refused, also where no scene leads to them")
{
  Model model = tetrahedron();
  model.document["nodes"].push_back({{"mesh", 0}, {"children", {2}}});
  model.document["nodes"].push_back({{"mesh", 0}, {"children", {1}}});
  CHECK(model.read().parts().size() == 1);
  model.document.erase("scenes");
  CHECK_THAT(refused(model.glb()), Contains("nodes[1] is in itself"));
  model.document["nodes"][0]["children"] = {1};
  CHECK_THAT(refused(model.glb()), Contains("nodes[1] is in the tree"));
}

TEST_CASE("Counts and lists of a glTF file beyond its data take no memory")
{
  Model model = tetrahedron();
  const int indices = model.view(std::vector<std::uint16_t>{1}), values = model.view(std::vector<float>{1, 0, 0});
  json& points = model.document["accessors"][0];
  points.erase("bufferView");
  points["sparse"] = {{"count", 1},
                      {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                      {"values", {{"bufferView", values}}}};
  points["count"] = 1000000;
  CHECK(refused(model.glb()).empty());
  points["count"] = 33000000;
  CHECK_THAT(refused(model.glb()), Contains("accessors[0] has 33000000 elements, of which only 1"));
  CHECK_THAT(refused_with("/scenes/0/nodes", std::vector<int>(100000)), Contains("more nodes than there are"));
  CHECK_THAT(refused(R"({"asset": {"version": "2.0"}})" + std::string(std::size_t(256) << 20, ' ')),
             Contains("longer than 256 MB") && Contains("save it as GLB"));
}

TEST_CASE("A small glTF file that uses a mesh very often is refused within moments")
{
  Model model = tetrahedron();
  model.document["nodes"] = json::array();
  for (int i = 0; i < 30000; ++i)
    model.document["nodes"].push_back({{"mesh", 0}});
  model.document["scenes"][0]["nodes"] = json::array();
  for (int i = 0; i < 30000; ++i)
    model.document["scenes"][0]["nodes"].push_back(i);
  model.document["accessors"][1]["count"] = 4000;
  model.bytes.resize(model.bytes.size() + 10000, '\0');
  model.document["bufferViews"][1]["byteLength"] = 8000;
  const auto begin = std::chrono::steady_clock::now();
  CHECK_THAT(refused(model.glb()), Contains("use the same meshes"));
#ifndef __SANITIZE_THREAD__ // sanitized programs are too slow
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(20));
#endif
  model = tetrahedron();
  const json primitive = model.document["meshes"][0]["primitives"][0];
  model.document["nodes"] = json::array();
  for (int i = 0; i < 20000; ++i) // a chain of nodes
    model.document["nodes"].push_back({{"children", {i + 1}}});
  model.document["nodes"].push_back({{"mesh", 0}});
  CHECK(model.read().parts().size() == 1);
}

TEST_CASE("Nodes that repeat meshes may make at most a million more triangles than the file has bytes")
{
  constexpr std::size_t nodes = 1990;
  const auto with_triangles = [&](std::size_t triangles, std::size_t bytes) {
    Model model = tetrahedron();
    std::vector<std::uint16_t> indices;
    while (indices.size() < 3 * triangles)
      indices.insert(indices.end(), {0, 2, 1});
    model.document["meshes"][0]["primitives"][0]["indices"] = model.accessor(indices, 1);
    model.document["nodes"] = std::vector<json>(nodes, {{"mesh", 0}});
    std::vector<std::size_t> all(nodes);
    std::iota(all.begin(), all.end(), 0);
    model.document["scenes"][0]["nodes"] = all;
    model.bytes.resize(model.bytes.size() + bytes);
    return refused(model.glb());
  };
  CHECK(with_triangles(500, 0).empty());
  const auto begin = std::chrono::steady_clock::now();
  CHECK_THAT(with_triangles(4000, 0), Contains("input.glb") && Contains("use the same meshes") && Contains("simplify"));
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(20));
  CHECK(with_triangles(1000, 1000000).empty()); // two million triangles in a file of more than a million bytes
}

TEST_CASE("A GLB file that is cut off is refused, and one with any byte changed is read or refused")
{
  Model model = tetrahedron();
  model.document["nodes"][0]["translation"] = {1, 2, 3};
  const std::string glb = model.glb();
  for (std::size_t size = 0; size < glb.size(); ++size) {
    CAPTURE(size);
    CHECK_FALSE(refused(glb.substr(0, size)).empty());
  }
  std::mt19937 random(1);
  std::size_t good = 0;
  for (std::size_t i = 0; i < 20 * glb.size(); ++i) {
    std::string damaged = glb;
    damaged[i % glb.size()] = char(random());
    if (i >= 10 * glb.size()) damaged[random() % glb.size()] = "0123456789-,[]{}\":"[random() % 18];
    good += refused(damaged).empty();
  }
  CHECK(good > glb.size());
}
