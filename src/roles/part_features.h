// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "roles/Boosted_trees.h"
#include "shape/Part_tree.h"

#include <vector>

namespace CGAL::Shape_correspondence::internal {

constexpr int part_feature_count = 68;

// The features from which the probability that a node of a part tree is a part is computed: one row for each node.
// \param quarter_turns turns about y after which the shape, in the frame of `surface`, faces +z
Byte_rows part_features(const Surface_patches& surface, const std::vector<Part_node>& nodes, int quarter_turns);

} // namespace CGAL::Shape_correspondence::internal
