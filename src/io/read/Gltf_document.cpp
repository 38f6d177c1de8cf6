// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/Gltf_document.h"
#include "base/limits.h"
#include "io/read/text_words.h"
#include "io/system/bytes.h"
#include "io/system/input_file.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>

// tinygltf is not used: it reads wrong types as missing values, truncates large numbers, and overruns image buffers.

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr std::uint64_t most_numbers = 200'000'000; // limit for a document: enough for ten million triangles
constexpr std::size_t most_zeros = 1'000'000;       // limit for an accessor's elements that are not in the file
constexpr const char* version_1 = "glTF 1.0";
constexpr const char* draco_extension = "KHR_draco_mesh_compression";
constexpr const char* meshopt_extensions[] = {"EXT_meshopt_compression", "KHR_meshopt_compression"};

/// The decoded bytes; none if a character is invalid or the text is truncated.
std::optional<std::string> from_base64(std::string_view text)
{
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  while (!text.empty() && text.back() == '=')
    text.remove_suffix(1);
  std::string result;
  result.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int number = 0; // number of bits that are not in the result yet
  for (char c : text) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    bits = bits << 6 | std::uint32_t(digit);
    number += 6;
    if (number < 8) continue;
    number -= 8;
    result.push_back(char(bits >> number & 0xFF));
  }
  return result;
}

/// Whether the extension is supported.
bool is_known(const std::string& extension)
{
  const auto names = {
      draco_extension,           meshopt_extensions[0],   meshopt_extensions[1], "KHR_mesh_quantization",
      "EXT_mesh_gpu_instancing", "KHR_texture_transform", "KHR_materials_unlit", "KHR_materials_pbrSpecularGlossiness"};
  return std::find(names.begin(), names.end(), extension) != names.end();
}

/// Whether the extension affects the appearance only, so that shapes are read correctly without it.
bool is_of_appearance(const std::string& extension)
{
  const auto words = {"_materials_", "_texture_",  "_lights_",  "KHR_technique", "_environment",
                      "KHR_xmp",     "_animation", "_metadata", "_audio",        "_features"};
  return std::any_of(words.begin(), words.end(),
                     [&](const char* word) { return extension.find(word) != std::string::npos; });
}

} // namespace

struct Gltf_document::Component
{
  int code; ///< code in the document
  std::size_t size;
  double largest; ///< value that stands for 1 in normalized numbers
  double (*read)(const char*);
};

Gltf_document::Gltf_document(std::string_view text, const std::string& file, const Reading_options& options,
                             const Gltf_codecs* codecs)
    : text_(text), file_(file), options_(options), codecs_(codecs)
{
  if (begins_with(text, "glTF")) split_glb();
  if (text_.size() > internal::largest_document)
    throw Invalid_input(file_ + ": its JSON is longer than " + std::to_string(internal::largest_document >> 20) +
                        " MB; save it as GLB, whose numbers are no text");
  root_ = parse_json(text_, file_);
  const Json_field number = (*root_)["asset"]["version"];
  const std::string version = number.is_text() ? number.text() : "1.0"; // old files have a number
  if (begins_with(version, "1.")) throw Needs_import{version_1};
  if (!begins_with(version, "2."))
    throw Invalid_input(file_ + ": it is glTF of version " + cited(version) + "; save it as glTF 2.0");
  check_extensions();
}

void Gltf_document::split_glb()
{
  constexpr std::size_t header = 12, chunk_header = 8;
  constexpr std::uint32_t json = 0x4E4F534A, binary = 0x004E4942;
  const auto cut_off = [&] {
    return Invalid_input(file_ + ": it cannot be read as GLB: it is cut off, or damaged; " + remedy::save_again);
  };
  if (text_.size() < header + chunk_header) throw cut_off();
  const std::uint32_t version = number_in<std::uint32_t>(text_.data() + 4);
  if (version == 1) throw Needs_import{version_1};
  if (version != 2)
    throw Invalid_input(file_ + ": it is GLB of version " + std::to_string(version) + "; save it as glTF 2.0");
  const std::size_t length = number_in<std::uint32_t>(text_.data() + 8);
  if (length < header || length > text_.size()) throw cut_off();
  std::string_view rest = text_.substr(header, length - header);
  text_ = {};
  while (rest.size() >= chunk_header) {
    const std::size_t size = number_in<std::uint32_t>(rest.data());
    const std::uint32_t type = number_in<std::uint32_t>(rest.data() + 4);
    rest.remove_prefix(chunk_header);
    if (size > rest.size()) throw cut_off();
    if (type == json && text_.empty()) text_ = rest.substr(0, size);
    if (type == binary && binary_.empty()) binary_ = rest.substr(0, size);
    rest.remove_prefix(size);
  }
  if (text_.empty()) throw cut_off();
}

