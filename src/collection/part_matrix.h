// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Part_map.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence {

/// The matrix of all part correspondences of a set. Parts are numbered consecutively, shape by shape.
struct Part_matrix
{
  std::vector<std::size_t> first; ///< for each shape, the index of its first part; then the number of all parts
  Eigen::SparseMatrix<double> confidences; ///< by two parts, symmetric; mean over the maps of both directions
  std::size_t rejected = 0;                ///< number of pairs of parts left out as outliers
};

/// Combines maps of pairs of shapes in one matrix (paper, section 6.2). Two parts are confirmed by a third shape if
/// they have a common counterpart there, and contradicted if each has a counterpart, but none in common; pairs with too
/// little confirmation are left out (cycle consistency). O(m d) time for m pairs of parts that have up to d
/// counterparts; 100 bytes for each pair in addition to the maps.
/// \param part_counts number of parts, by shape
/// \param maps part maps of pairs of shapes
/// \param least_cycle_support see `Co_analysis_options::least_cycle_support`
/// \throw Invalid_input if a map has a part or a shape that does not exist
Part_matrix part_matrix(const std::vector<std::size_t>& part_counts, const std::vector<Shape_pair_map>& maps,
                        double least_cycle_support);

} // namespace CGAL::Shape_correspondence
