// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/Gltf_document.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace CGAL::Shape_correspondence::IO {
namespace {

using Transform = Eigen::Affine3d;

/// What the indices of a primitive make.
enum Mode { POINTS, LINES, LOOP, LINE_STRIP, TRIANGLES, STRIP, FAN };

Transform transform_of(const Json_field& node)
{
  Transform result = Transform::Identity();
  if (node.has("matrix")) {
    const std::vector<Json_field> numbers = node["matrix"].elements(16, "a matrix of 16 numbers");
    for (int i = 0; i < 12; ++i)
      result(i % 3, i / 3) = numbers[std::size_t(i / 3 * 4 + i % 3)].number();
    return result;
  }
  if (node.has("translation")) result.translate(node["translation"].point());
  if (node.has("rotation")) {
    const std::vector<Json_field> q = node["rotation"].elements(4, "a quaternion [x, y, z, w]");
    result.rotate(Eigen::Quaterniond(q[3].number(), q[0].number(), q[1].number(), q[2].number()).normalized());
  }
  if (node.has("scale")) result.scale(node["scale"].point());
  return result;
}

/// The corners of the triangles of a strip or fan, or of triangles one by one, as numbers of its indices.
std::vector<std::size_t> corners_of(std::size_t mode, std::size_t indices)
{
  std::vector<std::size_t> result;
  const std::size_t step = mode == TRIANGLES ? 3 : 1;
  for (std::size_t i = 0; i + 2 < indices; i += step) {
    const bool is_turned = mode == STRIP && i % 2 == 1;
    result.insert(result.end(), {mode == FAN ? 0 : is_turned ? i + 1 : i, is_turned ? i : i + 1, i + 2});
  }
  return result;
}

/// The points or lines of a mesh that has no triangles.
std::size_t points_or_lines(std::size_t mode, std::size_t indices)
{
  return mode == LINES ? indices / 2 : mode == LINE_STRIP ? std::max<std::size_t>(indices, 1) - 1 : indices;
}

class Gltf_reader
{
public:
  Gltf_reader(Gltf_document& document) : document_(document) {}

  Model_content read(const std::string& file)
  {
    for (const Json_field& material : document_.list("materials"))
      add_material(material);
    visit_nodes();
    if (content_.parts.empty()) throw Invalid_input(file + ": there is no triangle in it; give every part a mesh");
    return std::move(content_);
  }

private:
  void add_material(const Json_field& of_file)
  {
    Surface_material material;
    if (of_file.has("name")) material.name = of_file["name"].text();
    const char* const glossiness = "KHR_materials_pbrSpecularGlossiness"; // of older exporters
    if (of_file.has("pbrMetallicRoughness"))
      read_colour(of_file["pbrMetallicRoughness"], "baseColor", material);
    else if (of_file.has("extensions") && of_file["extensions"].has(glossiness))
      read_colour(of_file["extensions"][glossiness], "diffuse", material);
    content_.materials.push_back(material);
  }

  void read_colour(const Json_field& looks, const std::string& name, Surface_material& material)
  {
    if (looks.has(name + "Factor")) {
      const std::vector<Json_field> channels = looks[name + "Factor"].elements(4, "a colour [red, green, blue, alpha]");
      for (int k = 0; k < 4; ++k)
        material.colour[k] = channels[std::size_t(k)].number();
    }
    if (looks.has(name + "Texture"))
      material.texture = texture(document_.element("textures", looks[name + "Texture"]["index"]));
  }

  /// \return -1 if its image is of a format of an extension
  int texture(const Json_field& of_file)
  {
    const std::optional<std::size_t> image = document_.index_at(of_file, "source", "images");
    if (!image) return -1;
    Texture_wrap wrap[2] = {Texture_wrap::REPEAT, Texture_wrap::REPEAT};
    if (of_file.has("sampler")) {
      const Json_field& sampler = document_.element("samplers", of_file["sampler"]);
      wrap[0] = wrap_at(sampler, "wrapS");
      wrap[1] = wrap_at(sampler, "wrapT");
    }
    const auto [found, is_new] =
        textures_.try_emplace({*image, wrap[0], wrap[1]}, static_cast<int>(content_.textures.size()));
    if (is_new) {
      content_.textures.push_back(texture_of_image(*image));
      content_.textures.back().wrap_u = wrap[0];
      content_.textures.back().wrap_v = wrap[1];
    }
    return found->second;
  }

