// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "chairs.h"

namespace CGAL::Shape_correspondence::generator {

/// A top on two saw-horses.
Assembly table_trestle();

/// A round top with an edge ring on a turned post with four curved feet.
Assembly table_pedestal();

/// A kitchen table: turned legs, aprons, a drawer with a knob.
Assembly table_four_legged();

} // namespace CGAL::Shape_correspondence::generator
