// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "chair_designs.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

void add_four_chair_legs(Assembly& chair, const Chair_frame& f, const Chair_design& design, bool posts)
{
  const double x = f.width / 2 - .8 * f.wood, z = f.depth / 2 - .8 * f.wood, splay = .03, top = f.height - .01;
  const Point front_foot(x + splay, 0, z + splay), front_top(x, top, z), rear_foot(x, 0, -z - 1.5 * splay),
      rear_top(x, top, -z);
  const bool turned = design.base == Chair_base::turned;
  const Section section = bar({.75 * f.wood, .75 * f.wood}, {f.wood, f.wood});
  const auto leg = [&](const Point& foot, const Point& head) {
    return turned ? turned_leg(foot, head, .7 * f.wood) : beam(foot, head, section);
  };
  chair.add_pair({"leg_front_l", "leg_front_r"}, leg_label("front"), leg(front_foot, front_top));
  chair.add_pair({"leg_rear_l", "leg_rear_r"}, leg_label("back"),
                 posts ? tube(bent({rear_foot, {x, f.height, f.back_z(f.height)}, f.at_back(x, f.top())}, .1, 4),
                              bar(f.wood, f.wood))
                       : leg(rear_foot, rear_top));
  const auto on_front = [&](double t) { return between(front_foot, front_top, t); };
  const auto on_rear = [&](double t) { return between(rear_foot, rear_top, t); };
  const auto mirrored_end = [](const Point& p) { return Point(-p.x(), p.y(), p.z()); };
  if (design.stretchers) {
    const Section rod = round_section(.3 * f.wood);
    const Point rear = on_rear(.4), front = on_front(.4), middle = between(rear, front, .5);
    chair.add_pair({"stretcher_l", "stretcher_r"}, {"stretcher", "stretcher_mid"}, beam(rear, front, rod));
    if (turned)
      chair.add("stretcher_cross", {"stretcher", "stretcher_cross"}, beam(mirrored_end(middle), middle, rod));
    else {
      chair.add("stretcher_front", {"stretcher", "stretcher_front_center"},
                beam(mirrored_end(on_front(.55)), on_front(.55), rod));
      chair.add("stretcher_rear", {"stretcher", "stretcher_back_center"},
                beam(mirrored_end(on_rear(.55)), on_rear(.55), rod));
    }
  }
  if (!design.aprons) return;
  const double y = f.height - .045;
  chair.add("apron_front", {"seat_frame", "seat_frame_front_center"}, beam({-x, y, z}, {x, y, z}, bar(.055, .02)));
  chair.add("apron_rear", {"seat_frame", "seat_frame_back_center"}, beam({-x, y, -z}, {x, y, -z}, bar(.055, .02)));
  chair.add_pair({"apron_l", "apron_r"}, {"seat_frame", "seat_frame_mid"}, beam({x, y, -z}, {x, y, z}, bar(.02, .055)));
}

void add_sled_base(Assembly& chair, const Chair_frame& f)
{
  const double x = f.width / 2 - .02, z = f.depth / 2 - .03, r = .012, top = f.height - .012;
  chair.add_pair(
      {"runner_l", "runner_r"}, {"leg", "runner"},
      tube(bent({{x, top, z - .03}, {x, r, z + .02}, {x, r, -z - .03}, {x, top, -z + .03}}, .05, 4), round_section(r)));
  chair.add_front_and_back({"bar_front", "bar_rear"}, {"seat_frame", "seat_frame_front_center"},
                           {"seat_frame", "seat_frame_back_center"},
                           beam({-x, top, z - .03}, {x, top, z - .03}, round_section(r)));
}

void add_cantilever_base(Assembly& chair, const Chair_frame& f)
{
  const double x = f.width / 2 - .02, z = f.depth / 2 + .01, r = .013, top = f.height - .02;
  chair.add_pair({"cantilever_l", "cantilever_r"}, {"leg", "runner"},
                 tube(bent({{x, top, -z + .04}, {x, top, z}, {x, r, z}, {x, r, -z}}, .07, 4), round_section(r)));
  chair.add("floor_bar", {"stretcher", "stretcher_back_center"}, beam({-x, r, -z}, {x, r, -z}, round_section(r)));
}

void add_x_base(Assembly& chair, const Chair_frame& f)
{
  const double x = f.width / 2 - .03, z = f.depth / 2, top = f.height - .015, y = .5 * f.height;
  const Section section = bar(.02, .034);
  chair.add_pair({"x_leg_front_l", "x_leg_front_r"}, leg_label("front"), beam({x, 0, z}, {x, top, -z + .03}, section));
  chair.add_pair({"x_leg_rear_l", "x_leg_rear_r"}, leg_label("back"),
                 beam({x - .022, 0, -z}, {x - .022, top, z - .03}, section));
  chair.add("bolt", {"stretcher", "stretcher_cross"},
            beam({-x - .02, y, .015}, {x + .02, y, .015}, round_section(.009)));
  chair.add_front_and_back({"foot_front", "foot_rear"}, {"stretcher", "stretcher_front_center"},
                           {"stretcher", "stretcher_back_center"},
                           beam({-x, .04, z - .035}, {x, .04, z - .035}, round_section(.01)));
}

