// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sofa_designs.h"

#include "../chairs.h"
#include "random.h"

#include <algorithm>
#include <functional>
#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {
namespace {

enum class Sofa_body { parts, shell, one_piece };

struct Sofa_design
{
  const char* name;
  Sofa_body body;
  int seats = 3;         ///< cushions side by side
  int back_cushions = 0; ///< 0: none but the back itself
  int pillows = 0;
  bool legs = true;
  bool chaise = false; ///< the left seat reaches far to the front
};

struct Sofa_frame
{
  double width, depth, low, seat, arm, back, thickness, arm_width;

  Sofa_frame(const Sofa_design& design, Random& random)
      : width(random.between(.6, .75) * design.seats + .3),
        depth(random.about(.88)),
        low(design.legs ? random.between(.08, .2) : 0),
        seat(random.about(.44, .08)),
        arm(random.about(.62)),
        back(random.about(.84)),
        thickness(random.between(.12, .2)),
        arm_width(random.between(.1, .22))
  {}

  double x() const { return width / 2; }
  double z() const { return depth / 2; }
  double under_cushions() const { return seat - cushion; }
  double inner_width() const { return width - 2 * arm_width; }
  double seat_back() const { return thickness - z(); } ///< where seats begin
  static constexpr double cushion = .15;
};

const Slab_options soft = {6, 6, .04, .35};

/// Of one to three cushions, from the right; the left one of a chaise longue has a name of its own.
Names side_names(int n, bool chaise)
{
  const std::string left = chaise ? "chaise" : "left";
  if (n == 1) return {""};
  if (n == 2) return {chaise ? "main" : "right", left};
  return {"right", "center", left};
}

/// Cushions side by side from the right, across the width between the arms.
void add_cushions(Assembly& sofa, const Sofa_frame& f, const std::string& stem, const Label& label, int n, bool chaise,
                  const std::function<Solid(double x, double width)>& cushion)
{
  const Names sides = side_names(n, chaise);
  const std::string name = label.fine.empty() ? label.coarse : label.fine;
  const double width = f.inner_width() / n;
  for (int i = 0; i < n; ++i) {
    const std::string fine = n == 1 ? label.fine : name + "_" + sides[std::size_t(i)];
    sofa.add(stem + "_" + std::to_string(i + 1), {label.coarse, fine}, cushion(width * (i + .5 - n / 2.), width - .01));
  }
}

/// Around the seat from the front on one side to the front on the other; the arms are lower than the back, and what is
/// within closes the front if it is high enough.
Solid seat_shell(const Sofa_frame& f, double low, double front, double floor)
{
  struct Corner
  {
    double x, z, height;
  };
  const double x = f.x(), z = f.z(), step = .02;
  const auto ring = [&](double inset, double back_inset, const std::function<double(double)>& height) {
    const double a = x - inset, b = z - back_inset, c = z - (inset > 0 ? std::min(inset, .06) : 0);
    const Corner corners[] = {
        {a, c, front},         {a, c - step, f.arm},      {a, .5 * (c - b), f.arm}, {a, step - b, f.arm},
        {a, -b, f.back},       {.5 * a, -b, f.back},      {-.5 * a, -b, f.back},    {-a, -b, f.back},
        {-a, step - b, f.arm}, {-a, .5 * (c - b), f.arm}, {-a, c - step, f.arm},    {-a, c, front},
        {-.5 * a, c, front},   {.5 * a, c, front}};
    Path result;
    for (const Corner& corner : corners)
      result.push_back({corner.x, height(corner.height), corner.z});
    return result;
  };
  const auto at = [](double y) { return [y](double) { return y; }; };
  const auto top = [](double y) { return y; };
  const Mesh mesh = loft({ring(0, 0, at(low)), ring(0, 0, top), ring(f.arm_width, f.thickness, top),
                          ring(f.arm_width, f.thickness, at(floor))});
  return {mesh, Kind::curve, line({-x, f.seat, 0}, {x, f.seat, 0})};
}

/// The back and both arms, bent around the seat.
Solid back_and_arms(const Sofa_frame& f, double low)
{
  const double x = f.x() - f.thickness / 2, back = f.thickness / 2 - f.z(), front = f.z() - .02;
  const auto surface = [=](double u, double v) {
    const Path plan = bent({{x, 0, front}, {x, 0, back}, {-x, 0, back}, {-x, 0, front}}, .25);
    const Point p = point_at(plan, v);
    const double rise = std::clamp((.1 - p.z()) / .4, 0., 1.); // towards the back
    const double high = f.arm + (f.back - f.arm) * rise;
    return Point(p.x(), low + u * (high - low), p.z());
  };
  return slab(surface, f.thickness * .9, {6, 24, 0, .3});
}

Assembly sofa(const Sofa_design& design, std::uint64_t seed)
{
  Random random(seed);
  Sofa_frame f(design, random);
  Assembly result(design.name, "sofa");
  const double under = f.under_cushions(), seat_depth = f.z() - f.seat_back();
  if (design.legs) {
    const double inset = design.body == Sofa_body::shell ? .1 : .08;
    const Point foot(f.x() - inset, 0, f.z() - inset), head(f.x() - inset - .02, f.low + .01, f.z() - inset - .02);
    result.add_four({"leg_fl", "leg_fr", "leg_bl", "leg_br"}, leg_label("front"), leg_label("back"),
                    random.below(2) == 0 ? turned_leg(foot, head, .028) : beam(foot, head, bar(.05, .05)));
  }
  const auto add_base = [&] {
    result.add("base", {"base", ""},
               board({0, (f.low + under) / 2, 0}, design.body == Sofa_body::shell ? f.inner_width() : f.width,
                     f.depth - .02, under - f.low, {6, 6, .01, .1}));
  };
  switch (design.body) {
  case Sofa_body::one_piece:
    result.add("body", {"base", "body"}, seat_shell(f, f.low, under, under - .02));
    break;
  case Sofa_body::shell:
    result.add("shell", {"back", "back_arm_shell"}, back_and_arms(f, f.low));
    add_base();
    break;
  case Sofa_body::parts:
    add_base();
    result.add("back", {"back", design.back_cushions > 0 ? "back_frame" : ""},
               slab(
                   [&](double u, double v) {
                     return Point((2 * v - 1) * f.x(), under + u * (f.back - under), f.thickness / 2 - f.z() - .06 * u);
                   },
                   f.thickness, soft));
    result.add_pair(
        {"arm_l", "arm_r"}, {"armrest", "armrest"},
        slab(flat({f.x() - f.arm_width / 2, under + .004, f.seat_back()}, {0, f.arm - under, 0}, {0, 0, seat_depth}),
             f.arm_width, soft));
  }
  add_cushions(result, f, "seat", {"seat", ""}, design.seats, design.chaise, [&](double x, double width) {
    const bool is_chaise = design.chaise && x > 0 && x + width > f.inner_width() / 2;
    const double more = is_chaise ? .7 : 0;
    return board({x, f.seat - f.cushion / 2 + .002, (f.seat_back() + f.z() + more) / 2}, width, seat_depth + more,
                 f.cushion, soft);
  });
  if (design.chaise)
    result.add("chaise", {"base", "base_chaise"},
               board({f.inner_width() / 2 * (1 - 1. / design.seats), (f.low + under) / 2, f.z() + .35},
                     f.inner_width() / design.seats, .7, under - f.low, {6, 6, .01, .1}));
  if (design.back_cushions > 0)
    add_cushions(result, f, "back_cushion", {"back", "back_cushion"}, design.back_cushions, false,
                 [&](double x, double width) {
                   const double lean = random.between(.06, .14), rise = f.back - f.seat - random.between(-.05, .1);
                   return slab(
                       [=](double u, double v) {
                         return Point(x + (v - .5) * width, f.seat + .01 + u * rise, f.seat_back() + .08 - lean * u);
                       },
                       .15, soft);
                 });
  for (int i = 0; i < design.pillows; ++i) {
    const double side = i % 2 == 0 ? 1 : -1, x = side * (f.inner_width() / 2 - .22 - .3 * (i / 2));
    const double size = random.between(.32, .45), z = f.seat_back() + (design.back_cushions > 0 ? .26 : .12);
    result.add("pillow_" + std::to_string(i + 1), {"cushion", ""},
               slab(flat({x - size / 2, f.seat - .005, z + .06}, {size, 0, 0}, {0, .95 * size, -.25 * size}), .12,
                    {6, 6, .06, .4}));
  }
  return result;
}

const std::vector<Sofa_design>& sofa_designs()
{
  using B = Sofa_body;
  static const std::vector<Sofa_design> designs{{"sofa_plain", B::parts, 3},
                                                {"sofa_cushions", B::parts, 3, 3},
                                                {"sofa_two_seats", B::parts, 2, 2},
                                                {"sofa_pillows", B::parts, 2, 2, 2},
                                                {"sofa_on_floor", B::parts, 3, 2, 4, false},
                                                {"sofa_armchair", B::parts, 1},
                                                {"sofa_chaise", B::parts, 3, 3, 0, true, true},
                                                {"sofa_chaise_two", B::parts, 2, 2, 0, true, true},
                                                {"sofa_body_chaise", B::one_piece, 2, 3, 1, false, true},
                                                {"sofa_shell", B::shell, 2, 2},
                                                {"sofa_shell_three", B::shell, 3, 3, 2},
                                                {"sofa_tub_chair", B::shell, 1},
                                                {"sofa_shell_plain", B::shell, 1, 1, 1},
                                                {"sofa_body", B::one_piece, 3, 3, 0, false},
                                                {"sofa_body_pillows", B::one_piece, 2, 2, 2, true},
                                                {"sofa_body_armchair", B::one_piece, 1, 1, 1, false},
                                                {"sofa_body_one_back", B::one_piece, 1, 1, 2, true}};
  return designs;
}

} // namespace

std::vector<Assembly> sofas(std::uint64_t seed) { return shapes_of(sofa_designs(), seed, sofa); }

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
