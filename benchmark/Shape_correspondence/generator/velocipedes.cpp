// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "designs.h"

namespace CGAL::Shape_correspondence::generator {

Solid tyre(const Point& middle, double radius, double thickness, int n)
{
  return torus(middle, Point::UnitX(), radius, round_section(thickness, 8), n);
}

Solid along_x(const Profile& profile, const Point& middle, int n)
{
  return transformed(post(profile, n), stand_on(middle, middle + Point::UnitX()));
}

Solid spokes(const Point& middle, double hub_radius, double radius, double half_width, int n)
{
  constexpr double wire = .0018, lacing = .35; // radius of a spoke; its angle at the hub from the radial direction
  Solid solid;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * pi * i / n, start = angle + (i % 2 == 0 ? lacing : -lacing);
    const Point from(i % 2 == 0 ? half_width : -half_width, hub_radius * std::sin(start), hub_radius * std::cos(start));
    append(solid.mesh,
           beam(middle + from, middle + radius * Point(0, std::sin(angle), std::cos(angle)), round_section(wire, 4), 1)
               .mesh);
  }
  solid.kind = Kind::sheet;
  solid.mid = sheet_grid([&](double u, double v) {
    const Point_2 p = radius * square_to_disc({2 * u - 1, 2 * v - 1});
    return Point(middle + Point(0, p.y(), p.x()));
  });
  return solid;
}

Solid saddle(double length, double width)
{
  auto patch = [=](double u, double v) {
    const double x = 2 * v - 1, wide = width * (.22 + .78 * std::pow(1 - u, 2) * (1 + .9 * u));
    return Point(x * wide / 2, -.25 * wide * x * x - .08 * length * std::sin(pi * u), (u - .5) * length);
  };
  return slab(patch, .14 * width, {9, 6, .15, .3});
}

Profile hub_profile(double half_length, double flange_radius, double flange)
{
  const double r = flange_radius, a = half_length, f = flange;
  return {{0, -a},        {.25 * r, -a},        {.25 * r, -f - .006}, {r, -f - .004},
          {r, -f + .004}, {.55 * r, -f + .008}, {.55 * r, f - .008},  {r, f - .004},
          {r, f + .004},  {.25 * r, f + .006},  {.25 * r, a},         {0, a}};
}

Path chain_path(const Point& front, double front_radius, const Point& rear, double rear_radius)
{
  const Point along = (front - rear).normalized(), up = Point::UnitX().cross(along).y() > 0
                                                            ? Point(Point::UnitX().cross(along))
                                                            : Point(-Point::UnitX().cross(along));
  const double lean = std::asin((front_radius - rear_radius) / (front - rear).norm());
  constexpr int arc_pieces = 8, run_pieces = 8;
  Path path;
  auto arc = [&](const Point& centre, double radius, double from, double to) {
    for (int i = 0; i <= arc_pieces; ++i) {
      const double angle = from + (to - from) * i / arc_pieces;
      path.push_back(centre + radius * (std::cos(angle) * along + std::sin(angle) * up));
    }
  };
  auto run = [&](const Point& to) {
    const Point from = path.back();
    for (int i = 1; i < run_pieces; ++i)
      path.push_back(between(from, to, double(i) / run_pieces));
  };
  arc(front, front_radius, -pi / 2 - lean, pi / 2 + lean);
  run(rear + rear_radius * (std::cos(pi / 2 + lean) * along + std::sin(pi / 2 + lean) * up));
  arc(rear, rear_radius, pi / 2 + lean, 3 * pi / 2 - lean);
  run(path.front());
  return path;
}

