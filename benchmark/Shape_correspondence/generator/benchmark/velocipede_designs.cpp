// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "velocipede_designs.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

void add_wheel(Assembly& shape, const std::string& stem, const std::string& where, const Point& axle, double radius,
               double tyre_radius, int n)
{
  shape.add("tyre_" + stem, {"wheel", "wheel_" + where}, tyre(axle, radius, tyre_radius));
  shape.add("spokes_" + stem, {"spokes", "spokes_" + where}, spokes(axle, .02, radius - .4 * tyre_radius, .025, n));
  shape.add("hub_" + stem, {"hub", "hub_" + where}, along_x(hub_profile(.058, .024, .025), axle));
}

Solid solid_wheel(const Point& axle, double radius, double half_axle)
{
  const Profile profile{{0, -half_axle},       {.008, -half_axle},   {.009, -.012},       {.5 * radius, -.008},
                        {.93 * radius, -.008}, {.93 * radius, .008}, {.5 * radius, .008}, {.009, .012},
                        {.008, half_axle},     {0, half_axle}};
  return transformed(disc(profile, .93 * radius, 0, 20), stand_on(axle, axle + Point::UnitX()));
}

void add_wheel_pair(Assembly& shape, const std::string& stem, const std::string& where, const Point& axle,
                    double radius, double tyre_radius, int n)
{
  const auto both = [&](const std::string& part) { return Names{part + stem + "_l", part + stem + "_r"}; };
  const Label tyre_label{"wheel", "wheel_" + where}, spokes_label{"spokes", "spokes_" + where},
      hub_label{"hub", "hub_" + where};
  shape.add_pair(both("tyre_"), tyre_label, tyre_label, tyre(axle, radius, tyre_radius));
  if (n == 0) { // a small solid wheel
    shape.add_pair(both("disc_"), hub_label, hub_label, solid_wheel(axle, radius, .05));
    return;
  }
  shape.add_pair(both("spokes_"), spokes_label, spokes_label, spokes(axle, .02, radius - .4 * tyre_radius, .02, n));
  shape.add_pair(both("hub_"), hub_label, hub_label, along_x(hub_profile(.045, .022, .02), axle));
}

void add_handlebar(Assembly& bike, const std::string& suffix, const Point& head_high, const Point& steer, Bars kind,
                   double reach)
{
  const Point clamp = head_high + .11 * steer + Point(0, 0, reach);
  bike.add("stem" + suffix, {"handlebar", "stem"},
           std::abs(reach) < .05
               ? beam(head_high - .03 * steer, clamp, round_section(.012))
               : tube(bent({head_high - .03 * steer, head_high + .1 * steer, clamp}, .035), round_section(.012)));
  const auto at = [&](double x, double y, double z) { return Point(clamp + Point(x, y, z)); };
  const Path half =
      kind == Bars::flat ? spline({at(0, 0, 0), at(.1, .004, 0), at(.2, .012, -.02), at(.29, .015, -.05)})
      : kind == Bars::drop
          ? spline(
                {at(0, 0, 0), at(.12, 0, 0), at(.19, 0, .03), at(.2, -.02, .1), at(.205, -.08, .1), at(.21, -.11, .03)})
          : spline({at(0, 0, 0), at(.07, .01, 0), at(.17, .04, -.03), at(.25, .05, -.1), at(.28, .045, -.2)});
  bike.add("handlebar" + suffix, {"handlebar", "handlebar"}, tube(with_mirror_image(half), round_section(.011)));
  bike.add_pair({"grip_l" + suffix, "grip_r" + suffix}, {"handlebar", "grip"},
                tube(Path(half.end() - 4, half.end()), round_section(.016)));
}

void add_saddle(Assembly& bike, const std::string& suffix, const Point& cluster, const Point& top)
{
  bike.add("saddle" + suffix, {"saddle", "saddle"}, translated(saddle(.27, .16), top));
  bike.add("seat_post" + suffix, {"saddle", "seat_post"},
           beam(cluster - .03 * (top - cluster).normalized(), top - Point(0, .02, 0), round_section(.0125)));
}

