// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cycle_designs.h"

#include "random.h"
#include "velocipede_designs.h"

#include <cmath>
#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {
namespace {

enum class Wheel { spokes, rods, disc };
enum class Frame_cut { tubes, stays_in_pairs, main_and_stays, one_piece };
enum class Fork_cut { blades, one_piece };
enum class Crank_cut { parts, sides, one_piece };
enum class Steering { flat, drop, swept, high, halves };

struct Cycle_design
{
  const char* name;
  Frame_cut frame;
  Fork_cut fork;
  Steering steering;
  Crank_cut cranks = Crank_cut::parts;
  Wheel wheels = Wheel::spokes;
  double radius = .335, tyre = .018;
  bool step_through = false, brakes = false, mudguards = false, chain = true, grips = true;
};

/// Solids that do not touch, as one part.
Solid joined(const std::vector<Solid>& solids)
{
  Solid result = solids.at(0);
  for (std::size_t i = 1; i < solids.size(); ++i)
    append(result.mesh, solids[i].mesh);
  return result;
}

/// A straight tube that begins and ends short of where others meet it.
Solid short_beam(const Point& from, const Point& to, double start, double end, const Section& section)
{
  const Point along = (to - from).normalized();
  return beam(from + start * along, to - end * along, section, 3);
}

/// Tyre, spokes and hub in one part.
Solid whole_wheel(const Point& axle, double radius, double tyre_radius, Wheel kind, double half_axle)
{
  constexpr double gap = .003, hub_radius = .016, wire_start = .024, rod = .008;
  const Solid hub = along_x(hub_profile(half_axle, hub_radius, .024), axle);
  const double inner = radius - tyre_radius - gap;
  const Solid rim = tyre(axle, radius, tyre_radius, 32);
  if (kind == Wheel::disc) { // thick within the tyre
    const Profile profile{{0, -half_axle}, {.02, -half_axle},  {.022, -.02}, {.5 * inner, -.012}, {inner, -.008},
                          {inner, .008},   {.5 * inner, .012}, {.022, .02},  {.02, half_axle},    {0, half_axle}};
    return joined({rim, transformed(disc(profile, inner, 0, 20), stand_on(axle, axle + Point::UnitX()))});
  }
  if (kind == Wheel::spokes) return joined({rim, spokes(axle, wire_start, inner, .02, 16), hub});
  std::vector<Solid> solids{rim, hub};
  constexpr int n = 5;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * pi * i / n;
    const Point out(0, std::sin(a), std::cos(a));
    solids.push_back(beam(axle + (hub_radius + rod) * out, axle + (inner - rod) * out, round_section(rod, 8)));
  }
  return joined(solids);
}

void add_whole_wheel(Assembly& shape, const std::string& where, const Point& axle, double radius, double tyre_radius,
                     Wheel kind, double half_axle = .06)
{
  shape.add("wheel_" + where, {"wheel", "wheel_" + where}, whole_wheel(axle, radius, tyre_radius, kind, half_axle));
}

/// Both arms from one point in the plane of symmetry, in one tube.
Solid wishbone(const Path& left_half, const Section& section) { return tube(with_mirror_image(left_half), section); }

/// Both stays of one sort, from the seat cluster or the bracket to the rear axle.
Solid stays(const Point& middle, const Point& end)
{
  return wishbone(bent({middle, middle + Point(.042, 0, 0), end}, .02, 2), round_section(.008, 8));
}

/// The tubes of a frame; those that are in one part with others end short of them.
struct Frame_tubes
{
  Solid head_tube, top_tube, down_tube, seat_tube, bottom_bracket, seat_stays, chain_stays;