void add_cranks(Assembly& shape, const Names& cranks, const Names& pedals, const Point& axle, double start,
                const Point& elbow, const Point& end)
{
  const double pedal_width = .09;
  const std::vector<Label> crank_labels{{"pedal", "crank_left"}, {"pedal", "crank_right"}};
  const std::vector<Label> pedal_labels{{"pedal", "pedal_left"}, {"pedal", "pedal_right"}};
  const Path path = bent({axle + Point(start, 0, 0), axle + elbow, axle + end}, .02);
  shape.add_labelled_ring(cranks, crank_labels, tube(path, bar({.02, .02}, {.014, .014})), axle, Point::UnitY());
  shape.add_labelled_ring(pedals, pedal_labels,
                          board(axle + end + Point(pedal_width / 2, 0, 0), pedal_width, .07, .022, {3, 3, .08, .3}),
                          axle, Point::UnitY());
  shape.touch_in_turn(cranks, pedals);
}

void add_bicycle_frame(Assembly& bike, const Bicycle_joints& at)
{
  bike.add("head_tube", {"frame", "head_tube"}, beam(at.head_low, at.head_high, round_section(.02)));
  bike.add("top_tube", {"frame", "top_tube"},
           beam(between(at.head_low, at.head_high, .7), at.seat_cluster, round_section(.014)));
  bike.add("down_tube", {"frame", "down_tube"},
           beam(between(at.head_low, at.head_high, .2), at.bottom_bracket, round_section(.017)));
  bike.add("seat_tube", {"frame", "seat_tube"},
           beam(at.bottom_bracket, at.seat_cluster + .06 * (at.seat_cluster - at.bottom_bracket), round_section(.016)));
  const Point shell(.036, 0, 0);
  bike.add("bottom_bracket", {"frame", "bottom_bracket"},
           beam(at.bottom_bracket - shell, at.bottom_bracket + shell, round_section(.023, 12), 3));
  bike.add_pair({"seat_stay_l", "seat_stay_r"}, {"frame", "seat_stay"},
                tube(bent({at.seat_cluster + Point(.012, -.03, 0), at.seat_cluster + Point(.032, -.08, -.055),
                           at.rear_axle + Point(.062, 0, 0)},
                          .03),
                     round_section(.008, 8)));
  bike.add_pair({"chain_stay_l", "chain_stay_r"}, {"frame", "chain_stay"},
                tube(bent({at.bottom_bracket + Point(.022, .002, -.015), at.bottom_bracket + Point(.03, .008, -.06),
                           at.rear_axle + Point(.062, 0, 0)},
                          .03),
                     round_section(.0075, 8)));
  bike.touch("head_tube", {"top_tube", "down_tube"});
  bike.touch("seat_tube", {"top_tube", "bottom_bracket", "down_tube", "seat_stay_l", "seat_stay_r"});
  bike.touch("bottom_bracket", {"down_tube", "chain_stay_l", "chain_stay_r"});

  bike.touch("seat_stay_l", {"chain_stay_l"});
  bike.touch("seat_stay_r", {"chain_stay_r"});
}

void add_bicycle_steering(Assembly& bike, const Bicycle_joints& at)
{
  bike.add("fork_crown", {"fork", "fork_crown"},
           beam(at.crown - Point(.05, 0, 0), at.crown + Point(.05, 0, 0), round_section(.016)));
  bike.add_pair(
      {"fork_blade_l", "fork_blade_r"}, {"fork", "fork_blade"},
      tube(
          spline({at.crown + Point(.04, 0, 0), {.043, .58, .399}, {.046, .45, .447}, at.front_axle + Point(.05, 0, 0)}),
          round_section(.013, .008)));
  bike.add(
      "stem", {"handlebar", "stem"},
      tube(bent({at.head_high - Point(0, .02, -.007), {0, .965, .273}, {0, .985, .355}}, .025), round_section(.012)));
  const Path half = spline({{0, .985, .36}, {.07, .988, .36}, {.16, 1.015, .345}, {.235, 1.03, .30}, {.29, 1.03, .22}});
  bike.add("handlebar", {"handlebar", "handlebar"}, tube(with_mirror_image(half), round_section(.011)));
  bike.add_pair({"grip_l", "grip_r"}, {"handlebar", "grip"},
                tube(Path(half.end() - 5, half.end()), round_section(.016)));
  bike.touch("fork_crown", {"head_tube", "fork_blade_l", "fork_blade_r"});
  bike.touch("stem", {"head_tube", "handlebar"});
  bike.touch("handlebar", {"grip_l", "grip_r"});
}

