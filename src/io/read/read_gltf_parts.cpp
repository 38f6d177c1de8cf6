// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "io/read/Gltf_document.h"
#include "io/read/model_parts.h"
#include "io/read/text_words.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace CGAL::Shape_correspondence::IO {
namespace {

using Transform = Eigen::Affine3d;

/// Kinds of primitives, by glTF's codes.
enum Mode { POINTS, LINES, LOOP, LINE_STRIP, TRIANGLES, STRIP, FAN };

Eigen::Affine2d place_of_texture(const Json_field& transform)
{
  const auto pair = [&](const char* key, double otherwise) {
    if (!transform.has(key)) return Eigen::Vector2d(otherwise, otherwise);
    const std::vector<Json_field> numbers = transform[key].elements(2, "two numbers");
    return Eigen::Vector2d(numbers[0].number(), numbers[1].number());
  };
  const double angle = transform.has("rotation") ? transform["rotation"].number() : 0;
  Eigen::Affine2d result = Eigen::Affine2d::Identity();
  result.translate(pair("offset", 0))
      .rotate(-angle)
      .scale(pair("scale", 1)); // the angle is counterclockwise, and v points down
  return result;
}

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

/// The corners of the triangles of a list, strip or fan, as positions in the primitive's indices.
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

/// The number of points or lines in a primitive without triangles.
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
    const Json_field& root = document_.root();
    is_written_ = root.has("asset") && root["asset"].has("generator") &&
                  begins_with(root["asset"]["generator"].text(), "Shape_correspondence ");
    for (const Json_field& material : document_.list("materials"))
      add_material(material);
    visit_nodes();
    if (content_.parts.empty()) throw Invalid_input(file + ": there is no triangle in it; give every part a mesh");
    content_.are_labelled = is_written_ && parts_written_ == content_.parts.size();
    if (!content_.are_labelled) name_parts_by_tree(tree_, node_of_part_, meshes_, content_.parts);
    content_.appearance_warnings = document_.appearance_warnings();
    return std::move(content_);
  }

