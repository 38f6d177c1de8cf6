// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gltf_models.h"

#include <Eigen/Geometry>

#include <catch2/catch.hpp>

#ifdef SHAPE_CORRESPONDENCE_WITH_DRACO
#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>
#endif
#ifdef SHAPE_CORRESPONDENCE_WITH_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

using namespace gltf_models;
using Catch::Matchers::Contains;

TEST_CASE("Nodes of glTF are parts, moved by all nodes that they are in, and read by no other program")
{
  setenv("SHAPE_CORRESPONDENCE_IMPORT", "/nowhere", 1);
  Model model = tetrahedron();
  model.document["meshes"][0]["name"] = "wedge";
  const double half = std::sqrt(0.5);
  model.document["nodes"] = {
      {{"name", "base"}, {"translation", {10, 0, 0}}, {"children", {2, 1}}},
      {{"name", "leg"}, {"mesh", 0}},
      {{"matrix", {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 5, 0, 1}}, {"mesh", 0}, {"children", {3}}},
      {{"name", "leg"},
       {"rotation", {0, 0, half, half}},
       {"scale", {1, 3, 1}},
       {"translation", {1, 0, 0}},
       {"mesh", 0}}};
  const Segmented_shape shape = model.read();
  REQUIRE(shape.parts().size() == 3);
  CHECK(shape.parts()[0].name == "wedge");
  CHECK(shape.parts()[1].name == "leg");
  CHECK(shape.parts()[2].name == "leg#2");
  const auto lowest = [&](int part) { return Point(shape.parts()[part].mesh.points.rowwise().minCoeff()); };
  const auto highest = [&](int part) { return Point(shape.parts()[part].mesh.points.rowwise().maxCoeff()); };
  CHECK(lowest(0).isApprox(Point(10, 5, 0)));
  CHECK(highest(0).isApprox(Point(12, 7, 2)));
  CHECK(lowest(1).isApprox(Point(10 + 2 - 6, 5, 0))); // the rotation maps y to -x
  CHECK(highest(1).isApprox(Point(12, 7, 2)));
  CHECK(highest(2).isApprox(Point(11, 1, 1)));
  model.document["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
  model.document["scene"] = 1;
  CHECK(model.read().parts().size() == 1);
  model.document.erase("scenes");
  model.document.erase("scene");
  CHECK(model.read().parts().size() == 3);
  unsetenv("SHAPE_CORRESPONDENCE_IMPORT");
}

TEST_CASE("Indices of every size, strips, fans and triangles without indices are the same surface")
{
  const auto mesh_of = [](json primitive, Model model) {
    primitive["attributes"]["POSITION"] = model.accessor(corners, 3);
    model.add_mesh(primitive);
    model.document["nodes"] = {{{"mesh", 0}}};
    const Segmented_shape shape = model.read();
    CHECK(shape.parts()[0].name == "model");
    return shape.parts()[0].mesh;
  };
  const auto volume = [](const Part_mesh& mesh) {
    double sum = 0;
    for (const auto& t : mesh.triangles.colwise())
      sum += mesh.points.col(t[0]).dot(mesh.points.col(t[1]).cross(mesh.points.col(t[2])));
    return sum / 6;
  };
  const auto check = [&](const json& primitive, const Model& model) {
    const Part_mesh mesh = mesh_of(primitive, model);
    CHECK(mesh.points.cols() == 4);
    CHECK(mesh.triangles.cols() == 4);
    CHECK(volume(mesh) == Approx(1. / 6));
  };
  Model model;
  const std::uint32_t strip[] = {0, 2, 1, 3, 0, 2};
  check({{"indices", model.accessor(triangles<std::uint8_t>, 1)}}, model);
  check({{"indices", model.accessor(triangles<std::uint16_t>, 1)}}, model);
  check({{"indices", model.accessor(triangles<std::uint32_t>, 1)}}, model);
  check({{"mode", 5}, {"indices", model.accessor(std::vector<std::uint32_t>(strip, strip + 6), 1)}}, model);
  const Part_mesh fan = mesh_of({{"mode", 6}}, model);
  CHECK(fan.triangles == (Eigen::Matrix3Xi(3, 2) << 0, 0, 1, 2, 2, 3).finished());

  Model plain;
  std::vector<float> all;
  for (int corner : triangles<std::uint8_t>)
    all.insert(all.end(), corners.begin() + 3 * corner, corners.begin() + 3 * corner + 3);
  plain.add_mesh({{"attributes", {{"POSITION", plain.accessor(all, 3)}}}});
  plain.document["nodes"] = {{{"mesh", 0}}};
  CHECK(volume(plain.read().parts()[0].mesh) == Approx(1. / 6));
  plain.add_mesh({{"attributes", {{"POSITION", 0}}}, {"mode", 3}});
  plain.document["meshes"][0]["primitives"].push_back(plain.document["meshes"][1]["primitives"][0]);
  const Temporary_folder folder;
  std::vector<std::string> warnings;
  IO::read_segmented_shape(folder.write("a.glb", plain.glb()), Point::UnitY(), &warnings);
  CHECK(warnings == std::vector<std::string>{"Faces of fewer than three corners were left out: 11."});
}

TEST_CASE("Positions of glTF may be quantized, strided and sparse")
{
  const auto with_points = [](Model model, int points) {
    const int indices = model.accessor(triangles<std::uint16_t>, 1);
    model.add_mesh({{"attributes", {{"POSITION", points}}}, {"indices", indices}});
    model.document["nodes"] = {{{"mesh", 0}}};
    model.document["extensionsRequired"] = {"KHR_mesh_quantization", "KHR_materials_unlit"};
    return model;
  };
  const Points expected = tetrahedron().read().parts()[0].mesh.points;
  const auto check = [&](const auto one, bool is_normalized) {
    using Number = std::remove_const_t<decltype(one)>;
    Model model;
    const Number o = 0;
    const int points = model.accessor(std::vector<Number>{o, o, o, one, o, o, o, one, o, o, o, one}, 3, is_normalized);
    CHECK(with_points(model, points).read().parts()[0].mesh.points == expected);
  };
  check(std::int8_t(127), true);
  check(std::uint8_t(255), true);
  check(std::int16_t(32767), true);
  check(std::uint16_t(65535), true);
  check(std::int8_t(1), false);
  check(std::uint16_t(1), false);

  Model strided;
  std::vector<float> padded;
  for (std::size_t i = 0; i < corners.size(); i += 3)
    padded.insert(padded.end(), {9, corners[i], corners[i + 1], corners[i + 2], 9});
  int points = strided.accessor(padded, 1);
  strided.document["bufferViews"][0]["byteStride"] = 20;
  strided.document["accessors"][0].update({{"byteOffset", 4}, {"count", 4}, {"type", "VEC3"}});
  CHECK(with_points(strided, points).read().parts()[0].mesh.points == expected);

  for (bool has_base : {true, false}) {
    Model sparse;
    points = sparse.accessor(std::vector<float>(12, 0), 3);
    if (!has_base) sparse.document["accessors"][0].erase("bufferView");
    const int indices = sparse.view(std::vector<std::uint16_t>{1, 2, 3});
    const int values = sparse.view(std::vector<float>(corners.begin() + 3, corners.end()));
    sparse.document["accessors"][0]["sparse"] = {{"count", 3},
                                                 {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                                 {"values", {{"bufferView", values}}}};
    CHECK(with_points(sparse, points).read().parts()[0].mesh.points == expected);
    sparse.document["accessors"][0]["count"] = 3;
    CHECK_THAT(refused(with_points(sparse, points).glb()), Contains("beyond its accessor"));
  }
}

TEST_CASE("Materials of glTF have their colours, textures and wrap modes")
{
  Model model = tetrahedron();
  const std::string png = "\x89PNG\r\n\x1A\n";
  const int image = model.view(std::vector<char>(png.begin(), png.end()));
  model.document["images"] = {{{"bufferView", image}, {"mimeType", "image/png"}, {"name", "wood"}},
                              {{"uri", "data:image/png;base64,iVBORw0KGgo="}},
                              {{"uri", "missing.png"}}};
  model.document["samplers"] = {{{"wrapS", 33648}, {"wrapT", 33071}}};
  model.document["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 1}}, {{"source", 2}}, {{"sampler", 0}}};
  for (int texture = 0; texture < 4; ++texture)
    model.document["materials"].push_back(
        {{"name", "m"},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {0.5, 0.25, 1, 0.75}}, {"baseColorTexture", {{"index", texture}}}}}});
  model.document["materials"].push_back(
      {{"extensions", {{"KHR_materials_pbrSpecularGlossiness", {{"diffuseFactor", {0, 1, 0, 1}}}}}}});
  json& primitive = model.document["meshes"][0]["primitives"][0];
  primitive["material"] = 0;
  primitive["attributes"]["TEXCOORD_0"] =
      model.accessor(std::vector<std::uint8_t>{0, 0, 255, 0, 0, 255, 51, 51}, 2, true);
  primitive["attributes"]["COLOR_0"] =
      model.accessor(std::vector<float>{1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, 4);
  Shape_appearance looks;
  model.read(&looks);
  REQUIRE(looks.materials.size() == 5);
  CHECK(looks.materials[0].colour.isApprox(Eigen::Vector4d(0.5, 0.25, 1, 0.75)));
  CHECK(looks.materials[4].colour.isApprox(Eigen::Vector4d(0, 1, 0, 1)));
  REQUIRE(looks.textures.size() == 3);
  CHECK(looks.materials[3].texture == -1);
  CHECK(looks.textures[0].bytes == png);
  CHECK(looks.textures[1].bytes == png);
  CHECK(looks.textures[0].wrap_u == Texture_wrap::MIRROR);
  CHECK(looks.textures[0].wrap_v == Texture_wrap::CLAMP);
  CHECK(looks.textures[1].wrap_u == Texture_wrap::REPEAT);
  REQUIRE(looks.warnings.size() == 1);
  CHECK_THAT(looks.warnings[0], Contains("'missing.png'"));
  const Part_appearance& part = looks.parts[0];
  CHECK(part.materials == std::vector<int>(4, 0));
  REQUIRE(part.coordinates.size() == 12);
  CHECK(part.coordinates[1] == Eigen::Vector2f(0, 1)); // of vertex 2, the second corner of the first triangle
  CHECK(part.coordinates[5].isApprox(Eigen::Vector2f(0.2f, 0.2f)));
  CHECK(part.colours == std::vector<Eigen::Vector3f>(12, Eigen::Vector3f(1, 0, 0)));
}

TEST_CASE("Instances of a mesh are parts, whichever of translations, rotations and scales a file gives")
{
  Model model = tetrahedron();
  const float half = float(std::sqrt(0.5));
  const int moves = model.accessor(std::vector<float>{10, 0, 0, 20, 0, 0}, 3),
            turns = model.accessor(std::vector<float>{0, 0, half, half, 0, 0, 0, 1}, 4),
            few_turns = model.accessor(std::vector<std::int8_t>{0, 0, 127, 0}, 4, true),
            sizes = model.accessor(std::vector<float>{1, 1, 3, 2, 2, 2}, 3);
  const auto with = [&](const json& attributes, const char* list) {
    Model result = model;
    result.document["nodes"][0]["translation"] = {0, 5, 0};
    result.document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = attributes;
    result.document[list] = {"EXT_mesh_gpu_instancing"};
    return result;
  };
  const Segmented_shape all =
      with({{"TRANSLATION", moves}, {"ROTATION", turns}, {"SCALE", sizes}}, "extensionsRequired").read();
  REQUIRE(all.parts().size() == 2);
  CHECK(all.parts()[0].name == "seat");
  CHECK(all.parts()[1].name == "seat#2");
  const auto extent = [&](int part) {
    const Points& points = all.parts()[std::size_t(part)].mesh.points;
    return std::pair<Point, Point>(points.rowwise().minCoeff(), points.rowwise().maxCoeff());
  };
  CHECK(extent(0).first.isApprox(Point(9, 5, 0), 1e-6)); // the rotation maps y to -x
  CHECK(extent(0).second.isApprox(Point(10, 6, 3), 1e-6));
  CHECK(extent(1).second.isApprox(Point(22, 7, 2), 1e-6));
  CHECK(with({{"TRANSLATION", moves}}, "extensionsUsed").read().parts().size() == 2);
  CHECK(with({{"ROTATION", few_turns}}, "extensionsUsed").read().parts().size() == 1);
  CHECK(with({{"SCALE", sizes}}, "extensionsUsed").read().parts().size() == 2);
  CHECK(with(json::object(), "extensionsUsed").read().parts().size() == 1);
  CHECK_THAT(refused(with({{"TRANSLATION", moves}, {"ROTATION", few_turns}}, "extensionsUsed").glb()),
             Contains("nodes[0]") && Contains("not of as many instances"));
  Model many = tetrahedron();
  const int zeros = many.accessor(std::vector<float>(3 * 100000), 3);
  many.document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", zeros}};
  CHECK_THAT(refused(many.glb()), Contains("100000 parts") && Contains("join small parts"));
}

TEST_CASE("Textures are where their set of coordinates and their transform say")
{
  Model model = tetrahedron();
  json& primitive = model.document["meshes"][0]["primitives"][0];
  primitive["material"] = 0;
  const std::vector<float> first{0, 0, 1, 0, 0, 1, 1, 1}, second{0.5f, 0, 0.5f, 0, 0.5f, 0, 0.5f, 0};
  primitive["attributes"]["TEXCOORD_0"] = model.accessor(first, 2);
  primitive["attributes"]["TEXCOORD_1"] = model.accessor(second, 2);
  model.document["images"] = {{{"uri", "data:image/png;base64,iVBORw0KGgo="}}};
  model.document["textures"] = {{{"source", 0}}};
  const auto places = [&](const json& of_texture) {
    Model changed = model;
    json texture = of_texture;
    texture["index"] = 0;
    changed.document["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", texture}}}}};
    changed.document["extensionsRequired"] = {"KHR_texture_transform"};
    Shape_appearance looks;
    changed.read(&looks);
    const std::vector<Eigen::Vector2f>& at = looks.parts[0].coordinates; // coordinates of corners 0, 2, 1
    return std::vector<Eigen::Vector2f>{at[0], at[2], at[1]};
  };
  const auto are = [](const std::vector<Eigen::Vector2f>& found, const std::vector<Eigen::Vector2f>& expected) {
    for (std::size_t i = 0; i < 3; ++i)
      if (!(found[i] - expected[i]).isZero(1e-6f)) return false;
    return true;
  };
  const auto transform = [](json values) {
    return json{{"extensions", {{"KHR_texture_transform", std::move(values)}}}};
  };
  CHECK(are(places({}), {{0, 0}, {1, 0}, {0, 1}}));
  CHECK(are(places({{"texCoord", 1}}), {{0.5f, 0}, {0.5f, 0}, {0.5f, 0}}));
  CHECK(are(places(transform({{"offset", {0.5, 0.25}}})), {{0.5f, 0.25f}, {1.5f, 0.25f}, {0.5f, 1.25f}}));
  CHECK(are(places(transform({{"scale", {2, -3}}})), {{0, 0}, {2, 0}, {0, -3}}));
  CHECK(are(places(transform({{"rotation", std::acos(0)}})), {{0, 0}, {0, -1}, {1, 0}}));
  CHECK(are(places(transform({{"rotation", std::acos(0)}, {"scale", {2, 3}}, {"offset", {1, 0}}})),
            {{1, 0}, {1, -2}, {4, 0}}));
  CHECK(are(places(transform({{"texCoord", 1}, {"offset", {1, 0}}})), {{1.5f, 0}, {1.5f, 0}, {1.5f, 0}}));
  CHECK_THAT(complaint([&] { places(transform({{"offset", {1}}})); }), Contains("two numbers"));
}

