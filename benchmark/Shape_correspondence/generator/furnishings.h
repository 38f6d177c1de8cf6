// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "chairs.h"

namespace CGAL::Shape_correspondence::generator {

/// A single bed, its head at the back: four posts, slats, a mattress, two pillows.
Assembly bed_slatted();

/// A desk lamp with two hinged pairs of rods and a bell for a shade.
Assembly lamp_desk();

} // namespace CGAL::Shape_correspondence::generator
