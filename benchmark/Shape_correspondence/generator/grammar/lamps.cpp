// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kinds.h"
#include "lights.h"
#include "supports.h"

namespace CGAL::Shape_correspondence::generator {

namespace {

Eigen::Isometry3d moved(const Point& to) { return Eigen::Isometry3d(Eigen::Translation3d(to)); }

// Adds the foot of a lamp; returns its height.
double add_foot(Sketch& s, double radius)
{
  const double height = radius * s.in(.06, .7);
  switch (s.count(0, 9)) {
  case 0: { // three or four feet
    const Point out(0, 0, radius * 1.3), knee(0, radius * s.in(.3, 4), 0);
    s.add_several(s.chance(.6) ? "base" : "body", ring(s.stick(out, knee, radius * .12), s.count(3, 4)), "",
                  Place::none, .4);
    return knee.y();
  }
  case 1: // plates on each other
    s.add_several("base", {s.turned({0, 0, 0}, {0, height / 2, 0}, radius * .7, radius),
                           s.turned({0, height / 2, 0}, {0, height, 0}, radius * .2, radius * .7)});
    return height;
  case 2: { // on small feet
    const double low = radius * s.in(.08, .3);
    s.add("base", Sketch::block({0, low + height / 2, 0}, {2 * radius, height, 2 * radius}, s.any({.07, .3})));
    s.add_several("base", ring(globe({0, low / 2, radius * .7}, low / 2), s.count(3, 4)), "foot", Place::none, .6);
    return low + height;
  }
  case 3:
  case 4:
    s.add("base", s.block({0, height / 2, 0}, {2 * radius, height, 2 * radius * s.in(.5, 1)}));
    return height;
  case 5: // a clamp at a board
    s.add("base",
          joined({s.block({0, 0, 0}, {radius, radius * .2, radius}),
                  s.block({0, radius, 0}, {radius, radius * .2, radius}),
                  s.block({0, radius / 2, -radius / 2}, {radius, radius * 1.2, radius * .2})}),
          "clamp");
    return radius;
  default:
    s.add("base", s.chance(.5)
                      ? s.turned({0, 0, 0}, {0, height, 0}, radius * .5, radius)
                      : Sketch::block({0, height / 2, 0}, {2 * radius, height, 2 * radius}, s.any({.07, .3, 1.})));
    return height;
  }
}

// Adds balls and rings on a post or vase.
void add_ornaments(Sketch& s, double low, double high, double radius)
{
  for (int i = s.count(1, 3); i > 0; --i) {
    const Point at(0, s.in(low, high), 0);
    s.add(s.chance(.5) ? "body" : "ornament",
          s.chance(.5) ? globe(at, radius * s.in(1, 2))
                       : torus(at, Point::UnitY(), radius * 1.2, round_section(radius * .4, 6), 16));
  }
}

// Adds a post: one part, or two to four parts one above the other.
void add_post(Sketch& s, double low, double high, double width, const std::string& fine)
{
  if (!s.chance(.25))
    return s.add("body",
                 s.chance(.25) ? s.turned({0, low, 0}, {0, high, 0}, width * .4, width * 1.2)
                               : s.stick({0, low, 0}, {0, high, 0}, width),
                 fine);
  const int count = s.count(2, 4);
  for (int i = 0; i < count; ++i) {
    const double step = (high - low) / count, y = low + i * step, w = width * s.in(.6, 1.4);
    s.add("body",
          s.chance(.4) ? s.turned({0, y, 0}, {0, y + step, 0}, w * .3, w) : s.stick({0, y, 0}, {0, y + step, 0}, w));
  }
}

// A tripod lamp: three or four long legs, a joint, a shade on top.
void draw_tripod_lamp(Sketch& s)
{
  const double height = s.in(.4, 1.6), reach = height * s.in(.15, .4), width = height * s.in(.015, .04),
               size = height * s.in(.1, .25);
  s.add_several(s.chance(.5) ? "base" : "body", ring(s.stick({0, 0, reach}, {0, height, width}, width), s.count(3, 4)),
                "leg", Place::none, .3);
  if (s.chance(.6)) s.add("body", globe({0, height, 0}, width * s.in(1, 2.5)), "joint");
  if (s.chance(.25)) s.add("base", s.block({0, height * s.in(.2, .5), 0}, {reach, width, reach}), "tray");
  add_light(s, drawn_light(s, size, false, s.chance(.4), s.chance(.4)), {moved({0, height, 0})});
}

// A standing lamp: a foot, a post or a vase, a shade above.
void draw_standing_lamp(Sketch& s)
{
  const double height = s.in(.2, 1.9), size = height * (height > 1 ? s.in(.07, .2) : s.in(.15, .5)),
               radius = height * (height > 1 ? s.in(.06, .16) : s.in(.12, .4));
  const bool is_vase = height < .8 && s.chance(.6);
  const double low = is_vase && s.chance(.5) ? 0 : add_foot(s, radius), width = height * s.in(.012, .07);
  if (!is_vase)
    add_post(s, low, height, width, s.any({"", "", "post"}));
  else if (s.chance(.3))
    s.add("body",
          Sketch::block({0, (low + height) / 2, 0}, {1.5 * radius, height - low, 1.5 * radius * s.in(.6, 1)},
                        s.in(.05, 1)),
          s.any({"", "vase"}));
  else
    s.add("body", s.turned({0, low, 0}, {0, height, 0}, .1 * radius, radius), s.any({"", "", "vase"}));
  if (s.chance(.15)) add_ornaments(s, low, height, is_vase ? radius * .5 : width * .7);
  if (is_vase && s.chance(.4)) { // a neck between vase and shade
    s.add("body", s.stick({0, height, 0}, {0, height + size * .4, 0}, width), s.any({"", "bulb_socket"}));
  }
  if (s.chance(.15)) { // arms with a light each
    const int count = s.count(2, 6);
    const double reach = s.in(.1, .4), rise = s.in(-.05, .2);
    s.add_several(
        "arm",
        ring(s.rod({{0, height * .9, 0}, {0, height * .85, reach / 2}, {0, height + rise, reach}}, width * .6), count));
    std::vector<Eigen::Isometry3d> places;
    for (int i = 0; i < count; ++i)
      places.push_back(rotation_about(Point::Zero(), Point::UnitY(), 2 * pi * i / count) *
                       moved({0, height + rise, reach}));
    return add_light(s,
                     s.chance(.3) ? drawn_candle(s, size * .5)
                                  : drawn_light(s, size * .6, s.chance(.5), s.chance(.4), s.chance(.4)),
                     places);
  }
  if (s.chance(.15))
    s.add_several("arm", ring(s.stick({0, height, 0}, {0, height + size * .3, size * .7}, width * .3), 3),
                  "shade_support", Place::none, .6);
  const double gap = s.in(-.5, .3) * size;
  add_light(s, drawn_light(s, size, false, s.chance(.45), s.chance(.35)), {moved({0, height + gap, 0})});
  if (s.chance(.1)) s.add("ornament", globe({0, height + gap + size * s.in(1, 2), 0}, size * .1), "finial");
  if (s.chance(.12))
    s.add("chain", s.stick({size * .4, height + gap - .1, 0}, {size * .4, height + gap + .05, 0}, .006));
}

// A post with one or two arms at its top: a street lamp or a banker's lamp.
void draw_hooked_lamp(Sketch& s)
{
  const double height = s.in(.3, 2.5), reach = height * s.in(.08, .5), width = height * s.in(.015, .05),
               size = height * s.in(.05, .18);
  const double low = add_foot(s, height * s.in(.06, .22)), top = height * s.in(.85, 1.1);
  const bool is_pair = s.chance(.25), is_whole = s.chance(.25);
  const Path hook{{0, height, 0}, {0, std::max(top, height) + reach * s.in(0, .3), reach * .5}, {0, top, reach}};
  const Solid arm = s.chance(.6) ? s.rod(hook, width * .8) : s.stick(hook[0], hook[2], width * .8);
  if (is_whole) {
    const Solid post = s.stick({0, low, 0}, {0, height, 0}, width);
    s.add("body", is_pair ? joined({post, arm, mirrored(arm, 2)}) : joined({post, arm}));
  } else {
    add_post(s, low, height, width, s.any({"", "post"}));
    s.add("arm", arm);
    if (is_pair) s.add("arm", mirrored(arm, 2));
  }
  std::vector<Eigen::Isometry3d> places{moved({0, top, reach}) *
                                        rotation_about(Point::Zero(), Point::UnitX(), s.in(-.5, .2))};
  if (is_pair) places.push_back(moved({0, top, -reach}));
  add_light(s, drawn_light(s, size, s.chance(.85), s.chance(.45), s.chance(.3)), places);
  if (is_pair || s.chance(.4)) s.turn_quarter();
}

// A desk or floor lamp: a foot, arms with joints or one bow, a shade that hangs from the end.
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
  if (s.chance(.35)) s.turn_quarter();
}

// An arc lamp: a foot, a bow, a shade that hangs from its end.
void draw_arc_lamp(Sketch& s)
{
  const double height = s.in(.5, 2.1), reach = height * s.in(.3, .9), width = height * s.in(.012, .03),
               low = add_foot(s, height * s.in(.08, .18));
  const double end = height * s.in(.5, .95), straight = s.chance(.5) ? s.in(.2, .6) * height : low;
  const Path bow{{0, straight, 0},
                 {0, between({0, straight, 0}, {0, height, 0}, .6).y(), reach * s.in(.02, .15)},
                 {0, height, reach * .5},
                 {0, end, reach}};
  if (straight > low) s.add("body", s.stick({0, low, 0}, {0, straight, 0}, width * 1.3), s.any({"", "post"}));
  s.add(straight > low || s.chance(.5) ? "arm" : "body", s.rod(bow, width));
  const double drop = s.chance(.3) ? s.in(.05, .2) * height : 0;
  if (drop > 0) s.add("chain", s.stick({0, end - drop, reach}, {0, end, reach}, width * .4));
  add_light(s, drawn_light(s, height * s.in(.07, .18), true, s.chance(.5), s.chance(.3)),
            {moved({0, end - drop, reach})});
  if (s.chance(.5)) s.turn_quarter();
}

// Adds a mount at a ceiling, y = 0; returns its height.
double add_ceiling_mount(Sketch& s, double radius)
{
  const double height = radius * s.in(.1, .8);
  s.add("base",
        s.chance(.5) ? s.turned({0, -height, 0}, {0, 0, 0}, radius * .5, radius)
                     : Sketch::block({0, -height / 2, 0}, {2 * radius, height, 2 * radius}, s.any({.07, 1.})),
        s.chance(.7) ? "ceiling_mount" : "");
  return height;
}

// Adds a hanger from `high` down to `low`: a rod, or a chain, which is one part or one part for each link.
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
  add_light(s,
            s.chance(.35) ? drawn_candle(s, s.in(.05, .12))
                          : drawn_light(s, s.in(.05, .14), hangs, s.chance(.6), s.chance(.4)),
            places, .1);
  if (s.chance(.2))
    s.add_several("ornament", ring(globe({0, root - .05, reach * .5}, .02), count), "", Place::none, .2);
  if (s.chance(.25)) s.add("ornament", globe({0, y - body - width, 0}, width * s.in(.8, 2)));
}

