// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "table_designs.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

void add_table_top(Assembly& table, const Table_frame& f, const Table_design& design)
{
  const double y = f.height - .015, thickness = .03;
  const double overhang = design.base == Table_base::pedestal || design.base == Table_base::plate ? 0 : .06;
  const double width = f.width + overhang, depth = f.depth + overhang;
  switch (design.top) {
  case Table_top::disc:
    table.add("top", {"tabletop", ""},
              disc(disc_profile(.5 * width, y - .5 * thickness, y + .5 * thickness, .006), .5 * width, y));
    return;
  case Table_top::framed_glass: {
    table.add("glass", {"tabletop", "glass_pane"}, board({0, y, 0}, width - .08, depth - .08, .012, {5, 6, 0, .2}));
    const Point x_side(.5 * width - .03, y, 0), z_side(0, y, .5 * depth - .03);
    table.add_pair({"frame_l", "frame_r"}, {"tabletop", "tabletop_frame"},
                   beam(x_side - Point(0, 0, .5 * depth), x_side + Point(0, 0, .5 * depth), bar(.06, .03)));
    table.add_front_and_back(
        {"frame_f", "frame_b"}, {"tabletop", "tabletop_frame"}, {"tabletop", "tabletop_frame"},
        beam(z_side - Point(.5 * width - .055, 0, 0), z_side + Point(.5 * width - .055, 0, 0), bar(.03, .06)));
    return;
  }
  default:
    table.add("top", {"tabletop", ""}, board({0, y, 0}, width, depth, thickness, {6, 8, .015, .25}));
  }
  const double leaf = .45 * f.width, edge = .5 * width;
  if (design.top == Table_top::drop_leaf_up)
    table.add_pair({"leaf_l", "leaf_r"}, {"tabletop", "leaf"},
                   board({edge + .5 * leaf + .004, y, 0}, leaf, depth, thickness, {5, 6, .03, .25}));
  if (design.top == Table_top::drop_leaf_down)
    table.add_pair(
        {"leaf_l", "leaf_r"}, {"tabletop", "leaf"},
        slab(flat({edge + .016, y - leaf, -.5 * depth}, {0, leaf, 0}, {0, 0, depth}), .022, {5, 6, .03, .25}));
}

void add_table_legs(Assembly& table, const Table_frame& f, const Table_design& design, Random& random)
{
  const double x = f.width / 2 - .6 * f.wood, z = f.depth / 2 - .6 * f.wood, top = f.under() + .005;
  const double splay = design.aprons || design.shelves ? 0 : random.between(0, .12);
  const auto leg = [&](double px, double pz) {
    if (design.base == Table_base::turned_legs) return turned_leg({px, 0, pz}, {px, top, pz}, .55 * f.wood);
    return beam({px + splay, 0, pz + splay}, {px, top, pz}, bar({.7 * f.wood, .7 * f.wood}, {f.wood, f.wood}));
  };
  const double inner = design.top == Table_top::disc ? .72 : 1;
  table.add_four({"leg_fl", "leg_fr", "leg_bl", "leg_br"}, leg_label("front"), leg_label("back"),
                 leg(inner * x, inner * z));
  if (design.base == Table_base::six_legs)
    table.add_front_and_back({"leg_fm", "leg_bm"}, {"leg", "leg_front_center"}, {"leg", "leg_back_center"}, leg(0, z));
  if (design.aprons) {
    const double y = f.under() - .045;
    table.add_front_and_back({"apron_f", "apron_b"}, {"apron", "apron_front_center"}, {"apron", "apron_back_center"},
                             beam({-x, y, z}, {x, y, z}, bar(.09, .022)));
    table.add_pair({"apron_l", "apron_r"}, {"apron", "apron_mid"}, beam({x, y, -z}, {x, y, z}, bar(.022, .09)));
  }
  if (design.stretchers) {
    const double y = .18 * f.height;
    table.add_pair({"stretcher_l", "stretcher_r"}, {"stretcher", "stretcher_mid"},
                   beam({x, y, -z}, {x, y, z}, bar(.025, .04)));
    table.add("stretcher_cross", {"stretcher", "stretcher_cross"}, beam({-x, y, 0}, {x, y, 0}, bar(.04, .025)));
  }
  for (int i = 0; i < design.shelves; ++i)
    table.add(
        "shelf_" + std::to_string(i + 1), {"shelf", ""},
        board({0, f.height * (.18 + .34 * i), 0}, f.width - .3 * f.wood, f.depth - .3 * f.wood, .022, {5, 6, 0, .2}));
  if (design.top == Table_top::drop_leaf_up) // gate legs carry the leaves
    table.add_pair({"gate_l", "gate_r"}, {"leg", "leg_gate"},
                   beam({x + .35 * f.width, 0, 0}, {x + .35 * f.width, top, 0}, bar(.7 * f.wood, .7 * f.wood)));
  if (design.top == Table_top::drop_leaf_up)
    table.add_pair({"gate_arm_l", "gate_arm_r"}, {"stretcher", "gate_arm"},
                   beam({x, .3 * f.height, 0}, {x + .35 * f.width, .3 * f.height, 0}, bar(.04, .025)));
  if (design.top == Table_top::drop_leaf_up)
    table.add_pair({"gate_hinge_l", "gate_hinge_r"}, {"stretcher", "stretcher_mid"},
                   beam({x, .3 * f.height, -z}, {x, .3 * f.height, z}, bar(.025, .04)));
}

