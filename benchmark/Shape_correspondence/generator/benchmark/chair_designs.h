// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_CHAIR_DESIGNS_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_CHAIR_DESIGNS_H

#include "../chairs.h"
#include "random.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

enum class Chair_base { plain, turned, sled, cantilever, x_frame, swivel, column };
enum class Chair_back { none, solid, cushion, ladder, slatted, spindle };
enum class Chair_arms { none, to_seat, to_back, to_both };

struct Chair_design
{
  const char* name;
  Chair_base base;
  Chair_back back;
  Chair_arms arms = Chair_arms::none;
  int bars = 4;        ///< slats or spindles of the back
  bool aprons = false; ///< rails under the seat
  bool stretchers = false;
};

/// Measures of a chair; the back rises from the rear edge of the seat and leans backwards.
struct Chair_frame
{
  double width, depth, height, back_height, lean, wood;

  explicit Chair_frame(Random& random)
      : width(random.about(.45)),
        depth(random.about(.44)),
        height(random.about(.45, .06)),
        back_height(random.about(.48)),
        lean(random.between(.1, .28)),
        wood(random.about(.034, .2))
  {}

  double top() const { return height + back_height; }
  double back_x() const { return width / 2 - .8 * wood; }
  double back_z(double y) const { return -depth / 2 + .8 * wood - lean * std::max(y - height, 0.); }
  Point at_back(double x, double y) const { return {x, y, back_z(y)}; }
  /// Along the back, up by `dy`.
  Point up_back(double dy) const { return {0, dy, -lean * dy}; }
};

/// Legs under the corners of the seat; where the back is framed, the rear ones run on as its posts.
void add_four_chair_legs(Assembly& chair, const Chair_frame& f, const Chair_design& design, bool posts);

/// Two runners on the floor, each with a front and a rear upright in one bent piece, and bars across under the seat.
void add_sled_base(Assembly& chair, const Chair_frame& f);

/// Two bent tubes, each from under the seat down in front and back along the floor, joined behind.
void add_cantilever_base(Assembly& chair, const Chair_frame& f);

/// Crossed legs on either side, a bolt through them, rods across at their feet.
void add_x_base(Assembly& chair, const Chair_frame& f);

/// A mount, a column, and a star on casters, or a plate.
void add_column_base(Assembly& chair, const Chair_frame& f, Random& random, bool star);

void add_chair_back(Assembly& chair, const Chair_frame& f, const Chair_design& design, bool posts_are_legs);

void add_chair_arms(Assembly& chair, const Chair_frame& f, const Chair_design& design);

Assembly chair(const Chair_design& design, std::uint64_t seed);

const std::vector<Chair_design>& chair_designs();

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_CHAIR_DESIGNS_H