void add_column_base(Assembly& chair, const Chair_frame& f, Random& random, bool star)
{
  const double top = f.height - .02, r = random.about(.026);
  chair.add("mount", {"seat_frame", "seat_mount"}, board({0, top - .02, 0}, .2, .22, .05, {3, 3}));
  if (!star) {
    chair.add("column", {"leg", "pedestal_post"}, beam({0, .02, 0}, {0, top - .03, 0}, round_section(r, 12)));
    chair.add("plate", {"leg", "base"},
              disc({{0, 0}, {.1, 0}, {.21, 0}, {.22, .008}, {.15, .018}, {.05, .035}, {0, .035}}, .22, .012));
    return;
  }
  chair.add("column", {"leg", "pedestal_post"}, beam({0, .08, 0}, {0, top - .03, 0}, round_section(r, 12)));
  const int n = random.below(2) == 0 ? 5 : 4;
  const double reach = random.about(.3);
  chair.add_ring(
      numbered("star_", n), {"leg", ""},
      tube(bent({{0, .12, .6 * r}, {0, .085, reach - .02}, {0, .045, reach}}, .015, 4), bar({.05, .036}, {.026, .02})),
      Point::Zero(), Point::UnitY());
  const Profile wheel{{0, -.024}, {.022, -.024}, {.028, -.018}, {.028, .018}, {.022, .024}, {0, .024}};
  chair.add_ring(numbered("caster_", n), {"caster", ""},
                 transformed(post(wheel), stand_on({0, .028, reach}, {1, .028, reach})), Point::Zero(), Point::UnitY());
}

void add_chair_back(Assembly& chair, const Chair_frame& f, const Chair_design& design, bool posts_are_legs)
{
  const double x = f.back_x(), foot = f.height + .002;
  if (design.back == Chair_back::none) return;
  if (design.back == Chair_back::cushion) {
    const double bar_z = f.back_z(f.height) - .035;
    chair.add("back_bar", {"back", "back_support"},
              tube(bent({{0, f.height - .03, -.05},
                         {0, f.height - .03, bar_z},
                         {0, f.height + .6 * f.back_height, bar_z - .6 * f.lean * f.back_height}},
                        .06),
                   bar(.07, .014)));
    chair.add("back_cushion", {"back", ""},
              curved_rest(f.at_back(0, f.height + .14), f.up_back(f.back_height - .14), f.width - .02, .04, .05,
                          {7, 8, .14, .35}));
    return;
  }
  if (design.back == Chair_back::spindle) {
    const double half = x - .01, top = f.back_height;
    const auto at = [&](double side, double rise) { return f.at_back(side * half, f.height + rise * top); };
    const Path right = spline({at(0, 1), at(.45, .97), at(.85, .82), at(1, .55), at(.95, .25), at(.85, .005)});
    chair.add("bow", {"back", "back_frame"}, tube(with_mirror_image(right), round_section(.013), Point::UnitZ()));
    const auto on_bow = [&](double px) {
      std::size_t i = 1;
      while (right[i].x() < px)
        ++i;
      return between(right[i - 1], right[i], (px - right[i - 1].x()) / (right[i].x() - right[i - 1].x()));
    };
    const double step = 1.5 * half / (design.bars + 1);
    for (int i = 0; i < design.bars / 2; ++i) {
      const double px = (i + (design.bars % 2 == 0 ? .5 : 1)) * step;
      const std::string stem = "spindle_" + std::to_string(i + 1);
      chair.add_pair({stem + "_l", stem + "_r"}, {"back", ""},
                     beam(f.at_back(.85 * px, foot), on_bow(px), round_section(.008, .006, 8)));
    }
    if (design.bars % 2 == 1)
      chair.add("spindle_mid", {"back", ""}, beam(f.at_back(0, foot), on_bow(0), round_section(.008, .006, 8)));
    return;
  }
  if (!posts_are_legs)
    chair.add_pair({"post_l", "post_r"}, {"back", "back_post"},
                   tube(line(f.at_back(x, foot - .01), f.at_back(x, f.top()), 6), bar(.8 * f.wood, .8 * f.wood)));
  const double clear = .3 * f.back_height;
  if (design.back == Chair_back::solid) {
    chair.add("panel", {"back", ""},
              curved_rest(f.at_back(0, f.height + clear), f.up_back(f.back_height - clear - .01), 2 * x + .2 * f.wood,
                          .035, .016, {7, 9, .05, .3}));
    return;
  }
  const double rail = .06;
  chair.add(
      "top_rail", {"back", "back_top_rail"},
      curved_rest(f.at_back(0, f.top() - rail), f.up_back(rail), 2 * x + .3 * f.wood, .02, .018, {4, 9, .06, .3}));
  if (design.back == Chair_back::ladder) {
    const double step = (f.back_height - clear - rail) / design.bars;
    chair.add_row(numbered("slat_", design.bars), {"back", ""},
                  curved_rest(f.at_back(0, f.height + clear), f.up_back(.5 * step), 2 * x + .2 * f.wood, .02, .012,
                              {3, 9, .04, .3}),
                  f.up_back(step));
    return;
  }
  const double low = f.height + .12;
  chair.add("low_rail", {"back", "back_lower_rail"}, beam(f.at_back(-x, low), f.at_back(x, low), bar(.036, .018)));
  const double step = 2 * x / (design.bars + 1);
  const Point first(-x + step, low, f.back_z(low)),
      last = f.at_back(-x + step, f.top() - .5 * rail) - Point(0, 0, .008);
  chair.add_row(numbered("slat_", design.bars), {"back", ""}, beam(first, last, bar(.45 * step, .01)), {step, 0, 0});
}

