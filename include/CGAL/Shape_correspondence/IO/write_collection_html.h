// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_WRITE_COLLECTION_HTML_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_WRITE_COLLECTION_HTML_H

#include <CGAL/Shape_correspondence/IO/collection_json.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <functional>
#include <iosfwd>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Shapes that a page shows at most, so that a browser can open it.
constexpr std::size_t largest_pictured = 1000;

/// \ingroup PkgShapeCorrespondenceIO
/// Writes a collection as a web page that needs no network: a grid of pictures of the shapes by their curves and
/// sheets, parts of one cluster in one colour, the medoid marked; the spanning tree with the medoid as its root; and
/// for two shapes that are clicked, their match, turned by the mouse. Of more than `largest_pictured` shapes it shows
/// so many, the medoid and others evenly from all branches of the spanning tree, and says so. Needs nlohmann-json: link
/// `CGAL::Shape_correspondence_IO`.
/// \param out the stream
/// \param collection what is shown
/// \param graph the structural graph of a shape by its index, called once for each
/// \param maps those that the page shows when their two shapes are clicked
void write_collection_html(std::ostream& out, const Collection& collection,
                           const std::function<Structural_graph(std::size_t)>& graph,
                           const std::vector<Shape_pair_map>& maps);

} // namespace IO
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_WRITE_COLLECTION_HTML_H
