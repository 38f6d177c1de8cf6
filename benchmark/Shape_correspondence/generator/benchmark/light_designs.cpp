// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "light_designs.h"

#include "../chairs.h"
#include "lamp_designs.h"

#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {
namespace {

enum class Shade { dome, cone, cup, globe, box, frame };
enum class Hanger { rod, cable, chain };

/// A bowl that is open below, its top at the origin.
Solid dome(double radius)
{
  const double r = radius, wall = .03 * radius;
  return post({{0, 0},
               {.4 * r, -.06 * r},
               {.75 * r, -.3 * r},
               {.95 * r, -.62 * r},
               {r, -.9 * r},
               {r - wall, -.9 * r},
               {.92 * r - wall, -.6 * r},
               {.7 * r, -.32 * r},
               {.38 * r, -.12 * r},
               {0, -.06 * r}},
              18);
}

Solid ball(double radius)
{
  const double r = radius;
  return post({{0, 0}, {.6 * r, -.2 * r}, {.95 * r, -.68 * r}, {.95 * r, -1.32 * r}, {.6 * r, -1.8 * r}, {0, -2 * r}},
              16);
}

/// The edges of a cube that hangs from the origin by a bar: two square rings, and rods between them.
Solid cube_frame(double half)
{
  const double rod = .06 * half, inner = half - 1.5 * rod;
  const auto ring = [&](double y) {
    const Path square =
        bent({{half, y, 0}, {half, y, half}, {-half, y, half}, {-half, y, -half}, {half, y, -half}, {half, y, 0}},
             .1 * half, 1);
    return tube({square.begin(), square.end() - 1}, round_section(rod, 6), Point::UnitY(), true);
  };
  Solid result = ring(-rod);
  append(result.mesh, ring(rod - 2 * half).mesh);
  append(result.mesh, beam({-inner, -rod, 0}, {inner, -rod, 0}, round_section(.5 * rod, 6), 2).mesh);
  for (double x : {-half, half})
    for (double z : {-half, half}) {
      const Point high(.94 * x, -2.2 * rod, .94 * z), low(.94 * x, 2.2 * rod - 2 * half, .94 * z);
      append(result.mesh, beam(high, low, round_section(.6 * rod, 6), 2).mesh);
    }
  return result;
}

Solid shade_solid(Shade shade, double radius)
{
  switch (shade) {
  case Shade::dome:
    return dome(radius);
  case Shade::cone:
    return lamp_shade(.8 * radius, .12 * radius, radius);
  case Shade::cup:
    return lamp_shade(1.6 * radius, .55 * radius, radius);
  case Shade::globe:
    return ball(radius);
  case Shade::box:
    return board({0, -radius, 0}, 2 * radius, 2 * radius, 2 * radius, {5, 5, 0, .05});
  default:
    return cube_frame(radius);
  }
}

/// Hanging lights: `count` of them under one mount.
Assembly hanging_light(const char* name, Shade shade, Hanger hanger, int count, bool cap, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double radius = random.about(count > 1 ? .1 : .2, .2),
               drop = random.about(hanger == Hanger::cable ? .6 : .42, .3);
  const double reach = count > 1 ? random.about(.2) : 0, mount = count > 1 ? reach + .06 : random.between(.06, .16);
  lamp.add("mount", {"base", "ceiling_mount"}, disc(disc_profile(mount, .97, 1., .006), mount, .985, 12));
  const auto ring = [&](const std::string& stem, const Label& label, const Solid& solid) {
    const Solid placed = translated(solid, {0, 0, reach});
    if (count > 1)
      lamp.add_ring(numbered(stem + "_", count), label, placed, Point::Zero(), Point::UnitY());
    else
      lamp.add(stem, label, placed);
  };
  double low = .972 - drop;
  if (hanger == Hanger::chain)
    low = add_lamp_chain(lamp, .975, 7, .03) + .02;
  else
    ring(hanger == Hanger::rod ? "rod" : "cable",
         hanger == Hanger::rod ? Label{"body", "hanging_post"} : Label{"chain", "cable"},
         beam({0, .975, 0}, {0, low - .024, 0}, round_section(hanger == Hanger::rod ? .009 : .003, 8), 7));
  const bool is_open = shade != Shade::globe && shade != Shade::box;
  const double top = shade == Shade::frame ? .07 : shade == Shade::dome ? .05 * radius : .024; // of the bulb
  if (cap || shade == Shade::frame)
    ring(cap ? "cap" : "socket", cap ? Label{"shade", "cap"} : Label{"body", "bulb_socket"},
         translated(post({{0, 0}, {.03, -.004}, {.036, -.02}, {.036, -.07}, {0, -.072}}, 12), {0, low, 0}));
  ring("shade",
       {"shade", shade == Shade::globe   ? "globe"
                 : shade == Shade::frame ? "shade_frame"
                                         : ""},
       translated(shade_solid(shade, radius), {0, low - (cap ? .06 : 0), 0}));
  if (is_open) ring("bulb", {"bulb", ""}, translated(light_bulb(.028), {0, low - top, 0}));
  return lamp;
}

/// A flat one, right under the ceiling.
Assembly ceiling_light(const char* name, bool wide_mount, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double r = random.about(.22), h = random.between(.06, .12), mount = wide_mount ? 1.1 * r : .7 * r;
  lamp.add("mount", {"base", "ceiling_mount"}, disc(disc_profile(mount, .97, 1., .006), mount, .985, 14));
  lamp.add("shade", {"shade", ""},
           post({{0, .974}, {r, .972}, {.98 * r, .97 - h}, {.9 * r, .97 - 1.1 * h}, {0, .97 - 1.15 * h}}, 18));
  lamp.add("bulb", {"bulb", ""},
           disc(disc_profile(.5 * r, .97 - 1.25 * h, .97 - 1.12 * h, .004), .5 * r, .97 - 1.2 * h, 14));
  return lamp;
}

Assembly street_lamp(const char* name, int heads, bool curved, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double h = random.about(4.5), reach = random.about(.9), base = random.between(.5, .9);
  lamp.add("base", {"base", ""}, post({{0, 0}, {.15, 0}, {.15, .8 * base}, {.09, base}, {0, base}}, 12));
  lamp.add("post", {"body", "post"}, beam({0, base - .02, 0}, {0, h, 0}, round_section(.07, .05), 9));
  const Path path = curved ? spline({{0, h - .1, 0}, {0, h + .15, .15}, {0, h + .3, .5 * reach}, {0, h + .25, reach}})
                           : line({0, h - .02, 0}, {0, h + .2, .4 * reach}, 5);
  const Point end = path.back(), far(0, end.y() - .02, end.z() + .55);
  const Solid arm = tube(path, round_section(.035)), head = beam(end, far, bar({.16, .08}, {.24, .06}));
  const Solid bulb =
      beam(between(end, far, .3) - Point(0, .055, 0), between(end, far, .9) - Point(0, .05, 0), bar(.14, .03));
  const auto ring = [&](const std::string& stem, const Label& label, const Solid& solid) {
    if (heads > 1)
      lamp.add_ring(numbered(stem + "_", heads), label, solid, Point::Zero(), Point::UnitY());
    else
      lamp.add(stem, label, solid);
  };
  ring("arm", {"arm", ""}, arm);
  ring("head", {"shade", ""}, head);
  ring("bulb", {"bulb", ""}, bulb);
  return lamp;
}

/// A lantern, on a post or on the ground, with four panes or a glass.
Assembly lantern(const char* name, double post_height, bool panes, bool handle, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double half = random.about(.1), h = random.between(.22, .34), low = .06 + post_height;
  lamp.add("base", {"base", ""},
           post({{0, 0}, {1.3 * half, 0}, {1.3 * half, .03}, {1.1 * half, .06}, {0, .062}}, panes ? 12 : 14));
  if (post_height > 0) {
    lamp.add("post", {"body", "post"}, beam({0, .055, 0}, {0, low, 0}, round_section(.03), 8));
    lamp.add("platform", {"body", "platform"}, board({0, low + .01, 0}, 2.2 * half, 2.2 * half, .025));
  }
  const double floor = low + (post_height > 0 ? .024 : .002), top = floor + h;
  if (panes) {
    const Solid pane = slab(flat({-.9 * half, floor, half}, {1.8 * half, 0, 0}, {0, h, 0}), .008, {5, 5, 0, .2});
    lamp.add_ring(numbered("pane_", 4), {"shade", ""}, pane, Point::Zero(), Point::UnitY());
  } else
    lamp.add("glass", {"shade", ""},
             post({{0, floor},
                   {.7 * half, floor},
                   {half, floor + .3 * h},
                   {.95 * half, floor + .8 * h},
                   {.6 * half, top},
                   {0, top}},
                  16));
  const double roof = random.between(.06, .14);
  lamp.add("roof", {"shade", "roof"},
           post({{0, top - .004},
                 {1.3 * half, top},
                 {1.25 * half, top + .02},
                 {.3 * half, top + roof},
                 {0, top + roof + .01}},
                panes ? 12 : 14));
  if (handle)
    lamp.add("handle", {"arm", "handle"},
             tube(spline({{half, top + .01, 0},
                          {.8 * half, top + .14, 0},
                          {0, top + .2, 0},
                          {-.8 * half, top + .14, 0},
                          {-half, top + .01, 0}}),
                  round_section(.006, 8)));
  return lamp;
}

/// A shade on a pole, and no more than a bulb beside.
Assembly plain_lamp(const char* name, double height, bool wide_body, bool bulb, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double h = random.about(height), r = random.about(height > 1 ? .17 : .11),
               shade = random.about(height > 1 ? .16 : .15);
  lamp.add("base", {"base", ""}, disc(disc_profile(r, 0, .03, .006), r, .015, 14));
  const double top = h - shade;
  lamp.add("post", {"body", "post"},
           beam({0, .026, 0}, {0, h - .02, 0}, wide_body ? round_section(.07, .04) : round_section(.012), 9));
  lamp.add("shade", {"shade", ""}, translated(lamp_shade(1.3 * shade, .7 * shade, shade), {0, h, 0}));
  if (bulb) lamp.add("bulb", {"bulb", ""}, translated(upside_down(light_bulb(.03)), {0, top - .004, 0}));
  return lamp;
}

/// One bent arm from the base, on a table or a wall, to the shade.
Assembly bent_arm_lamp(const char* name, bool on_wall, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double reach = random.about(.2), h = random.about(.42);
  const Path path = on_wall ? spline({{0, .3, 0}, {0, .34, .4 * reach}, {0, .36, .9 * reach}, {0, .3, 1.2 * reach}})
                            : spline({{0, .03, 0}, {0, .7 * h, -.02}, {0, h, .3 * reach}, {0, .95 * h, reach}});
  if (on_wall)
    lamp.add("mount", {"base", "wall_mount"},
             transformed(disc(disc_profile(.07, -.02, .004, .004), .07, -.01, 14), stand_on({0, .3, 0}, {0, .3, 1})));
  else
    lamp.add("base", {"base", ""}, lamp_foot(random.about(.11), .036));
  lamp.add("arm", {"arm", ""}, tube(path, round_section(.01)));
  const Point end = path.back(), down = Point(0, -1, random.between(.2, .7)).normalized();
  const Eigen::Isometry3d head = stand_on(end, end - down);
  lamp.add("socket", {"body", "bulb_socket"},
           transformed(post({{0, .02}, {.02, .02}, {.03, -.03}, {.03, -.06}, {0, -.06}}, 12), head));
  lamp.add("shade", {"shade", ""},
           transformed(translated(lamp_shade(.15, .035, random.about(.085)), {0, -.03, 0}), head));
  lamp.add("bulb", {"bulb", ""}, transformed(translated(light_bulb(.026), {0, -.058, 0}), head));
  return lamp;
}

} // namespace