void Gltf_document::check_extensions()
{
  if (!root_->has("extensionsRequired")) return;
  for (const std::string& name : (*root_)["extensionsRequired"].texts()) {
    if (!is_known(name) && !is_of_appearance(name))
      throw Invalid_input(file_ + ": it needs the extension " + cited(name) +
                          " of glTF, which is not known here; save it without this extension");
    required_.insert(name);
  }
}

std::vector<std::string> Gltf_document::appearance_warnings() const
{
  std::vector<std::string> result;
  for (const std::string& name : required_)
    if (!is_known(name) && name.find("_texture_") == std::string::npos) // unsupported textures have their own warnings
      result.push_back("What the extension " + cited(name) + " of glTF describes was left out.");
  return result;
}

const std::vector<Json_field>& Gltf_document::list(const std::string& name)
{
  const auto [found, is_new] = lists_.emplace(name, std::vector<Json_field>());
  if (is_new && root_->has(name)) found->second = (*root_)[name].elements();
  return found->second;
}

std::size_t Gltf_document::index(const std::string& list_name, const Json_field& reference)
{
  const int result = reference.integer();
  if (result < 0 || std::size_t(result) >= list(list_name).size())
    reference.fail("is " + std::to_string(result) + ", but there are " + std::to_string(list(list_name).size()) + " " +
                   list_name + ", numbered from 0");
  return std::size_t(result);
}

std::optional<std::size_t> Gltf_document::index_at(const Json_field& field, const std::string& key,
                                                   const std::string& list_name)
{
  if (!field.has(key)) return std::nullopt;
  return index(list_name, field[key]);
}

std::size_t Gltf_document::number_at(const Json_field& field, const std::string& key, std::size_t otherwise)
{
  if (!field.has(key)) return otherwise;
  const Json_field number = field[key];
  number.number_at_least_0();
  return std::size_t(number.integer());
}

void Gltf_document::count(const Json_field& place, std::uint64_t numbers)
{
  counted_ += numbers;
  if (counted_ > most_numbers)
    place.fail("is too much: the meshes have more than 200 million numbers, counted as often as nodes use them; "
               "simplify the model, or cut it into parts");
}

void Gltf_document::count_triangles(std::uint64_t triangles)
{
  triangles_ += triangles;
  std::uint64_t bytes = text_.size() + binary_.size();
  for (const auto* read : {&loaded_, &decompressed_})
    for (const auto& [index, data] : *read)
      bytes += data.size();
  for (const auto& [view, mesh] : draco_)
    bytes += mesh.corners.size();
  if (are_repeated_too_often(triangles_, bytes)) throw Invalid_input(file_ + ": " + repeated_too_often);
}

std::optional<std::string> Gltf_document::data_of_uri(std::string_view uri)
{
  if (!begins_with(uri, "data:")) return std::nullopt;
  constexpr std::string_view mark = ";base64,";
  const std::size_t begin = uri.find(mark);
  std::optional<std::string> data;
  if (begin != std::string_view::npos) data = from_base64(uri.substr(begin + mark.size()));
  return data ? data : std::string(); // damaged data are empty
}

std::string Gltf_document::load(const Json_field& buffer)
{
  const std::string uri = buffer["uri"].text();
  if (std::optional<std::string> data = data_of_uri(uri)) return std::move(*data);
  Named_file file = Named_files{file_, options_, largest_model, rest_of_files_}.read(uri);
  if (file.fault.empty()) return std::move(file.bytes);
  throw Invalid_input(file_ + ": the file " + cited_file(uri) + ", which it names, " + file.fault +
                      "; put it beside the model");
}

std::string_view Gltf_document::buffer(std::size_t index)
{
  const Json_field& field = list("buffers")[index];
  std::string_view data = binary_;
  if (field.has("uri")) {
    if (loaded_.count(index) == 0) loaded_[index] = load(field);
    data = loaded_[index];
  } else if (index > 0 || binary_.empty())
    field.fail("is not in the file, and names no other one");
  const std::size_t length = number_at(field, "byteLength", data.size());
  if (length > data.size())
    field.fail("has " + std::to_string(length) + " bytes by its byteLength, but only " + std::to_string(data.size()) +
               " are there: it is cut off or damaged; " + remedy::save_again);
  return data.substr(0, length);
}

std::string_view Gltf_document::bytes_in(const Json_field& view)
{
  const std::string_view all = buffer(index("buffers", view["buffer"]));
  const std::size_t offset = number_at(view, "byteOffset", 0), length = number_at(view, "byteLength", 0);
  if (offset > all.size() || length > all.size() - offset)
    view.fail("ends beyond the " + std::to_string(all.size()) + " bytes of its buffer");
  return all.substr(offset, length);
}

