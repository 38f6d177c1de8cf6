// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "assembly.h"
#include "primitives.h"

namespace CGAL::Shape_correspondence::generator {

Label leg_label(const std::string& row);

/// A seat of width `front` in front and `back` behind, whose middle is lower than its edges by `dish`.
Solid dished_seat(double front, double back, double depth, double y, double thickness, double dish,
                  const Slab_options& options);

/// A back rest of some width from `low` along `rise`, whose middle is `bulge` behind its sides.
Solid curved_rest(const Point& low, const Point& rise, double width, double bulge, double thickness,
                  const Slab_options& options);

/// A chair with four plain legs, aprons under the seat, a bent panel between two posts.
Assembly chair_four_legged();

/// An office chair: cushions, a gas column, a star of five legs on casters, arms.
Assembly chair_swivel();

/// A ladder-back chair with arms; its rear legs continue as the posts of the back.
Assembly chair_slatted();

/// A turned leg on the floor, thickest at 0.7 of its height.
Solid turned_leg(double height, double radius);

Solid turned_leg(const Point& foot, const Point& top, double radius);

/// A Windsor chair: turned splayed legs, an H of stretchers, spindles under a bow.
Assembly chair_spindle();

/// A bar stool: a round board with a cushion, four splayed legs, a foot ring.
Assembly stool();

/// A table with a top on two saw-horses.
Assembly table_trestle();

/// A table with a round top and an edge ring, on a turned post with four curved feet.
Assembly table_pedestal();

/// A kitchen table: turned legs, aprons, a drawer with a knob.
Assembly table_four_legged();

/// A single bed, its head at the back: four posts, slats, a mattress, two pillows.
Assembly bed_slatted();

/// A desk lamp with two hinged pairs of rods and a bell for a shade.
Assembly lamp_desk();

/// A landing wheel on an axle along x, as a solid of revolution.
Solid landing_wheel(const Point& middle, double radius, double width);

/// A jet engine along z about the origin, hollow in front, its nose at z = 0.
Solid jet_engine(double length, double radius);

/// An airliner: swept low wings, two jets on pylons, gear down.
Assembly airplane_twin_engine();

/// A propeller about the z axis through the origin: two twisted blades in one piece.
Solid two_bladed_propeller(double radius, double chord);

/// A light high-wing aeroplane: braced wings, one propeller, nose wheel.
Assembly airplane_propeller();

Solid tyre(const Point& middle, double radius, double thickness, int n = 36);

/// A solid of revolution along x; height 0 of its profile is at `middle`.
Solid along_x(const Profile& profile, const Point& middle, int n = 12);

/// Wire spokes of a wheel in a plane of y and z, from both flanges of the hub: many components, of kind sheet.
Solid spokes(const Point& middle, double hub_radius, double radius, double half_width, int n);

/// A saddle pointing forward, its top at the origin: wide behind, a nose in front, sides turned down.
Solid saddle(double length, double width);

Profile hub_profile(double half_length, double flange_radius, double flange);

/// The closed path of a chain around two sprockets in a plane of y and z.
Path chain_path(const Point& front, double front_radius, const Point& rear, double rear_radius);

/// Adds two cranks with pedals, copies by half a turn about the vertical axis through `axle`. Relative to `axle`, the
/// left crank leads from `start` in x over `elbow` to `end`.
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

/// The joints of a child's tricycle, in its plane of symmetry.
struct Tricycle_joints
{
  Point front_axle{0, .2, .3}, head_low{0, .43, .225}, head_high{0, .53, .192};
  Point seat_joint{0, .3, -.13}, rear_axle{0, .115, -.3}, saddle{0, .455, -.165};
};

void add_tricycle_frame(Assembly& trike, const Tricycle_joints& at);

void add_tricycle_steering(Assembly& trike, const Tricycle_joints& at);

/// The rear wheels share the fine label of a bicycle's one rear wheel.
void add_tricycle_wheels(Assembly& trike, const Tricycle_joints& at);

/// A child's tricycle, its pedals on the front wheel.
Assembly tricycle();

} // namespace CGAL::Shape_correspondence::generator
