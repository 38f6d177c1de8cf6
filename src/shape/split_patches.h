// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "shape/Part_tree.h"

#include <CGAL/Shape_correspondence/split_parts.h>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The `surface_patches()` of objects, in the objects' own frame.
Surface_patches patches_of_objects(const Segmented_shape& objects, const std::vector<std::vector<int>>& materials);

/// Makes a part of each node of a cut. Patches take the place of loose pieces in objects where a part ends within one.
/// \param materials with which the surface was divided
/// \param nodes the tree of the patches \param cut indices of the nodes that are parts
Part_split split_patches(const Segmented_shape& objects, const Surface_patches& surface,
                         const std::vector<std::vector<int>>& materials, const std::vector<Part_node>& nodes,
                         const std::vector<std::size_t>& cut);

} // namespace CGAL::Shape_correspondence::internal
