// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bed_designs.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

void add_bed_end(Assembly& bed, const Bed_frame& f, const std::string& stem, const std::string& coarse, Bed_end kind,
                 double low, double high, double side)
{
  const double x = f.x(), z = side * f.z();
  const Label label{coarse, ""};
  if (kind == Bed_end::panel) {
    bed.add(stem + "_panel", {coarse, coarse + "_panel"},
            slab(flat({-x, low, z}, {2 * x, 0, 0}, {0, high - low - .05, 0}), .024, {7, 4, 0, .2}));
    bed.add(stem + "_rail", {coarse, coarse + "_rail"},
            beam({-x, high - .04, z}, {x, high - .04, z}, bar(.07, .05), 7));
    return;
  }
  if (kind == Bed_end::cushion) {
    bed.add(stem + "_cushion", {coarse, coarse + "_panel"},
            slab(flat({-x, low, z}, {2 * x, 0, 0}, {0, high - low, 0}), .11, {7, 5, .05, .35}));
    return;
  }
  bed.add(stem + "_rail", {coarse, coarse + "_rail"}, beam({-x, high - .04, z}, {x, high - .04, z}, bar(.07, .04), 7));
  if (kind == Bed_end::slats) {
    const int n = 3;
    const double step = (high - .09 - low) / n;
    bed.add_row(numbered(stem + "_slat_", n), label,
                slab(flat({-x, low, z}, {2 * x, 0, 0}, {0, .7 * step, 0}), .02, {6, 3, 0, .2}), {0, step, 0});
    return;
  }
  bed.add(stem + "_low_rail", {coarse, coarse + "_mid_rail"},
          beam({-x, low + .02, z}, {x, low + .02, z}, bar(.05, .03), 7));
  const int n = std::max(4, int(2 * x / .16));
  const double step = 2 * x / (n + 1);
  bed.add_row(numbered(stem + "_bar_", n), label,
              beam({-x + step, low + .02, z}, {-x + step, high - .05, z}, round_section(.012)), {step, 0, 0});
}

void add_mattress(Assembly& bed, const Bed_frame& f, const std::string& suffix, double y, int pillows)
{
  bed.add("mattress" + suffix, {"mattress", ""},
          board({0, y + .09, 0}, f.width - .05, f.length - .06, .18, {7, 5, .03, .25}));
  const double z = -f.z() + .26;
  if (pillows == 2)
    bed.add_pair({"pillow_l" + suffix, "pillow_r" + suffix}, {"pillow", "pillow"},
                 board({.23 * f.width, y + .225, z}, .4 * f.width, .34, .11, {5, 5, .12, .4}));
  else if (pillows == 1)
    bed.add("pillow" + suffix, {"pillow", ""}, board({0, y + .225, z}, .6 * f.width, .36, .11, {5, 5, .12, .4}));
}

void add_lying_surface(Assembly& bed, const Bed_frame& f, const std::string& suffix, double y, int laths, int pillows)
{
  bed.add_pair({"rail_l" + suffix, "rail_r" + suffix}, {"side_rail", "side_rail"},
               beam({f.x() - .01, y, -f.z()}, {f.x() - .01, y, f.z()}, bar(.028, .15), 8));
  const double step = (f.length - .3) / (laths - 1);
  bed.add_row(numbered("lath" + suffix + "_", laths), {"base", ""},
              beam({-f.x() + .01, y + .03, -.5 * step * (laths - 1)}, {f.x() - .01, y + .03, -.5 * step * (laths - 1)},
                   bar(.02, .09)),
              {0, 0, step});
  add_mattress(bed, f, suffix, y + .038, pillows);
}

void add_bed_posts(Assembly& bed, const Bed_frame& f, double head, double foot, bool round)
{
  const auto post_at = [&](double z, double height) {
    return beam({f.x(), 0, z}, {f.x(), height, z}, round ? round_section(.5 * f.wood) : bar(f.wood, f.wood));
  };
  bed.add_pair({"post_head_l", "post_head_r"}, leg_label("back"), post_at(-f.z(), head));
  bed.add_pair({"post_foot_l", "post_foot_r"}, leg_label("front"), post_at(f.z(), foot));
}

