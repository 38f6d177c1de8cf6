// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kinds.h"
#include "supports.h"

namespace CGAL::Shape_correspondence::generator {

namespace {

// Proportions of a car: half width; heights of underside, belt line and roof; z of both ends, and of windscreen and
// rear window at the belt line (`low`) and the roof (`high`); radius of the wheels, z of the axles.
struct Car
{
  double x, low, belt, roof, front, rear;
  double screen_low, screen_high, rear_high, rear_low;
  double wheel, front_axle, rear_axle;

  double inner_x() const { return x * .82; } // half width of the roof
};

Car car_proportions(Sketch& s)
{
  Car at;
  at.x = s.in(.7, 1.1);
  at.wheel = s.in(.26, .48);
  at.low = at.wheel * s.in(.4, 1.1);
  at.belt = at.low + s.in(.4, .8);
  at.roof = at.belt + s.in(.3, 1.2);
  at.front = s.in(1.5, 2.6);
  at.rear = -s.in(1.5, 2.8);
  const int kind = s.count(0, 3); // saloon, hatchback, van, truck with a bed
  at.screen_low = kind == 2 ? at.front * s.in(.85, .97) : at.front * s.in(.35, .6);
  at.screen_high = at.screen_low - s.in(.05, .7);
  at.rear_low = kind == 0 ? at.rear * s.in(.5, .75) : kind == 3 ? at.rear * s.in(.0, .25) : at.rear * .98;
  at.rear_high = at.rear_low + s.in(.02, .4);
  at.front_axle = at.front - at.wheel - s.in(.1, .6);
  at.rear_axle = at.rear + at.wheel + s.in(.1, .7);
  return at;
}

// A prism across the car with side view `outline` (z, y), narrower at the roof. \param widest half width at the belt
Solid side_view(const Car& at, const std::vector<Point_2>& outline, double widest)
{
  std::vector<Path> rings;
  for (const double side : {-1., -.9, .9, 1.}) {
    Path path;
    for (const Point_2& p : outline) {
      const double t = std::max(0., p.y() - at.belt) / (at.roof - at.belt), inset = std::abs(side) == 1 ? .97 : 1;
      path.push_back({side * widest * (1 - t * .18), at.low + (p.y() - at.low) * inset, p.x()});
    }
    rings.push_back(path);
  }
  return {loft(rings), Kind::curve, line({-widest, at.low, 0}, {widest, at.low, 0})};
}

void add_body(Sketch& s, const Car& at)
{
  const double nose = at.belt - s.in(0, .25), hood = at.belt - s.in(0, .1);
  std::vector<Point_2> outline{{at.rear, at.low}, {at.front, at.low}, {at.front, nose}, {at.screen_low, hood}};
  const bool has_cabin = s.chance(.85);
  if (has_cabin) outline.insert(outline.end(), {{at.screen_high, at.roof}, {at.rear_high, at.roof}});
  outline.insert(outline.end(), {{at.rear_low, at.belt}, {at.rear, at.belt - s.in(0, .15)}});
  s.add("body", side_view(at, outline, at.x));
  if (!has_cabin && s.chance(.7))
    s.add("roof", s.block({0, at.roof, (at.screen_high + at.rear_high) / 2},
                          {2 * at.inner_x(), .06, at.screen_high - at.rear_high}));
  if (at.rear_low > at.rear * .3 && s.chance(.5))
    s.add("cargo",
          s.block({0, at.belt, (at.rear + at.rear_low) / 2}, {1.9 * at.x, s.in(.1, 1.5), at.rear_low - at.rear}));
}

void add_wheels(Sketch& s, const Car& at)
{
  const double width = at.wheel * s.in(.4, .8), out = s.in(-.5, .2) * width;
  for (const double z : {at.front_axle, at.rear_axle}) {
    const Point hub(at.x + out, at.wheel, z);
    const Solid tyre = beam(hub - Point(width / 2, 0, 0), hub + Point(width / 2, 0, 0), round_section(at.wheel, 16), 2);
    s.add_pair("wheel", tyre, "", Place::corner);
    if (s.chance(.08)) s.add("axle", s.stick({-at.x, at.wheel, z}, {at.x, at.wheel, z}, .08), "", Place::none);
  }
}

// A window pane on the left side, between two values of z.
Solid side_pane(const Car& at, double from, double to)
{
  const double low = at.belt + .05, high = at.roof - .08;
  const Point a(at.x, low, from), edge(0, 0, to - from), up(at.inner_x() - at.x, high - low, 0);
  return slab(flat(a, edge, up), .03);
}

void add_windows(Sketch& s, const Car& at)
{
  const auto pane = [&](double z_low, double z_high, double out) {
    const Point a(-.85 * at.x, at.belt + .05, z_low + out), b(-.75 * at.x, at.roof - .06, z_high + out);
    return slab(
        [=](double u, double v) {
          return Point((2 * u - 1) * -between(a, b, v).x(), between(a, b, v).y(), between(a, b, v).z());
        },
        .03);
  };
  if (s.chance(.06)) {
    const double from = at.rear_low + .1, length = at.screen_low - from;
    return s.add("window", s.block({0, (at.belt + at.roof) / 2, from + length / 2},
                                   {2 * at.x * .93, (at.roof - at.belt) * .8, length}));
  }
  s.add("window", pane(at.screen_low, at.screen_high, .02), "windshield");
  if (s.chance(.9)) s.add("window", pane(at.rear_low, at.rear_high, -.02), "rear_window");
  const double from = at.screen_high - .05, to = at.rear_high + .1;
  const int count = from - to > 1.2 ? s.count(1, 3) : s.count(1, 2);
  const std::string names[] = {"window_front", "window_back", "window_quarter"};
  for (int i = 0; i < count; ++i)
    s.add_pair("window",
               side_pane(at, between({0, 0, from}, {0, 0, to}, (i + .05) / count).z(),
                         between({0, 0, from}, {0, 0, to}, (i + .95) / count).z()),
               names[i]);
}

void add_lights_and_mirrors(Sketch& s, const Car& at)
{
  const double size = s.in(.1, .3), y = at.belt - s.in(.1, .3), out = s.in(.55, .9) * at.x;
  const double roundness = s.any({.1, 1.});
  if (s.chance(.9))
    s.add_pair("light", Sketch::block({out, y, at.front}, {size * s.in(1, 1.6), size, .1}, roundness), "headlight");
  if (s.chance(.75))
    s.add_pair("light", Sketch::block({out, y, at.rear}, {size, size * s.in(.6, 2), .1}, roundness), "taillight");
  if (s.chance(.2)) s.add_pair("light", s.block({out, y - size, at.front}, {size * .7, size * .5, .1}), "light");
  if (s.chance(.85))
    s.add_pair("mirror", s.block({at.x + .1, at.belt + s.in(.02, .2), at.screen_low - s.in(.1, .5)}, {.2, .15, .1}));
}

void add_trim(Sketch& s, const Car& at)
{
  const double length = at.front - at.rear, middle = (at.front + at.rear) / 2;
  if (s.chance(.5))
    for (const double z : {at.front + .05, at.rear - .05})
      s.add("bumper", s.block({0, at.low + s.in(.05, .2), z}, {2 * at.x * s.in(.9, 1.02), s.in(.1, .3), .2}),
            z > 0 ? "bumper_front" : "bumper_back");
  if (s.chance(.35))
    s.add("grille", s.block({0, at.belt - s.in(.2, .35), at.front}, {at.x * s.in(.6, 1.3), s.in(.1, .3), .06}));
  if (s.chance(.4))
    s.add("underbody", s.block({0, at.low - .02, middle}, {2 * at.x * .95, s.in(.04, .2), length * .97}));
  if (s.chance(.25))
    s.add_pair("sill", s.block({at.x, at.low + .05, (at.front_axle + at.rear_axle) / 2},
                               {.08, .15, at.front_axle - at.rear_axle - 2.2 * at.wheel}));
  if (s.chance(.35)) {
    const int count = s.count(1, 2);
    for (int i = 0; i < count; ++i)
      s.add_pair("handle",
                 s.block({at.x + .02, at.belt - .06,
                          between({0, 0, at.screen_high}, {0, 0, at.rear_high}, (i + .85) / count).z()},
                         {.05, .04, .2}),
                 i == 0 ? "handle_front" : "handle_back");
  }
  if (s.chance(.15))
    for (const double z : {at.front_axle, at.rear_axle})
      s.add_pair("fender", s.block({at.x, at.wheel * 2, z}, {.25, .12, at.wheel * 2.4}),
                 z > 0 ? "fender_front" : "fender_back");
  if (s.chance(.25))
    s.add("interior", s.block({0, (at.low + at.belt) / 2, (at.screen_high + at.rear_high) / 2},
                              {1.5 * at.x, at.belt - at.low, at.screen_high - at.rear_high}));
  if (s.chance(.06))
    s.add("cargo", s.block({0, at.roof + .1, (at.screen_high + at.rear_high) / 2},
                           {1.5 * at.x, .2, at.screen_high - at.rear_high}));
}

} // namespace

void draw_car(Sketch& s)
{
  const Car at = car_proportions(s);
  add_body(s, at);
  add_wheels(s, at);
  add_windows(s, at);
  add_lights_and_mirrors(s, at);
  add_trim(s, at);
}

} // namespace CGAL::Shape_correspondence::generator
