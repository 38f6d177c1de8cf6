// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "desk_designs.h"

#include "random.h"
#include "table_designs.h"

#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {
namespace {

enum class Desk_support { panels, frames, columns, cabinet, two_cabinets, thick_legs };

struct Desk_design
{
  const char* name;
  Desk_support support;
  double width, depth, height; ///< before they are varied
  bool back_panel = false;
  int shelves = 0;
  int drawers = 0; ///< of each cabinet
  bool apron = false;
};

struct Desk_frame
{
  double width, depth, height, wood;

  Desk_frame(const Desk_design& design, Random& random)
      : width(random.about(design.width)),
        depth(random.about(design.depth)),
        height(random.about(design.height, .06)),
        wood(random.between(.02, .05))
  {}

  double x() const { return width / 2; }
  double z() const { return depth / 2; }
  double under() const { return height - wood; }
};

Solid upright(const Desk_frame& f, double x, double low, double high, double thickness)
{
  return slab(flat({x, low, -f.z() + .02}, {0, high - low, 0}, {0, 0, f.depth - .04}), thickness, {6, 6, 0, .2});
}

/// Both ends stand on rings of bars, each in one piece.
Solid end_frame(const Desk_frame& f)
{
  const double x = f.x() - .06, z = f.z() - .05, low = .02, high = f.under() - .02;
  const Path ring = bent({{x, low, 0}, {x, low, z}, {x, high, z}, {x, high, -z}, {x, low, -z}, {x, low, 0}}, .03);
  return tube({ring.begin(), ring.end() - 1}, bar(.04, .036), Point::UnitX(), true);
}

void add_columns(Assembly& desk, const Desk_frame& f)
{
  const double x = .8 * f.x();
  desk.add_pair({"foot_l", "foot_r"}, {"leg", "foot_column"},
                beam({x, .03, -f.z() + .04}, {x, .03, f.z() - .04}, bar(.06, .05), 7));
  desk.add_pair({"column_l", "column_r"}, {"leg", "upper_column"},
                beam({x, .05, 0}, {x, f.under(), 0}, bar(.07, .05), 8));
}

/// A box for drawers at one side, x > 0, and their fronts with handles.
void add_desk_cabinet(Assembly& desk, const Desk_frame& f, const std::string& suffix, const std::string& side,
                      double sign, int drawers)
{
  const double width = .32 * f.width, x = sign * (f.x() - width / 2 - .02), low = .06, high = f.under() - .004;
  desk.add("cabinet" + suffix, {"cabinet", "cabinet_body" + side},
           board({x, (low + high) / 2, -.02}, width, f.depth - .06, high - low, {6, 6, 0, .03}));
  const double step = (high - low) / drawers, front = f.z() - .04;
  desk.add_row(
      numbered("drawer" + suffix + "_", drawers), {"drawer", ""},
      slab(flat({x - width / 2 + .01, low + .01, front}, {width - .02, 0, 0}, {0, step - .02, 0}), .02, {6, 5, 0, .2}),
      {0, step, 0});
  desk.add_row(
      numbered("handle" + suffix + "_", drawers), {"handle", "drawer_handle"},
      beam({x - .06, low + step / 2, front + .016}, {x + .06, low + step / 2, front + .016}, round_section(.008)),
      {0, step, 0});
}

Assembly desk(const Desk_design& design, std::uint64_t seed)
{
  Random random(seed);
  const Desk_frame f(design, random);
  Assembly result(design.name, "table");
  result.add("top", {"tabletop", ""}, board({0, f.height - f.wood / 2, 0}, f.width, f.depth, f.wood, {6, 8, 0, .2}));
  const double panel = random.between(.02, .05), end = f.x() - .02 - panel / 2;
  switch (design.support) {
  case Desk_support::panels:
    result.add_pair({"side_l", "side_r"}, {"leg", "side_panel"}, upright(f, end, 0, f.under(), panel));
    break;
  case Desk_support::frames:
    result.add_pair({"frame_l", "frame_r"}, {"leg", "leg_frame"}, end_frame(f));
    break;
  case Desk_support::columns:
    add_columns(result, f);
    break;
  case Desk_support::cabinet:
    result.add("side", {"leg", "leg_mid_right"}, upright(f, -end, 0, f.under(), panel));
    add_desk_cabinet(result, f, "", "", 1, design.drawers);
    break;
  case Desk_support::two_cabinets:
    add_desk_cabinet(result, f, "_l", "_left", 1, design.drawers);
    add_desk_cabinet(result, f, "_r", "_right", -1, design.drawers);
    break;
  case Desk_support::thick_legs: {
    const double leg = random.between(.05, .11);
    result.add_four(
        {"leg_fl", "leg_fr", "leg_bl", "leg_br"}, leg_label("front"), leg_label("back"),
        beam({f.x() - leg / 2, 0, f.z() - leg / 2}, {f.x() - leg / 2, f.under(), f.z() - leg / 2}, bar(leg, leg)));
  }
  }
  const double between_sides = 2 * (end - .02);
  if (design.back_panel) {
    const double low = random.between(.3, .5) * f.height, right = .04 - f.x(),
                 left = f.x() - (design.support == Desk_support::cabinet ? .34 * f.width : .04);
    result.add(
        "panel", {"panel", "modesty_panel"},
        slab(flat({right, low, -f.z() + .06}, {left - right, 0, 0}, {0, f.under() - low, 0}), .02, {5, 7, 0, .2}));
  }
  for (int i = 0; i < design.shelves; ++i)
    result.add(
        "shelf_" + std::to_string(i + 1), {"shelf", ""},
        board({0, f.height * (i + 1) / (design.shelves + 1.5), 0}, between_sides, f.depth - .1, .02, {6, 8, 0, .2}));
  if (design.apron) {
    const double y = f.under() - .05, x = f.x() - .06, z = f.z() - .06;
    result.add_front_and_back({"apron_f", "apron_b"}, {"apron", "apron_front_center"}, {"apron", "apron_back_center"},
                              beam({-x, y, z}, {x, y, z}, bar(.09, .02)));
    result.add_pair({"apron_l", "apron_r"}, {"apron", "apron_mid"}, beam({x, y, -z}, {x, y, z}, bar(.02, .09)));
  }
  return result;
}

const std::vector<Desk_design>& desk_designs()
{
  using S = Desk_support;
  static const std::vector<Desk_design> designs{
      {"table_panels", S::panels, 1.2, .7, .74},
      {"table_panels_back", S::panels, 1.2, .6, .74, true},
      {"table_panels_low", S::panels, 1., .5, .42, false, 1},
      {"table_panels_shelf", S::panels, .8, .4, .6, true, 1},
      {"table_frames", S::frames, 1.4, .7, .74},
      {"table_frames_apron", S::frames, 1.6, .8, .74, false, 0, 0, true},
      {"table_frames_low", S::frames, 1.1, .6, .45, false, 1},
      {"table_columns", S::columns, 1.6, .8, .72},
      {"table_columns_panel", S::columns, 1.5, .75, .72, true},
      {"table_cabinet", S::cabinet, 1.3, .65, .75, true, 0, 3},
      {"table_cabinet_plain", S::cabinet, 1.1, .6, .74, false, 0, 2},
      {"table_two_cabinets", S::two_cabinets, 1.7, .8, .76, true, 0, 3},
      {"table_thick_legs", S::thick_legs, .9, .9, .45},
      {"table_thick_legs_high", S::thick_legs, 1.5, .8, .74, false, 0, 0, true},
      {"table_bench", S::thick_legs, 1.2, .38, .45, false, 0, 0, true}};
  return designs;
}

} // namespace

std::vector<Assembly> desks(std::uint64_t seed) { return shapes_of(desk_designs(), seed, desk); }

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
