// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_WRITE_GLB_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_WRITE_GLB_H

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <iosfwd>

namespace CGAL::Shape_correspondence::IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Writes a picture of a correspondence as binary glTF 2.0: both shapes in their common frame side by side, source on
/// the left, corresponding parts in the same colour, unmatched parts grey, one node for each part with the part's name.
/// Further scenes show the curves and sheets, and the contacts as lines. Shapes without meshes (`source_shape` or
/// `target_shape` null, for graphs read from files) are drawn by their curves and sheets. Link
/// `CGAL::Shape_correspondence_IO`.
void write_correspondence_glb(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                              const Structural_graph& target, const Segmented_shape* source_shape = nullptr,
                              const Segmented_shape* target_shape = nullptr);

/// \ingroup PkgShapeCorrespondenceIO
/// Writes a picture of a structural graph: transparent surfaces, curves as tubes and sheets as patches, one colour for
/// each group, and a line for each contact.
void write_structural_graph_glb(std::ostream& out, const Structural_graph& graph,
                                const Segmented_shape* shape = nullptr);

} // namespace CGAL::Shape_correspondence::IO

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_WRITE_GLB_H