TEST_CASE("Required extensions that describe looks only are left out, with warnings where looks are asked for")
{
  Model model = tetrahedron();
  model.document["meshes"][0]["primitives"][0]["material"] = 0;
  const std::string webp = "RIFF____WEBP";
  const int image = model.view(std::vector<char>(webp.begin(), webp.end()));
  model.document["images"] = {{{"bufferView", image}, {"mimeType", "image/webp"}, {"name", "cloth"}}};
  model.document["textures"] = {{{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}}};
  model.document["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  model.document["extensionsRequired"] = {"EXT_texture_webp", "KHR_materials_variants", "KHR_mesh_quantization"};
  Shape_appearance looks;
  CHECK(model.read(&looks).parts().size() == 1);
  REQUIRE(looks.warnings.size() == 2);
  CHECK_THAT(looks.warnings[0], Contains("'KHR_materials_variants'") && Contains("left out"));
  CHECK_THAT(looks.warnings[1], Contains("'cloth' was left out"));
}

TEST_CASE("Parts that are only numbered have the name of the node above that says more, or of their mesh")
{
  const auto names_of = [](const json& nodes, const json& roots) {
    Model model = tetrahedron();
    model.document["meshes"][0]["name"] = "wedge";
    model.document["nodes"] = nodes;
    model.document["scenes"][0]["nodes"] = roots;
    std::vector<std::string> result;
    const Segmented_shape shape = model.read();
    for (const Shape_part& part : shape.parts())
      result.push_back(part.name);
    return result;
  };
  using Names = std::vector<std::string>;
  const json root = {{"name", "chair"}, {"children", {1, 2, 3}}};
  const auto node = [](const char* name, std::vector<int> children) {
    return children.empty() ? json{{"name", name}, {"mesh", 0}} : json{{"name", name}, {"children", children}};
  };
  const auto named = [&](const char* a, const char* b, const char* c) {
    return names_of({root, node("leg.001_3", {4}), node("Group_2", {5}), node("rail", {6, 7}), node(a, {}), node(b, {}),
                     node(c, {}), node("Mesh.012", {})},
                    {0});
  };
  CHECK(named("Object_4", "arm", "node_3") == Names{"leg.001_3", "arm", "rail", "rail#2"});
  // `Object_5` is in `Group_2`, which only has a number, and in `chair`, which has all parts: its mesh names it
  CHECK(named("mesh17", "Object_5", "12") == Names{"leg.001_3", "wedge", "rail", "rail#2"});
  CHECK(named("Cube.001", "Object5b", "seat") == Names{"Cube.001", "Object5b", "seat", "rail"});
}

#ifdef SHAPE_CORRESPONDENCE_WITH_DRACO
TEST_CASE("Meshes that Draco compressed are read, also quantized ones")
{
  const auto compressed = [](auto one, bool is_normalized) {
    using Number = decltype(one);
    draco::Mesh mesh;
    mesh.set_num_points(4);
    const bool is_real = std::is_floating_point_v<Number>;
    draco::GeometryAttribute positions;
    positions.Init(draco::GeometryAttribute::POSITION, nullptr, 3, is_real ? draco::DT_FLOAT32 : draco::DT_INT16,
                   is_normalized, 3 * sizeof(Number), 0);
    const int id = mesh.AddAttribute(positions, true, 4);
    for (std::uint32_t v = 0; v < 4; ++v) {
      Number point[3];
      for (std::size_t k = 0; k < 3; ++k)
        point[k] = Number(corners[3 * v + k] * one);
      mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(v), point);
    }
    for (std::size_t t = 0; t < 12; t += 3) {
      draco::Mesh::Face face;
      for (std::size_t k = 0; k < 3; ++k)
        face[k] = draco::PointIndex(triangles<std::uint32_t>[t + k]);
      mesh.AddFace(face);
    }
    draco::EncoderBuffer buffer;
    draco::Encoder encoder;
    REQUIRE(encoder.EncodeMeshToBuffer(mesh, &buffer).ok());
    Model model = tetrahedron();
    const int view = model.view(std::vector<char>(buffer.data(), buffer.data() + buffer.size()));
    for (json& accessor : model.document["accessors"])
      accessor.erase("bufferView");
    if (!is_real) model.document["accessors"][0].update({{"componentType", 5122}, {"normalized", is_normalized}});
    model.document["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", view}, {"attributes", {{"POSITION", mesh.attribute(id)->unique_id()}}}};
    model.document["extensionsRequired"] = {"KHR_draco_mesh_compression", "KHR_mesh_quantization"};
    return model;
  };
  const auto check = [&](Model model) {
    const Segmented_shape shape = model.read();
    REQUIRE(shape.parts().size() == 1);
    CHECK(shape.parts()[0].name == "seat");
    const Part_mesh& mesh = shape.parts()[0].mesh;
    CHECK(mesh.triangles.cols() == 4);
    CHECK(mesh.points.rowwise().minCoeff().isZero(1e-3));
    CHECK(mesh.points.rowwise().maxCoeff().isApprox(Point::Ones(), 1e-3));
  };
  check(compressed(1.f, false));
  check(compressed(std::int16_t(32767), true));
  check(compressed(std::int16_t(1), false));
  Model damaged = compressed(1.f, false);
  const std::size_t begin = damaged.document["bufferViews"].back()["byteOffset"];
  damaged.bytes.replace(begin, 4, "XXXX");
  CHECK_THAT(complaint([&] { damaged.read(); }), Contains("Draco") && Contains("without compression"));
  damaged = compressed(1.f, false);
  damaged.document["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"]["attributes"]["POSITION"] =
      7;
  CHECK_THAT(complaint([&] { damaged.read(); }), Contains("POSITION is none of the attributes"));
  setenv("SHAPE_CORRESPONDENCE_IMPORT", "/nowhere", 1);
  CHECK_THAT(refused(compressed(1.f, false).glb()), Contains("needs the extension KHR_draco_mesh_compression"));
  unsetenv("SHAPE_CORRESPONDENCE_IMPORT");
}
#endif

