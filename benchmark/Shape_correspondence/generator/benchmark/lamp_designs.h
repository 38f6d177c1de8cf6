// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_LAMP_DESIGNS_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_LAMP_DESIGNS_H

#include "../furnishings.h"
#include "random.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

/// A shade that widens downwards, open below, hung from its top at the origin.
Solid lamp_shade(double height, double top, double bottom);

/// A bulb about the y axis, its socket at the origin, hanging.
Solid light_bulb(double size);

Solid upside_down(const Solid& solid);

Solid lamp_foot(double radius, double height);

Solid hinge(const Point& at, double radius);

/// A desk lamp of `rods` hinged rods, single or in pairs.
Assembly desk_lamp(const char* name, int rods, bool paired, bool clamp, std::uint64_t seed);

enum class Lamp_body { vase, column, candlestick, balls, pole, tripod };

/// A shade on a body: a table lamp or a floor lamp.
Assembly standing_lamp(const char* name, Lamp_body body, double height, std::uint64_t seed);

/// A foot, a pole that bends over in an arc, and a shade that hangs from its end.
Assembly arc_lamp(const char* name, std::uint64_t seed);

/// Links of a chain one below the other, turned in turns.
double add_lamp_chain(Assembly& lamp, double top, int n, double size);

/// A shade that hangs from the ceiling, by a chain or a rod.
Assembly pendant(const char* name, int links, std::uint64_t seed);

/// Curved arms around a body, each with a candle-like socket and a bulb; they may have small shades.
Assembly chandelier(const char* name, int arms, bool shades, std::uint64_t seed);

/// A bar at the ceiling with spots in a row, each in a bracket.
Assembly spot_bar(const char* name, int spots, std::uint64_t seed);

/// All lamps; `seed` is of the first one.
std::vector<Assembly> lamps(std::uint64_t seed);

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_LAMP_DESIGNS_H
