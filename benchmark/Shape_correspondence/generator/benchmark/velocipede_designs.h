// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_VELOCIPEDE_DESIGNS_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_VELOCIPEDE_DESIGNS_H

#include "../tricycle.h"
#include "random.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

/// A tyre, its spokes and its hub.
void add_wheel(Assembly& shape, const std::string& stem, const std::string& where, const Point& axle, double radius,
               double tyre_radius, int n);

/// A solid small wheel about x, its axle `half_axle` long on either side.
Solid solid_wheel(const Point& axle, double radius, double half_axle);

/// The same on the left and on the right.
void add_wheel_pair(Assembly& shape, const std::string& stem, const std::string& where, const Point& axle,
                    double radius, double tyre_radius, int n);

enum class Bars { flat, drop, swept };

void add_handlebar(Assembly& bike, const std::string& suffix, const Point& head_high, const Point& steer, Bars kind,
                   double reach);

void add_saddle(Assembly& bike, const std::string& suffix, const Point& cluster, const Point& top);

void add_fork(Assembly& bike, const Point& crown, const Point& axle, double rake);

void add_chain(Assembly& bike, const Point& front, const Point& rear);

/// Where a frame's tubes meet, in its plane of symmetry.
struct Frame_joints
{
  double radius;
  Point front_axle, rear_axle, bracket, head_low, head_high, cluster, saddle, steer;

  Frame_joints(Random& random, double wheel_radius, double extra_length = 0) : radius(wheel_radius)
  {
    const double base = random.about(1.02, .05) + extra_length;
    front_axle = {0, radius + .018, .5 * base};
    rear_axle = {0, radius + .018, -.5 * base};
    bracket = {0, random.about(.28, .06), rear_axle.z() + .43};
    const double lean = random.between(.28, .36);
    steer = Point(0, 1, -lean).normalized();
    head_low = front_axle + Point(0, radius + .05, -lean * (radius + .05) - .04);
    head_high = head_low + random.about(.15, .2) * steer;
    cluster = bracket + Point(0, .5, -.15);
    saddle = bracket + random.about(.7, .05) * Point(0, 1, -.3).normalized();
  }
};

/// The tubes of a frame but for the stays at the rear wheel.
void add_front_frame(Assembly& bike, const Frame_joints& at, bool step_through);

void add_stays(Assembly& bike, const Frame_joints& at);

void add_pedals(Assembly& bike, const std::string& suffix, const Point& axle);

/// A mudguard over the upper rear of a wheel.
void add_mudguard(Assembly& bike, const std::string& where, const Point& axle, double radius, double from, double to,
                  double width = .055);

struct Bicycle_design
{
  Bars bars;
  bool step_through = false, mudguards = false, rack = false, basket = false;
  double wheel = .335, tyre = .018;
};

Assembly bicycle(const char* name, const Bicycle_design& design, std::uint64_t seed);

/// Two riders: another bracket, seat tube, saddle, handlebar and pair of pedals in front.
Assembly tandem(const char* name, bool step_through, std::uint64_t seed);

/// A high wheel with pedals in front, a small one behind.
Assembly penny_farthing(const char* name, std::uint64_t seed);

/// A child's tricycle: that of data/, in other proportions.
Assembly child_tricycle(const char* name, std::uint64_t seed);

/// A bicycle with an axle and two wheels behind, a basket over it.
Assembly adult_tricycle(const char* name, std::uint64_t seed);

/// A box between two wheels in front, the rest of a bicycle behind it.
Assembly cargo_tricycle(const char* name, std::uint64_t seed);

/// A deck to stand on, a tall steering column; one wheel in front, or two.
Assembly scooter(const char* name, bool two_in_front, std::uint64_t seed);

enum class Wheelchair { standard, sport, transport };

Assembly wheelchair(const char* name, Wheelchair kind, std::uint64_t seed);

/// All velocipedes; `seed` is of the first one.
std::vector<Assembly> velocipedes(std::uint64_t seed);

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_VELOCIPEDE_DESIGNS_H
