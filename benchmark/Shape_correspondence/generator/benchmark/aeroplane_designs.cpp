// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "aeroplane_designs.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

void add_fuselage(Assembly& plane, const Plane_frame& f, bool pod)
{
  const double n = f.nose(), end = pod ? -.12 * f.length : f.tail(), l = n - end, r = f.r;
  const auto at = [&](double t) { return n - t * l; };
  if (f.blunt) {
    plane.add("cowling", {"engine", ""},
              hull({{n, 0, .55 * r, .55 * r}, {n - .02 * l, 0, .85 * r, .85 * r}, {n - .12 * l, 0, .92 * r, .94 * r}},
                   16, 3));
    plane.add("fuselage", {"fuselage", ""},
              hull({{at(.11), 0, .9 * r, .92 * r},
                    {at(.25), .1 * r, r, 1.1 * r},
                    {at(.4), .15 * r, r, 1.2 * r},
                    {at(.6), .1 * r, .75 * r, .8 * r},
                    {at(.85), .25 * r, .35 * r, .4 * r},
                    {at(1), .35 * r, .1 * r, .15 * r}}));
    return;
  }
  plane.add("fuselage", {"fuselage", ""},
            hull({{n, -.2 * r, .06 * r, .06 * r},
                  {at(.02), -.18 * r, .4 * r, .38 * r},
                  {at(.07), -.1 * r, .75 * r, .75 * r},
                  {at(.18), 0, r, r},
                  {at(.5), 0, r, r},
                  {at(.7), .05 * r, .95 * r, .95 * r},
                  {at(.88), .3 * r, .5 * r, .5 * r},
                  {at(1), .45 * r, .1 * r, .14 * r}},
                 18));
}

Solid half_wing(double x0, double y, double z, double half_span, double chord, double taper, double sweep, double rise)
{
  return wing(
      {{{x0, y, z}, chord, .13 * chord}, {{x0 + half_span, y + rise, z - sweep}, taper * chord, .11 * taper * chord}},
      Point::UnitY(), 7);
}

std::function<Point(double)> add_wings(Assembly& plane, const Plane_frame& f, const Plane_design& design)
{
  const bool delta = design.wing == Plane_wing::delta, swept = design.wing == Plane_wing::swept;
  const bool high = design.wing == Plane_wing::high;
  const double half = .5 * f.span - .5 * f.r, x0 = .5 * f.r;
  const double y = high ? .95 * f.r : delta ? -.3 * f.r : -.65 * f.r;
  const double z = delta ? (design.canard ? .06 : .14) * f.length : swept ? .15 * f.length : f.wing_z();
  const double chord = delta ? .5 * f.length : swept ? 1.35 * f.chord : f.chord;
  const double sweep = delta ? .36 * f.length : swept ? .38 * half : .12 * f.chord;
  const double rise = high || delta ? .01 * half : .09 * half;
  const double taper = delta ? .16 : swept ? .3 : .62;
  const Names names{"wing_l", "wing_r"};
  if (delta)
    plane.add_pair(
        names, {"wing", "wing"},
        wing({{{x0, y, z}, chord, .06 * chord}, {{x0 + half, y + rise, z - sweep}, taper * chord, .05 * taper * chord}},
             Point::UnitY(), 8));
  else
    plane.add_pair(names, {"wing", "wing"}, half_wing(x0, y, z, half, chord, taper, sweep, rise));
  if (design.wing == Plane_wing::biplane) {
    const double up = 2.3 * f.r, gap_z = z + .25 * f.chord;
    plane.add_pair({"upper_wing_l", "upper_wing_r"}, {"wing", "wing"},
                   half_wing(.01, y + up, gap_z, half + x0, f.chord, .75, .1 * f.chord, .03 * half));
    const auto strut = [&](double x, double dz) {
      const double t = x / (half + x0);
      return beam({x, y + .05 * t * half, z - dz}, {x, y + up + .03 * t * half, gap_z - dz},
                  oval({.012 * f.length * .5, .006 * f.length * .5}, {.012 * f.length * .5, .006 * f.length * .5}, 8));
    };
    plane.add_pair({"strut_front_l", "strut_front_r"}, {"strut", "strut"}, strut(.68 * half, .25 * f.chord));
    plane.add_pair({"strut_rear_l", "strut_rear_r"}, {"strut", "strut"}, strut(.68 * half, .6 * f.chord));
    plane.add_pair({"cabane_l", "cabane_r"}, {"strut", "cabane"},
                   beam({.6 * f.r, .6 * f.r, z - .3 * f.chord}, {.8 * f.r, y + up, gap_z - .4 * f.chord},
                        round_section(.004 * f.length, 8)));
  }
  if (high && f.blunt)
    plane.add_pair({"brace_l", "brace_r"}, {"strut", "strut"},
                   beam({.8 * f.r, -.7 * f.r, z - .4 * f.chord}, {.5 * half, .95 * f.r, z - .4 * f.chord},
                        oval({.004 * f.length, .007 * f.length}, {.004 * f.length, .007 * f.length}, 8)));
  return [=](double t) { return Point(x0 + t * half, y + t * rise, z - t * sweep); };
}

