// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/bytes.h"
#include "io/write/pictures.h"

#include <CGAL/Shape_correspondence/version.h>

#include <cstdint>
#include <ostream>
#include <type_traits>

namespace CGAL::Shape_correspondence::IO {
namespace {

// Codes of the glTF 2.0 specification
constexpr int component_uint16 = 5123, component_uint32 = 5125, component_float = 5126;
constexpr int target_vertices = 34962, target_indices = 34963, no_target = 0;
constexpr int mode_lines = 1;         // the default mode is triangles
constexpr int restart_index = 0xFFFF; // reserved: not a valid 16-bit index
constexpr std::uint32_t magic = 0x46546C67, chunk_json = 0x4E4F534A, chunk_binary = 0x004E4942;

void append_uint32(std::string& bytes, std::size_t value) { append_little_endian(bytes, std::uint32_t(value)); }

void pad(std::string& bytes, char filler) { bytes.resize((bytes.size() + 3) / 4 * 4, filler); }

void append_chunk_header(std::string& bytes, std::uint32_t type, const std::string& content)
{
  append_uint32(bytes, content.size());
  append_uint32(bytes, type);
}

template <typename Vector>
Json listed(const Vector& numbers)
{
  Json result = Json::array();
  for (auto number : numbers)
    result.push_back(number);
  return result;
}

} // namespace

Glb_file::Glb_file()
{
  document_["asset"] = {{"version", "2.0"}, {"generator", "Shape_correspondence " CGAL_SHAPE_CORRESPONDENCE_VERSION}};
  document_["scene"] = 0;
  for (const char* list :
       {"scenes", "nodes", "meshes", "materials", "textures", "images", "samplers", "accessors", "bufferViews"})
    document_[list] = Json::array();
}

int Glb_file::add(const char* list, Json object)
{
  Json& all = document_[list];
  all.push_back(std::move(object));
  return static_cast<int>(all.size()) - 1;
}

int Glb_file::add_bytes(const std::string& bytes)
{
  buffer_ += bytes;
  pad(buffer_, '\0');
  return add(
      "bufferViews",
      Json{{"buffer", 0}, {"byteOffset", buffer_.size() - (bytes.size() + 3) / 4 * 4}, {"byteLength", bytes.size()}});
}

Glb_file::Shared_view& Glb_file::shared_view(int target, std::size_t stride)
{
  const auto [found, is_new] = shared_views_.try_emplace({target, stride});
  if (is_new) {
    Json view = {{"buffer", 0}};
    if (target != no_target) view["target"] = target;
    if (target == target_vertices) view["byteStride"] = stride;
    found->second.view = add("bufferViews", std::move(view));
  }
  return found->second;
}

/// Adds the columns of a matrix as elements of an accessor. Equal accessors of anything but vertices, such as indices
/// of patches of one size, are stored once.
template <typename Scalar>
int Glb_file::add_accessor(const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& elements, int target,
                           bool has_bounds)
{
  constexpr const char* types[] = {"SCALAR", "VEC2", "VEC3"};
  constexpr bool is_float = std::is_same<Scalar, float>::value, is_short = sizeof(Scalar) == sizeof(std::uint16_t);
  Json accessor = {{"componentType", is_float   ? component_float
                                     : is_short ? component_uint16
                                                : component_uint32},
                   {"count", elements.cols()},
                   {"type", types[elements.rows() - 1]}};
  if (has_bounds) {
    accessor["min"] = listed(elements.rowwise().minCoeff().eval());
    accessor["max"] = listed(elements.rowwise().maxCoeff().eval());
  }
  std::string bytes;
  for (Eigen::Index i = 0; i < elements.size(); ++i)
    append_little_endian(bytes, elements.data()[i]);
  int unshared = -1;
  int& number =
      target == target_vertices ? unshared : shared_accessors_.try_emplace(accessor.line() + bytes, -1).first->second;
  if (number >= 0) return number;
  Shared_view& view = shared_view(target, std::size_t(elements.rows()) * sizeof(Scalar));
  accessor["bufferView"] = view.view;
  accessor["byteOffset"] = view.bytes.size();
  view.bytes += bytes;
  return number = add("accessors", Json::of_text(accessor.line()));
}

int Glb_file::add_material(const std::string& name, const Eigen::Vector3d& colour, double alpha, int texture)
{
  Json material = {{"name", name},
                   {"pbrMetallicRoughness",
                    {{"baseColorFactor", {colour.x(), colour.y(), colour.z(), alpha}},
                     {"metallicFactor", 0.0},
                     {"roughnessFactor", 0.7}}}};
  if (texture >= 0) material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", texture}};
  material["doubleSided"] = true;
  if (alpha < 1) material["alphaMode"] = "BLEND";
  return add("materials", std::move(material));
}

int Glb_file::add_node(const std::string& name, const std::vector<Drawn_mesh>& meshes)
{
  Json primitives = Json::array();
  for (const Drawn_mesh& mesh : meshes)
    if (!mesh.empty()) primitives.push_back(primitive(mesh));
  const Json named = name.empty() ? Json::object() : Json{{"name", name}};
  Json node = named;
  if (!primitives.empty()) {
    Json mesh = named;
    mesh["primitives"] = std::move(primitives);
    if (!meshes[0].morphs.empty()) mesh["weights"] = std::vector<double>(meshes[0].morphs.size(), 0.);
    node["mesh"] = add("meshes", Json::of_text(mesh.line()));
  }
  return add("nodes", std::move(node));
}

int Glb_file::add_node(const std::string& name, const std::vector<int>& children, const Point& translation)
{
  Json node = {{"name", name}};
  if (!children.empty()) node["children"] = children;
  node["translation"] = listed(translation);
  return add("nodes", std::move(node));
}

Json Glb_file::primitive(const Drawn_mesh& mesh)
{
  const bool has_triangles = mesh.triangles.cols() > 0;
  Json result;
  const auto add_points = [&](const Points& points) {
    return add_accessor<float>(points.cast<float>(), target_vertices, true);
  };
  Json& attributes = result["attributes"];
  attributes["POSITION"] = add_points(mesh.points);
  if (mesh.normals.cols() > 0)
    attributes["NORMAL"] = add_accessor<float>(mesh.normals.cast<float>(), target_vertices, false);
  if (mesh.coordinates.cols() > 0)
    attributes["TEXCOORD_0"] = add_accessor<float>(mesh.coordinates, target_vertices, false);
  if (mesh.colours.cols() > 0) attributes["COLOR_0"] = add_accessor<float>(mesh.colours, target_vertices, false);
  const Eigen::Map<const Eigen::RowVectorXi> indices(has_triangles ? mesh.triangles.data() : mesh.lines.data(),
                                                     has_triangles ? mesh.triangles.size() : mesh.lines.size());
  result["indices"] = mesh.points.cols() < restart_index
                          ? add_accessor<std::uint16_t>(indices.cast<std::uint16_t>(), target_indices, false)
                          : add_accessor<int>(indices, target_indices, false);
  result["material"] = mesh.material;
  if (!has_triangles) result["mode"] = mode_lines;
  if (!mesh.layer.empty()) result["extras"] = {{"layer", mesh.layer}};
  for (const Points& morph : mesh.morphs)
    result["targets"].push_back(Json{{"POSITION", add_points(morph)}});
  return result;
}

void Glb_file::animate_morphs(int node, const std::vector<double>& times, const Eigen::MatrixXf& weights)
{
  if (weights.size() > 0) add_channel(node, "weights", "LINEAR", times, weights.reshaped().transpose());
}

void Glb_file::animate_visibility(int node, double begin, double end)
{
  if (begin > 0) document_["nodes"][static_cast<std::size_t>(node)]["scale"] = {0, 0, 0};
  const std::vector<double> times = begin > 0 ? std::vector<double>{0, begin, end} : std::vector<double>{begin, end};
  Eigen::MatrixXf sizes = Eigen::MatrixXf::Zero(3, Eigen::Index(times.size()));
  sizes.col(sizes.cols() - 2).setOnes();
  add_channel(node, "scale", "STEP", times, sizes);
}

void Glb_file::add_channel(int node, const char* path, const char* interpolation, const std::vector<double>& times,
                           const Eigen::MatrixXf& values)
{
  if (!document_.contains("animations"))
    add("animations", Json{{"channels", Json::array()}, {"samplers", Json::array()}});
  const Eigen::Map<const Eigen::RowVectorXd> seconds(times.data(), Eigen::Index(times.size()));
  const int input = add_accessor<float>(seconds.cast<float>(), no_target, true);
  const int output = add_accessor<float>(values, no_target, false);
  Json& animation = document_["animations"][0];
  animation["channels"].push_back(
      Json{{"sampler", animation["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
  animation["samplers"].push_back(Json{{"input", input}, {"output", output}, {"interpolation", interpolation}});
}

void Glb_file::set_node_extras(int node, Json extras)
{
  document_["nodes"][static_cast<std::size_t>(node)]["extras"] = std::move(extras);
}

void Glb_file::set_animation_extras(Json extras)
{
  if (document_.contains("animations")) document_["animations"][0]["extras"] = std::move(extras);
}

void Glb_file::write(std::ostream& out, const std::vector<Glb_scene>& scenes) const
{
  Json document = document_;
  std::string buffer = buffer_;
  for (const auto& [kind, shared] : shared_views_) {
    Json& view = document["bufferViews"][std::size_t(shared.view)];
    view["byteOffset"] = buffer.size();
    view["byteLength"] = shared.bytes.size();
    buffer += shared.bytes;
    pad(buffer, '\0');
  }
  for (const Glb_scene& scene : scenes)
    document["scenes"].push_back(Json{{"name", scene.name}, {"nodes", scene.roots}});
  if (!buffer.empty()) document["buffers"] = Json::array({Json{{"byteLength", buffer.size()}}});
  for (const char* list : {"meshes", "materials", "textures", "images", "samplers", "accessors", "bufferViews"})
    if (document[list].empty()) document.erase(list); // empty lists are not allowed
  std::string json = document.line(), header, binary_header;
  pad(json, ' ');
  if (!buffer.empty()) append_chunk_header(binary_header, chunk_binary, buffer);
  append_uint32(header, magic);
  append_uint32(header, 2);
  append_uint32(header, 20 + json.size() + binary_header.size() + buffer.size());
  append_chunk_header(header, chunk_json, json);
  out << header << json << binary_header << buffer;
}

} // namespace CGAL::Shape_correspondence::IO