// A wall lamp: a plate behind, an arm to the front, a light; or spotlights along a track below a ceiling.
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

// A ceiling lamp: a mount, and a light or fluorescent tubes.
void draw_ceiling_lamp(Sketch& s)
{
  const double radius = s.in(.12, .4), low = add_ceiling_mount(s, radius * s.in(.4, 1.1));
  if (s.chance(.35)) {
    const int count = s.count(1, 3);
    const Solid one = beam({-radius * 1.5, -low - .03, 0}, {radius * 1.5, -low - .03, 0}, round_section(.02, 8), 2);
    s.add_several("bulb", row(one, {0, 0, -.05 * (count - 1)}, {0, 0, .05 * (count - 1)}, count), "tube");
    if (s.chance(.5)) s.add("shade", s.block({0, -low - .03, 0}, {3.2 * radius, .07, .12 * count}));
    return;
  }
  add_light(s, drawn_light(s, radius, true, s.chance(.4), s.chance(.2)), {moved({0, -low, 0})});
  if (s.chance(.25)) s.add("ornament", globe({0, -low - radius * s.in(.8, 1.8), 0}, radius * .08));
}

// A spotlight: a drum that turns in a bow, on a foot, at times with a post.
void draw_spotlight(Sketch& s)
{
  const double size = s.in(.06, .16), length = size * s.in(1.2, 3), y = s.chance(.5) ? s.in(.6, 1.6) : s.in(.12, .3),
               x = size * 1.15;
  const double low = add_foot(s, s.in(.06, .2));
  if (y > low + .1 + size) add_post(s, low, y - size, size * s.in(.15, .4), s.any({"", "post"}));
  if (s.chance(.7)) {
    Path bow{{-x, y, 0}, {-x, y - 1.1 * size, 0}, {x, y - 1.1 * size, 0}, {x, y, 0}};
    s.add("arm", tube(bent(bow, size * .3), bar(size * .12, size * .3)), s.chance(.3) ? "bracket" : "");
  }
  const Eigen::Isometry3d aim = rotation_about({0, y, 0}, Point::UnitX(), s.in(-.6, .5));
  const Point back(0, y, -length / 2), front(0, y, length / 2);
  s.add("shade", transformed(s.chance(.5) ? s.turned(back, front, size * .5, size)
                                          : beam(back, front, round_section(size * s.in(.5, 1), size, 12), 2),
                             aim));
  if (s.chance(.5))
    s.add("bulb", transformed(beam(front, front + Point(0, 0, .01), round_section(size * .8, 12), 1), aim));
}