  static Texture_wrap wrap_at(const Json_field& sampler, const char* key)
  {
    constexpr std::size_t repeat = 10497, clamp = 33071, mirror = 33648;
    const std::size_t code = Gltf_document::number_at(sampler, key, repeat);
    return code == clamp ? Texture_wrap::CLAMP : code == mirror ? Texture_wrap::MIRROR : Texture_wrap::REPEAT;
  }

  Texture texture_of_image(std::size_t index)
  {
    const Json_field& image = document_.list("images")[index];
    Texture result{image.has("name") ? image["name"].text() : "image " + std::to_string(index), "", {}};
    if (!image.has("uri")) {
      const std::string_view bytes = document_.bytes(document_.element("bufferViews", image["bufferView"]));
      document_.count(image, bytes.size() / sizeof(double));
      result.bytes = bytes;
    } else if (std::optional<std::string> data = Gltf_document::data_of_uri(image["uri"].text()))
      result.bytes = std::move(*data);
    else
      result.name = image["uri"].text();
    return result;
  }

  /// The nodes of the scene, or those in no other one where there is no scene.
  std::vector<std::size_t> roots()
  {
    const std::vector<Json_field>& scenes = document_.list("scenes");
    if (!scenes.empty())
      return children(scenes[document_.index_at(document_.root(), "scene", "scenes").value_or(0)], "nodes");
    const std::vector<Json_field>& nodes = document_.list("nodes");
    std::vector<bool> is_child(nodes.size());
    for (const Json_field& node : nodes)
      for (std::size_t child : children(node, "children"))
        is_child[child] = true;
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (!is_child[i]) result.push_back(i);
    return result;
  }

  std::vector<std::size_t> children(const Json_field& parent, const char* key)
  {
    std::vector<std::size_t> result;
    if (!parent.has(key)) return result;
    const Json_field list = parent[key];
    if (list.size() > document_.list("nodes").size()) list.fail("has more nodes than there are");
    for (const Json_field& child : list.elements())
      result.push_back(document_.index("nodes", child));
    return result;
  }
  /// Each, then those in it, in their order; without recursion, since a tree may be deep.
  void visit_nodes()
  {
    const std::vector<Json_field>& nodes = document_.list("nodes");
    std::vector<bool> added(nodes.size());
    std::vector<std::pair<std::size_t, Transform>> open;
    const auto add = [&](const std::vector<std::size_t>& indices, const Transform& parent) {
      for (auto i = indices.rbegin(); i != indices.rend(); ++i) {
        if (added[*i]) nodes[*i].fail("is in the tree of nodes twice, or in itself");
        added[*i] = true;
        open.emplace_back(*i, parent);
      }
    };
    add(roots(), Transform::Identity());
    while (!open.empty()) {
      const auto [index, parent] = open.back();
      open.pop_back();
      const Json_field& node = nodes[index];
      const Transform to_world = parent * transform_of(node);
      if (node.has("mesh")) add_part(node, to_world);
      add(children(node, "children"), to_world);
    }
    if (!document_.list("scenes").empty()) return; // nodes may be in no scene
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (!added[i]) nodes[i].fail("is in itself, or in one that is");
  }

  void add_part(const Json_field& node, const Transform& to_world)
  {
    const Json_field& mesh = document_.element("meshes", node["mesh"]);
    Model_part part;
    for (const Json_field& named : {node, mesh})
      if (part.name.empty() && named.has("name")) part.name = named["name"].text();
    for (const Json_field& primitive : mesh["primitives"].elements())
      add_primitive(primitive, to_world, part);
    if (!part.corners.empty()) content_.parts.push_back(std::move(part));
  }

