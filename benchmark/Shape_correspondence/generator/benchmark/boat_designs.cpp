// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "vehicles.h"

namespace CGAL::Shape_correspondence::generator {
namespace {

/// An open hull of planks, from the stern at -`length` / 2 to the bow.
struct Hull_design
{
  double length, half_beam, depth;
  int thwarts;
};

/// Half width of a hull relative to its greatest one, at `t` from the stern (0) to the bow (1).
double hull_width(double t)
{
  const double bow_begins = .4, stern = .75, bow = .03;
  if (t < bow_begins) return stern + (1 - stern) * std::sin(pi / 2 * t / bow_begins);
  const double forward = (t - bow_begins) / (1 - bow_begins);
  return 1 - (1 - bow) * forward * forward;
}

/// A point of the left side at `t` along the hull; `v` = 0: on the edge of the bottom, 1: on the upper edge, which
/// rises towards the bow.
Point on_side(const Hull_design& hull, double t, double v)
{
  const double bottom = .6, rise = .35 * hull.depth;
  return {hull.half_beam * hull_width(t) * (bottom + (1 - bottom) * v), v * (hull.depth + rise * t * t),
          hull.length * (t - .5)};
}

void add_hull(Assembly& boat, const Hull_design& hull)
{
  const double thickness = .03;
  boat.add("bottom", {"hull", "bottom"},
           slab([&](double u, double v) -> Point { return on_side(hull, u, 0).cwiseProduct(Point(1 - 2 * v, 1, 1)); },
                thickness, {10, 4}));
  boat.add_pair({"side_l", "side_r"}, {"hull", "side"},
                slab([&](double u, double v) { return on_side(hull, u, v); }, thickness, {10, 3}));
  boat.add("transom", {"hull", "transom"},
           slab([&](double u, double v) -> Point { return on_side(hull, 0, u).cwiseProduct(Point(1 - 2 * v, 1, 1)); },
                thickness, {3, 4}));
  boat.add("keel", {"hull", "keel"},
           beam({0, -.05, -.48 * hull.length}, {0, -.05, .47 * hull.length}, bar(.04, .08), 10));
  for (int i = 0; i < hull.thwarts; ++i) {
    const double t = .15 + .5 * i / hull.thwarts, height = .65;
    const Point end = on_side(hull, t, height);
    boat.add("thwart_" + std::to_string(i + 1), {"seat", "thwart"},
             board({0, end.y(), end.z()}, 2 * end.x(), .22, .03, {3, 6}));
  }
}

void add_oars(Assembly& boat, const Hull_design& hull)
{
  const Point rowlock = on_side(hull, .42, 1) + Point(0, .06, 0);
  const Point handle = rowlock + Point(-.62 * hull.half_beam, .12, -.12), out = (rowlock - handle).normalized();
  boat.add_pair({"rowlock_l", "rowlock_r"}, {"oar", "rowlock"},
                beam(rowlock - Point(0, .1, 0), rowlock + Point(0, .02, 0), round_section(.018)));
  boat.add_pair({"loom_l", "loom_r"}, {"oar", "loom"},
                beam(handle, rowlock + 1.1 * out, round_section(.024, .018), 12));
  const Point blade = rowlock + 1.08 * out;
  boat.add_pair({"blade_l", "blade_r"}, {"oar", "blade"},
                slab(flat(blade - Point(0, .08, 0), .5 * out, {0, .16, 0}), .015, {6, 3, .1}));
}

/// A sail in the plane of symmetry: its foot from `tack` to `clew`, its head above the tack.
Solid sail(const Point& tack, const Point& clew, const Point& head)
{
  const double head_width = .06, belly = .04;
  return slab(
      [=](double u, double v) -> Point {
        const Point foot = between(tack, clew, u), top = between(head, head + Point(clew - tack), head_width * u);
        return between(foot, top, v) + Point(belly * (clew - tack).norm() * std::sin(pi * u) * (1 - v), 0, 0);
      },
      .012, {6, 10});
}

/// A mast that stands on the keel, its boom, and the sail between them.
void add_mast(Assembly& boat, const std::string& suffix, double z, double height, double boom_length)
{
  const double boom_height = .85;
  const Point at(0, 0, z), tack = at + Point(0, boom_height, -.05);
  boat.add("mast" + suffix, {"mast", "mast"}, beam(at, at + Point(0, height, 0), round_section(.045, .025), 14));
  boat.add("boom" + suffix, {"mast", "boom"},
           beam(at + Point(0, boom_height - .03, -.03), at + Point(0, boom_height - .03, -boom_length),
                round_section(.025), 8));
  boat.add("sail" + suffix, {"sail", "mainsail"},
           sail(tack, tack + Point(0, 0, .06 - boom_length), at + Point(0, .94 * height, -.05)));
}

void add_jib(Assembly& boat, const Point& tack, const Point& clew, const Point& head)
{
  boat.add("forestay", {"mast", "forestay"}, beam(tack, head, round_section(.012), 12));
  const Point in = .01 * (clew - tack).normalized();
  boat.add("jib", {"sail", "jib"}, sail(tack + in + .06 * (head - tack), clew, tack + in + .9 * (head - tack)));
}

void add_rudder(Assembly& boat, const Hull_design& hull)
{
  const double stern = -.5 * hull.length - .02;
  boat.add("rudder", {"rudder", "rudder"},
           slab(flat({0, -.35, stern}, {0, .4 + hull.depth, 0}, {0, 0, -.24}), .03, {6, 3, .05}));
  boat.add("tiller", {"rudder", "tiller"},
           beam({0, .045 + hull.depth, stern - .1}, {0, .16 + hull.depth, stern + .85}, round_section(.02), 7));
}

Assembly rowing_boat()
{
  const Hull_design hull{3.4, .65, .42, 3};
  Assembly boat("boat_rowing", "boat");
  add_hull(boat, hull);
  add_oars(boat, hull);
  return boat;
}

Assembly dinghy()
{
  const Hull_design hull{4.2, .8, .48, 2};
  Assembly boat("boat_dinghy", "boat");
  add_hull(boat, hull);
  const double mast = .9, height = 4.6;
  add_mast(boat, "", mast, height, 2.3);
  add_jib(boat, on_side(hull, .97, 1).cwiseProduct(Point(0, 1, 1)), {0, .8, mast + .1}, {0, .8 * height, mast + .03});
  boat.add("centreboard", {"hull", "centreboard"}, slab(flat({0, -.8, .1}, {0, 0, .5}, {0, .78, 0}), .03, {4, 5, .04}));
  add_rudder(boat, hull);
  return boat;
}

Assembly yawl()
{
  const Hull_design hull{6, 1, .65, 3};
  Assembly boat("boat_yawl", "boat");
  add_hull(boat, hull);
  const double main = 1.2, height = 6.2;
  const Point stem = on_side(hull, .98, 1).cwiseProduct(Point(0, 1, 1)), sprit = stem + Point(0, .12, .9);
  add_mast(boat, "", main, height, 2.5);
  add_mast(boat, "_mizzen", -2.3, 3.4, 1.2);
  boat.add("bowsprit", {"mast", "bowsprit"}, beam(stem - Point(0, .1, .6), sprit, round_section(.04, .03), 8));
  add_jib(boat, sprit, {0, 1, main + .15}, {0, .9 * height, main + .02});
  add_rudder(boat, hull);
  return boat;
}

} // namespace

std::vector<Assembly> boats() { return {rowing_boat(), dinghy(), yawl()}; }

} // namespace CGAL::Shape_correspondence::generator