void add_single(Assembly& bed, const Bed_frame& f, const Bed_design& design, Random& random)
{
  const double head = random.about(.95), foot = design.footboard ? random.about(.58) : f.base + .1;
  add_bed_posts(bed, f, head, foot, design.end == Bed_end::bars);
  add_bed_end(bed, f, "head", "headboard", design.end, f.base, head, -1);
  if (design.footboard) add_bed_end(bed, f, "foot", "footboard", design.end, f.base - .06, foot, 1);
  add_lying_surface(bed, f, "", f.base, 8, design.pillows);
}

void add_platform(Assembly& bed, const Bed_frame& f, const Bed_design& design)
{
  bed.add_four({"foot_fl", "foot_fr", "foot_bl", "foot_br"}, leg_label("front"), leg_label("back"),
               turned_leg({f.x() - .08, 0, f.z() - .08}, {f.x() - .08, .13, f.z() - .08}, .03));
  bed.add("box", {"base", "mattress_board"}, board({0, .22, 0}, f.width, f.length, .2, {6, 5, .01, .2}));
  add_bed_end(bed, f, "head", "headboard", design.end, .14, 1.05, -1);
  add_mattress(bed, f, "", .32, design.pillows);
}

void add_ladder(Assembly& bed, const Bed_frame& f, double high, bool at_end)
{
  const double half = .18;
  const Point foot = at_end ? Point(half, 0, f.z() + .28) : Point(half, 0, 0);
  const Point head = at_end ? Point(half, high, f.z() + .02) : Point(half, high, 0);
  Assembly& b = bed;
  if (at_end) {
    b.add_pair({"ladder_l", "ladder_r"}, {"ladder", ""}, beam(foot, head, bar(.03, .05), 8));
    const int n = 5;
    const Point step = (head - foot) / (n + 1);
    const Point first = foot + step;
    b.add_row(numbered("rung_", n), {"ladder", "rung"}, beam(first, first - Point(2 * half, 0, 0), round_section(.014)),
              step);
    return;
  }
  // on the left side, towards the foot
  const double x = f.x() + .02, z = .5 * f.z();
  b.add_row({"ladder_1", "ladder_2"}, {"ladder", ""},
            beam({x + .12, 0, z - half}, {x, high, z - half}, bar(.05, .03), 8), {0, 0, 2 * half});
  const int n = 5;
  const Point step(-.12 / (n + 1), high / (n + 1), 0), first = Point(x + .12, 0, z) + step;
  b.add_row(numbered("rung_", n), {"ladder", "rung"},
            beam(first - Point(0, 0, half), first + Point(0, 0, half), round_section(.014)), step);
}

void add_guard(Assembly& bed, const Bed_frame& f, double y)
{
  bed.add_pair({"guard_l", "guard_r"}, {"side_rail", "guard_rail"},
               beam({f.x(), y + .36, -f.z()}, {f.x(), y + .36, f.z()}, bar(.024, .08), 8));
}

void add_bunk(Assembly& bed, const Bed_frame& f, const Bed_design& design, bool ladder_at_end)
{
  const double upper = 1.25, top = 1.7;
  add_bed_posts(bed, f, top, top, false);
  add_bed_end(bed, f, "head", "headboard", design.end, f.base, f.base + .5, -1);
  add_bed_end(bed, f, "head_up", "headboard", design.end, upper, top, -1);
  add_bed_end(bed, f, "foot", "footboard", design.end, f.base, f.base + .5, 1);
  add_bed_end(bed, f, "foot_up", "footboard", design.end, upper, top, 1);
  add_lying_surface(bed, f, "_low", f.base, 6, design.pillows);
  add_lying_surface(bed, f, "_up", upper, 6, design.pillows);
  add_guard(bed, f, upper);
  add_ladder(bed, f, upper, ladder_at_end);
}

