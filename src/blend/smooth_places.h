// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Charted_mesh.h"

#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Where the vertices of a surface go on another one in the same coordinates: to the nearest places. Where these tear
/// neighbours apart, as between the two layers of a hull, vertices go to the places nearest to where they would be if
/// they moved as their neighbours do on average, some times over.
std::vector<Mesh_place> smooth_places(const Points& vertices, const Eigen::Matrix3Xi& triangles, const Points& onto,
                                      const Eigen::Matrix3Xi& onto_triangles);

} // namespace CGAL::Shape_correspondence::internal
