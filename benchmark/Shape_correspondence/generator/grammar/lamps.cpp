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

// A hollow shade about the y axis, wider at `low` than at `high` or the reverse; open at one end or both.
Solid shade(Sketch& s, double low, double high, double low_radius, double high_radius)
{
  const double wall = std::max(low_radius, high_radius) * .03, bulge = s.chance(.4) ? s.in(0, .6) : 0;
  Profile outer, inner;
  constexpr int steps = 5;
  for (int i = 0; i <= steps; ++i) {
    const double t = double(i) / steps, r = low_radius + t * (high_radius - low_radius) +
                                            bulge * std::sin(pi * t) * std::abs(low_radius - high_radius) / 2;
    outer.push_back({std::max(r, 2 * wall), low + t * (high - low)});
    inner.push_back({std::max(r, 2 * wall) - wall, low + t * (high - low) - (i == steps ? 2 * wall : 0)});
  }
  Profile all{{0, inner.back().y()}};
  all.insert(all.end(), inner.rbegin(), inner.rend());
  all.insert(all.end(), outer.begin(), outer.end());
  all.push_back({0, high});
  return post(all, s.is_square() && s.chance(.3) ? 4 : 16);
}

Solid globe(const Point& middle, double radius) { return Sketch::block(middle, Point::Constant(2 * radius), 1); }

// Any shade, with its bulb inside or below; it hangs from or stands on `at`.
struct Light
{
  Solids shades, bulbs, sockets;
};

Light drawn_light(Sketch& s, double size, bool hangs, bool has_bulb, bool has_socket)
{
  Light result;
  const double height = size * s.in(.7, 2), wide = size * s.in(.8, 1.3), narrow = wide * s.in(.15, .9);
  switch (s.count(0, 4)) {
  case 0:
    result.shades = {globe({0, hangs ? -size : size, 0}, size)};
    break;
  case 1:
    result.shades = {s.block({0, hangs ? -height / 2 : height / 2, 0}, {2 * wide, height, 2 * wide})};
    break;
  default:
    result.shades = {hangs ? shade(s, -height, 0, wide, narrow) : shade(s, 0, height, wide, narrow)};
  }
  const double radius = size * s.in(.15, .4), y = (hangs ? -1 : 1) * height * s.in(.3, .8);
  if (has_bulb)
    result.bulbs = {s.chance(.6) ? globe({0, y, 0}, radius)
                                 : s.turned({0, y - radius, 0}, {0, y + radius, 0}, radius * .3, radius)};
  if (has_socket) result.sockets = {s.stick({0, hangs ? 0 : -height * .1, 0}, {0, y * .6, 0}, radius)};
  return result;
}

// \param joins_all one part for several lights
void add_light(Sketch& s, const Light& light, const std::vector<Eigen::Isometry3d>& places, double chance_of_one = .05)
{
  const auto placed = [&](const Solids& solids) {
    Solids result;
    for (const Eigen::Isometry3d& place : places)
      for (const Solid& one : solids)
        result.push_back(transformed(one, place));
    return result;
  };
  s.add_several("shade", placed(light.shades), "", Place::none, chance_of_one);
  if (!light.bulbs.empty()) s.add_several("bulb", placed(light.bulbs), "", Place::none, chance_of_one);
  if (!light.sockets.empty()) s.add_several("body", placed(light.sockets), "bulb_socket", Place::none, chance_of_one);
}

Eigen::Isometry3d moved(const Point& to) { return Eigen::Isometry3d(Eigen::Translation3d(to)); }

// What a lamp stands on; \return its height.
double add_foot(Sketch& s, double radius)
{
  const double height = radius * s.in(.08, .6);
  if (s.chance(.2)) {
    const Point out(0, 0, radius * 1.3), knee(0, radius * s.in(1, 4), 0);
    s.add_several(s.chance(.5) ? "base" : "body", ring(s.stick(out, knee, radius * .12), 3), "", Place::none, .4);
    return knee.y();
  }
  const Solid foot = s.chance(.5)
                         ? s.turned({0, 0, 0}, {0, height, 0}, radius * .5, radius)
                         : Sketch::block({0, height / 2, 0}, {2 * radius, height, 2 * radius}, s.any({.07, .3, 1.}));
  s.add("base", foot);
  return height;
}

