// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_STRUCTURAL_GRAPH_FORMATS_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_STRUCTURAL_GRAPH_FORMATS_H

#include <CGAL/Shape_correspondence/build_structural_graph.h>

#include <iosfwd>
#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Writes the graph for graph tools: a node for every group, with the names of its `parts`, its `symmetry` and its
/// `solidity`; an edge for every two groups in contact, with the number of its `contacts`. Geometry is left out.
void write_structural_graph_graphml(std::ostream& out, const Structural_graph& graph);

/// \ingroup PkgShapeCorrespondenceIO
/// The same for Graphviz, every node labelled with its parts.
void write_structural_graph_dot(std::ostream& out, const Structural_graph& graph);

/// \ingroup PkgShapeCorrespondenceIO
/// Reads a structure graph in the XML that programs for topology-varying shape matching exchange: a `document` of
/// - `node`s: an `id`, a `type` (`CURVE` or `SHEET`), of a sheet `controls` with two counts `c`, the control `point`s
///   of a cubic B-spline with clamped uniform knots, and their `weights`, 1 if there are none;
/// - `edge`s: two nodes `n`, and for each a `coord` of parameters `uv`, one for each contact region; without `coord`s
///   the contact is where the parts are nearest;
/// - `group`s: nodes `n`. Their symmetry is the detected one, or else the mirror plane half-way between two members, or
///   the mean step between more. Without `group`s, these are detected.
///
/// Splines are sampled; meshes that nodes name are not read, so that volumes are unknown.
/// \param in the text
/// \param file_name names the input in messages
/// \param up the upright direction, which the format does not have
/// \param options of what is detected
/// \throw Invalid_input if the text is not XML or not such a document; the message names the node, edge or group
Structural_graph read_structural_graph_xml(std::istream& in, const std::string& file_name,
                                           const Point& up = Point(0, 0, 1), const Structure_options& options = {});

} // namespace IO
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_STRUCTURAL_GRAPH_FORMATS_H
