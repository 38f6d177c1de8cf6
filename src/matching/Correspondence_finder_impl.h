// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "matching/Alignments.h"
#include "matching/match_parts.h"
#include "roles/Shape_roles.h"

#include <CGAL/Shape_correspondence/Search_result.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence {

namespace internal {

/// An alignment of two shapes to try.
struct Alignment_candidate
{
  int turn = 0; ///< quarter turns of the target into the frame of the source
  /// If `by_roles`: the quarter turns from the given orientations after which the shapes face +z.
  int source_front = 0, target_front = 0;
  bool by_roles = false;
};

constexpr const char* search_was_cancelled = "The search was cancelled";
constexpr const char* time_is_over = "The time limit ended the search";
constexpr double small_time = 1; // seconds granted to the fallback when the time limit left no time for a search

/// One run of a search. The source of its problem is the shape that is deformed.
struct Search_run
{
  Matching_problem problem;
  Direction direction;
  int turns;                ///< quarter turns of the target
  std::size_t coarse_parts; ///< number of parts matched first, coarse to fine; 0: all at once
  Search_result result;
};

/// The runs of a search for the least energy; the best one is kept.
struct Search_runs
{
  std::unique_ptr<const Search_run> best;
  std::size_t states = 0, evaluations = 0, done = 0, count = 0;
  std::string end;       ///< why runs are missing; empty if all were done
  std::string too_large; ///< message about runs whose tables exceed the memory; empty if there are none
};

/// The result of `Search_method::PARTS` before its energy is computed.
struct Part_match_result
{
  Part_matching matching;                ///< part indices of the source and of the target in the alignment
  Matching_problem::Shared_shape target; ///< the target in the alignment
  Alignment_candidate alignment;         ///< the alignment of least cost
  Correspondence known;                  ///< roles, category and warnings
  std::size_t tried = 0, candidates = 0; ///< numbers of alignments
  std::string end;                       ///< why alignments were not tried; empty if all were
};

/// The votes of the forest for the parts of the source and of the target, under one category.
using Role_votes_of_pair = std::array<std::shared_ptr<const Role_votes>, 2>;

// The shape restricted to the chosen parts, with each set of pinned parts as a group.
// \param chosen indices in the structural graph; empty: all \throw Invalid_input if the shape lacks one of them
Matching_problem::Shared_shape participating(Matching_problem::Shared_shape shape,
                                             const std::vector<std::size_t>& chosen,
                                             const std::vector<std::vector<std::size_t>>& pinned = {});

} // namespace internal

using namespace internal;

/// One source, to be matched with any target. Matching by parts is in `find_by_parts.cpp`, the search for the least
/// energy in `find_by_energy.cpp`, and what both share in `find_correspondence.cpp`.
class Correspondence_finder::Impl
{
public:
  /// \throw Invalid_input if an option is out of range or names a part that does not exist
  Impl(const Prepared_shape& source, const Search_options& options);

  std::vector<Correspondence> ranked(const Prepared_shape& target) const;
  std::array<Correspondence, 2> both_orders(const Prepared_shape& target) const;
  std::vector<Transferred_label> transferred_labels(const std::vector<Part_label>& labels,
                                                    const Prepared_shape& target) const;
  std::string source_category() const;
  double lower_bound(const Prepared_shape& target, double unmatched_energy) const;

private:
  using Shared_shape = Matching_problem::Shared_shape;
  using Alignments = Prepared_shape::Alignments;