// Standing: a foot, a post or a vase, a shade above.
void draw_standing_lamp(Sketch& s)
{
  const double height = s.in(.25, 1.8), size = s.in(.08, .28) * (height > 1 ? 1 : .8), radius = s.in(.08, .22);
  const bool is_vase = height < .8 && s.chance(.5);
  const double low = is_vase && s.chance(.5) ? 0 : add_foot(s, radius);
  const double width = s.in(.01, .05);
  const Solid body = is_vase        ? s.turned({0, low, 0}, {0, height, 0}, .02, radius)
                     : s.chance(.2) ? s.turned({0, low, 0}, {0, height, 0}, width * .4, width * 1.2)
                                    : s.stick({0, low, 0}, {0, height, 0}, width);
  if (!is_vase && s.chance(.2)) {
    const int count = s.count(2, 4);
    for (const Solid& one : row(s.stick({0, low, 0}, {0, low + (height - low) / count, 0}, width), Point::Zero(),
                                {0, (height - low) * (count - 1) / count, 0}, count))
      s.add("body", one);
  } else {
    s.add("body", body, s.any({"", "", "post", is_vase ? "vase" : ""}));
  }
  if (s.chance(.2)) { // arms with a light each
    const int count = s.count(2, 6);
    const double reach = s.in(.1, .4), rise = s.in(-.05, .2);
    s.add_several(
        "arm",
        ring(s.rod({{0, height * .9, 0}, {0, height * .85, reach / 2}, {0, height + rise, reach}}, width * .6), count));
    std::vector<Eigen::Isometry3d> places;
    for (int i = 0; i < count; ++i)
      places.push_back(rotation_about(Point::Zero(), Point::UnitY(), 2 * pi * i / count) *
                       moved({0, height + rise, reach}));
    return add_light(s, drawn_light(s, size * .6, s.chance(.5), s.chance(.4), s.chance(.4)), places);
  }
  if (s.chance(.15))
    s.add_several("arm", ring(s.stick({0, height, 0}, {0, height + size * .3, size * .7}, width * .3), 3),
                  "shade_support", Place::none, .6);
  const double gap = s.in(-.5, .3) * size;
  add_light(s, drawn_light(s, size, false, s.chance(.45), s.chance(.3)), {moved({0, height + gap, 0})});
  if (s.chance(.08))
    s.add("chain", s.stick({size * .4, height + gap - .1, 0}, {size * .4, height + gap + .05, 0}, .006));
}

// On a desk or a floor: a foot, arms with joints or a bow, a shade that looks down.
void draw_reaching_lamp(Sketch& s)
{
  const double scale = s.chance(.3) ? s.in(1, 1.8) : s.in(.35, .7), width = scale * s.in(.02, .06),
               size = scale * s.in(.1, .25);
  const double low = add_foot(s, scale * s.in(.15, .3));
  Path joints{{0, low, 0}};
  for (int i = s.count(1, 3); i > 0; --i)
    joints.push_back(joints.back() + Point(0, scale * s.in(.15, .6), scale * s.in(-.4, .5)));
  joints.push_back(joints.back() + Point(0, scale * s.in(-.15, .2), scale * s.in(.1, .5)));
  const Point end = joints.back();
  if (s.chance(.35)) {
    s.add(s.chance(.5) ? "arm" : "body", s.rod(joints, width));
  } else {
    const bool has_joints = s.chance(.3), is_double = s.chance(.2), starts_with_post = s.chance(.5);
    for (std::size_t i = 1; i < joints.size(); ++i) {
      const Solid one = s.stick(joints[i - 1], joints[i], width);
      if (i == 1 && starts_with_post)
        s.add("body", one, "post");
      else if (is_double)
        s.add_pair("arm", translated(one, {2 * width, 0, 0}), "arm", Place::none);
      else
        s.add("arm", one);
      if (has_joints) s.add("arm", globe(joints[i], width), i == 1 ? "joint" : "");
    }
  }
  const Light light = drawn_light(s, size, true, s.chance(.5), s.chance(.25));
  add_light(s, light, {moved(end) * rotation_about(Point::Zero(), Point::UnitX(), s.in(-.9, .3))});
}

