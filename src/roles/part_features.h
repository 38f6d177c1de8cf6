// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "roles/Boosted_trees.h"
#include "shape/Part_tree.h"

#include <vector>

namespace CGAL::Shape_correspondence::internal {

constexpr int part_feature_count = 68;

// The features that tell whether a node of a part tree is a part, node by node.
// \param quarter_turns about up, from the given frame, with which the shape faces +z
Byte_rows part_features(const Surface_patches& surface, const std::vector<Part_node>& nodes, int quarter_turns);

} // namespace CGAL::Shape_correspondence::internal
