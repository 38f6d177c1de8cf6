// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "plant_designs.h"

#include "../chairs.h"
#include "random.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {
namespace {

enum class Growth { rosette, upright, stem, palm, crown, cactus };

struct Plant_design
{
  const char* name;
  Growth growth;
  int leaves;                           ///< or arms of a cactus
  double height, pot_width, pot_height; ///< before they are varied
  bool saucer = false;
};

struct Pot
{
  double radius, height;

  double soil() const { return .88 * height; }
};

void add_pot(Assembly& plant, const Pot& pot, bool angular, bool saucer)
{
  const double r = pot.radius, h = pot.height, wall = .12 * r;
  plant.add("pot", {"pot", ""},
            post({{0, 0},
                  {.62 * r, 0},
                  {.68 * r, .02 * h},
                  {r, .96 * h},
                  {r, h},
                  {r - wall, h},
                  {r - 1.2 * wall, .8 * h},
                  {0, .78 * h}},
                 angular ? 8 : 20));
  plant.add("soil", {"soil", ""},
            disc(disc_profile(r - 1.3 * wall, .8 * h, pot.soil(), .004), r - 1.3 * wall, .84 * h, 20));
  if (saucer)
    plant.add("saucer", {"pot", "saucer"}, disc(disc_profile(.9 * r, -.03 * h, .015 * h, .004), .9 * r, 0, 20));
}

/// A leaf that rises from `root` outwards along z, and bends down: `droop` at its tip, of its length.
Solid leaf(const Point& root, double length, double rise, double droop, double width)
{
  const auto surface = [=](double u, double v) {
    const double across = width * std::sin(pi * (.08 + .87 * u)) * (v - .5), along = length * u;
    return Point(root + Point(across, along * rise - droop * length * u * u + .3 * std::abs(across),
                              along * std::sqrt(std::max(.05, 1 - rise * rise))));
  };
  return slab(surface, .02 * length, {8, 4, 0, .2});
}

/// Leaves all around, each a little different from the others.
void add_leaves(Assembly& plant, int n, const Point& root, double length, double rise, double droop, double width,
                Random& random)
{
  for (int i = 0; i < n; ++i) {
    const Solid one =
        leaf(root, random.about(length, .25), random.about(rise, .2), random.about(droop, .3), random.about(width, .2));
    const double angle = 2 * pi * (i + random.between(-.2, .2)) / n;
    plant.add("leaf_" + std::to_string(i + 1), {"leaf", ""},
              transformed(one, rotation_about(Point::Zero(), Point::UnitY(), angle)));
  }
}

void add_cactus(Assembly& plant, const Pot& pot, double height, int arms, Random& random)
{
  const double radius = .45 * pot.radius;
  const auto column = [](const Path& path, double r) { return tube(path, round_section(r, .8 * r, 12)); };
  plant.add("stem", {"stem", ""}, column(line({0, pot.soil() - .02, 0}, {0, height, 0}, 8), radius));
  for (int i = 0; i < arms; ++i) {
    const double side = i % 2 == 0 ? 1 : -1, y = random.between(.4, .65) * (height - pot.soil()) + pot.soil();
    const double out = side * 2.1 * radius, rise = random.between(.2, .35) * height;
    plant.add("branch_" + std::to_string(i + 1), {"stem", "branch"},
              column(bent({{.5 * side * radius, y, 0}, {out, y, 0}, {out, y + rise, 0}}, .8 * radius), .5 * radius));
  }
}

Assembly plant(const Plant_design& design, std::uint64_t seed)
{
  Random random(seed);
  const Pot pot{random.about(design.pot_width / 2), random.about(design.pot_height)};
  const double height = random.about(design.height), soil = pot.soil();
  Assembly result(design.name, "plant");
  add_pot(result, pot, random.below(2) == 0, design.saucer);
  const Point root(0, soil - .01, .1 * pot.radius);
  const double above = height - soil;
  switch (design.growth) {
  case Growth::rosette:
    add_leaves(result, design.leaves, root, 1.3 * above, random.between(.75, .9), random.between(.4, .8), .3 * above,
               random);
    break;
  case Growth::upright:
    add_leaves(result, design.leaves, root, 1.05 * above, .97, random.between(.02, .1), .16 * above, random);
    break;
  case Growth::stem:
  case Growth::palm: {
    const double stem = design.growth == Growth::palm ? height - .35 * above : soil + .5 * above;
    result.add("stem", {"stem", ""},
               beam({0, soil - .02, 0}, {0, stem, 0}, round_section(.05 * above, .03 * above), 8));
    add_leaves(result, design.leaves, {0, stem - .02, .02 * above},
               design.growth == Growth::palm ? .6 * above : .55 * above, random.between(.5, .85),
               random.between(.4, .8), .2 * above, random);
    break;
  }
  case Growth::crown: {
    const double stem = soil + .45 * above, radius = .45 * above;
    result.add("stem", {"stem", "trunk"},
               beam({0, soil - .02, 0}, {0, stem, 0}, round_section(.06 * above, .04 * above), 8));
    for (int i = 0; i < design.leaves; ++i) {
      const double size = i == 0 ? radius : random.between(.4, .6) * radius, angle = 2 * pi * i / design.leaves;
      const Point at = i == 0 ? Point(0, height - radius, 0)
                              : Point(.6 * radius * std::cos(angle), stem + .2 * above, .6 * radius * std::sin(angle));
      const Profile ball{{0, -.95 * size},        {.55 * size, -.8 * size}, {.95 * size, -.3 * size},
                         {.95 * size, .3 * size}, {.55 * size, .8 * size},  {0, .95 * size}};
      result.add("leaves_" + std::to_string(i + 1), {"leaf", ""}, translated(post(ball, 14), at));
    }
    break;
  }
  case Growth::cactus:
    add_cactus(result, pot, height, design.leaves, random);
  }
  return result;
}

const std::vector<Plant_design>& plant_designs()
{
  using G = Growth;
  static const std::vector<Plant_design> designs{{"plant_rosette", G::rosette, 9, .5, .3, .28},
                                                 {"plant_rosette_low", G::rosette, 6, .35, .34, .25},
                                                 {"plant_rosette_large", G::rosette, 14, .9, .36, .32, true},
                                                 {"plant_upright", G::upright, 7, .7, .25, .25},
                                                 {"plant_upright_saucer", G::upright, 10, .9, .3, .28, true},
                                                 {"plant_upright_few", G::upright, 4, .5, .22, .2},
                                                 {"plant_stem", G::stem, 8, .8, .3, .3},
                                                 {"plant_stem_tall", G::stem, 12, 1.3, .34, .34},
                                                 {"plant_palm", G::palm, 8, 1.4, .36, .32},
                                                 {"plant_palm_many", G::palm, 15, 1.8, .42, .38, true},
                                                 {"plant_tree", G::crown, 1, 1.2, .36, .32},
                                                 {"plant_tree_balls", G::crown, 4, 1.3, .36, .34},
                                                 {"plant_cactus", G::cactus, 0, .6, .26, .22},
                                                 {"plant_cactus_arm", G::cactus, 1, .7, .3, .25},
                                                 {"plant_cactus_arms", G::cactus, 2, .9, .34, .28}};
  return designs;
}

} // namespace

std::vector<Assembly> plants(std::uint64_t seed) { return shapes_of(plant_designs(), seed, plant); }

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
