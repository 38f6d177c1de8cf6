// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bed_kinds.h"

#include "made_bed_designs.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {
namespace {

/// A bed frame of a width and length that are varied.
Bed_frame frame_of(double width, double length, Random& random)
{
  return Bed_frame({"", Bed_kind::single, Bed_end::panel, width, length}, random);
}

/// A mattress on `lying`, pillows on it at the head, and bedding.
void make_bed(Assembly& bed, const Bed_frame& f, double lying, double thickness, int pillows, Bedding bedding,
              Random& random, const std::string& suffix = "")
{
  const double top = lying + thickness;
  bed.add("mattress" + suffix, {"mattress", ""},
          board({0, lying + thickness / 2, 0}, f.width - .07, f.length - .07, thickness - .004, {7, 5, .03, .25}));
  const double z = -f.z() + random.between(.22, .32), height = random.between(.1, .16);
  const auto pillow = [&](double x, double width) {
    return board({x, top + .45 * height, z}, width, random.between(.3, .42), height, {6, 6, .1, .4});
  };
  if (pillows == 2)
    bed.add_pair({"pillow_l" + suffix, "pillow_r" + suffix}, {"pillow", "pillow"}, pillow(.24 * f.width, .4 * f.width));
  else if (pillows == 1)
    bed.add("pillow" + suffix, {"pillow", ""}, pillow(0, random.between(.5, .75) * f.width));
  add_bedding(bed, f, bedding, top, random, suffix);
}

void add_side_rails(Assembly& bed, const Bed_frame& f, double y, double height)
{
  bed.add_pair({"rail_l", "rail_r"}, {"side_rail", "side_rail"},
               beam({f.x(), y, -f.z()}, {f.x(), y, f.z()}, bar(.03, height), 8));
}

/// Bars or a panel along one of the long sides, and at both ends.
Assembly day_bed(const char* name, bool panels, bool drawers, std::uint64_t seed)
{
  Random random(seed);
  Assembly bed(name, "bed");
  const Bed_frame f = frame_of(.95, 2., random);
  const double high = random.about(.85, .1), lying = random.between(.3, .4), x = f.x(), z = f.z();
  add_bed_posts(bed, f, high, high, !panels);
  for (const auto& [stem, side] : {std::pair<std::string, double>{"head", -1}, {"foot", 1}})
    add_bed_end(bed, f, stem, stem + "board", panels ? Bed_end::panel : Bed_end::bars, lying, high, side);
  bed.add("back_rail", {"back_rail", ""}, beam({-x, high - .03, -z}, {-x, high - .03, z}, round_section(.02), 8));
  if (panels)
    bed.add("back_panel", {"back_rail", ""},
            slab(flat({-x, lying, -z + .03}, {0, 0, 2 * z - .06}, {0, high - lying - .06, 0}), .02, {7, 4, 0, .2}));
  else {
    constexpr int bars = 8;
    const double step = 2 * z / (bars + 1);
    bed.add_row(numbered("back_bar_", bars), {"back_rail", ""},
                beam({-x, lying, -z + step}, {-x, high - .035, -z + step}, round_section(.01, 8)), {0, 0, step});
  }
  add_side_rails(bed, f, lying - .05, .12);
  bed.add("board", {"base", "mattress_board"}, board({0, lying - .03, 0}, f.width - .03, f.length - .04, .03));
  if (drawers)
    bed.add_row({"drawer_1", "drawer_2"}, {"drawer", ""},
                board({.02, .15, -.5 * z}, f.width - .06, z - .08, .18, {5, 5, 0, .1}), {0, 0, z});
  make_bed(bed, f, lying - .012, random.between(.14, .2), drawers ? 2 : 0, drawers ? Bedding::blanket : Bedding::none,
           random);
  return bed;
}

/// A bed that can be raised: a chassis on casters, struts, boards at the ends and bent rails at the sides.
Assembly hospital_bed(const char* name, bool struts, Bedding bedding, std::uint64_t seed)
{
  Random random(seed);
  Assembly bed(name, "bed");
  const Bed_frame f = frame_of(.95, 2.05, random);
  const double lying = random.about(.55, .1), low = .2, x = f.x(), z = f.z(), in = .12;
  bed.add_four({"caster_fl", "caster_fr", "caster_bl", "caster_br"}, {"leg", "caster_front"}, {"leg", "caster_back"},
               transformed(disc(disc_profile(.07, -.02, .02, .006), .07, 0, 16),
                           stand_on({x - in, .07, z - in}, {x - in + 1, .07, z - in})));
  bed.add("chassis", {"base", "chassis"},
          board({0, low - .02, 0}, f.width - 1.6 * in, f.length - 1.2 * in, .1, {6, 5, .02, .2}));
  if (struts)
    bed.add_four({"strut_fl", "strut_fr", "strut_bl", "strut_br"}, {"leg", "lift_strut_front"},
                 {"leg", "lift_strut_back"},
                 beam({x - .2, low, .45 * z}, {x - .2, lying - .04, .7 * z}, bar(.05, .03)));
  else
    bed.add_front_and_back({"column_f", "column_b"}, {"leg", "lift_strut_front"}, {"leg", "lift_strut_back"},
                           beam({0, low, .5 * z}, {0, lying - .04, .5 * z}, bar(.2, .2)));
  bed.add("board", {"base", "mattress_board"}, board({0, lying - .03, 0}, f.width, f.length - .06, .05));
  for (const auto& [stem, side] : {std::pair<std::string, double>{"head", -1}, {"foot", 1}})
    bed.add(stem + "_panel", {stem + "board", stem + "board_panel"},
            slab(flat({-x, lying - .08, side * z}, {2 * x, 0, 0}, {0, side < 0 ? .5 : .38, 0}), .04, {6, 5, .05, .3}));
  for (const auto& [stem, middle] : {std::pair<std::string, double>{"head", -.45}, {"foot", .4}})
    bed.add_pair({stem + "_guard_l", stem + "_guard_r"}, {"side_rail", ""}, {"side_rail", ""},
                 tube(bent({{x + .02, lying - .05, (middle - .3) * z},
                            {x + .02, lying + .3, (middle - .26) * z},
                            {x + .02, lying + .3, (middle + .26) * z},
                            {x + .02, lying - .05, (middle + .3) * z}},
                           .08),
                      round_section(.016, 8)));
  make_bed(bed, f, lying - .004, .13, 1, bedding, random);
  return bed;
}

/// Rails on posts around what lies high.
void add_guard_rails(Assembly& bed, const Bed_frame& f, double lying, int rails)
{
  const double x = f.x(), z = f.z();
  for (int i = 0; i < rails; ++i) {
    const double y = lying + .16 + .15 * i;
    const std::string number = std::to_string(i + 1);
    bed.add_pair({"guard_l" + number, "guard_r" + number}, {"side_rail", "guard_rail"},
                 beam({x, y, -z}, {x, y, z}, bar(.025, .07), 8));
    bed.add("head_rail" + number, {"headboard", ""}, beam({-x, y, -z}, {x, y, -z}, bar(.07, .025), 6));
    bed.add("foot_rail" + number, {"footboard", ""}, beam({-x, y, z}, {x, y, z}, bar(.07, .025), 6));
  }
}

/// Steps beside the foot that rise to the head, with drawers in them or not.
void add_stairs(Assembly& bed, const Bed_frame& f, double high, int steps, bool drawers)
{
  const double depth = .26, width = .42, z = f.z() + .035 + width / 2;
  for (int i = 0; i < steps; ++i) {
    const double height = high * (i + 1) / (steps + 1), x = f.x() - (i + .5) * depth;
    const std::string number = std::to_string(i + 1);
    bed.add("step_" + number, {"stairs", ""}, board({x, height / 2, z}, depth - .004, width, height, {5, 5, 0, .02}));
    if (drawers)
      bed.add("step_drawer_" + number, {"drawer", "stairs_drawer"},
              slab(flat({x - .4 * depth, height - .2, z + width / 2 + .006}, {.8 * depth, 0, 0}, {0, .15, 0}), .02,
                   {5, 5, 0, .2}));
  }
}

/// A bed on tall posts above a desk; stairs or a ladder lead to it.
Assembly loft_bed(const char* name, bool stairs, bool cabinet, Bedding bedding, std::uint64_t seed)
{
  Random random(seed);
  Assembly bed(name, "bed");
  const Bed_frame f = frame_of(1., 2.05, random);
  const double lying = random.about(1.4, .08), top = lying + .48, x = f.x(), z = f.z();
  add_bed_posts(bed, f, top, top, false);
  add_guard_rails(bed, f, lying, stairs ? 3 : 2);
  add_side_rails(bed, f, lying - .04, .15);
  bed.add("head_board", {"headboard", "headboard_rail"},
          beam({-x, lying - .04, -z}, {x, lying - .04, -z}, bar(.15, .03)));
  bed.add("foot_board", {"footboard", "footboard_rail"},
          beam({-x, lying - .04, z}, {x, lying - .04, z}, bar(.15, .03)));
  bed.add("board", {"base", "mattress_board"}, board({0, lying - .03, 0}, f.width - .03, f.length - .04, .03));
  make_bed(bed, f, lying - .012, .15, 1, bedding, random);
  const double desk = .73, depth = .55;
  bed.add("desk_top", {"desk", "desk_top"},
          board({-x + depth / 2, desk, 0}, depth, f.length - .05, .03, {6, 5, 0, .2}));
  if (cabinet) {
    bed.add("cabinet", {"cabinet", ""}, board({-x + depth / 2, .36, -z + .3}, depth - .06, .42, .7, {5, 5, 0, .02}));
    bed.add_row(numbered("drawer_", 3), {"drawer", ""},
                slab(flat({-x + depth - .02, .06, -z + .12}, {0, 0, .36}, {0, .17, 0}), .02, {5, 5, 0, .2}),
                {0, .21, 0});
  }
  bed.add("desk_side", {"desk", ""}, slab(flat({-x + .04, 0, .5 * z}, {depth - .1, 0, 0}, {0, desk - .012, 0}), .03));
  if (stairs)
    add_stairs(bed, f, lying, 4, cabinet);
  else
    add_ladder(bed, f, lying, true);
  return bed;
}

/// Two beds one above the other, made; the frame is one part, or posts and rails.
Assembly made_bunk(const char* name, bool in_one, Bedding bedding, std::uint64_t seed)
{
  Random random(seed);
  Assembly bed(name, "bed");
  const Bed_frame f = frame_of(1., 2.05, random);
  const double upper = random.about(1.2, .06), top = upper + .5, x = f.x(), z = f.z(), wood = .07, gap = .004;
  if (in_one) {
    Solid frame = beam({x, 0, z}, {x, top, z}, round_section(.5 * wood, 8), 3);
    const auto add = [&](const Solid& solid) { append(frame.mesh, solid.mesh); };
    for (const auto& [sx, sz] : {std::pair<double, double>{-1, 1}, {1, -1}, {-1, -1}})
      add(beam({sx * x, 0, sz * z}, {sx * x, top, sz * z}, round_section(.5 * wood, 8), 3));
    const double end_x = x - wood / 2 - gap, end_z = z - wood / 2 - gap;
    for (double y : {f.base, upper, top - .06})
      for (double side : {-1., 1.}) {
        add(beam({-end_x, y, side * z}, {end_x, y, side * z}, oval({.045, .015}, {.045, .015}, 8), 2));
        add(beam({side * x, y, -end_z}, {side * x, y, end_z}, oval({.015, .045}, {.015, .045}, 8), 2));
      }
    bed.add("frame", {"side_rail", "bed_frame"}, frame);
  } else {
    add_bed_posts(bed, f, top, top, false);
    for (const auto& [stem, y] : {std::pair<std::string, double>{"low", f.base}, {"up", upper}, {"guard", top - .06}})
      bed.add_pair({stem + "_l", stem + "_r"}, {"side_rail", "side_rail"},
                   beam({x, y, -z}, {x, y, z}, bar(.03, .1), 8));
    for (const auto& [stem, y] : {std::pair<std::string, double>{"low", f.base}, {"up", upper}}) {
      add_bed_end(bed, f, "head_" + stem, "headboard", Bed_end::slats, y, y + .45, -1);
      add_bed_end(bed, f, "foot_" + stem, "footboard", Bed_end::slats, y, y + .45, 1);
    }
    add_ladder(bed, f, upper, false);
  }
  make_bed(bed, f, f.base - .02, .2, 1, bedding, random, "_low");
  make_bed(bed, f, upper - .02, .2, 1, bedding, random, "_up");
  return bed;
}

/// Boards all around that reach near the ground, with drawers in one side or plinths under them.
Assembly boarded_bed(const char* name, double width, bool drawers, int pillows, Bedding bedding, std::uint64_t seed)
{
  Random random(seed);
  Assembly bed(name, "bed");
  const Bed_frame f = frame_of(width, 2.05, random);
  const double lying = random.about(.38), head = random.about(.95), foot = random.about(.7), x = f.x(), z = f.z();
  add_bed_posts(bed, f, head, foot, false);
  bed.add("head_panel", {"headboard", ""},
          slab(flat({-x, .1, -z}, {2 * x, 0, 0}, {0, head - .14, 0}), .025, {7, 6, .03, .2}));
  bed.add("foot_panel", {"footboard", ""},
          slab(flat({-x, .1, z}, {2 * x, 0, 0}, {0, foot - .14, 0}), .025, {7, 6, .03, .2}));
  bed.add_pair({"side_l", "side_r"}, {"side_rail", "side_rail"},
               slab(flat({x, .18, -z}, {0, 0, 2 * z}, {0, lying - .1, 0}), .025, {4, 7, 0, .2}));
  bed.add_pair({"plinth_l", "plinth_r"}, {"side_rail", "plinth"},
               beam({x - .03, .13, -z}, {x - .03, .13, z}, bar(.025, .12), 8));
  bed.add("board", {"base", "mattress_board"}, board({0, lying - .02, 0}, f.width - .02, f.length - .02, .03));
  if (drawers)
    bed.add_row({"drawer_1", "drawer_2", "drawer_3"}, {"drawer", ""},
                slab(flat({x + .014, .2, -.92 * z}, {0, 0, .58 * z}, {0, .16, 0}), .02, {5, 5, 0, .2}),
                {0, 0, .62 * z});
  make_bed(bed, f, lying - .002, random.between(.14, .2), pillows, bedding, random);
  return bed;
}

/// Ends of thick posts, with rails between them, that stand on the ground in place of legs.
Assembly post_ended_bed(const char* name, double width, bool footboard, int rails, Bedding bedding, std::uint64_t seed)
{
  Random random(seed);
  Assembly bed(name, "bed");
  const Bed_frame f = frame_of(width, 2.05, random);
  const double wood = random.between(.12, .2), lying = random.between(.15, .3), x = f.x() - wood / 2 + .04;
  const auto add_end = [&](const std::string& stem, double z, double high) {
    const Label label{stem + "board", ""};
    bed.add_pair({stem + "_post_l", stem + "_post_r"}, label, label, beam({x, 0, z}, {x, high, z}, bar(wood, wood)));
    for (int i = 0; i < rails; ++i) {
      const double y = high - .1 - i * .22;
      bed.add(stem + "_rail_" + std::to_string(i + 1), {stem + "board", stem + "board_rail"},
              beam({-x, y, z}, {x, y, z}, bar(.12, .5 * wood), 6));
    }
  };
  add_end("head", -f.z() - wood / 2, random.about(.85));
  if (footboard)
    add_end("foot", f.z() + wood / 2, random.about(.6));
  else
    bed.add_pair({"leg_l", "leg_r"}, {"leg", "leg"},
                 beam({x - .1, 0, f.z() - .15}, {x - .1, lying + .01, f.z() - .15}, bar(.12, .12)));
  bed.add("mattress", {"mattress", ""}, board({0, lying + .12, 0}, f.width, f.length + .02, .24, {7, 5, .02, .2}));
  const double top = lying + .24;
  bed.add_pair({"pillow_l", "pillow_r"}, {"pillow", "pillow"},
               board({.24 * f.width, top + .06, -f.z() + .3}, .4 * f.width, .36, .13, {6, 6, .1, .4}));
  add_bedding(bed, f, bedding, top, random);
  return bed;
}

/// An end of a metal bed: a bent tube with bars in it; in one part, or rails and bars.
void add_metal_end(Assembly& bed, const Bed_frame& f, const std::string& stem, double low, double high, double z,
                   bool in_one, double arch)
{
  const double x = f.x(), r = .016, gap = .02;
  const std::string coarse = stem + "board";
  const auto top_at = [&](double at) { return high + arch * (1 - at * at / (x * x)); };
  Path bow;
  constexpr int pieces = 12;
  for (int i = 0; i <= pieces; ++i) {
    const double at = x * (1 - 2. * i / pieces);
    bow.push_back({at, top_at(at), z});
  }
  const Solid top = tube(bow, round_section(r, 8)), rail = beam({-x, low, z}, {x, low, z}, round_section(r, 8), 6);
  const int n = std::max(3, int(2 * x / .18));
  const double step = 2 * x / (n + 1);
  const auto bar_at = [&](int i) {
    const double at = -x + (i + 1) * step, end = in_one ? r + gap : 0;
    return beam({at, low + end, z}, {at, top_at(at) - end, z}, round_section(.5 * r, 6), 3);
  };
  if (!in_one) {
    bed.add(stem + "_bow", {coarse, coarse + "_rail"}, top);
    bed.add(stem + "_rail", {coarse, coarse + "_mid_rail"}, rail);
    for (int i = 0; i < n; ++i)
      bed.add(stem + "_bar_" + std::to_string(i + 1), {coarse, ""}, bar_at(i));
    return;
  }
  Solid all = top;
  append(all.mesh, rail.mesh);
  for (int i = 0; i < n; ++i)
    append(all.mesh, bar_at(i).mesh);
  bed.add(stem + "_frame", {coarse, coarse + "_ornament"}, all);
}

Assembly metal_bed(const char* name, double width, bool in_one, int pillows, Bedding bedding, std::uint64_t seed)
{
  Random random(seed);
  Assembly bed(name, "bed");
  const Bed_frame f = frame_of(width, 2.05, random);
  const double lying = random.about(.4), head = random.about(1.05), foot = random.about(.75);
  add_bed_posts(bed, f, head + .03, foot + .03, true);
  add_metal_end(bed, f, "head", lying + .08, head, -f.z(), in_one, random.between(0, .2));
  add_metal_end(bed, f, "foot", lying + .05, foot, f.z(), in_one, random.between(0, .1));
  add_side_rails(bed, f, lying - .03, .06);
  bed.add("board", {"base", "mattress_board"}, board({0, lying - .02, 0}, f.width - .02, f.length - .04, .03));
  make_bed(bed, f, lying - .004, random.between(.15, .22), pillows, bedding, random);
  return bed;
}

/// A box with an upholstered panel at its head.
Assembly box_bed(const char* name, double width, int cushions, Bedding bedding, std::uint64_t seed)
{
  Random random(seed);
  Assembly bed(name, "bed");
  const Bed_frame f = frame_of(width, 2.1, random);
  const double lying = random.between(.22, .34), head = random.about(1.1), z = -f.z() - .03;
  bed.add("base", {"base", ""}, board({0, lying / 2, 0}, f.width, f.length, lying, {6, 6, 0, .05}));
  bed.add("head_frame", {"headboard", "headboard_frame"},
          slab(flat({-f.x() - .05, 0, z - .02}, {f.width + .1, 0, 0}, {0, head, 0}), .05, {6, 6, 0, .2}));
  const double part = f.width / cushions;
  bed.add_row(numbered("head_cushion_", cushions), {"headboard", "headboard_panel"},
              slab(flat({-f.x() + .01, lying + .1, z + .03}, {part - .02, 0, 0}, {0, head - lying - .14, 0}), .06,
                   {5, 5, .03, .35}),
              {part, 0, 0});
  make_bed(bed, f, lying - .002, random.between(.2, .3), 2, bedding, random);
  return bed;
}

} // namespace

