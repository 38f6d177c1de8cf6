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

namespace CGAL {
namespace Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceCorrespondence
/// Which shape is deformed into which.
enum class Direction {
  SOURCE_TO_TARGET, ///< the source into the target
  TARGET_TO_SOURCE  ///< the target into the source
};

/// \ingroup PkgShapeCorrespondenceCorrespondence
/// A group of the shape that was deformed and what it became.
struct Group_match
{
  std::vector<std::size_t> source;        ///< part indices in the source shape
  std::vector<std::size_t> target;        ///< part indices in the target shape
  Operation operation = Operation::MATCH; ///< what the GeoTopo transform did to the group
  double energy = 0;         ///< its share of E_d + w_c E_c: half of each of its contacts, all of those inside it
  double distortion = 0;     ///< its share of E_d
  double connectedness = 0;  ///< its share of E_c, before weighting
  double solidity_ratio = 1; ///< S_i of Eq. 5, its entry in E_s
  /// By how much the least energy of all rises if the group may not have this match (its min-marginal): 0 is a toss-up,
  /// infinity is no other choice. Not a number where it was not asked for.
  double min_marginal = std::numeric_limits<double>::quiet_NaN();
};

/// \ingroup PkgShapeCorrespondenceCorrespondence
/// The energy of one pair of connected parts of the shape that was deformed.
struct Contact_energy
{
  std::array<std::size_t, 2> parts; ///< the two parts
  double distortion = 0;            ///< its share of E_d
  double connectedness = 0;         ///< its share of E_c, before weighting
};

/// \ingroup PkgShapeCorrespondenceCorrespondence
/// A part-to-part correspondence between a source and a target shape.
struct Correspondence
{
  /// Sorted by source, then target, each once. A search of least energy tells the images of every part of the shape
  /// that was deformed, and the segments that it cut curves into; matching by parts pairs sets of parts as wholes,
  /// every part of one with every part of the other, and has confidences.
  std::vector<Part_correspondence> pairs;
  std::vector<Group_match> groups;           ///< by group of the shape that was deformed
  std::vector<Contact_energy> contacts;      ///< by contact of the shape that was deformed
  std::vector<std::size_t> unmatched_source; ///< source parts without a counterpart, ascending
  std::vector<std::size_t> unmatched_target; ///< target parts without a counterpart, ascending
  /// E of Eq. 1. Matching by parts is rated with whole parts, a search with the pieces of sheets that split or merge.
  double energy = 0;
  Energy_terms terms;                                ///< its terms
  Direction direction = Direction::SOURCE_TO_TARGET; ///< which shape was deformed into which
  bool complete = false; ///< every group of the deformed shape is assigned, or left unmatched where that is allowed
  bool optimal = false;  ///< the energy is proven minimal over the labels, of this direction and turn of the target
  int target_quarter_turns = 0;          ///< of the target about up, into the source's frame
  Search_summary search;                 ///< how the search went
  std::string category;                  ///< whose roles were joined with the costs of parts; empty: none
  std::vector<std::string> source_roles; ///< of every source part, the likeliest role; empty without a category
  std::vector<std::string> target_roles; ///< the same, of the target parts
  std::vector<std::string> warnings;     ///< what was approximated or ended early, in whole sentences
};

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_CORRESPONDENCE_H
