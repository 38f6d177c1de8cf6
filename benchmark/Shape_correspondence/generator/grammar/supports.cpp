// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "supports.h"

namespace CGAL::Shape_correspondence::generator {

namespace {

// Adds bars between legs at corners: at all sides, left and right with or without one across, or only in front.
void add_stretchers(Sketch& s, const Point& corner, double width)
{
  const double x = corner.x(), y = corner.y(), z = corner.z();
  const auto bar_between = [&](const Point& a, const Point& b) { return s.stick(a, b, width); };
  const int kind = s.count(0, 3);
  if (kind == 0) {
    s.add("stretcher", bar_between({-x, y, z}, {x, y, z}), "", Place::corner);
    s.add("stretcher", bar_between({-x, y, -z}, {x, y, -z}), "", Place::corner);
  }
  if (kind != 3) s.add_pair("stretcher", bar_between({x, y, -z}, {x, y, z}), "", Place::corner);
  if (kind == 1) s.add("stretcher", bar_between({-x, y, 0}, {x, y, 0}));
  if (kind == 3) s.add("stretcher", bar_between({-x, y, z}, {x, y, z}), s.chance(.5) ? "footrest" : "");
}

Solid caster(Sketch& s, const Point& top, double radius)
{
  const Solid wheel =
      beam(top + Point(-radius / 2, -radius, 0), top + Point(radius / 2, -radius, 0), round_section(radius, 12), 1);
  return joined({wheel, s.stick(top - Point(0, radius, 0), top, radius / 2)});
}

void add_star(Sketch& s, double radius, double low, double hub, bool on_casters)
{
  const int count = s.count(3, 6);
  const double width = s.in(.08, .16) * radius,
               caster_radius = on_casters || s.chance(.5) ? s.in(.06, .12) * radius : 0;
  const double foot = 2 * caster_radius + width / 2;
  const Solid branch = s.stick({0, std::max(low, foot), 0}, {0, foot, radius}, width, width * s.in(.5, 1));
  Solids casters;
  if (caster_radius > 0) casters = ring(caster(s, {0, 2 * caster_radius, radius}, caster_radius), count);
  const Solids branches = ring(branch, count);
  if (s.chance(.45)) { // in one piece
    Solids all = branches;
    if (s.chance(.6)) all.insert(all.end(), casters.begin(), casters.end()), casters.clear();
    s.add("leg", joined(all));
  } else {
    for (const Solid& one : branches)
      s.add("leg", one);
    if (s.chance(.4)) s.add("leg", Sketch::block({0, low, 0}, {2 * hub, 2 * width, 2 * hub}, .5));
  }
  if (!casters.empty()) s.add_several("caster", casters, "", Place::none, .1);
}

Solids trestle(Sketch& s, const Carried& at, double x, double width)
{
  const double z = at.half_depth * s.in(.6, .95), y = at.height;
  if (s.chance(.4)) return {s.stick({x, 0, -z}, {x, y, z * .9}, width), s.stick({x, 0, z}, {x, y, -z * .9}, width)};
  if (s.chance(.5)) {
    const double spread = s.in(.1, .5) * z;
    return {s.stick({x, 0, -z}, {x, y, -spread}, width), s.stick({x, 0, z}, {x, y, spread}, width)};
  }
  return {s.stick({x, width / 2, -z}, {x, width / 2, z}, width), s.stick({x, width / 2, 0}, {x, y, 0}, width * 1.4),
          s.stick({x, y - width / 2, -z}, {x, y - width / 2, z}, width)};
}

Solid loop(Sketch& s, double x, double half_depth, double height, double width)
{
  const double h = height - width / 2, g = width / 2, d = half_depth;
  return s.chance(.5) ? tube(bent({{x, h, d}, {x, g, d}, {x, g, -d}, {x, h, -d}}, .2 * std::min(d, h)),
                             s.is_square() ? bar(width, width) : round_section(width / 2, 8))
                      : joined({s.stick({x, h, d}, {x, g, d}, width), s.stick({x, g, d}, {x, g, -d}, width),
                                s.stick({x, g, -d}, {x, h, -d}, width), s.stick({x, h, d}, {x, h, -d}, width)});
}

} // namespace

Solid leg(Sketch& s, const Point& foot, const Point& top, double width)
{
  switch (s.count(0, 5)) {
  case 0:
    return s.stick(foot, top, width * s.in(.3, .8), width);
  case 1: {
    const Point out = Point(foot.x() + top.x(), 0, foot.z() + top.z()).normalized() * width * s.in(-.8, .8);
    return s.rod({foot, between(foot, top, .3) - out, between(foot, top, .75) + out, top}, width);
  }
  case 2:
    return s.turned(foot, top, .25 * width, .6 * width);
  case 3:
    if (top.y() - foot.y() > 4 * width && s.chance(.3)) {
      const double radius = width * .7;
      return joined(
          {caster(s, foot + Point(0, 2 * radius, 0), radius), s.stick(foot + Point(0, 2 * radius, 0), top, width)});
    }
    [[fallthrough]];
  default:
    return s.stick(foot, top, width);
  }
}

void add_legs(Sketch& s, const Carried& at, bool may_have_stretchers)
{
  const double width = at.size() * s.in(.03, .11);
  const double splay = s.chance(.35) ? s.in(0, .3) : 0, inset = s.chance(.6) ? 0 : s.in(0, .35);
  const auto corner = [&](double out, double y) {
    return Point(out * (at.half_width * (1 - inset) - width / 2), y, out * (at.half_depth * (1 - inset) - width / 2));
  };
  const Solid one = leg(s, corner(1 + splay, 0), corner(1, at.height), width);
  s.add_four("leg", one);
  if (at.half_width > 1.6 * at.half_depth && s.chance(.12)) {
    const Point out(-corner(1 + splay / 2, 0).x(), 0, 0);
    s.add("leg", translated(one, out), "", Place::corner);
    s.add("leg", mirrored(snapped(translated(one, out)), 2), "", Place::corner);
  }
  if (may_have_stretchers && s.chance(.3)) {
    const double t = s.in(.12, .7);
    add_stretchers(s, corner(1 + splay * (1 - t), at.height * t), width * s.in(.35, .9));
  }
}

void add_column(Sketch& s, const Carried& at, bool on_casters)
{
  const double radius = at.size() / 2 * s.in(.5, 1.2), hub = at.size() * s.in(.02, .1);
  const double low = at.height * s.in(.06, .25);
  const int foot = on_casters ? 3 : s.count(0, 3);
  const Solid post = s.chance(.3)
                         ? s.turned({0, low, 0}, {0, at.height, 0}, hub * .5, hub * 1.5)
                         : s.stick({0, foot == 0 ? 0 : low, 0}, {0, at.height, 0}, 2 * hub, 2 * hub * s.in(.5, 1.2));
  const Solid plate = s.chance(.5) ? Sketch::block({0, low / 2, 0}, {2 * radius, low, 2 * radius}, s.any({.08, .5}))
                                   : s.turned({0, 0, 0}, {0, low, 0}, radius * .4, radius);
  if (foot == 0) {
    s.add_several("leg", {Sketch::block({0, low / 4, 0}, {2 * radius, low / 2, 2 * radius}, 1), post}, "", Place::none,
                  .5);
  } else if (foot == 1 && s.chance(.5)) {
    s.add_several("leg", {plate, post}, "", Place::none, .4);
  } else {
    add_star(s, radius, low, hub, on_casters);
    s.add("leg", post, "pedestal_post");
  }
}

void add_sides(Sketch& s, const Carried& at, const std::string& role_of_bar)
{
  const double width = at.size() * s.in(.02, .08), x = at.half_width * s.in(.6, 1) - width / 2;
  const int kind = s.count(0, 2);
  if (kind == 0)
    s.add_pair("leg", s.block({x, at.height / 2, 0}, {width, at.height, 2 * at.half_depth * s.in(.6, 1)}),
               s.chance(.3) ? "side_panel" : "leg", s.chance(.5) ? Place::side : Place::corner);
  else if (kind == 1)
    s.add_pair("leg", loop(s, x, at.half_depth * s.in(.7, 1), at.height, width), "", Place::corner);
  else if (const Solids bars = trestle(s, at, x, width); s.chance(.5))
    s.add_pair("leg", joined(bars), "", Place::corner);
  else
    for (const Solid& one : bars)
      s.add_pair("leg", one, "", Place::corner);
  if (s.chance(.4)) {
    const double y = at.height * s.in(.1, .8);
    s.add(role_of_bar, s.stick({-x, y, 0}, {x, y, 0}, width * s.in(.5, 1)));
  }
}

void add_leg_frame(Sketch& s, const Carried& at)
{
  const double width = at.size() * s.in(.02, .06), x = at.half_width * s.in(.7, 1);
  const Solid side = loop(s, x, at.half_depth * s.in(.6, 1), at.height, width);
  Solids all{side, mirrored(side)};
  const double y = s.chance(.5) ? width : at.height - width;
  for (const double z : {-.5, .5})
    all.push_back(s.stick({-x, y, z * at.half_depth}, {x, y, z * at.half_depth}, width));
  s.add("leg", joined(all), s.chance(.3) ? "leg_frame" : "");
}

void add_rails(Sketch& s, const Carried& at, const std::string& role)
{
  const double height = at.height * s.in(.06, .2), thickness = at.size() * s.in(.015, .06);
  const double x = at.half_width * s.in(.8, 1), z = at.half_depth * s.in(.8, 1), y = at.height - height / 2;
  const Solid front = s.block({0, y, z - thickness / 2}, {2 * x, height, thickness}),
              left = s.block({x - thickness / 2, y, 0}, {thickness, height, 2 * z});
  if (s.chance(.25))
    return s.add(role, joined({front, mirrored(front, 2), left, mirrored(left)}), s.chance(.5) ? "frame" : "");
  if (s.chance(.8)) {
    s.add(role, front, "", Place::corner);
    s.add(role, mirrored(snapped(front), 2), "", Place::corner);
  }
  s.add_pair(role, left, "", Place::corner);
}

Solid handle(Sketch& s, const Point& at, double length)
{
  const double out = length * s.in(.12, .3);
  switch (s.count(0, 3)) {
  case 0:
    return Sketch::block(at + Point(0, 0, out), {length / 3, length / 3, 2 * out}, 1);
  case 1:
    return s.rod({at - Point(length / 2, 0, 0), at + Point(-length / 3, 0, out), at + Point(length / 3, 0, out),
                  at + Point(length / 2, 0, 0)},
                 out / 2);
  case 2:
    return s.stick(at + Point(0, -length / 2, out), at + Point(0, length / 2, out), out);
  default:
    return s.stick(at + Point(-length / 2, 0, out), at + Point(length / 2, 0, out), out);
  }
}

} // namespace CGAL::Shape_correspondence::generator
