// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Piece_pair.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

namespace CGAL::Shape_correspondence::internal {

/// The piece of a part cut out by a box in its chart, closed if the part is closed. The whole part for the whole chart.
Part_mesh piece_of(const Part_mesh& part, const Part_chart& chart, const Chart_box& box);

} // namespace CGAL::Shape_correspondence::internal
