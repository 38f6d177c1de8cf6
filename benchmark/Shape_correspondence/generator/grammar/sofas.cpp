// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kinds.h"
#include "supports.h"

namespace CGAL::Shape_correspondence::generator {

namespace {

// Proportions of a sofa: half width and half depth of the seats, heights, thickness of arms and back, number of seats.
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
  at.x = at.places * s.in(.25, .38);
  at.z = s.in(.24, .45);
  at.low = s.chance(.25) ? 0 : s.in(.05, .22);
  at.seat = s.in(.3, .52);
  at.top = at.seat + s.in(.2, .65);
  at.arm = s.chance(.15) ? 0 : s.in(.06, .28);
  at.arm_height = s.chance(.12) ? at.top : at.seat + s.in(.02, .28);
  at.back = s.in(.08, .28);
  return at;
}

// Adds both arms: a block, a roll on a panel, a frame of bars, a bow, slats under a bar, or a body with a pad.
void add_arms(Sketch& s, const Sofa& at, double low, double front, double rear)
{
  const double x = at.x + at.arm / 2, height = at.arm_height - low, z = (front + rear) / 2, depth = front - rear;
  const double wood = std::min(at.arm, s.in(.02, .07));
  const Point upper(x, at.arm_height - wood / 2, front), lower(x, low, front);
  const auto behind = [&](const Point& p) { return Point(p.x(), p.y(), rear); };
  Solids arm;
  switch (s.count(0, 9)) {
  case 0: { // a roll, on a panel that may be thinner
    const double radius = std::min(at.arm * s.in(.5, .8), height * .5);
    const Point end(at.x + at.arm * s.in(.5, .8), at.arm_height - radius, front);
    arm = {s.block({x, (low + end.y()) / 2, z}, {at.arm * s.in(.6, 1), end.y() - low, depth}),
           beam(end, behind(end), round_section(radius, 12), 2)};
    break;
  }
  case 1: // a frame of bars
    arm = {s.stick(lower, upper, wood), s.stick(behind(lower), behind(upper), wood),
           s.stick(upper, behind(upper), wood)};
    if (s.chance(.5))
      arm.push_back(s.stick(lower + Point(0, wood / 2, 0), behind(lower) + Point(0, wood / 2, 0), wood));
    break;
  case 2: { // a bow
    arm = {tube(bent({lower, upper, behind(upper), behind(lower)}, .3 * std::min(height, depth)),
                s.is_square() ? bar(wood, wood) : round_section(wood / 2, 8))};
    break;
  }
  case 3: // slopes to the front, or is lower there
    arm = {mapped(s.block({x, low + height / 2, z}, {at.arm, height, depth}), [&, drop = s.in(.2, .6)](const Point& p) {
      const double t = (p.z() - rear) / depth;
      return Point(p.x(), low + (p.y() - low) * (1 - drop * t * t), p.z());
    })};
    break;
  case 4: { // a body and a pad
    const double pad = height * s.in(.1, .35);
    arm = {s.block({x, (low + at.arm_height - pad) / 2, z}, {at.arm, height - pad, depth}),
           s.block({x, at.arm_height - pad / 2, z}, {at.arm * s.in(.9, 1.2), pad, depth * s.in(.8, 1.05)})};
    break;
  }
  case 5: // slats under a bar
    arm = row(s.stick({x, low, rear}, {x, at.arm_height - wood, rear}, wood * .7), {0, 0, .05 * depth},
              {0, 0, .95 * depth}, s.count(2, 6));
    arm.push_back(s.block({x, at.arm_height - wood / 2, z}, {at.arm, wood, depth}));
    break;
  default:
    arm = {s.block({x, low + height / 2, z}, {at.arm, height, depth})};
  }
  if (s.chance(.75)) arm = {joined(arm)};
  for (const Solid& one : arm)
    s.add_pair("armrest", one);
  if (s.chance(.06)) s.add_pair("cushion", s.cushion({at.x - .06, at.seat + .1, z}, {.12, .2, depth * s.in(.4, .8)}));
}

// Adds the back: one block, one for each seat, a rail over bars, or a block with a roll or rail; at times it leans.
void add_back(Sketch& s, const Sofa& at, double low, double half_width)
{
  const double height = at.top - low, y = (low + at.top) / 2, z = -at.z - at.back / 2,
               lean = s.chance(.4) ? s.in(0, .35) : 0;
  const auto leant = [&](const Solid& solid) {
    return mapped(solid,
                  [&](const Point& p) { return Point(p.x(), p.y(), p.z() - lean * std::max(0., p.y() - at.seat)); });
  };
  const std::string fine = s.any({"", "", "back_frame"});
  const double wood = s.in(.02, .06);
  switch (s.count(0, 7)) {
  case 0: { // one block for each seat
    const double step = 2 * half_width / at.places;
    const Solid one = leant(s.block({0, y, z}, {step * .99, height, at.back}));
    return s.add_several("back", row(one, {-half_width + step / 2, 0, 0}, {half_width - step / 2, 0, 0}, at.places), "",
                         Place::side, .1);
  }
  case 1: { // a rail over bars
    Solids bars = row(s.stick({0, low, z}, {0, at.top - wood, z}, wood * s.in(.4, 1)), {-half_width + wood, 0, 0},
                      {half_width - wood, 0, 0}, s.count(3, 4 * at.places));
    bars.push_back(s.block({0, at.top - wood, z}, {2 * half_width, 2 * wood, wood}));
    for (Solid& one : bars)
      one = leant(one);
    return s.add_several("back", bars, fine, Place::none, .5);
  }
  case 2: { // a body and a roll or rail above
    const double roll = std::min(height * s.in(.1, .3), .2);
    s.add("back", leant(s.block({0, y - roll / 2, z}, {2 * half_width, height - roll, at.back})), fine);
    return s.add("back",
                 leant(s.chance(.5)
                           ? beam({-half_width, at.top - roll / 2, z}, {half_width, at.top - roll / 2, z},
                                  round_section(roll * s.in(.5, .8), 12), 2)
                           : s.block({0, at.top - roll / 2, z}, {2 * half_width, roll, at.back * s.in(.5, 1.3)})),
                 "back_top");
  }
  case 3: // higher in the middle or at the ends
    return s.add("back",
                 leant(mapped(s.block({0, y, z}, {2 * half_width, height, at.back}),
                              [&, rise = s.in(-.3, .3)](const Point& p) {
                                const double t = p.x() / half_width;
                                return Point(p.x(), low + (p.y() - low) * (1 + rise * (.5 - t * t)), p.z());
                              })),
                 fine);
  default:
    s.add("back", leant(s.block({0, y, z}, {2 * half_width, height, at.back})), fine);
  }
}

void add_arms_and_back(Sketch& s, const Sofa& at, double base_top)
{
  const double low = s.chance(.6) ? at.low : base_top, back_low = s.chance(.5) ? at.low : base_top;
  const bool is_between_arms = s.chance(.5);
  const double rear = is_between_arms ? -at.z - at.back * s.in(.2, 1) : -at.z;
  if (at.arm > 0 && s.chance(.1)) {
    const Solid arm =
        s.block({at.x + at.arm / 2, (low + at.arm_height) / 2, 0}, {at.arm, at.arm_height - low, 2 * at.z});
    const Solid back =
        s.block({0, (back_low + at.top) / 2, -at.z - at.back / 2}, {2 * at.outer_x(), at.top - back_low, at.back});
    return s.add("back", joined({back, arm, mirrored(arm)}), "back_arm_shell");
  }
  if (s.chance(.93)) add_back(s, at, back_low, is_between_arms ? at.x : at.outer_x());
  if (at.arm > 0) add_arms(s, at, low, at.z + s.in(-.1, .08), rear);
}

// Adds the base, with back and arms, or one body of them all; returns the height of the top of the base.
double add_base(Sketch& s, const Sofa& at)
{
  const double height = (at.seat - at.low) * s.in(.15, .7), top = at.low + height;
  const Solid base =
      s.block({0, (at.low + top) / 2, -at.back / 2}, {2 * at.outer_x() * s.in(.95, 1), height, 2 * at.z + at.back});
  if (s.chance(.25)) {
    const Solid back =
        s.block({0, (at.low + at.top) / 2, -at.z - at.back / 2}, {2 * at.outer_x(), at.top - at.low, at.back});
    const Solid arm = s.block({at.x + at.arm / 2, (at.low + at.arm_height) / 2, 0},
                              {std::max(at.arm, .01), at.arm_height - at.low, 2 * at.z});
    s.add("base", at.arm > 0 ? joined({base, back, arm, mirrored(arm)}) : joined({base, back}), "body");
  } else if (s.chance(.12)) { // a base of rails along the edges
    add_rails(s, {at.outer_x(), at.z, top}, "base");
    add_arms_and_back(s, at, top);
  } else {
    if (s.chance(.9)) s.add("base", base, s.any({"", "", "frame", "platform"}));
    if (s.chance(.1))
      s.add("base", s.block({0, (at.low + top) / 2, at.z + .01}, {2 * at.outer_x(), height * s.in(.7, 1), .03}),
            "base_front");
    add_arms_and_back(s, at, top);
  }
  return top;
}

// Adds the parts that reach to the front at one side: a chaise longue, or the second wing of a corner sofa.
void add_wing(Sketch& s, const Sofa& at, double low, double height, double roundness)
{
  const double side = s.any({-1., 1.}), width = s.in(.5, .75), length = s.in(.3, 1.6),
               x = side * (at.outer_x() - width / 2), z = at.z + length / 2;
  const bool is_corner = length > .8;
  const int count = is_corner ? s.count(1, 2) : 1;
  const double step = length / count;
  s.add_several("seat",
                row(Sketch::block({x, low + height / 2, at.z + step / 2}, {width, height, step * .98}, roundness),
                    {0, 0, 0}, {0, 0, length - step}, count),
                is_corner ? "seat_corner" : "seat_chaise", Place::none, .1);
  s.add("base", s.block({x, (at.low + low) / 2, z}, {width, std::max(low - at.low, .03), length}), "base_chaise");
  if (!is_corner) return;
  if (s.chance(.8))
    s.add("back",
          s.block({side * (at.outer_x() + at.back / 2), (at.low + at.top) / 2, z}, {at.back, at.top - at.low, length}),
          "back_corner");
  if (at.arm > 0 && s.chance(.5))
    s.add(
        "armrest",
        s.block({x, (at.low + at.arm_height) / 2, at.z + length + at.arm / 2}, {width, at.arm_height - at.low, at.arm}),
        "armrest_corner");
}

void add_seats(Sketch& s, const Sofa& at, double low)
{
  const double height = std::max(at.seat - low, .06), front = s.in(-.05, .1), roundness = s.in(.05, .5);
  const int count = s.chance(.35) ? 1 : at.places;
  const double step = 2 * at.x / count;
  const Solid one = Sketch::block({0, low + height / 2, front / 2}, {step * .98, height, 2 * at.z + front}, roundness);
  s.add_several("seat", row(one, {-at.x + step / 2, 0, 0}, {at.x - step / 2, 0, 0}, count), s.any({"", "seat_cushion"}),
                Place::side, .1);
  if (s.chance(.08)) // a second layer of cushions below
    s.add("seat", Sketch::block({0, low - height * .3, front / 2}, {2 * at.x, height * .6, 2 * at.z}, roundness),
          "seat_lower");
  if (at.places > 1 && s.chance(.15)) add_wing(s, at, low, height, roundness);
}

void add_cushions(Sketch& s, const Sofa& at)
{
  const double height = (at.top - at.seat) * s.in(.7, 1.1), thickness = s.in(.1, .22);
  if (s.chance(.55)) {
    const int count = s.chance(.2) ? 1 : at.places;
    const double step = 2 * at.x / count;
    const Solid one =
        transformed(s.cushion({0, at.seat + height / 2, -at.z + thickness / 2}, {step * .97, height, thickness}),
                    rotation_about({0, at.seat, -at.z}, Point::UnitX(), s.chance(.5) ? 0 : -s.in(0, .3)));
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
  const Carried carried{at.outer_x() * s.in(.75, 1), at.z + at.back / 2 * s.in(0, 1), at.low};
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

} // namespace CGAL::Shape_correspondence::generator
