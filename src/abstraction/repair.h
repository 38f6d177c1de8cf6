// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "abstraction/deadline.h"

#include <CGAL/Shape_correspondence/Part_abstraction.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>

namespace CGAL::Shape_correspondence::internal {

/// A part repaired for the flow.
struct Repaired_part
{
  Part_mesh mesh;    ///< closed, connected, oriented outwards
  double volume = 0; ///< volume enclosed by all components of the part
  Abstraction_report::Repair repair = Abstraction_report::Repair::NONE;
  bool several_components = false;
};

/// Makes a part closed and connected: its dominant component with holes filled, or a wrap around everything.
/// \throw Flow_failure
Repaired_part repair_part(const Part_mesh& part, const Deadline& deadline);

} // namespace CGAL::Shape_correspondence::internal