// A plate at a ceiling, y = 0; \return its height.
double add_ceiling_mount(Sketch& s, double radius)
{
  const double height = radius * s.in(.1, .8);
  s.add("base",
        s.chance(.5) ? s.turned({0, -height, 0}, {0, 0, 0}, radius * .5, radius)
                     : Sketch::block({0, -height / 2, 0}, {2 * radius, height, 2 * radius}, s.any({.07, 1.})),
        s.chance(.7) ? "ceiling_mount" : "");
  return height;
}

// A rod, a cable, or links of a chain, each a part or all one; from `high` down to `low`.
void add_hanger(Sketch& s, const Point& high, const Point& low, double width)
{
  if (s.chance(.6))
    return s.add(s.any({"body", "body", "chain"}), s.stick(low, high, width), s.chance(.5) ? "hanging_post" : "");
  const int count = s.count(3, 9);
  const double length = (high - low).norm() / count;
  Solids links;
  for (int i = 0; i < count; ++i)
    links.push_back(torus(between(low, high, (i + .5) / count), i % 2 ? Point::UnitX() : Point::UnitZ(), length * .45,
                          round_section(length * .12, 6), 12));
  s.add_several("chain", links, "", Place::none, .75);
}

void draw_pendant(Sketch& s)
{
  const double length = s.in(.15, 1.2), size = s.in(.1, .35), width = s.in(.006, .03);
  const int count = s.chance(.25) ? s.count(2, 4) : 1;
  const double step = s.in(2.2, 3.5) * size;
  double low = 0;
  if (s.chance(.85)) {
    if (count == 1)
      low = add_ceiling_mount(s, s.in(.04, .14));
    else
      s.add("base", s.block({0, -.02, 0}, {step * count * .9, .04, .1}), "ceiling_mount");
  }
  std::vector<Eigen::Isometry3d> places;
  for (int i = 0; i < count; ++i) {
    const Point at((i - .5 * (count - 1)) * step, -low, 0);
    add_hanger(s, at, at - Point(0, length, 0), width);
    places.push_back(moved(at - Point(0, length, 0)));
  }
  add_light(s, drawn_light(s, size, true, s.chance(.6), s.chance(.4)), places);
}

void draw_chandelier(Sketch& s)
{
  const double length = s.in(.1, .9), width = s.in(.012, .04), reach = s.in(.25, .6), body = s.in(.1, .5);
  const double low = s.chance(.85) ? add_ceiling_mount(s, s.in(.05, .14)) : 0, y = -low - length;
  add_hanger(s, {0, -low, 0}, {0, y, 0}, width);
  s.add("body",
        s.chance(.5) ? s.turned({0, y - body, 0}, {0, y, 0}, width, width * 4) : globe({0, y - body / 2, 0}, body / 2));
  const int count = s.count(3, 10);
  const bool hangs = s.chance(.4);
  const double rise = s.in(-.15, .2), root = y - body * s.in(.2, .9);
  const Solid arm =
      s.chance(.7)
          ? s.rod({{0, root, width}, {0, root - s.in(0, .15), reach * .55}, {0, root + rise, reach}}, width * .8)
          : s.stick({0, root, width}, {0, root + rise, reach}, width * .8);
  s.add_several("arm", ring(arm, count), "", Place::none, .12);
  if (s.chance(.15)) s.add("body", torus({0, root, 0}, Point::UnitY(), reach * .8, round_section(width / 2, 6), 24));
  std::vector<Eigen::Isometry3d> places;
  for (int i = 0; i < count; ++i)
    places.push_back(rotation_about(Point::Zero(), Point::UnitY(), 2 * pi * i / count) *
                     moved({0, root + rise, reach}));
  add_light(s, drawn_light(s, s.in(.05, .14), hangs, s.chance(.6), s.chance(.4)), places, .1);
  if (s.chance(.2))
    s.add_several("ornament", ring(globe({0, root - .05, reach * .5}, .02), count), "", Place::none, .2);
}