  Frame_tubes(const Frame_joints& at, bool step_through, bool in_one)
  {
    const double at_head = in_one ? .038 : 0, at_bracket = in_one ? .05 : 0, at_cluster = in_one ? .034 : 0;
    const Point shell(.036, 0, 0), low = between(at.bracket, at.cluster, .45);
    head_tube = beam(at.head_low, at.head_high, round_section(.02), 3);
    top_tube =
        short_beam(between(at.head_low, at.head_high, step_through ? .7 : .8),
                   step_through ? low : Point(at.cluster - Point(0, .02, 0)), at_head, at_cluster, round_section(.013));
    down_tube =
        short_beam(between(at.head_low, at.head_high, .15), at.bracket, at_head, at_bracket, round_section(.015));
    seat_tube = short_beam(at.bracket, at.cluster, at_bracket, 0, round_section(.015));
    bottom_bracket = beam(at.bracket - shell, at.bracket + shell, round_section(.022, 12), 3);
    const Point high = at.cluster + Point(0, -.05, in_one ? -.016 : -.012),
                near = at.bracket + Point(0, .01, in_one ? -.05 : -.02);
    seat_stays = stays(high, at.rear_axle + Point(.06, .011, .002));
    chain_stays = stays(near, at.rear_axle + Point(.06, -.01, .004));
  }

  std::vector<Solid> main_tubes() const { return {head_tube, top_tube, down_tube, seat_tube, bottom_bracket}; }
};

void add_frame(Assembly& bike, const Frame_joints& at, Frame_cut cut, bool step_through)
{
  const Frame_tubes tubes(at, step_through, cut == Frame_cut::main_and_stays || cut == Frame_cut::one_piece);
  if (cut == Frame_cut::one_piece) {
    std::vector<Solid> all = tubes.main_tubes();
    all.push_back(tubes.seat_stays);
    all.push_back(tubes.chain_stays);
    bike.add("frame", {"frame", "frame"}, joined(all));
    return;
  }
  if (cut == Frame_cut::main_and_stays)
    bike.add("frame", {"frame", "frame"}, joined(tubes.main_tubes()));
  else {
    bike.add("head_tube", {"frame", "head_tube"}, tubes.head_tube);
    bike.add("top_tube", {"frame", "top_tube"}, tubes.top_tube);
    bike.add("down_tube", {"frame", "down_tube"}, tubes.down_tube);
    bike.add("seat_tube", {"frame", "seat_tube"}, tubes.seat_tube);
    bike.add("bottom_bracket", {"frame", "bottom_bracket"}, tubes.bottom_bracket);
  }
  if (cut == Frame_cut::tubes) {
    add_stays(bike, at);
    return;
  }
  bike.add("seat_stays", {"frame", "seat_stays"}, tubes.seat_stays);
  bike.add("chain_stays", {"frame", "chain_stays"}, tubes.chain_stays);
}

/// The bars of a bicycle; `high` and `halves` are those that add_handlebar() does not have.
void add_steering(Assembly& bike, const Frame_joints& at, Steering kind, bool grips)
{
  if (kind != Steering::high && kind != Steering::halves) {
    add_handlebar(bike, "", at.head_high, at.steer,
                  kind == Steering::flat   ? Bars::flat
                  : kind == Steering::drop ? Bars::drop
                                           : Bars::swept,
                  kind == Steering::swept ? .02 : .08);
    return;
  }
  const Point clamp = at.head_high + .07 * at.steer + Point(0, 0, .04);
  const auto from_clamp = [&](double x, double y, double z) { return Point(clamp + Point(x, y, z)); };
  const bool is_high = kind == Steering::high;
  const Path half =
      is_high
          ? bent({from_clamp(0, 0, 0), from_clamp(.1, .01, 0), from_clamp(.17, .2, -.01), from_clamp(.36, .22, -.06)},
                 .05)
          : spline({from_clamp(.004, 0, 0), from_clamp(.1, .01, -.01), from_clamp(.2, .02, -.04),
                    from_clamp(.3, .01, -.1)});
  bike.add("stem", {"handlebar", "stem"}, beam(at.head_high - .02 * at.steer, clamp, round_section(.015)));
  if (is_high)
    bike.add("handlebar", {"handlebar", "handlebar"}, wishbone(half, round_section(.011)));
  else
    bike.add_pair({"handlebar_l", "handlebar_r"}, {"handlebar", "handlebar"}, tube(half, round_section(.011)));
  if (grips)
    bike.add_pair({"grip_l", "grip_r"}, {"handlebar", "grip"},
                  tube(Path(half.end() - 3, half.end()), round_section(.016)));
}

