// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "shape/meshes.h"

#include <CGAL/Shape_correspondence/segment_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Segments of a closed connected surface that are nearly convex, smooth or of one thickness.
/// \param patches number of patches that the segments are made of, at least 1
/// \return by face, the number of its segment; segments are numbered by their first faces; empty if no point of the
/// surface sees another one through the inside
/// \pre the mesh bounds a volume, and has no garbage
std::vector<std::size_t> convex_segments(const Halfedge_mesh& mesh, std::size_t patches,
                                         const Segmentation_options& options);

} // namespace CGAL::Shape_correspondence::internal
