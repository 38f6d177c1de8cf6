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
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <functional>
#include <iosfwd>
#include <optional>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Largest number of shapes on a page, so that a browser can open it.
constexpr std::size_t largest_pictured = 1000;

/// \ingroup PkgShapeCorrespondenceIO
/// Writes a collection as a web page that needs no network: a gallery of the shapes with the medoid marked, the minimum
/// spanning tree with the medoid as its root, and the correspondence of two shapes that are clicked. Parts of one
/// cluster have one colour everywhere. Surfaces are simplified to 400 000 triangles in all; curves and sheets of more
/// than 50 shapes are drawn with few triangles. Of more than `largest_pictured` shapes the page shows only so many: the
/// medoid, and others drawn evenly from all branches of the spanning tree. Needs nlohmann-json: link
/// `CGAL::Shape_correspondence_IO`.
/// \param out the stream
/// \param collection what is shown
/// \param graph the structural graph of a shape by its index, called once for each
/// \param maps those that the page shows if their two shapes are clicked; for others it shows the command to match them
/// \param model the surfaces of a shape, called once for each, with the parts of its graph in the same order; if it is
/// empty or returns nothing, the page shows curves and sheets
void write_collection_html(std::ostream& out, const Collection& collection,
                           const std::function<Structural_graph(std::size_t)>& graph,
                           const std::vector<Shape_pair_map>& maps,
                           const std::function<std::optional<Segmented_shape>(std::size_t)>& model = {});

} // namespace IO
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_WRITE_COLLECTION_HTML_H