void add_front_drawers(Assembly& table, const Table_frame& f, const Table_design& design)
{
  const double width = (f.width - .2) / design.drawers, y = f.under() - .047, z = f.depth / 2 - .02;
  const Solid knob = post({{0, 0}, {.008, 0}, {.007, .012}, {.015, .018}, {.017, .026}, {.01, .034}, {0, .036}}, 10);
  const double first = -.5 * width * (design.drawers - 1);
  table.add_row(numbered("drawer_", design.drawers), {"drawer", ""},
                slab(flat({first - .46 * width, y - .035, z}, {.92 * width, 0, 0}, {0, .07, 0}), .016, {6, 3, 0, .2}),
                {width, 0, 0});
  table.add_row(numbered("knob_", design.drawers), {"knob", ""},
                transformed(knob, stand_on({first, y, z + .006}, {first, y, 1})), {width, 0, 0});
}

void add_cabinet(Assembly& table, const Table_frame& f, const Table_design& design)
{
  const double w = .34 * f.width, x = f.width / 2 - w / 2, low = .06, high = f.under() + .002, z = f.depth / 2 - .03;
  table.add("cabinet_side_in", {"cabinet", ""},
            slab(flat({x - w / 2, low, -z}, {0, high - low, 0}, {0, 0, 2 * z}), .018, {5, 5, 0, .2}));
  table.add("cabinet_side_out", {"cabinet", ""},
            slab(flat({x + w / 2, low, -z}, {0, high - low, 0}, {0, 0, 2 * z}), .018, {5, 5, 0, .2}));
  table.add("cabinet_floor", {"cabinet", ""}, board({x, low + .01, 0}, w, 2 * z, .018, {4, 5, 0, .2}));
  table.add("cabinet_back", {"cabinet", ""},
            slab(flat({x - w / 2, low, -z}, {0, high - low, 0}, {w, 0, 0}), .012, {5, 4, 0, .2}));
  const double step = (high - low) / design.drawers;
  table.add_row(numbered("drawer_", design.drawers), {"drawer", ""},
                slab(flat({x - w / 2 + .01, low + .03, z}, {w - .02, 0, 0}, {0, .8 * step, 0}), .02, {5, 4, 0, .2}),
                {0, step, 0});
  table.add_row(
      numbered("handle_", design.drawers), {"knob", ""},
      beam({x - .06, low + .03 + .4 * step, z + .016}, {x + .06, low + .03 + .4 * step, z + .016}, bar(.014, .016)),
      {0, step, 0});
  const double leg_x = -f.width / 2 + .04;
  table.add_front_and_back({"leg_f", "leg_b"}, {"leg", "leg_front_right"}, {"leg", "leg_back_right"},
                           beam({leg_x, 0, z}, {leg_x, f.under() + .005, z}, bar(.045, .045)));
  for (const double side : {-.4, .4}) {
    const std::string stem = side < 0 ? "foot_in" : "foot_out";
    const double foot_x = x + side * w;
    table.add_front_and_back({stem + "_f", stem + "_b"}, {"leg", "foot"}, {"leg", "foot"},
                             beam({foot_x, 0, .8 * z}, {foot_x, low + .01, .8 * z}, bar(.035, .035), 3));
  }
}

void add_pedestal(Assembly& table, const Table_frame& f, const Table_design& design, double x, bool pair,
                  Random& random)
{
  const double top = f.under() - .012, r = random.about(.035);
  const Solid cap =
      beam({x - .28 * f.depth, f.under() - .012, 0}, {x + .28 * f.depth, f.under() - .012, 0}, bar(.03, .09));
  Profile profile{
      {0, .08},      {1.2 * r, .08}, {1.6 * r, .14},       {1.6 * r, .24}, {r, .3 * top}, {1.5 * r, .45 * top},
      {r, .6 * top}, {r, .75 * top}, {1.4 * r, .85 * top}, {1.4 * r, top}, {0, top}};
  const Solid column = translated(post(profile, 14), {x, 0, 0});
  const double reach = pair ? .42 * f.depth : .36 * f.width;
  const Path path = spline({{0, .2, .02}, {0, .2, .3 * reach}, {0, .1, .7 * reach}, {0, .022, reach}});
  const Section section = bar({.04, .06}, {.03, .036});
  if (pair) {
    table.add_pair({"cap_l", "cap_r"}, {"apron", "apron_mid"},
                   beam({x, f.under() - .012, -.35 * f.depth}, {x, f.under() - .012, .35 * f.depth}, bar(.06, .03)));
    table.add_pair({"post_l", "post_r"}, {"leg", "pedestal_post"}, column);
    table.add_four({"foot_fl", "foot_fr", "foot_bl", "foot_br"}, {"leg", ""}, {"leg", ""},
                   translated(tube(path, section), {x, 0, 0}));
    return;
  }
  table.add("cap", {"apron", ""},
            disc(disc_profile(.16, f.under() - .03, f.under() + .002, .008), .16, f.under() - .014, 24));
  if (design.base == Table_base::plate) {
    table.add("post", {"leg", "pedestal_post"}, beam({0, .02, 0}, {0, f.under() - .02, 0}, round_section(1.1 * r, 14)));
    const double radius = .28 * f.width;
    table.add("plate", {"leg", "base"},
              disc({{0, 0},
                    {.5 * radius, 0},
                    {.95 * radius, 0},
                    {radius, .01},
                    {.6 * radius, .03},
                    {.2 * radius, .045},
                    {0, .045}},
                   radius, .018));
    return;
  }
  table.add("post", {"leg", "pedestal_post"}, column);
  table.add_ring(numbered("foot_", random.below(2) == 0 ? 3 : 4), {"leg", ""}, tube(path, section), Point::Zero(),
                 Point::UnitY());
  if (design.shelves)
    table.add("shelf", {"shelf", ""},
              disc(disc_profile(.2 * f.width, .5 * top, .5 * top + .02, .005), .2 * f.width, .5 * top + .01, 24));
}

