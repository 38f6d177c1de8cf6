// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "designs.h"

namespace CGAL::Shape_correspondence::generator {

void add_tricycle_frame(Assembly& trike, const Tricycle_joints& at)
{
  trike.add("steering_head", {"frame", "head_tube"}, beam(at.head_low, at.head_high, round_section(.02)));
  trike.add(
      "backbone", {"frame", "down_tube"},
      tube(spline({between(at.head_low, at.head_high, .5), {0, .4, .1}, {0, .32, -.05}, {0, .24, -.2}, at.rear_axle}),
           round_section(.018)));
  trike.add("axle_beam", {"frame", "rear_axle"}, beam({-.22, .115, -.3}, {.22, .115, -.3}, round_section(.012), 7));
  trike.add("step", {"step", ""}, board({0, .132, -.345}, .26, .13, .018, {4, 6, .1, .25}));
  trike.touch("backbone", {"steering_head", "axle_beam", "step"});
  trike.touch("step", {"axle_beam"});
}

void add_tricycle_steering(Assembly& trike, const Tricycle_joints& at)
{
  trike.add("yoke", {"fork", "fork_crown"}, board(at.head_low - Point(0, .006, -.002), .13, .05, .02, {3, 5, .1, .25}));
  trike.add_pair({"yoke_arm_l", "yoke_arm_r"}, {"fork", "fork_blade"},
                 beam(at.head_low + Point(.052, -.006, .002), at.front_axle + Point(.052, -.01, 0),
                      bar({.012, .028}, {.012, .022})));
  trike.add("bar_stem", {"handlebar", "stem"},
            beam(at.head_high - Point(0, .03, -.0099), at.head_high + Point(0, .09, -.0297), round_section(.012)));
  const Path half = spline({{0, .62, .162}, {.07, .625, .16}, {.14, .66, .145}, {.19, .665, .11}, {.225, .66, .06}});
  trike.add("bars", {"handlebar", "handlebar"}, tube(with_mirror_image(half), round_section(.01)));
  trike.add_pair({"knob_grip_l", "knob_grip_r"}, {"handlebar", "grip"},
                 tube(Path(half.end() - 5, half.end()), round_section(.016)));
  trike.touch("yoke", {"steering_head", "yoke_arm_l", "yoke_arm_r"});
  trike.touch("bar_stem", {"steering_head", "bars"});
  trike.touch("bars", {"knob_grip_l", "knob_grip_r"});
}

void add_tricycle_wheels(Assembly& trike, const Tricycle_joints& at)
{
  trike.add("big_tyre", {"wheel", "wheel_front"}, tyre(at.front_axle, .18, .02));
  trike.add("big_spokes", {"spokes", "spokes_front"}, spokes(at.front_axle, .02, .17, .02, 16));
  trike.add("big_hub", {"hub", "hub_front"}, along_x(hub_profile(.062, .026, .02), at.front_axle));
  const Point left = at.rear_axle + Point(.19, 0, 0);
  const Label tyre_label{"wheel", "wheel_rear"}, disc_label{"hub", "hub_rear"};
  trike.add_pair({"small_tyre_l", "small_tyre_r"}, tyre_label, tyre_label, tyre(left, .097, .018, 28));
  const Profile dish{{0, -.022},   {.02, -.022}, {.022, -.008}, {.06, -.005}, {.084, -.005},
                     {.084, .005}, {.06, .005},  {.022, .008},  {.02, .022},  {0, .022}};
  trike.add_pair({"wheel_disc_l", "wheel_disc_r"}, disc_label, disc_label,
                 transformed(disc(dish, .084, 0, 24), stand_on(left, left + Point::UnitX())));
  trike.touch("big_spokes", {"big_tyre", "big_hub"});
  trike.touch("big_hub", {"yoke_arm_l", "yoke_arm_r"});
  trike.touch("axle_beam", {"wheel_disc_l", "wheel_disc_r"});
  trike.touch_in_turn({"wheel_disc_l", "wheel_disc_r"}, {"small_tyre_l", "small_tyre_r"});
}

Assembly tricycle()
{
  Assembly trike("tricycle", "velocipede");
  const Tricycle_joints at;
  add_tricycle_frame(trike, at);
  add_tricycle_steering(trike, at);
  add_tricycle_wheels(trike, at);
  const Names cranks{"lever_l", "lever_r"}, pedals{"foot_rest_l", "foot_rest_r"};
  add_cranks(trike, cranks, pedals, at.front_axle, .0595, {.085, 0, 0}, {.085, -.07, .07});
  trike.touch("big_hub", cranks);
  trike.add("perch", {"saddle", "saddle"}, translated(saddle(.24, .19), at.saddle));
  trike.add("perch_post", {"saddle", "seat_post"},
            beam(at.seat_joint - Point(0, .035, -.005), at.saddle - Point(0, .02, 0), round_section(.014)));
  trike.touch("perch_post", {"perch", "backbone"});
  return trike;
}

} // namespace CGAL::Shape_correspondence::generator