/// A fork in one part, with the steerer and the stem or without.
void add_whole_fork(Assembly& bike, const Frame_joints& at, double tyre_radius)
{
  const Point crown = at.head_low - .02 * at.steer, end = at.front_axle + Point(.064, 0, 0);
  const double out = .036 + tyre_radius;
  bike.add("fork", {"fork", "fork"},
           wishbone(bent({crown, crown + Point(out, -.004, 0), between(crown + Point(out, 0, 0), end, .5), end}, .02),
                    round_section(.013, 8)));
}

/// Cranks and pedals on both sides, the left crank `angle` below forwards.
void add_cut_cranks(Assembly& bike, const Point& bracket, Crank_cut cut, double angle)
{
  const double reach = .165, out = .048, width = .09, gap = .014;
  const Point arm(out, -reach * std::sin(angle), reach * std::cos(angle));
  const auto crank = [&](double sign) {
    const Point start(out, (cut == Crank_cut::one_piece ? .12 : 0) * arm.y(),
                      (cut == Crank_cut::one_piece ? .12 : 0) * arm.z());
    return beam(bracket + sign * start, bracket + sign * arm, bar(.02, .02));
  };
  const auto pedal = [&](double sign) {
    return board(bracket + sign * (arm + Point(gap + width / 2, 0, 0)), width, .07, .022, {3, 3, .08, .3});
  };
  switch (cut) {
  case Crank_cut::parts:
    for (const auto& [side, sign] : {std::pair<std::string, double>{"left", 1}, {"right", -1}}) {
      bike.add("crank_" + side, {"pedal", "crank_" + side}, crank(sign));
      bike.add("pedal_" + side, {"pedal", "pedal_" + side}, pedal(sign));
    }
    break;
  case Crank_cut::sides:
    bike.add("pedal_l", {"pedal", "pedal_left"}, joined({crank(1), pedal(1)}));
    bike.add("pedal_r", {"pedal", "pedal_right"}, joined({crank(-1), pedal(-1)}));
    break;
  default:
    bike.add(
        "pedals", {"pedal", ""},
        joined({crank(1), pedal(1), crank(-1), pedal(-1),
                beam(bracket - Point(out + .01, 0, 0), bracket + Point(out + .01, 0, 0), round_section(.009), 3)}));
  }
}

/// A chain and its front sprocket, of any size.
void add_drivetrain(Assembly& bike, const Point& front, const Point& rear, Random& random)
{
  const Point aside(-.046, 0, 0);
  const double ring = random.between(.07, .11), thick = random.between(.002, .005);
  bike.add("chainring", {"drivetrain", "chainring"},
           transformed(disc(disc_profile(ring, -thick, thick, .5 * thick), ring, 0),
                       stand_on(front + aside, front + aside + Point::UnitX())));
  bike.add("chain", {"drivetrain", "chain"},
           tube(chain_path(front + aside, ring + .004, rear + aside, random.between(.03, .045)), bar(.008, .008),
                Point::UnitX(), true));
}

void add_brakes(Assembly& bike, const Frame_joints& at, double radius, double tyre_radius)
{
  const double above = radius + tyre_radius + .012;
  const auto caliper = [&](const Point& axle, const Point& outward) {
    const Point middle = axle + above * outward.normalized();
    return tube(with_mirror_image(bent({middle + Point(0, .012, 0), middle + Point(tyre_radius + .012, .006, 0),
                                        middle + Point(tyre_radius + .013, -.035, 0)},
                                       .01)),
                round_section(.006, 8));
  };
  bike.add("brake_front", {"brake", "brake_front"}, caliper(at.front_axle, at.head_low - at.front_axle));
  bike.add("brake_rear", {"brake", "brake_rear"}, caliper(at.rear_axle, at.cluster - at.rear_axle));
}