void add_trestles(Assembly& table, const Table_frame& f, const Table_design& design)
{
  const double x = .36 * f.width, z = .4 * f.depth, top = f.under();
  table.add_pair({"head_l", "head_r"}, {"apron", "apron_mid"},
                 beam({x, top - .03, -z}, {x, top - .03, z}, bar(.06, .06)));
  if (design.base == Table_base::x_trestle) {
    table.add_pair({"x_front_l", "x_front_r"}, leg_label("front"),
                   beam({x, 0, z}, {x, top - .05, -.8 * z}, bar(.05, .07)));
    table.add_pair({"x_back_l", "x_back_r"}, leg_label("back"),
                   beam({x - .03, 0, -z}, {x - .03, top - .05, .8 * z}, bar(.05, .07)));
  } else {
    table.add_pair({"post_l", "post_r"}, {"leg", "leg_mid"}, beam({x, .05, 0}, {x, top - .04, 0}, bar(.06, .16)));
    table.add_pair({"foot_l", "foot_r"}, {"leg", "foot"}, beam({x, .03, -z}, {x, .03, z}, bar(.07, .06)));
  }
  const double y = design.base == Table_base::x_trestle ? .5 * top : .35 * top;
  table.add("stretcher", {"stretcher", "stretcher_cross"}, beam({-x, y, 0}, {x, y, 0}, bar(.07, .03)));
}

Assembly table(const Table_design& design, std::uint64_t seed)
{
  Random random(seed);
  const Table_frame f(design, random);
  Assembly result(design.name, "table");
  add_table_top(result, f, design);
  switch (design.base) {
  case Table_base::pedestal:
  case Table_base::plate:
    add_pedestal(result, f, design, 0, false, random);
    break;
  case Table_base::two_pedestals:
    add_pedestal(result, f, design, .3 * f.width, true, random);
    break;
  case Table_base::trestle:
  case Table_base::x_trestle:
    add_trestles(result, f, design);
    break;
  case Table_base::cabinet:
    add_cabinet(result, f, design);
    return result;
  default:
    add_table_legs(result, f, design, random);
  }
  if (design.drawers) add_front_drawers(result, f, design);
  return result;
}

const std::vector<Table_design>& table_designs()
{
  using Base = Table_base;
  using Top = Table_top;
  static const std::vector<Table_design> designs{
      {"table_dining", Base::legs, Top::board, true},
      {"table_round", Base::legs, Top::disc, false, 0, 0, false, 1.0, 1.0},
      {"table_drawers", Base::turned_legs, Top::board, true, 0, 2, false, 1.2, .7},
      {"table_pedestal_round", Base::pedestal, Top::disc, false, 0, 0, false, 1., 1.},
      {"table_bistro", Base::plate, Top::disc, false, 0, 0, false, .7, .7},
      {"table_double_pedestal", Base::two_pedestals, Top::board, false, 0, 0, false, 1.9, .9},
      {"table_monastery", Base::trestle, Top::board, false, 0, 0, false, 1.8, .8},
      {"table_x_trestle", Base::x_trestle, Top::board, false, 0, 0, false, 1.6, .8},
      {"table_leaves_down", Base::legs, Top::drop_leaf_down, true, 0, 0, false, .8, .8},
      {"table_leaves_up", Base::turned_legs, Top::drop_leaf_up, true, 0, 0, false, .7, .9},
      {"table_coffee", Base::legs, Top::board, false, 1, 0, false, 1.1, .6, .42},
      {"table_side", Base::legs, Top::board, true, 2, 1, false, .5, .42, .62},
      {"table_desk", Base::cabinet, Top::board, false, 0, 4, false, 1.3, .65},
      {"table_writing", Base::legs, Top::board, true, 0, 3, true, 1.2, .6},
      {"table_glass", Base::six_legs, Top::framed_glass, true, 0, 0, false, 2., .9}};
  return designs;
}

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