std::vector<Assembly> lights(std::uint64_t seed)
{
  return {hanging_light("lamp_dome", Shade::dome, Hanger::rod, 1, false, seed),
          hanging_light("lamp_dome_cable", Shade::dome, Hanger::cable, 1, true, seed + 1),
          hanging_light("lamp_cone", Shade::cone, Hanger::rod, 1, true, seed + 2),
          hanging_light("lamp_cone_chain", Shade::cone, Hanger::chain, 1, false, seed + 3),
          hanging_light("lamp_cup", Shade::cup, Hanger::rod, 1, false, seed + 4),
          hanging_light("lamp_cups", Shade::cup, Hanger::rod, 4, false, seed + 5),
          hanging_light("lamp_globe", Shade::globe, Hanger::rod, 1, true, seed + 6),
          hanging_light("lamp_globes", Shade::globe, Hanger::cable, 3, false, seed + 7),
          hanging_light("lamp_box", Shade::box, Hanger::rod, 1, false, seed + 8),
          hanging_light("lamp_cube_frame", Shade::frame, Hanger::rod, 1, false, seed + 9),
          ceiling_light("lamp_ceiling", true, seed + 10),
          ceiling_light("lamp_ceiling_bowl", false, seed + 11),
          street_lamp("lamp_street", 1, true, seed + 12),
          street_lamp("lamp_street_three", 3, false, seed + 13),
          lantern("lamp_lantern_panes", 0, true, true, seed + 14),
          lantern("lamp_lantern_glass", 0, false, true, seed + 15),
          lantern("lamp_lantern_post", .9, true, false, seed + 16),
          plain_lamp("lamp_plain_floor", 1.6, false, true, seed + 17),
          plain_lamp("lamp_plain_table", .5, true, false, seed + 18),
          bent_arm_lamp("lamp_gooseneck", false, seed + 19),
          bent_arm_lamp("lamp_wall", true, seed + 20)};
}

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
