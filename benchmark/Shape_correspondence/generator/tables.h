// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_TABLES_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_TABLES_H

#include "chairs.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

/// A table with a top on two saw-horses.
Assembly table_trestle();

/// A table with a round top and an edge ring, on a turned post with four curved feet.
Assembly table_pedestal();

/// A kitchen table: turned legs, aprons, a drawer with a knob.
Assembly table_four_legged();

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_TABLES_H