Assembly cycle(const Cycle_design& design, std::uint64_t seed)
{
  Random random(seed);
  const Frame_joints at(random, design.radius);
  Assembly bike(design.name, "velocipede");
  add_frame(bike, at, design.frame, design.step_through);
  if (design.fork == Fork_cut::blades)
    add_fork(bike, at.head_low - .018 * at.steer, at.front_axle, .02);
  else
    add_whole_fork(bike, at, design.tyre);
  add_steering(bike, at, design.steering, design.grips);
  add_saddle(bike, "", at.cluster, at.saddle);
  add_whole_wheel(bike, "front", at.front_axle, at.radius, design.tyre, design.wheels);
  add_whole_wheel(bike, "rear", at.rear_axle, at.radius, design.tyre, design.wheels);
  if (design.chain) add_drivetrain(bike, at.bracket, at.rear_axle, random);
  add_cut_cranks(bike, at.bracket, design.cranks, random.between(-.5 * pi, .5 * pi));
  if (design.brakes) add_brakes(bike, at, at.radius, design.tyre);
  if (design.mudguards) {
    const double inner = at.radius + design.tyre - .03; // near the tyre
    add_mudguard(bike, "front", at.front_axle, inner, .25 * pi, .95 * pi);
    add_mudguard(bike, "rear", at.rear_axle, inner, .3 * pi, 1.1 * pi);
  }
  return bike;
}

const std::vector<Cycle_design>& cycle_designs()
{
  using F = Frame_cut;
  using K = Fork_cut;
  using S = Steering;
  using C = Crank_cut;
  using W = Wheel;
  static const std::vector<Cycle_design> designs{
      {"velocipede_whole_city", F::one_piece, K::one_piece, S::swept, C::parts, W::spokes, .335, .018, false, false,
       true},
      {"velocipede_whole_road", F::stays_in_pairs, K::blades, S::drop, C::parts, W::spokes, .34, .012, false, true},
      {"velocipede_whole_mountain", F::tubes, K::one_piece, S::flat, C::parts, W::spokes, .33, .03},
      {"velocipede_whole_bmx", F::stays_in_pairs, K::blades, S::high, C::parts, W::spokes, .25, .03},
      {"velocipede_whole_fixed", F::main_and_stays, K::one_piece, S::flat, C::sides, W::rods, .34, .014},
      {"velocipede_whole_cruiser", F::one_piece, K::blades, S::halves, C::sides, W::spokes, .32, .035},
      {"velocipede_whole_step_through", F::tubes, K::one_piece, S::swept, C::sides, W::spokes, .34, .02, true, false,
       true},
      {"velocipede_whole_brakes", F::main_and_stays, K::one_piece, S::halves, C::parts, W::spokes, .335, .02, false,
       true},
      {"velocipede_whole_time_trial", F::one_piece, K::one_piece, S::drop, C::parts, W::disc, .34, .012},
      {"velocipede_whole_simple", F::one_piece, K::one_piece, S::high, C::one_piece, W::rods, .31, .03, false, false,
       false, false},
      {"velocipede_whole_child", F::tubes, K::one_piece, S::flat, C::one_piece, W::rods, .22, .022},
      {"velocipede_whole_balance", F::main_and_stays, K::blades, S::flat, C::one_piece, W::disc, .2, .024, true, false,
       false, false}};
  return designs;
}

