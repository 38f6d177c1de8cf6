// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_CLI_MATCH_TABLE_H
#define CGAL_SHAPE_CORRESPONDENCE_CLI_MATCH_TABLE_H

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <iosfwd>

namespace CGAL {
namespace Shape_correspondence {
namespace cli {

/// Writes a correspondence for people: a line a pair of parts, gathered by group, then what is left and the energy.
void write_match_table(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                       const Structural_graph& target);

} // namespace cli
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_CLI_MATCH_TABLE_H
