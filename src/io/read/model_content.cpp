// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_parts.h"
#include "io/system/input_file.h"
#include "io/system/quoting.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace CGAL::Shape_correspondence::IO {
namespace {

namespace fs = std::filesystem;

std::string with_slashes(std::string name)
{
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

/// Whether a name is a default for unnamed objects: a number, or a word from a list with or without a number.
bool only_counts(const std::string& name)
{
  std::string word;
  for (char c : name)
    if (std::isalpha(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80)
      word += char(std::tolower(static_cast<unsigned char>(c)));
  const auto words = {
      "",         "object", "obj",      "mesh",      "node",  "group",          "geometry",    "geom",
      "meshnode", "shape",  "objectid", "polygon",   "part",  "primitive",      "polysurface", "submesh",
      "root",     "scene",  "rootnode", "component", "gltf",  "gltfnode",       "meshobject",  "instance",
      "default",  "model",  "untitled", "unnamed",   "solid", "sketchfabmodel", "transform",   "entity"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

} // namespace

Named_file Named_files::read(const std::string& given) const
{
  const fs::path folder = fs::path(model).parent_path();
  const std::string name = with_slashes(given);
  std::error_code error;
  std::string fault = "is not there";
  for (const fs::path candidate : {name, percent_decoded(name)})
    for (const fs::path& path : {folder / candidate.relative_path(), folder / candidate.filename()}) {
      if (!fs::is_regular_file(path, error)) continue;
      if (!options.allow_outside_files && !is_in_folder_of(model, path.string())) {
        fault = "is outside the model's folder, and not read without `Reading_options::allow_outside_files`";
        continue;
      }
      const std::uintmax_t size = fs::file_size(path, error);
      if (size > largest) return {"", "is larger than " + std::to_string(largest >> 20) + " MB"};
      if (size > rest) return {"", "is more than a model may have in such files"};
      std::ifstream in(path, std::ios::binary);
      Named_file result{std::string(std::size_t(size), '\0'), in ? "" : "cannot be read"};
      in.read(result.bytes.data(), std::streamsize(size));
      result.bytes.resize(std::size_t(in.gcount()));
      rest -= std::min<std::uintmax_t>(rest, result.bytes.size());
      return result;
    }
  return {"", fault};
}

void append_appearance(Model_content& from, Model_content& to)
{
  for (Surface_material& material : from.materials)
    if (material.texture >= 0) material.texture += int(to.textures.size());
  for (Model_part& part : from.parts)
    for (int& material : part.appearance.materials)
      if (material >= 0) material += int(to.materials.size());
  const auto append = [](auto& more, auto& all) { std::move(more.begin(), more.end(), std::back_inserter(all)); };
  append(from.materials, to.materials);
  append(from.textures, to.textures);
}

Part_appearance appearance_of(const Part_appearance& all, const std::vector<std::size_t>& triangles)
{
  const std::size_t needed = triangles.empty() ? 1 : triangles.back() + 1; // shorter attributes are left out
  Part_appearance result;
  for (std::size_t t : triangles) {
    if (all.materials.size() >= needed) result.materials.push_back(all.materials[t]);
    for (std::size_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
      if (all.coordinates.size() >= 3 * needed) result.coordinates.push_back(all.coordinates[corner]);
      if (all.colours.size() >= 3 * needed) result.colours.push_back(all.colours[corner]);
    }
  }
  return result;
}

void add_appearance(const Part_appearance& more, std::size_t more_triangles, std::size_t triangles,
                    Part_appearance& all)
{
  const auto append = [](auto& to, std::size_t before, const auto& from, std::size_t count, const auto& none) {
    if (to.empty() && from.empty()) return;
    to.resize(before, none);
    to.insert(to.end(), from.begin(), from.end());
    to.resize(before + count, none);
  };
  append(all.materials, triangles, more.materials, more_triangles, -1);
  append(all.coordinates, 3 * triangles, more.coordinates, 3 * more_triangles, Eigen::Vector2f(0, 0));
  append(all.colours, 3 * triangles, more.colours, 3 * more_triangles, Eigen::Vector3f(1, 1, 1));
}

void name_parts_by_tree(const std::vector<Tree_node>& tree, const std::vector<int>& node_of_part,
                        const std::vector<std::string>& meshes, std::vector<Model_part>& parts)
{
  std::vector<std::size_t> parts_in(tree.size()); // number of parts in the subtree of a node
  for (int node : node_of_part)
    ++parts_in[std::size_t(node)];
  for (std::size_t i = tree.size(); i-- > 0;)
    if (tree[i].parent >= 0) parts_in[std::size_t(tree[i].parent)] += parts_in[i];
  // For each node, the nearest one, from itself upwards, with a name that is no default; -1: none
  std::vector<int> telling(tree.size());
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const int parent = tree[i].parent;
    telling[i] = !only_counts(tree[i].name) ? int(i) : parent < 0 ? -1 : telling[std::size_t(parent)];
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!only_counts(parts[i].name)) continue;
    const int node = telling[std::size_t(node_of_part[i])];
    if (node >= 0 && parts_in[std::size_t(node)] < parts.size())
      parts[i].name = tree[std::size_t(node)].name;
    else if (!only_counts(meshes[i]) || parts[i].name.empty())
      parts[i].name = meshes[i];
  }
}

} // namespace CGAL::Shape_correspondence::IO