  bool has_no_pairs(const Prepared_shape& target) const
  {
    return number_of_parts_ == 0 || structure(target.graph()).parts.empty();
  }
  Correspondence without_pairs(const Prepared_shape& target) const;
  Shared_shape aligned(const Prepared_shape& target, int quarter_turns) const;
  // The quarter turns of the target to try, the likeliest first.
  std::vector<int> tried_turns(const Prepared_shape& target) const;
  Match_constraints constraints(const Aligned_shape& source, const Aligned_shape& target) const
  {
    return Match_constraints(source, target, options_.energy);
  }
  static void take_roles(const Correspondence& known, Correspondence& correspondence);
  Deadline deadline() const { return Deadline(options_.time_limit > 0 ? options_.time_limit : Deadline::never); }
  // \param end `search_was_cancelled` or `time_is_over`
  static void mark_ended(const std::string& end, std::size_t done, std::size_t runs, Correspondence& correspondence);

  Part_match_result matched_parts(const Prepared_shape& target, const Deadline& limit) const;
  // Says in the result whether features were compared.
  void tell_features(const Prepared_shape& target, Part_match_result& found) const;
  // The alignments to try, the likeliest first. \param category set to the category of both shapes, if roles tell one
  std::vector<Alignment_candidate> candidates(const Prepared_shape& target, Pair_category& category) const;
  // The category of both shapes. If they belong to none in their given orientations, and these are not certain, the
  // category after turning, provided that the roles of one shape clearly show it facing another side.
  Pair_category recognised(const Prepared_shape& target) const;
  // The alignments that make the fronts coincide, as found by the roles of a category; empty if only one alignment is
  // wanted and it is the given one.
  std::vector<Alignment_candidate> candidates_by_roles(const Prepared_shape& target, std::size_t category) const;
  // \param deadline see `part_costs()`
  Part_matching matched_in(const Prepared_shape& target, const Shared_shape& shape,
                           const Alignment_candidate& alignment, const Deadline* deadline) const;
  // Matches the shapes, each turned from its own frame.
  Part_matching matched_in_frames(const Prepared_shape& target, const Aligned_shape& shape, int source_turn,
                                  int target_turn, const Deadline* deadline) const;
  std::shared_ptr<const Shape_features> features(const Prepared_shape& of, const Shared_shape& shape, int turn) const;
  static void warn_of_fronts(const Alignment_candidate& alignment, Correspondence& result);
  void join_roles(const Prepared_shape& target, const Aligned_shape& aligned_target, const Pair_category& category,
                  const Alignment_candidate& alignment, Part_matching& matching, Correspondence& result) const;
  // \param result receives the roles, or a warning why there are none
  std::optional<Role_votes_of_pair> votes_of(const Prepared_shape& target, const Pair_category& category,
                                             const Alignment_candidate& alignment, Correspondence& result) const;
  // Removes pairs of confidence below `Search_options::min_confidence`.
  Part_match_result without_unsure(Part_match_result found) const;
  // The result with the energy of deforming the source, with only the likeliest counterparts if all would take long.
  Correspondence rated(const Shared_shape& source, const Part_match_result& found, const Deadline& limit) const;
  // The result with the energy of deforming the target.
  // \pre the target is not turned
  Correspondence rated_backwards(Part_match_result found, const Deadline& limit) const;
  bool takes_shapes_as_they_are() const;

  std::vector<Correspondence> least_energy(const Prepared_shape& target) const;
  Search_runs runs(const Prepared_shape& target, const Search_options& options, const Deadline& deadline) const;
  std::vector<Correspondence> correspondences_of(const Search_runs& runs, const Deadline& deadline) const;
  // The match of parts by costs, for when there is no time or memory for any run of the search.
  Correspondence by_costs(const Prepared_shape& target, const Search_runs& runs, const Deadline& limit) const;
  // The options with `Energy_options::role_costs`, if roles are wanted and known. \param result see `votes_of()`
  Search_options with_role_costs(const Prepared_shape& target, Correspondence& result) const;
  double lower_bound(const Shared_shape& deformed, const Shared_shape& other, double unmatched_energy) const;

  Search_options options_;
  Pinned_sets pinned_;
  Prepared_shape prepared_source_;
  Shape_frame source_frame_;
  std::size_t number_of_parts_;
  Shared_shape source_;
};

} // namespace CGAL::Shape_correspondence
