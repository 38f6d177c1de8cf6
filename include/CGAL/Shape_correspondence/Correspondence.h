// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_CORRESPONDENCE_H
#define CGAL_SHAPE_CORRESPONDENCE_CORRESPONDENCE_H

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

/// The three terms of the deformation energy (paper, Eq. 1), before weighting.
struct Energy_terms
{
  double distortion = 0;    ///< E_d, Eq. 2 and 3
  double connectedness = 0; ///< E_c, Eq. 4 with its sign turned
  double split = 0;         ///< E_s, Eq. 5
  double unmatched = 0;     ///< cost of groups left unmatched, where the caller allowed it
};

/// What the GeoTopo transform does to the parts of a group, seen in the direction of the search (paper, section 4.1).
enum class Operation {
  MATCH,     ///< as many parts as before, one to one
  SPLIT,     ///< one part becomes many
  DUPLICATE, ///< some parts of several are cloned
  MERGE,     ///< many parts become fewer
  CUT,       ///< curves are cut into equally long segments, one for each target part
  JOIN,      ///< the inverse: several curves become the segments of one
  NONE       ///< left unmatched
};

/// The operation's name in files and messages.
inline const char* name_of(Operation operation)
{
  static constexpr const char* names[] = {"match", "split", "duplicate", "merge", "cut", "join", "none"};
  return names[int(operation)];
}

enum class Direction { SOURCE_TO_TARGET, TARGET_TO_SOURCE };

/// A group of the shape that was deformed and what it became.
struct Group_match
{
  std::vector<std::size_t> source; ///< part indices in the source shape
  std::vector<std::size_t> target; ///< part indices in the target shape
  Operation operation = Operation::MATCH;
  double energy = 0;         ///< its share of E_d + w_c E_c: half of each of its contacts, all of those inside it
  double distortion = 0;     ///< its share of E_d
  double connectedness = 0;  ///< its share of E_c, before weighting
  double solidity_ratio = 1; ///< S_i of Eq. 5, its entry in E_s
  /// By how much the least energy of all rises if the group may not have this match (its min-marginal): 0 is a toss-up,
  /// infinity is no other choice. Not a number where it was not asked for.
  double min_marginal = std::numeric_limits<double>::quiet_NaN();
};

/// The energy of one pair of connected parts of the shape that was deformed.
struct Contact_energy
{
  std::array<std::size_t, 2> parts;
  double distortion = 0;
  double connectedness = 0;
};

/// How the search went.
struct Search_summary
{
  std::string method = "beam"; ///< parts, beam or exact
  std::size_t states = 0;      ///< search states kept
  std::size_t evaluations = 0; ///< energies of states computed
  double lower_bound = 0;      ///< no correspondence in the direction of the result costs less
};

/// A part-to-part correspondence between a source and a target shape.
struct Correspondence
{
  std::vector<std::pair<std::size_t, std::size_t>> pairs; ///< (source part, target part), sorted, each once
  std::vector<double> confidences; ///< by pair, how probable it is, between 0 and 1; empty where the method has none
  std::vector<Group_match> groups; ///< by group of the shape that was deformed
  std::vector<Contact_energy> contacts; ///< by contact of the shape that was deformed
  std::vector<std::size_t> unmatched_source;
  std::vector<std::size_t> unmatched_target;
  double energy = 0; ///< E of Eq. 1
  Energy_terms terms;
  Direction direction = Direction::SOURCE_TO_TARGET; ///< which shape was deformed into which
  bool complete = false; ///< every group of the deformed shape is assigned, or left unmatched where that is allowed
  bool optimal = false;  ///< the energy is proven minimal over the labels
  int target_quarter_turns = 0; ///< of the target about up, into the source's frame
  Search_summary search;
  std::vector<std::string> warnings;
};

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_CORRESPONDENCE_H