#ifdef SHAPE_CORRESPONDENCE_WITH_MESHOPTIMIZER
TEST_CASE("Buffer views that meshoptimizer compressed are read")
{
  const auto compressed = [] {
    Model model = tetrahedron();
    const auto pack = [&](int view, std::vector<unsigned char> bytes, const json& description) {
      const int packed = model.view(bytes);
      json extension = model.document["bufferViews"][packed];
      model.document["bufferViews"].erase(packed);
      extension.update(description);
      model.document["bufferViews"][view]["extensions"]["EXT_meshopt_compression"] = extension;
      model.document["bufferViews"][view]["buffer"] = 1; // an empty buffer
    };
    std::vector<unsigned char> points(meshopt_encodeVertexBufferBound(4, 12)),
        faces(meshopt_encodeIndexBufferBound(12, 4));
    points.resize(meshopt_encodeVertexBuffer(points.data(), points.size(), corners.data(), 4, 12));
    const std::vector<unsigned>& indices = triangles<unsigned>;
    faces.resize(meshopt_encodeIndexBuffer(faces.data(), faces.size(), indices.data(), indices.size()));
    pack(0, points, {{"mode", "ATTRIBUTES"}, {"count", 4}, {"byteStride", 12}});
    pack(1, faces, {{"mode", "TRIANGLES"}, {"count", 12}, {"byteStride", 2}});
    model.document["extensionsRequired"] = {"EXT_meshopt_compression"};
    return model;
  };
  const Part_mesh mesh = compressed().read().parts()[0].mesh;
  CHECK(mesh.triangles.cols() == 4);
  CHECK(mesh.points.rowwise().maxCoeff() == Point::Ones());
  const auto changed = [&](const char* key, const json& value) {
    Model model = compressed();
    model.document["bufferViews"][0]["extensions"]["EXT_meshopt_compression"][key] = value;
    return complaint([&] { model.read(); });
  };
  CHECK_THAT(changed("mode", "OTHER"), Contains("cannot be decompressed"));
  CHECK_THAT(changed("filter", "QUATERNION"), Contains("cannot be decompressed"));
  CHECK_THAT(changed("byteStride", 6), Contains("cannot be decompressed"));
  CHECK_THAT(changed("byteStride", 0), Contains("byteStride"));
  CHECK_FALSE(changed("count", 3).empty());
  CHECK_THAT(changed("count", 2147483647), Contains("200 million"));
  CHECK_THAT(changed("byteLength", 3), Contains("cannot be decompressed"));
}
#endif
