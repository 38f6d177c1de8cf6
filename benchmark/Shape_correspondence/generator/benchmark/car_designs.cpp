// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "car_designs.h"

#include "../chairs.h"
#include "random.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {
namespace {

enum class Car_body { saloon, estate, van, lorry };

struct Car_design
{
  const char* name;
  Car_body body;
  double length, height; ///< before they are varied
  int side_windows = 2;  ///< on each side; the third one is a quarter window
  bool bumpers = true, handles = true, underbody = false, interior = false;
};

/// Where the corners of the outline are that is seen from the side.
struct Car_frame
{
  double length, height, half_width, clearance, belt, radius;
  double hood_front, windshield_low, windshield_high, rear_high, rear_low; ///< along z
  double hood, tail;                                                       ///< heights in front of and behind the cabin

  Car_frame(const Car_design& design, Random& random)
      : length(random.about(design.length, .08)),
        height(random.about(design.height, .08)),
        half_width(random.about(.2 * design.length, .06)),
        clearance(random.between(.16, .26)),
        belt(height * random.between(.58, .66)),
        radius(random.between(.29, .36))
  {
    const bool is_van = design.body == Car_body::van || design.body == Car_body::lorry;
    const double front = length / 2;
    hood_front = front - (is_van ? .06 : .1);
    hood = belt - (is_van ? .03 : random.between(.05, .12));
    windshield_low = is_van ? front - random.between(.15, .5) : front - random.between(.24, .32) * length;
    windshield_high = windshield_low - (is_van ? random.between(.2, .4) : random.between(.45, .65));
    const bool has_boot = design.body == Car_body::saloon;
    rear_low = has_boot ? random.between(.12, .18) * length - front : .08 - front;
    rear_high = rear_low + (is_van ? .05 : has_boot ? random.between(.4, .6) : random.between(.15, .35));
    if (design.body == Car_body::lorry) rear_low = rear_high = windshield_low - random.between(1.2, 1.5);
    tail = belt - (has_boot ? .04 : 0);
    if (is_van) half_width = random.between(.9, 1.05);
  }