void add_fork(Assembly& bike, const Point& crown, const Point& axle, double rake)
{
  bike.add("fork_crown", {"fork", "fork_crown"},
           beam(crown - Point(.05, 0, 0), crown + Point(.05, 0, 0), round_section(.016)));
  const Point top = crown + Point(.042, 0, 0), end = axle + Point(.052, 0, 0);
  bike.add_pair({"fork_blade_l", "fork_blade_r"}, {"fork", "fork_blade"},
                tube(spline({top, between(top, end, .5) - Point(0, 0, rake), end}), round_section(.013, .008)));
}

void add_chain(Assembly& bike, const Point& front, const Point& rear)
{
  const Point aside(-.048, 0, 0);
  bike.add("chainring", {"drivetrain", "chainring"},
           transformed(disc(disc_profile(.088, -.002, .002, .001), .088, 0),
                       stand_on(front + aside, front + aside + Point::UnitX())));
  bike.add("chain", {"drivetrain", "chain"},
           tube(chain_path(front + aside, .09, rear + aside, .04), bar(.005, .008), Point::UnitX(), true));
}

void add_front_frame(Assembly& bike, const Frame_joints& at, bool step_through)
{
  bike.add("head_tube", {"frame", "head_tube"}, beam(at.head_low, at.head_high, round_section(.02)));
  const Point low = between(at.bracket, at.cluster, .25);
  bike.add("top_tube", {"frame", "top_tube"},
           step_through
               ? tube(spline({between(at.head_low, at.head_high, .7), between(at.head_low, low, .5) + Point(0, -.03, 0),
                              low}),
                      round_section(.014))
               : beam(between(at.head_low, at.head_high, .75), at.cluster - Point(0, .02, 0), round_section(.014)));
  bike.add("down_tube", {"frame", "down_tube"},
           beam(between(at.head_low, at.head_high, .2), at.bracket, round_section(.017)));
  bike.add("seat_tube", {"frame", "seat_tube"}, beam(at.bracket, at.cluster, round_section(.016)));
  const Point shell(.036, 0, 0);
  bike.add("bottom_bracket", {"frame", "bottom_bracket"},
           beam(at.bracket - shell, at.bracket + shell, round_section(.023, 12), 3));
}

void add_stays(Assembly& bike, const Frame_joints& at)
{
  const Point end = at.rear_axle + Point(.06, 0, 0);
  bike.add_pair({"seat_stay_l", "seat_stay_r"}, {"frame", "seat_stay"},
                tube(bent({at.cluster + Point(.012, -.03, 0), at.cluster + Point(.035, -.09, -.05), end}, .03),
                     round_section(.008, 8)));
  bike.add_pair({"chain_stay_l", "chain_stay_r"}, {"frame", "chain_stay"},
                tube(bent({at.bracket + Point(.022, 0, -.015), at.bracket + Point(.035, .006, -.07), end}, .03),
                     round_section(.008, 8)));
}

void add_pedals(Assembly& bike, const std::string& suffix, const Point& axle)
{
  add_cranks(bike, {"crank_l" + suffix, "crank_r" + suffix}, {"pedal_l" + suffix, "pedal_r" + suffix}, axle, .03,
             {.06, 0, 0}, {.062, 0, .165});
}

void add_mudguard(Assembly& bike, const std::string& where, const Point& axle, double radius, double from, double to,
                  double width)
{
  bike.add("mudguard_" + where, {"mudguard", "mudguard_" + where},
           slab(
               [=](double u, double v) {
                 const double a = from + u * (to - from);
                 return Point(axle +
                              Point((v - .5) * width, (radius + .035) * std::sin(a), (radius + .035) * std::cos(a)));
               },
               .006, {10, 3, 0, .2}));
}

