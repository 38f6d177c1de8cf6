// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_MARKOV_CLUSTERING_H
#define CGAL_SHAPE_CORRESPONDENCE_MARKOV_CLUSTERING_H

#include <cstddef>
#include <vector>

namespace Eigen {
template <typename Scalar, int Options, typename StorageIndex>
class SparseMatrix; // avoids <Eigen/SparseCore>, which takes a second to compile
}

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `markov_clustering()`.
struct Markov_clustering_options
{
  /// Exponent for the entries of columns, more than 1; larger values give more and smaller clusters.
  double inflation = 2;
  double expansion_limit = 1e-4;   ///< share of the sum of a column below which an entry is dropped
  std::size_t column_limit = 1000; ///< largest number of entries of a column; the smallest ones are dropped
  /// Largest number of entries of the matrix, 28 bytes each; it also limits a column to an even share of it.
  std::size_t entry_limit = 30'000'000;
  /// Largest difference, at convergence, between the largest entry of a column and the sum of squares of its entries.
  double tolerance = 1e-3;
  int maximum_iterations = 200; ///< limit for the iterations of squaring and inflating
};

/// \ingroup PkgShapeCorrespondenceSets
/// The result of `markov_clustering()`.
struct Markov_clustering
{
  std::vector<std::size_t> labels;    ///< labels by node, from 0 on, in the order of the clusters' first nodes
  std::size_t number_of_clusters = 0; ///< labels are 0 to `number_of_clusters` - 1
  int iterations = 0;                 ///< number of squarings of the matrix
  bool converged = false;             ///< whether the tolerance was reached
};

/// \ingroup PkgShapeCorrespondenceSets
/// Clusters a graph by simulated flow (van Dongen 2000): the column-stochastic matrix of its weights is squared, which
/// spreads flow, and its entries are raised to a power, which strengthens strong flow, until convergence; a node
/// belongs to the attractors in which its flow ends. Each node gets a loop with the weight of its strongest edge, as in
/// van Dongen's program `mcl`. Deterministic, in parallel where TBB is. Time: that of sparse products of columns of at
/// most `column_limit` entries. Memory: 28 bytes for each of at most `entry_limit` entries, less than 1 GB by default.
/// \param weights symmetric matrix of the weights; the diagonal is ignored
/// \param options options of the flow, and limits of memory
/// \throw Invalid_input if a weight is negative or not finite, or an option is out of its range
Markov_clustering markov_clustering(const Eigen::SparseMatrix<double, 0, int>& weights,
                                    const Markov_clustering_options& options = {});

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_MARKOV_CLUSTERING_H
