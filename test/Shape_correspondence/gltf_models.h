// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/read/model_parts.h"
#include "io/system/bytes.h"
#include "model_files.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>

#include <nlohmann/json.hpp>

/// Models in glTF, made in memory.
namespace gltf_models {

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using nlohmann::json;

/// A glTF model under construction; every accessor has its own buffer view in one buffer.
struct Model
{
  json document = {{"asset", {{"version", "2.0"}}}, {"scenes", {{{"nodes", {0}}}}}};
  std::string bytes;

  template <typename Number>
  int view(const std::vector<Number>& numbers)
  {
    bytes.resize((bytes.size() + 3) / 4 * 4);
    const std::size_t begin = bytes.size();
    for (Number number : numbers)
      IO::append_little_endian(bytes, number);
    document["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes.size() - begin}});
    return int(document["bufferViews"].size()) - 1;
  }

  template <typename Number>
  int accessor(const std::vector<Number>& numbers, int components, bool is_normalized = false)
  {
    constexpr bool is_signed = std::is_signed_v<Number>;
    const int type = std::is_floating_point_v<Number> ? 5126
                     : sizeof(Number) == 4            ? 5125 //
                                                      : 5120 + 2 * (sizeof(Number) == 2) + !is_signed;
    const char* const types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
    document["accessors"].push_back({{"bufferView", view(numbers)},
                                     {"componentType", type},
                                     {"count", numbers.size() / std::size_t(components)},
                                     {"type", types[components - 1]}});
    if (is_normalized) document["accessors"].back()["normalized"] = true;
    return int(document["accessors"].size()) - 1;
  }

  void add_mesh(const json& primitive) { document["meshes"].push_back({{"primitives", {primitive}}}); }

  std::string glb() const
  {
    json whole = document;
    whole["buffers"] = {{{"byteLength", bytes.size()}}};
    std::string text = whole.dump(), binary = bytes, result = "glTF";
    text.resize((text.size() + 3) / 4 * 4, ' ');
    binary.resize((bytes.size() + 3) / 4 * 4);
    const auto append = [&](std::size_t number) { IO::append_little_endian(result, std::uint32_t(number)); };
    append(2);
    append(12 + 8 + text.size() + 8 + binary.size());
    append(text.size());
    result += "JSON" + text;
    append(binary.size());
    return result + std::string("BIN\0", 4) + binary;
  }

  Segmented_shape read(Shape_appearance* looks = nullptr) const
  {
    const Temporary_folder folder;
    const std::string file = folder.write("model.glb", glb());
    return looks ? IO::read_shape_and_appearance(file, *looks) : IO::read_segmented_shape(file);
  }
};

inline const std::vector<float> corners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
template <typename Number>
inline const std::vector<Number> triangles = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

inline Model tetrahedron()
{
  Model model;
  const int points = model.accessor(corners, 3), indices = model.accessor(triangles<std::uint16_t>, 1);
  model.add_mesh({{"attributes", {{"POSITION", points}}}, {"indices", indices}});
  model.document["nodes"] = {{{"name", "seat"}, {"mesh", 0}}};
  return model;
}

/// The error of reading a file with these bytes; empty if the file is read.
inline std::string refused(const std::string& bytes)
{
  return complaint([&] { IO::read_gltf_parts(bytes, "input.glb"); });
}

} // namespace gltf_models
