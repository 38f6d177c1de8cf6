// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kinds.h"

namespace CGAL::Shape_correspondence::generator {

namespace {

// Proportions of a cycle: radii of the wheels, thickness of tubes, joints in the plane of symmetry.
struct Cycle
{
  double front_wheel, rear_wheel, tube;
  Point front, rear, crank, head, head_low, seat, saddle;
};

Cycle cycle_proportions(Sketch& s)
{
  Cycle at;
  at.rear_wheel = s.in(.12, .38);
  at.front_wheel = s.chance(.75) ? at.rear_wheel : s.in(.15, .5);
  at.tube = s.in(.02, .05);
  const double base = s.in(.4, .65) + at.front_wheel * .3, tall = s.in(.75, 1.1);
  at.front = {0, at.front_wheel, base};
  at.rear = {0, at.rear_wheel, -base};
  at.crank = {0, at.rear_wheel * s.in(.7, 1), s.in(-.15, .05)};
  const double lean = s.in(.1, .3);
  at.head = {0, std::max(tall * .85, 2.2 * at.front_wheel), base - lean - .05};
  at.head_low = between(at.head, {0, 2 * at.front_wheel + .03, base - lean * .5}, s.in(.6, 1));
  at.seat = {0, tall * s.in(.65, .85), -base * s.in(.35, .55)};
  at.saddle = at.seat + Point(0, s.in(.05, .25), -.04);
  return at;
}

void add_wheel(Sketch& s, const Point& hub, double radius, const std::string& name, double x = 0)
{
  const double tyre = radius * s.in(.04, .16);
  Solids all{torus(hub, Point::UnitX(), radius - tyre, round_section(tyre, 8), 24)};
  if (s.chance(.6)) {
    const int count = s.count(4, 12);
    const Solid spoke = beam(Point::Zero(), Point(0, radius - tyre, 0), round_section(radius * .015, 6), 1);
    for (int i = 0; i < count; ++i)
      all.push_back(
          translated(transformed(spoke, rotation_about(Point::Zero(), Point::UnitX(), 2 * pi * i / count)), hub));
  } else if (s.chance(.5)) {
    all = {beam(hub - Point(tyre, 0, 0), hub + Point(tyre, 0, 0), round_section(radius, 20), 2)};
  }
  if (x == 0 && s.chance(.12)) { // a tyre, a rim and a hub
    s.add("wheel", joined(all), name);
    s.add("wheel", torus(hub, Point::UnitX(), radius - 2.2 * tyre, round_section(tyre * .5, 6), 24), name + "_rim");
    if (s.chance(.6))
      s.add("wheel", beam(hub - Point(.05, 0, 0), hub + Point(.05, 0, 0), round_section(.02, 8), 1), name + "_hub");
  } else if (x == 0)
    s.add("wheel", joined(all), name);
  else
    s.add_pair("wheel", translated(joined(all), {x, 0, 0}), name, Place::none);
}

void add_frame(Sketch& s, const Cycle& at)
{
  const double t = at.tube;
  const bool is_step_through = s.chance(.3);
  const Point top = is_step_through ? between(at.crank, at.seat, .4) : at.seat;
  const auto stay = [&](const Point& from, double x) {
    return joined({s.stick(from, at.rear + Point(x, 0, 0), t * .6), s.stick(from, at.rear - Point(x, 0, 0), t * .6)});
  };
  const Solids tubes{
      s.stick(at.head_low, at.head, t * 1.2), s.stick(at.head, top, t), s.stick(at.head_low, at.crank, t),
      s.stick(at.crank, at.seat, t),          stay(at.crank, .04),      stay(at.seat, .04)};
  if (s.chance(.12)) { // one beam in place of a frame of triangles
    const Solid beam_of_frame =
        s.rod({at.head_low, between(at.head_low, at.crank, .6), at.crank, at.rear}, t * s.in(1.2, 2.5));
    return s.add("frame",
                 joined({beam_of_frame, s.stick(at.crank, at.seat, t), s.stick(at.head_low, at.head, t * 1.2)}),
                 "frame");
  }
  if (s.chance(.2)) { // two parts: the front and the rear triangle
    s.add("frame", joined({tubes[0], tubes[1], tubes[2], tubes[3]}), "frame");
    return s.add("frame", joined({tubes[4], tubes[5]}), "frame_rear");
  }
  if (s.chance(.5)) return s.add("frame", joined(tubes), s.chance(.4) ? "frame" : "");
  const std::string names[] = {"head_tube", "top_tube", "down_tube", "seat_tube", "chain_stays", "seat_stays"};
  for (std::size_t i = 0; i < tubes.size(); ++i)
    s.add("frame", tubes[i], names[i]);
}

void add_steering(Sketch& s, const Cycle& at)
{
  const double width = s.in(.2, .38), t = at.tube;
  const Point top = at.head + (at.head - at.head_low).normalized() * s.in(.05, .25);
  const Point x(s.in(.03, .06), 0, 0);
  const Solid blade =
      s.chance(.5)
          ? s.stick(at.head_low + x, at.front + x, t * .8)
          : s.rod({at.head_low + x, between(at.head_low, at.front, .6) + x + Point(0, 0, -.02), at.front + x}, t * .8);
  const Point grip(width, top.y() + s.in(-.08, .15), top.z() - s.in(-.1, .3));
  const bool is_dropped = s.chance(.2); // dropped handlebars, as of a racing cycle
  const Point low_grip = grip + Point(0, -.12, -.1), bend = grip + Point(0, -.04, .08);
  const Solid bars =
      is_dropped ? s.rod({Point(-low_grip.x(), low_grip.y(), low_grip.z()), Point(-bend.x(), bend.y(), bend.z()),
                          Point(-grip.x(), grip.y(), grip.z()), top, grip, bend, low_grip},
                         t * .8)
                 : s.rod({Point(-grip.x(), grip.y(), grip.z()), Point(-width * .6, top.y() + .02, top.z() + .03), top,
                          Point(width * .6, top.y() + .02, top.z() + .03), grip},
                         t * .8);
  const Solid stem = s.stick(at.head, top, t * .9);
  const int kind = s.count(0, 4);
  if (kind == 0) return s.add("handlebar", joined({bars, stem, blade, mirrored(blade)}), "handlebar_and_fork");
  if (kind < 3)
    s.add("fork", joined({blade, mirrored(blade)}), "fork");
  else
    s.add_pair("fork", blade, "fork_blade");
  if (kind == 3) s.add("fork", s.block(at.head_low, {.12, .04, .05}), "fork_crown");
  s.add("handlebar", bars, "handlebar");
  if (s.chance(.6)) s.add("handlebar", stem, "stem");
  if (s.chance(.45))
    s.add_pair("handlebar", beam(grip, grip + Point(.02, 0, -.1), round_section(t * .6, 8), 1), "grip");
}

void add_saddle(Sketch& s, const Cycle& at)
{
  const double width = s.in(.12, .28), length = s.in(.2, .4);
  s.add("saddle",
        mapped(s.cushion(at.saddle, {width, s.in(.04, .1), length}),
               [&, narrow = s.in(0, .8)](const Point& p) { // narrower towards the front
                 const double t = std::clamp((p.z() - at.saddle.z()) / length + .5, 0., 1.);
                 return Point(p.x() * (1 - narrow * t), p.y(), p.z());
               }),
        "saddle");
  if (s.chance(.06)) s.add("saddle", s.cushion(at.saddle + Point(0, .2, -.2), {width, .3, .06}), "backrest");
  if (s.chance(.65)) s.add("saddle", s.stick(at.seat, at.saddle, at.tube * .8), "seat_post");
}

void add_drive(Sketch& s, const Cycle& at, const Point& axle)
{
  const double arm = s.in(.1, .18), x = s.in(.05, .1), angle = s.in(0, 2 * pi);
  const Point out(0, arm * std::cos(angle), arm * std::sin(angle));
  const Point left = axle + Point(x, 0, 0), right = axle - Point(x, 0, 0);
  const Solid crank = s.stick(left, left + out, .025), other = s.stick(right, right - out, .025);
  const Solid pedal = s.block(left + out + Point(.06, 0, 0), {.1, .025, .07}),
              other_pedal = s.block(right - out - Point(.06, 0, 0), {.1, .025, .07});
  const int kind = s.count(0, 2);
  if (kind == 0) {
    s.add("pedal", joined({crank, pedal}), "crank_left");
    s.add("pedal", joined({other, other_pedal}), "crank_right");
  } else {
    s.add("pedal", pedal, "pedal_left");
    s.add("pedal", other_pedal, "pedal_right");
    if (kind == 2) s.add("pedal", crank, "crank_left"), s.add("pedal", other, "crank_right");
  }
  if (axle == at.front) return;
  if (s.chance(.7))
    s.add("drivetrain", beam(axle - Point(.05, 0, 0), axle - Point(.04, 0, 0), round_section(s.in(.06, .12), 16), 1),
          "chainring");
  if (s.chance(.6))
    s.add("drivetrain",
          joined({s.stick(axle + Point(-.045, .08, 0), at.rear + Point(-.045, .04, 0), .012),
                  s.stick(axle + Point(-.045, -.08, 0), at.rear + Point(-.045, -.04, 0), .012)}),
          "chain");
}

Solid fender(const Point& hub, double radius, double from, double to)
{
  return slab(
      [=](double u, double v) {
        const double a = from + u * (to - from);
        return Point((v - .5) * .06, hub.y() + radius * std::sin(a), hub.z() + radius * std::cos(a));
      },
      .006);
}

void add_fittings(Sketch& s, const Cycle& at)
{
  if (s.chance(.35)) s.add("fender", fender(at.rear, at.rear_wheel * 1.07, 1, 2.9), "fender_rear");
  if (s.chance(.3)) s.add("fender", fender(at.front, at.front_wheel * 1.07, .9, 2.4), "fender_front");
  const Point on_rear = at.rear + Point(0, at.rear_wheel * 1.15, -.02);
  if (s.chance(.3)) {
    Solids all{s.block(on_rear, {.15, .03, .35})};
    if (s.chance(.6))
      for (const double x : {-.07, .07})
        all.push_back(s.stick(at.rear + Point(x, 0, 0), on_rear + Point(x, 0, 0), .012));
    s.add_several("rack", all, "rack", Place::none, .7);
  }
  if (s.chance(.22)) {
    const double width = s.in(.25, .4), height = s.in(.15, .3), depth = s.in(.2, .35);
    const Point middle = s.chance(.75) ? at.head + Point(0, .05, .1 + depth / 2) : on_rear + Point(0, height / 2, 0);
    Solids sides{s.block(middle - Point(0, height / 2, 0), {width, .01, depth})};
    for (const double side : {-.5, .5}) {
      sides.push_back(s.block(middle + Point(side * width, 0, 0), {.01, height, depth}));
      sides.push_back(s.block(middle + Point(0, 0, side * depth), {width, height, .01}));
    }
    s.add("basket", s.chance(.5) ? joined(sides) : s.block(middle, {width, height, depth}), "basket");
  }
  if (s.chance(.25)) s.add("light", s.block(at.head + Point(0, 0, .08), {.06, .06, .08}), "light_front");
  if (s.chance(.15)) s.add("brake", s.block(at.head_low + Point(0, -.02, .03), {.06, .06, .03}), "brake_front");
}

// A kick scooter: a board to stand on in place of a saddle.
void draw_scooter(Sketch& s, Cycle at)
{
  at.front_wheel = at.rear_wheel = s.in(.05, .14);
  at.front.y() = at.front_wheel;
  at.rear.y() = at.rear_wheel;
  at.head = {0, s.in(.6, 1), at.front.z() - .12};
  at.head_low = {0, 2.4 * at.front_wheel, at.front.z() - .03};
  const double y = at.front_wheel * s.in(.6, 1.4);
  s.add("frame",
        joined({s.block({0, y, -.05}, {.12, .03, at.front.z() - at.rear.z() - .2}),
                s.stick({0, y, at.front.z() - .2}, at.head_low, .05), s.stick(at.head_low, at.head, .035)}),
        "deck");
  add_steering(s, at);
  add_wheel(s, at.front, at.front_wheel, "wheel_front");
  add_wheel(s, at.rear, at.rear_wheel, "wheel_rear");
  if (s.chance(.4)) s.add("fender", fender(at.rear, at.rear_wheel * 1.2, .8, 2.6), "fender_rear");
}

} // namespace

void draw_velocipede(Sketch& s)
{
  const Cycle at = cycle_proportions(s);
  if (s.chance(.12)) return draw_scooter(s, at);
  const bool is_tricycle = s.chance(.15), is_led_by_two = !is_tricycle && s.chance(.06);
  add_frame(s, at);
  add_steering(s, at);
  add_saddle(s, at);
  add_wheel(s, at.front, at.front_wheel, "wheel_front", is_led_by_two ? s.in(.15, .35) : 0);
  if (!is_tricycle && s.chance(.05)) // training wheels
    add_wheel(s, {0, at.rear_wheel * .4, at.rear.z()}, at.rear_wheel * .4, "wheel_training", s.in(.1, .2));
  add_wheel(s, at.rear, at.rear_wheel, "wheel_rear", is_tricycle ? s.in(.15, .35) : 0);
  if (s.chance(.85)) add_drive(s, at, is_tricycle && s.chance(.5) ? at.front : at.crank);
  add_fittings(s, at);
}

} // namespace CGAL::Shape_correspondence::generator
