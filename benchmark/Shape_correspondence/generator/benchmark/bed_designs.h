// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_BED_DESIGNS_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_BED_DESIGNS_H

#include "../furnishings.h"
#include "random.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

enum class Bed_kind { single, platform, bunk, loft, canopy, cot, sofa };
enum class Bed_end { panel, slats, bars, cushion };

struct Bed_design
{
  const char* name;
  Bed_kind kind;
  Bed_end end;
  double width = 1., length = 2.05; ///< before they are varied
  int pillows = 1;
  bool footboard = true;
};

struct Bed_frame
{
  double width, length, base, wood;

  Bed_frame(const Bed_design& design, Random& random)
      : width(random.about(design.width, .06)),
        length(random.about(design.length, .03)),
        base(random.about(.32)),
        wood(random.about(.065, .2))
  {}

  double x() const { return width / 2; }
  double z() const { return length / 2; }
};

/// A board that fills one end between `low` and `high`, at the head (side -1) or the foot (side 1).
void add_bed_end(Assembly& bed, const Bed_frame& f, const std::string& stem, const std::string& coarse, Bed_end kind,
                 double low, double high, double side);

void add_mattress(Assembly& bed, const Bed_frame& f, const std::string& suffix, double y, int pillows);

/// Side rails, laths across them, the mattress.
void add_lying_surface(Assembly& bed, const Bed_frame& f, const std::string& suffix, double y, int laths, int pillows);

/// Four posts; at the head and at the foot they may differ in height.
void add_bed_posts(Assembly& bed, const Bed_frame& f, double head, double foot, bool round);

void add_single(Assembly& bed, const Bed_frame& f, const Bed_design& design, Random& random);

/// An upholstered box on short feet.
void add_platform(Assembly& bed, const Bed_frame& f, const Bed_design& design);

void add_ladder(Assembly& bed, const Bed_frame& f, double high, bool at_end);

void add_guard(Assembly& bed, const Bed_frame& f, double y);

void add_bunk(Assembly& bed, const Bed_frame& f, const Bed_design& design, bool ladder_at_end);

/// A bed above a desk.
void add_loft(Assembly& bed, const Bed_frame& f, const Bed_design& design);

/// Tall posts with rails around their heads, and laths of cloth across or a tester on top.
void add_canopy(Assembly& bed, const Bed_frame& f, const Bed_design& design, Random& random);

/// High barred sides all around a small mattress.
void add_cot(Assembly& bed, const Bed_frame& f, const Bed_design& design, Random& random);

/// A sofa folded out: its back at the head, arms at both sides, a frame that stands on feet in front.
void add_sofa(Assembly& bed, const Bed_frame& f, const Bed_design& design, bool frame_shown);

Assembly bed(const Bed_design& design, std::uint64_t seed);

const std::vector<Bed_design>& bed_designs();

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_BED_DESIGNS_H
