// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_COLLECTION_JSON_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_COLLECTION_JSON_H

#include <CGAL/Shape_correspondence/co_analysis.h>
#include <CGAL/Shape_correspondence/nearest_shapes.h>
#include <CGAL/Shape_correspondence/transitive_correspondence.h>

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Largest number of shapes for which the JSON of a collection contains the energies; for more, write a matrix file.
constexpr std::size_t largest_written_matrix = 1000;

/// \ingroup PkgShapeCorrespondenceIO
/// The results of the analysis of a set of shapes.
struct Collection
{
  /// A shape of the set.
  struct Shape
  {
    std::string name;               ///< name of the shape
    std::string file;               ///< the file or folder from which it was read
    std::vector<std::string> parts; ///< names of its parts
  };
  /// Two shapes for which a chain via other shapes has less energy than the direct match.
  struct Bridge
  {
    std::size_t source;                       ///< index of the source shape
    std::size_t target;                       ///< index of the target shape
    Transitive_correspondence correspondence; ///< the correspondence via other shapes
  };

  std::vector<Shape> shapes; ///< the shapes; all indices refer to this order
  /// The energies of ordered pairs of shapes. A function, since a matrix of them might exceed memory.
  std::function<double(std::size_t source, std::size_t target)> energy;
  std::size_t medoid = 0;       ///< index of the `topological_medoid()`
  std::vector<Shape_pair> tree; ///< a minimum spanning tree by `symmetric_distances()`
  std::vector<Bridge> bridges;  ///< pairs of shapes for which a chain of shapes has less energy, the largest gain first
  std::size_t bridge_count = 0; ///< number of all such pairs, of which `bridges` may list only some
  Co_analysis co_analysis;      ///< labels of parts
  std::size_t co_analysis_shape_pairs = 0; ///< number of unordered pairs of shapes whose maps were clustered
  std::vector<Shape_pair_map> matches;     ///< maps of ordered pairs of shapes to be written
  std::vector<std::string> warnings;       ///< sentences on approximations and early ends
};

/// \ingroup PkgShapeCorrespondenceIO
/// Writes the analysis of a set of shapes in the JSON format `shape_correspondence/collection`, version 1.
/// Needs nlohmann-json: link `CGAL::Shape_correspondence_IO`.
void write_collection_json(std::ostream& out, const Collection& collection);

/// \ingroup PkgShapeCorrespondenceIO
/// The shapes of a collection that are nearest to a query.
struct Nearest_in_collection
{
  Collection::Shape query;               ///< the query
  std::vector<Collection::Shape> shapes; ///< all shapes of the collection
  Nearest_shapes nearest;                ///< the result, by index into `shapes`
  std::vector<std::string> warnings;     ///< sentences on approximations and early ends
};

/// \ingroup PkgShapeCorrespondenceIO
/// Writes the nearest shapes `found` in the JSON format `shape_correspondence/nearest`, version 1.
void write_nearest_json(std::ostream& out, const Nearest_in_collection& found);

} // namespace CGAL::Shape_correspondence::IO

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_COLLECTION_JSON_H