void add_tail(Assembly& plane, const Plane_frame& f, const Plane_design& design, const Point& boom)
{
  const double c = .55 * f.chord * (design.wing == Plane_wing::swept ? 1.3 : 1), z = f.tail() + 1.25 * c,
               half = .17 * f.span;
  const double fin = std::max(2.2 * f.r, .12 * f.length), y = .3 * f.r;
  const Point side = Point::UnitX();
  if (design.tail == Plane_tail::booms) {
    const double x = boom.x(), y_boom = boom.y(), end = f.tail();
    plane.add_pair({"boom_l", "boom_r"}, {"boom", "boom"},
                   translated(hull({{f.wing_z() + .1 * f.length, y_boom, .2 * f.r, .2 * f.r},
                                    {f.wing_z(), y_boom, .42 * f.r, .45 * f.r},
                                    {0, y_boom, .36 * f.r, .4 * f.r},
                                    {end, y_boom + .1 * f.r, .14 * f.r, .18 * f.r}},
                                   12),
                              {x, 0, 0}));
    plane.add_pair(
        {"fin_l", "fin_r"}, {"v_stab", "v_stab"},
        wing({{{x, y_boom - .2 * f.r, z}, 1.2 * c, .09 * c}, {{x, y_boom + .9 * fin, z - .35 * c}, .75 * c, .06 * c}},
             side, 5));
    plane.add("tailplane", {"h_stab", ""},
              wing({{{-x, y_boom + .25 * f.r, z - .2 * c}, .8 * c, .08 * c},
                    {{x, y_boom + .25 * f.r, z - .2 * c}, .8 * c, .08 * c}},
                   Point::UnitY(), 8));
    return;
  }
  plane.add("fin", {"v_stab", ""},
            wing({{{0, y, z + .1 * c}, 1.35 * c, .1 * c}, {{0, y + fin, z - .55 * c}, .75 * c, .06 * c}}, side, 6));
  if (design.tail == Plane_tail::fin_only) return;
  const bool top = design.tail == Plane_tail::t_tail;
  plane.add_pair({"stabiliser_l", "stabiliser_r"}, {"h_stab", "h_stab"},
                 wing({{{.0, top ? y + .98 * fin : .3 * f.r, top ? z - .5 * c : z}, top ? .8 * c : c, .09 * c},
                       {{half, top ? y + fin : .35 * f.r, z - .55 * c}, .5 * c, .05 * c}},
                      Point::UnitY(), 6));
}

void add_propeller(Assembly& plane, const std::string& stem, const Label& label, const Point& hub, double radius)
{
  plane.add("blades" + stem, label, translated(two_bladed_propeller(radius, .16 * radius), hub));
}

