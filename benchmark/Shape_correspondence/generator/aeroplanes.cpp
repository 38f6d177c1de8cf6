// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "designs.h"

namespace CGAL::Shape_correspondence::generator {

Solid landing_wheel(const Point& middle, double radius, double width)
{
  const double half = width / 2;
  const Solid wheel = post({{0, -.6 * half},
                            {.5 * radius, -.6 * half},
                            {.6 * radius, -half},
                            {.85 * radius, -.9 * half},
                            {radius, -.4 * half},
                            {radius, .4 * half},
                            {.85 * radius, .9 * half},
                            {.6 * radius, half},
                            {.5 * radius, .6 * half},
                            {0, .6 * half}},
                           16);
  return transformed(wheel, stand_on(middle, middle + Point::UnitX()));
}

Solid jet_engine(double length, double radius)
{
  Profile profile{{0, -.12}, {.2, -.2}, {.78, -.2},  {.8, -.04},  {.87, 0},    {.95, -.04}, {1, -.2},
                  {1, -.45}, {.9, -.7}, {.68, -.86}, {.52, -.86}, {.42, -.94}, {0, -1.08}};
  for (Point_2& p : profile)
    p = {p.x() * radius, p.y() * length};
  return transformed(post(profile, 16), stand_on(Point::Zero(), Point::UnitZ()));
}

Assembly airplane_twin_engine()
{
  Assembly plane("airplane_twin_engine", "airplane");
  plane.add("hull", {"fuselage", ""},
            hull({{17.4, -.35, .1, .1},
                  {17, -.32, .62, .6},
                  {16, -.15, 1.25, 1.25},
                  {14, 0, 1.85, 1.9},
                  {12, 0, 1.98, 2},
                  {6, 0, 1.98, 2},
                  {0, 0, 1.98, 2},
                  {-7, 0, 1.98, 2},
                  {-11, .35, 1.65, 1.65},
                  {-15, 1, .9, .95},
                  {-18, 1.35, .3, .4},
                  {-18.6, 1.4, .12, .2}},
                 18));
  const Point up = Point::UnitY();
  plane.add_pair({"port_wing", "starboard_wing"}, {"wing", "wing"},
                 wing({{{1, -1.1, 5}, 7, .95}, {{6, -.75, 1.9}, 3.9, .5}, {{17, .2, -3.6}, 1.5, .17}}, up));
  plane.add_pair({"port_tailplane", "starboard_tailplane"}, {"h_stab", "h_stab"},
                 wing({{{.3, 1.1, -13.2}, 3.6, .36}, {{6.2, 1.7, -16.7}, 1.4, .13}}, up, 5));
  plane.add(
      "fin", {"v_stab", ""},
      wing({{{0, 1.3, -10.6}, 5.4, .45}, {{0, 2.6, -12.2}, 4.3, .4}, {{0, 7.4, -16.3}, 1.8, .17}}, Point::UnitX(), 3));
  plane.add_pair({"port_jet", "starboard_jet"}, {"engine", "engine"},
                 translated(jet_engine(4.2, 1.05), {5.8, -2.2, 4.6}));
  plane.add_pair({"port_pylon", "starboard_pylon"}, {"pylon", "pylon"},
                 wing({{{5.8, -1.35, 3.6}, 3.4, .35}, {{5.8, -.7, 2.2}, 3., .35}}, Point::UnitX(), 3));
  plane.add("nose_strut", {"gear", "gear_nose"}, beam({0, -3.4, 13}, {0, -1.5, 13.1}, round_section(.11)));
  plane.add("nose_wheel", {"gear", "gear_nose"}, landing_wheel({0, -3.45, 13}, .38, .5));
  plane.add_pair({"port_strut", "starboard_strut"}, {"gear", "gear"},
                 beam({2.9, -3.2, -.2}, {2.75, -.95, -.1}, round_section(.16)));
  plane.add_pair({"port_wheel", "starboard_wheel"}, {"gear", "gear"}, landing_wheel({2.9, -3.25, -.2}, .58, .9));
  plane.touch("hull", {"port_wing", "starboard_wing", "port_tailplane", "starboard_tailplane", "fin", "nose_strut"});
  plane.touch("nose_strut", {"nose_wheel"});
  const Names wings{"port_wing", "starboard_wing"}, pylons{"port_pylon", "starboard_pylon"},
      struts{"port_strut", "starboard_strut"};
  plane.touch_in_turn(wings, pylons);
  plane.touch_in_turn(wings, struts);
  plane.touch_in_turn(pylons, {"port_jet", "starboard_jet"});
  plane.touch_in_turn(struts, {"port_wheel", "starboard_wheel"});
  return plane;
}

Solid two_bladed_propeller(double radius, double chord)
{
  constexpr int steps = 12, n = 10;
  std::vector<Path> rings;
  for (int i = 0; i <= steps; ++i) {
    const double x = -1 + 2. * i / steps, r = std::abs(x);
    const double width = chord * (.35 + 1.6 * r - 1.6 * r * r * r), pitch = pi / 2 - 1.1 * std::clamp(1.3 * x, -1., 1.);
    const double thickness = chord * (.34 - .26 * r);
    Path ring;
    for (int j = 0; j < n; ++j) {
      const double angle = 2 * pi * (j + 0.5) / n, a = width / 2 * std::cos(angle), b = thickness / 2 * std::sin(angle);
      ring.push_back(
          {x * radius, a * std::cos(pitch) - b * std::sin(pitch), a * std::sin(pitch) + b * std::cos(pitch)});
    }
    rings.push_back(ring);
  }
  return {loft(rings), Kind::curve, line({-radius, 0, 0}, {radius, 0, 0}, 6)};
}

Assembly airplane_propeller()
{
  Assembly plane("airplane_propeller", "airplane");
  plane.add("body", {"fuselage", ""},
            hull({{1.5, -.02, .46, .4},
                  {.9, .02, .52, .5},
                  {.35, .2, .55, .68},
                  {-.4, .22, .55, .7},
                  {-1.2, .16, .5, .62},
                  {-2, .06, .36, .42},
                  {-3.5, .08, .2, .25},
                  {-5.2, .14, .07, .12}}));
  plane.add("cowling", {"engine", ""},
            hull({{2.25, -.03, .3, .27}, {2.18, -.03, .4, .36}, {1.9, -.03, .46, .42}, {1.4, -.02, .485, .44}}, 16, 3));
  plane.add("spinner", {"propeller", "spinner"},
            transformed(post({{0, 0}, {.17, 0}, {.17, .06}, {.15, .17}, {.1, .27}, {.05, .32}, {0, .335}}, 14),
                        stand_on({0, -.03, 2.22}, {0, -.03, 3})));
  plane.add("airscrew", {"propeller", ""}, translated(two_bladed_propeller(.95, .17), {0, -.03, 2.33}));
  const Point up = Point::UnitY();
  plane.add_pair({"wing_a", "wing_b"}, {"wing", "wing"},
                 wing({{{.1, .87, .6}, 1.63, .2}, {{2.6, .92, .6}, 1.63, .2}, {{5.4, .98, .45}, 1.13, .13}}, up));
  plane.add_pair({"brace_a", "brace_b"}, {"strut", "strut"},
                 beam({.36, -.28, .1}, {2.45, .9, .0}, oval({.06, .03}, {.06, .03}, 8)));
  plane.add_pair({"stabiliser_a", "stabiliser_b"}, {"h_stab", "h_stab"},
                 wing({{{.02, .2, -4.2}, 1.25, .11}, {{1.7, .2, -4.45}, .8, .07}}, up));
  plane.add(
      "rudder_fin", {"v_stab", ""},
      wing({{{0, .15, -3.5}, 1.75, .1}, {{0, .55, -4}, 1.35, .1}, {{0, 1.6, -4.75}, .8, .07}}, Point::UnitX(), 3));
  plane.add_pair(
      {"main_leg_a", "main_leg_b"}, {"gear", "gear"},
      tube(spline({{.25, -.4, -.5}, {.6, -.62, -.52}, {1.15, -1.12, -.55}}), bar({.05, .14}, {.03, .09}), up));
  plane.add_pair({"main_tyre_a", "main_tyre_b"}, {"gear", "gear"}, landing_wheel({1.18, -1.1, -.55}, .21, .16));
  plane.add("nose_leg", {"gear", "gear_nose"}, beam({0, -1.0, 1.62}, {0, -.3, 1.5}, round_section(.035)));
  plane.add("nose_tyre", {"gear", "gear_nose"}, landing_wheel({0, -1.12, 1.64}, .19, .14));
  const Names wings{"wing_a", "wing_b"}, braces{"brace_a", "brace_b"}, legs{"main_leg_a", "main_leg_b"};
  plane.touch("body", {"cowling", "stabiliser_a", "stabiliser_b", "rudder_fin", "nose_leg"});
  for (const Names& pair : {wings, braces, legs})
    plane.touch("body", pair);
  plane.touch_in_turn(wings, braces);
  plane.touch_in_turn(legs, {"main_tyre_a", "main_tyre_b"});
  plane.touch("rudder_fin", {"stabiliser_a", "stabiliser_b"});
  plane.touch("spinner", {"cowling", "airscrew"});
  plane.touch("nose_leg", {"nose_tyre", "cowling"});
  return plane;
}

} // namespace CGAL::Shape_correspondence::generator
