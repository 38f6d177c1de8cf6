// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sofa_kinds.h"

#include "../chairs.h"
#include "random.h"

#include <cmath>
#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {
namespace {

const Slab_options soft_edges = {6, 6, .04, .35}, firm_edges = {6, 6, .01, .15};

/// Measures of a sofa, varied.
struct Measures
{
  double width, depth, seat, arm, back, arm_width, cushion;

  Measures(Random& random, int seats)
      : width(random.between(.58, .72) * seats + .36),
        depth(random.about(.88, .08)),
        seat(random.about(.43, .08)),
        arm(random.about(.6, .1)),
        back(random.about(.82, .1)),
        arm_width(random.between(.1, .2)),
        cushion(random.between(.13, .18))
  {}

  double x() const { return width / 2; }
  double z() const { return depth / 2; }
  double inner() const { return x() - arm_width; } ///< half of the width between the arms
};

/// "right", "center" and "left", as cushions are called from the right to the left.
std::string place(int i, int n)
{
  if (n == 1) return "";
  return i == 0 ? "_right" : i == n - 1 ? "_left" : "_center";
}

/// Seats side by side between the arms, from the back to `front`.
void add_seats(Assembly& sofa, const Measures& m, int n, double back, double front, const std::string& coarse,
               double top, double thickness)
{
  const double width = 2 * m.inner() / n;
  for (int i = 0; i < n; ++i)
    sofa.add(coarse + "_" + std::to_string(i + 1),
             {coarse, n == 1 ? "" : (coarse == "base" ? "base_cushion" : coarse) + place(i, n)},
             board({-m.inner() + (i + .5) * width, top - thickness / 2, (back + front) / 2}, width - .008, front - back,
                   thickness - .004, soft_edges));
}

/// Cushions that lean on the back, side by side, from `low` to `high`.
void add_back_cushions(Assembly& sofa, const Measures& m, const std::string& stem, int n, double z, double low,
                       double high, double lean)
{
  const double width = 2 * m.inner() / n;
  for (int i = 0; i < n; ++i) {
    const double right = -m.inner() + i * width;
    sofa.add(stem + "_" + std::to_string(i + 1), {"back", stem + place(i, n)},
             slab(flat({right + .004, low, z}, {width - .008, 0, 0}, {0, high - low, -lean}), .14, soft_edges));
  }
}

void add_legs(Assembly& sofa, const Measures& m, double height, bool turned)
{
  const double x = m.x() - .07, z = m.z() - .07;
  sofa.add_four({"leg_fl", "leg_fr", "leg_bl", "leg_br"}, leg_label("front"), leg_label("back"),
                turned ? turned_leg({x, 0, z}, {x - .01, height + .004, z - .01}, .03)
                       : beam({x, 0, z}, {x, height + .004, z}, bar(.05, .05)));
}

void add_arms(Assembly& sofa, const Measures& m, double low, double from, double to)
{
  sofa.add_pair({"arm_l", "arm_r"}, {"armrest", "armrest"},
                slab(flat({m.x() - m.arm_width / 2, low, from}, {0, m.arm - low, 0}, {0, 0, to - from}), m.arm_width,
                     soft_edges));
}

void add_pillows(Assembly& sofa, const Measures& m, int n, double z, double size)
{
  for (int i = 0; i < n; ++i) {
    const double x = n == 1 ? .3 * m.inner() : m.inner() * (1.5 * i / (n - 1) - .75);
    sofa.add(
        "pillow_" + std::to_string(i + 1), {"cushion", ""},
        slab(flat({x - size / 2, m.seat - .004, z}, {size, 0, 0}, {0, .9 * size, -.3 * size}), .12, {6, 6, .08, .4}));
  }
}

/// Two wings at a right angle: base, back and seats of each; the left one reaches to the front.
Assembly corner_sofa(const char* name, int seats, bool arms, int pillows, std::uint64_t seed)
{
  Random random(seed);
  Assembly sofa(name, "sofa");
  const Measures m(random, seats);
  const double low = arms ? random.between(.06, .14) : 0, under = m.seat - m.cushion, t = .2, wing = m.depth * .9;
  const double reach = random.between(.6, 1.1), x = m.x(), z = m.z();
  sofa.add("base_main", {"base", "base_main"},
           board({-wing / 2, (low + under) / 2, 0}, m.width - wing - .004, m.depth, under - low, firm_edges));
  sofa.add("base_wing", {"base", "base_chaise"},
           board({x - wing / 2, (low + under) / 2, reach / 2}, wing, m.depth + reach, under - low, firm_edges));
  sofa.add("back_main", {"back", "back_frame"},
           slab(flat({-x, under - .002, -z + t / 2}, {m.width, 0, 0}, {0, m.back - under, -.05}), t, soft_edges));
  sofa.add("back_wing", {"back", "back_frame"},
           slab(flat({x - t / 2, under - .002, -z + t}, {0, 0, m.depth + reach - t}, {0, m.back - under, 0}), t,
                soft_edges));
  const double width = (m.width - wing) / (seats - 1), side = arms ? m.arm_width / (seats - 1) : 0;
  for (int i = 0; i < seats - 1; ++i)
    sofa.add("seat_" + std::to_string(i + 1), {"seat", "seat_main"},
             board({x - wing - (i + .5) * (width - side), m.seat - m.cushion / 2, t / 2}, width - side - .008,
                   m.depth - t, m.cushion - .004, soft_edges));
  sofa.add("seat_wing", {"seat", "seat_chaise"},
           board({x - t / 2 - wing / 2, m.seat - m.cushion / 2, (t + reach) / 2}, wing - t - .008,
                 m.depth + reach - t - .01, m.cushion - .004, soft_edges));
  if (arms) {
    sofa.add("arm", {"armrest", ""},
             slab(flat({-x + m.arm_width / 2, under - .002, -z + t}, {0, m.arm - under, 0}, {0, 0, m.depth - t}),
                  m.arm_width, soft_edges));
    for (const auto& [leg, at] : {std::pair<std::string, Point_2>{"leg_1", {-x + .08, z - .08}},
                                  {"leg_2", {-x + .08, .08 - z}},
                                  {"leg_3", {x - .08, .08 - z}},
                                  {"leg_4", {x - .08, z + reach - .08}},
                                  {"leg_5", {x - wing + .08, z + reach - .08}}})
      sofa.add(leg, {"leg", ""}, beam({at.x(), 0, at.y()}, {at.x(), low + .004, at.y()}, bar(.05, .05)));
  }
  add_pillows(sofa, m, pillows, -z + t + .14, .38);
  return sofa;
}

/// Cushions within a frame of tubes that run around arms and back; cushions below those one sits on.
Assembly tube_sofa(const char* name, int seats, bool base_cushions, int pillows, std::uint64_t seed)
{
  Random random(seed);
  Assembly sofa(name, "sofa");
  const Measures m(random, seats);
  const double x = m.x() + .03, z = m.z(), r = .016, low = .14, t = .16;
  const double y = m.arm;
  sofa.add("frame", {"leg", "leg_frame"},
           tube(bent({{x, 0, z}, {x, y, z}, {x, y, -z - .03}, {-x, y, -z - .03}, {-x, y, z}, {-x, 0, z}}, .06),
                round_section(r, 8)));
  sofa.add_pair({"leg_bl", "leg_br"}, leg_label("back"), beam({x, 0, -z}, {x, y, -z}, round_section(r, 8)));
  sofa.add("rail", {"base", "rail_ring"},
           tube(bent({{x, low, 0}, {x, low, z}, {-x, low, z}, {-x, low, -z}, {x, low, -z}, {x, low, -.02}}, .05),
                round_section(r, 8)));
  sofa.add("support", {"base", "support"}, board({0, low + .025, 0}, 2 * x, m.depth - .02, .03, firm_edges));
  double seat_low = low + .04;
  if (base_cushions) {
    const double top = .5 * (seat_low + m.seat);
    add_seats(sofa, m, seats, -z + t, z, "base", top, top - seat_low);
    seat_low = top;
  }
  add_seats(sofa, m, seats, -z + t, z, "seat", m.seat, m.seat - seat_low);
  add_arms(sofa, m, low + .038, -z + .02, z - .02);
  sofa.add("back", {"back", ""},
           slab(flat({-m.inner() + .004, low + .038, -z + t / 2}, {2 * m.inner() - .008, 0, 0},
                     {0, m.back - low - .1, -.02}),
                t, soft_edges));
  add_pillows(sofa, m, pillows, -z + t + .14, .38);
  return sofa;
}

/// Cushions on a wooden platform on legs, with arms of bars or none.
Assembly platform_sofa(const char* name, int seats, bool frame_arms, int back_cushions, int pillows, std::uint64_t seed)
{
  Random random(seed);
  Assembly sofa(name, "sofa");
  const Measures m(random, seats);
  const double under = m.seat - m.cushion, x = m.x(), z = m.z(), wood = .05;
  sofa.add("platform", {"base", "platform"}, board({0, under - .03, 0}, m.width, m.depth, .06, firm_edges));
  add_legs(sofa, m, under - .06, random.below(2) == 0);
  add_seats(sofa, m, seats, -z + .08, z - .02, "seat", m.seat, m.cushion);
  if (back_cushions > 0) {
    sofa.add("back_rail", {"back", "back_frame"},
             slab(flat({-x, under - .002, -z + .03}, {2 * x, 0, 0}, {0, m.back - under - .12, -.08}), .04, firm_edges));
    add_back_cushions(sofa, m, "back_cushion", back_cushions, -z + .13, m.seat + .002, m.back,
                      random.between(.06, .12));
  } else
    sofa.add("back", {"back", ""},
             slab(flat({-x, under - .002, -z + .08}, {2 * x, 0, 0}, {0, m.back - under, -.1}), .15, soft_edges));
  if (frame_arms)
    sofa.add_pair({"arm_l", "arm_r"}, {"armrest", "armrest"},
                  tube(bent({{x - .04, under - .01, z - .08},
                             {x - .04, m.arm, z - .08},
                             {x - .04, m.arm, -z + .16},
                             {x - .04, under - .01, -z + .16}},
                            .05),
                       bar(wood, wood)));
  add_pillows(sofa, m, pillows, -z + .36, .36);
  return sofa;
}

/// Arms from the ground up, the seat between them, a back of one or two pieces.
Assembly block_sofa(const char* name, int seats, bool split_back, bool base, int pillows, std::uint64_t seed)
{
  Random random(seed);
  Assembly sofa(name, "sofa");
  const Measures m(random, seats);
  const double z = m.z(), t = .2, under = base ? m.seat - m.cushion : 0, middle = .5 * (m.seat + m.back);
  add_arms(sofa, m, 0, -z, z);
  if (base)
    sofa.add("base", {"base", ""}, board({0, .5 * under, t / 2}, 2 * m.inner() - .008, m.depth - t, under, firm_edges));
  if (base)
    add_seats(sofa, m, seats, -z + t, z + .02, "seat", m.seat, m.cushion);
  else
    sofa.add("seat", {"seat", ""},
             board({0, .5 * m.seat, t / 2}, 2 * m.inner() - .008, m.depth - t, m.seat, firm_edges));
  const double right = -m.inner() + .004, width = 2 * m.inner() - .008;
  if (split_back) {
    sofa.add("back_lower", {"back", "back_lower"},
             slab(flat({right, 0, -z + t / 2}, {width, 0, 0}, {0, middle, 0}), t, soft_edges));
    sofa.add(
        "back_upper", {"back", "back_upper"},
        slab(flat({right, middle + .002, -z + t / 2 - .02}, {width, 0, 0}, {0, m.back - middle, -.03}), t, soft_edges));
  } else
    sofa.add("back", {"back", ""}, slab(flat({right, 0, -z + t / 2}, {width, 0, 0}, {0, m.back, 0}), t, soft_edges));
  add_pillows(sofa, m, pillows, -z + t + .14, .36);
  return sofa;
}

/// Rolls along arms and back, on turned legs.
Assembly rolled_sofa(const char* name, int seats, std::uint64_t seed)
{
  Random random(seed);
  Assembly sofa(name, "sofa");
  const Measures m(random, seats);
  const double low = random.between(.08, .14), under = m.seat - m.cushion, z = m.z(), r = random.between(.07, .1),
               t = .16;
  add_legs(sofa, m, low, true);
  sofa.add("base", {"base", ""}, board({0, .5 * (low + under), 0}, m.width, m.depth, under - low, firm_edges));
  add_arms(sofa, m, under - .002, -z + .02, z - .02);
  sofa.add_pair(
      {"roll_l", "roll_r"}, {"armrest", "arm_roll"},
      beam({m.x() - .3 * m.arm_width, m.arm, -z + .02}, {m.x() - .3 * m.arm_width, m.arm, z}, round_section(r, 14), 6));
  sofa.add(
      "back", {"back", ""},
      slab(flat({-m.inner() + .004, under - .002, -z + t / 2}, {2 * m.inner() - .008, 0, 0}, {0, m.back - under, -.04}),
           t, soft_edges));
  sofa.add("back_roll", {"back", "back_roll"},
           beam({-m.inner(), m.back, -z + .04}, {m.inner(), m.back, -z + .04}, round_section(.9 * r, 14), 8));
  add_seats(sofa, m, seats, -z + t, z - .01, "seat", m.seat, m.cushion);
  return sofa;
}

/// Two rows of cushions against the back.
Assembly high_back_sofa(const char* name, int seats, int pillows, std::uint64_t seed)
{
  Random random(seed);
  Assembly sofa(name, "sofa");
  Measures m(random, seats);
  m.back += .14;
  const double low = random.between(.04, .1), under = m.seat - m.cushion, z = m.z(), t = .14,
               middle = .45 * m.seat + .55 * m.back;
  add_legs(sofa, m, low, false);
  sofa.add("base", {"base", ""}, board({0, .5 * (low + under), 0}, m.width, m.depth, under - low, firm_edges));
  add_arms(sofa, m, under - .002, -z, z);
  sofa.add("frame", {"back", "back_frame"},
           slab(flat({-m.inner() + .004, under - .002, -z + t / 2}, {2 * m.inner() - .008, 0, 0},
                     {0, m.back - under - .1, 0}),
                t, firm_edges));
  add_seats(sofa, m, seats, -z + t, z, "seat", m.seat, m.cushion);
  add_back_cushions(sofa, m, "lower_back_cushion", seats, -z + t + .1, m.seat + .002, middle, .03);
  add_back_cushions(sofa, m, "upper_back_cushion", seats, -z + t + .07, middle + .004, m.back, .03);
  add_pillows(sofa, m, pillows, -z + t + .3, .34);
  return sofa;
}

/// A low body with a rim at its back and sides, and cushions that lie loose on it.
Assembly loose_cushions(const char* name, int seats, bool mats, bool rim, int pillows, std::uint64_t seed)
{
  Random random(seed);
  Assembly sofa(name, "sofa");
  Measures m(random, seats);
  m.depth += .15;
  if (mats) m.seat = m.cushion + .22;
  const double x = m.x(), z = m.z(), under = mats ? m.seat - m.cushion : m.seat, t = .16;
  Solid body = board({0, .5 * under - .004, 0}, m.width, m.depth, under - .008, firm_edges);
  if (rim) { // parts of the body that do not touch it
    append(body.mesh,
           slab(flat({-x, under + .002, -z + t / 2}, {m.width, 0, 0}, {0, m.arm - under, 0}), t, firm_edges).mesh);
    for (double side : {-1., 1.})
      append(body.mesh, slab(flat({side * (x - t / 2), under + .002, -z + t + .006}, {0, 0, m.depth - t - .006},
                                  {0, m.arm - under, 0}),
                             t, firm_edges)
                            .mesh);
  }
  sofa.add("body", {"base", "body"}, body);
  m.arm_width = rim ? t + .01 : .02;
  if (mats) add_seats(sofa, m, seats, -z + t + .01, z, "seat", m.seat, m.cushion);
  add_pillows(sofa, m, pillows, -z + t + .2, random.between(.36, .46));
  return sofa;
}

} // namespace

