// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kinds.h"

namespace CGAL::Shape_correspondence::generator {

namespace {

// Proportions of an aeroplane, its nose at +z: length and radius of the body; half span, chord, sweep (shift to the
// rear over half span) and place of the wing; half span and place of the tail; height of the fin.
struct Plane
{
  double length, radius, span, chord, sweep, wing_z, wing_y, tail, tail_z, fin;

  double z(double t) const { return length * (.5 - t); } // t: from the nose (0) to the tail (1)
};

Plane plane_proportions(Sketch& s)
{
  Plane at;
  at.length = 10;
  at.radius = at.length * s.in(.035, .085);
  at.span = at.length * s.in(.28, .85);
  at.chord = at.length * s.in(.1, .3);
  at.sweep = s.chance(.5) ? s.in(-.05, .1) : s.in(.2, 1);
  at.wing_z = at.z(s.in(.25, .5));
  at.wing_y = s.any({-.7, -.4, 0., .8, 1.}) * at.radius;
  at.tail = at.length * s.in(.1, .24);
  at.tail_z = at.z(s.in(.86, .95));
  at.fin = at.length * s.in(.1, .22);
  return at;
}

void add_fuselage(Sketch& s, const Plane& at)
{
  const double blunt = s.in(.15, .6), rise = s.in(0, .8) * at.radius, tall = s.in(.9, 1.3);
  std::vector<Hull_station> stations;
  for (const double t : {0., .04, .15, .35, .6, .8, 1.}) {
    const double r = t < .15 ? blunt + (1 - blunt) * std::sqrt(t / .15) : t < .6 ? 1 : 1 - .85 * (t - .6) / .4;
    stations.push_back({at.z(t), t > .6 ? rise * (t - .6) / .4 : 0, r * at.radius, r * at.radius * tall});
  }
  s.add("fuselage", hull(stations, 12));
}

// A half wing, its root at x = 0.
Solid half_wing(const Point& root, double span, double chord, double tip_chord, double sweep, double rise,
                double thickness)
{
  const Point tip = root + Point(span, rise, -span * sweep);
  return wing({{root, chord, chord * thickness}, {tip, tip_chord, tip_chord * thickness}}, Point::UnitY(), 2);
}

void add_wings(Sketch& s, const Plane& at)
{
  const double tip = at.chord * s.in(.2, 1), rise = at.span * s.in(-.03, .12), thickness = s.in(.07, .16);
  const bool is_biplane = s.chance(.08);
  for (int i = 0; i <= int(is_biplane); ++i) {
    const Point root(0, i == 0 ? at.wing_y : at.wing_y + at.chord * s.in(.9, 1.3), at.wing_z - i * .2 * at.chord);
    const Solid half = half_wing(root, at.span, at.chord, tip, at.sweep, rise, thickness);
    const std::string fine = !is_biplane ? "wing" : i == 0 ? "wing_lower" : "wing_upper";
    if (s.chance(.25))
      s.add("wing", joined({half, mirrored(half)}), is_biplane ? fine : "");
    else
      s.add_pair("wing", half, fine);
    if (i == 0) continue;
    const double x = at.span * s.in(.5, .75);
    s.add_pair("strut",
               s.stick({x, at.wing_y, at.wing_z - .3 * at.chord}, {x, root.y(), at.wing_z - .4 * at.chord}, .08));
  }
  if (!is_biplane && at.wing_y > .5 * at.radius && s.chance(.35))
    s.add_pair("strut", s.stick({0, -at.radius * .8, at.wing_z - .3 * at.chord},
                                {at.span * .45, at.wing_y, at.wing_z - .3 * at.chord}, .08));
}

void add_tail(Sketch& s, const Plane& at)
{
  const double chord = at.fin * s.in(.4, .9), sweep = s.in(0, .9), tip = chord * s.in(.3, .9);
  const int kind = s.count(0, 9); // of tail: 0 to 5 low, 6 and 7 on the fin, 8 with two fins, 9 fin only
  const double y = kind < 6 ? s.in(0, .5) * at.radius : kind < 8 ? at.fin : at.radius * .3;
  const double back = kind >= 6 && kind < 8 ? at.fin * sweep : 0;
  const Solid half = half_wing({0, y, at.tail_z - back}, at.tail, chord * s.in(.7, 1), tip * .8, s.in(0, .6), 0, .1);
  if (kind != 9 && s.chance(.35))
    s.add("h_stab", joined({half, mirrored(half)}));
  else if (kind != 9)
    s.add_pair("h_stab", half);
  const auto fin = [&](double x) {
    return wing({{{x, 0, at.tail_z}, chord, chord * .1}, {{x, at.fin, at.tail_z - at.fin * sweep}, tip, tip * .1}},
                Point::UnitX(), 2);
  };
  if (kind == 8)
    s.add_pair("v_stab", fin(at.tail * s.in(.5, 1)));
  else if (s.chance(.9))
    s.add("v_stab", fin(0));
  if (s.chance(.06))
    s.add("canard", joined({half_wing({0, 0, at.z(.1)}, at.tail * .8, chord * .6, tip * .5, .4, 0, .1),
                            mirrored(half_wing({0, 0, at.z(.1)}, at.tail * .8, chord * .6, tip * .5, .4, 0, .1))}));
}

void add_propeller(Sketch& s, const Point& hub, double radius, bool is_pair)
{
  const int count = s.count(2, 4);
  Solids blades;
  const Solid one = s.block({0, radius / 2, 0}, {radius * .16, radius, radius * .04});
  for (int i = 0; i < count; ++i)
    blades.push_back(
        translated(transformed(one, rotation_about(Point::Zero(), Point::UnitZ(), 2 * pi * (i + .25) / count)), hub));
  blades.push_back(Sketch::block(hub, {radius * .3, radius * .3, radius * .5}, 1));
  if (is_pair)
    s.add_pair("propeller", joined(blades));
  else
    s.add("propeller", joined(blades));
}

void add_engines(Sketch& s, const Plane& at)
{
  const double radius = at.radius * s.in(.4, .9), length = radius * s.in(2.5, 6);
  const bool has_propellers = s.chance(.4);
  const auto nacelle = [&](const Point& front) {
    return hull({{front.z(), front.y(), radius * .8, radius * .8},
                 {front.z() - length * .3, front.y(), radius, radius},
                 {front.z() - length, front.y(), radius * .5, radius * .5}},
                12);
  };
  const auto under_wing = [&](double t) {
    return Point(at.span * t, at.wing_y - radius * s.in(-.2, 1.4),
                 at.wing_z - at.span * t * at.sweep + length * s.in(.1, .6));
  };
  const int kind = s.count(0, 5);
  if (kind == 0)
    return add_propeller(s, {0, 0, at.z(0) + .1}, at.radius * s.in(1.3, 3), false); // propeller at the nose
  if (kind == 1) {
    const Point front(0, 0, at.z(.2));
    s.add("engine", nacelle({0, at.radius * s.in(0, 1.2), at.z(.02)}));
    return add_propeller(s, front + Point(0, 0, at.length * .22), at.radius * 2, false);
  }
  if (kind == 2) {
    const Point front(at.radius + radius * s.in(.6, 1.2), at.radius * s.in(0, .8), at.z(s.in(.6, .75)));
    return s.add_pair("engine", translated(nacelle({0, front.y(), front.z()}), {front.x(), 0, 0}));
  }
  if (kind == 3 && s.chance(.5)) return; // engines inside the body are no parts
  const int count = s.chance(.3) ? 2 : 1;
  for (int i = 0; i < count; ++i) {
    const Point front = under_wing(i == 0 ? s.in(.25, .4) : s.in(.5, .7));
    const std::string which = count == 1 ? "" : i == 0 ? "_inner" : "_outer";
    s.add_pair("engine", translated(nacelle({0, front.y(), front.z()}), {front.x(), 0, 0}),
               which.empty() ? "" : "engine" + which);
    if (has_propellers) add_propeller(s, front + Point(0, 0, .1), radius * s.in(1.5, 3), true);
  }
}

Solid wheel_on_strut(Sketch& s, const Point& top, double low, double radius, int wheels)
{
  Solids all{s.stick({top.x(), low + radius, top.z()}, top, radius * .4)};
  for (int i = 0; i < wheels; ++i) {
    const double x = top.x() + (wheels == 1 ? 0 : (2 * i - 1) * radius * .5);
    all.push_back(beam({x - radius * .25, low + radius, top.z()}, {x + radius * .25, low + radius, top.z()},
                       round_section(radius, 12), 1));
  }
  return joined(all);
}

void add_gear(Sketch& s, const Plane& at)
{
  const double low = -at.radius * s.in(1.6, 3.2), radius = at.radius * s.in(.2, .55), x = at.radius * s.in(.6, 2.5);
  const bool has_tail_wheel = s.chance(.25);
  const double z = at.wing_z - at.chord * (has_tail_wheel ? .1 : .6);
  const Solid main = wheel_on_strut(s, {x, std::min(at.wing_y, 0.), z}, low, radius, s.count(1, 2));
  if (s.chance(.1))
    s.add("gear", joined({main, mirrored(main)}), "gear_main");
  else
    s.add_pair("gear", main);
  if (has_tail_wheel)
    s.add("gear", wheel_on_strut(s, {0, 0, at.z(.92)}, low * s.in(.3, .8), radius * .6, 1), "gear_tail");
  else if (s.chance(.9))
    s.add("gear", wheel_on_strut(s, {0, -at.radius * .5, at.z(s.in(.06, .18))}, low, radius * .8, s.count(1, 2)),
          "gear_nose");
}

} // namespace

void draw_aeroplane(Sketch& s)
{
  const Plane at = plane_proportions(s);
  add_fuselage(s, at);
  add_wings(s, at);
  add_tail(s, at);
  add_engines(s, at);
  if (s.chance(.85)) add_gear(s, at);
  if (s.chance(.3))
    s.add(
        "window",
        s.block({0, at.radius * .8, at.z(s.in(.12, .3))}, {at.radius * 1.3, at.radius * .8, at.length * s.in(.06, .2)}),
        "canopy");
}

} // namespace CGAL::Shape_correspondence::generator
