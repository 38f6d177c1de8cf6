// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_AEROPLANE_DESIGNS_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_AEROPLANE_DESIGNS_H

#include "../aeroplanes.h"
#include "random.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

enum class Plane_wing { low, high, biplane, delta, swept };
enum class Plane_tail { low, t_tail, booms, fin_only };
enum class Plane_engines { none, jets_under_wing, jets_in_tail, nozzles, nose_propeller, wing_propellers, pusher };
/// Where booms are, as a part of the half span.
constexpr double boom_place = 0.4;

enum class Plane_gear { none, nose_wheel, tail_wheel };

struct Plane_design
{
  const char* name;
  Plane_wing wing;
  Plane_tail tail;
  Plane_engines engines;
  int number_of_engines;
  Plane_gear gear;
  bool canard = false;
  double length = 8, span = 10; ///< before they are varied
};

struct Plane_frame
{
  double length, span, r, chord;
  bool blunt; ///< a cowling in front instead of a pointed nose

  Plane_frame(const Plane_design& design, Random& random)
      : length(random.about(design.length)),
        span(random.about(design.span)),
        r(random.about(.06, .15) * design.length),
        chord(random.about(.15, .15) * design.length),
        blunt(design.engines == Plane_engines::nose_propeller)
  {}

  double nose() const { return .5 * length; }
  double tail() const { return -.5 * length; }
  double wing_z() const { return .1 * length; } ///< leading edge of the root
};

void add_fuselage(Assembly& plane, const Plane_frame& f, bool pod);

Solid half_wing(double x0, double y, double z, double half_span, double chord, double taper, double sweep, double rise);

/// The wings; returns the leading edge of the main one at the part `t` of the half span.
std::function<Point(double)> add_wings(Assembly& plane, const Plane_frame& f, const Plane_design& design);

void add_tail(Assembly& plane, const Plane_frame& f, const Plane_design& design, const Point& boom);

void add_propeller(Assembly& plane, const std::string& stem, const Label& label, const Point& hub, double radius);

void add_engines(Assembly& plane, const Plane_frame& f, const Plane_design& design,
                 const std::function<Point(double)>& leading_edge);

void add_gear_leg(Assembly& plane, const std::string& stem, const std::string& fine, const Point& top, double ground,
                  double wheel);

void add_gear(Assembly& plane, const Plane_frame& f, const Plane_design& design,
              const std::function<Point(double)>& leading_edge);

Assembly aeroplane(const Plane_design& design, std::uint64_t seed);

const std::vector<Plane_design>& aeroplane_designs();

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_AEROPLANE_DESIGNS_H
