// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_CO_ANALYSIS_H
#define CGAL_SHAPE_CORRESPONDENCE_CO_ANALYSIS_H

#include <CGAL/Shape_correspondence/Part_map.h>
#include <CGAL/Shape_correspondence/markov_clustering.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceSets
/// The part map of two shapes of a set.
struct Shape_pair_map
{
  std::size_t source; ///< index of the source shape
  std::size_t target; ///< index of the target shape
  Part_map map;       ///< source to target
};

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `co_analysis()`.
struct Co_analysis_options
{
  Markov_clustering_options clustering; ///< options of the clustering
  /// A pair of parts is an outlier if fewer of the third shapes that could confirm it do. 0 rejects none.
  double least_cycle_support = 0.5;
};

/// \ingroup PkgShapeCorrespondenceSets
/// The matrix of all part correspondences of a set. Parts are numbered shape after shape.
struct Part_matrix
{
  std::vector<std::size_t> first; ///< by shape, the number of its first part; the number of all parts at the end
  Eigen::SparseMatrix<double> confidences; ///< symmetric; the mean of the maps of either direction
  std::size_t rejected = 0;                ///< pairs of parts left out as outliers
};

/// \ingroup PkgShapeCorrespondenceSets
/// Encodes maps of pairs of shapes, as many as are given, in one matrix (paper, section 6.2). Two parts are confirmed
/// by a third shape if they have a common counterpart there, and contradicted if each has one, but no common one; pairs
/// that too few confirm are left out (cycle consistency). O(m d) time for m pairs of parts that have up to d
/// counterparts; 100 bytes a pair besides the maps.
/// \param part_counts by shape, the number of its parts
/// \throw Invalid_input if a map has a part or a shape that is not there
Part_matrix part_matrix(const std::vector<std::size_t>& part_counts, const std::vector<Shape_pair_map>& maps,
                        double least_cycle_support);

/// \ingroup PkgShapeCorrespondenceSets
/// Labels of parts that are consistent over a set.
struct Co_analysis
{
  static constexpr int none = -1; ///< the label of a part that is like no other part

  std::vector<std::vector<int>> labels; ///< by shape and part; the largest cluster is 0; `none`: like no other part
  int number_of_labels = 0;             ///< labels are 0 to `number_of_labels` - 1
  std::size_t part_pairs = 0;           ///< in the matrix, unordered
  std::size_t rejected_pairs = 0;       ///< as outliers
};

/// \ingroup PkgShapeCorrespondenceSets
/// Finds which parts of a set of shapes correspond over the set: clusters the matrix of all part correspondences by
/// Markov clustering, each cluster a label (paper, section 6.2). A cluster of parts of one shape only is no label.
/// Memory: that of `part_matrix()`, then that of `markov_clustering()`.
/// \throw Invalid_input if a map has a part or a shape that is not there, or an option is out of its range
Co_analysis co_analysis(const std::vector<std::size_t>& part_counts, const std::vector<Shape_pair_map>& maps,
                        const Co_analysis_options& options = {});

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_CO_ANALYSIS_H
