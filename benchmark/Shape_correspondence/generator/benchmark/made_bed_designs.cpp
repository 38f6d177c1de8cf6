// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "made_bed_designs.h"

#include "random.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {
namespace {

/// What lies across the bed and hangs down at both sides, between two places along z, 0 the foot and 1 the head.
Solid cover(const Bed_frame& f, double top, double from, double to, double drop)
{
  const double half = f.x() + .01;
  const auto surface = [=](double u, double v) {
    const double z = f.z() - (from + u * (to - from)) * f.length, across = 2 * v - 1, edge = .8;
    const double beyond = std::max(0., std::abs(across) - edge) / (1 - edge);
    return Point(std::copysign(half * std::min(1., std::abs(across) / edge), across), top - drop * beyond, z);
  };
  return slab(surface, .03, {7, 14, 0, .3});
}

} // namespace

void add_bedding(Assembly& bed, const Bed_frame& f, Bedding bedding, double top, Random& random,
                 const std::string& suffix)
{
  const double drop = random.between(.08, .22), end = random.between(.62, .75);
  if (bedding == Bedding::none) return;
  if (bedding == Bedding::band) {
    const double from = random.between(.15, .55);
    bed.add("band" + suffix, {"bedding", "band"}, cover(f, top + .02, from, from + .18, drop));
    return;
  }
  bed.add("blanket" + suffix, {"bedding", "blanket"}, cover(f, top + .02, 0, end, drop));
  if (bedding == Bedding::fold)
    bed.add("fold" + suffix, {"bedding", "fold"}, cover(f, top + .045, end - .12, end, .7 * drop));
}

namespace {

enum class Bed_support { posts, frame, box };

struct Made_bed_design
{
  const char* name;
  Bed_support support;
  Bed_design bed; ///< its ends, width and pillows
  Bedding bedding = Bedding::blanket;
  bool headboard = true, legs = true;
};

/// A ring around the mattress, in one piece.
Solid bed_ring(const Bed_frame& f, double y)
{
  const double x = f.x(), z = f.z();
  const Path ring = bent({{x, y, 0}, {x, y, z}, {-x, y, z}, {-x, y, -z}, {x, y, -z}, {x, y, 0}}, .05);
  return tube({ring.begin(), ring.end() - 1}, bar(.14, .05), Point::UnitY(), true);
}

void add_short_legs(Assembly& bed, const Bed_frame& f, double top)
{
  const double inset = .04;
  bed.add_four({"leg_fl", "leg_fr", "leg_bl", "leg_br"}, leg_label("front"), leg_label("back"),
               beam({f.x() - inset, 0, f.z() - inset}, {f.x() - inset, top, f.z() - inset}, bar(.08, .08)));
}

Assembly made_bed(const Made_bed_design& design, std::uint64_t seed)
{
  Random random(seed);
  Bed_frame f(design.bed, random);
  Assembly bed(design.name, "bed");
  const double head = random.about(.95), foot = random.about(.55), thick = random.between(.16, .26);
  double lying = f.base; // where the mattress lies
  switch (design.support) {
  case Bed_support::posts:
    add_bed_posts(bed, f, head, design.bed.footboard ? foot : f.base + .1, random.below(2) == 0);
    bed.add_pair({"rail_l", "rail_r"}, {"side_rail", "side_rail"},
                 beam({f.x(), f.base, -f.z()}, {f.x(), f.base, f.z()}, bar(.03, .18), 8));
    break;
  case Bed_support::frame:
    lying = design.legs ? .24 : .16;
    bed.add("frame", {"side_rail", "bed_frame"}, bed_ring(f, lying));
    if (design.legs) add_short_legs(bed, f, lying - .06);
    break;
  case Bed_support::box:
    lying = random.between(.2, .34);
    bed.add("base", {"base", ""},
            board({0, .5 * (lying + (design.legs ? .08 : 0)), 0}, f.width, f.length, lying - (design.legs ? .08 : 0),
                  {6, 6, 0, .05}));
    if (design.legs) add_short_legs(bed, f, .085);
  }
  if (design.headboard) add_bed_end(bed, f, "head", "headboard", design.bed.end, lying - .08, head, -1);
  if (design.bed.footboard) add_bed_end(bed, f, "foot", "footboard", design.bed.end, lying - .08, foot, 1);
  const double top = lying + thick;
  bed.add("mattress", {"mattress", ""},
          board({0, lying + thick / 2, 0}, f.width - .05, f.length - .06, thick - .004, {7, 5, .03, .25}));
  const double z = -f.z() + .28, height = random.between(.09, .15), tilt = random.between(0, .15);
  const auto pillow = [&](double x, double width) {
    return slab(flat({x - width / 2, top + height / 2 - .02 + tilt, z - .18}, {width, 0, 0}, {0, -tilt, .38}), height,
                {6, 6, .1, .4});
  };
  if (design.bed.pillows == 2)
    bed.add_pair({"pillow_l", "pillow_r"}, {"pillow", "pillow"}, pillow(.24 * f.width, .4 * f.width));
  else if (design.bed.pillows == 1)
    bed.add("pillow", {"pillow", ""}, pillow(0, .6 * f.width));
  add_bedding(bed, f, design.bedding, top, random);
  return bed;
}

const std::vector<Made_bed_design>& made_bed_designs()
{
  using Kind = Bed_kind;
  using End = Bed_end;
  using S = Bed_support;
  using B = Bedding;
  static const std::vector<Made_bed_design> designs{
      {"bed_made_panels", S::posts, {"", Kind::single, End::panel, 1., 2.05, 1}},
      {"bed_made_double", S::posts, {"", Kind::single, End::panel, 1.6, 2.05, 2}, B::fold},
      {"bed_made_bars", S::posts, {"", Kind::single, End::bars, 1.4, 2.05, 2}},
      {"bed_made_slats", S::posts, {"", Kind::single, End::slats, .9, 2., 1, false}, B::band},
      {"bed_made_throw", S::posts, {"", Kind::single, End::slats, 1.5, 2.1, 2}, B::band},
      {"bed_frame_head", S::frame, {"", Kind::single, End::panel, 1.6, 2.1, 2, false}},
      {"bed_frame_plain", S::frame, {"", Kind::single, End::panel, 1.5, 2.1, 2, false}, B::fold, false},
      {"bed_frame_low", S::frame, {"", Kind::single, End::cushion, 1.4, 2., 2, false}, B::blanket, true, false},
      {"bed_frame_bars", S::frame, {"", Kind::single, End::bars, 1., 2., 1}, B::none},
      {"bed_frame_single", S::frame, {"", Kind::single, End::panel, .9, 2., 1}, B::fold},
      {"bed_box", S::box, {"", Kind::single, End::cushion, 1.6, 2.1, 2, false}},
      {"bed_box_floor", S::box, {"", Kind::single, End::panel, 1.8, 2.1, 2, false}, B::fold, true, false},
      {"bed_box_band", S::box, {"", Kind::single, End::bars, 1., 2., 1, true}, B::band, true, false},
      {"bed_box_legs", S::box, {"", Kind::single, End::panel, 1.2, 2., 1, true}, B::blanket},
      {"bed_box_bare", S::box, {"", Kind::single, End::cushion, 1.4, 2., 2, false}, B::none, true, true}};
  return designs;
}

} // namespace

std::vector<Assembly> made_beds(std::uint64_t seed) { return shapes_of(made_bed_designs(), seed, made_bed); }

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