  double front() const { return length / 2; }
  double axle(bool in_front) const { return in_front ? .32 * length : -.3 * length; }
  /// How much narrower the cabin is at a height.
  double width_at(double y) const { return half_width * (1 - .2 * std::clamp((y - belt) / (height - belt), 0., 1.)); }
};

/// One mesh: from the floor over the widest place, the hood and the boot, and the belt up to the roof.
Solid car_body(const Car_frame& f, bool is_lorry)
{
  struct Level
  {
    double front, back;     ///< heights
    double front_z, back_z; ///< where they are
    double half_width;
  };
  const double back = is_lorry ? f.rear_low : -f.front(), w = f.half_width;
  const Level levels[] = {{f.clearance, f.clearance, f.front() - .04, back + .03, .94 * w},
                          {.6 * f.hood, .6 * f.hood, f.front(), back, w},
                          {f.hood, .95 * f.tail, f.hood_front, back + (is_lorry ? 0 : .02), w},
                          {f.belt, f.tail, f.windshield_low, f.rear_low, w},
                          {f.height, f.height, f.windshield_high, f.rear_high, f.width_at(f.height)}};
  constexpr int pieces = 4; // of a side
  std::vector<Path> rings;
  for (const Level& level : levels) {
    const double x = level.half_width;
    const Point corners[] = {{x, level.front, level.front_z},
                             {x, level.back, level.back_z},
                             {-x, level.back, level.back_z},
                             {-x, level.front, level.front_z}};
    rings.emplace_back();
    for (int side = 0; side < 4; ++side)
      for (int i = 0; i < pieces; ++i)
        rings.back().push_back(between(corners[side], corners[(side + 1) % 4], double(i) / pieces));
  }
  return {loft(rings), Kind::curve, line({0, .5 * f.belt, back}, {0, .5 * f.belt, f.front()})};
}

/// A pane that lies on the body between two of its corners across.
Solid pane(const Car_frame& f, const Point& low, const Point& high)
{
  constexpr double border = .06, thickness = .02;
  const auto surface = [=](double u, double v) {
    const Point p = between(low, high, border + u * (1 - 2 * border));
    return Point((2 * v - 1) * .88 * f.width_at(p.y()), p.y(), p.z());
  };
  return slab(surface, thickness, {5, 6, .05, .2});
}

/// A pane of the left side between two places along z, below the roof.
Solid side_pane(const Car_frame& f, double back, double front)
{
  const double low = f.belt + .02, high = f.height - .07;
  const auto edge = [&](double z, double y) { // not beyond the sloping ends of the cabin
    const double t = (y - f.belt) / (f.height - f.belt);
    const double most = f.windshield_low + t * (f.windshield_high - f.windshield_low) - .06;
    const double least = f.rear_low + t * (f.rear_high - f.rear_low) + .06;
    return std::clamp(z, std::min(least, most), most);
  };
  const auto surface = [=](double u, double v) {
    const double y = low + u * (high - low), from = edge(back, y), to = edge(front, y);
    return Point(f.width_at(y) + .004, y, from + v * (to - from));
  };
  return slab(surface, .016, {4, 6, .04, .2});
}

void add_windows(Assembly& car, const Car_frame& f, const Car_design& design)
{
  const Point low(0, f.belt, f.windshield_low + .01), high(0, f.height, f.windshield_high + .01);
  car.add("windshield", {"window", "windshield"}, pane(f, low, high));
  if (design.body != Car_body::lorry)
    car.add("rear_window", {"window", "rear_window"},
            pane(f, {0, f.tail, f.rear_low - .01}, {0, f.height, f.rear_high - .01}));
  const char* const names[] = {"window_front", "window_back", "window_quarter"};
  const double from = f.windshield_low - .05, to = design.body == Car_body::van ? .1 * f.length : f.rear_low;
  const double step = (from - to) / design.side_windows;
  for (int i = 0; i < design.side_windows; ++i) {
    const std::string name = names[i];
    const double front = from - i * step;
    car.add_pair({name + "_l", name + "_r"}, {"window", name}, side_pane(f, front - step + .06, front));
  }
}

Solid wheel(const Point& at, double radius, double width)
{
  const Solid disc_about_y = post({{0, -.35 * width},
                                   {.55 * radius, -.4 * width},
                                   {.6 * radius, -.5 * width},
                                   {.92 * radius, -.5 * width},
                                   {radius, -.38 * width},
                                   {radius, .38 * width},
                                   {.92 * radius, .5 * width},
                                   {.6 * radius, .5 * width},
                                   {.55 * radius, .4 * width},
                                   {0, .35 * width}},
                                  20);
  return transformed(disc_about_y, stand_on(at, at + Point::UnitX()));
}

void add_wheels(Assembly& car, const Car_frame& f, const Car_design& design)
{
  const double x = f.half_width - .08, width = design.body == Car_body::lorry ? .3 : .2;
  car.add_pair({"wheel_front_l", "wheel_front_r"}, {"wheel", "wheel_front"},
               wheel({x, f.radius, f.axle(true)}, f.radius, width));
  car.add_pair({"wheel_back_l", "wheel_back_r"}, {"wheel", "wheel_back"},
               wheel({x, f.radius, f.axle(false)}, f.radius, width));
}

void add_lights(Assembly& car, const Car_frame& f, double back)
{
  const double x = .72 * f.half_width;
  const auto light = [&](double y, double z) { return beam({x - .13, y, z}, {x + .13, y, z}, bar(.14, .06)); };
  car.add_pair({"headlight_l", "headlight_r"}, {"light", "headlight"}, light(.78 * f.hood, f.front() - .05));
  car.add_pair({"taillight_l", "taillight_r"}, {"light", "taillight"}, light(.8 * f.tail, back + .01));
}

/// What is behind the cabin of a lorry, and the frame that carries it.
void add_cargo(Assembly& car, const Car_frame& f)
{
  const double front = f.rear_low - .08, back = -f.front(), low = .76, high = f.height * 1.12;
  car.add(
      "cargo", {"cargo", ""},
      board({0, (low + high) / 2, (front + back) / 2}, 2 * f.half_width, front - back, high - low, {6, 6, .01, .05}));
  car.add("chassis", {"underbody", ""},
          board({0, .62, (front + back) / 2 + .2}, 1.8 * f.half_width, front - back + .4, .3));
}

Assembly car(const Car_design& design, std::uint64_t seed)
{
  Random random(seed);
  const Car_frame f(design, random);
  const bool is_lorry = design.body == Car_body::lorry;
  Assembly result(design.name, "car");
  result.add("body", {"body", ""}, car_body(f, is_lorry));
  add_windows(result, f, design);
  add_wheels(result, f, design);
  add_lights(result, f, -f.front());
  if (is_lorry) add_cargo(result, f);
  const double mirror_z = f.windshield_low - .15, mirror_y = f.belt + .08;
  result.add_pair(
      {"mirror_l", "mirror_r"}, {"mirror", "mirror"},
      beam({f.half_width - .03, mirror_y, mirror_z}, {f.half_width + .2, mirror_y, mirror_z}, bar(.13, .08)));
  const auto bumper = [&](double z) {
    const double x = .94 * f.half_width, bend = z > 0 ? -.14 : .14;
    return tube(bent({{-x, .42, z + bend}, {-.85 * x, .42, z}, {.85 * x, .42, z}, {x, .42, z + bend}}, .1),
                bar(.16, .1), Point::UnitY());
  };
  if (design.bumpers) {
    result.add("bumper_front", {"bumper", "bumper_front"}, bumper(f.front() + .02));
    if (!is_lorry) result.add("bumper_back", {"bumper", "bumper_back"}, bumper(-f.front()));
  }
  const auto grip = [&](double z) {
    const Point at(f.half_width + .01, f.belt - .08, z);
    return beam(at - Point(0, 0, .08), at + Point(0, 0, .08), round_section(.014));
  };
  if (design.handles) {
    const double door = f.windshield_low - 1.05;
    result.add_pair({"handle_front_l", "handle_front_r"}, {"handle", "handle_front"}, grip(door));
    if (design.side_windows > 1)
      result.add_pair({"handle_back_l", "handle_back_r"}, {"handle", "handle_back"}, grip(door - .85));
  }
  if (design.underbody)
    result.add("underbody", {"underbody", ""}, board({0, f.clearance, 0}, 1.5 * f.half_width, .86 * f.length, .08));
  if (design.interior)
    result.add("interior", {"interior", ""},
               board({0, (f.clearance + f.belt) / 2, (f.windshield_low + f.rear_low) / 2}, 1.5 * f.half_width,
                     .9 * (f.windshield_low - f.rear_low), f.belt - f.clearance, {6, 6, .05, .2}));
  return result;
}

const std::vector<Car_design>& car_designs()
{
  using B = Car_body;
  static const std::vector<Car_design> designs{
      {"car_saloon", B::saloon, 4.5, 1.45},
      {"car_saloon_plain", B::saloon, 4.4, 1.4, 2, false, false},
      {"car_saloon_underbody", B::saloon, 4.6, 1.42, 3, true, false, true},
      {"car_saloon_interior", B::saloon, 4.3, 1.44, 2, true, true, false, true},
      {"car_coupe", B::saloon, 4.2, 1.25, 1, true, true},
      {"car_sports", B::saloon, 4.3, 1.2, 2, true, false, true},
      {"car_sports_plain", B::saloon, 4.2, 1.18, 1, false, false},
      {"car_hatchback", B::estate, 3.9, 1.5, 2, true, true, false, true},
      {"car_estate", B::estate, 4.7, 1.5, 3},
      {"car_suv", B::estate, 4.6, 1.8, 3, true, true, true, true},
      {"car_suv_plain", B::estate, 4.5, 1.75, 3, false, false},
      {"car_van", B::van, 5., 2.1, 2, true, true},
      {"car_van_plain", B::van, 4.6, 2., 1, false, true, true},
      {"car_lorry", B::lorry, 6.5, 2.6, 1, true, true},
      {"car_lorry_plain", B::lorry, 5.8, 2.4, 1, false, false}};
  return designs;
}

} // namespace

std::vector<Assembly> cars(std::uint64_t seed) { return shapes_of(car_designs(), seed, car); }

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
