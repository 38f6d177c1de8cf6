// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapes.h"

#include "aeroplane_designs.h"
#include "bed_designs.h"
#include "bed_kinds.h"
#include "boat_designs.h"
#include "car_designs.h"
#include "cart_designs.h"
#include "chair_designs.h"
#include "cycle_designs.h"
#include "desk_designs.h"
#include "fixture_designs.h"
#include "lamp_designs.h"
#include "light_designs.h"
#include "made_bed_designs.h"
#include "plant_designs.h"
#include "shelf_designs.h"
#include "sofa_designs.h"
#include "sofa_kinds.h"
#include "table_designs.h"
#include "velocipede_designs.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

namespace {

/// The shapes of designs, each with a seed of its own.
template <typename Design, typename Make>
void add_shapes(const std::vector<Design>& designs, std::uint64_t seed, const Make& make, std::vector<Assembly>& shapes)
{
  for (const Design& design : designs)
    shapes.push_back(make(design, seed++));
}

} // namespace

std::vector<Assembly> benchmark_shapes()
{
  std::vector<Assembly> shapes;
  add_shapes(aeroplane_designs(), 100, aeroplane, shapes);
  add_shapes(bed_designs(), 200, bed, shapes);
  add_shapes(chair_designs(), 300, chair, shapes);
  for (const Assembly& lamp : lamps(400))
    shapes.push_back(lamp);
  add_shapes(table_designs(), 500, table, shapes);
  for (const Assembly& velocipede : velocipedes(600))
    shapes.push_back(velocipede);
  return shapes;
}

std::vector<Assembly> training_shapes()
{
  std::vector<Assembly> shapes = benchmark_shapes();
  for (const std::vector<Assembly>& category :
       {made_beds(700), cars(800), desks(900), lights(1000), plants(1100), shelves(1200), sofas(1300), cycles(1400),
        fixtures(1500), bed_kinds(1600), sofa_kinds(1700)})
    shapes.insert(shapes.end(), category.begin(), category.end());
  return shapes;
}

std::vector<Assembly> gallery_shapes()
{
  std::vector<Assembly> shapes = boats();
  for (const Assembly& cart : carts())
    shapes.push_back(cart);
  return shapes;
}

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
