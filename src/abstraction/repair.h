// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/deadline.h"

#include <CGAL/Shape_correspondence/Part_abstraction.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <stdexcept>

namespace CGAL::Shape_correspondence::internal {

/// Thrown if a part cannot be abstracted by the mean curvature flow; the message says why. Caught in `abstraction/`.
class Flow_failure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A part repaired for the mean curvature flow.
struct Repaired_part
{
  Part_mesh mesh;    ///< closed, connected, oriented outwards
  double volume = 0; ///< volume of the solid components, or of the wrap, if there is one and not all are solid
  Abstraction_report::Repair repair = Abstraction_report::Repair::NONE;
  bool several_components = false;
};

/// Makes a part closed and connected: its dominant component, with holes filled or, if that fails, wrapped; without a
/// dominant component, a wrap around everything. \throw Flow_failure, Out_of_time
Repaired_part repair_part(const Part_mesh& part, const Deadline& deadline);

/// Remeshes to triangles of uniform size, as the flow needs them: a leg of eight vertices would collapse to a point.
/// Splits and collapses edges and spreads vertices over the surface (Botsch and Kobbelt 2004, without edge flips).
/// Remeshing takes most of the time, and CGAL's `isotropic_remeshing()` would take three times as many instructions.
/// \pre `solid` is a closed manifold
/// \throw Flow_failure
Part_mesh remeshed(const Part_mesh& solid, double edge_length, const Deadline& deadline);

} // namespace CGAL::Shape_correspondence::internal
