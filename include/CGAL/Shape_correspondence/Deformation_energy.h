// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_DEFORMATION_ENERGY_H
#define CGAL_SHAPE_CORRESPONDENCE_DEFORMATION_ENERGY_H

#include <vector>

namespace CGAL {
namespace Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceSearch
/// The three terms of the deformation energy (paper, Eq. 1), before weighting.
struct Energy_terms
{
  double distortion = 0;    ///< E_d, Eq. 2 and 3
  double connectedness = 0; ///< E_c, Eq. 4 with its sign turned
  double split = 0;         ///< E_s, Eq. 5
  double unmatched = 0;     ///< cost of groups left unmatched, where the caller allowed it
};

/// \ingroup PkgShapeCorrespondenceOptions
/// Weights of Eq. 1 with the paper's values. A term with weight 0 is switched off (the paper's Figure 4).
struct Energy_weights
{
  double distortion = 1;      ///< of E_d
  double connectedness = 0.6; ///< w_c
  double split = 0.4;         ///< w_s
};

/// \ingroup PkgShapeCorrespondenceSearch
/// E = E_d + w_c E_c + w_s E_s (Eq. 1), and the cost of what is left unmatched.
double deformation_energy(const Energy_terms& terms, const Energy_weights& weights = {});

/// \ingroup PkgShapeCorrespondenceSearch
/// E_s (Eq. 5) of the vector S of solidity ratios, an entry a group of parts; 0 of no groups.
double split_energy(const std::vector<double>& solidity_ratios);

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_DEFORMATION_ENERGY_H