void add_engines(Assembly& plane, const Plane_frame& f, const Plane_design& design,
                 const std::function<Point(double)>& leading_edge)
{
  const int pairs = design.number_of_engines / 2;
  const double jet_radius = .42 * f.r + .006 * f.length;
  const double prop = std::min(1.1 * f.r + .05 * f.span, (pairs == 2 ? .06 : .11) * f.span);
  switch (design.engines) {
  case Plane_engines::jets_under_wing:
    for (int i = 0; i < pairs; ++i) {
      const std::string number = pairs > 1 ? "_" + std::to_string(i + 1) : "";
      const Point le = leading_edge(pairs == 1 ? .3 : .27 + .28 * i),
                  at = le + Point(0, -1.45 * jet_radius, .9 * jet_radius);
      plane.add_pair({"jet_l" + number, "jet_r" + number}, {"engine", "engine"},
                     translated(jet_engine(3.6 * jet_radius, jet_radius), at));
      plane.add_pair({"pylon_l" + number, "pylon_r" + number}, {"pylon", "pylon"},
                     wing({{at + Point(0, .8 * jet_radius, -.8 * jet_radius), 2.4 * jet_radius, .25 * jet_radius},
                           {le + Point(0, 0, -.3 * jet_radius), 2.2 * jet_radius, .25 * jet_radius}},
                          Point::UnitX(), 4));
    }
    return;
  case Plane_engines::jets_in_tail:
    plane.add_pair({"jet_l", "jet_r"}, {"engine", "engine"},
                   translated(jet_engine(.17 * f.length, .38 * f.r), {1.55 * f.r, .5 * f.r, -.2 * f.length}));
    plane.add_pair({"pylon_l", "pylon_r"}, {"pylon", "pylon"},
                   wing({{{.7 * f.r, .45 * f.r, -.23 * f.length}, .1 * f.length, .1 * f.r},
                         {{1.3 * f.r, .5 * f.r, -.23 * f.length}, .09 * f.length, .1 * f.r}},
                        Point::UnitY(), 3));
    return;
  case Plane_engines::nozzles:
    if (design.number_of_engines == 1)
      plane.add("nozzle", {"engine", ""},
                hull({{f.tail() + .16 * f.length, .2 * f.r, .62 * f.r, .62 * f.r},
                      {f.tail() + .06 * f.length, .25 * f.r, .66 * f.r, .66 * f.r},
                      {f.tail() - .02 * f.length, .3 * f.r, .52 * f.r, .52 * f.r}},
                     16, 3));
    else
      plane.add_pair(
          {"nacelle_l", "nacelle_r"}, {"engine", "engine"},
          translated(jet_engine(.24 * f.length, .42 * f.r), leading_edge(.3) + Point(0, -.5 * f.r, -.04 * f.length)));
    return;
  case Plane_engines::nose_propeller:
    plane.add("spinner", {"propeller", "spinner"},
              transformed(post({{0, 0},
                                {.3 * f.r, 0},
                                {.3 * f.r, .1 * f.r},
                                {.26 * f.r, .35 * f.r},
                                {.13 * f.r, .55 * f.r},
                                {0, .62 * f.r}},
                               14),
                          stand_on({0, 0, f.nose() - .02 * f.r}, {0, 0, f.nose() + 1})));
    add_propeller(plane, "", {"propeller", ""}, {0, 0, f.nose() + .12 * f.r}, 1.15 * f.r + .04 * f.length);
    return;
  case Plane_engines::pusher: {
    const double end = design.tail == Plane_tail::booms ? -.12 * f.length : f.tail(), y = .4 * f.r;
    plane.add("engine", {"engine", ""},
              hull({{end + .16 * f.length, y * .5, .7 * f.r, .7 * f.r},
                    {end + .07 * f.length, y * .8, .62 * f.r, .62 * f.r},
                    {end - .015 * f.length, y, .3 * f.r, .3 * f.r}},
                   16, 3));
    add_propeller(plane, "", {"propeller", ""}, {0, y, end - .025 * f.length}, .9 * f.r + .035 * f.length);
    return;
  }
  case Plane_engines::wing_propellers:
    for (int i = 0; i < pairs; ++i) {
      const std::string number = pairs > 1 ? "_" + std::to_string(i + 1) : "";
      const bool on_booms = design.tail == Plane_tail::booms;
      const Point le = on_booms ? Point(leading_edge(boom_place) + Point(0, 0, .1 * f.length))
                                : leading_edge(pairs == 1 ? .32 : .26 + .27 * i);
      const double r = .42 * f.r, front = le.z() + (on_booms ? .02 : .09) * f.length;
      plane.add_pair({"nacelle_l" + number, "nacelle_r" + number}, {"engine", "engine"},
                     translated(hull({{front, le.y(), .4 * r, .4 * r},
                                      {front - .01 * f.length, le.y(), .85 * r, .85 * r},
                                      {front - .06 * f.length, le.y(), r, r},
                                      {front - (on_booms ? .1 : .17) * f.length, le.y(), .75 * r, .75 * r},
                                      {front - (on_booms ? .12 : .24) * f.length, le.y(), .2 * r, .2 * r}},
                                     14),
                                {le.x(), 0, 0}));
      plane.add_pair({"blades_l" + number, "blades_r" + number}, {"propeller", "propeller"},
                     translated(two_bladed_propeller(prop, .16 * prop), {le.x(), le.y(), front + .02 * r}));
    }
    return;
  case Plane_engines::none:
    return;
  }
}

void add_gear_leg(Assembly& plane, const std::string& stem, const std::string& fine, const Point& top, double ground,
                  double wheel)
{
  plane.add("strut_" + stem, {"gear", fine}, beam({top.x(), ground + wheel, top.z()}, top, round_section(.3 * wheel)));
  plane.add("wheel_" + stem, {"gear", fine}, landing_wheel({top.x(), ground + wheel, top.z()}, wheel, .9 * wheel));
}

