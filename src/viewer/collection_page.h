// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/Json.h"

#include <iosfwd>

namespace CGAL::Shape_correspondence::IO {

/// Writes a page with pictures of shapes, their spanning tree, and the match of two that are clicked.
/// \param data "notes", lines of text; "total", how many shapes the collection has; "shapes", those shown, with the
/// points of their parts; "medoid", an index; "tree", pairs of shapes with their distances; "maps", by pair; "colours"
void write_collection_page(std::ostream& out, const Json& data);

} // namespace CGAL::Shape_correspondence::IO
