// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_STRUCTURAL_GRAPH_JSON_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_STRUCTURAL_GRAPH_JSON_H

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>

#include <iosfwd>
#include <optional>
#include <string>

namespace CGAL::Shape_correspondence::IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Writes a structural graph in the JSON format `shape_correspondence/graph`, version 1. Reading gives a bitwise
/// identical graph, except for the hulls of the parts, which are not saved, and their surface points, of which only the
/// 32 used by matching are saved (key `surface` of a part: a list of points, optional). The key `method` of a part's
/// `abstraction` is the value of `Abstraction_report::Method` in lower case. Needs nlohmann-json: link
/// `CGAL::Shape_correspondence_IO`.
void write_structural_graph_json(std::ostream& out, const Structural_graph& graph);

/// \ingroup PkgShapeCorrespondenceIO
/// Reads a structural graph; groups, contacts and the frame are computed if the file has none. Parts in none of the
/// given groups become single groups; if `options.symmetry.enabled` is false, all parts do.
/// \param in the text
/// \param file_name name of the input in messages
/// \param options options of the detection of groups and contacts
/// \throw Invalid_input if the text is not JSON, or not a valid structural graph; the message gives the place
Structural_graph read_structural_graph_json(std::istream& in, const std::string& file_name,
                                            const Structure_options& options = {});

/// \ingroup PkgShapeCorrespondenceIO
/// The model from which a graph file was built, if its parts name their meshes: the key `mesh` of a part is the path of
/// a model file relative to the folder of the graph file. None if no part names a mesh. Reads the graph file again.
/// \throw Invalid_input if only some parts name a mesh, or a mesh is unusable
std::optional<Segmented_shape> read_part_meshes(const std::string& graph_file, const Structural_graph& graph,
                                                const Reading_options& options = {});

} // namespace CGAL::Shape_correspondence::IO

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_STRUCTURAL_GRAPH_JSON_H
