// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_TRANSITIVE_CORRESPONDENCE_H
#define CGAL_SHAPE_CORRESPONDENCE_TRANSITIVE_CORRESPONDENCE_H

#include <CGAL/Shape_correspondence/Part_map.h>
#include <CGAL/Shape_correspondence/energy_matrix.h>

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceSets
/// Two shapes joined by an edge of a tree, the smaller index first.
using Shape_pair = std::pair<std::size_t, std::size_t>;

/// \ingroup PkgShapeCorrespondenceSets
/// A minimum spanning tree of a set of shapes: n - 1 pairs with the least sum of distances, in the order of Prim's
/// algorithm, starting at the first shape (Prim 1957; O(n²) time and O(n) memory).
/// \param distances symmetric matrix, see `symmetric_distances()`
std::vector<Shape_pair> minimum_spanning_tree(const Eigen::Ref<const Eigen::MatrixXd>& distances);

/// \ingroup PkgShapeCorrespondenceSets
/// A chain of shapes and its energy, the sum of the energies of its steps.
struct Shape_chain
{
  std::vector<std::size_t> shapes; ///< the source, the intermediate shapes, the target
  double energy = 0;               ///< the sum of the energies of its steps

  /// Whether there are no intermediate shapes.
  bool is_direct() const { return shapes.size() <= 2; }
};

/// \ingroup PkgShapeCorrespondenceSets
/// The best chains from one source to all targets, including itself (a chain of one shape). Candidates are the direct
/// step, the chain via one intermediate shape, the bridge, of least energy (paper, section 6.1, Figure 13), and the
/// chain along the tree; the one with the least sum of `energies` is taken, in case of a tie the one with the fewest
/// steps. O(n²) for n shapes.
/// \param energies those of `Energy_matrix` \param tree a spanning tree \param source index of the shape
std::vector<Shape_chain> best_chains(const Eigen::MatrixXd& energies, const std::vector<Shape_pair>& tree,
                                     std::size_t source);

/// \ingroup PkgShapeCorrespondenceSets
/// A correspondence that may be composed via other shapes.
struct Transitive_correspondence
{
  Shape_chain chain;        ///< the chain along which it is composed
  double direct_energy = 0; ///< energy of the direct match
  Part_map map;             ///< map from source to target, composed along the chain
};

/// \ingroup PkgShapeCorrespondenceSets
/// The part correspondence of two shapes of a set along the best chain. The direct match is taken unless another chain
/// has less energy and a composed map that is not empty. `tree` is a spanning tree.
/// \pre the matrix is complete
Transitive_correspondence transitive_correspondence(const Energy_matrix& matrix, const std::vector<Shape_pair>& tree,
                                                    std::size_t source, std::size_t target);

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_TRANSITIVE_CORRESPONDENCE_H