/// A folding bicycle: one low main tube between small wheels, a long stem and a long seat post.
Assembly folding_bicycle(const char* name, std::uint64_t seed)
{
  Random random(seed);
  Frame_joints at(random, .2);
  at.head_low = at.front_axle + Point(0, .3, -.1);
  at.head_high = at.head_low + .14 * at.steer;
  at.cluster = at.bracket + Point(0, .22, -.07);
  Assembly bike(name, "velocipede");
  bike.add("head_tube", {"frame", "head_tube"}, beam(at.head_low, at.head_high, round_section(.022)));
  bike.add(
      "main_tube", {"frame", "down_tube"},
      beam(between(at.head_low, at.head_high, .4), between(at.bracket, at.cluster, .5), oval({.02, .04}, {.02, .04})));
  bike.add("seat_tube", {"frame", "seat_tube"}, beam(at.bracket, at.cluster, round_section(.02)));
  bike.add("chain_stays", {"frame", "chain_stays"},
           stays(at.bracket + Point(0, .01, -.02), at.rear_axle + Point(.06, -.01, .004)));
  bike.add("seat_stays", {"frame", "seat_stays"},
           stays(at.cluster + Point(0, -.04, -.012), at.rear_axle + Point(.06, .011, .002)));
  add_whole_fork(bike, at, .02);
  const Point clamp = at.head_high + random.about(.42) * at.steer;
  bike.add("stem", {"handlebar", "stem"}, beam(at.head_high - .003 * at.steer, clamp, round_section(.018), 7));
  bike.add("handlebar", {"handlebar", "handlebar"},
           beam(clamp - Point(.28, 0, 0), clamp + Point(.28, 0, 0), round_section(.012), 7));
  bike.add_pair({"grip_l", "grip_r"}, {"handlebar", "grip"},
                beam(clamp + Point(.18, 0, 0), clamp + Point(.29, 0, 0), round_section(.017)));
  const Point shell(.04, 0, 0);
  bike.add("bottom_bracket", {"frame", "bottom_bracket"},
           beam(at.bracket - shell, at.bracket + shell, round_section(.024, 12), 3));
  add_saddle(bike, "", at.cluster, at.saddle);
  add_whole_wheel(bike, "front", at.front_axle, at.radius, .02, Wheel::spokes);
  add_whole_wheel(bike, "rear", at.rear_axle, at.radius, .02, Wheel::spokes);
  add_drivetrain(bike, at.bracket, at.rear_axle, random);
  add_cut_cranks(bike, at.bracket, Crank_cut::parts, random.between(-.5 * pi, .5 * pi));
  return bike;
}

/// A load in front of the rider: the front wheel is small and far ahead.
Assembly cargo_bicycle(const char* name, bool box, std::uint64_t seed)
{
  Random random(seed);
  const Frame_joints at(random, .3);
  Assembly bike(name, "velocipede");
  const double small = .2, ahead = random.about(.75);
  const Point front(0, small + .018, at.front_axle.z() + ahead), low(0, .3, at.head_low.z() + .02);
  add_frame(bike, at, Frame_cut::stays_in_pairs, false);
  bike.add("beam", {"frame", "boom_tube"},
           tube(bent({at.head_low + .01 * at.steer, low, {0, .3, front.z() - .3}, {0, .52, front.z() - .08}}, .06),
                round_section(.022)));
  bike.add("fork", {"fork", "fork"},
           wishbone(bent({{0, .5, front.z() - .07}, {.06, .5, front.z() - .07}, front + Point(.062, 0, 0)}, .02),
                    round_section(.013, 8)));
  bike.add(
      box ? "box" : "platform", {"basket", ""},
      board({0, box ? .5 : .34, .5 * (low.z() + front.z()) - .08}, .5, ahead - .25, box ? .36 : .04, {5, 6, .02, .1}));
  add_steering(bike, at, Steering::swept, true);
  add_saddle(bike, "", at.cluster, at.saddle);
  add_whole_wheel(bike, "front", front, small, .02, Wheel::spokes);
  add_whole_wheel(bike, "rear", at.rear_axle, at.radius, .02, Wheel::spokes);
  add_drivetrain(bike, at.bracket, at.rear_axle, random);
  add_cut_cranks(bike, at.bracket, Crank_cut::sides, random.between(-.5 * pi, .5 * pi));
  return bike;
}

