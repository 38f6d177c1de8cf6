// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "Sketch.h"

#include <vector>

namespace CGAL::Shape_correspondence::generator {

/// A hollow shade about the y axis, closed above, open below: a cone, drum, dome or bell; at times with four sides.
Solid hood(Sketch& s, double low, double high, double low_radius, double high_radius);

Solid globe(const Point& middle, double radius);

/// The solids of a light that hangs from or stands on the origin.
struct Light
{
  Solids shades, bulbs, sockets;
};

/// A light with a shade, at times a bare bulb; its bulb and socket are drawn if asked for.
Light drawn_light(Sketch& s, double size, bool hangs, bool has_bulb, bool has_socket);

/// A candle, or a bulb like one, without a shade.
Light drawn_candle(Sketch& s, double size);

/// \param places where copies of the light are \param chance_of_one that they are one part
void add_light(Sketch& s, const Light& light, const std::vector<Eigen::Isometry3d>& places, double chance_of_one = .05);

} // namespace CGAL::Shape_correspondence::generator