// An oil lamp: a tank, a burner, a glass chimney, at times with a flame and a handle.
void draw_oil_lamp(Sketch& s)
{
  const double radius = s.in(.06, .14), tank = radius * s.in(.6, 2), neck = radius * s.in(.2, .5);
  const double low = s.chance(.6) ? add_foot(s, radius * s.in(.8, 1.2)) : 0, burner = low + tank + neck,
               top = burner + radius * s.in(1.5, 3.5);
  s.add(s.chance(.7) ? "body" : "base", s.turned({0, low, 0}, {0, low + tank, 0}, radius * .4, radius), "tank");
  s.add("body", s.turned({0, low + tank, 0}, {0, burner, 0}, radius * .3, radius * .6), s.any({"", "bulb_socket"}));
  s.add("shade", s.turned({0, burner, 0}, {0, top, 0}, radius * .3, radius * .8));
  if (s.chance(.4)) s.add("bulb", globe({0, burner + radius * .5, 0}, radius * .2));
  if (s.chance(.5))
    s.add("arm",
          s.rod({{radius * .6, low, 0},
                 {radius * 1.6, low + tank, 0},
                 {0, top + radius, 0},
                 {-radius * 1.6, low + tank, 0},
                 {-radius * .6, low, 0}},
                radius * .06),
          "handle");
}

// A lantern: a cage or panes between a floor and a roof, a bulb inside; it stands, hangs, or is on a post or a wall.
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
  const Solid roof = hood(s, y + height, y + height * 1.3, width * 1.2, width * .2);
  s.add(s.chance(.6) ? "shade" : "body", roof, "roof");
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
  s.any<Draw_lamp>({draw_standing_lamp, draw_standing_lamp, draw_standing_lamp, draw_tripod_lamp, draw_hooked_lamp,
                    draw_reaching_lamp, draw_reaching_lamp, draw_arc_lamp, draw_pendant, draw_pendant, draw_chandelier,
                    draw_chandelier, draw_wall_lamp, draw_wall_lamp, draw_ceiling_lamp, draw_spotlight, draw_oil_lamp,
                    draw_lantern, draw_lantern})(s);
}

} // namespace CGAL::Shape_correspondence::generator
