// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_MAP_PIECE_OF_H
#define CGAL_SHAPE_CORRESPONDENCE_MAP_PIECE_OF_H

#include "map/Part_pair.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// The piece of a part that a box of its chart cuts out, closed if the part is. All of it for the whole chart.
Part_mesh piece_of(const Points& points, const Eigen::Matrix3Xi& triangles, const Part_chart& chart,
                   const Chart_box& box);

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_MAP_PIECE_OF_H
