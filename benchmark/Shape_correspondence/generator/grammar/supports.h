// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "Sketch.h"

namespace CGAL::Shape_correspondence::generator {

/// What a support carries: a rectangle about the y axis.
struct Carried
{
  double half_width, half_depth, height;

  double size() const { return half_width + half_depth; }
};

/// One leg: straight, tapered, curved, turned, or with a foot or caster.
Solid leg(Sketch& s, const Point& foot, const Point& top, double width);

/// Four legs, or five to eight under something long; may be joined by stretchers.
void add_legs(Sketch& s, const Carried& at, bool may_have_stretchers = true);

/// A column on a disc, a block, or three to six branches with or without casters; in one part or in several.
void add_column(Sketch& s, const Carried& at, bool on_casters = false);

/// Two sides: panels, loops, sledges, trestles or crossed bars; may be joined by a bar.
void add_sides(Sketch& s, const Carried& at, const std::string& role_of_bar = "stretcher");

/// One frame of bent tubes.
void add_leg_frame(Sketch& s, const Carried& at);

/// Rails or aprons along the four edges, in four parts or in one.
void add_rails(Sketch& s, const Carried& at, const std::string& role);

/// A knob, a bar or a bow on something that looks to +z.
Solid handle(Sketch& s, const Point& at, double length);

} // namespace CGAL::Shape_correspondence::generator
