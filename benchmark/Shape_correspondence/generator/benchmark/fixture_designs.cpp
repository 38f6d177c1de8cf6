// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixture_designs.h"

#include "../primitives.h"
#include "lamp_designs.h"
#include "random.h"

#include <cmath>
#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {
namespace {

enum class Carrier { ground, chain, rod, wall, post };
enum class Lantern_sides { panes, corner_posts, both, cage, glass };

/// As many copies about the y axis, or one.
void add_around(Assembly& lamp, const std::string& stem, const Label& label, const Solid& solid, int count)
{
  if (count > 1)
    lamp.add_ring(numbered(stem + "_", count), label, solid, Point::Zero(), Point::UnitY());
  else
    lamp.add(stem, label, solid);
}

/// A plate on the wall, its middle at `at`.
Solid wall_mount(const Point& at, double radius)
{
  return transformed(disc(disc_profile(radius, -.01, .01, .003), radius, 0, 14), stand_on(at, at + Point::UnitZ()));
}

/// What is between the floor and the roof of a lantern.
void add_lantern_sides(Assembly& lamp, Lantern_sides sides, double half, double low, double high)
{
  if (sides == Lantern_sides::panes || sides == Lantern_sides::both)
    add_around(lamp, "pane", {"shade", "pane"},
               slab(flat({-.85 * half, low, .9 * half}, {1.7 * half, 0, 0}, {0, high - low, 0}), .008, {5, 5, 0, .2}),
               4);
  if (sides == Lantern_sides::corner_posts || sides == Lantern_sides::both)
    add_around(lamp, "corner", {"body", "post"},
               beam({.95 * half, low - .01, .95 * half}, {.95 * half, high + .01, .95 * half}, bar(.02, .02)), 4);
  if (sides == Lantern_sides::cage) { // uprights and a ring in one part
    Solid cage = torus({0, .5 * (low + high), 0}, Point::UnitY(), 1.06 * half, round_section(.06 * half, 6), 24);
    constexpr int uprights = 6;
    for (int i = 0; i < uprights; ++i) {
      const double a = 2 * pi * i / uprights;
      const Point out = .92 * half * Point(std::cos(a), 0, std::sin(a));
      append(cage.mesh, beam(out + Point(0, low, 0), out + Point(0, high, 0), round_section(.05 * half, 6)).mesh);
    }
    lamp.add("cage", {"shade", "lantern_cage"}, cage);
  }
  if (sides == Lantern_sides::glass || sides == Lantern_sides::cage) {
    const double r = sides == Lantern_sides::cage ? .7 * half : half, h = high - low;
    lamp.add(
        "glass", {"shade", ""},
        post({{0, low}, {.7 * r, low}, {r, low + .35 * h}, {.9 * r, low + .8 * h}, {.6 * r, high}, {0, high}}, 16));
  }
}

/// A lantern that stands, hangs or is held by an arm at a wall.
Assembly lantern(const char* name, Carrier carrier, Lantern_sides sides, bool bulb, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double half = random.about(.1), h = random.between(.2, .32), roof = random.between(.05, .14);
  const double under = carrier == Carrier::post ? random.about(.9, .4) : carrier == Carrier::ground ? .05 : 0;
  const double floor = under + .025, top = floor + h, peak = top + roof;
  const double foot = (carrier == Carrier::post ? 1.2 : 1.25) * half;
  if (carrier == Carrier::ground) lamp.add("base", {"base", ""}, board({0, .5 * under, 0}, 2 * foot, 2 * foot, under));
  if (carrier == Carrier::post) {
    lamp.add("base", {"base", ""}, post({{0, 0}, {foot, 0}, {foot, .06}, {.6 * foot, .12}, {0, .122}}, 12));
    lamp.add("post", {"body", "post"},
             beam({0, .115, 0}, {0, under + .004, 0}, round_section(random.between(.02, .06), .02), 8));
  }
  lamp.add("floor", {"body", "platform"}, board({0, under + .014, 0}, 2.3 * half, 2.3 * half, .026));
  add_lantern_sides(lamp, sides, half, floor, top);
  lamp.add("roof", {"shade", "roof"},
           post({{0, top - .006},
                 {1.4 * half, top - .002},
                 {1.35 * half, top + .015},
                 {.3 * half, peak - .01},
                 {.2 * half, peak},
                 {0, peak}},
                12));
  if (bulb) lamp.add("bulb", {"bulb", ""}, translated(upside_down(light_bulb(.028)), {0, floor - .004, 0}));
  switch (carrier) {
  case Carrier::ground:
    lamp.add("handle", {"arm", "handle"},
             tube(spline({{.8 * half, peak - .6 * roof, 0},
                          {.7 * half, peak + .06, 0},
                          {0, peak + .12, 0},
                          {-.7 * half, peak + .06, 0},
                          {-.8 * half, peak - .6 * roof, 0}}),
                  round_section(.007, 8)));
    break;
  case Carrier::chain: {
    constexpr int links = 7;
    constexpr double size = .026;
    const double high = peak + links * 1.55 * size + .3 * size;
    add_lamp_chain(lamp, high, links, size);
    lamp.add("mount", {"base", "ceiling_mount"}, translated(lamp_foot(.06, .03), {0, high - .01, 0}));
    break;
  }
  case Carrier::rod: {
    const double high = peak + random.between(.15, .5);
    lamp.add("rod", {"body", "hanging_post"}, beam({0, peak - .01, 0}, {0, high, 0}, round_section(.008, 8), 6));
    lamp.add("mount", {"base", "ceiling_mount"},
             disc(disc_profile(.07, high - .005, high + .02, .004), .07, high + .01, 14));
    break;
  }
  case Carrier::wall: {
    const double back = -half - random.between(.08, .2);
    lamp.add("mount", {"base", "wall_mount"}, wall_mount({0, .5 * (floor + top), back}, .07));
    lamp.add("arm", {"arm", ""},
             tube(spline({{0, .5 * (floor + top), back},
                          {0, peak + .05, back + .03},
                          {0, peak + .1, .5 * back},
                          {0, peak + .06, -.005},
                          {0, peak - .01, 0}}),
                  round_section(.009, 8)));
    break;
  }
  default:
    break;
  }
  return lamp;
}

/// Arms with a dish, a candle and a flame each, around a turned body that hangs from a chain or a rod.
Assembly candle_chandelier(const char* name, int arms, bool chain, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double reach = random.about(.34), y = .4, rise = random.between(.05, .16), top = .97;
  lamp.add("mount", {"base", "ceiling_mount"}, translated(upside_down(lamp_foot(.07, .06)), {0, 1.01, 0}));
  double low = .72;
  if (chain)
    low = add_lamp_chain(lamp, top, 6, .026) + .012;
  else
    lamp.add("rod", {"body", "hanging_post"}, beam({0, top, 0}, {0, low, 0}, round_section(.01, 8), 6));
  lamp.add("column", {"body", "post"},
           post({{0, y + .04},
                 {.018, y + .04},
                 {.018, y + .14},
                 {.035, y + .18},
                 {.014, y + .24},
                 {.012, low},
                 {0, low + .006}},
                14));
  lamp.add("bowl", {"body", "hub"},
           post({{0, y - .09}, {.02, y - .085}, {.07, y - .02}, {.07, y + .02}, {.03, y + .045}, {0, y + .045}}, 16));
  const double end = y + rise;
  add_around(lamp, "arm", {"arm", ""},
             tube(spline({{0, y, .06}, {0, y - .09, .4 * reach}, {0, y - .07, .85 * reach}, {0, end, reach}}),
                  round_section(.008)),
             arms);
  add_around(lamp, "dish", {"arm", "drip_pan"},
             translated(disc({{0, 0}, {.03, 0}, {.045, .008}, {.043, .014}, {.02, .006}, {0, .006}}, .04, .005, 14),
                        {0, end - .003, reach}),
             arms);
  add_around(lamp, "candle", {"arm", "candle"}, beam({0, end, reach}, {0, end + .07, reach}, round_section(.011), 3),
             arms);
  add_around(lamp, "flame", {"bulb", ""}, translated(upside_down(light_bulb(.016)), {0, end + .068, reach}), arms);
  return lamp;
}

/// Lamps on a hoop that hangs by three rods.
Assembly hoop_chandelier(const char* name, int lights, bool shades, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double radius = random.about(.34), high = random.about(.6, .2);
  lamp.add("mount", {"base", "ceiling_mount"}, disc(disc_profile(.08, high, high + .03, .006), .08, high + .015, 14));
  lamp.add("hoop", {"body", "hoop"}, torus({0, 0, 0}, Point::UnitY(), radius, bar(.03, .03)));
  add_around(lamp, "rod", {"chain", "rod"}, beam({0, high, .05}, {0, .004, radius}, round_section(.005, 8), 7), 3);
  add_around(lamp, "socket", {"body", "bulb_socket"}, beam({radius, .01, 0}, {radius, .05, 0}, round_section(.018), 3),
             lights);
  add_around(lamp, "bulb", {"bulb", ""}, translated(upside_down(light_bulb(.024)), {radius, .048, 0}), lights);
  if (shades) add_around(lamp, "shade", {"shade", ""}, translated(lamp_shade(.12, .05, .08), {radius, .13, 0}), lights);
  return lamp;
}

/// A spot: a tube in a bracket, its glass in front; on the ceiling (looking down) or a wall (looking aside).
void add_spot(Assembly& lamp, const std::string& suffix, const Point& joint, const Point& towards, double size,
              bool ring)
{
  const Eigen::Isometry3d head = stand_on(joint, joint - towards);
  const double r = .5 * size;
  lamp.add("shade" + suffix, {"shade", ""},
           transformed(post({{0, .4 * size},
                             {.7 * r, .4 * size},
                             {r, .25 * size},
                             {r, -.8 * size},
                             {.9 * r, -.8 * size},
                             {.9 * r, -.5 * size},
                             {0, -.5 * size}},
                            16),
                       head));
  if (ring)
    lamp.add("ring" + suffix, {"shade", "front_ring"},
             transformed(torus({0, -.82 * size, 0}, Point::UnitY(), .98 * r, round_section(.05 * size, 8), 20), head));
  lamp.add(
      "bulb" + suffix, {"bulb", ""},
      transformed(disc(disc_profile(.7 * r, -.62 * size, -.49 * size, .01 * size), .7 * r, -.55 * size, 14), head));
}

/// Spots side by side under a track, each on a short arm.
Assembly track(const char* name, int spots, bool turned, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double step = random.about(.3), size = random.about(.11), width = step * spots, drop = random.between(.06, .14);
  lamp.add("track", {"base", "track"}, beam({-.5 * width, 0, 0}, {.5 * width, 0, 0}, bar(.03, .04), 8));
  for (int i = 0; i < spots; ++i) {
    const std::string suffix = "_" + std::to_string(i + 1);
    const double x = step * (i - .5 * (spots - 1));
    const Point joint(x, -drop, 0);
    lamp.add("arm" + suffix, {"arm", ""}, beam({x, -.008, 0}, joint, round_section(.008, 8)));
    const double aside = turned ? random.between(-.8, .8) : 0;
    add_spot(lamp, suffix, joint, Point(aside, -1, random.between(.2, .9)).normalized(), size, false);
  }
  return lamp;
}

Assembly single_spot(const char* name, bool on_wall, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double reach = random.about(.22, .3), size = random.about(.16);
  const Point joint = on_wall ? Point(0, 0, reach) : Point(0, -reach, 0);
  lamp.add("mount", {"base", on_wall ? "wall_mount" : "ceiling_mount"},
           on_wall ? wall_mount({0, 0, 0}, .08) : disc(disc_profile(.08, -.01, .01, .003), .08, 0, 14));
  lamp.add("arm", {"body", ""}, beam(Point::Zero(), joint, round_section(.014), 6));
  const Point towards = Point(0, -1, random.between(.2, 1.2)).normalized();
  const Point aside(.5 * size + .006, 0, 0), behind = on_wall ? Point(0, 0, -.5 * size) : Point(0, .5 * size, 0);
  lamp.add(
      "bracket", {"arm", "swivel"},
      tube(with_mirror_image(bent({joint + behind, joint + aside + behind, joint + aside}, .02)), bar(.024, .008)));
  add_spot(lamp, "", joint, towards, size, true);
  return lamp;
}

/// A bowl that shines upwards, on a pole of some pieces.
Assembly uplight(const char* name, int pieces, bool cup, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double h = random.about(1.7), r = random.about(.16), foot = random.about(.15);
  lamp.add("base", {"base", ""}, lamp_foot(foot, .035));
  for (int i = 0; i < pieces; ++i) {
    const double low = .03 + i * (h - .03) / pieces, high = .03 + (i + 1) * (h - .03) / pieces;
    lamp.add("post_" + std::to_string(i + 1), {"body", "post"},
             beam({0, low - .004, 0}, {0, high, 0}, round_section(.02 - .004 * i), 7));
  }
  lamp.add("bowl", {"shade", ""},
           translated(upside_down(cup ? lamp_shade(1.4 * r, .4 * r, .8 * r) : lamp_shade(.7 * r, .25 * r, 1.1 * r)),
                      {0, h - .02, 0}));
  lamp.add("bulb", {"bulb", ""}, translated(upside_down(light_bulb(.022)), {0, h - .006, 0}));
  return lamp;
}

/// A post with one globe on top, or some on arms around it.
Assembly globe_post(const char* name, int globes, double height, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double h = random.about(height), r = random.about(.11) * height / 2, reach = globes > 1 ? .22 * h : 0;
  lamp.add("base", {"base", ""},
           post({{0, 0}, {.06 * h, 0}, {.06 * h, .05 * h}, {.03 * h, .12 * h}, {0, .122 * h}}, 12));
  lamp.add("post", {"body", "post"}, beam({0, .118 * h, 0}, {0, h, 0}, round_section(.02 * h, .012 * h), 9));
  if (globes > 1)
    add_around(lamp, "arm", {"arm", ""},
               tube(spline({{0, .9 * h, .008 * h}, {0, .86 * h, .5 * reach}, {0, .88 * h, reach}, {0, .96 * h, reach}}),
                    round_section(.008 * h)),
               globes);
  const double low = globes > 1 ? .955 * h : .995 * h;
  add_around(
      lamp, "globe", {"shade", "globe"},
      translated(
          post({{0, 0}, {.6 * r, .2 * r}, {.95 * r, .68 * r}, {.95 * r, 1.32 * r}, {.6 * r, 1.8 * r}, {0, 2 * r}}, 16),
          {0, low, reach}),
      globes);
  add_around(lamp, "cap", {"shade", "cap"},
             translated(post({{0, 1.9 * r}, {.5 * r, 1.85 * r}, {.3 * r, 2.1 * r}, {0, 2.2 * r}}, 14), {0, low, reach}),
             globes);
  return lamp;
}

/// Stacked rings of paper on a foot, with a lid or without.
Assembly paper_lamp(const char* name, double height, bool lid, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double h = random.about(height), r = random.about(.14);
  lamp.add("base", {"base", ""}, disc(disc_profile(1.02 * r, 0, .05, .006), r, .025, 16));
  constexpr int waves = 6;
  Profile profile{{0, .048}, {.9 * r, .048}};
  for (int i = 0; i < waves; ++i) {
    profile.push_back({r, .05 + (i + .5) * (h - .05) / waves});
    profile.push_back({.9 * r, .05 + (i + 1) * (h - .05) / waves});
  }
  profile.push_back({0, h});
  lamp.add("shade", {"shade", ""}, post(profile, 16));
  if (lid) lamp.add("lid", {"shade", "cap"}, disc(disc_profile(.95 * r, h - .004, h + .02, .004), r, h + .01, 16));
  return lamp;
}

/// A lamp at a wall whose arm ends under a shade, or in a cup that shines upwards.
Assembly sconce(const char* name, int arms, bool upwards, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double reach = random.about(.16), rise = random.between(.04, .14), x = arms > 1 ? random.about(.12) : 0;
  lamp.add("mount", {"base", "wall_mount"}, wall_mount({0, 0, 0}, .07));
  const Path path = spline({{.3 * x, 0, 0}, {.6 * x, -.04, .6 * reach}, {x, 0, reach}, {x, rise, reach}});
  const Solid arm = tube(path, round_section(.009)),
              socket = beam({x, rise - .01, reach}, {x, rise + .04, reach}, round_section(.018), 3),
              bulb = translated(upside_down(light_bulb(.022)), {x, rise + .038, reach}),
              shade = upwards ? translated(upside_down(lamp_shade(.15, .035, .08)), {x, rise + .006, reach})
                              : translated(lamp_shade(.13, .05, .085), {x, rise + .13, reach});
  const auto add = [&](const std::string& stem, const Label& label, const Solid& solid) {
    if (arms > 1)
      lamp.add_pair({stem + "_l", stem + "_r"}, label, label, solid);
    else
      lamp.add(stem, label, solid);
  };
  add("arm", {"arm", ""}, arm);
  add("socket", {"body", "bulb_socket"}, socket);
  add("bulb", {"bulb", ""}, bulb);
  add("shade", {"shade", ""}, shade);
  return lamp;
}

/// Shades in a row under one long mount.
Assembly row_pendant(const char* name, int shades, bool cups, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double step = random.about(.3), drop = random.about(.5, .3), r = random.about(.1), y = -drop;
  lamp.add("mount", {"base", "ceiling_mount"}, board({0, .014, 0}, step * (shades - .4), .08, .03, {5, 4, 0, .2}));
  const Point first(-.5 * step * (shades - 1), 0, 0), along(step, 0, 0);
  const auto add = [&](const std::string& stem, const Label& label, const Solid& solid) {
    lamp.add_row(numbered(stem + "_", shades), label, translated(solid, first), along);
  };
  add("cable", {"chain", "cable"}, beam({0, .004, 0}, {0, y, 0}, round_section(.003, 8), 7));
  add("socket", {"body", "bulb_socket"}, beam({0, y + .01, 0}, {0, y - .05, 0}, round_section(.02), 3));
  add("shade", {"shade", ""},
      translated(cups ? lamp_shade(1.6 * r, .5 * r, .9 * r) : lamp_shade(.8 * r, .3 * r, 1.2 * r), {0, y - .02, 0}));
  add("bulb", {"bulb", ""}, translated(light_bulb(.024), {0, y - .048, 0}));
  return lamp;
}

/// A flat light on arms under the ceiling, a ring around it.
Assembly ring_light(const char* name, int arms, std::uint64_t seed)
{
  Random random(seed);
  Assembly lamp(name, "lamp");
  const double r = random.about(.25), h = random.between(.05, .1);
  lamp.add("mount", {"base", "ceiling_mount"}, disc(disc_profile(.5 * r, -.01, .02, .004), .5 * r, .005, 16));
  lamp.add("ring", {"arm", "shade_ring"}, torus({0, -h, 0}, Point::UnitY(), r, bar(.02, .03)));
  add_around(lamp, "arm", {"arm", ""},
             tube(bent({{0, -.004, .4 * r}, {0, -.01, r}, {0, -h + .008, r}}, .02), round_section(.006, 8)), arms);
  lamp.add("shade", {"shade", ""}, disc(disc_profile(.97 * r, -h - .03, -h + .01, .006), .97 * r, -h - .01, 20));
  return lamp;
}

} // namespace

