// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_TABLE_DESIGNS_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_TABLE_DESIGNS_H

#include "../tables.h"
#include "random.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

enum class Table_base { legs, turned_legs, six_legs, pedestal, plate, two_pedestals, trestle, x_trestle, cabinet };
enum class Table_top { board, disc, framed_glass, drop_leaf_down, drop_leaf_up };

struct Table_design
{
  const char* name;
  Table_base base;
  Table_top top = Table_top::board;
  bool aprons = false;
  int shelves = 0;
  int drawers = 0;
  bool stretchers = false;
  double width = 1.2, depth = .75, height = .74; ///< before they are varied
};

struct Table_frame
{
  double width, depth, height, wood;

  Table_frame(const Table_design& design, Random& random)
      : width(random.about(design.width)),
        depth(random.about(design.depth)),
        height(random.about(design.height, .05)),
        wood(random.about(.055, .25) * std::sqrt(design.height / .74))
  {}

  double under() const { return height - .03; } ///< the underside of the top
};

void add_table_top(Assembly& table, const Table_frame& f, const Table_design& design);

void add_table_legs(Assembly& table, const Table_frame& f, const Table_design& design, Random& random);

/// Drawers side by side in the front, each with a knob.
void add_front_drawers(Assembly& table, const Table_frame& f, const Table_design& design);

/// A pile of drawers on one side, legs on the other.
void add_cabinet(Assembly& table, const Table_frame& f, const Table_design& design);

void add_pedestal(Assembly& table, const Table_frame& f, const Table_design& design, double x, bool pair,
                  Random& random);

void add_trestles(Assembly& table, const Table_frame& f, const Table_design& design);

Assembly table(const Table_design& design, std::uint64_t seed);

const std::vector<Table_design>& table_designs();

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_TABLE_DESIGNS_H
