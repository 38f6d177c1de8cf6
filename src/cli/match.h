// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/load_shape.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <iosfwd>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// Correspondences of two shapes, the best first, and the time in seconds that everything took.
struct Matched_shapes
{
  std::vector<Correspondence> ranked;
  IO::Match_seconds seconds;
};

Matched_shapes match_shapes(const Loaded_shape& source, const Loaded_shape& target, const Search_options& options);

/// Writes a correspondence as a table, in lines of 80 characters if names allow: one row for each block
/// (`correspondence_blocks()`) with role, operation and confidence, then unmatched parts, energy and distance.
/// \param verbose whether to list all parts of large blocks
void write_match_table(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                       const Structural_graph& target, bool verbose);

} // namespace CGAL::Shape_correspondence::cli
