// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "lamp_designs.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

Solid lamp_shade(double height, double top, double bottom)
{
  constexpr double wall = .004;
  return post({{0, -.02},
               {.5 * top, -.005},
               {top, -.005},
               {.5 * (top + bottom), -.5 * height},
               {bottom, -height},
               {bottom - wall, -height},
               {.5 * (top + bottom) - wall, -.5 * height},
               {top - wall, -.012},
               {.4 * top, -.012},
               {0, -.028}},
              24);
}

Solid light_bulb(double size)
{
  return post({{0, 0},
               {.4 * size, 0},
               {.42 * size, -.6 * size},
               {.85 * size, -1.4 * size},
               {size, -2 * size},
               {.8 * size, -2.6 * size},
               {.35 * size, -2.95 * size},
               {0, -3 * size}},
              12);
}

Solid upside_down(const Solid& solid) { return transformed(solid, rotation_about(Point::Zero(), Point::UnitX(), pi)); }

Solid lamp_foot(double radius, double height)
{
  return disc({{0, 0},
               {.6 * radius, 0},
               {.96 * radius, 0},
               {radius, .3 * height},
               {.9 * radius, .7 * height},
               {.3 * radius, height},
               {0, height}},
              radius, .4 * height, 28);
}

Solid hinge(const Point& at, double radius)
{
  const Solid barrel = post({{0, -1.5 * radius},
                             {.85 * radius, -1.5 * radius},
                             {radius, -1.2 * radius},
                             {radius, 1.2 * radius},
                             {.85 * radius, 1.5 * radius},
                             {0, 1.5 * radius}});
  return transformed(barrel, stand_on(at, at + Point::UnitX()));
}

Assembly desk_lamp(const char* name, int rods, bool paired, bool clamp, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double rod = random.about(.24, .15);
  if (clamp) {
    lamp.add("clamp", {"base", "clamp"},
             tube(bent({{0, -.05, .05}, {0, -.05, -.03}, {0, .02, -.03}, {0, .02, .03}}, .012), bar(.04, .012)));
    lamp.add("screw", {"base", "clamp_screw"}, beam({0, -.09, .035}, {0, -.02, .035}, round_section(.007)));
  } else
    lamp.add("foot", {"base", ""}, lamp_foot(random.about(.1), .028));
  lamp.add("turret", {"body", ""}, beam({0, .015, 0}, {0, .09, 0}, round_section(.016)));
  Path joints{{0, .08, 0}};
  for (int i = 0; i < rods; ++i) {
    const double angle = i % 2 == 0 ? random.between(1.7, 1.95) : random.between(.5, .75);
    joints.push_back(joints.back() + rod * Point(0, std::sin(angle), std::cos(angle)));
  }
  for (int i = 0; i < rods; ++i) {
    const std::string number = std::to_string(i + 1);
    const double apart = i % 2 == 0 ? .018 : .008;
    const Point side(paired ? apart : 0, 0, 0);
    if (paired)
      lamp.add_pair({"rod_l" + number, "rod_r" + number}, {"arm", ""},
                    beam(joints[i] + side, joints[i + 1] + side, round_section(.005, 8)));
    else
      lamp.add("rod" + number, {"arm", ""}, beam(joints[i], joints[i + 1], round_section(.009)));
    lamp.add("hinge" + number, {"body", "hinge"}, hinge(joints[i + 1], .016));
  }
  const double tilt = random.between(.3, .7);
  const Eigen::Isometry3d head =
      Eigen::Translation3d(joints.back() + Point(0, -.012, .006)) * Eigen::AngleAxisd(-tilt, Point::UnitX());
  lamp.add("shade", {"shade", ""}, transformed(lamp_shade(.14, .03, random.about(.08)), head));
  lamp.add("bulb", {"bulb", ""}, transformed(translated(light_bulb(.026), {0, -.024, 0}), head));
  return lamp;
}

