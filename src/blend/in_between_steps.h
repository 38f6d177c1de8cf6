// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/In_between_shape.h"

namespace CGAL::Shape_correspondence::internal {

/// The least size of a part that is stretched, of the shape's height; guards divisions by sizes.
constexpr double least_stretched_size = 1e-6;

/// The shape of a blend at `t`, strictly between its ends: the steps below, in turns.
In_between_shape in_between_shape(const Blend_structure& blend, const Task_times& times, double t);

/// Makes mirror images mirror images of each other, first their boxes and then their surfaces: each one goes half of
/// the way to the other. At the ends, which need not be quite symmetric, nothing moves.
void symmetrise(In_between_shape& shape);

/// Makes the box of a part and that of its mirror image mirror images of each other, for all parts of a kind.
/// \param of_matched whether those that are matched, or the others
void symmetrise_boxes(In_between_shape& shape, bool of_matched);

/// Moves every point of a part and of its mirror image half of the way to where the other is, seen in the mirror, some
/// times over. Nothing for a part whose image comes before it, or one that is so far from the mirror image of its image
/// that it would be crushed, or has so many points that it would be crumpled.
void symmetrise_surfaces(In_between_shape& shape, std::size_t part);

/// Unmatched parts are as much as remains of them, and follow what they are attached to; none goes into the ground.
void place_unmatched_parts(In_between_shape& shape);

enum class Relaxation { NOTHING_TO_DO, CLOSED, OPEN };

/// Closes the gaps of contacts and puts feet on the ground, by relaxation: all matched parts move at once, by the
/// affine motions nearest to that, mirror images alike.
Relaxation relax_contacts(In_between_shape& shape);

/// Moves components that have come apart from the rest, the smallest one first, back to what is nearest to them.
/// Returns whether there were any.
bool reconnect_components(In_between_shape& shape);

} // namespace CGAL::Shape_correspondence::internal
