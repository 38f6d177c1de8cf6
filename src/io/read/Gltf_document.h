// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/read/Json_field.h"
#include "io/read/model_parts.h"

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <set>

namespace CGAL::Shape_correspondence::IO {

/// A mesh that Draco compressed.
struct Draco_mesh
{
  std::vector<std::size_t> corners;          ///< numbers of vertices, three a triangle
  std::map<int, Eigen::MatrixXd> attributes; ///< by identifier, a vertex a column; not normalised
};

/// A buffer view that meshoptimizer compressed: what the document says of it.
struct Meshopt_view
{
  std::string_view bytes;
  std::size_t count, stride;
  std::string mode, filter;
};

/// What takes compressed meshes apart, in a program of its own; one that it was built without is empty.
struct Gltf_codecs
{
  std::function<Draco_mesh(std::string_view)> draco;
  std::function<std::string(const Meshopt_view&)> meshopt;
};

/// Thrown where a document needs what only the program with codecs and assimp reads.
struct Needs_import
{
  std::string what;
};

/// A glTF document and its buffers. All that it says is checked against what is there before it is used; what is wrong
/// is an `Invalid_input` that names the file and the place.
class Gltf_document
{
public:
  /// \param text of a GLB or glTF file; it must outlive this \param file its name \param codecs null: there are none
  /// \throw Needs_import if it is of version 1
  Gltf_document(std::string_view text, const std::string& file, const Reading_options& options,
                const Gltf_codecs* codecs);

  const Json_field& root() const { return *root_; }

  /// The elements of a list of the document, such as "nodes"; none if it has no such list.
  const std::vector<Json_field>& list(const std::string& name);

  /// The number that refers to an element of a list.
  std::size_t index(const std::string& list_name, const Json_field& reference);
  const Json_field& element(const std::string& list_name, const Json_field& reference)
  {
    return list(list_name)[index(list_name, reference)];
  }

  /// The same, and a number that is not negative, of a key that may be missing.
  std::optional<std::size_t> index_at(const Json_field& field, const std::string& key, const std::string& list_name);
  static std::size_t number_at(const Json_field& field, const std::string& key, std::size_t otherwise);

  /// What an accessor refers to, an element a column; normalised numbers are in [-1, 1].
  /// \param types that it may be of: SCALAR, VEC2, VEC3, VEC4
  Eigen::MatrixXd numbers(const Json_field& accessor_reference, std::initializer_list<const char*> types);

  /// The same of an attribute of a primitive, none if it has no such one.
  std::optional<Eigen::MatrixXd> attribute(const Json_field& primitive, const std::string& name,
                                           std::initializer_list<const char*> types);

  /// The indices of a primitive, none if it has none. \throw Needs_import if it is compressed, and there are no codecs
  std::optional<Eigen::VectorXd> indices(const Json_field& primitive);

  /// The bytes of a buffer view that a key refers to, no longer compressed.
  std::string_view bytes(const Json_field& reference);

  /// Warnings about looks that extensions describe.
  std::vector<std::string> warnings_of_looks() const;

  /// The bytes in a URI that is none of a file. \return none if it is one of a file
  static std::optional<std::string> data_of_uri(std::string_view uri);

  /// Counts numbers that are read or made, since a small file may use a mesh many times.
  void count(const Json_field& place, std::uint64_t numbers);

  /// Counts triangles, of which there are far more than bytes only where nodes use the same mesh.
  void count_triangles(std::uint64_t triangles);

private:
  struct Component;

  static const Component& component_at(const Json_field& field);
  static std::size_t components_of(const Json_field& accessor, std::initializer_list<const char*> types);
  static double largest_of(const Json_field& accessor); ///< which stands for 1; 1 unless numbers are normalised
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

  std::string_view text_, binary_; ///< the document, and the bytes that follow it in a GLB file
  const std::string& file_;
  const Reading_options& options_;
  const Gltf_codecs* codecs_;
  std::set<std::string> required_; ///< extensions
  std::optional<Json_field> root_;
  std::map<std::string, std::vector<Json_field>> lists_;
  std::map<std::size_t, std::string> loaded_;       ///< buffers, by index
  std::map<std::size_t, std::string> decompressed_; ///< buffer views, by index
  std::map<std::size_t, Draco_mesh> draco_;         ///< by buffer view
  std::uintmax_t rest_of_files_ = largest_model;
  std::uint64_t counted_ = 0, triangles_ = 0;
};

/// What a document holds. \throw Needs_import if it needs codecs that are not given, or is of version 1
Model_content read_gltf(std::string_view text, const std::string& file, const Reading_options& options,
                        const Gltf_codecs* codecs);

} // namespace CGAL::Shape_correspondence::IO
