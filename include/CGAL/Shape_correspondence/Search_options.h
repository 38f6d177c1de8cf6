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
#include <CGAL/Shape_correspondence/Energy_options.h>
#include <CGAL/Shape_correspondence/Exact_options.h>
#include <CGAL/Shape_correspondence/Part_matching_options.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence {

class Role_model;

/// \ingroup PkgShapeCorrespondenceOptions
/// Methods of finding a correspondence.
enum class Search_method {
  PARTS, ///< least cost of substituting parts, without deformation; highest F1 against human labels
  BEAM,  ///< least deformation energy, by the beam search of the paper
  EXACT  ///< least deformation energy, with a proof
};

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `find_correspondence()`.
struct Search_options
{
  Search_method method = Search_method::PARTS; ///< how the correspondence is found
  Part_matching_options parts;                 ///< options of `Search_method::PARTS`
  /// Role model used by `Search_method::PARTS`, and by the others if `Energy_weights::roles` is not 0; null: none.
  /// Shapes should face +z. The program uses `IO::shipped_role_model()`.
  std::shared_ptr<const Role_model> roles;
  /// Category of both shapes, for `roles`; empty: the most similar one, or none if no category is similar enough.
  std::string category;
  double min_confidence = 0; ///< pairs of lower confidence, in [0, 1], are left out; for `Search_method::PARTS`
  Beam_options beam;         ///< options of `Search_method::BEAM`
  Exact_options exact;       ///< options of `Search_method::EXACT`
  Energy_options energy;     ///< options of the deformation energy
  /// Whether to deform each shape into the other one, and keep the result of less energy per pair of connected parts.
  bool both_directions = true;
  /// Whether to compare directions by energy, as in the paper, instead of energy per pair of connected parts.
  bool direction_by_energy = false;
  /// Coarse correspondence: number of largest parts to match, in whole groups as far as they fit; 0: all parts.
  int maximum_parts = 0;
  /// Whether `maximum_parts` applies to both shapes. Otherwise it applies to the source only, which is deformed into
  /// the whole target (paper, section 6.1).
  bool coarse_target = true;
  /// Coarse to fine (paper, section 3), for shapes of many parts: `BEAM` and `EXACT` first match this number of largest
  /// parts of each shape. Every other group may then only be matched to the images of its nearest large parts, or
  /// groups near these, so that time and memory depend on the number of groups near a large part. 0: all parts at once.
  int coarse_to_fine = 0;
  std::vector<std::size_t> source_parts; ///< indices of the source parts to match; empty: all parts
  std::vector<std::size_t> target_parts; ///< indices of the target parts to match; empty: all parts
  /// Number of alignments to try, at least 0: turns of the target about the upright axis by 90° or 180°. 1: only the
  /// one nearest to the given orientation, see `front_is_sure`; 0: all. The best one is taken; `Search_method::PARTS`
  /// prefers the nearest one unless another is better by a margin. With `roles`, any number other than 1 tries all
  /// alignments that make the fronts of both shapes, according to the roles of their parts, coincide.
  int alignments = 1;
  /// Whether the given orientation is right. Otherwise, with 1 alignment, `Search_method::PARTS` turns a shape by a
  /// multiple of 90° if the roles of its parts clearly show another front.
  bool front_is_sure = false;
  int solutions = 1; ///< largest number of results of `Correspondence_finder::ranked()`, at least 1
  /// Whether to compute `Group_match::min_marginal` by exact search, also with `Search_method::BEAM`.
  bool min_marginals = false;
  /// Time limit of a match, in seconds; 0: none, so that results do not depend on speed. When it is reached, the best
  /// result so far is returned with a warning, and `Correspondence::complete` and `optimal` are false. If there is none
  /// yet, parts are matched by their costs as with `Search_method::PARTS`, which tries at least one alignment.
  double time_limit = 0;
  /// Called before every direction of every alignment with the completed share, in [0, 1]; `false` ends the search.
  std::function<bool(double)> progress;
};

/// \ingroup PkgShapeCorrespondenceOptions
/// The paper's method: beam search with K = 20 and k = 4 over all alignments that the shapes' symmetry allows (section
/// 5), the direction of less energy, deform-to-fit by extremities, hard proximity; a coarse correspondence selects
/// parts of the source only (section 6.1). For graphs, see `paper_structure_options()`.
Search_options paper_options();

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_SEARCH_OPTIONS_H
