// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_FURNISHINGS_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_FURNISHINGS_H

#include "chairs.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

/// A single bed, its head at the back: four posts, slats, a mattress, two pillows.
Assembly bed_slatted();

/// A desk lamp with two hinged pairs of rods and a bell for a shade.
Assembly lamp_desk();

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_FURNISHINGS_H
