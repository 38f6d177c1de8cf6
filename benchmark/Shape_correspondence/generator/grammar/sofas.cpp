// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kinds.h"
#include "supports.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

namespace {

// A sofa in the making: half width and half depth of what people sit on, heights, and the thickness of arms and back.
struct Sofa
{
  double x, z, low, seat, top, arm, arm_height, back;
  int places;

  double outer_x() const { return x + arm; }
};

Sofa sofa_proportions(Sketch& s)
{
  Sofa at;
  at.places = s.count(1, 4);
  at.x = at.places * s.in(.28, .36);
  at.z = s.in(.28, .42);
  at.low = s.chance(.25) ? 0 : s.in(.05, .22);
  at.seat = s.in(.36, .48);
  at.top = at.seat + s.in(.25, .55);
  at.arm = s.chance(.15) ? 0 : s.in(.06, .28);
  at.arm_height = at.seat + s.in(.05, .28);
  at.back = s.in(.08, .28);
  return at;
}

void add_arms_and_back(Sketch& s, const Sofa& at, double base_top)
{
  const double depth = 2 * at.z + at.back, low = s.chance(.6) ? at.low : base_top;
  const bool is_between_arms = s.chance(.5);
  const double back_x = is_between_arms ? at.x : at.outer_x();
  const double back_low = s.chance(.5) ? at.low : base_top;
  const Solid back =
      s.block({0, (back_low + at.top) / 2, -at.z - at.back / 2}, {2 * back_x, at.top - back_low, at.back});
  Solid arm = s.block({at.x + at.arm / 2, (low + at.arm_height) / 2, -at.back / 2 * is_between_arms},
                      {at.arm, at.arm_height - low, is_between_arms ? depth : 2 * at.z});
  if (s.chance(.2)) {
    const Point end(at.x + at.arm * .6, at.arm_height - at.arm * .3, at.z);
    arm = joined({arm, beam(end, end - Point(0, 0, depth), round_section(at.arm * .6, 12), 2)});
  }
  if (at.arm > 0 && s.chance(.15)) return s.add("back", joined({back, arm, mirrored(arm)}), "back_arm_shell");
  if (s.chance(.9)) s.add("back", back, s.chance(.3) ? "back_frame" : "");
  if (at.arm > 0) s.add_pair("armrest", arm);
}

// The base, or one body of base, back and arms.
double add_base(Sketch& s, const Sofa& at)
{
  const double height = (at.seat - at.low) * s.in(.15, .7), top = at.low + height;
  const Solid base =
      s.block({0, (at.low + top) / 2, -at.back / 2}, {2 * at.outer_x() * s.in(.95, 1), height, 2 * at.z + at.back});
  if (s.chance(.35)) {
    const Solid back =
        s.block({0, (at.low + at.top) / 2, -at.z - at.back / 2}, {2 * at.outer_x(), at.top - at.low, at.back});
    const Solid arm = s.block({at.x + at.arm / 2, (at.low + at.arm_height) / 2, 0},
                              {std::max(at.arm, .01), at.arm_height - at.low, 2 * at.z});
    s.add("base", at.arm > 0 ? joined({base, back, arm, mirrored(arm)}) : joined({base, back}), "body");
  } else {
    if (s.chance(.9)) s.add("base", base, s.any({"", "", "frame", "platform"}));
    add_arms_and_back(s, at, top);
  }
  return top;
}

void add_seats(Sketch& s, const Sofa& at, double low)
{
  const double height = std::max(at.seat - low, .06), front = s.in(0, .1), roundness = s.in(.05, .5);
  const int count = s.chance(.35) ? 1 : at.places;
  const double step = 2 * at.x / count;
  const Solid one = Sketch::block({0, low + height / 2, front / 2}, {step * .98, height, 2 * at.z + front}, roundness);
  s.add_several("seat", row(one, {-at.x + step / 2, 0, 0}, {at.x - step / 2, 0, 0}, count), "", Place::side, .1);
  if (at.places > 1 && s.chance(.12)) {
    const double length = s.in(.3, .7), side = s.any({-1., 1.});
    s.add("seat",
          Sketch::block({side * (at.x - step / 2), low + height / 2, at.z + length / 2}, {step, height, length},
                        roundness),
          "seat_chaise");
    s.add("base",
          s.block({side * (at.x - step / 2), (at.low + low) / 2, at.z + length / 2},
                  {step, std::max(low - at.low, .03), length}),
          "base_chaise");
  }
}

void add_cushions(Sketch& s, const Sofa& at)
{
  const double height = (at.top - at.seat) * s.in(.7, 1.1), thickness = s.in(.1, .22);
  if (s.chance(.55)) {
    const int count = s.chance(.2) ? 1 : at.places;
    const double step = 2 * at.x / count;
    const Solid one = s.cushion({0, at.seat + height / 2, -at.z + thickness / 2}, {step * .97, height, thickness});
    s.add_several("back", row(one, {-at.x + step / 2, 0, 0}, {at.x - step / 2, 0, 0}, count), "back_cushion",
                  Place::side, .1);
  }
  if (!s.chance(.35)) return;
  const double size = s.in(.25, .45);
  const Solid pillow = transformed(s.cushion({0, 0, 0}, {size, size, size * .35}),
                                   rotation_about({0, 0, 0}, Point::UnitX(), -s.in(.1, .5)));
  for (int i = s.count(1, 4); i > 0; --i)
    s.add("cushion", translated(pillow, {s.any({-1., 1.}) * s.in(.4, .95) * (at.x - size / 2), at.seat + size / 2,
                                         -at.z + thickness + s.in(.05, .2)}));
}

} // namespace

void draw_sofa(Sketch& s)
{
  const Sofa at = sofa_proportions(s);
  const double seat_low = add_base(s, at);
  add_seats(s, at, seat_low);
  add_cushions(s, at);
  if (at.low == 0) return;
  const Carried carried{at.outer_x() * s.in(.8, 1), at.z + at.back / 2 * s.in(0, 1), at.low};
  switch (s.count(0, 5)) {
  case 0:
    return add_leg_frame(s, carried);
  case 1:
    return add_sides(s, carried, "leg");
  case 2:
    if (s.chance(.4))
      return s.add("base", s.block({0, at.low / 2, 0}, {1.8 * at.outer_x(), at.low, 1.8 * at.z}), "plinth");
    [[fallthrough]];
  default:
    add_legs(s, carried, false);
  }
}

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