void add_chair_arms(Assembly& chair, const Chair_frame& f, const Chair_design& design)
{
  if (design.arms == Chair_arms::none) return;
  const double x = f.width / 2 + .005, y = f.height + .21, front = .35 * f.depth;
  const bool to_back = design.arms != Chair_arms::to_seat;
  const Point rear = to_back ? f.at_back(f.back_x(), y) : Point(x, y, -.3 * f.depth);
  chair.add_pair({"arm_l", "arm_r"}, {"armrest", "armrest"},
                 tube(spline({rear, {x + .01, y + .004, 0}, {x + .015, y, front + .03}}),
                      bar({.04, .024}, {.055, .024}), Point::UnitX()));
  if (design.arms == Chair_arms::to_back) return;
  const auto support = [&](double z) {
    return beam({x - .03, f.height - .005, z}, {x + .01, y, z}, round_section(.013, .011));
  };
  chair.add_pair({"arm_support_l", "arm_support_r"}, {"armrest", "armrest_support"}, support(front - .02));
  if (!to_back)
    chair.add_pair({"arm_support_rear_l", "arm_support_rear_r"}, {"armrest", "armrest_support"},
                   support(-.24 * f.depth));
}

Assembly chair(const Chair_design& design, std::uint64_t seed)
{
  Random random(seed);
  Chair_frame f(random);
  if (design.base == Chair_base::column) f.height *= 1.45;
  const bool legs = design.base == Chair_base::plain || design.base == Chair_base::turned;
  const bool framed =
      design.back != Chair_back::none && design.back != Chair_back::cushion && design.back != Chair_back::spindle;
  const bool posts_are_legs = framed && design.base == Chair_base::plain;
  Assembly result(design.name, "chair");
  if (design.base == Chair_base::swivel)
    result.add("seat", {"seat", ""},
               dished_seat(f.width + .03, f.width, f.depth, f.height + .015, .07, .012, {7, 7, .12, .35}));
  else if (design.base == Chair_base::column)
    result.add("seat", {"seat", ""},
               disc(disc_profile(.5 * f.width, f.height - .015, f.height + .035, .015), .5 * f.width, f.height + .01));
  else
    result.add(
        "seat", {"seat", ""},
        dished_seat(f.width + .02, f.width - .02, f.depth, f.height, random.about(.032, .2), .01, {7, 7, .06, .3}));
  switch (design.base) {
  case Chair_base::sled:
    add_sled_base(result, f);
    break;
  case Chair_base::cantilever:
    add_cantilever_base(result, f);
    break;
  case Chair_base::x_frame:
    add_x_base(result, f);
    break;
  case Chair_base::swivel:
  case Chair_base::column:
    add_column_base(result, f, random, design.base == Chair_base::swivel);
    break;
  default:
    add_four_chair_legs(result, f, design, posts_are_legs);
  }
  add_chair_back(result, f, design, legs && posts_are_legs);
  add_chair_arms(result, f, design);
  return result;
}

const std::vector<Chair_design>& chair_designs()
{
  using Base = Chair_base;
  using Back = Chair_back;
  using Arms = Chair_arms;
  static const std::vector<Chair_design> designs{
      {"chair_solid", Base::plain, Back::solid, Arms::none, 0, true, false},
      {"chair_ladder_arms", Base::plain, Back::ladder, Arms::to_both, 4, false, true},
      {"chair_windsor", Base::turned, Back::spindle, Arms::none, 7, false, true},
      {"chair_slats", Base::plain, Back::slatted, Arms::to_seat, 5, true, false},
      {"chair_windsor_arms", Base::turned, Back::spindle, Arms::to_both, 8, false, true},
      {"chair_office", Base::swivel, Back::cushion, Arms::to_seat},
      {"chair_office_slats", Base::swivel, Back::slatted, Arms::to_back, 6},
      {"chair_office_plain", Base::swivel, Back::cushion},
      {"chair_sled", Base::sled, Back::solid},
      {"chair_sled_arms", Base::sled, Back::slatted, Arms::to_both, 7},
      {"chair_cantilever", Base::cantilever, Back::solid},
      {"chair_cantilever_arms", Base::cantilever, Back::ladder, Arms::to_back, 2},
      {"chair_folding", Base::x_frame, Back::solid},
      {"chair_director", Base::x_frame, Back::ladder, Arms::to_both, 3},
      {"chair_bar_stool", Base::column, Back::none}};
  return designs;
}

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