Assembly bicycle(const char* name, const Bicycle_design& design, std::uint64_t seed)
{
  Random random(seed);
  const Frame_joints at(random, design.wheel);
  Assembly bike(name, "velocipede");
  add_front_frame(bike, at, design.step_through);
  add_stays(bike, at);
  add_fork(bike, at.head_low - .018 * at.steer, at.front_axle, .02);
  add_handlebar(bike, "", at.head_high, at.steer, design.bars, design.bars == Bars::swept ? .02 : .09);
  add_saddle(bike, "", at.cluster, at.saddle);
  add_wheel(bike, "front", "front", at.front_axle, at.radius, design.tyre, 20);
  add_wheel(bike, "rear", "rear", at.rear_axle, at.radius, design.tyre, 20);
  add_chain(bike, at.bracket, at.rear_axle);
  add_pedals(bike, "", at.bracket);
  if (design.mudguards) {
    add_mudguard(bike, "front", at.front_axle, at.radius, .25 * pi, .95 * pi);
    add_mudguard(bike, "rear", at.rear_axle, at.radius, .3 * pi, 1.1 * pi);
  }
  const Point rack = at.rear_axle + Point(0, at.radius + .09, 0);
  if (design.rack) {
    bike.add("rack", {"rack", "rack"}, board(rack, .13, .36, .015, {4, 6, .04, .25}));
    bike.add_pair({"rack_strut_l", "rack_strut_r"}, {"rack", "rack_strut"},
                  beam(at.rear_axle + Point(.066, 0, 0), rack + Point(.055, 0, -.05), round_section(.006, 8)));
  }
  if (design.basket)
    bike.add("basket", {"basket", ""}, board(at.head_high + Point(0, .03, .135), .32, .24, .2, {5, 5, .05, .2}));
  return bike;
}

Assembly tandem(const char* name, bool step_through, std::uint64_t seed)
{
  Random random(seed);
  const double extra = .68;
  Frame_joints rear(random, .335, extra);
  Assembly bike(name, "velocipede");
  Frame_joints front = rear;
  const Point ahead(0, 0, extra);
  front.bracket += ahead;
  front.cluster += ahead;
  front.saddle += ahead;
  add_front_frame(bike, front, false);
  bike.add("rear_seat_tube", {"frame", "seat_tube"}, beam(rear.bracket, rear.cluster, round_section(.016)));
  bike.add("rear_top_tube", {"frame", "top_tube"},
           beam(front.cluster - Point(0, .02, 0),
                step_through ? between(rear.bracket, rear.cluster, .35) : Point(rear.cluster - Point(0, .02, 0)),
                round_section(.014)));
  const Point shell(.036, 0, 0);
  bike.add("rear_bottom_bracket", {"frame", "bottom_bracket"},
           beam(rear.bracket - shell, rear.bracket + shell, round_section(.023, 12), 3));
  bike.add("boom_tube", {"frame", "boom_tube"}, beam(front.bracket, rear.bracket, round_section(.018)));
  add_stays(bike, rear);
  add_fork(bike, front.head_low - .018 * front.steer, front.front_axle, .02);
  add_handlebar(bike, "_front", front.head_high, front.steer, Bars::flat, .08);
  const Point up = Point(0, 1, -.3).normalized();
  add_handlebar(bike, "_rear", front.cluster + .08 * up, up, Bars::swept, -.12);
  add_saddle(bike, "_front", front.cluster, front.saddle);
  add_saddle(bike, "_rear", rear.cluster, rear.saddle);
  add_wheel(bike, "front", "front", rear.front_axle, rear.radius, .018, 20);
  add_wheel(bike, "rear", "rear", rear.rear_axle, rear.radius, .018, 20);
  add_chain(bike, rear.bracket, rear.rear_axle);
  add_pedals(bike, "_front", front.bracket);
  add_pedals(bike, "_rear", rear.bracket);
  return bike;
}

Assembly penny_farthing(const char* name, std::uint64_t seed)
{
  Random random(seed);
  const double big = random.about(.62, .06), small = random.about(.2, .1);
  const Point front(0, big + .012, .22), rear(0, small + .012, -.55), head(0, 2 * big + .1, .16);
  Assembly bike(name, "velocipede");
  bike.add("head_tube", {"frame", "head_tube"},
           beam(head - Point(0, .06, -.005), head + Point(0, .05, -.005), round_section(.02)));
  Path knots{head};
  for (double a : {.62, .78, .92, 1.02})
    knots.push_back(front + (big + .07) * Point(0, std::sin(a * pi), std::cos(a * pi)));
  knots.push_back(rear + Point(0, small + .06, .02));
  bike.add("backbone", {"frame", "down_tube"}, tube(spline(knots), round_section(.018, .012)));
  bike.add("rear_fork_crown", {"frame", "rear_crown"},
           beam(rear + Point(-.05, small + .06, .02), rear + Point(.05, small + .06, .02), round_section(.011)));
  bike.add_pair({"rear_blade_l", "rear_blade_r"}, {"frame", "seat_stay"},
                beam(rear + Point(.047, small + .06, .02), rear + Point(.05, 0, 0), round_section(.009)));
  bike.add("fork_crown", {"fork", "fork_crown"},
           beam(head + Point(-.055, -.065, 0), head + Point(.055, -.065, 0), round_section(.014)));
  bike.add_pair({"fork_blade_l", "fork_blade_r"}, {"fork", "fork_blade"},
                beam(head + Point(.05, -.065, 0), front + Point(.055, 0, 0), round_section(.012, .009)));
  add_handlebar(bike, "", head + Point(0, .04, 0), Point::UnitY(), Bars::swept, -.03);
  bike.add("saddle", {"saddle", "saddle"}, translated(saddle(.26, .17), head + Point(0, .02, -.22)));
  bike.add("saddle_spring", {"saddle", "seat_post"},
           tube(spline({head + Point(0, -.02, -.03), head + Point(0, -.06, -.15), head + Point(0, .0, -.24)}),
                round_section(.009)));
  add_wheel(bike, "front", "front", front, big, .012, 28);
  add_wheel(bike, "rear", "rear", rear, small, .012, 14);
  add_cranks(bike, {"crank_l", "crank_r"}, {"pedal_l", "pedal_r"}, front, .055, {.085, 0, 0}, {.085, -.05, .12});
  return bike;
}