Assembly standing_lamp(const char* name, Lamp_body body, double height, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double h = random.about(height, .08), r = random.about(.09),
               shade = random.about(.16) * std::sqrt(height / .45);
  const double neck = h - 1.1 * shade;
  const auto profile = [&](Profile points) {
    for (Point_2& p : points)
      p = {p.x() * r, .03 + p.y() * (neck - .03)};
    return points;
  };
  if (body != Lamp_body::tripod) lamp.add("foot", {"base", ""}, lamp_foot(body == Lamp_body::pole ? .16 : r, .034));
  switch (body) {
  case Lamp_body::vase:
    lamp.add(
        "vase", {"body", "vase"},
        post(profile({{0, -.02}, {.55, -.02}, {.6, .02}, {1, .4}, {.95, .6}, {.5, .85}, {.25, .93}, {.25, 1}, {0, 1}}),
             20));
    break;
  case Lamp_body::column:
    lamp.add(
        "column", {"body", "post"},
        post(profile({{0, -.02}, {.36, -.02}, {.36, .1}, {.3, .12}, {.3, .5}, {.3, .88}, {.36, .9}, {.36, 1}, {0, 1}}),
             14));
    break;
  case Lamp_body::candlestick:
    lamp.add("candlestick", {"body", "post"},
             post(profile({{0, -.02},
                           {.45, -.02},
                           {.25, .06},
                           {.4, .12},
                           {.16, .2},
                           {.16, .45},
                           {.36, .52},
                           {.16, .6},
                           {.16, .85},
                           {.3, .93},
                           {.2, 1},
                           {0, 1}}),
                  14));
    break;
  case Lamp_body::balls:
    for (int i = 0; i < 3; ++i) {
      const double size = (neck - .03) / 6, y = .024 + (2 * i + 1) * size;
      lamp.add("ball_" + std::to_string(i + 1), {"body", ""},
               post({{0, y - 1.03 * size},
                     {.6 * size, y - .82 * size},
                     {.95 * size, y - .35 * size},
                     {size, y},
                     {.95 * size, y + .35 * size},
                     {.6 * size, y + .82 * size},
                     {0, y + 1.03 * size}},
                    18));
    }
    break;
  case Lamp_body::pole:
    lamp.add("pole", {"body", "post"}, beam({0, .025, 0}, {0, neck, 0}, round_section(.014), 9));
    break;
  case Lamp_body::tripod: {
    const double top = .8 * neck;
    lamp.add_ring(numbered("leg_", 3), {"base", "leg"}, beam({0, 0, .32}, {0, top, .025}, round_section(.012, .016), 7),
                  Point::Zero(), Point::UnitY());
    lamp.add("hub", {"body", "hub"},
             post({{0, top - .03},
                   {.035, top - .03},
                   {.045, top - .015},
                   {.045, top + .015},
                   {.035, top + .03},
                   {0, top + .03}},
                  14));
    lamp.add("pole", {"body", "post"}, beam({0, top + .02, 0}, {0, neck, 0}, round_section(.012)));
  }
  }
  lamp.add("socket", {"body", "neck"}, beam({0, neck - .008, 0}, {0, neck + .035, 0}, round_section(.017), 3));
  lamp.add("bulb", {"bulb", ""}, translated(upside_down(light_bulb(.027)), {0, neck + .03, 0}));
  const double shade_height = 1.2 * shade;
  lamp.add("shade", {"shade", ""}, translated(lamp_shade(shade_height, .6 * shade, shade), {0, neck + .155, 0}));
  lamp.add("finial", {"shade", "cap"},
           translated(post({{0, 0}, {.008, 0}, {.008, .035}, {.014, .045}, {.008, .055}, {0, .058}}, 10),
                      {0, neck + .105, 0}));
  return lamp;
}

Assembly arc_lamp(const char* name, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double h = random.about(1.9, .06), reach = random.about(1.1, .08);
  lamp.add("foot", {"base", ""}, board({0, .04, 0}, .3, .34, .08, {4, 4, .04, .2}));
  lamp.add("arc", {"arm", ""},
           tube(spline({{0, .07, 0},
                        {0, .6 * h, -.06},
                        {0, .93 * h, .12},
                        {0, h, .5 * reach},
                        {0, .93 * h, .88 * reach},
                        {0, .84 * h, reach}}),
                round_section(.016)));
  const Point end(0, .84 * h, reach);
  lamp.add("socket", {"body", "neck"}, beam(end + Point(0, .02, 0), end - Point(0, .06, 0), round_section(.022), 3));
  lamp.add("shade", {"shade", ""}, translated(lamp_shade(.2, .06, .19), end - Point(0, .02, 0)));
  lamp.add("bulb", {"bulb", ""}, translated(light_bulb(.03), end - Point(0, .055, 0)));
  return lamp;
}

double add_lamp_chain(Assembly& lamp, double top, int n, double size)
{
  for (int i = 0; i < n; ++i) {
    const Point middle(0, top - (i + .5) * 1.55 * size, 0);
    lamp.add("link_" + std::to_string(i + 1), {"chain", ""},
             torus(middle, i % 2 == 0 ? Point::UnitX() : Point::UnitZ(), size, round_section(.24 * size, 8), 20));
  }
  return top - n * 1.55 * size - .35 * size;
}

