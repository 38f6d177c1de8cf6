// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_DEFORMATION_ENERGY_H
#define CGAL_SHAPE_CORRESPONDENCE_DEFORMATION_ENERGY_H

#include <CGAL/Shape_correspondence/Points.h>

#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceSearch
/// The terms of the deformation energy (paper, Eq. 1), before weighting.
struct Energy_terms
{
  double distortion = 0;    ///< E_d, Eq. 2 and 3
  double connectedness = 0; ///< E_c, Eq. 4 with its sign corrected
  double split = 0;         ///< E_s, Eq. 5
  double unmatched = 0;     ///< cost of unmatched groups (`Energy_options::unmatched_cost`)
  double roles = 0;         ///< disagreement of roles (`Energy_options::role_costs`); not in the paper
};

/// \ingroup PkgShapeCorrespondenceOptions
/// Weights of Eq. 1 with the paper's values. A term with weight 0 is switched off (the paper's Figure 4).
struct Energy_weights
{
  double distortion = 1;      ///< weight of E_d, not negative
  double connectedness = 0.6; ///< w_c, weight of E_c, not negative
  double split = 0.4;         ///< w_s, weight of E_s, not negative
  double roles = 0;           ///< weight of the disagreement of roles, not negative; not in the paper
};

/// \ingroup PkgShapeCorrespondenceSearch
/// E = E_d + w_c E_c + w_s E_s (Eq. 1), the cost of unmatched groups, and the weighted disagreement of roles.
double deformation_energy(const Energy_terms& terms, const Energy_weights& weights = {});

/// \ingroup PkgShapeCorrespondenceSearch
/// An entry of D (Eq. 2): the cosine of the rotation angle of a structural rod, the vector from a sample of one part to
/// a sample of another; 0 beyond a right angle. For a rod of length zero the entry is 1, for one that becomes zero it
/// is 0. Lengths count as zero if their square is below 1e-9, in units of the shape's height.
/// \param before the rod before the deformation
/// \param after the rod after the deformation
double rod_rotation(const Point& before, const Point& after);

/// \ingroup PkgShapeCorrespondenceSearch
/// E_d of two connected parts (Eq. 3): 1 - ||D|| / ||J||.
/// \param mean_squared_cosine mean of the squared entries of D
double distortion_energy(double mean_squared_cosine);

/// \ingroup PkgShapeCorrespondenceSearch
/// E_c of two connected parts (Eq. 4): min(1, d'/f) if they have come apart (d' > d), else 0. The sign of the printed
/// equation is corrected: as printed, E_c decreases as parts separate.
/// \param shortest_before d, the length of the shortest structural rod before the deformation
/// \param shortest_after d', the length of the shortest rod after the deformation
/// \param longest_before f, the length of the longest rod before the deformation
double connectedness_energy(double shortest_before, double shortest_after, double longest_before);

/// \ingroup PkgShapeCorrespondenceSearch
/// E_s (Eq. 5) of the vector S of solidity ratios, one entry for each group of parts; 0 if there are no groups. If a
/// group and its image differ in their numbers of parts, S_i is the smaller of their solidities divided by the larger.
/// It is 1 for groups that are not matched yet, for groups of equal size (the paper mentions only single parts, and
/// charges "one-to-many and many-to-one" only), and for rotational groups.
double split_energy(const std::vector<double>& solidity_ratios);

/// \ingroup PkgShapeCorrespondenceSearch
/// 1 - ||v|| / ||J|| for a vector v, the form shared by Eq. 3 and Eq. 5.
/// \param mean_square mean of the squared entries of v
double norm_loss(double mean_square);

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_DEFORMATION_ENERGY_H