void add_bicycle_wheels(Assembly& bike, const Bicycle_joints& at)
{
  const double radius = .335, plane = .048;
  bike.add("front_tyre", {"wheel", "wheel_front"}, tyre(at.front_axle, radius, .018));
  bike.add("rear_tyre", {"wheel", "wheel_rear"}, tyre(at.rear_axle, radius, .018));
  bike.add("front_spokes", {"spokes", "spokes_front"}, spokes(at.front_axle, .018, radius - .01, .028, 20));
  bike.add("rear_spokes", {"spokes", "spokes_rear"}, spokes(at.rear_axle, .021, radius - .01, .028, 20));
  const Point wheelbase = at.front_axle - at.rear_axle;
  bike.state_row({"rear_tyre", "front_tyre"}, wheelbase);
  bike.state_row({"rear_spokes", "front_spokes"}, wheelbase);
  bike.add("front_hub", {"hub", "hub_front"}, along_x(hub_profile(.06, .022, .028), at.front_axle));
  const Profile with_sprocket{{0, -.07},      {.007, -.07},  {.007, -.052}, {.038, -.0495},
                              {.038, -.0465}, {.014, -.043}, {.014, -.034}, {.026, -.032},
                              {.026, -.024},  {.014, -.02},  {.014, .02},   {.026, .024},
                              {.026, .032},   {.007, .036},  {.007, .07},   {0, .07}};
  bike.add("rear_hub", {"hub", "hub_rear"}, along_x(with_sprocket, at.rear_axle, 16));
  const Point aside(-plane, 0, 0);
  bike.add("chainring", {"drivetrain", "chainring"},
           transformed(disc(disc_profile(.088, -.002, .002, .001), .088, 0),
                       stand_on(at.bottom_bracket + aside, at.bottom_bracket + aside + Point::UnitX())));
  bike.add("chain", {"drivetrain", "chain"},
           tube(chain_path(at.bottom_bracket + aside, .09, at.rear_axle + aside, .04), bar(.005, .008), Point::UnitX(),
                true));
  bike.touch("front_spokes", {"front_tyre", "front_hub"});
  bike.touch("rear_spokes", {"rear_tyre", "rear_hub"});
  bike.touch("front_hub", {"fork_blade_l", "fork_blade_r"});
  bike.touch("rear_hub", {"chain_stay_l", "chain_stay_r", "seat_stay_l", "seat_stay_r", "chain"});
  bike.touch("chain", {"chainring", "seat_stay_r"});
}

Assembly bicycle()
{
  Assembly bike("bicycle", "velocipede");
  const Bicycle_joints at;
  add_bicycle_frame(bike, at);
  add_bicycle_steering(bike, at);
  add_bicycle_wheels(bike, at);
  bike.add("saddle", {"saddle", "saddle"}, translated(saddle(.27, .16), at.saddle));
  bike.add("seat_post", {"saddle", "seat_post"},
           beam(between(at.seat_cluster, at.saddle, .1), at.saddle - Point(0, .02, 0), round_section(.0125)));
  const Names cranks{"crank_l", "crank_r"}, pedals{"pedal_l", "pedal_r"};
  add_cranks(bike, cranks, pedals, at.bottom_bracket, .033, Point(.062, 0, 0), Point(.062, 0, .165));
  bike.touch("seat_post", {"seat_tube", "saddle"});
  bike.touch("bottom_bracket", cranks);
  bike.touch("crank_r", {"chainring"});
  return bike;
}

} // namespace CGAL::Shape_correspondence::generator