Assembly pendant(const char* name, int links, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double shade = random.about(.18), height = 1.;
  lamp.add("rose", {"base", "ceiling_mount"}, translated(lamp_foot(.07, .03), {0, height - .03, 0}));
  double y = height - .022;
  if (links)
    y = add_lamp_chain(lamp, y, links, .026) + .004;
  else {
    lamp.add("rod", {"chain", "rod"}, beam({0, y, 0}, {0, y - .38, 0}, round_section(.006), 7));
    y -= .378;
  }
  lamp.add("socket", {"body", "neck"}, beam({0, y + .012, 0}, {0, y - .07, 0}, round_section(.022), 3));
  lamp.add("shade", {"shade", ""}, translated(lamp_shade(.9 * shade, .3 * shade, shade), {0, y - .03, 0}));
  lamp.add("bulb", {"bulb", ""}, translated(light_bulb(.03), {0, y - .064, 0}));
  return lamp;
}

Assembly chandelier(const char* name, int arms, bool shades, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double reach = random.about(.34), y = .45;
  lamp.add("rose", {"base", "ceiling_mount"}, translated(lamp_foot(.06, .028), {0, .972, 0}));
  const double low = add_lamp_chain(lamp, .978, 6, .026);
  lamp.add("body", {"body", ""},
           post({{0, y - .06},
                 {.02, y - .05},
                 {.06, y},
                 {.05, y + .06},
                 {.02, y + .1},
                 {.04, y + .16},
                 {.016, y + .22},
                 {.012, low + .01},
                 {0, low + .012}},
                16));
  lamp.add_ring(numbered("arm_", arms), {"arm", ""},
                tube(spline({{0, y, .045},
                             {0, y - .07, .4 * reach},
                             {0, y - .06, .8 * reach},
                             {0, y + .02, reach},
                             {0, y + .05, reach}}),
                     round_section(.01)),
                Point::Zero(), Point::UnitY());
  lamp.add_ring(numbered("cup_", arms), {"body", "neck"},
                translated(post({{0, 0}, {.012, 0}, {.03, .018}, {.03, .026}, {.016, .03}, {.016, .07}, {0, .07}}, 12),
                           {0, y + .042, reach}),
                Point::Zero(), Point::UnitY());
  lamp.add_ring(numbered("bulb_", arms), {"bulb", ""}, translated(upside_down(light_bulb(.018)), {0, y + .108, reach}),
                Point::Zero(), Point::UnitY());
  if (shades)
    lamp.add_ring(numbered("shade_", arms), {"shade", ""}, translated(lamp_shade(.1, .04, .075), {0, y + .18, reach}),
                  Point::Zero(), Point::UnitY());
  return lamp;
}

Assembly spot_bar(const char* name, int spots, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double step = random.about(.26), width = step * spots, y = .4;
  lamp.add("rose", {"base", "ceiling_mount"}, translated(lamp_foot(.06, .03), {0, y - .004, 0}));
  lamp.add("bar", {"body", "post"}, beam({-.5 * width, y - .01, 0}, {.5 * width, y - .01, 0}, bar(.03, .024), 8));
  const double first = -.5 * step * (spots - 1);
  lamp.add_row(numbered("bracket_", spots), {"arm", ""},
               beam({first, y - .015, 0}, {first, y - .1, .02}, round_section(.008)), {step, 0, 0});
  const Point at(first, y - .085, .015);
  const Eigen::Isometry3d head = Eigen::Translation3d(at) * Eigen::AngleAxisd(-.6, Point::UnitX());
  lamp.add_row(numbered("spot_", spots), {"shade", ""}, transformed(lamp_shade(.11, .03, .05), head), {step, 0, 0});
  lamp.add_row(numbered("bulb_", spots), {"bulb", ""}, transformed(translated(light_bulb(.02), {0, -.022, 0}), head),
               {step, 0, 0});
  return lamp;
}

std::vector<Assembly> lamps(std::uint64_t seed)
{
  return {desk_lamp("lamp_desk_two_rods", 2, true, false, seed),
          desk_lamp("lamp_desk_single", 2, false, false, seed + 1),
          desk_lamp("lamp_desk_clamp", 2, true, true, seed + 2),
          desk_lamp("lamp_desk_three_rods", 3, false, false, seed + 3),
          standing_lamp("lamp_vase", Lamp_body::vase, .5, seed + 4),
          standing_lamp("lamp_column", Lamp_body::column, .55, seed + 5),
          standing_lamp("lamp_candlestick", Lamp_body::candlestick, .5, seed + 6),
          standing_lamp("lamp_balls", Lamp_body::balls, .5, seed + 7),
          standing_lamp("lamp_floor", Lamp_body::pole, 1.6, seed + 8),
          standing_lamp("lamp_tripod", Lamp_body::tripod, 1.5, seed + 9),
          arc_lamp("lamp_arc", seed + 10),
          pendant("lamp_pendant_chain", 8, seed + 11),
          chandelier("lamp_chandelier", 5, false, seed + 12),
          chandelier("lamp_chandelier_shades", 6, true, seed + 13),
          spot_bar("lamp_spots", 3, seed + 14)};
}

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