  void add_primitive(const Json_field& primitive, const Transform& to_world, Model_part& part)
  {
    constexpr std::uint64_t numbers_of_primitive = 100, numbers_of_corner = 3; // a primitive takes time as 100 numbers
    document_.count(primitive, numbers_of_primitive);
    const Json_field attributes = primitive["attributes"];
    if (!attributes.has("POSITION")) return;
    const Eigen::MatrixXd points = document_.numbers(attributes["POSITION"], {"VEC3"});
    const std::vector<std::size_t> vertices = vertices_of(primitive, std::size_t(points.cols()), part.name);
    const std::size_t mode = Gltf_document::number_at(primitive, "mode", TRIANGLES);
    if (mode > FAN) primitive["mode"].fail("is " + std::to_string(mode) + ", which is none");
    if (mode < TRIANGLES) {
      content_.faces_left_out += points_or_lines(mode, vertices.size());
      return;
    }
    std::vector<std::size_t> corners = corners_of(mode, vertices.size());
    document_.count(primitive, numbers_of_corner * corners.size());
    document_.count_triangles(corners.size() / 3);
    for (std::size_t& corner : corners)
      corner = vertices[corner];
    add_looks(looks_of(primitive, attributes, corners, points.cols()), corners.size() / 3, part.corners.size() / 3,
              part.appearance);
    if (part.corners.empty()) part.corners.reserve(corners.size());
    for (std::size_t corner : corners)
      part.corners.push_back(to_world * Point(points.col(Eigen::Index(corner))));
  }

  std::vector<std::size_t> vertices_of(const Json_field& primitive, std::size_t points, const std::string& part)
  {
    std::vector<std::size_t> result;
    if (!primitive.has("indices")) {
      result.resize(points);
      std::iota(result.begin(), result.end(), std::size_t(0));
      return result;
    }
    const Eigen::MatrixXd indices = document_.numbers(primitive["indices"], {"SCALAR"});
    result.reserve(std::size_t(indices.cols()));
    for (double index : indices.row(0)) {
      if (!(index >= 0 && index < double(points)) || index != std::floor(index)) // nor is NaN
        primitive["indices"].fail("of part '" + part + "' has a vertex that is not one of the " +
                                  std::to_string(points));
      result.push_back(std::size_t(index));
    }
    return result;
  }

  Part_appearance looks_of(const Json_field& primitive, const Json_field& attributes,
                           const std::vector<std::size_t>& corners, Eigen::Index points)
  {
    const std::optional<std::size_t> material = document_.index_at(primitive, "material", "materials");
    Part_appearance result;
    result.materials.assign(corners.size() / 3, material ? int(*material) : -1);
    const auto read = [&](const char* name, std::initializer_list<const char*> types, auto add) {
      if (!attributes.has(name)) return;
      const Eigen::MatrixXd of_points = document_.numbers(attributes[name], types);
      if (of_points.cols() != points) attributes[name].fail("is not of as many vertices as POSITION");
      for (std::size_t corner : corners)
        add(of_points.col(Eigen::Index(corner)));
    };
    read("TEXCOORD_0", {"VEC2"}, [&](auto at) { result.coordinates.emplace_back(float(at[0]), float(at[1])); });
    read("COLOR_0", {"VEC3", "VEC4"},
         [&](auto colour) { result.colours.push_back(colour.template head<3>().template cast<float>()); });
    return result;
  }

  Gltf_document& document_;
  Model_content content_;
  std::map<std::tuple<std::size_t, Texture_wrap, Texture_wrap>, int> textures_; ///< by image
};

} // namespace

Model_content read_gltf_parts(std::string_view text, const std::string& file, const Reading_options& options)
{
  Gltf_document document(text, file, options);
  if (document.needs().empty()) return Gltf_reader(document).read(file);
  try {
    return import_parts(file, options);
  } catch (const Invalid_input& error) {
    std::string what = error.what(); // with a remedy
    const std::size_t end = what.rfind("; ");
    throw Invalid_input(what.insert(std::min(end, what.size()), " (it needs " + document.needs() + ")"));
  }
}

} // namespace CGAL::Shape_correspondence::IO