std::vector<Assembly> bed_kinds(std::uint64_t seed)
{
  using B = Bedding;
  return {day_bed("bed_day_bars", false, false, seed),
          day_bed("bed_day_panels", true, true, seed + 1),
          hospital_bed("bed_hospital", true, B::blanket, seed + 2),
          hospital_bed("bed_hospital_columns", false, B::fold, seed + 3),
          loft_bed("bed_loft_stairs", true, true, B::none, seed + 4),
          loft_bed("bed_loft_ladder", false, false, B::blanket, seed + 5),
          made_bunk("bed_bunk_frame", true, B::fold, seed + 6),
          made_bunk("bed_bunk_made", false, B::blanket, seed + 7),
          boarded_bed("bed_boarded", 1., false, 1, B::blanket, seed + 8),
          boarded_bed("bed_boarded_drawers", 1.5, true, 2, B::fold, seed + 9),
          boarded_bed("bed_boarded_bare", 1., true, 0, B::none, seed + 10),
          post_ended_bed("bed_posts", 1., true, 1, B::band, seed + 11),
          post_ended_bed("bed_posts_double", 1.7, false, 2, B::band, seed + 12),
          metal_bed("bed_metal", 1.4, false, 1, B::blanket, seed + 13),
          metal_bed("bed_metal_frames", 1., true, 1, B::fold, seed + 14),
          metal_bed("bed_metal_double", 1.6, true, 2, B::blanket, seed + 15),
          box_bed("bed_upholstered", 1.6, 3, B::blanket, seed + 16),
          box_bed("bed_upholstered_single", 1., 1, B::fold, seed + 17)};
}

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