template <typename Codec>
void Gltf_document::check_codec(const Codec Gltf_codecs::*codec, const char* extension, const char* library) const
{
  if (!codecs_) throw Needs_import{std::string("the extension ") + extension};
  if (!(codecs_->*codec))
    throw Invalid_input(file_ + ": it needs the extension " + extension +
                        " of glTF, and the program was built without " + library + "; save it without compression");
}

std::string Gltf_document::decompressed(const Json_field& view, const Json_field& extension)
{
  check_codec(&Gltf_codecs::meshopt, meshopt_extensions[0], "meshoptimizer");
  const auto text_at = [&](const char* key) { return extension.has(key) ? extension[key].text() : ""; };
  const Meshopt_view packed{bytes_in(extension), number_at(extension, "count", 0),
                            number_at(extension, "byteStride", 0), text_at("mode"), text_at("filter")};
  constexpr std::size_t largest_stride = 256; // limit of the extension, in bytes
  if (packed.stride == 0 || packed.stride > largest_stride) extension.fail("has a byteStride that is not in 1 to 256");
  count(extension, packed.count * (packed.stride / sizeof(float) + 1));
  std::string result = codecs_->meshopt(packed);
  if (result.empty() && packed.count > 0)
    view.fail("cannot be decompressed; it is damaged, or by a newer meshoptimizer: save it without compression");
  return result;
}

std::string_view Gltf_document::bytes(const Json_field& reference)
{
  const std::size_t number = index("bufferViews", reference);
  if (const auto found = decompressed_.find(number); found != decompressed_.end()) return found->second;
  const Json_field& view = list("bufferViews")[number];
  if (view.has("extensions"))
    for (const char* name : meshopt_extensions)
      if (const Json_field extensions = view["extensions"]; extensions.has(name) && requires_extension(name))
        return decompressed_[number] = decompressed(view, extensions[name]);
  return bytes_in(view);
}

const Gltf_document::Component& Gltf_document::component_at(const Json_field& field)
{
  static const Component components[] = {
      {5120, 1, 127, real_in<std::int8_t>},           {5121, 1, 255, real_in<std::uint8_t>},
      {5122, 2, 32767, real_in<std::int16_t>},        {5123, 2, 65535, real_in<std::uint16_t>},
      {5125, 4, 4294967295., real_in<std::uint32_t>}, {5126, 4, 1, real_in<float>}};
  const Json_field code = field["componentType"];
  for (const Component& known : components)
    if (known.code == code.integer()) return known;
  code.fail("is " + std::to_string(code.integer()) + ", which is none");
}

Eigen::MatrixXd Gltf_document::decode(const Json_field& place, const Component& component, bool is_normalized,
                                      std::size_t components, std::size_t count)
{
  const Json_field view = element("bufferViews", place["bufferView"]);
  const std::string_view all = bytes(place["bufferView"]);
  const std::size_t size = component.size * components;
  const std::size_t stride = number_at(view, "byteStride", size), offset = number_at(place, "byteOffset", 0);
  if (stride < size) view.fail("has a byteStride of less than an element");
  if (offset > all.size() || (count > 0 && (size > all.size() - offset || //
                                            (count - 1) > (all.size() - offset - size) / stride)))
    place.fail("has " + std::to_string(count) + " elements, which is more than its buffer view of " +
               std::to_string(all.size()) + " bytes holds");
  Eigen::MatrixXd result(components, count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < components; ++k) {
      const double number = component.read(all.data() + offset + i * stride + k * component.size);
      result(Eigen::Index(k), Eigen::Index(i)) = is_normalized ? std::max(number / component.largest, -1.) : number;
    }
  return result;
}

void Gltf_document::replace_sparse(const Json_field& sparse, const Component& component, bool is_normalized,
                                   Eigen::MatrixXd& all)
{
  const std::size_t number = number_at(sparse, "count", 0);
  if (number > std::size_t(all.cols())) sparse.fail("has more elements than its accessor");
  const Json_field indices = sparse["indices"];
  const Eigen::MatrixXd places = decode(indices, component_at(indices), false, 1, number);
  const Eigen::MatrixXd values = decode(sparse["values"], component, is_normalized, std::size_t(all.rows()), number);
  for (Eigen::Index i = 0; i < values.cols(); ++i) {
    if (!(places(0, i) >= 0 && places(0, i) < double(all.cols()))) indices.fail("has an index beyond its accessor");
    all.col(Eigen::Index(places(0, i))) = values.col(i);
  }
}

