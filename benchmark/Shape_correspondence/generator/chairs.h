// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_CHAIRS_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_CHAIRS_H

#include "assembly.h"
#include "primitives.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

Label leg_label(const std::string& row);

/// A seat of width `front` in front and `back` behind, whose middle is lower than its edges by `dish`.
Solid dished_seat(double front, double back, double depth, double y, double thickness, double dish,
                  const Slab_options& options);

/// A back rest of some width from `low` along `rise`, whose middle is `bulge` behind its sides.
Solid curved_rest(const Point& low, const Point& rise, double width, double bulge, double thickness,
                  const Slab_options& options);

/// A chair with four plain legs, aprons under the seat, a bent panel between two posts.
Assembly chair_four_legged();

/// An office chair: cushions, a gas column, a star of five legs on casters, arms.
Assembly chair_swivel();

/// A ladder-back chair with arms; its rear legs continue as the posts of the back.
Assembly chair_slatted();

/// A turned leg on the floor, thickest at 0.7 of its height.
Solid turned_leg(double height, double radius);

Solid turned_leg(const Point& foot, const Point& top, double radius);

/// A Windsor chair: turned splayed legs, an H of stretchers, spindles under a bow.
Assembly chair_spindle();

/// A bar stool: a round board with a cushion, four splayed legs, a foot ring.
Assembly stool();

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_CHAIRS_H
