// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write/glb_builder.h"
#include "io/system/image_file.h"

#include <CGAL/Shape_correspondence/version.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <ostream>

namespace CGAL::Shape_correspondence::IO {
namespace {

// Numbers of the glTF 2.0 specification
constexpr int component_uint32 = 5125, component_float = 5126;
constexpr int target_vertices = 34962, target_indices = 34963, no_target = 0;
constexpr int mode_lines = 1;                         // triangles need none
constexpr int wrap_numbers[] = {10497, 33648, 33071}; // of Texture_wrap
constexpr std::uint32_t magic = 0x46546C67, chunk_json = 0x4E4F534A, chunk_binary = 0x004E4942;

void append_uint32(std::string& bytes, std::uint32_t value)
{
  for (int shift = 0; shift < 32; shift += 8)
    bytes.push_back(static_cast<char>((value >> shift) & 0xFF));
}

void append_float(std::string& bytes, float value)
{
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  append_uint32(bytes, bits);
}

void pad(std::string& bytes, char filler) { bytes.resize((bytes.size() + 3) / 4 * 4, filler); }

void append_chunk(std::string& bytes, std::uint32_t type, const std::string& content)
{
  append_uint32(bytes, static_cast<std::uint32_t>(content.size()));
  append_uint32(bytes, type);
  bytes += content;
}

Json components(const Eigen::Vector3f& v) { return {v.x(), v.y(), v.z()}; }

} // namespace

Glb_builder::Glb_builder()
{
  document_["asset"] = {{"version", "2.0"}, {"generator", "Shape_correspondence " CGAL_SHAPE_CORRESPONDENCE_VERSION}};
  document_["scene"] = 0;
  for (const char* list :
       {"scenes", "nodes", "meshes", "materials", "textures", "images", "samplers", "accessors", "bufferViews"})
    document_[list] = Json::array();
}

int Glb_builder::add_material(const std::string& name, const Eigen::Vector3d& colour, double alpha)
{
  Json material;
  material["name"] = name;
  material["pbrMetallicRoughness"] = {{"baseColorFactor", {colour.x(), colour.y(), colour.z(), alpha}},
                                      {"metallicFactor", 0.0},
                                      {"roughnessFactor", 0.7}};
  material["doubleSided"] = true;
  if (alpha < 1) material["alphaMode"] = "BLEND";
  document_["materials"].push_back(material);
  return static_cast<int>(document_["materials"].size()) - 1;
}

int Glb_builder::add_texture(const Texture& texture)
{
  const Json view = {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", texture.bytes.size()}};
  const int image = static_cast<int>(document_["images"].size()),
            sampler = static_cast<int>(document_["samplers"].size());
  document_["images"].push_back(Json{{"name", texture.name},
                                     {"mimeType", is_png(texture.bytes) ? "image/png" : "image/jpeg"},
                                     {"bufferView", document_["bufferViews"].size()}});
  document_["bufferViews"].push_back(view);
  buffer_ += texture.bytes;
  pad(buffer_, '\0');
  document_["samplers"].push_back(
      Json{{"wrapS", wrap_numbers[int(texture.wrap_u)]}, {"wrapT", wrap_numbers[int(texture.wrap_v)]}});
  document_["textures"].push_back(Json{{"source", image}, {"sampler", sampler}});
  return static_cast<int>(document_["textures"].size()) - 1;
}

int Glb_builder::add_material(const Surface_material& material, int texture)
{
  const int result = add_material(material.name, material.colour.head<3>(), material.colour[3]);
  if (texture >= 0) document_["materials"].back()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", texture}};
  return result;
}

int Glb_builder::add_node(const std::string& name, const std::vector<std::pair<Drawn_mesh, int>>& meshes)
{
  Json primitives = Json::array();
  for (const auto& [mesh, material] : meshes) {
    if (!mesh.empty()) primitives.push_back(primitive(mesh, material));
  }
  Json node = {{"name", name}};
  if (!primitives.empty()) {
    node["mesh"] = document_["meshes"].size();
    document_["meshes"].push_back(Json{{"name", name}, {"primitives", primitives}});
  }
  document_["nodes"].push_back(node);
  return static_cast<int>(document_["nodes"].size()) - 1;
}

int Glb_builder::add_node(const std::string& name, const std::vector<int>& children, const Point& translation)
{
  Json node = {{"name", name}};
  if (!children.empty()) node["children"] = children;
  node["translation"] = {translation.x(), translation.y(), translation.z()};
  document_["nodes"].push_back(node);
  return static_cast<int>(document_["nodes"].size()) - 1;
}

int Glb_builder::add_morphing_node(const std::string& name, const std::vector<Morphing_mesh>& meshes)
{
  Json primitives = Json::array();
  for (const Morphing_mesh& mesh : meshes) {
    primitives.push_back(
        primitive({mesh.shapes[0], {}, mesh.triangles, {}, {}, mesh.coordinates, mesh.colours}, mesh.material));
    for (std::size_t i = 1; i < mesh.shapes.size(); ++i)
      primitives.back()["targets"].push_back(Json{{"POSITION", add_vectors(mesh.shapes[i] - mesh.shapes[0], true)}});
  }
  const std::vector<double> weights(meshes[0].shapes.size() - 1, 0.);
  const int node = add_node(name, {});
  document_["nodes"].back()["mesh"] = document_["meshes"].size();
  document_["meshes"].push_back(Json{{"name", name}, {"primitives", primitives}});
  if (!weights.empty()) document_["meshes"].back()["weights"] = weights;
  return node;
}

void Glb_builder::animate_shapes(int node, const std::vector<double>& times)
{
  if (times.size() < 2) return;
  std::vector<double> weights;
  for (std::size_t key = 0; key < times.size(); ++key)
    for (std::size_t shape = 1; shape < times.size(); ++shape)
      weights.push_back(shape == key ? 1 : 0);
  add_channel(node, "weights", "LINEAR", add_numbers(times, "SCALAR", 1, true),
              add_numbers(weights, "SCALAR", 1, false));
}

void Glb_builder::animate_visibility(int node, double begin, double end)
{
  std::vector<double> times = {begin, end}, sizes = {1, 1, 1, 0, 0, 0};
  if (begin > 0) {
    times.insert(times.begin(), 0);
    sizes.insert(sizes.begin(), 3, 0);
    document_["nodes"][static_cast<std::size_t>(node)]["scale"] = {0, 0, 0};
  }
  add_channel(node, "scale", "STEP", add_numbers(times, "SCALAR", 1, true), add_numbers(sizes, "VEC3", 3, false));
}

void Glb_builder::add_channel(int node, const char* path, const char* interpolation, int times, int values)
{
  if (!document_.contains("animations"))
    document_["animations"] = Json::array({Json{{"channels", Json::array()}, {"samplers", Json::array()}}});
  Json& animation = document_["animations"][0];
  animation["channels"].push_back(
      Json{{"sampler", animation["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
  animation["samplers"].push_back(Json{{"input", times}, {"output", values}, {"interpolation", interpolation}});
}

Json Glb_builder::primitive(const Drawn_mesh& mesh, int material)
{
  const bool has_triangles = mesh.triangles.cols() > 0;
  Json result;
  result["attributes"]["POSITION"] = add_vectors(mesh.points, true);
  if (mesh.normals.cols() > 0) result["attributes"]["NORMAL"] = add_vectors(mesh.normals, false);
  if (!mesh.coordinates.empty()) result["attributes"]["TEXCOORD_0"] = add_attribute(mesh.coordinates, "VEC2");
  if (!mesh.colours.empty()) result["attributes"]["COLOR_0"] = add_attribute(mesh.colours, "VEC3");
  result["indices"] = has_triangles ? add_indices(mesh.triangles.data(), mesh.triangles.size())
                                    : add_indices(mesh.lines.data(), mesh.lines.size());
  result["material"] = material;
  if (!has_triangles) result["mode"] = mode_lines;
  if (!mesh.layer.empty()) result["extras"] = {{"layer", mesh.layer}};
  return result;
}

int Glb_builder::add_vectors(const Points& vectors, bool with_bounds)
{
  const Eigen::Matrix3Xf values = vectors.cast<float>();
  std::string bytes;
  for (Eigen::Index i = 0; i < values.size(); ++i)
    append_float(bytes, values.data()[i]);
  Json accessor = {{"componentType", component_float}, {"count", values.cols()}, {"type", "VEC3"}};
  if (with_bounds) {
    accessor["min"] = components(values.rowwise().minCoeff());
    accessor["max"] = components(values.rowwise().maxCoeff());
  }
  return add_accessor(bytes, target_vertices, accessor);
}

template <typename Vectors>
int Glb_builder::add_attribute(const Vectors& vectors, const char* type)
{
  std::string bytes;
  for (const auto& vector : vectors)
    for (float value : vector)
      append_float(bytes, value);
  return add_accessor(bytes, target_vertices,
                      {{"componentType", component_float}, {"count", vectors.size()}, {"type", type}});
}

int Glb_builder::add_indices(const int* indices, Eigen::Index count)
{
  std::string bytes;
  for (Eigen::Index i = 0; i < count; ++i)
    append_uint32(bytes, static_cast<std::uint32_t>(indices[i]));
  return add_accessor(bytes, target_indices,
                      {{"componentType", component_uint32}, {"count", count}, {"type", "SCALAR"}});
}

int Glb_builder::add_numbers(const std::vector<double>& numbers, const char* type, int components, bool with_bounds)
{
  std::string bytes;
  for (double number : numbers)
    append_float(bytes, static_cast<float>(number));
  Json accessor = {{"componentType", component_float},
                   {"count", numbers.size() / static_cast<std::size_t>(components)},
                   {"type", type}};
  if (with_bounds) {
    const auto [least, greatest] = std::minmax_element(numbers.begin(), numbers.end());
    accessor["min"] = {static_cast<float>(*least)};
    accessor["max"] = {static_cast<float>(*greatest)};
  }
  return add_accessor(bytes, no_target, accessor);
}

int Glb_builder::add_accessor(const std::string& bytes, int target, Json accessor)
{
  accessor["bufferView"] = document_["bufferViews"].size();
  document_["bufferViews"].push_back(Json{{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}});
  if (target != no_target) document_["bufferViews"].back()["target"] = target;
  buffer_ += bytes;
  document_["accessors"].push_back(accessor);
  return static_cast<int>(document_["accessors"].size()) - 1;
}

void Glb_builder::set_node_extras(int node, Json extras)
{
  document_["nodes"][static_cast<std::size_t>(node)]["extras"] = std::move(extras);
}

void Glb_builder::set_animation_extras(Json extras)
{
  if (document_.contains("animations")) document_["animations"][0]["extras"] = std::move(extras);
}

void Glb_builder::write(std::ostream& out, const std::vector<Glb_scene>& scenes) const
{
  Json document = document_;
  for (const Glb_scene& scene : scenes)
    document["scenes"].push_back(Json{{"name", scene.name}, {"nodes", scene.roots}});
  if (!buffer_.empty()) document["buffers"] = Json::array({Json{{"byteLength", buffer_.size()}}});
  for (const char* list : {"meshes", "materials", "textures", "images", "samplers", "accessors", "bufferViews"}) {
    if (document[list].empty()) document.erase(list); // empty lists are not allowed
  }
  std::string json = document.line();
  pad(json, ' ');
  std::string chunks;
  append_chunk(chunks, chunk_json, json);
  if (!buffer_.empty()) append_chunk(chunks, chunk_binary, buffer_); // padded
  std::string header;
  append_uint32(header, magic);
  append_uint32(header, 2);
  append_uint32(header, static_cast<std::uint32_t>(12 + chunks.size()));
  out << header << chunks;
}

} // namespace CGAL::Shape_correspondence::IO