void add_gear(Assembly& plane, const Plane_frame& f, const Plane_design& design,
              const std::function<Point(double)>& leading_edge)
{
  if (design.gear == Plane_gear::none) return;
  const double wheel = .32 * f.r + .004 * f.length, ground = -1.9 * f.r - wheel;
  const bool tail_wheel = design.gear == Plane_gear::tail_wheel, at_hull = design.wing == Plane_wing::high;
  // In the lower wing, or in the hull under a high one
  const Point at_wing = leading_edge(.08) - Point(0, 0, (tail_wheel ? .3 : .6) * f.chord);
  const Point root = at_hull ? Point(.45 * f.r, -.5 * f.r, 0) : at_wing;
  const Point foot(std::max(root.x(), 1.5 * f.r), ground + wheel, root.z());
  plane.add_pair({"gear_l", "gear_r"}, {"gear", "gear"}, beam(foot, root, round_section(.3 * wheel)));
  plane.add_pair({"wheel_l", "wheel_r"}, {"gear", "gear"}, landing_wheel(foot, wheel, .9 * wheel));
  if (tail_wheel)
    add_gear_leg(plane, "tail", "gear_tail", {0, .1 * f.r, f.tail() + .06 * f.length}, -.75 * f.r - .5 * wheel,
                 .5 * wheel);
  else
    add_gear_leg(plane, "nose", "gear_nose", {0, -.5 * f.r, .37 * f.length}, ground, .8 * wheel);
}

Assembly aeroplane(const Plane_design& design, std::uint64_t seed)
{
  Random random(seed);
  const Plane_frame f(design, random);
  Assembly plane(design.name, "airplane");
  add_fuselage(plane, f, design.tail == Plane_tail::booms);
  const auto leading_edge = add_wings(plane, f, design);
  add_tail(plane, f, design, leading_edge(boom_place));
  if (design.canard)
    plane.add_pair({"canard_l", "canard_r"}, {"canard", "canard"},
                   half_wing(.4 * f.r, .1 * f.r, .4 * f.length, .15 * f.span, .5 * f.chord, .6, .2 * f.chord, 0));
  add_engines(plane, f, design, leading_edge);
  add_gear(plane, f, design, leading_edge);
  return plane;
}

const std::vector<Plane_design>& aeroplane_designs()
{
  using Wing = Plane_wing;
  using Tail = Plane_tail;
  using Engines = Plane_engines;
  using Gear = Plane_gear;
  static const std::vector<Plane_design> designs{
      {"airplane_low_wing", Wing::low, Tail::low, Engines::nose_propeller, 1, Gear::tail_wheel, false, 7, 9.5},
      {"airplane_airliner", Wing::swept, Tail::low, Engines::jets_under_wing, 2, Gear::nose_wheel, false, 36, 33},
      {"airplane_four_jets", Wing::swept, Tail::low, Engines::jets_under_wing, 4, Gear::nose_wheel, false, 60, 58},
      {"airplane_business_jet", Wing::swept, Tail::t_tail, Engines::jets_in_tail, 2, Gear::nose_wheel, false, 18, 17},
      {"airplane_high_wing", Wing::high, Tail::low, Engines::nose_propeller, 1, Gear::nose_wheel, false, 7.5, 10.5},
      {"airplane_commuter", Wing::high, Tail::t_tail, Engines::wing_propellers, 2, Gear::nose_wheel, false, 22, 26},
      {"airplane_transport", Wing::high, Tail::low, Engines::wing_propellers, 4, Gear::nose_wheel, false, 29, 38},
      {"airplane_biplane", Wing::biplane, Tail::low, Engines::nose_propeller, 1, Gear::tail_wheel, false, 7, 8.5},
      {"airplane_biplane_twin", Wing::biplane, Tail::low, Engines::wing_propellers, 2, Gear::tail_wheel, false, 9, 13},
      {"airplane_delta", Wing::delta, Tail::fin_only, Engines::nozzles, 1, Gear::none, false, 15, 9},
      {"airplane_delta_twin", Wing::delta, Tail::fin_only, Engines::nozzles, 2, Gear::nose_wheel, false, 30, 15},
      {"airplane_twin_boom", Wing::high, Tail::booms, Engines::pusher, 1, Gear::nose_wheel, false, 9, 11},
      {"airplane_twin_boom_twin", Wing::low, Tail::booms, Engines::wing_propellers, 2, Gear::nose_wheel, false, 11, 15},
      {"airplane_canard", Wing::low, Tail::fin_only, Engines::pusher, 1, Gear::nose_wheel, true, 6, 8.5},
      {"airplane_glider", Wing::high, Tail::t_tail, Engines::none, 0, Gear::none, false, 7, 16}};
  return designs;
}

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
