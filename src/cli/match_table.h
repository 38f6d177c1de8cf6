// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <iosfwd>

namespace CGAL::Shape_correspondence::cli {

/// Writes a correspondence for people: a line a pair of parts, gathered by group, then what is left and the energy.
void write_match_table(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                       const Structural_graph& target);

} // namespace CGAL::Shape_correspondence::cli
