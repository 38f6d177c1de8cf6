// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_ENERGY_MATRIX_H
#define CGAL_SHAPE_CORRESPONDENCE_ENERGY_MATRIX_H

#include <CGAL/Shape_correspondence/Part_map.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <CGAL/tags.h>

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `energy_matrix()`.
struct Energy_matrix_options
{
  Search_options search; ///< options of every match
  /// Energy, not negative, of a pair of connected parts one of which is unmatched; the default is about that of a bad
  /// deformation.
  double unmatched_energy = 0.5;
  /// Called from one thread at a time with the numbers of completed and of all pairs of shapes; `false` ends the work.
  std::function<bool(std::size_t done, std::size_t total)> progress;
};

/// \ingroup PkgShapeCorrespondenceSets
/// The distance of two shapes, and the correspondence of their parts.
struct Rated_map
{
  double energy = std::numeric_limits<double>::quiet_NaN(); ///< see `distance_energy()`; NaN: not computed
  Part_map map;                                             ///< part map from the source to the target
};

/// \ingroup PkgShapeCorrespondenceSets
/// The distance of two shapes: E of Eq. 1 per pair of connected parts of the deformed shape, so that shapes with
/// different numbers of parts can be compared. A pair with an unmatched part counts `unmatched_energy`, unless the
/// search charged it, so that a match of few parts does not give a small distance; a part without contacts counts as a
/// pair.
double distance_energy(const Correspondence& correspondence, double unmatched_energy);

/// \ingroup PkgShapeCorrespondenceSets
/// Matches the given ordered pairs of shapes (source, target); results are in the order of the pairs. Every shape is
/// aligned once. Bitwise identical sequentially and in parallel (`CGAL::Parallel_tag`, with TBB).
/// \pre the graphs are valid
/// \throw Invalid_input if an option is out of its range
template <typename ConcurrencyTag = CGAL::Sequential_tag>
std::vector<Rated_map> match_pairs(const std::vector<Structural_graph>& shapes,
                                   const std::vector<std::pair<std::size_t, std::size_t>>& pairs,
                                   const Energy_matrix_options& options = {});

/// \ingroup PkgShapeCorrespondenceSets
/// Matches pairs of prepared shapes, whose cached data are reused.
template <typename ConcurrencyTag = CGAL::Sequential_tag>
std::vector<Rated_map> match_pairs(const std::vector<Prepared_shape>& shapes,
                                   const std::vector<std::pair<std::size_t, std::size_t>>& pairs,
                                   const Energy_matrix_options& options = {});

/// \ingroup PkgShapeCorrespondenceSets
/// The energies and part maps of all ordered pairs of a set of shapes.
struct Energy_matrix
{
  Eigen::MatrixXd energies;   ///< `distance_energy()` of source × target; 0 on the diagonal
  std::vector<Part_map> maps; ///< ordered by source, then target
  bool complete = true;       ///< whether all pairs were matched: `progress` did not end the work

  /// The part map of a pair of shapes.
  const Part_map& map(std::size_t source, std::size_t target) const
  {
    return maps[source * std::size_t(energies.cols()) + target];
  }
};

/// \ingroup PkgShapeCorrespondenceSets
/// Matches all ordered pairs of shapes: n (n - 1) matches and O(n²) memory.
/// \pre the graphs are valid
/// \throw Invalid_input if an option is out of its range
template <typename ConcurrencyTag = CGAL::Sequential_tag>
Energy_matrix energy_matrix(const std::vector<Structural_graph>& shapes, const Energy_matrix_options& options = {});

/// \ingroup PkgShapeCorrespondenceSets
/// Symmetric distances: the mean of the `energies` of both directions.
Eigen::MatrixXd symmetric_distances(const Eigen::MatrixXd& energies);

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_ENERGY_MATRIX_H
