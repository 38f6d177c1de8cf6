// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "Sketch.h"

namespace CGAL::Shape_correspondence::generator {

/// The rectangle about the y axis that a support carries, at a height above the floor.
struct Carried
{
  double half_width, half_depth, height;

  double size() const { return half_width + half_depth; }
};

/// One leg: straight, tapered, curved, turned, or with a foot or caster.
Solid leg(Sketch& s, const Point& foot, const Point& top, double width);

/// Adds four legs, or six under a long rectangle; at times joined by stretchers.
void add_legs(Sketch& s, const Carried& at, bool may_have_stretchers = true);

/// Adds a column on a plate, or on a star of three to six branches with or without casters; in one part or several.
void add_column(Sketch& s, const Carried& at, bool on_casters = false);

/// Adds two sides: panels, loops, trestles or crossed bars; at times joined by a bar.
void add_sides(Sketch& s, const Carried& at, const std::string& role_of_bar = "stretcher");

/// Adds a frame in one part: two loops joined by two bars.
void add_leg_frame(Sketch& s, const Carried& at);

/// Adds rails or aprons along the edges, each a part, or a frame of four in one part.
void add_rails(Sketch& s, const Carried& at, const std::string& role);

/// A knob, a bar or a bow at a point of a front that faces +z.
Solid handle(Sketch& s, const Point& at, double length);

} // namespace CGAL::Shape_correspondence::generator
