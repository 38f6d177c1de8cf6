// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "assembly.h"
#include "primitives.h"

namespace CGAL::Shape_correspondence::generator {

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

} // namespace CGAL::Shape_correspondence::generator
