// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "velocipedes.h"

namespace CGAL::Shape_correspondence::generator {

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