private:
  /// The placement of a texture: its set of texture coordinates, and their transform.
  struct Place
  {
    std::size_t set = 0;
    Eigen::Affine2d transform = Eigen::Affine2d::Identity();
  };

  void add_material(const Json_field& of_file)
  {
    places_.emplace_back();
    Surface_material material;
    if (of_file.has("name")) material.name = of_file["name"].text();
    const char* const glossiness = "KHR_materials_pbrSpecularGlossiness"; // used by older exporters
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
    if (!looks.has(name + "Texture")) return;
    const Json_field of_texture = looks[name + "Texture"];
    material.texture = texture(document_.element("textures", of_texture["index"]));
    Place& place = places_.back();
    place.set = Gltf_document::number_at(of_texture, "texCoord", 0);
    const char* const extension = "KHR_texture_transform";
    if (!of_texture.has("extensions") || !of_texture["extensions"].has(extension)) return;
    const Json_field transform = of_texture["extensions"][extension];
    place.set = Gltf_document::number_at(transform, "texCoord", place.set);
    place.transform = place_of_texture(transform);
  }

  /// The index of a texture's image, or else of the image that an extension names, of which the format may be unknown.
  std::optional<std::size_t> image_of(const Json_field& texture)
  {
    std::optional<std::size_t> image = document_.index_at(texture, "source", "images");
    if (image || !texture.has("extensions")) return image;
    for (const char* name : {"EXT_texture_webp", "KHR_texture_basisu", "EXT_texture_avif", "MSFT_texture_dds"})
      if (!image && texture["extensions"].has(name))
        image = document_.index_at(texture["extensions"][name], "source", "images");
    return image;
  }

  /// The index in `content_` of a texture of the file; -1 if it has no image.
  int texture(const Json_field& of_file)
  {
    const std::optional<std::size_t> image = image_of(of_file);
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
      const std::string_view bytes = document_.bytes(image["bufferView"]);
      document_.count(image, bytes.size() / sizeof(double));
      result.bytes = bytes;
    } else if (std::optional<std::string> data = Gltf_document::data_of_uri(image["uri"].text()))
      result.bytes = std::move(*data);
    else
      result.name = image["uri"].text();
    return result;
  }

  /// The nodes of the scene; without a scene, the nodes without a parent.
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

  /// Visits the nodes depth-first, without recursion, since a tree may be deep.
  void visit_nodes()
  {
    const std::vector<Json_field>& nodes = document_.list("nodes");
    std::vector<bool> added(nodes.size());
    struct Open_node
    {
      std::size_t index;
      int parent; // index in `tree_`
      Transform of_parent;
    };
    std::vector<Open_node> open;
    const auto add = [&](const std::vector<std::size_t>& indices, int parent, const Transform& transform) {
      for (auto i = indices.rbegin(); i != indices.rend(); ++i) {
        if (added[*i]) nodes[*i].fail("is in the tree of nodes twice, or in itself");
        added[*i] = true;
        open.push_back({*i, parent, transform});
      }
    };
    add(roots(), -1, Transform::Identity());
    while (!open.empty()) {
      const Open_node next = open.back();
      open.pop_back();
      const Json_field& node = nodes[next.index];
      const Transform to_world = next.of_parent * transform_of(node);
      const int number = int(tree_.size());
      tree_.push_back({next.parent, node.has("name") ? node["name"].text() : ""});
      if (node.has("mesh"))
        for (const Transform& instance : instances_of(node)) {
          add_part(node, to_world * instance);
          node_of_part_.resize(content_.parts.size(), number);
        }
      add(children(node, "children"), number, to_world);
    }
    if (!document_.list("scenes").empty()) return; // nodes need not belong to a scene
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (!added[i]) nodes[i].fail("is in itself, or in one that is");
  }

  /// The transforms of a node's mesh: one, unless an extension gives several instances.
  std::vector<Transform> instances_of(const Json_field& node)
  {
    const char* const extension = "EXT_mesh_gpu_instancing";
    if (!node.has("extensions") || !node["extensions"].has(extension)) return {Transform::Identity()};
    const Json_field attributes = node["extensions"][extension]["attributes"];
    const auto columns = [&](const char* name, const char* type) -> std::optional<Eigen::MatrixXd> {
      if (!attributes.has(name)) return std::nullopt;
      return document_.numbers(attributes[name], {type});
    };
    const auto moves = columns("TRANSLATION", "VEC3"), turns = columns("ROTATION", "VEC4"),
               scales = columns("SCALE", "VEC3");
    std::vector<Transform> result(std::size_t(moves    ? moves->cols()
                                              : turns  ? turns->cols()
                                              : scales ? scales->cols()
                                                       : 1),
                                  Transform::Identity());
    if (result.size() > internal::most_parts) attributes.fail("are of " + internal::too_many_parts(result.size()));
    for (const auto* numbers : {&moves, &turns, &scales})
      if (*numbers && std::size_t((*numbers)->cols()) != result.size())
        attributes.fail("are not of as many instances each");
    for (std::size_t i = 0; i < result.size(); ++i) {
      const auto column = Eigen::Index(i);
      if (moves) result[i].translate(Point(moves->col(column)));
      if (turns) result[i].rotate(Eigen::Quaterniond(Eigen::Vector4d(turns->col(column))).normalized());
      if (scales) result[i].scale(Point(scales->col(column)));
    }
    return result;
  }

  void add_part(const Json_field& node, const Transform& to_world)
  {
    const Json_field& mesh = document_.element("meshes", node["mesh"]);
    Model_part part;
    if (node.has("name")) part.name = node["name"].text();
    const std::string mesh_name = mesh.has("name") ? mesh["name"].text() : "";
    if (part.name.empty()) part.name = mesh_name;
    for (const Json_field& primitive : mesh["primitives"].elements())
      add_primitive(primitive, to_world, part);
    if (part.corners.empty()) return content_.without_faces.push_back(part.name);
    parts_written_ += is_written_ && node.has("extras") && node["extras"].has("part");
    content_.parts.push_back(std::move(part));
    meshes_.push_back(mesh_name);
  }

  void add_primitive(const Json_field& primitive, const Transform& to_world, Model_part& part)
  {
    // Reading a primitive takes about as long as reading 100 numbers, and counts as much towards the limit
    constexpr std::uint64_t numbers_of_primitive = 100, numbers_of_corner = 3;
    document_.count(primitive, numbers_of_primitive);
    const std::optional<Eigen::MatrixXd> positions = document_.attribute(primitive, "POSITION", {"VEC3"});
    if (!positions) return;
    const Eigen::MatrixXd& points = *positions;
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
    add_appearance(appearance_of(primitive, corners, points.cols()), corners.size() / 3, part.corners.size() / 3,
                   part.appearance);
    if (part.corners.empty()) part.corners.reserve(corners.size());
    for (std::size_t corner : corners)
      part.corners.push_back(to_world * Point(points.col(Eigen::Index(corner))));
  }

  std::vector<std::size_t> vertices_of(const Json_field& primitive, std::size_t points, const std::string& part)
  {
    std::vector<std::size_t> result;
    const std::optional<Eigen::VectorXd> indices = document_.indices(primitive);
    if (!indices) {
      result.resize(points);
      std::iota(result.begin(), result.end(), std::size_t(0));
      return result;
    }
    result.reserve(std::size_t(indices->size()));
    for (double index : *indices) {
      if (!(index >= 0 && index < double(points)) || index != std::floor(index)) // NaN fails as well
        primitive["indices"].fail("of part '" + part + "' has a vertex that is not one of the " +
                                  std::to_string(points));
      result.push_back(std::size_t(index));
    }
    return result;
  }

  Part_appearance appearance_of(const Json_field& primitive, const std::vector<std::size_t>& corners,
                                Eigen::Index points)
  {
    const std::optional<std::size_t> material = document_.index_at(primitive, "material", "materials");
    Part_appearance result;
    result.materials.assign(corners.size() / 3, material ? int(*material) : -1);
    const auto read = [&](const std::string& name, std::initializer_list<const char*> types, auto add) {
      const std::optional<Eigen::MatrixXd> of_points = document_.attribute(primitive, name, types);
      if (!of_points) return;
      if (of_points->cols() != points) primitive["attributes"][name].fail("is not of as many vertices as POSITION");
      for (std::size_t corner : corners)
        add(of_points->col(Eigen::Index(corner)));
    };
    const Place place = material ? places_[*material] : Place();
    read("TEXCOORD_" + std::to_string(place.set), {"VEC2"}, [&](auto at) {
      result.coordinates.push_back((place.transform * Eigen::Vector2d(at)).template cast<float>());
    });
    read("COLOR_0", {"VEC3", "VEC4"},
         [&](auto colour) { result.colours.push_back(colour.template head<3>().template cast<float>()); });
    return result;
  }

  Gltf_document& document_;
  Model_content content_;
  std::vector<Place> places_;   ///< indexed by material
  std::vector<Tree_node> tree_; ///< each node after its parent
  std::vector<int> node_of_part_;
  bool is_written_ = false;         ///< whether the file was written by this program
  std::size_t parts_written_ = 0;   ///< number of nodes marked as parts
  std::vector<std::string> meshes_; ///< names of the parts' meshes
  std::map<std::tuple<std::size_t, Texture_wrap, Texture_wrap>, int>
      textures_; ///< indices of textures by image and wrap modes
};

} // namespace

Model_content read_gltf(std::string_view text, const std::string& file, const Reading_options& options,
                        const Gltf_codecs* codecs)
{
  Gltf_document document(text, file, options, codecs);
  return Gltf_reader(document).read(file);
}

} // namespace CGAL::Shape_correspondence::IO