Assembly unicycle(const char* name, std::uint64_t seed)
{
  Random random(seed);
  const double radius = random.about(.27, .2);
  const Point axle(0, radius + .022, 0), crown = axle + Point(0, radius + .07, 0);
  Assembly bike(name, "velocipede");
  bike.add(
      "fork", {"fork", "fork"},
      wishbone(bent({crown, crown + Point(.06, -.004, 0), axle + Point(.062, 0, 0)}, .02), round_section(.013, 8)));
  add_saddle(bike, "", crown, crown + Point(0, random.about(.3), 0));
  add_whole_wheel(bike, "front", axle, radius, .022, Wheel::spokes);
  add_cut_cranks(bike, axle, Crank_cut::parts, random.between(-.5 * pi, .5 * pi));
  return bike;
}

/// A kick scooter: a deck between two solid wheels, the steering column in one part with its bar or not.
Assembly kick_scooter(const char* name, bool column_in_one, std::uint64_t seed)
{
  Random random(seed);
  const double radius = random.about(.09, .2), z = .5 * random.about(.72), high = random.about(.85);
  const Point front(0, radius + .014, z), rear(0, radius + .014, -z), steer = Point(0, 1, -.18).normalized();
  const Point head = front + (radius + .1) * steer, top = front + high * steer, bar_end(.2, 0, 0);
  Assembly shape(name, "velocipede");
  shape.add("deck", {"deck", ""}, board({0, radius, 0}, .13, 2 * (z - radius) - .1, .03, {7, 4, .04, .25}));
  shape.add("frame", {"frame", "frame"},
            tube(spline({head, head + Point(0, -.06, -.06), {0, radius, z - radius - .09}}), round_section(.022)));
  shape.add(
      "fork", {"fork", "fork"},
      wishbone(bent({head, head + Point(.034, -.002, 0), front + Point(.036, 0, 0)}, .015), round_section(.011, 8)));
  const Solid column = beam(head, top - (column_in_one ? .02 : 0) * steer, round_section(.016), 7),
              across = beam(top - bar_end, top + bar_end, round_section(.012), 7);
  if (column_in_one)
    shape.add("steering", {"handlebar", "handlebar"},
              joined({across, beam(head, top - .032 * steer, round_section(.016), 7)}));
  else {
    shape.add("column", {"handlebar", "column"}, column);
    shape.add("handlebar", {"handlebar", "handlebar"}, across);
  }
  shape.add_pair({"grip_l", "grip_r"}, {"handlebar", "grip"},
                 beam(top + .5 * bar_end, top + 1.05 * bar_end, round_section(.018)));
  shape.add_pair({"stay_l", "stay_r"}, {"frame", "chain_stay"},
                 beam({.036, radius, -z + radius + .08}, rear + Point(.036, 0, -.01), bar(.012, .02)));
  add_whole_wheel(shape, "front", front, radius - .016, .016, Wheel::disc, .04);
  add_whole_wheel(shape, "rear", rear, radius - .016, .016, Wheel::disc, .04);
  return shape;
}

enum class Motor { scooter, moped, motorcycle };

/// What carries the rider: shield, floor and body of a scooter, or tube, tank and engine.
void add_motor_frame(Assembly& bike, Motor kind, const Point& head, double half, double seat)
{
  if (kind == Motor::scooter) {
    bike.add("shield", {"frame", "shield"},
             slab(flat({-.2, .3, head.z() + .02}, {.4, 0, 0}, {0, head.y() - .28, -.06}), .04, {6, 5, .05, .3}));
    bike.add("floor", {"deck", ""}, board({0, .28, .1}, .34, 2 * (head.z() - .09), .06, {6, 5, .03, .25}));
    bike.add("body", {"frame", "frame"},
             board({0, .5 * (seat + .3), -.55 * half}, .32, .9 * half, seat - .32, {6, 6, .05, .2}));
    return;
  }
  bike.add("frame", {"frame", "frame"},
           tube(spline({head,
                        {0, .55, .25 * half},
                        {0, .3, .1 * half},
                        {0, .3, -.3 * half},
                        {0, seat - .06, -.4 * half},
                        {0, seat - .04, -.95 * half}}),
                round_section(.028)));
  bike.add("tank", {"frame", "tank"},
           hull({{.05 * half, seat + .02, .06, .05},
                 {.2 * half, seat + .06, .12, .1},
                 {.42 * half, seat + .06, .11, .1},
                 {.55 * half, seat + .04, .06, .06}}));
  const double length = kind == Motor::moped ? .24 : .36, height = kind == Motor::moped ? .2 : .28;
  bike.add("engine", {"drivetrain", "engine"}, board({0, .42, .05}, .24, length, height, {5, 5, .03, .2}));
}