Assembly child_tricycle(const char* name, std::uint64_t seed)
{
  Random random(seed);
  const double wide = random.about(1.15, .1), tall = random.about(1.05, .1);
  const Assembly model = tricycle();
  Assembly result(name, "velocipede");
  result.groups = model.groups;
  for (Part part : model.parts) {
    part.solid =
        snapped(mapped(part.solid, [&](const Point& p) { return Point(wide * p.x(), tall * p.y(), tall * p.z()); }));
    result.parts.push_back(part);
  }
  for (Part_group& group : result.groups)
    group.point = group.point.cwiseProduct(Point(wide, tall, tall));
  return result;
}

Assembly adult_tricycle(const char* name, std::uint64_t seed)
{
  Random random(seed);
  const Frame_joints at(random, .26);
  Assembly trike(name, "velocipede");
  const double track = random.about(.31, .08);
  add_front_frame(trike, at, true);
  trike.add_pair({"seat_stay_l", "seat_stay_r"}, {"frame", "seat_stay"},
                 beam(at.cluster + Point(.01, -.03, 0), at.rear_axle + Point(.14, 0, 0), round_section(.009, 8)));
  trike.add_pair({"chain_stay_l", "chain_stay_r"}, {"frame", "chain_stay"},
                 beam(at.bracket + Point(.02, 0, 0), at.rear_axle + Point(.1, 0, 0), round_section(.009, 8)));
  trike.add("axle", {"frame", "rear_axle"},
            beam(at.rear_axle - Point(track, 0, 0), at.rear_axle + Point(track, 0, 0), round_section(.013), 8));
  add_fork(trike, at.head_low - .018 * at.steer, at.front_axle, .02);
  add_handlebar(trike, "", at.head_high, at.steer, Bars::swept, .02);
  add_saddle(trike, "", at.cluster, at.saddle);
  add_wheel(trike, "front", "front", at.front_axle, at.radius, .02, 16);
  add_wheel_pair(trike, "rear", "rear", at.rear_axle + Point(track, 0, 0), at.radius, .02, 16);
  add_chain(trike, at.bracket, at.rear_axle);
  add_pedals(trike, "", at.bracket);
  trike.add("basket", {"basket", ""},
            board(at.rear_axle + Point(0, at.radius + .13, .05), .44, .42, .22, {5, 5, .03, .2}));
  return trike;
}

Assembly cargo_tricycle(const char* name, std::uint64_t seed)
{
  Random random(seed);
  Frame_joints at(random, .28, .15);
  Assembly trike(name, "velocipede");
  const double track = .4;
  at.head_low = at.front_axle + Point(0, .12, -.4);
  at.head_high = at.head_low + .45 * at.steer;
  add_front_frame(trike, at, true);
  add_stays(trike, at);
  trike.add("front_axle", {"frame", "front_axle"},
            beam(at.front_axle - Point(track, 0, 0), at.front_axle + Point(track, 0, 0), round_section(.014), 8));
  trike.add("backbone", {"frame", "boom_tube"}, beam(at.head_low + .03 * at.steer, at.front_axle, round_section(.02)));
  trike.add("box", {"basket", ""}, board(at.front_axle + Point(0, .24, .02), .64, .66, .38, {6, 6, .01, .1}));
  add_handlebar(trike, "", at.head_high, at.steer, Bars::swept, .02);
  add_saddle(trike, "", at.cluster, at.saddle);
  add_wheel_pair(trike, "front", "front", at.front_axle + Point(track, 0, 0), at.radius, .02, 16);
  add_wheel(trike, "rear", "rear", at.rear_axle, at.radius, .02, 16);
  add_chain(trike, at.bracket, at.rear_axle);
  add_pedals(trike, "", at.bracket);
  return trike;
}

