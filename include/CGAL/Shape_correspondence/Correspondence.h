// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_CORRESPONDENCE_H
#define CGAL_SHAPE_CORRESPONDENCE_CORRESPONDENCE_H

#include <CGAL/Shape_correspondence/Deformation_energy.h>
#include <CGAL/Shape_correspondence/Geotopo_operation.h>
#include <CGAL/Shape_correspondence/Part_correspondence.h>
#include <CGAL/Shape_correspondence/Search_summary.h>

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceCorrespondence
/// The direction of the deformation.
enum class Direction {
  SOURCE_TO_TARGET, ///< the source is deformed into the target
  TARGET_TO_SOURCE  ///< the target is deformed into the source
};

/// \ingroup PkgShapeCorrespondenceCorrespondence
/// A symmetry group of the deformed shape and its counterpart.
struct Group_match
{
  std::vector<std::size_t> source;        ///< part indices in the source shape
  std::vector<std::size_t> target;        ///< part indices in the target shape
  Operation operation = Operation::MATCH; ///< operation of the GeoTopo transform on the group
  double energy =
      0; ///< share of E_d + w_c E_c: the energies of contacts inside the group and half of those with other groups
  double distortion = 0;     ///< share of E_d
  double connectedness = 0;  ///< share of E_c, before weighting
  double solidity_ratio = 1; ///< S_i of Eq. 5, its entry in E_s
  /// Min-marginal: increase of the least energy if this match of the group is forbidden. 0: another match is as good;
  /// infinity: there is no other match; NaN: not computed (`Search_options::min_marginals`).
  double min_marginal = std::numeric_limits<double>::quiet_NaN();
};

/// \ingroup PkgShapeCorrespondenceCorrespondence
/// The energy of one pair of connected parts of the deformed shape.
struct Contact_energy
{
  std::array<std::size_t, 2> parts; ///< the two parts
  double distortion = 0;            ///< share of E_d
  double connectedness = 0;         ///< share of E_c, before weighting
};

/// \ingroup PkgShapeCorrespondenceCorrespondence
/// A part-to-part correspondence between a source and a target shape.
struct Correspondence
{
  /// Corresponding parts, sorted by source, then target, each pair once. A search for the least energy gives the images
  /// of every part of the deformed shape, with the segments of cut curves. Matching by parts pairs sets of parts, every
  /// part of one set with every part of the other, and gives confidences.
  std::vector<Part_correspondence> pairs;
  std::vector<Group_match> groups;           ///< one for each group of the deformed shape, sorted by parts
  std::vector<Contact_energy> contacts;      ///< one for each contact of the deformed shape, sorted by parts
  std::vector<std::size_t> unmatched_source; ///< source parts without a counterpart, ascending
  std::vector<std::size_t> unmatched_target; ///< target parts without a counterpart, ascending
  /// Deformation energy, E of Eq. 1. After a search, each piece of a sheet that splits or merges is deformed by itself;
  /// after matching by parts, whole parts are deformed.
  double energy = 0;
  Energy_terms terms;                                ///< the terms of the energy
  Direction direction = Direction::SOURCE_TO_TARGET; ///< which shape was deformed into which
  /// Whether every group of the deformed shape is assigned, or left unmatched where that is allowed.
  bool complete = false;
  bool optimal = false; ///< whether the energy is proven minimal over all labels, for this direction and alignment
  int target_quarter_turns = 0; ///< quarter turns of the target about the up axis that align it with the source
  Search_summary search;        ///< effort of the search, and its lower bound
  std::string category;         ///< category whose roles were used; empty: none
  std::vector<std::string> source_roles; ///< most probable role of each source part; empty without a category
  std::vector<std::string> target_roles; ///< most probable role of each target part; empty without a category
  /// Number of rows of `Shape_structure::features`, if features were compared, else 0.
  std::size_t feature_dimension = 0;
  double feature_weight = 0;         ///< `Part_cost_weights::features`, if features were compared, else 0
  std::vector<std::string> warnings; ///< sentences on approximations made and limits reached
};

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_CORRESPONDENCE_H