/// With a motor: an engine between thick wheels, a tank or a floor before the saddle, an exhaust.
Assembly motor_bike(const char* name, Motor kind, std::uint64_t seed)
{
  Random random(seed);
  const bool is_scooter = kind == Motor::scooter;
  const double radius = is_scooter ? .17 : .25, tyre_radius = kind == Motor::moped ? .035 : .06;
  const double half = .5 * random.about(is_scooter ? 1.2 : 1.3, .06), seat = random.about(.75, .06);
  const Point front(0, radius + tyre_radius, half), rear(0, radius + tyre_radius, -half),
      steer = Point(0, 1, -.42).normalized(), head = front + (radius + tyre_radius + .28) * steer;
  const double aside = tyre_radius + .03;
  Assembly bike(name, "velocipede");
  add_motor_frame(bike, kind, head, half, seat);
  bike.add_pair({"swing_l", "swing_r"}, {"frame", "chain_stay"},
                beam({.03, .31, -.27 * half}, rear + Point(aside, 0, 0), bar(.03, .04)));
  bike.add_pair({"damper_l", "damper_r"}, {"frame", "seat_stay"},
                beam(rear + Point(aside, .02, .03), {aside, seat - .02, rear.z() + .12}, round_section(.02)));
  bike.add("exhaust", {"drivetrain", "exhaust"},
           beam({-.1, .37, is_scooter ? -.2 * half : 0}, {-.16, .34, -1.1 * half}, round_section(.025, .045), 8));
  bike.add("fork_crown", {"fork", "fork_crown"},
           beam(head - Point(aside + .01, 0, 0), head + Point(aside + .01, 0, 0), bar(.04, .04)));
  bike.add_pair({"fork_l", "fork_r"}, {"fork", "fork_blade"},
                beam(head + Point(aside, 0, 0), front + Point(aside, 0, 0), round_section(.022), 7));
  add_handlebar(bike, "", head + .02 * steer, steer, Bars::flat, .02);
  bike.add("saddle", {"saddle", "saddle"}, board({0, seat + .02, -.45 * half}, .26, 1.1 * half, .1, {7, 6, .06, .35}));
  add_whole_wheel(bike, "front", front, radius, tyre_radius, is_scooter ? Wheel::disc : Wheel::rods, aside);
  add_whole_wheel(bike, "rear", rear, radius, tyre_radius, is_scooter ? Wheel::disc : Wheel::rods, aside);
  const double guard = radius + tyre_radius - .028, width = 2 * tyre_radius + .03;
  add_mudguard(bike, "front", front, guard, .2 * pi, .9 * pi, width);
  add_mudguard(bike, "rear", rear, guard, .35 * pi, .95 * pi, width);
  return bike;
}

} // namespace

std::vector<Assembly> cycles(std::uint64_t seed)
{
  std::vector<Assembly> result = shapes_of(cycle_designs(), seed, cycle);
  seed += result.size();
  for (const Assembly& other :
       {folding_bicycle("velocipede_folding", seed), cargo_bicycle("velocipede_cargo_box", true, seed + 1),
        cargo_bicycle("velocipede_cargo_platform", false, seed + 2), unicycle("velocipede_unicycle", seed + 3),
        kick_scooter("velocipede_kick_scooter", false, seed + 4),
        kick_scooter("velocipede_kick_scooter_column", true, seed + 5),
        motor_bike("velocipede_motor_scooter", Motor::scooter, seed + 6),
        motor_bike("velocipede_moped", Motor::moped, seed + 7),
        motor_bike("velocipede_motorcycle", Motor::motorcycle, seed + 8)})
    result.push_back(other);
  return result;
}

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