void add_loft(Assembly& bed, const Bed_frame& f, const Bed_design& design)
{
  const double upper = 1.35, top = 1.8;
  add_bed_posts(bed, f, top, top, false);
  add_bed_end(bed, f, "head", "headboard", design.end, upper, top, -1);
  add_bed_end(bed, f, "foot", "footboard", design.end, upper, top, 1);
  add_lying_surface(bed, f, "", upper, 7, design.pillows);
  add_guard(bed, f, upper);
  bed.add("desk", {"desk", "desk_top"}, board({-.05, .72, -.2}, f.width - .04, f.length - .46, .03, {6, 6, 0, .2}));
  bed.add("desk_leg", {"desk", ""},
          slab(flat({-f.x() + .05, 0, .58}, {f.width - .2, 0, 0}, {0, .71, 0}), .03, {5, 5, 0, .2}));
  add_ladder(bed, f, upper, true);
}

void add_canopy(Assembly& bed, const Bed_frame& f, const Bed_design& design, Random& random)
{
  const double top = random.about(2.05, .05), x = f.x(), z = f.z(), y = top - .04;
  add_bed_posts(bed, f, top, top, design.end == Bed_end::bars);
  add_bed_end(bed, f, "head", "headboard", design.end, f.base, 1.05, -1);
  if (design.footboard) add_bed_end(bed, f, "foot", "footboard", design.end, f.base - .05, .6, 1);
  add_lying_surface(bed, f, "", f.base, 8, design.pillows);
  bed.add_pair({"canopy_l", "canopy_r"}, {"canopy", "canopy_mid"}, beam({x, y, -z}, {x, y, z}, bar(.05, .05), 7));
  bed.add_front_and_back({"canopy_f", "canopy_b"}, {"canopy", "canopy_front_center"}, {"canopy", "canopy_back_center"},
                         beam({-x, y, z}, {x, y, z}, bar(.05, .05)));
  if (design.pillows == 2) // the roomy ones have a cloth
    bed.add(
        "tester", {"canopy", "tester"},
        slab([=](double u,
                 double v) { return Point((2 * v - 1) * (x - .01), y + .03 + .1 * std::sin(pi * v), (2 * u - 1) * z); },
             .02, {6, 8, 0, .2}));
}

void add_cot(Assembly& bed, const Bed_frame& f, const Bed_design& design, Random& random)
{
  const double high = random.about(.88, .06), low = .3;
  add_bed_posts(bed, f, high, high, random.below(2) == 0);
  add_bed_end(bed, f, "head", "headboard", design.end, low, high, -1);
  add_bed_end(bed, f, "foot", "footboard", design.end, low, high, 1);
  const double x = f.x();
  bed.add_pair({"side_top_l", "side_top_r"}, {"side_rail", "side_rail"},
               beam({x, high - .03, -f.z()}, {x, high - .03, f.z()}, bar(.03, .05), 8));
  bed.add_pair({"side_low_l", "side_low_r"}, {"side_rail", "side_rail_low"},
               beam({x, low, -f.z()}, {x, low, f.z()}, bar(.03, .05), 8));
  const int n = 7;
  const double step = f.length / (n + 1);
  for (int i = 0; i < n; ++i) {
    const std::string stem = "side_bar_" + std::to_string(i + 1), z_stem = stem;
    const double z = -f.z() + (i + 1) * step;
    bed.add_pair({z_stem + "_l", z_stem + "_r"}, {"side_rail", "side_bar"},
                 beam({x, low, z}, {x, high - .04, z}, round_section(.011)));
  }
  bed.add("floor", {"base", "mattress_board"}, board({0, low + .02, 0}, f.width, f.length - .02, .02, {5, 5, 0, .2}));
  bed.add("mattress", {"mattress", ""},
          board({0, low + .085, 0}, f.width - .05, f.length - .06, .11, {6, 5, .03, .25}));
  if (design.pillows == 0) return;
  bed.add("pillow", {"pillow", ""}, board({0, low + .17, -f.z() + .18}, .6 * f.width, .22, .07, {5, 5, .12, .4}));
}