Assembly scooter(const char* name, bool two_in_front, std::uint64_t seed)
{
  Random random(seed);
  const double radius = random.about(.09, .15), length = random.about(.75, .08), high = random.about(.85, .08),
               z = .5 * length;
  const Point front(0, radius + .012, z), rear(0, radius + .012, -z), steer = Point(0, 1, -.2).normalized();
  const Point head_low = front + (radius + .07) * steer + Point(0, 0, -.02), head_high = head_low + .12 * steer;
  Assembly shape(name, "velocipede");
  shape.add("deck", {"deck", ""}, board({0, radius + .01, 0}, .13, length - 2 * radius - .14, .022, {7, 4, .04, .25}));
  shape.add("head_tube", {"frame", "head_tube"}, beam(head_low, head_high, round_section(.022)));
  shape.add("neck", {"frame", "down_tube"},
            tube(spline({between(head_low, head_high, .5),
                         head_low + Point(0, -.04, -.06),
                         {0, radius + .012, z - radius - .08}}),
                 round_section(.018)));
  shape.add("column", {"handlebar", "column"},
            beam(head_high - .04 * steer, front + high * steer, round_section(.016), 7));
  add_handlebar(shape, "", front + (high - .06) * steer, steer, Bars::flat, .0);
  if (two_in_front) {
    shape.add("front_axle", {"frame", "front_axle"},
              beam(front - Point(.11, 0, 0), front + Point(.11, 0, 0), round_section(.011)));
    shape.add("fork_tube", {"fork", "fork_crown"}, beam(front, head_low + .02 * steer, round_section(.016)));
    add_wheel_pair(shape, "front", "front", front + Point(.12, 0, 0), radius, .018, 0);
  } else {
    add_fork(shape, head_low - .012 * steer, front, .0);
    shape.add("tyre_front", {"wheel", "wheel_front"}, tyre(front, radius, .016, 24));
    shape.add("disc_front", {"hub", "hub_front"}, solid_wheel(front, radius, .055));
  }
  shape.add_pair({"rear_stay_l", "rear_stay_r"}, {"frame", "chain_stay"},
                 beam({.035, radius + .01, -z + radius + .1}, {.035, radius + .012, -z - .01}, bar(.012, .02)));
  shape.add("tyre_rear", {"wheel", "wheel_rear"}, tyre(rear, radius, .016, 24));
  shape.add("disc_rear", {"hub", "hub_rear"}, solid_wheel(rear, radius, .04));
  add_mudguard(shape, "rear", rear, radius, 0, .9 * pi, .076);
  return shape;
}

