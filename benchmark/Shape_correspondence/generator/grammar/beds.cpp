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

// A bed in the making: half width, half length, the upper height of the rails, the height of the ends, thickness of
// wood.
struct Bed
{
  double x, z, frame, head, foot, wood, rail;
};

Bed bed_proportions(Sketch& s)
{
  Bed at;
  at.x = s.in(.35, 1);
  at.z = s.in(.85, 1.1);
  at.frame = s.in(.18, .5);
  at.head = at.frame + s.in(.2, 1);
  at.foot = at.frame + s.in(.02, .5);
  at.wood = s.in(.02, .1);
  at.rail = at.frame * s.in(.25, .7);
  return at;
}

// A board, or rails and bars between posts, at one end.
void add_end(Sketch& s, const Bed& at, const std::string& role, double z, double height, bool is_framed)
{
  if (!is_framed) {
    const double low = s.chance(.5) ? 0 : at.frame - at.rail;
    if (!s.chance(.3))
      return s.add(role, s.block({0, (low + height) / 2, z}, {2 * at.x, height - low, at.wood * s.in(.6, 2.5)}));
    const double rail = (height - low) * s.in(.1, .2);
    s.add(role, s.block({0, (low + height) / 2, z}, {2 * at.x, height - low - rail, at.wood}), role + "_panel");
    return s.add(role, s.block({0, height - rail / 2, z}, {2 * at.x, rail, at.wood * 1.6}), role + "_rail");
  }
  const double low = at.frame - at.rail, x = at.x - at.wood / 2;
  const Solid top = s.stick({-x, height - at.wood, z}, {x, height - at.wood, z}, at.wood);
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
  if (s.chance(.15)) return s.add("base", s.block({0, at.frame / 2, 0}, {2 * at.x, at.frame, 2 * at.z}));
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
  const int pillows = s.count(0, 2);
  const double size = s.in(.25, .4), height = s.in(.06, .16), z = -at.z + size / 2 + .06;
  if (pillows == 1) s.add("pillow", s.cushion({0, top + height / 2, z}, {x * s.in(.8, 1.6), height, size}));
  if (pillows == 2) s.add_pair("pillow", s.cushion({x * .48, top + height / 2, z}, {x * s.in(.7, .92), height, size}));
  if (pillows == 2 && s.chance(.2))
    s.add_pair("pillow", s.cushion({x * .45, top + height, z + .2}, {x * .7, height, size * .8}));
  if (!s.chance(.55)) return;
  const double from = -at.z + s.in(.3, 1.1), thickness = s.in(.02, .1), hang = s.chance(.5) ? s.in(.05, .3) : 0;
  Solid blanket =
      s.block({0, top + thickness / 2 - hang / 2, (from + at.z) / 2}, {2 * x * 1.03, thickness + hang, at.z - from});
  s.add("bedding", blanket, s.chance(.6) ? "blanket" : "");
  if (s.chance(.25))
    s.add("bedding", s.block({0, top + thickness, from}, {2 * x * 1.04, thickness, s.in(.1, .3)}), "fold");
}

void add_mattress(Sketch& s, const Bed& at)
{
  const double height = s.in(.1, .32), sunk = s.in(0, .5) * at.rail, x = at.x - at.wood * s.in(.5, 1.2),
               top = at.frame - sunk + height;
  if (s.chance(.92)) s.add("mattress", s.block({0, top - height / 2, 0}, {2 * x, height, 1.96 * at.z}));
  add_bedding(s, at, top, x);
}

// An upper bed on the same posts, with guards and a ladder.
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

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
