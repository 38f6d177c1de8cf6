// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "abstraction/deadline.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

namespace CGAL::Shape_correspondence::internal {

/// Remeshes to triangles of uniform size, as the flow needs them: a leg of eight vertices would collapse to a point.
/// Splits and collapses edges and spreads vertices over the surface (Botsch and Kobbelt 2004, without edge flips).
/// Remeshing takes most of the time, and CGAL's `isotropic_remeshing()` three times as many instructions.
/// \pre `solid` is a closed manifold
/// \throw Flow_failure
Part_mesh remeshed(const Part_mesh& solid, double edge_length, const Deadline& deadline);

} // namespace CGAL::Shape_correspondence::internal
