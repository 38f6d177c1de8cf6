// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "designs.h"

namespace CGAL::Shape_correspondence::generator {

Assembly table_trestle()
{
  Assembly table("table_trestle", "table");
  table.add("plank_top", {"tabletop", ""}, board({0, .735, 0}, 1.6, .8, .03, {6, 10, 0, .2}));
  const double x = .5, head = .69;
  const Names beams{"horse_beam_l", "horse_beam_r"};
  table.add_pair(beams, {"apron", "apron_mid"}, beam({x, head, -.36}, {x, head, .36}, bar(.06, .07), 6));
  auto leg = [&](double side) {
    return beam({x + side * .17, 0, .33}, {x + side * .022, .7, .27}, bar({.035, .045}, {.04, .05}));
  };
  const Names outer_front{"strut_1", "strut_2"}, inner_front{"strut_3", "strut_4"}, outer_back{"strut_5", "strut_6"},
      inner_back{"strut_7", "strut_8"}, front_ties{"tie_1", "tie_2"}, back_ties{"tie_3", "tie_4"};
  const Label leg_label{"leg", ""}, tie_label{"stretcher", ""};
  table.add_four({"strut_1", "strut_2", "strut_5", "strut_6"}, leg_label, leg_label, leg(1));
  table.add_four({"strut_3", "strut_4", "strut_7", "strut_8"}, leg_label, leg_label, leg(-1));
  table.add_four({"tie_1", "tie_2", "tie_3", "tie_4"}, tie_label, tie_label,
                 beam({x - .135, .2, .313}, {x + .135, .2, .313}, bar(.045, .02)));
  table.touch("plank_top", beams);
  for (const Names& legs : {outer_front, inner_front, outer_back, inner_back})
    table.touch_in_turn(beams, legs);

  for (const Names& legs : {outer_front, inner_front})
    table.touch_in_turn(front_ties, legs);
  for (const Names& legs : {outer_back, inner_back})
    table.touch_in_turn(back_ties, legs);
  return table;
}

Assembly table_pedestal()
{
  Assembly table("table_pedestal", "table");
  table.add("round_top", {"tabletop", ""}, disc(disc_profile(.5, .715, .745, .006), .5, .73));
  table.add("edge_ring", {"tabletop", "tabletop_edge"},
            torus({0, .73, 0}, Point::UnitY(), .508, oval({.019, .014}, {.019, .014}, 8), 40));
  table.add("cap", {"apron", ""}, disc(disc_profile(.17, .69, .717, .008), .17, .7035, 24));
  table.add("turned_post", {"leg", "pedestal_post"},
            post({{0, .1},
                  {.04, .1},
                  {.06, .115},
                  {.06, .27},
                  {.035, .29},
                  {.05, .31},
                  {.033, .33},
                  {.058, .4},
                  {.05, .47},
                  {.032, .58},
                  {.03, .61},
                  {.048, .625},
                  {.034, .64},
                  {.06, .695},
                  {0, .695}},
                 16));
  const Names feet = numbered("claw_", 4);
  const Path path = spline({{0, .23, .03}, {0, .245, .13}, {0, .14, .26}, {0, .045, .37}, {0, .028, .44}});
  table.add_ring(
      feet, {"leg", ""},
      transformed(tube(path, bar({.04, .06}, {.034, .036})), rotation_about(Point::Zero(), Point::UnitY(), pi / 4)),
      Point::Zero(), Point::UnitY());
  table.add("drop", {"leg", "finial"},
            post({{0, .055}, {.018, .06}, {.026, .075}, {.02, .092}, {.03, .103}, {0, .103}}));
  table.touch("round_top", {"edge_ring", "cap"});
  table.touch("turned_post", {"cap", "drop"});
  table.touch("turned_post", feet);
  return table;
}

Assembly table_four_legged()
{
  Assembly table("table_four_legged", "table");
  table.add("top_board", {"tabletop", ""}, board({0, .75, 0}, 1.3, .8, .028, {6, 8, .015, .25}));
  Profile profile{{0, 0},      {.014, 0},   {.017, .02}, {.02, .1},   {.03, .38},  {.034, .46}, {.022, .49},
                  {.036, .51}, {.024, .53}, {.034, .56}, {.034, .65}, {.034, .74}, {0, .74}};
  table.add_four({"post_1", "post_2", "post_3", "post_4"}, leg_label("front"), leg_label("back"),
                 translated(post(profile), {.56, 0, .32}));
  table.add_front_and_back({"skirt_f", "skirt_b"}, {"apron", "apron_front_center"}, {"apron", "apron_back_center"},
                           beam({-.55, .685, .325}, {.55, .685, .325}, bar(.11, .022)));
  table.add_pair({"skirt_l", "skirt_r"}, {"apron", "apron_mid"},
                 beam({.565, .685, -.31}, {.565, .685, .31}, bar(.022, .11)));
  table.add("drawer_front", {"drawer", ""},
            slab(flat({-.2, .645, .338}, {.4, 0, 0}, {0, .08, 0}), .014, {6, 3, 0, .2}));
  const Solid knob = post({{0, 0}, {.008, 0}, {.007, .012}, {.015, .018}, {.017, .026}, {.01, .034}, {0, .036}}, 10);
  table.add("knob", {"knob", ""}, transformed(knob, stand_on({0, .685, .342}, {0, .685, 1})));
  const Names fronts{"post_1", "post_2"}, backs{"post_3", "post_4"}, sides{"skirt_l", "skirt_r"};
  table.touch("top_board", {"post_1", "post_2", "post_3", "post_4", "skirt_f", "skirt_b", "skirt_l", "skirt_r"});
  table.touch("skirt_f", fronts);
  table.touch("skirt_b", backs);
  table.touch_in_turn(sides, fronts);
  table.touch_in_turn(sides, backs);
  table.touch("drawer_front", {"skirt_f", "knob"});
  return table;
}

} // namespace CGAL::Shape_correspondence::generator
