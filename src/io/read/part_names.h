// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/read/model_parts.h"

namespace CGAL::Shape_correspondence::IO {

/// A node of the tree that a model file has.
struct Tree_node
{
  int parent; ///< -1: none
  std::string name;
};

/// Names parts of which the own name only counts, as `Object_4` does, after the nearest node above that says more, or
/// else after their mesh. Such a node is none of those that have all parts in them.
/// \param tree the nodes, each after its parent \param node_of_part the own node of each part
/// \param meshes the names of their meshes
void name_parts_by_tree(const std::vector<Tree_node>& tree, const std::vector<int>& node_of_part,
                        const std::vector<std::string>& meshes, std::vector<Model_part>& parts);

} // namespace CGAL::Shape_correspondence::IO