// On a wall: a plate behind, an arm to the front, a light; or spots along a track below a ceiling.
void draw_wall_lamp(Sketch& s)
{
  const double size = s.in(.06, .16), reach = s.in(.08, .35), width = s.in(.01, .035);
  if (s.chance(.35)) {
    const int count = s.count(2, 5);
    const double step = s.in(.2, .4), drop = s.in(.03, .2);
    s.add("base", s.block({0, 0, 0}, {step * count, .03, .05}), s.chance(.5) ? "track" : "ceiling_mount");
    std::vector<Eigen::Isometry3d> places;
    for (int i = 0; i < count; ++i) {
      const Point at((i - .5 * (count - 1)) * step, -drop, 0);
      s.add("arm", s.stick(at, at + Point(0, drop, 0), width));
      places.push_back(moved(at) * rotation_about(Point::Zero(), Point::UnitX(), s.in(-.8, .8)));
    }
    return add_light(s, drawn_light(s, size * .6, true, s.chance(.5), false), places);
  }
  s.add("base", s.block({0, 0, 0}, {size * s.in(.6, 1.6), size * s.in(.6, 2.5), .02}), "wall_plate");
  const bool hangs = s.chance(.5), is_pair = s.chance(.2);
  const Point end(is_pair ? size * 1.5 : 0, s.in(-.1, .1), reach);
  const Solid arm =
      s.chance(.6) ? s.rod({{0, 0, 0}, {end.x() / 2, -.05, reach * .6}, end}, width) : s.stick({0, 0, 0}, end, width);
  if (is_pair)
    s.add_pair("arm", arm, "arm", Place::none);
  else
    s.add("arm", arm);
  std::vector<Eigen::Isometry3d> places{moved(end)};
  if (is_pair) places.push_back(moved({-end.x(), end.y(), end.z()}));
  add_light(s, drawn_light(s, size, hangs, s.chance(.6), s.chance(.4)), places);
}

// A cage or panes between a floor and a roof, with a light inside; it stands, hangs, or is on a post or a wall.
void draw_lantern(Sketch& s)
{
  const double width = s.in(.08, .2), height = width * s.in(1.2, 3), bar = width * s.in(.05, .12);
  const int kind = s.count(0, 3);
  const double y = kind == 1 ? s.in(1, 2.5) : 0;
  if (kind == 1) {
    s.add("body",
          s.chance(.5) ? s.turned({0, .1, 0}, {0, y, 0}, .02, .08) : s.stick({0, .1, 0}, {0, y, 0}, s.in(.04, .1)),
          "post");
    if (s.chance(.7)) s.add("base", s.turned({0, 0, 0}, {0, .1, 0}, .1, .2));
  }
  s.add(kind == 1 && s.chance(.5) ? "body" : "base", s.block({0, y + bar / 2, 0}, {2 * width, bar, 2 * width}));
  Solids cage;
  for (const double x : {-1., 1.})
    for (const double z : {-1., 1.})
      cage.push_back(
          s.stick({.9 * x * width, y + bar, .9 * z * width}, {.9 * x * width, y + height, .9 * z * width}, bar));
  if (s.chance(.5)) s.add_several("body", cage, "cage", Place::none, .7);
  if (s.chance(.6))
    s.add("shade", s.block({0, y + height / 2, 0}, {1.7 * width, height - 2 * bar, 1.7 * width}), "pane");
  s.add("shade", shade(s, y + height, y + height * 1.3, width * 1.2, width * .2), "roof");
  if (s.chance(.7)) s.add("bulb", globe({0, y + height * .4, 0}, width * s.in(.2, .5)));
  const Point top(0, y + height * 1.3, 0);
  if (kind == 2) {
    add_hanger(s, top + Point(0, s.in(.1, .6), 0), top, bar);
  } else if (kind == 3) {
    s.add("base", s.block({0, y + height * .7, -width - .1}, {width, height, .02}), "wall_plate");
    s.add("arm", s.rod({{0, y + height, -width - .1}, {0, y + height * 1.6, -width * .5}, top}, bar));
  } else if (s.chance(.5)) {
    s.add(
        "arm",
        s.rod({top - Point(width, .2 * height, 0), top + Point(0, width, 0), top + Point(width, -.2 * height, 0)}, bar),
        "handle");
  }
}

} // namespace

void draw_lamp(Sketch& s)
{
  using Draw_lamp = void (*)(Sketch&);
  s.any<Draw_lamp>({draw_standing_lamp, draw_standing_lamp, draw_reaching_lamp, draw_pendant, draw_chandelier,
                    draw_wall_lamp, draw_lantern})(s);
}

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
