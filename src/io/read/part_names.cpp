// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/part_names.h"

#include <algorithm>
#include <cctype>

namespace CGAL::Shape_correspondence::IO {
namespace {

/// Whether a name is a default for unnamed objects: a number, or one of these words with or without a number.
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

void name_parts_by_tree(const std::vector<Tree_node>& tree, const std::vector<int>& node_of_part,
                        const std::vector<std::string>& meshes, std::vector<Model_part>& parts)
{
  std::vector<std::size_t> parts_in(tree.size()); // number of parts in the subtree of a node
  for (int node : node_of_part)
    ++parts_in[std::size_t(node)];
  for (std::size_t i = tree.size(); i-- > 0;)
    if (tree[i].parent >= 0) parts_in[std::size_t(tree[i].parent)] += parts_in[i];
  // The nearest node, from the node itself upwards, with a name that is no default
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
