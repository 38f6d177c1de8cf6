// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_CO_ANALYSIS_H
#define CGAL_SHAPE_CORRESPONDENCE_CO_ANALYSIS_H

#include <CGAL/Shape_correspondence/Part_map.h>
#include <CGAL/Shape_correspondence/markov_clustering.h>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `co_analysis()`.
struct Co_analysis_options
{
  Markov_clustering_options clustering; ///< options of the clustering
  /// A pair of parts is an outlier if they have a common counterpart in less than this share, in [0, 1], of the third
  /// shapes where both have counterparts; 0: no pair is.
  double least_cycle_support = 0.5;
};

/// \ingroup PkgShapeCorrespondenceSets
/// Labels of parts that are consistent over a set.
struct Co_analysis
{
  static constexpr int none = -1; ///< label of a part in no cluster

  /// Indexed by shape and part; 0 is the largest cluster; `none` for parts in no cluster.
  std::vector<std::vector<int>> labels;
  int number_of_labels = 0;       ///< labels are 0 to `number_of_labels` - 1
  std::size_t part_pairs = 0;     ///< number of unordered pairs of parts in the clustered matrix
  std::size_t rejected_pairs = 0; ///< number of pairs left out as outliers
};

/// \ingroup PkgShapeCorrespondenceSets
/// Finds labels of parts over a set of shapes: clusters the matrix of all part correspondences by Markov clustering;
/// each cluster is a label (paper, section 6.2), unless all of its parts are of one shape. Memory: 100 bytes for each
/// pair of parts in addition to the maps, then that of `markov_clustering()`. `part_counts` are the numbers of parts of
/// the shapes, `maps` are of any pairs of shapes.
/// \throw Invalid_input if a map has a part or a shape that does not exist, or an option is out of its range
Co_analysis co_analysis(const std::vector<std::size_t>& part_counts, const std::vector<Shape_pair_map>& maps,
                        const Co_analysis_options& options = {});

/// \ingroup PkgShapeCorrespondenceSets
/// The maps reduced to pairs of parts in one cluster, which the whole set confirms: fewer pairs of higher precision.
std::vector<Shape_pair_map> agreeing_maps(std::vector<Shape_pair_map> maps, const Co_analysis& analysis);

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_CO_ANALYSIS_H