std::vector<Assembly> fixtures(std::uint64_t seed)
{
  using C = Carrier;
  using L = Lantern_sides;
  return {lantern("lamp_lantern_chain", C::chain, L::both, false, seed),
          lantern("lamp_lantern_rod", C::rod, L::glass, true, seed + 1),
          lantern("lamp_lantern_wall", C::wall, L::panes, true, seed + 2),
          lantern("lamp_lantern_cage", C::post, L::cage, false, seed + 3),
          lantern("lamp_lantern_corners", C::post, L::corner_posts, true, seed + 4),
          lantern("lamp_lantern_storm", C::ground, L::cage, false, seed + 5),
          lantern("lamp_lantern_garden", C::ground, L::both, false, seed + 6),
          candle_chandelier("lamp_candles", 6, true, seed + 7),
          candle_chandelier("lamp_candles_rod", 4, false, seed + 8),
          hoop_chandelier("lamp_hoop", 6, false, seed + 9),
          hoop_chandelier("lamp_hoop_shades", 3, true, seed + 10),
          track("lamp_track", 4, true, seed + 11),
          track("lamp_track_two", 2, false, seed + 12),
          single_spot("lamp_wall_spot", true, seed + 13),
          single_spot("lamp_ceiling_spot", false, seed + 14),
          uplight("lamp_uplight", 1, false, seed + 15),
          uplight("lamp_uplight_pieces", 3, true, seed + 16),
          globe_post("lamp_globe_post", 1, 2.5, seed + 17),
          globe_post("lamp_globe_posts", 3, 3.5, seed + 18),
          globe_post("lamp_globe_garden", 1, .8, seed + 19),
          paper_lamp("lamp_paper", .4, false, seed + 20),
          paper_lamp("lamp_paper_tall", 1., true, seed + 21),
          sconce("lamp_sconce", 1, true, seed + 22),
          sconce("lamp_sconce_pair", 2, false, seed + 23),
          row_pendant("lamp_row", 3, true, seed + 24),
          row_pendant("lamp_row_domes", 4, false, seed + 25),
          ring_light("lamp_ring", 4, seed + 26)};
}

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
