// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "designs.h"

namespace CGAL::Shape_correspondence::generator {

Assembly bed_slatted()
{
  Assembly bed("bed_slatted", "bed");
  const double x = .47, head = -1.02, foot = 1.02;
  const Names head_posts{"head_post_l", "head_post_r"}, foot_posts{"foot_post_l", "foot_post_r"},
      rails{"side_rail_l", "side_rail_r"};
  bed.add_pair(head_posts, leg_label("back"), beam({x, 0, head}, {x, .95, head}, bar(.06, .06)));
  bed.add_pair(foot_posts, leg_label("front"), beam({x, 0, foot}, {x, .6, foot}, bar(.06, .06)));
  bed.add_pair(rails, {"side_rail", "side_rail"}, beam({x, .3, head}, {x, .3, foot}, bar(.026, .14), 8));
  const Point half(x, 0, 0), at_head(0, 0, head), at_foot(0, 0, foot);
  auto crosswise = [&](const Point& at, double height, double size) {
    return beam(at - half + Point(0, height, 0), at + half + Point(0, height, 0), bar(size, .03));
  };
  bed.add("head_top", {"headboard", "headboard_rail"}, crosswise(at_head, .88, .09));
  bed.add("head_low", {"headboard", "headboard_mid_rail"}, crosswise(at_head, .44, .08));
  bed.state_row({"head_low", "head_top"}, {0, .44, 0});
  const Names bars = numbered("head_bar_", 5);
  bed.add_row(bars, {"headboard", ""}, beam({-.3, .45, head}, {-.3, .87, head}, round_section(.012)), {.15, 0, 0});
  bed.add("foot_top", {"footboard", "footboard_rail"}, crosswise(at_foot, .54, .09));
  bed.add("foot_panel", {"footboard", "footboard_panel"},
          slab(flat({-.46, .25, foot}, {.92, 0, 0}, {0, .26, 0}), .018, {6, 3, 0, .2}));
  const Names slats = numbered("lath_", 9);
  bed.add_row(slats, {"base", ""}, beam({-.46, .33, -.88}, {.46, .33, -.88}, bar(.018, .09)), {0, 0, .22});
  bed.add("mattress", {"mattress", ""}, board({0, .424, 0}, .9, 1.96, .18, {8, 6, .03, .25}));
  bed.add_pair({"pillow_l", "pillow_r"}, {"pillow", "pillow"}, board({.225, .56, -.78}, .4, .32, .11, {5, 5, .12, .4}));
  bed.touch_in_turn(rails, head_posts);
  bed.touch_in_turn(rails, foot_posts);
  bed.touch("head_top", head_posts);
  bed.touch("head_low", head_posts);
  bed.touch("head_top", bars);
  bed.touch("head_low", bars);
  bed.touch("foot_top", foot_posts);
  bed.touch("foot_panel", foot_posts);
  bed.touch("foot_panel", {"foot_top", "side_rail_l", "side_rail_r"});
  for (const std::string& slat : slats)
    bed.touch(slat, rails);
  bed.touch("mattress", slats);
  bed.touch("mattress", {"pillow_l", "pillow_r"});
  return bed;
}

Assembly lamp_desk()
{
  Assembly lamp("lamp_desk", "lamp");
  const Point root(0, .07, -.06), elbow(0, .36, -.2), wrist(0, .52, .08), outer(.019, 0, 0), inner(.0075, 0, 0);
  lamp.add("foot", {"base", ""},
           translated(disc({{0, 0}, {.09, 0}, {.1, .006}, {.1, .016}, {.085, .026}, {.03, .03}, {0, .03}}, .1, .014),
                      {0, 0, -.06}));
  lamp.add("turret", {"body", ""},
           translated(post({{0, .025}, {.016, .025}, {.014, .05}, {.02, .055}, {.02, .085}, {0, .085}}), {0, 0, -.06}));
  auto joint = [](const Point& at) {
    const Solid barrel = post({{0, -.026}, {.016, -.026}, {.019, -.022}, {.019, .022}, {.016, .026}, {0, .026}});
    return transformed(barrel, stand_on(at, at + Point::UnitX()));
  };
  const Names lower{"lower_rod_l", "lower_rod_r"}, upper{"upper_rod_l", "upper_rod_r"};
  lamp.add_pair(lower, {"arm", ""}, beam(root + outer, elbow + outer, round_section(.005, 8)));
  lamp.add("elbow", {"body", ""}, joint(elbow));
  lamp.add_pair(upper, {"arm", ""}, beam(elbow + inner, wrist + inner, round_section(.005, 8)));
  lamp.add("wrist", {"body", ""}, joint(wrist));
  const Point down = Point(0, -.86, .5).normalized();
  const Profile bell{{0, .02},    {.022, .02},  {.03, .035},  {.042, .08}, {.075, .15}, {.085, .17},
                     {.082, .17}, {.071, .148}, {.038, .081}, {.026, .04}, {0, .036}};
  const Eigen::Isometry3d hang = stand_on(wrist, wrist + down);
  lamp.add("bell", {"shade", ""}, transformed(post(bell, 24), hang));
  lamp.add("neck", {"body", "neck"},
           transformed(post({{0, .012}, {.01, .012}, {.01, .017}, {.014, .022}, {0, .022}}), hang));
  lamp.add(
      "bulb", {"bulb", ""},
      transformed(
          post({{0, .03}, {.012, .03}, {.013, .055}, {.024, .08}, {.029, .1}, {.024, .12}, {.012, .13}, {0, .132}}),
          hang));
  lamp.touch("turret", {"foot"});
  lamp.touch("turret", lower);
  lamp.touch("elbow", lower);
  lamp.touch("elbow", upper);
  lamp.touch("wrist", upper);
  lamp.touch("neck", {"wrist", "bell"});
  lamp.touch("bulb", {"bell"});
  return lamp;
}

} // namespace CGAL::Shape_correspondence::generator
