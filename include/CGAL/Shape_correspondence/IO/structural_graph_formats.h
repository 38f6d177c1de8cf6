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

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <iosfwd>

namespace CGAL::Shape_correspondence::IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Writes the graph in GraphML: a node for every group, with the names of its `parts`, its `symmetry` and its
/// `solidity`; an edge for every two groups in contact, with the number of its `contacts`. Geometry is left out.
void write_structural_graph_graphml(std::ostream& out, const Structural_graph& graph);

/// \ingroup PkgShapeCorrespondenceIO
/// Writes the graph in the DOT language of Graphviz, every node labelled with its parts.
void write_structural_graph_dot(std::ostream& out, const Structural_graph& graph);

} // namespace CGAL::Shape_correspondence::IO

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_STRUCTURAL_GRAPH_FORMATS_H
