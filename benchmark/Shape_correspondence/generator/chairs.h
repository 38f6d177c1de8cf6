// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "assembly.h"
#include "primitives.h"

namespace CGAL::Shape_correspondence::generator {

Label leg_label(const std::string& row);

/// A seat that is `front` wide in front and `back` wide behind and hollow by `dish`.
Solid dished_seat(double front, double back, double depth, double y, double thickness, double dish,
                  const Slab_options& options);

/// A back rest from `low` along `rise`, `width` wide, its middle `bulge` behind its ends.
Solid curved_rest(const Point& low, const Point& rise, double width, double bulge, double thickness,
                  const Slab_options& options);

/// Four plain legs, aprons under the seat, a bent panel between two posts.
Assembly chair_four_legged();

/// An office chair: cushions, a gas column, a star of five legs on casters, arms.
Assembly chair_swivel();

/// A ladder-back chair with arms; its rear legs run on as the posts of the back.
Assembly chair_slatted();

/// A turned leg of unit height from the floor, thickest in its upper third.
Solid turned_leg(double height, double radius);

Solid turned_leg(const Point& foot, const Point& top, double radius);

/// A Windsor chair: turned splayed legs, an H of stretchers, spindles under a bow.
Assembly chair_spindle();

/// A bar stool: a round board with a cushion, four splayed legs, a foot ring.
Assembly stool();

} // namespace CGAL::Shape_correspondence::generator