Eigen::MatrixXd Gltf_document::zeros(const Json_field& accessor, std::size_t components, std::size_t count)
{
  const std::size_t given = number_at(accessor["sparse"], "count", 0);
  if (count > most_zeros && count - most_zeros > given)
    accessor.fail("has " + std::to_string(count) + " elements, of which only " + std::to_string(given) +
                  " are in the file; save the model without sparse accessors");
  return Eigen::MatrixXd::Zero(Eigen::Index(components), Eigen::Index(count));
}

std::size_t Gltf_document::components_of(const Json_field& accessor, std::initializer_list<const char*> types)
{
  const std::string type = accessor["type"].text();
  if (std::find(types.begin(), types.end(), type) == types.end())
    accessor.fail("is of type " + cited(type) + " where " + *types.begin() + " is expected");
  return type == "SCALAR" ? 1 : std::size_t(type.back() - '0');
}

double Gltf_document::largest_of(const Json_field& accessor)
{
  return accessor.has("normalized") && accessor["normalized"].boolean() ? component_at(accessor).largest : 1;
}

Eigen::MatrixXd Gltf_document::numbers(const Json_field& accessor_reference, std::initializer_list<const char*> types)
{
  const Json_field& accessor = element("accessors", accessor_reference);
  const std::size_t components = components_of(accessor, types);
  const std::size_t elements = number_at(accessor, "count", 0);
  count(accessor, std::uint64_t(elements) * components);
  const Component& component = component_at(accessor);
  const bool is_normalized = largest_of(accessor) > 1;
  Eigen::MatrixXd result;
  if (accessor.has("bufferView"))
    result = decode(accessor, component, is_normalized, components, elements);
  else if (accessor.has("sparse"))
    result = zeros(accessor, components, elements);
  else
    accessor.fail("has no bufferView; if the model is compressed, save it without compression");
  if (accessor.has("sparse")) replace_sparse(accessor["sparse"], component, is_normalized, result);
  return result;
}

const Draco_mesh* Gltf_document::draco_mesh(const Json_field& primitive)
{
  if (!primitive.has("extensions") || !primitive["extensions"].has(draco_extension)) return nullptr;
  const Json_field attributes = primitive["attributes"];
  if (!attributes.has("POSITION") || element("accessors", attributes["POSITION"]).has("bufferView"))
    return nullptr; // the mesh also exists uncompressed
  check_codec(&Gltf_codecs::draco, draco_extension, "Draco");
  const Json_field reference = primitive["extensions"][draco_extension]["bufferView"];
  const std::size_t view = index("bufferViews", reference);
  if (const auto found = draco_.find(view); found != draco_.end()) return &found->second;
  Draco_mesh mesh = codecs_->draco(bytes(reference));
  if (mesh.attributes.empty())
    reference.fail("cannot be decompressed by Draco; the file is damaged: save it again, or without compression");
  return &(draco_[view] = std::move(mesh));
}

std::optional<Eigen::MatrixXd> Gltf_document::attribute(const Json_field& primitive, const std::string& name,
                                                        std::initializer_list<const char*> types)
{
  const Json_field attributes = primitive["attributes"];
  if (!attributes.has(name)) return std::nullopt;
  const Draco_mesh* const mesh = draco_mesh(primitive);
  if (!mesh) return numbers(attributes[name], types);
  const Json_field identifiers = primitive["extensions"][draco_extension]["attributes"];
  if (!identifiers.has(name)) return numbers(attributes[name], types);
  const auto found = mesh->attributes.find(identifiers[name].integer());
  const Json_field& accessor = element("accessors", attributes[name]);
  const std::size_t components = components_of(accessor, types);
  if (found == mesh->attributes.end() || std::size_t(found->second.rows()) != components)
    identifiers[name].fail("is none of the attributes that Draco compressed");
  count(accessor, std::uint64_t(found->second.size()));
  const double largest = largest_of(accessor);
  return largest > 1 ? Eigen::MatrixXd((found->second / largest).cwiseMax(-1)) : found->second;
}

std::optional<Eigen::VectorXd> Gltf_document::indices(const Json_field& primitive)
{
  if (const Draco_mesh* const mesh = draco_mesh(primitive)) {
    count(primitive, mesh->corners.size());
    return Eigen::Map<const Eigen::Matrix<std::size_t, Eigen::Dynamic, 1>>(mesh->corners.data(),
                                                                           Eigen::Index(mesh->corners.size()))
        .cast<double>();
  }
  if (!primitive.has("indices")) return std::nullopt;
  return Eigen::VectorXd(numbers(primitive["indices"], {"SCALAR"}).row(0));
}

} // namespace CGAL::Shape_correspondence::IO
