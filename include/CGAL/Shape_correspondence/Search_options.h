// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_SEARCH_OPTIONS_H
#define CGAL_SHAPE_CORRESPONDENCE_SEARCH_OPTIONS_H

#include <CGAL/Shape_correspondence/Beam_options.h>
#include <CGAL/Shape_correspondence/Matching_options.h>
#include <CGAL/Shape_correspondence/exact_search.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

class Role_model;

/// \ingroup PkgShapeCorrespondenceOptions
/// How a correspondence is found.
enum class Search_method {
  PARTS, ///< least costs of corresponding parts, no deformation; agrees best with people
  BEAM,  ///< least deformation energy by the paper's beam search
  EXACT  ///< least deformation energy, with a proof
};

/// \ingroup PkgShapeCorrespondenceOptions
/// What it costs that one part corresponds to another. Lengths are in the unit box of either shape: each axis of the
/// common frame runs from 0 to 1 over the shape, so that a low chair and a high one compare.
struct Part_cost_weights
{
  double overlap = 2;  ///< the share of the smaller part's box that lies outside of the other one's
  double extent = 0.7; ///< |log of the ratio of the boxes' sides|, summed over the axes
  double ground = 1.5; ///< one stands on the ground and the other does not; half of it for boards from side to side
  double side = 3;     ///< distance of the boxes' centres sideways
  double front = 3.5;  ///< the same, to the front
  double orientation = 1.5; ///< Frobenius distance of the normalized square roots of the surfaces' covariances
  double chamfer = 2;       ///< mean distance of a point of either surface from the other surface
  double contacts = 2;      ///< the share of the parts that they touch which do not correspond
  double chain = 50;        ///< one is a ring of a chain and the other is not
};

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `Search_method::PARTS`; bounds are of costs by `Part_cost_weights`.
struct Part_matching_options
{
  Part_cost_weights weights; ///< weights of the terms of a cost
  /// A pair is matched if it costs least for one of its parts and, over both parts, at most so much more than least.
  /// Less of it: fewer pairs, of which more are right.
  double excess = 1.5;
  double confident_excess = 0.5;   ///< the same, for pairs that decide which sets of parts correspond
  double shared_counterpart = 3.5; ///< parts of one shape that cost less among each other may share a counterpart
  bool panels = true;              ///< match panels as sets: rows, boards in one side of the shape
  bool support = true;             ///< match the parts that support a seat or top as a set
  bool chains = true; ///< a shape with a chain hangs from it, and rings of chains correspond to each other only
};

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `find_correspondence()`.
struct Search_options
{
  Search_method method = Search_method::PARTS; ///< how the correspondence is found
  Part_matching_options parts;                 ///< options of `Search_method::PARTS`
  /// What parts are for, joined with the costs of `Search_method::PARTS`; none: the costs alone. Shapes look to +z.
  /// `IO::shipped_role_model()` is the one that the program takes.
  std::shared_ptr<const Role_model> roles;
  /// Of both shapes, for `roles`; empty: the one that they are most like, or none where they are like none.
  std::string category;
  double min_confidence = 0;   ///< drop pairs that are less probable; of `Search_method::PARTS`
  Beam_options beam;           ///< options of `Search_method::BEAM`
  Exact_options exact;         ///< options of `Search_method::EXACT`
  Matching_options matching;   ///< what may be matched, and at which energy
  bool both_directions = true; ///< deform either shape into the other and keep the lower energy per connected pair
  int maximum_parts = 0;       ///< coarse correspondence: only so many most prominent parts; 0 takes all
  /// Whether `maximum_parts` is of both shapes, or of the source alone (paper, section 6.1), which then is the one that
  /// is deformed, into all of the target.
  bool coarse_target = true;
  std::vector<std::size_t> source_parts; ///< only these parts of the source, by their index; empty: all parts
  std::vector<std::size_t> target_parts; ///< only these parts of the target, by their index; empty: all parts
  /// How many alignments are tried, turns of the target about the up axis by 90° or 180°. The one that scores best is
  /// taken, by `Search_method::PARTS` only if it is clearly better than the first; 1 is the first, the one nearest to
  /// the given orientation, 0 all of them. With `roles`, other numbers than 1 mean all in which the shapes of a known
  /// category may look to +z, by the roles of their parts.
  int alignments = 1;
  int solutions = 1;          ///< how many `find_correspondences()` returns at most
  bool min_marginals = false; ///< compute `Group_match::min_marginal`, by exact searches whatever the method
  /// Called before every direction of every alignment with the share that is done; `false` ends the search.
  std::function<bool(double)> progress;
};

/// \ingroup PkgShapeCorrespondenceOptions
/// The paper's method: beam search with K = 20 and k = 4, of all alignments that the shapes' symmetry leaves (section
/// 5, "Initial alignment"), in both directions; a coarse correspondence selects parts of the source alone
/// (section 6.1).
Search_options paper_options();

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_SEARCH_OPTIONS_H
