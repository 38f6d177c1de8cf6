// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kinds.h"
#include "supports.h"

namespace CGAL::Shape_correspondence::generator {

namespace {

// Proportions of a chair: half sizes of the seat, its upper and lower height, the height of the back.
struct Chair
{
  double x, z, low, high, top;
  double lean;          // shift of the top of the back to the rear
  double thickness = 0; // width of the bars of the back

  Point back(double side, double t) const { return {side * x, high + t * (top - high), -z - lean * t}; }
  Carried carried() const { return {x, z, low}; }
};

Chair proportions(Sketch& s)
{
  Chair at;
  const double high = s.chance(.15) ? s.in(.55, .85) : s.in(.3, .5),
               thickness = s.chance(.4) ? s.in(.07, .16) : s.in(.015, .06);
  at.x = s.in(.18, .34);
  at.z = at.x * s.in(.8, 1.2);
  at.high = high;
  at.low = high - thickness;
  at.top = high + s.in(.2, .8);
  at.lean = s.chance(.3) ? 0 : s.in(0, .3) * (at.top - high);
  at.thickness = s.in(.02, .05);
  return at;
}

void add_seat(Sketch& s, const Chair& at)
{
  const double thickness = at.high - at.low, y = (at.high + at.low) / 2;
  const double roundness = s.chance(.2) ? 1 : s.in(.05, .5);
  const auto seat = [&](double scale, double height, double middle) {
    return Sketch::block({0, middle, 0}, {2 * at.x * scale, height, 2 * at.z * scale}, roundness);
  };
  if (s.chance(.12)) { // slats
    const int count = s.count(3, 9);
    const double step = 2 * at.z / count;
    const Solid slat = s.block({0, y, 0}, {2 * at.x, thickness, step * s.in(.5, .85)});
    return s.add_several("seat", row(slat, {0, 0, -at.z + step / 2}, {0, 0, at.z - step / 2}, count));
  }
  s.add("seat", seat(1, thickness, y));
  if (thickness < .06 && s.chance(.25)) {
    const double height = s.in(.03, .1);
    s.add("seat", seat(s.in(.8, 1), height, at.high + height / 2), "cushion");
  }
}

// Adds a leg at each corner; the rear legs continue as posts of the back.
void add_legs_with_posts(Sketch& s, const Chair& at, double width)
{
  const double x = at.x - width / 2, z = at.z - width / 2;
  s.add_pair("leg", leg(s, {x, 0, z}, {x, at.low, z}, width), "", Place::corner);
  const Point foot(x, 0, -z - s.in(0, .25) * at.lean), knee(x, at.low, -z), end(x, at.top, -z - at.lean);
  const Solid post = at.lean > 0 ? s.rod({foot, knee, between(knee, end, .5), end}, width) : s.stick(foot, end, width);
  s.add_pair("leg", post, "", Place::corner);
}

void add_support(Sketch& s, const Chair& at)
{
  switch (s.count(0, 7)) {
  case 0: // a star on casters, as of an office chair
    if (s.chance(.7)) {
      const double height = s.in(.02, .06);
      s.add("seat_frame", s.block({0, at.low - height / 2, 0}, {at.x * s.in(.5, 1.2), height, at.z * s.in(.5, 1.2)}),
            "seat_mount");
      return add_column(s, {at.x, at.z, at.low - height}, true);
    }
    return add_column(s, at.carried(), true);
  case 1:
    return add_column(s, at.carried());
  case 2:
    return add_sides(s, at.carried());
  case 3:
    return add_leg_frame(s, at.carried());
  default:
    add_legs(s, at.carried());
    if (s.chance(.35)) add_rails(s, at.carried(), "seat_frame");
  }
}

// The bars of a back: level (a ladder) or upright.
Solids back_bars(Sketch& s, const Chair& at, double low, double high, double x)
{
  const int count = s.count(2, 8);
  Solids result;
  const bool level = s.chance(.5);
  const double bow = s.chance(.4) ? s.in(0, .15) * at.x : 0;
  for (int i = 0; i < count; ++i) {
    const double t = (i + .5) / count;
    if (level) {
      const double side = x / at.x, h = low + t * (high - low);
      result.push_back(s.rod({at.back(side, h), at.back(0, h) - Point(0, 0, bow), at.back(-side, h)}, at.thickness));
    } else {
      const double side = (2 * t - 1) * x / at.x;
      result.push_back(s.stick(at.back(side, low), at.back(side, high), at.thickness * .7));
    }
  }
  return result;
}

Solid back_board(Sketch& s, const Chair& at, double low, double high, double x, double thickness)
{
  const double bow = s.chance(.4) ? s.in(0, .3) * at.x : 0, corner = s.chance(.5) ? s.in(0, .18) : 0;
  const auto surface = [=](double u, double v) {
    const double side = (2 * u - 1) * x / at.x;
    return Point(at.back(side, low + v * (high - low)) + Point(0, 0, bow * side * side - thickness / 2));
  };
  Slab_options options;
  options.corner = corner;
  return slab(surface, thickness, options);
}

void add_framed_back(Sketch& s, const Chair& at, double width, bool has_posts)
{
  const double low = s.in(0, .3), rail = s.in(.02, .08), x = at.x - width;
  const Solids bars = back_bars(s, at, low, .95, x);
  if (s.chance(.7))
    s.add_several("back", bars, "", Place::none, .2);
  else
    s.add("back", back_board(s, at, low, .9, x, .4 * width), "back_panel");
  if (!has_posts && s.chance(.5)) {
    const Point a = at.back(1 - width / at.x, 0), b = at.back(1 - width / at.x, .9);
    const Solid hoop = s.rod({a, b, at.back(.5, 1), at.back(0, 1.03), at.back(-.5, 1), Point(-b.x(), b.y(), b.z()),
                              Point(-a.x(), a.y(), a.z())},
                             width);
    return s.add("back", hoop, "back_frame");
  }
  if (!has_posts)
    s.add_pair("back", s.stick(at.back(1 - width / at.x, -.1), at.back(1 - width / at.x, 1), width),
               s.chance(.5) ? "back_post" : "back");
  const Point end = at.back(1, 1);
  if (s.chance(.8)) s.add("back", s.block({0, end.y() - rail / 2, end.z()}, {2 * at.x, rail, width}), "back_top_rail");
  if (low > .1 && s.chance(.4))
    s.add("back", s.stick(at.back(-1, low), at.back(1, low), width * .8), "back_lower_rail");
}

void add_back(Sketch& s, const Chair& at, double width, bool has_posts)
{
  if (has_posts || s.chance(.35)) return add_framed_back(s, at, width, has_posts);
  const double thickness = s.chance(.4) ? s.in(.05, .15) : s.in(.012, .05), low = s.chance(.5) ? 0 : s.in(.1, .4);
  const double x = at.x * s.in(.7, 1.05);
  s.add("back", back_board(s, at, low, 1, x, thickness), s.chance(.2) && low == 0 ? "back_shell" : "");
  if (thickness < .05 && s.chance(.25)) {
    const double middle = s.in(.45, .6), height = (at.top - at.high) * s.in(.4, .75);
    const Point p = at.back(0, middle);
    s.add("back", s.cushion(p + Point(0, 0, .05), {1.7 * x, height, .08}), "back_cushion");
  }
  if (low > .1 && s.chance(.7))
    s.add("back", s.rod({{0, at.low, -.5 * at.z}, {0, at.low, -at.z - .03}, at.back(0, low)}, .05),
          s.chance(.5) ? "back_post" : "");
}

void add_arms(Sketch& s, const Chair& at, double width)
{
  const double height = at.high + s.in(.12, .28), x = at.x + s.in(-.5, 1) * width, front = at.z * s.in(.3, 1);
  const double rear = -at.z - at.lean * .3;
  if (s.chance(.25)) {
    const double low = s.chance(.5) ? at.low : at.low * s.in(0, .5), thick = s.in(.02, .14);
    return s.add_pair("armrest", s.block({at.x + thick / 2, (low + height) / 2, 0}, {thick, height - low, 2 * at.z}));
  }
  const Solid pad = s.chance(.5)
                        ? s.block({x, height, (front + rear) / 2}, {width * s.in(1, 2), width * .8, front - rear})
                        : s.rod({{x, height, rear}, {x, height * 1.01, 0}, {x, height, front}}, width);
  const double z = front * s.in(.3, .95);
  Solids support{s.stick({x, at.low, z}, {x, height, z}, width)};
  if (s.chance(.3)) support.push_back(s.stick({x, at.low, rear * .7}, {x, height, rear * .7}, width));
  if (s.chance(.5)) return s.add_pair("armrest", joined({pad, joined(support)}));
  s.add_pair("armrest", pad);
  if (s.chance(.85)) s.add_pair("armrest", joined(support), "armrest_support");
}

} // namespace

void draw_chair(Sketch& s)
{
  const Chair at = proportions(s);
  const double width = s.in(.025, .07);
  add_seat(s, at);
  const bool is_stool = s.chance(.1), has_posts = !is_stool && s.chance(.3);
  if (has_posts) {
    add_legs_with_posts(s, at, width);
    if (s.chance(.4)) add_rails(s, at.carried(), "seat_frame");
  } else {
    add_support(s, at);
  }
  if (!is_stool) add_back(s, at, width, has_posts);
  if (!is_stool && s.chance(.35)) add_arms(s, at, width);
}

} // namespace CGAL::Shape_correspondence::generator
