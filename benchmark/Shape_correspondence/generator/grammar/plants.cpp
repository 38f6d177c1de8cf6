// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kinds.h"

namespace CGAL::Shape_correspondence::generator {

namespace {

// A leaf from the origin along z, bent down by about `bend` times its length; `width` is its greatest width.
Solid leaf(Sketch& s, double length, double width, double bend)
{
  const int kind = s.count(0, 2);
  if (kind == 0) return s.rod({{0, 0, 0}, {0, length * .1, length * .5}, {0, -length * bend, length}}, width * .3);
  return slab(
      [=](double u, double v) {
        const double shape = kind == 1 ? std::sin(pi * (.1 + .8 * v)) : 1 - .8 * v;
        return Point((u - .5) * width * shape, length * (.3 * v - bend * v * v), length * v);
      },
      length * .02);
}

void add_pot(Sketch& s, double radius, double height)
{
  switch (s.count(0, 2)) {
  case 0:
    s.add("pot", s.turned({0, 0, 0}, {0, height, 0}, radius * .6, radius));
    break;
  case 1:
    s.add("pot", Sketch::block({0, height / 2, 0}, {2 * radius, height, 2 * radius}, s.any({.08, .3})));
    break;
  default:
    s.add("pot", s.stick({0, 0, 0}, {0, height, 0}, 1.4 * radius, 2 * radius));
  }
  if (s.chance(.15)) s.add("pot", Sketch::block({0, .01, 0}, {2.4 * radius, .03, 2.4 * radius}, .5), "saucer");
  if (s.chance(.15))
    s.add("pot", torus({0, height, 0}, Point::UnitY(), radius, round_section(radius * .12, 6), 16), "rim");
  if (s.chance(.75)) s.add("soil", Sketch::block({0, height, 0}, {1.7 * radius, height * .08, 1.7 * radius}, .5));
}

} // namespace

void draw_plant(Sketch& s)
{
  const double radius = s.in(.08, .25), height = radius * s.in(.7, 3), tall = s.in(.2, 1.6), length = s.in(.15, .6);
  add_pot(s, radius, height);
  const bool has_stem = s.chance(.5);
  const double top = has_stem ? height + tall : height;
  if (has_stem && s.chance(.7))
    s.add("stem", s.rod({{0, height, 0}, {s.in(-.05, .05), height + tall / 2, 0}, {0, top, 0}}, s.in(.02, .06)));
  else if (has_stem)
    s.add_several("stem", ring(s.stick({0, height, 0}, {0, top, radius * .5}, .02), s.count(2, 4)));
  if (s.chance(.2)) // one crown of foliage
    return s.add_several("leaf", row(Sketch::block({0, top, 0}, {length * 2, length * 1.5, length * 2}, s.in(.5, 1)),
                                     Point::Zero(), {0, length * s.in(0, 2), 0}, s.count(1, 3)));
  if (s.chance(.12)) // a cactus or a ball of shoots
    return s.add_several("leaf", ring(s.turned({radius * .2, height, 0}, {radius * s.in(.2, 1), height + tall, 0},
                                               length * .1, length * .4),
                                      s.count(1, 5)));
  const int count = s.count(3, 14);
  Solids leaves;
  const Solid one = leaf(s, length, length * s.in(.1, .6), s.in(-.2, .8));
  for (int i = 0; i < count; ++i) {
    const double y = has_stem && s.chance(.7) ? s.in(height + tall * .4, top) : top;
    const Eigen::Isometry3d turn = rotation_about(Point::Zero(), Point::UnitY(), 2 * pi * (i + s.in(-.3, .3)) / count) *
                                   rotation_about(Point::Zero(), Point::UnitX(), -s.in(-.2, 1.3));
    leaves.push_back(translated(
        mapped(transformed(one, turn), [&, scale = s.in(.6, 1.1)](const Point& p) { return Point(scale * p); }),
        {0, y, 0}));
  }
  s.add_several("leaf", leaves, "", Place::none, .15);
}

} // namespace CGAL::Shape_correspondence::generator
