// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "box_shapes.h"
#include "hand_made_graphs.h"
#include "model_files.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/IO/write_glb.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <Eigen/Geometry>

#include <cstdint>
#include <cstring>
#include <set>

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using nlohmann::json;

namespace {

std::uint32_t number_at(const std::string& bytes, std::size_t offset)
{
  std::uint32_t result = 0;
  for (int i = 3; i >= 0; --i)
    result = result << 8 | static_cast<unsigned char>(bytes.at(offset + i));
  return result;
}

float float_at(const std::string& bytes, std::size_t offset)
{
  const std::uint32_t bits = number_at(bytes, offset);
  float result;
  std::memcpy(&result, &bits, sizeof(result));
  return result;
}

struct Glb
{
  json document;
  std::string buffer;
};

/// Splits a GLB into its chunks, and checks the requirements of the specification.
Glb opened(const std::string& bytes)
{
  REQUIRE(bytes.substr(0, 4) == "glTF");
  REQUIRE(number_at(bytes, 4) == 2);
  REQUIRE(number_at(bytes, 8) == bytes.size());
  const std::uint32_t json_size = number_at(bytes, 12);
  REQUIRE(json_size % 4 == 0);
  REQUIRE(bytes.substr(16, 4) == "JSON");
  const std::size_t binary = 20 + json_size;
  REQUIRE(bytes.substr(binary + 4, 4) == std::string("BIN\0", 4));
  REQUIRE(number_at(bytes, binary) % 4 == 0);
  REQUIRE(binary + 8 + number_at(bytes, binary) == bytes.size());
  return {json::parse(bytes.substr(20, json_size)), bytes.substr(binary + 8)};
}

/// Where an accessor's elements begin in the buffer.
std::size_t offset_of(const Glb& glb, const json& accessor)
{
  const json& view = glb.document["bufferViews"][accessor["bufferView"].get<std::size_t>()];
  return view["byteOffset"].get<std::size_t>() + accessor["byteOffset"].get<std::size_t>();
}

/// Checks that accessors lie within their views and the buffer, and that their bounds hold.
void check_accessors(const Glb& glb)
{
  REQUIRE(glb.document["buffers"][0]["byteLength"] == glb.buffer.size());
  for (const json& accessor : glb.document["accessors"]) {
    const json& view = glb.document["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const std::size_t offset = offset_of(glb, accessor), count = accessor["count"];
    const std::size_t components = accessor["type"] == "VEC3" ? 3 : 1;
    const std::size_t bytes = accessor["componentType"] == 5123 ? 2 : 4; // 16-bit or 32-bit numbers
    REQUIRE(accessor["byteOffset"].get<std::size_t>() + count * components * bytes <= view["byteLength"]);
    REQUIRE((!view.contains("byteStride") || view["byteStride"] == components * bytes));
    REQUIRE(offset % bytes == 0);
    REQUIRE(offset + count * components * bytes <= glb.buffer.size());
    if (!accessor.contains("min")) continue;
    for (std::size_t i = 0; i < 3 * count; ++i) {
      const float value = float_at(glb.buffer, offset + 4 * i);
      REQUIRE(value >= accessor["min"][i % 3].get<float>());
      REQUIRE(value <= accessor["max"][i % 3].get<float>());
    }
  }
}

Point vector_at(const Glb& glb, int accessor, std::uint32_t index)
{
  const std::size_t offset = offset_of(glb, glb.document["accessors"][accessor]) + 12 * index;
  return Point(float_at(glb.buffer, offset), float_at(glb.buffer, offset + 4), float_at(glb.buffer, offset + 8));
}

/// Checks that normals are unit vectors on the front side of their triangles.
void check_normals(const Glb& glb)
{
  for (const json& mesh : glb.document["meshes"]) {
    for (const json& primitive : mesh["primitives"]) {
      if (primitive.value("mode", 4) == 1) continue; // mode 1: lines, which have no normals
      const int positions = primitive["attributes"]["POSITION"], normals = primitive["attributes"]["NORMAL"];
      const json& indices = glb.document["accessors"][primitive["indices"].get<int>()];
      const std::size_t offset = offset_of(glb, indices);
      for (std::size_t t = 0; t < indices["count"].get<std::size_t>(); t += 3) {
        std::uint32_t v[3];
        for (std::size_t k = 0; k < 3; ++k)
          v[k] = number_at(glb.buffer, offset + 2 * (t + k)) & 0xFFFF; // 16 bits for up to 2^16 - 2 points
        const Point a = vector_at(glb, positions, v[0]);
        const Point face = (vector_at(glb, positions, v[1]) - a).cross(vector_at(glb, positions, v[2]) - a);
        for (std::uint32_t i : v) {
          REQUIRE(vector_at(glb, normals, i).norm() == Approx(1));
          REQUIRE(face.dot(vector_at(glb, normals, i)) > -1e-9);
        }
      }
    }
  }
}

json colour_of(const Glb& glb, int parent, const std::string& name)
{
  const json& roots = glb.document["scenes"][0]["nodes"];
  for (const json& child : glb.document["nodes"][roots[parent].get<int>()]["children"]) {
    const json& node = glb.document["nodes"][child.get<int>()];
    if (node["name"] != name) continue;
    const json& primitive = glb.document["meshes"][node["mesh"].get<int>()]["primitives"][0];
    return glb.document["materials"][primitive["material"].get<int>()]["pbrMetallicRoughness"]["baseColorFactor"];
  }
  return nullptr;
}

Correspondence some_match()
{
  Correspondence c;
  c.pairs = {{0, 0}, {1, 1}, {1, 2}, {1, 3}, {2, 4}, {3, 5}};
  c.groups = {
      {{0}, {0}, Operation::MATCH, 0}, {{1}, {1, 2, 3}, Operation::SPLIT, 0}, {{2, 3}, {4, 5}, Operation::MATCH, 0}};
  c.unmatched_source = {4, 5};
  c.unmatched_target = {6, 7};
  return c;
}

Segmented_shape boxes_of(const Structural_graph& graph)
{
  Segmented_shape result(structure(graph).name);
  for (const Part_abstraction& part : structure(graph).parts)
    result.add_part(part.name, box_shapes::box(part.control_points().col(0), Point::Constant(0.1)));
  return result;
}

std::string picture(const Correspondence& c)
{
  std::ostringstream out;
  IO::write_correspondence_glb(out, c, hand_made::chair(), hand_made::slatted_chair());
  return out.str();
}

} // namespace

TEST_CASE("A picture of a correspondence is a valid GLB with the parts as nodes")
{
  const Glb glb = opened(picture(some_match()));
  check_accessors(glb);
  check_normals(glb);
  CHECK(glb.document["asset"]["version"] == "2.0");
  const json& roots = glb.document["scenes"][0]["nodes"];
  REQUIRE(roots.size() == 2);
  CHECK(glb.document["nodes"][roots[0].get<int>()]["name"] == "chair");
  CHECK(glb.document["nodes"][roots[0].get<int>()]["children"].size() == 6);
  CHECK(glb.document["nodes"][roots[1].get<int>()]["name"] == "slatted chair");
  CHECK(glb.document["nodes"][roots[1].get<int>()]["children"].size() == 8);
}

TEST_CASE("Further scenes hold the curves and sheets, and the contacts as lines, part by part")
{
  const Structural_graph source = hand_made::chair(), target = hand_made::slatted_chair();
  const Segmented_shape source_shape = boxes_of(source), target_shape = boxes_of(target);
  std::ostringstream out;
  IO::write_correspondence_glb(out, some_match(), source, target, &source_shape, &target_shape);
  const Glb glb = opened(out.str());
  check_accessors(glb);
  check_normals(glb);
  CHECK(glb.document["scene"] == 0);
  REQUIRE(glb.document["scenes"].size() == 3);
  const std::vector<std::string> layers{"surfaces", "curves and sheets", "contacts"};
  const auto node = [&](const json& index) { return glb.document["nodes"][index.get<std::size_t>()]; };
  for (std::size_t scene = 0; scene < 3; ++scene) {
    REQUIRE(glb.document["scenes"][scene]["nodes"].size() == 2);
    for (std::size_t side = 0; side < 2; ++side) {
      const Shape_structure& shape = structure(side == 0 ? source : target);
      const json root = node(glb.document["scenes"][scene]["nodes"][side]);
      CHECK(root["name"] == shape.name);
      CHECK(root["translation"] == node(glb.document["scenes"][0]["nodes"][side])["translation"]);
      CHECK(root["children"].size() == (scene < 2 ? shape.parts.size() : 1));
      for (std::size_t i = 0; i < root["children"].size(); ++i) {
        const json child = node(root["children"][i]);
        const json primitive = glb.document["meshes"][child["mesh"].get<std::size_t>()]["primitives"][0];
        CHECK(primitive["extras"]["layer"] == layers[scene]);
        CHECK(primitive.value("mode", 4) == (scene < 2 ? 4 : 1));
        if (scene < 2) CHECK(child["name"] == shape.parts[i].name);
        if (scene < 2) CHECK(child["extras"]["part"] == i);
        if (scene == 2) // three segments for each line
          CHECK(glb.document["accessors"][primitive["indices"].get<std::size_t>()]["count"] ==
                6 * shape.contacts.size());
      }
    }
  }
}

TEST_CASE("Corresponding parts have one colour, all others are grey")
{
  const Glb glb = opened(picture(some_match()));
  const json grey = colour_of(glb, 0, "leg hind left");
  CHECK(grey[0] == grey[1]);
  CHECK(grey[1] == grey[2]);
  CHECK(colour_of(glb, 1, "leg hind right") == grey);
  CHECK(colour_of(glb, 0, "seat") == colour_of(glb, 1, "seat"));
  CHECK(colour_of(glb, 0, "back") == colour_of(glb, 1, "slat 1"));
  CHECK(colour_of(glb, 0, "back") == colour_of(glb, 1, "slat 3"));
  // Symmetric parts, which the search treats as one group, have different colours
  const json left = colour_of(glb, 0, structure(hand_made::chair()).parts[2].name);
  const json right = colour_of(glb, 0, structure(hand_made::chair()).parts[3].name);
  CHECK(left == colour_of(glb, 1, structure(hand_made::slatted_chair()).parts[4].name));
  CHECK(right == colour_of(glb, 1, structure(hand_made::slatted_chair()).parts[5].name));
  const std::set<json> colours{grey, colour_of(glb, 0, "seat"), colour_of(glb, 0, "back"), left, right};
  CHECK(colours.size() == 5);
}

TEST_CASE("assimp reads the picture back: the source left, both upright")
{
  const Temporary_folder folder;
  Correspondence c = some_match();
  const auto bounds = [&](const std::string& part) {
    const Segmented_shape shape = IO::read_segmented_shape(folder.path("a.glb"));
    for (const Shape_part& p : shape.parts()) {
      if (p.name == part)
        return Eigen::AlignedBox3d(p.mesh.points.rowwise().minCoeff(), p.mesh.points.rowwise().maxCoeff());
    }
    throw std::runtime_error("no part " + part);
  };
  // Names must be unique to be read as one model
  Structural_graph source = hand_made::chair(), target = hand_made::chair();
  for (Part_abstraction& part : structure(target).parts)
    part.name += " of target";
  c = Correspondence();
  std::ostringstream out;
  IO::write_correspondence_glb(out, c, source, target);
  folder.write("a.glb", out.str());
  CHECK(bounds("leg front left").max().x() < bounds("leg front right of target").min().x());
  CHECK(bounds("back").min().y() > bounds("leg front left").min().y());
  CHECK(bounds("leg front left").center().z() > 0);

  c.target_quarter_turns = 1; // front +z goes to +x
  std::ostringstream turned;
  IO::write_correspondence_glb(turned, c, source, target);
  folder.write("a.glb", turned.str());
  CHECK(bounds("leg front left of target").center().x() > bounds("leg hind left of target").center().x());
}

TEST_CASE("A picture of a graph has faint surfaces, an abstraction for each part, and contacts")
{
  const Temporary_folder folder;
  const Segmented_shape shape = IO::read_segmented_shape(folder.write("table.obj", obj_table()));
  Shape_structure structure;
  structure.name = "table";
  for (const Shape_part& part : shape.parts())
    structure.parts.push_back(hand_made::curve(part.name, part.mesh.points.col(0), part.mesh.points.col(7)));
  for (std::size_t leg = 1; leg < 5; ++leg)
    structure.contacts.push_back({{0, leg}, {Eigen::Vector2d(0.5, 0), Eigen::Vector2d(1, 0)}, {}});
  const Structural_graph graph =
      make_structural_graph(structure, {hand_made::group({0}), hand_made::group({1, 2, 3, 4})});
  std::ostringstream out;
  IO::write_structural_graph_glb(out, graph, &shape);
  const Glb glb = opened(out.str());
  check_accessors(glb);
  check_normals(glb);
  std::set<std::string> names;
  for (const json& node : glb.document["nodes"])
    names.insert(node["name"].get<std::string>());
  CHECK(names == std::set<std::string>{"table", "top", "leg_1", "leg_2", "leg_3", "leg_4", "contacts"});
  int faint = 0;
  for (const json& material : glb.document["materials"])
    faint += material.value("alphaMode", "OPAQUE") == "BLEND";
  CHECK(faint == 2);
  std::ostringstream bare;
  IO::write_structural_graph_glb(bare, graph);
  check_accessors(opened(bare.str()));
}
