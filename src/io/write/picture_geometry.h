// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/write/glb_builder.h"

namespace CGAL::Shape_correspondence::IO {

/// A surface that is smooth where faces meet at less than 35° and has edges elsewhere.
Drawn_mesh shaded(const Points& points, const Eigen::Matrix3Xi& triangles);

/// A round tube along a polyline.
Drawn_mesh tube(const Points& polyline, bool closed, double radius);

/// The surface of a grid of points, row by row.
Drawn_mesh patch(const Points& grid, int rows, int cols);

/// All of them as one.
Drawn_mesh joined(const std::vector<Drawn_mesh>& meshes);

} // namespace CGAL::Shape_correspondence::IO
