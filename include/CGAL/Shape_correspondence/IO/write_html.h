// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_WRITE_HTML_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_WRITE_HTML_H

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <iosfwd>

namespace CGAL::Shape_correspondence::IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Writes a structural graph as a web page that needs no network: transparent surfaces, curves and sheets, one colour
/// for each group, a line for each contact, and a table of the parts. The page contains the outputs of
/// `write_structural_graph_glb()` and `write_structural_graph_json()`; surfaces of more than 100 000 triangles are
/// simplified. If `shape` is null (for a graph read from a file), only curves and sheets are drawn. Needs
/// nlohmann-json: link `CGAL::Shape_correspondence_IO`.
void write_structural_graph_html(std::ostream& out, const Structural_graph& graph,
                                 const Segmented_shape* shape = nullptr);

/// \ingroup PkgShapeCorrespondenceIO
/// Writes a correspondence as a web page: both shapes side by side under one camera, source on the left, corresponding
/// parts in the same colour, unmatched parts grey, and a table of corresponding parts. Pointing at a part highlights it
/// and its counterparts. `source_shape` and `target_shape` are null for shapes without meshes. The page contains the
/// outputs of `write_correspondence_glb()` and `write_correspondence_json()`.
void write_correspondence_html(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                               const Structural_graph& target, const Segmented_shape* source_shape = nullptr,
                               const Segmented_shape* target_shape = nullptr);

} // namespace CGAL::Shape_correspondence::IO

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_WRITE_HTML_H
