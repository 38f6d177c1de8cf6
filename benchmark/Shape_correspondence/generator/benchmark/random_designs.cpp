// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "random_designs.h"

#include "aeroplane_designs.h"
#include "bed_designs.h"
#include "chair_designs.h"
#include "lamp_designs.h"
#include "table_designs.h"
#include "velocipede_designs.h"

#include <algorithm>
#include <initializer_list>
#include <set>
#include <tuple>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

namespace {

template <typename T>
T any_of(std::initializer_list<T> values, Random& random)
{
  return values.begin()[random.below(values.size())];
}

bool coin(Random& random) { return random.below(2) == 0; }

int whole_number(int least, int most, Random& random)
{
  return least + int(random.below(std::size_t(most - least + 1)));
}

/// What makes two designs of one style: options, not measures.
auto style(const Chair_design& d) { return std::make_tuple(d.base, d.back, d.arms); }
auto style(const Bed_design& d) { return std::make_tuple(d.kind, d.end, d.footboard, d.pillows); }
auto style(const Table_design& d)
{
  return std::make_tuple(d.base, d.top, d.aprons, d.shelves, d.drawers, d.stretchers);
}
auto style(const Plane_design& d)
{
  return std::make_tuple(d.wing, d.tail, d.engines, d.number_of_engines, d.gear, d.canard);
}

Chair_design random_chair(Random& random)
{
  using Base = Chair_base;
  using Back = Chair_back;
  using Arms = Chair_arms;
  Chair_design d{"",
                 any_of({Base::plain, Base::turned, Base::sled, Base::cantilever, Base::x_frame, Base::swivel}, random),
                 any_of({Back::none, Back::solid, Back::cushion, Back::ladder, Back::slatted, Back::spindle}, random)};
  if (random.below(10) == 0) d.base = Base::column, d.back = Back::cushion;
  if (d.base != Base::column)
    d.arms = d.back == Back::none ? any_of({Arms::none, Arms::to_seat}, random)
                                  : any_of({Arms::none, Arms::to_seat, Arms::to_back, Arms::to_both}, random);
  d.bars = d.back == Back::ladder ? whole_number(2, 5, random) : whole_number(3, 9, random);
  d.aprons = coin(random);
  d.stretchers = coin(random);
  return d;
}

Table_design random_table(Random& random)
{
  using Base = Table_base;
  using Top = Table_top;
  Table_design d{"", any_of({Base::legs, Base::turned_legs, Base::six_legs, Base::pedestal, Base::plate,
                             Base::two_pedestals, Base::trestle, Base::x_trestle, Base::cabinet},
                            random)};
  const bool on_legs = d.base == Base::legs || d.base == Base::turned_legs || d.base == Base::six_legs;
  const bool on_column = d.base == Base::pedestal || d.base == Base::plate;
  d.width = random.between(.7, 1.9);
  d.depth = d.width * random.between(.5, .8);
  d.height = on_legs && random.below(3) == 0 ? random.between(.4, .6) : .74;
  if (on_legs)
    d.top = any_of({Top::board, Top::disc, Top::framed_glass, Top::drop_leaf_down, Top::drop_leaf_up}, random);
  else if (on_column)
    d.top = any_of({Top::board, Top::disc}, random);
  else
    d.top = any_of({Top::board, Top::drop_leaf_down}, random);
  if (d.top == Top::drop_leaf_down) d.width = std::min(d.width, 1.8 * d.height); // leaves end above the floor
  if (d.top == Top::disc || on_column) d.depth = d.width = random.between(.6, 1.2);
  if (on_legs && d.top != Top::disc) { // under a disc legs stand too far in for what joins them
    d.aprons = d.top == Top::drop_leaf_up || coin(random);
    d.shelves = d.top == Top::drop_leaf_up ? 0 : whole_number(0, 2, random);
    d.stretchers = d.shelves == 0 && d.aprons && coin(random);
    d.drawers = d.aprons ? whole_number(0, 3, random) : 0;
  }
  if (d.base == Base::pedestal) d.shelves = whole_number(0, 1, random);
  if (d.base == Base::cabinet) d.drawers = whole_number(2, 5, random);
  return d;
}

Bed_design random_bed(Random& random)
{
  using Kind = Bed_kind;
  using End = Bed_end;
  Bed_design d{
      "", any_of({Kind::single, Kind::platform, Kind::bunk, Kind::loft, Kind::canopy, Kind::cot, Kind::sofa}, random),
      any_of({End::panel, End::slats, End::bars, End::cushion}, random)};
  d.footboard = coin(random);
  d.pillows = whole_number(0, 2, random);
  d.width = random.between(.9, 1.7);
  switch (d.kind) {
  case Kind::platform: // has no posts that slats could be fixed to, and no footboard
    if (d.end == End::slats) d.end = End::bars;
    d.footboard = false;
    break;
  case Kind::bunk:
  case Kind::loft:
    d.width = random.between(.9, 1.1);
    break;
  case Kind::cot:
    d.width = random.between(.62, .75);
    d.length = random.between(1.2, 1.4);
    break;
  case Kind::sofa:
    d.end = End::cushion;
    if (d.pillows == 1) d.pillows = 2;
    d.length = random.between(1.85, 2);
    break;
  default:
    break;
  }
  return d;
}

Plane_design random_aeroplane(Random& random)
{
  using Wing = Plane_wing;
  using Tail = Plane_tail;
  using Engines = Plane_engines;
  using Gear = Plane_gear;
  Plane_design d{"",        any_of({Wing::low, Wing::high, Wing::biplane, Wing::delta, Wing::swept}, random),
                 Tail::low, Engines::none,
                 0,         any_of({Gear::none, Gear::nose_wheel, Gear::tail_wheel}, random)};
  switch (d.wing) {
  case Wing::low:
  case Wing::high:
    d.tail = any_of({Tail::low, Tail::t_tail, Tail::booms}, random);
    d.engines = d.tail == Tail::booms ? any_of({Engines::pusher, Engines::wing_propellers}, random)
                                      : any_of({Engines::none, Engines::jets_under_wing, Engines::jets_in_tail,
                                                Engines::nose_propeller, Engines::wing_propellers, Engines::pusher},
                                               random);
    break;
  case Wing::biplane:
    d.tail = any_of({Tail::low, Tail::t_tail}, random);
    d.engines = any_of({Engines::nose_propeller, Engines::wing_propellers}, random);
    break;
  case Wing::delta:
    d.tail = any_of({Tail::low, Tail::t_tail, Tail::fin_only}, random);
    d.engines = any_of({Engines::nozzles, Engines::pusher}, random);
    break;
  case Wing::swept:
    d.tail = any_of({Tail::low, Tail::t_tail}, random);
    d.engines = any_of({Engines::jets_under_wing, Engines::jets_in_tail, Engines::nozzles}, random);
  }
  d.canard = (d.tail == Tail::fin_only || d.wing == Wing::low) && coin(random);
  if (d.canard && d.wing == Wing::low && d.tail != Tail::booms) d.tail = Tail::fin_only;
  const bool wing_engines = d.engines == Engines::jets_under_wing || d.engines == Engines::wing_propellers;
  d.number_of_engines = d.engines == Engines::none ? 0
                        : wing_engines ? (d.tail != Tail::booms && d.wing != Wing::biplane && coin(random) ? 4 : 2)
                        : d.engines == Engines::jets_in_tail ? 2
                        : d.engines == Engines::nozzles      ? whole_number(1, 2, random)
                                                             : 1;
  d.length = random.between(7, d.number_of_engines == 4 ? 50 : 25);
  d.span = d.length * (d.wing == Wing::delta ? random.between(.5, .65) : random.between(.9, 1.5));
  return d;
}

/// Lamps of other numbers and sizes; their kinds are those of `lamps()`.
Assembly random_lamp(Random& random, std::uint64_t seed)
{
  using Body = Lamp_body;
  switch (random.below(6)) {
  case 0:
    return desk_lamp("", whole_number(1, 4, random), coin(random), coin(random), seed);
  case 1:
    return chandelier("", whole_number(3, 8, random), coin(random), seed);
  case 2:
    return pendant("", coin(random) ? 0 : whole_number(3, 12, random), seed);
  case 3:
    return random.below(3) == 0 ? arc_lamp("", seed) : spot_bar("", whole_number(2, 5, random), seed);
  default:
    return standing_lamp(
        "", any_of({Body::vase, Body::column, Body::candlestick, Body::balls, Body::pole, Body::tripod}, random),
        random.between(.35, 1.7), seed);
  }
}

/// Bicycles of other options; of the other kinds of `velocipedes()` there are no others, only other measures.
Assembly random_velocipede(Random& random, std::uint64_t seed)
{
  switch (random.below(12)) {
  case 0:
    return tandem("", coin(random), seed);
  case 1:
    return penny_farthing("", seed);
  case 2:
    return child_tricycle("", seed);
  case 3:
    return coin(random) ? adult_tricycle("", seed) : cargo_tricycle("", seed);
  case 4:
    return scooter("", coin(random), seed);
  case 5:
  case 6:
    return wheelchair("", any_of({Wheelchair::standard, Wheelchair::sport, Wheelchair::transport}, random), seed);
  default: {
    Bicycle_design d{any_of({Bars::flat, Bars::drop, Bars::swept}, random)};
    d.step_through = coin(random);
    d.mudguards = coin(random);
    d.rack = coin(random);
    d.basket = coin(random);
    d.wheel = random.between(.26, .35);
    d.tyre = random.between(.012, .028);
    return bicycle("", d, seed);
  }
  }
}

/// Shapes of styles that neither the known designs have nor one another.
template <typename Design, typename Draw, typename Make>
void add_new_styles(const std::vector<Design>& known, std::size_t number, const Draw& draw, const Make& make,
                    Random& random, std::vector<Assembly>& shapes)
{
  std::set<decltype(style(known[0]))> styles;
  for (const Design& design : known)
    styles.insert(style(design));
  while (number) {
    const Design design = draw(random);
    if (!styles.insert(style(design)).second) continue;
    shapes.push_back(make(design, random.below(std::size_t(1) << 32)));
    --number;
  }
}

} // namespace

std::vector<Assembly> random_shapes(std::uint64_t seed)
{
  constexpr std::size_t number = 15;
  Random random(seed);
  std::vector<Assembly> shapes;
  add_new_styles(aeroplane_designs(), number, random_aeroplane, aeroplane, random, shapes);
  add_new_styles(bed_designs(), number, random_bed, bed, random, shapes);
  add_new_styles(chair_designs(), number, random_chair, chair, random, shapes);
  for (std::size_t k = 0; k < number; ++k)
    shapes.push_back(random_lamp(random, random.below(std::size_t(1) << 32)));
  add_new_styles(table_designs(), number, random_table, table, random, shapes);
  for (std::size_t k = 0; k < number; ++k)
    shapes.push_back(random_velocipede(random, random.below(std::size_t(1) << 32)));
  for (std::size_t k = 0; k < shapes.size(); ++k)
    shapes[k].name = shapes[k].category + numbered("_", int(number))[k % number];
  return shapes;
}

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