void add_sofa(Assembly& bed, const Bed_frame& f, const Bed_design& design, bool frame_shown)
{
  const double x = f.x(), z = f.z(), back = -z, sofa_front = back + .85, y = .36;
  bed.add("back", {"headboard", "headboard_panel"},
          slab([=](double u, double v) { return Point((2 * v - 1) * x, .2 + u * .65, back - .18 * u); }, .16,
               {6, 7, .04, .35}));
  bed.add_pair({"arm_l", "arm_r"}, {"armrest", "armrest"},
               slab(flat({x + .08, .06, back - .08}, {0, .54, 0}, {0, 0, .93}), .15, {5, 6, .06, .35}));
  bed.add("sofa_box", {"base", "chassis"}, board({0, .2, back + .42}, 2 * x, .84, .24, {5, 6, .01, .2}));
  bed.add("mattress", {"mattress", ""}, board({0, y + .06, 0}, 2 * x - .06, 2 * z - .02, .13, {7, 6, .03, .25}));
  if (frame_shown) {
    bed.add_pair({"frame_l", "frame_r"}, {"side_rail", "side_rail"},
                 beam({x - .05, y - .02, sofa_front - .05}, {x - .05, y - .02, z - .02}, round_section(.016)));
    bed.add("frame_front", {"footboard", "footboard_rail"},
            beam({-x + .05, y - .02, z - .02}, {x - .05, y - .02, z - .02}, round_section(.016)));
    bed.add_pair({"leg_front_l", "leg_front_r"}, leg_label("front"),
                 beam({x - .05, 0, z - .03}, {x - .05, y - .01, z - .03}, round_section(.014)));
  } else
    bed.add("drawer", {"drawer", ""}, board({0, .235, .42}, 2 * x - .1, 2 * z - .86, .25, {5, 6, .01, .2}));
  bed.add_pair({"leg_back_l", "leg_back_r"}, leg_label("back"),
               turned_leg({x - .06, 0, back + .05}, {x - .06, .1, back + .05}, .028));
  if (design.pillows)
    bed.add_pair({"pillow_l", "pillow_r"}, {"pillow", "pillow"},
                 board({.5 * x, y + .18, back + .3}, .8 * x, .36, .12, {5, 5, .12, .4}));
}

Assembly bed(const Bed_design& design, std::uint64_t seed)
{
  Random random(seed);
  const Bed_frame f(design, random);
  Assembly result(design.name, "bed");
  switch (design.kind) {
  case Bed_kind::single:
    add_single(result, f, design, random);
    break;
  case Bed_kind::platform:
    add_platform(result, f, design);
    break;
  case Bed_kind::bunk:
    add_bunk(result, f, design, !design.footboard);
    break;
  case Bed_kind::loft:
    add_loft(result, f, design);
    break;
  case Bed_kind::canopy:
    add_canopy(result, f, design, random);
    break;
  case Bed_kind::cot:
    add_cot(result, f, design, random);
    break;
  case Bed_kind::sofa:
    add_sofa(result, f, design, design.footboard);
  }
  return result;
}

const std::vector<Bed_design>& bed_designs()
{
  using Kind = Bed_kind;
  using End = Bed_end;
  static const std::vector<Bed_design> designs{{"bed_panels", Kind::single, End::panel},
                                               {"bed_slats", Kind::single, End::slats, 1.4, 2.05, 2},
                                               {"bed_bars", Kind::single, End::bars, .95, 2., 1},
                                               {"bed_no_footboard", Kind::single, End::slats, 1.6, 2.1, 2, false},
                                               {"bed_platform", Kind::platform, End::cushion, 1.6, 2.1, 2, false},
                                               {"bed_bunk_slats", Kind::bunk, End::slats, .95, 2.},
                                               {"bed_bunk_panels", Kind::bunk, End::panel, .95, 2., 1, false},
                                               {"bed_loft", Kind::loft, End::slats, 1., 2.05},
                                               {"bed_canopy", Kind::canopy, End::panel, 1.5, 2.1, 2},
                                               {"bed_canopy_bars", Kind::canopy, End::bars, 1.1, 2.05, 1},
                                               {"bed_canopy_open", Kind::canopy, End::slats, 1.6, 2.1, 2, false},
                                               {"bed_cot_bars", Kind::cot, End::bars, .66, 1.25, 0},
                                               {"bed_cot_panels", Kind::cot, End::panel, .7, 1.3, 1},
                                               {"bed_sofa", Kind::sofa, End::cushion, 1.5, 1.95, 0},
                                               {"bed_sofa_drawer", Kind::sofa, End::cushion, 1.35, 1.9, 2, false}};
  return designs;
}

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