Assembly wheelchair(const char* name, Wheelchair kind, std::uint64_t seed)
{
  Random random(seed);
  const double width = random.about(.44, .06), seat_y = random.about(.5, .04), x = .5 * width, depth = .42, r = .013;
  const double big = kind == Wheelchair::transport ? .16 : .3, small = kind == Wheelchair::sport ? .06 : .09;
  const Point rear(x + .055, big + .014, -.2), front(x - .01, small + .01, kind == Wheelchair::sport ? .3 : .27);
  const double back_top = kind == Wheelchair::sport ? seat_y + .26 : seat_y + .45;
  Assembly shape(name, "velocipede");
  shape.add("seat", {"saddle", "seat"}, board({0, seat_y, 0}, width, depth, .035, {6, 6, .03, .3}));
  shape.add(
      "back", {"back", ""},
      slab(flat({-x, seat_y + .06, -.23}, {width, 0, 0}, {0, back_top - seat_y - .1, -.03}), .025, {6, 6, .04, .3}));
  shape.add_pair(
      {"back_post_l", "back_post_r"}, {"frame", "back_post"},
      kind == Wheelchair::sport
          ? tube(line({x, big * .9, -.2}, {x, back_top, -.25}, 6), round_section(r))
          : tube(bent({{x, .8 * big, -.2}, {x, back_top, -.25}, {x, back_top + .01, -.36}}, .04), round_section(r)));
  shape.add_pair({"seat_tube_l", "seat_tube_r"}, {"frame", "seat_tube"},
                 beam({x, seat_y - .02, -.22}, {x, seat_y - .02, .22}, round_section(r)));
  shape.add_pair({"front_tube_l", "front_tube_r"}, {"frame", "down_tube"},
                 tube(bent({{x, seat_y - .02, .2}, {x, seat_y - .02, .27}, {x, .14, .4}}, .04), round_section(r)));
  shape.add_pair({"low_tube_l", "low_tube_r"}, {"frame", "chain_stay"},
                 beam({x, big + .014, -.21}, {x, 2.2 * small + .02, front.z()}, round_section(r)));
  shape.add("axle", {"frame", "rear_axle"}, beam({-rear.x(), rear.y(), rear.z()}, rear, round_section(.014), 8));
  shape.add_pair({"cross_l", "cross_r"}, {"frame", "cross_brace"},
                 beam({.015, .5 * seat_y, .02}, {x, seat_y - .02, .02}, round_section(.011)));
  if (big > .25) {
    add_wheel_pair(shape, "rear", "rear", rear, big, .016, 18);
    const Label rim{"handrim", "handrim"};
    shape.add_pair({"handrim_l", "handrim_r"}, rim,
                   torus(rear + Point(.022, 0, 0), Point::UnitX(), .95 * big, round_section(.008, 8)));
  } else
    add_wheel_pair(shape, "rear", "rear", rear, big, .018, 0);
  shape.add_pair({"caster_fork_l", "caster_fork_r"}, {"fork", "fork_blade"},
                 beam({front.x() + .025, 2.2 * small + .03, front.z()}, {front.x() + .025, front.y(), front.z() - .01},
                      bar(.01, .026)));
  add_wheel_pair(shape, "front", "front", front - Point(.002, 0, 0), small, .014, 0);
  shape.add_pair({"footrest_l", "footrest_r"}, {"pedal", "pedal"},
                 board({.5 * x + .005, .13, .46}, x - .03, .14, .018, {4, 5, .06, .3}));
  if (kind != Wheelchair::sport) {
    shape.add_pair({"arm_pad_l", "arm_pad_r"}, {"armrest", "armrest"},
                   beam({x + .012, seat_y + .2, -.2}, {x + .012, seat_y + .2, .13}, bar(.05, .03)));
    shape.add_pair({"arm_post_l", "arm_post_r"}, {"armrest", "armrest_support"},
                   beam({x + .01, seat_y - .015, .08}, {x + .012, seat_y + .19, .08}, round_section(.011)));
  }
  if (kind != Wheelchair::sport)
    shape.add_pair({"push_grip_l", "push_grip_r"}, {"handlebar", "grip"},
                   beam({x, back_top + .01, -.31}, {x, back_top + .012, -.4}, round_section(.018)));
  return shape;
}

std::vector<Assembly> velocipedes(std::uint64_t seed)
{
  return {bicycle("velocipede_city", {Bars::swept, false, true, true}, seed),
          bicycle("velocipede_road", {Bars::drop, false, false, false, false, .34, .013}, seed + 1),
          bicycle("velocipede_step_through", {Bars::swept, true, true, true, true}, seed + 2),
          bicycle("velocipede_mountain", {Bars::flat, false, false, false, false, .34, .028}, seed + 3),
          penny_farthing("velocipede_penny_farthing", seed + 4),
          tandem("velocipede_tandem", false, seed + 5),
          tandem("velocipede_tandem_step_through", true, seed + 6),
          child_tricycle("velocipede_child_tricycle", seed + 7),
          adult_tricycle("velocipede_adult_tricycle", seed + 8),
          cargo_tricycle("velocipede_cargo_tricycle", seed + 9),
          scooter("velocipede_scooter", false, seed + 10),
          scooter("velocipede_scooter_three_wheels", true, seed + 11),
          wheelchair("velocipede_wheelchair", Wheelchair::standard, seed + 12),
          wheelchair("velocipede_wheelchair_sport", Wheelchair::sport, seed + 13),
          wheelchair("velocipede_wheelchair_transport", Wheelchair::transport, seed + 14)};
}

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
