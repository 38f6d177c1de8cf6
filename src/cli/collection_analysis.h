// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Collection_options.h"
#include "cli/collection_shapes.h"
#include "cli/collection_work.h"
#include "io/system/Mapped_matrix.h"

#include <CGAL/Shape_correspondence/IO/collection_json.h>
#include <CGAL/Shape_correspondence/co_analysis.h>

#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// A shape's distances from the others.
struct Shape_distances
{
  double mean = 0;
  std::size_t nearest = 0;
  double nearest_distance = 0;
};

/// The analysis of a collection, with the energies and maps that it is computed from.
struct Analysis
{
  IO::Mapped_matrix energies;
  std::vector<Shape_distances> distances; ///< by shape
  IO::Collection collection;              ///< refers to the energies
  std::vector<Shape_pair_map> maps;
};

/// Reads all pairs twice, first the energies and then those maps that are clustered or on bridges. For n shapes, 16 n²
/// bytes for energies and distances are in a file of the store, if there is one, else in memory; then memory is needed,
/// for each of 64 n maps at most, of some hundred bytes, and that of `co_analysis()`.
Analysis analysed(const Collection_shapes& shapes, const Collection_options& options, Collection_work& work);

/// The shapes nearest to a query. \param file names it in the result
IO::Nearest_in_collection nearest_in_collection(const Structural_graph& query, const std::string& file,
                                                const Collection_shapes& shapes, std::size_t count,
                                                const Energy_matrix_options& matching);

} // namespace CGAL::Shape_correspondence::cli
