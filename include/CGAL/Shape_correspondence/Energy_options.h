// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_ENERGY_OPTIONS_H
#define CGAL_SHAPE_CORRESPONDENCE_ENERGY_OPTIONS_H

#include <CGAL/Shape_correspondence/Deformation_energy.h>

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceOptions
/// Ways to combine E_d and E_c of the pairs of connected parts.
enum class Energy_norm {
  SUM,   ///< sums over the connected pairs (the paper's Eq. 1)
  POOLED ///< E_d: one norm over the rods of all pairs, without resampling curves as sheets; E_c: the mean
};

/// \ingroup PkgShapeCorrespondenceOptions
/// Ways to deform a matched part into its target part (paper, section 5, "Deform-to-fit").
enum class Deform_to_fit {
  SAMPLES,    ///< sample by sample: the part becomes the target part
  EXTREMITIES ///< ends or corners move to those of the target, with linearly interpolated displacements in between,
              ///< which keeps the part's curvature; closed curves are fitted sample by sample
};

/// \ingroup PkgShapeCorrespondenceOptions
/// A part of the source and a part of the target, by their indices.
struct Part_pair
{
  std::size_t source = 0; ///< index of a part of the source
  std::size_t target = 0; ///< index of a part of the target
};

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of the deformation energy and its labels.
struct Energy_options
{
  /// An infinite `unmatched_cost`: every group must be matched.
  static constexpr double never = std::numeric_limits<double>::infinity();

  Energy_weights weights;                     ///< weights of the terms of the energy
  Energy_norm norm = Energy_norm::SUM;        ///< how E_d and E_c are computed
  bool cut_curves = true;                     ///< whether to allow `Operation::CUT` and `Operation::JOIN`
  Deform_to_fit fit = Deform_to_fit::SAMPLES; ///< how matched parts are deformed
  /// Whether contacts of unmatched parts are hard constraints (paper, section 4.2): then a part follows its contact
  /// points wherever an affine map can; otherwise it resists stretching slightly.
  bool hard_proximity = false;
  /// Energy for each contact with an unmatched group, and for an unmatched group without contacts, not negative;
  /// `never`: groups must be matched.
  double unmatched_cost = never;
  /// Pairs that must correspond; their parts correspond to no other parts. A part in several pairs corresponds to all
  /// its partners. A search removes these parts from their symmetry groups and charges no E_s for them.
  std::vector<Part_pair> pinned;
  std::vector<Part_pair> forbidden; ///< pairs that must not correspond
  /// Disagreement of the roles of each source part (row) and target part (column), by their indices, in [0, 1]; empty:
  /// 0. The energy of a contact is increased by `Energy_weights::roles` times the mean disagreement of its two parts
  /// with their images; a part without contacts is charged once. If the matrix is empty and the weight is not 0,
  /// `find_correspondence()` computes it from `Search_options::roles`.
  Eigen::MatrixXd role_costs;
};

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_ENERGY_OPTIONS_H