std::vector<Assembly> sofa_kinds(std::uint64_t seed)
{
  return {corner_sofa("sofa_corner", 3, true, 0, seed),
          corner_sofa("sofa_corner_wide", 4, true, 2, seed + 1),
          corner_sofa("sofa_corner_low", 3, false, 3, seed + 2),
          tube_sofa("sofa_tubes", 3, true, 2, seed + 3),
          tube_sofa("sofa_tubes_two", 2, false, 0, seed + 4),
          tube_sofa("sofa_tubes_armchair", 1, true, 0, seed + 5),
          platform_sofa("sofa_platform", 2, true, 2, 0, seed + 6),
          platform_sofa("sofa_platform_open", 3, false, 0, 2, seed + 7),
          platform_sofa("sofa_platform_three", 3, true, 3, 2, seed + 8),
          block_sofa("sofa_block_armchair", 1, true, false, 0, seed + 9),
          block_sofa("sofa_block", 2, false, true, 2, seed + 10),
          block_sofa("sofa_block_split", 3, true, true, 0, seed + 11),
          rolled_sofa("sofa_rolled", 3, seed + 12),
          rolled_sofa("sofa_rolled_armchair", 1, seed + 13),
          high_back_sofa("sofa_high_back", 2, 2, seed + 14),
          high_back_sofa("sofa_high_back_three", 3, 0, seed + 15),
          loose_cushions("sofa_loose", 3, false, true, 5, seed + 16),
          loose_cushions("sofa_mats", 4, true, true, 0, seed + 17)};
}

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
