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

namespace CGAL::Shape_correspondence::IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Largest number of shapes that a page shows, so that browsers can open it.
constexpr std::size_t largest_pictured = 1000;

/// \ingroup PkgShapeCorrespondenceIO
/// Writes a collection as a web page that needs no network: a gallery of the shapes with the medoid marked, the minimum
/// spanning tree with the medoid as its root, and the correspondence of two shapes selected by clicks. Parts of one
/// cluster have the same colour everywhere. Surfaces are simplified to 400 000 triangles in all; curves and sheets of
/// more than 50 shapes are drawn with few triangles. If there are more than `largest_pictured` shapes, the page shows
/// that number: the medoid, and others chosen evenly from all branches of the spanning tree. Needs nlohmann-json: link
/// `CGAL::Shape_correspondence_IO`.
/// \param out the stream
/// \param collection the analysis of the set
/// \param graph the structural graph of a shape by its index, called once for each
/// \param maps the maps that the page shows for selected pairs; for other pairs it shows the command to match them
/// \param model the surfaces of a shape, called once for each, with its parts in the order of its graph; if empty or
/// without a result, the page shows curves and sheets
void write_collection_html(std::ostream& out, const Collection& collection,
                           const std::function<Structural_graph(std::size_t)>& graph,
                           const std::vector<Shape_pair_map>& maps,
                           const std::function<std::optional<Segmented_shape>(std::size_t)>& model = {});

} // namespace CGAL::Shape_correspondence::IO

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_WRITE_COLLECTION_HTML_H
