// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kinds.h"
#include "supports.h"

namespace CGAL::Shape_correspondence::generator {

namespace {

// Proportions of a bed: half width, half length; heights of the frame's upper edge, of head and foot; thickness of
// wood; height of the rails themselves.
struct Bed
{
  double x, z, frame, head, foot, wood, rail;
};

Bed bed_proportions(Sketch& s)
{
  Bed at;
  at.x = s.in(.33, 1.1);
  at.z = s.chance(.1) ? s.in(.55, .85) : s.in(.85, 1.15);
  at.frame = s.in(.18, .5);
  at.head = at.frame + s.in(.2, 1);
  at.foot = at.frame + s.in(.02, .5);
  at.wood = s.in(.02, .1);
  at.rail = at.frame * s.in(.25, .7);
  return at;
}

// Adds the headboard or footboard: a board, or rails and bars between posts.
void add_end(Sketch& s, const Bed& at, const std::string& role, double z, double height, bool is_framed)
{
  if (!is_framed) {
    const double low = s.chance(.5) ? 0 : at.frame - at.rail;
    const double half_width = at.x * (s.chance(.25) ? s.in(.9, 1.5) : 1), thickness = at.wood * s.in(.6, 2.5);
    const Solid panel = s.block({0, (low + height) / 2, z}, {2 * half_width, height - low, thickness});
    switch (s.count(0, 9)) {
    case 0: // higher in the middle or at the ends
      return s.add(role, mapped(panel, [&, rise = s.in(-.4, .3)](const Point& p) {
                     const double t = p.x() / half_width;
                     return Point(p.x(), low + (p.y() - low) * (1 - rise * t * t), p.z());
                   }));
    case 1: { // cushions side by side or above each other
      const int count = s.count(2, 6);
      const bool is_beside = s.chance(.6);
      const Point step = is_beside ? Point(2 * half_width / count, 0, 0) : Point(0, (height - low) / count, 0);
      const Point size = Point(2 * half_width, height - low, 0) - step * (count - 1) + Point(0, 0, thickness + .04);
      const Point first = -step * (count - 1) / 2 + Point(0, (low + height) / 2, z);
      return s.add_several(role, row(s.cushion(first, size * .99), {0, 0, 0}, step * (count - 1), count),
                           role + "_panel", Place::none, .15);
    }
    case 2: // wings at the sides
      s.add(role, panel);
      return s.add_pair(role,
                        s.block({half_width + thickness / 2, (low + height) / 2, z + (z < 0 ? .1 : -.1)},
                                {thickness, height - low, s.in(.1, .35)}),
                        role + "_wing");
    case 3: { // a case with boards
      const double depth = s.in(.12, .3), middle = z + (z < 0 ? -depth / 2 : depth / 2);
      s.add(role, s.block({0, height * .45, middle}, {2 * half_width, height * .9, depth}), role + "_box");
      return s.add(role, s.block({0, height * .95, middle}, {2 * half_width, height * .1, depth}), role + "_top");
    }
    case 4:
    case 5:
      break;
    default:
      return s.add(role, panel);
    }
    const double rail = (height - low) * s.in(.1, .2);
    s.add(role, s.block({0, (low + height) / 2, z}, {2 * at.x, height - low - rail, at.wood}), role + "_panel");
    return s.add(role, s.block({0, height - rail / 2, z}, {2 * at.x, rail, at.wood * 1.6}), role + "_rail");
  }
  const double low = s.chance(.7) ? at.frame - at.rail : .05 * height, x = at.x - at.wood / 2;
  const Solid top = s.stick({-x, height - at.wood, z}, {x, height - at.wood, z}, at.wood);
  if (s.chance(.15)) { // a bow, with or without bars
    Solids bow{tube(
        spline({{-x, low, z}, {-x, height * .8, z}, {0, height * s.in(1, 1.15), z}, {x, height * .8, z}, {x, low, z}},
               4),
        round_section(at.wood / 2, 8))};
    if (s.chance(.6))
      for (const Solid& one : row(s.stick({0, low, z}, {0, height * .85, z}, at.wood * .4), {-x * .8, 0, 0},
                                  {x * .8, 0, 0}, s.count(3, 8)))
        bow.push_back(one);
    return s.add_several(role, bow, "", Place::none, .5);
  }
  if (s.chance(.4))
    return s.add_several(role,
                         {s.block({0, (low + height) / 2, z}, {2 * x, height - low - at.wood, at.wood * .4}), top}, "",
                         Place::none, .4);
  Solids bars;
  const int count = s.count(2, 9);
  if (s.chance(.5))
    bars = row(s.stick({0, low, z}, {0, height - at.wood, z}, at.wood * .5), {-x * .85, 0, 0}, {x * .85, 0, 0}, count);
  else
    bars = row(s.block({0, low, z}, {2 * x, (height - low) / count * .5, at.wood * .5}), {0, .1 * (height - low), 0},
               {0, .8 * (height - low), 0}, count);
  bars.push_back(top);
  s.add_several(role, bars, "", Place::none, .3);
}

void add_posts(Sketch& s, const Bed& at)
{
  const double x = at.x - at.wood / 2, z = at.z;
  const bool is_canopy = s.chance(.12);
  const double high = is_canopy ? s.in(1.6, 2.1) : 0, width = at.wood * s.in(.9, 1.5);
  const auto post = [&](double end, double height) {
    return s.chance(.3) ? s.turned({x, 0, end}, {x, height, end}, width * .3, width * .6)
                        : s.stick({x, 0, end}, {x, height, end}, width);
  };
  s.add_pair("leg", post(z, is_canopy ? high : at.foot + s.in(0, .08)), "", Place::corner);
  s.add_pair("leg", post(-z, is_canopy ? high : at.head + s.in(0, .08)), "", Place::corner);
  if (s.chance(.15))
    s.add_pair("leg", Sketch::block({x, (is_canopy ? high : at.foot) + width, z}, Point::Constant(2 * width), 1),
               "leg_knob");
}

void add_rails_of(Sketch& s, const Bed& at)
{
  const double y = at.frame - at.rail / 2;
  if (s.chance(.3)) {
    const Solid frame = s.chance(.5) ? s.block({0, y, 0}, {2 * at.x, at.rail, 2 * at.z})
                                     : joined({s.block({at.x - at.wood / 2, y, 0}, {at.wood, at.rail, 2 * at.z}),
                                               s.block({-at.x + at.wood / 2, y, 0}, {at.wood, at.rail, 2 * at.z}),
                                               s.block({0, y, at.z}, {2 * at.x, at.rail, at.wood}),
                                               s.block({0, y, -at.z}, {2 * at.x, at.rail, at.wood})});
    return s.add(s.chance(.6) ? "side_rail" : "base", frame, s.chance(.5) ? "bed_frame" : "");
  }
  if (s.chance(.2)) {
    const double low = s.chance(.5) ? 0 : at.frame * s.in(.1, .5), over = s.chance(.7) ? 1 : s.in(1, 1.2);
    s.add("base", s.block({0, (low + at.frame) / 2, 0}, {2 * at.x * over, at.frame - low, 2 * at.z * over}));
    if (low > 0 && s.chance(.4)) s.add("base", s.block({0, low / 2, 0}, {1.6 * at.x, low, 1.6 * at.z}), "plinth");
    return;
  }
  if (s.chance(.12)) { // a fence of bars, as of a cot
    const double x = at.x - at.wood / 2, low = at.frame - at.rail, high = std::min(at.head, at.frame + .4);
    Solids bars =
        row(s.stick({x, low, 0}, {x, high, 0}, at.wood * .5), {0, 0, -.95 * at.z}, {0, 0, .95 * at.z}, s.count(5, 14));
    for (const double height : {low, high})
      bars.push_back(s.stick({x, height, -at.z}, {x, height, at.z}, at.wood));
    return s.add_pair("side_rail", joined(bars));
  }
  s.add_pair("side_rail", s.block({at.x - at.wood / 2, y, 0}, {at.wood, at.rail, 2 * at.z}));
  if (s.chance(.3)) {
    const int count = s.count(5, 14);
    s.add_several("slat",
                  row(s.block({0, at.frame - at.rail * .4, 0}, {1.9 * at.x, at.wood * .3, 1.3 * at.z / count}),
                      {0, 0, -.93 * at.z}, {0, 0, .93 * at.z}, count),
                  "", Place::none, .2);
  } else if (s.chance(.4)) {
    s.add("base", s.block({0, at.frame - at.rail * .4, 0}, {1.9 * at.x, at.wood * .5, 1.95 * at.z}),
          s.chance(.5) ? "mattress_board" : "");
  }
}

void add_bedding(Sketch& s, const Bed& at, double top, double x)
{
  const int pillows = s.count(0, 3);
  const double size = s.in(.25, .4), height = s.in(.06, .16), z = -at.z + size / 2 + .06;
  if (pillows == 1) s.add("pillow", s.cushion({0, top + height / 2, z}, {x * s.in(.8, 1.6), height, size}));
  if (pillows == 2) s.add_pair("pillow", s.cushion({x * .48, top + height / 2, z}, {x * s.in(.7, .92), height, size}));
  if (pillows == 2 && s.chance(.2))
    s.add_pair("pillow", s.cushion({x * .45, top + height, z + .2}, {x * .7, height, size * .8}));
  if (pillows == 3) { // rows of pillows, at times with a roll
    if (s.chance(.3))
      s.add("pillow",
            beam({-x * .8, top + size * .3, z}, {x * .8, top + size * .3, z}, round_section(size * .3, 12), 2));
    const int rows = s.count(1, 3);
    for (int i = 0; i < rows; ++i) {
      const double width = x * s.in(.5, .9), tilt = s.in(0, 1.1);
      s.add_pair("pillow",
                 transformed(s.cushion({x * .47, top + size * .3, z + .15 * i}, {width, height, size * s.in(.6, 1)}),
                             rotation_about({0, top, z + .15 * i}, Point::UnitX(), -tilt)));
    }
  }
  if (!s.chance(.55)) return;
  const double from = -at.z + s.in(.3, 1.1), thickness = s.in(.02, .1), hang = s.chance(.5) ? s.in(.05, .3) : 0;
  const double end = s.chance(.8) ? at.z : at.z - s.in(.1, .5) * (at.z - from);
  const Solid blanket =
      s.chance(.6)
          ? s.block({0, top + thickness / 2 - hang / 2, (from + end) / 2}, {2 * x * 1.03, thickness + hang, end - from})
          : slab(
                [=](double u, double v) { // the blanket hangs down at the sides
                  const double across = 2 * u - 1, fall = std::max(0., std::abs(across) - .8) / .2;
                  return Point(across * x * 1.05, top + thickness - fall * (hang + thickness), from + v * (end - from));
                },
                thickness * .5 + .005);
  s.add("bedding", blanket, s.chance(.6) ? "blanket" : "");
  if (s.chance(.25))
    s.add("bedding", s.block({0, top + thickness, from}, {2 * x * 1.04, thickness, s.in(.1, .3)}), "fold");
}

void add_mattress(Sketch& s, const Bed& at)
{
  const double height = s.in(.1, .32), sunk = s.in(0, .5) * at.rail, x = at.x - at.wood * s.in(.5, 1.2),
               top = at.frame - sunk + height;
  if (s.chance(.08)) // two mattresses side by side
    s.add_pair("mattress", s.block({x / 2, top - height / 2, 0}, {.99 * x, height, 1.96 * at.z}));
  else if (s.chance(.92))
    s.add("mattress", s.block({0, top - height / 2, 0}, {2 * x, height, 1.96 * at.z}));
  if (s.chance(.1))
    s.add("mattress", s.block({0, top + .01, 0}, {1.98 * x, s.in(.02, .07), 1.94 * at.z}), "mattress_topper");
  add_bedding(s, at, top, x);
}

// Adds an upper bed on the same posts, at times with guards and a ladder.
void add_upper_bed(Sketch& s, const Bed& at)
{
  Bed upper = at;
  upper.frame = at.frame + s.in(.8, 1.1);
  add_rails_of(s, upper);
  add_mattress(s, upper);
  const double y = upper.frame + .3, x = at.x - at.wood / 2;
  if (s.chance(.7)) s.add_pair("side_rail", s.block({x, y, 0}, {at.wood * .6, .08, 2 * at.z}), "guard_rail");
  Solids ladder{s.stick({x + .1, 0, .2}, {x, y, .2}, .04), s.stick({x + .1, 0, .55}, {x, y, .55}, .04)};
  for (int i = s.count(3, 6); i > 0; --i)
    ladder.push_back(s.stick({x + .05, y * i / 7, .2}, {x + .05, y * i / 7, .55}, .035));
  if (s.chance(.8)) s.add_several("ladder", ladder, "", Place::none, .5);
}

void add_drawers(Sketch& s, const Bed& at)
{
  const int count = s.count(1, 3);
  const double length = 1.7 * at.z / count, height = at.frame - at.rail;
  for (const double side : {1., -1.})
    if (side > 0 || s.chance(.5)) {
      for (const Solid& one : row(s.block({side * at.x * .6, height * .5, 0}, {at.x * .8, height * .85, length * .95}),
                                  {0, 0, -.85 * at.z + length / 2}, {0, 0, .85 * at.z - length / 2}, count))
        s.add("drawer", one);
    }
}

} // namespace

void draw_bed(Sketch& s)
{
  Bed at = bed_proportions(s);
  const bool has_posts = s.chance(.4), is_bunk = has_posts && s.chance(.2);
  if (is_bunk) at.head = at.foot = at.frame + s.in(1.2, 1.6);
  if (s.chance(.9)) add_end(s, at, "headboard", -at.z, at.head, has_posts);
  if (s.chance(.6)) add_end(s, at, "footboard", at.z, at.foot, has_posts);
  if (has_posts)
    add_posts(s, at);
  else if (s.chance(.6))
    add_legs(s, {at.x, at.z, at.frame - at.rail}, false);
  add_rails_of(s, at);
  add_mattress(s, at);
  if (is_bunk) add_upper_bed(s, at);
  if (!is_bunk && s.chance(.15)) add_drawers(s, at);
}

} // namespace CGAL::Shape_correspondence::generator
