// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/read/document.h"
#include "io/read/model_parts.h"

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <set>

namespace CGAL::Shape_correspondence::IO {

/// A mesh decoded by Draco.
struct Draco_mesh
{
  std::vector<std::size_t> corners;          ///< vertex indices, three for each triangle
  std::map<int, Eigen::MatrixXd> attributes; ///< indexed by identifier; one column for each vertex; not normalized
};

/// A buffer view compressed by meshoptimizer, with its description in the document.
struct Meshopt_view
{
  std::string_view bytes;
  std::size_t count, stride;
  std::string mode, filter;
};

/// Decoders of compressed meshes, available in a separate program; a decoder that it was built without is empty.
struct Gltf_codecs
{
  std::function<Draco_mesh(std::string_view)> draco;
  std::function<std::string(const Meshopt_view&)> meshopt;
};

/// Thrown if a document can only be read by the separate program (src/import), which has codecs and assimp.
struct Needs_import
{
  std::string what;
};

/// A glTF document and its buffers. All values are checked before use; errors (`Invalid_input`) name file and place.
class Gltf_document
{
public:
  /// \param text content of a GLB or glTF file; must outlive this \param file its name \param codecs may be null
  /// \throw Needs_import if the document is glTF 1.0
  Gltf_document(std::string_view text, const std::string& file, const Reading_options& options,
                const Gltf_codecs* codecs);

  const Json_field& root() const { return *root_; }

  /// The elements of a list of the document, such as "nodes"; empty if there is no such list.
  const std::vector<Json_field>& list(const std::string& name);

  /// The index by which a field refers to an element of a list, and the element.
  std::size_t index(const std::string& list_name, const Json_field& reference);
  const Json_field& element(const std::string& list_name, const Json_field& reference)
  {
    return list(list_name)[index(list_name, reference)];
  }

  /// The index at an optional key; none if the key is missing.
  std::optional<std::size_t> index_at(const Json_field& field, const std::string& key, const std::string& list_name);
  /// The nonnegative integer at an optional key; `otherwise` if the key is missing.
  static std::size_t number_at(const Json_field& field, const std::string& key, std::size_t otherwise);

  /// The data of an accessor, one column for each element; normalized numbers are in [-1, 1].
  /// \param types allowed types: SCALAR, VEC2, VEC3, VEC4
  Eigen::MatrixXd numbers(const Json_field& accessor_reference, std::initializer_list<const char*> types);

  /// The data of an attribute of a primitive; none if it is missing.
  std::optional<Eigen::MatrixXd> attribute(const Json_field& primitive, const std::string& name,
                                           std::initializer_list<const char*> types);

  /// The vertex indices of a primitive; none if missing. \throw Needs_import if compressed, without codecs
  std::optional<Eigen::VectorXd> indices(const Json_field& primitive);

  /// The bytes of a buffer view, decompressed.
  std::string_view bytes(const Json_field& reference);

  /// Warnings about appearance that unsupported extensions describe.
  std::vector<std::string> appearance_warnings() const;

  /// The bytes in a data URI. \return none if the URI names a file
  static std::optional<std::string> data_of_uri(std::string_view uri);

  /// Counts numbers that are read or generated; fails beyond a limit, since a small file may use a mesh many times.
  void count(const Json_field& place, std::uint64_t numbers);

  /// Counts triangles; fails beyond a limit, since nodes that share a mesh can make far more of them than bytes.
  void count_triangles(std::uint64_t triangles);

private:
  struct Component;

  static const Component& component_at(const Json_field& field);
  static std::size_t components_of(const Json_field& accessor, std::initializer_list<const char*> types);
  static double largest_of(const Json_field& accessor); ///< integer that stands for 1, if normalized; else 1
  void split_glb();
  void check_extensions();
  bool requires_extension(const std::string& name) const { return required_.count(name) > 0; }
  std::string_view buffer(std::size_t index);
  std::string_view bytes_in(const Json_field& view);
  std::string decompressed(const Json_field& view, const Json_field& extension);
  const Draco_mesh* draco_mesh(const Json_field& primitive);
  template <typename Codec>
  void check_codec(const Codec Gltf_codecs::*codec, const char* extension, const char* library) const;
  std::string load(const Json_field& buffer);
  Eigen::MatrixXd decode(const Json_field& place, const Component& component, bool is_normalized,
                         std::size_t components, std::size_t count);
  static Eigen::MatrixXd zeros(const Json_field& accessor, std::size_t components, std::size_t count);
  void replace_sparse(const Json_field& sparse, const Component& component, bool is_normalized, Eigen::MatrixXd& all);

  std::string_view text_, binary_; ///< the document, and the binary data of a GLB file
  const std::string& file_;
  const Reading_options& options_;
  const Gltf_codecs* codecs_;
  std::set<std::string> required_; ///< required extensions
  std::optional<Json_field> root_;
  std::map<std::string, std::vector<Json_field>> lists_;
  std::map<std::size_t, std::string> loaded_;       ///< buffers, by index
  std::map<std::size_t, std::string> decompressed_; ///< buffer views, by index
  std::map<std::size_t, Draco_mesh> draco_;         ///< indexed by buffer view
  std::uintmax_t rest_of_files_ = largest_model;
  std::uint64_t counted_ = 0, triangles_ = 0;
};

/// Reads the content of a document. \throw Needs_import if it needs codecs that are not given, or is glTF 1.0
Model_content read_gltf(std::string_view text, const std::string& file, const Reading_options& options,
                        const Gltf_codecs* codecs);

} // namespace CGAL::Shape_correspondence::IO
