// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "designs.h"

namespace CGAL::Shape_correspondence::generator {

Label leg_label(const std::string& row) { return {"leg", "leg_" + row}; }

Solid dished_seat(double front, double back, double depth, double y, double thickness, double dish,
                  const Slab_options& options)
{
  auto patch = [=](double u, double v) {
    const double x = 2 * v - 1, z = 2 * u - 1, width = back + u * (front - back);
    return Point(x * width / 2, y - dish * (1 - x * x) * (1 - z * z), z * depth / 2);
  };
  return slab(patch, thickness, options);
}

Solid curved_rest(const Point& low, const Point& rise, double width, double bulge, double thickness,
                  const Slab_options& options)
{
  auto patch = [=](double u, double v) {
    const double x = 2 * v - 1;
    return Point(low + u * rise + Point(x * width / 2, 0, -bulge * (1 - x * x)));
  };
  return slab(patch, thickness, options);
}

Assembly chair_four_legged()
{
  Assembly chair("chair_four_legged", "chair");
  chair.add("seat", {"seat", ""}, dished_seat(.47, .42, .45, .45, .03, .012, {7, 7, .05, .25}));
  chair.add_pair({"front_left_leg", "front_right_leg"}, leg_label("front"),
                 beam({.205, 0, .195}, {.2, .44, .19}, bar({.028, .028}, {.042, .042})));
  chair.add_pair({"rear_left_leg", "rear_right_leg"}, leg_label("back"),
                 beam({.185, 0, -.235}, {.18, .44, -.185}, bar({.028, .028}, {.042, .042})));
  chair.add("front_apron", {"seat_frame", "seat_frame_front_center"},
            beam({-.19, .405, .192}, {.19, .405, .192}, bar(.06, .02)));
  chair.add("rear_apron", {"seat_frame", "seat_frame_back_center"},
            beam({-.17, .405, -.182}, {.17, .405, -.182}, bar(.06, .02)));
  chair.add_pair({"left_apron", "right_apron"}, {"seat_frame", "seat_frame_mid"},
                 beam({.18, .405, -.175}, {.198, .405, .18}, bar(.02, .06)));
  const Point foot(.17, .44, -.195), top(.17, .92, -.29), rise = top - foot;
  chair.add_pair({"left_back_post", "right_back_post"}, {"back", "back_post"},
                 tube(line(foot, top, 7), round_section(.017, .013)));
  const Point low = foot + .38 * rise - Point(foot.x(), 0, 0);
  chair.add("back_panel", {"back", ""}, curved_rest(low, .58 * rise, .345, .04, .016, {7, 9, .06, .3}));
  chair.touch("seat", {"front_left_leg", "front_right_leg", "rear_left_leg", "rear_right_leg", "left_back_post",
                       "right_back_post"});
  chair.touch("front_apron", {"front_left_leg", "front_right_leg", "seat"});
  chair.touch("rear_apron", {"rear_left_leg", "rear_right_leg", "seat"});
  chair.touch("left_apron", {"front_left_leg", "rear_left_leg", "seat"});
  chair.touch("right_apron", {"front_right_leg", "rear_right_leg", "seat"});
  chair.touch("left_back_post", {"rear_left_leg"});
  chair.touch("right_back_post", {"rear_right_leg"});
  chair.touch("back_panel", {"left_back_post", "right_back_post"});
  return chair;
}

Assembly chair_swivel()
{
  Assembly chair("chair_swivel", "chair");
  chair.add("cushion_seat", {"seat", ""}, dished_seat(.49, .44, .47, .505, .07, .012, {7, 7, .12, .35}));
  chair.add("cushion_back", {"back", ""},
            curved_rest({0, .62, -.215}, {0, .42, -.07}, .44, .05, .055, {7, 8, .14, .35}));
  chair.add("back_bar", {"back", "back_support"},
            tube(bent({{0, .452, -.05}, {0, .452, -.29}, {0, .82, -.315}}, .07), bar(.07, .014)));
  chair.add("mount", {"seat_frame", "seat_mount"}, board({0, .445, 0}, .2, .24, .05, {3, 3}));
  chair.add("column", {"leg", "pedestal_post"},
            post({{0, .075},
                  {.04, .075},
                  {.048, .085},
                  {.048, .135},
                  {.04, .145},
                  {.026, .15},
                  {.026, .22},
                  {.026, .29},
                  {.016, .295},
                  {.016, .36},
                  {.016, .43},
                  {0, .43}}));
  const Names legs = numbered("star_", 5), casters = numbered("caster_", 5);
  chair.add_ring(legs, {"leg", ""},
                 tube(bent({{0, .12, .04}, {0, .083, .3}, {0, .04, .315}}, .02, 4), bar({.05, .036}, {.026, .02})),
                 Point::Zero(), Point::UnitY());
  const Solid wheels = post({{0, -.026},
                             {.02, -.026},
                             {.028, -.021},
                             {.028, -.008},
                             {.02, -.005},
                             {.02, .005},
                             {.028, .008},
                             {.028, .021},
                             {.02, .026},
                             {0, .026}});
  chair.add_ring(casters, {"caster", ""}, transformed(wheels, stand_on({0, .028, .315}, {1, .028, .315})),
                 Point::Zero(), Point::UnitY());
  chair.add_pair(
      {"arm_bracket_l", "arm_bracket_r"}, {"armrest", "armrest_support"},
      tube(bent({{.14, .467, -.02}, {.285, .467, -.02}, {.285, .715, -.035}}, .04), bar(.05, .014), Point::UnitZ()));
  chair.add_pair({"arm_pad_l", "arm_pad_r"}, {"armrest", "armrest"},
                 beam({.28, .725, -.16}, {.28, .725, .11}, bar(.07, .028)));
  chair.touch("mount", {"cushion_seat", "column", "back_bar"});
  chair.touch("back_bar", {"cushion_back", "cushion_seat"});
  chair.touch("cushion_seat", {"arm_bracket_l", "arm_bracket_r"});
  chair.touch("column", legs);
  chair.touch_in_turn(legs, casters);
  chair.touch_in_turn({"arm_bracket_l", "arm_bracket_r"}, {"arm_pad_l", "arm_pad_r"});
  return chair;
}

Assembly chair_slatted()
{
  Assembly chair("chair_slatted", "chair");
  const double knee = .45, top = 1., lean = .2, knee_z = -.19, foot_z = -.24;
  auto post_z = [&](double y) { return y < knee ? foot_z + (knee_z - foot_z) * y / knee : knee_z - lean * (y - knee); };
  chair.add("rush_seat", {"seat", ""}, dished_seat(.46, .41, .43, .45, .032, .006, {6, 6, .05, .35}));
  chair.add_pair({"leg_fl", "leg_fr"}, leg_label("front"), beam({.205, 0, .19}, {.205, .47, .19}, round_section(.02)));
  chair.add_pair({"leg_bl", "leg_br"}, leg_label("back"),
                 tube(bent({{.19, 0, foot_z}, {.19, knee, knee_z}, {.19, top, post_z(top)}}, .1, 4), bar(.034, .034)));
  const Point up(0, 1, -lean);
  const Names slats = numbered("slat_", 4);
  chair.add_row(slats, {"back", ""}, curved_rest({0, .58, post_z(.58)}, .05 * up, .375, .028, .012, {3, 9, .04, .3}),
                .09 * up);
  chair.add("crest", {"back", "back_top_rail"},
            curved_rest({0, .945, post_z(.945)}, .085 * up, .41, .03, .018, {4, 9, .1, .3}));
  chair.add("rung_front", {"stretcher", "stretcher_front_center"},
            beam({-.2, .3, .19}, {.2, .3, .19}, round_section(.012)));
  chair.add("rung_back", {"stretcher", "stretcher_back_center"},
            beam({-.185, .24, post_z(.24)}, {.185, .24, post_z(.24)}, round_section(.012)));
  const Names upper{"rung_upper_l", "rung_upper_r"}, lower{"rung_lower_l", "rung_lower_r"};
  chair.add_pair(upper, {"stretcher", "stretcher_mid"},
                 beam({.19, .33, post_z(.33)}, {.205, .33, .185}, round_section(.012)));
  chair.add_pair(lower, {"stretcher", "stretcher_mid"},
                 beam({.19, .15, post_z(.15)}, {.205, .15, .185}, round_section(.012)));
  const Names arms{"arm_l", "arm_r"}, stumps{"arm_post_l", "arm_post_r"};
  chair.add_pair(arms, {"armrest", "armrest"},
                 tube(spline({{.19, .69, post_z(.69) + .005}, {.222, .695, -.06}, {.232, .69, .1}, {.22, .685, .23}}),
                      bar({.034, .024}, {.06, .024})));
  chair.add_pair(stumps, {"armrest", "armrest_support"},
                 beam({.205, .455, .19}, {.224, .69, .18}, round_section(.016, .012)));
  const Names left{"leg_fl", "leg_bl"}, right{"leg_fr", "leg_br"}, backs{"leg_bl", "leg_br"},
      fronts{"leg_fl", "leg_fr"};
  chair.touch("rush_seat", fronts);
  chair.touch("rush_seat", backs);
  for (const std::string& slat : slats)
    chair.touch(slat, backs);
  chair.touch("crest", backs);
  chair.touch("rung_front", fronts);
  chair.touch("rung_back", backs);
  for (const Names& rungs : {upper, lower}) {
    chair.touch(rungs[0], left);
    chair.touch(rungs[1], right);
  }
  chair.touch_in_turn(arms, backs);
  chair.touch_in_turn(arms, stumps);
  chair.touch_in_turn(stumps, fronts);
  chair.touch("rush_seat", stumps);
  return chair;
}

Solid turned_leg(double height, double radius)
{
  Profile profile{{0, 0},     {.5, 0}, {.55, .03}, {.62, .2}, {.9, .42}, {.62, .5},
                  {.95, .56}, {1, .7}, {.8, .85},  {.6, 1},   {0, 1}};
  for (Point_2& p : profile)
    p = {p.x() * radius, p.y() * height};
  return post(profile);
}

Solid turned_leg(const Point& foot, const Point& top, double radius)
{
  return transformed(turned_leg((top - foot).norm(), radius), stand_on(foot, top));
}

Assembly chair_spindle()
{
  Assembly chair("chair_spindle", "chair");
  chair.add("saddle_seat", {"seat", ""}, dished_seat(.45, .4, .42, .445, .042, .014, {8, 8, .14, .3}));
  const Point front_foot(.225, 0, .205), front_top(.14, .438, .13), back_foot(.2, 0, -.23), back_top(.12, .438, -.13);
  chair.add_pair({"turned_leg_a", "turned_leg_b"}, leg_label("front"), turned_leg(front_foot, front_top, .02));
  chair.add_pair({"turned_leg_c", "turned_leg_d"}, leg_label("back"), turned_leg(back_foot, back_top, .02));
  const Point from = between(back_foot, back_top, .38), to = between(front_foot, front_top, .38),
              middle = between(from, to, .5);
  const Names sides{"h_side_left", "h_side_right"};
  chair.add_pair(sides, {"stretcher", "stretcher_mid"}, beam(from, to, round_section(.011)));
  chair.add("h_cross", {"stretcher", "stretcher_cross"},
            beam({-middle.x(), middle.y(), middle.z()}, middle, round_section(.01)));
  const Path half = spline(
      {{0, .97, -.31}, {.1, .945, -.305}, {.175, .86, -.285}, {.2, .72, -.25}, {.19, .57, -.205}, {.17, .445, -.165}});
  chair.add("bow", {"back", "back_frame"}, tube(with_mirror_image(half), round_section(.012), Point::UnitZ()));
  auto on_bow = [&](double x) {
    std::size_t i = 1;
    while (half[i].x() < x)
      ++i;
    return between(half[i - 1], half[i], (x - half[i - 1].x()) / (half[i].x() - half[i - 1].x()));
  };
  auto spindle = [&](double x) { return beam({.8 * x, .45, -.175}, on_bow(x), round_section(.008, .006, 8)); };
  chair.add("spindle_mid", {"back", ""}, spindle(0));
  Names spindles{"spindle_mid"};
  for (int i = 1; i <= 3; ++i) {
    const std::string stem = "spindle_" + std::to_string(i);
    chair.add_pair({stem + "_l", stem + "_r"}, {"back", ""}, spindle(.048 * i));
    spindles.insert(spindles.end(), {stem + "_l", stem + "_r"});
  }
  chair.touch("saddle_seat", {"turned_leg_a", "turned_leg_b", "turned_leg_c", "turned_leg_d", "bow"});
  chair.touch("saddle_seat", spindles);
  chair.touch("bow", spindles);
  chair.touch("h_cross", sides);
  chair.touch(sides[0], {"turned_leg_a", "turned_leg_c"});
  chair.touch(sides[1], {"turned_leg_b", "turned_leg_d"});
  return chair;
}

Assembly stool()
{
  Assembly chair("stool", "chair");
  chair.add("round_board", {"seat", ""}, disc(disc_profile(.16, .62, .645, .006), .16, .6325));
  chair.add("pad", {"seat", "cushion"},
            disc({{0, .642}, {.08, .642}, {.145, .642}, {.155, .655}, {.15, .675}, {.13, .687}, {.07, .693}, {0, .694}},
                 .15, .668));
  const Names legs = numbered("splay_", 4);
  const Point foot(.165, 0, .165), top(.085, .63, .085);
  chair.add_four(legs, {"leg", ""}, {"leg", ""}, beam(foot, top, round_section(.012, .016)));
  const double height = .2, radius = between(foot, top, height / top.y()).x() * std::sqrt(2.);
  chair.add("foot_ring", {"stretcher", ""}, torus({0, height, 0}, Point::UnitY(), radius, round_section(.009, 8)));
  chair.touch("round_board", legs);
  chair.touch("round_board", {"pad"});
  chair.touch("foot_ring", legs);
  return chair;
}

} // namespace CGAL::Shape_correspondence::generator
