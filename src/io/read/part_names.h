// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/read/model_parts.h"

namespace CGAL::Shape_correspondence::IO {

struct Tree_node
{
  int parent; ///< -1: none
  std::string name;
};

/// Names parts with default names, such as `Object_4`, after the nearest ancestor node with a better name that does not
/// contain all parts, or else after their mesh.
/// \param tree the nodes, each after its parent \param node_of_part the node of each part
/// \param meshes names of the parts' meshes
void name_parts_by_tree(const std::vector<Tree_node>& tree, const std::vector<int>& node_of_part,
                        const std::vector<std::string>& meshes, std::vector<Model_part>& parts);

} // namespace CGAL::Shape_correspondence::IO
