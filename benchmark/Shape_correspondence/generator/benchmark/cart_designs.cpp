// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "vehicles.h"

namespace CGAL::Shape_correspondence::generator {
namespace {

// Adds a wheel: tyre, spokes and hub.
void add_wheel(Assembly& shape, const std::string& where, const Point& axle, double radius, double tyre_radius, int n)
{
  shape.add("tyre_" + where, {"wheel", "wheel_" + where}, tyre(axle, radius, tyre_radius));
  shape.add("spokes_" + where, {"spokes", "spokes_" + where}, spokes(axle, .02, radius - .4 * tyre_radius, .025, n));
  shape.add("hub_" + where, {"hub", "hub_" + where}, along_x(hub_profile(.058, .024, .025), axle));
}

void add_wheel_pair(Assembly& shape, const std::string& where, const Point& axle, double radius, double tyre_radius,
                    int n)
{
  const auto add = [&](const std::string& role, const Solid& solid) {
    const Label label{role, role + "_" + where};
    shape.add_pair({(role == "wheel" ? "tyre" : role) + "_" + where + "_l",
                    (role == "wheel" ? "tyre" : role) + "_" + where + "_r"},
                   label, label, solid);
  };
  add("wheel", tyre(axle, radius, tyre_radius));
  add("spokes", spokes(axle, .02, radius - .4 * tyre_radius, .02, n));
  add("hub", along_x(hub_profile(.045, .022, .02), axle));
}

/// The box that carries the load: height of the floor, `z` of the middle, height of the walls.
struct Box_design
{
  double half_width, length, height, z, wall;
  double thickness = .02;

