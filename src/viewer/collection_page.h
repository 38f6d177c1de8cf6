// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_VIEWER_COLLECTION_PAGE_H
#define CGAL_SHAPE_CORRESPONDENCE_VIEWER_COLLECTION_PAGE_H

#include "io/Json.h"

#include <iosfwd>

namespace CGAL {
namespace Shape_correspondence {
namespace IO {

/// Writes a page with pictures of shapes, their spanning tree, and the match of two that are clicked.
/// \param data "notes", lines of text; "total", how many shapes the collection has; "shapes", those shown, with the
/// points of their parts; "medoid", an index; "tree", pairs of shapes with their distances; "maps", by pair; "colours"
void write_collection_page(std::ostream& out, const Json& data);

} // namespace IO
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_VIEWER_COLLECTION_PAGE_H
