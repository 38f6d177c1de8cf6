// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_STRUCTURAL_GRAPH_CACHE_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_STRUCTURAL_GRAPH_CACHE_H

#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>

#include <optional>
#include <string>

namespace CGAL::Shape_correspondence::IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Identifies the result of `build_structural_graph()` for a shape: a hash (SHA-1) of all names, coordinates and
/// triangles (bitwise), of all options that the graph depends on except the time limit, and of the version of the
/// algorithms. Only the type of the abstractor is hashed: use one folder for each state of a stateful one. Linear time.
std::string content_hash(const Segmented_shape& shape, const Structure_options& options);

/// \ingroup PkgShapeCorrespondenceIO
/// A folder of structural graphs, each stored under the content hash of its input. Several processes may use one folder
/// at a time. A file that is damaged, or does not match its name, counts as missing.
class Structural_graph_cache
{
public:
  /// Creates the folder if it does not exist.
  /// \throw Invalid_input if it cannot be used
  explicit Structural_graph_cache(std::string folder);

  /// The graph with this content hash; none if it is not stored. Bitwise identical except for the hulls and most
  /// surface samples of the parts, which are not saved (the samples used by matching are).
  std::optional<Structural_graph> find(const std::string& content) const;

  /// Whether the file for this content hash is damaged.
  bool is_damaged(const std::string& content) const;

  /// Saves a graph under its `content`, replacing an earlier one. A graph with a part that reached the time limit is
  /// not saved, since it depends on the speed of the machine.
  /// \throw Invalid_input if the file cannot be written
  void insert(const Structural_graph& graph) const;

private:
  std::string path(const std::string& content) const;

  std::string folder_;
};

} // namespace CGAL::Shape_correspondence::IO

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_STRUCTURAL_GRAPH_CACHE_H