  double front() const { return z + length / 2; }
  double back() const { return z - length / 2; }
  double top() const { return height + wall; }
};

void add_floor(Assembly& cart, const Box_design& box)
{
  cart.add("floor", {"box", "floor"},
           board({0, box.height, box.z}, 2 * box.half_width, box.length, box.thickness, {6, 5}));
}

/// An upright board across the cart.
Solid cross_board(const Box_design& box, double z, double lean)
{
  return slab(flat({-box.half_width, box.height, z}, {2 * box.half_width, 0, 0}, {0, box.wall, lean}), box.thickness,
              {5, 3});
}

void add_boarded_sides(Assembly& cart, const Box_design& box, double flare)
{
  cart.add_pair({"wall_l", "wall_r"}, {"box", "wall"},
                slab(flat({box.half_width, box.height, box.back()}, {0, 0, box.length}, {flare, box.wall, 0}),
                     box.thickness, {6, 3}));
  cart.add("front_wall", {"box", "front_wall"}, cross_board(box, box.front(), flare));
}

/// Adds rails on stakes at both sides, and a rail across each end.
void add_railed_sides(Assembly& cart, const Box_design& box, int stakes)
{
  const double step = (box.length - .06) / (stakes - 1), x = box.half_width;
  for (int i = 0; i < stakes; ++i) {
    const double z = box.back() + .03 + i * step;
    const std::string number = std::to_string(i + 1);
    cart.add_pair({"stake_l" + number, "stake_r" + number}, {"box", "stake"},
                  beam({x, box.height - .01, z}, {x, box.top(), z}, bar(.03, .03)));
  }
  for (const auto& [name, part] : {std::pair<std::string, double>{"low_rail", .5}, {"top_rail", 1}})
    cart.add_pair({name + "_l", name + "_r"}, {"box", "rail"},
                  beam({x, box.height + part * box.wall, box.back()}, {x, box.height + part * box.wall, box.front()},
                       bar(.045, .022), 8));
  for (const auto& [name, z] : {std::pair<std::string, double>{"front", box.front()}, {"back", box.back()}})
    cart.add(name + "_rail", {"box", name + "_rail"}, beam({-x, box.top(), z}, {x, box.top(), z}, bar(.045, .022), 6));
}

/// Adds an axle with a wheel at either end, and the hangers that hold it under the floor.
void add_axle(Assembly& cart, const std::string& where, const Box_design& box, double z, double radius, int spokes)
{
  const double x = box.half_width + .07, tyre_radius = .022;
  const Point axle(0, radius + tyre_radius, z);
  cart.add("axle_" + where, {"axle", "axle_" + where},
           beam(axle - Point(x, 0, 0), axle + Point(x, 0, 0), round_section(.018), 8));
  add_wheel_pair(cart, where, axle + Point(x, 0, 0), radius, tyre_radius, spokes);
  cart.add_pair({"hanger_" + where + "_l", "hanger_" + where + "_r"}, {"axle", "hanger"},
                beam(axle + Point(.7 * box.half_width, 0, 0), {.7 * box.half_width, box.height, z}, bar(.05, .03)));
}

Assembly wheelbarrow()
{
  Assembly cart("cart_wheelbarrow", "cart");
  const Box_design box{.27, .62, .42, 0, .2};
  const Point axle(0, .2, .62);
  add_floor(cart, box);
  add_boarded_sides(cart, box, .08);
  cart.add("back_wall", {"box", "back_wall"}, cross_board(box, box.back(), -.05));
  add_wheel(cart, "front", axle, .178, .022, 12);
  cart.add("axle_front", {"axle", "axle_front"},
           beam(axle - Point(.09, 0, 0), axle + Point(.09, 0, 0), round_section(.012)));
  cart.add_pair({"shaft_l", "shaft_r"}, {"handle", "shaft"},
                beam(axle + Point(.08, 0, 0), {.27, .52, -.95}, bar(.035, .035), 12));
  cart.add_pair({"grip_l", "grip_r"}, {"handle", "grip"},
                beam({.269, .519, -.94}, {.28, .55, -1.1}, round_section(.02)));
  cart.add_pair({"leg_l", "leg_r"}, {"leg", "leg"}, beam({.215, .42, -.25}, {.25, 0, -.35}, bar(.035, .035), 7));
  cart.add("brace", {"leg", "brace"}, beam({-.235, .18, -.306}, {.235, .18, -.306}, bar(.025, .025)));
  return cart;
}

Assembly handcart()
{
  Assembly cart("cart_handcart", "cart");
  const Box_design box{.45, 1.2, .55, -.1, .28};
  add_floor(cart, box);
  add_boarded_sides(cart, box, .06);
  add_axle(cart, "rear", box, -.2, .4, 14);
  cart.add_pair({"shaft_l", "shaft_r"}, {"handle", "shaft"},
                beam({.36, .53, -.3}, {.36, .8, 1.35}, bar(.045, .035), 12));
  cart.add("crossbar", {"handle", "grip"}, beam({-.37, .8, 1.34}, {.37, .8, 1.34}, round_section(.02), 8));
  cart.add_pair({"prop_l", "prop_r"}, {"leg", "leg"}, beam({.36, .57, .4}, {.36, 0, .45}, bar(.035, .035), 7));
  return cart;
}

Assembly wagon()
{
  Assembly cart("cart_wagon", "cart");
  const Box_design box{.45, 1.5, .5, 0, .35};
  add_floor(cart, box);
  add_railed_sides(cart, box, 4);
  add_axle(cart, "rear", box, -.5, .26, 12);
  add_axle(cart, "front", box, .5, .2, 12);
  const Point front_axle(0, .222, .5), grip(0, .75, 1.6);
  cart.add("drawbar", {"handle", "shaft"}, beam(front_axle, grip, round_section(.018), 10));
  cart.add("crossbar", {"handle", "grip"}, beam(grip - Point(.14, 0, 0), grip + Point(.14, 0, 0), round_section(.018)));
  return cart;
}

} // namespace

std::vector<Assembly> carts() { return {wheelbarrow(), handcart(), wagon()}; }

} // namespace CGAL::Shape_correspondence::generator
