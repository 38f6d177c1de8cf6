// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <iosfwd>

namespace CGAL::Shape_correspondence::cli {

/// Writes a correspondence for people, in lines of 80 characters where names allow: a row for each block
/// (`correspondence_blocks()`) with role, operation and confidence, then the unmatched parts, the energy and the
/// distance.
/// \param verbose whether all parts of large blocks are listed
void write_match_table(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                       const Structural_graph& target, bool verbose);

/// Writes what became of each symmetry group of the deformed shape, with its share of the energy.
void write_group_table(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                       const Structural_graph& target);

} // namespace CGAL::Shape_correspondence::cli
