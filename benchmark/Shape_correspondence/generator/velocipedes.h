// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "assembly.h"
#include "primitives.h"

namespace CGAL::Shape_correspondence::generator {

Solid tyre(const Point& middle, double radius, double thickness, int n = 36);

/// A post laid along x, its height from -1/2 to 1/2 about `middle`.
Solid along_x(const Profile& profile, const Point& middle, int n = 12);

/// Wire spokes of a wheel in the plane of y and z, from both flanges of the hub; many pieces, one sheet.
Solid spokes(const Point& middle, double hub_radius, double radius, double half_width, int n);

/// A saddle pointing forward, its top at the origin: wide behind, a nose in front, sides turned down.
Solid saddle(double length, double width);

Profile hub_profile(double half_length, double flange_radius, double flange);

/// A chain around two sprockets in a plane of y and z, radii first, as a closed path.
Path chain_path(const Point& front, double front_radius, const Point& rear, double rear_radius);

/// Two cranks with pedals, each other's copy by half a turn about the vertical axis through `axle`: from `start` left
/// of the axle over `elbow` to `end`, both relative to it.
void add_cranks(Assembly& shape, const Names& cranks, const Names& pedals, const Point& axle, double start,
                const Point& elbow, const Point& end);

/// The joints of a bicycle's frame, in its plane of symmetry.
struct Bicycle_joints
{
  Point front_axle{0, .353, .52}, rear_axle{0, .353, -.5}, bottom_bracket{0, .28, -.07};
  Point crown{0, .702, .359}, head_low{0, .715, .355}, head_high{0, .865, .306};
  Point seat_cluster{0, .79, -.226}, saddle{0, .985, -.285};
};

void add_bicycle_frame(Assembly& bike, const Bicycle_joints& at);

void add_bicycle_steering(Assembly& bike, const Bicycle_joints& at);

void add_bicycle_wheels(Assembly& bike, const Bicycle_joints& at);

/// A city bicycle.
Assembly bicycle();

} // namespace CGAL::Shape_correspondence::generator
