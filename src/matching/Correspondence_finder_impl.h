// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "matching/Alignments.h"
#include "roles/Shape_roles.h"
#include "matching/match_parts.h"

#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence {
using namespace internal;

/// One source, matched with any target. What `Search_method::PARTS` finds is in `find_by_parts.cpp`, what the searches
/// for the least energy find in `find_by_energy.cpp`, and what both share in `find_correspondence.cpp`.
class Correspondence_finder::Impl
{
public:
  /// \throw Invalid_input if an option is out of its range or names a part that there is not
  Impl(const Prepared_shape& source, const Search_options& options);

  std::vector<Correspondence> ranked(const Prepared_shape& target) const;
  std::array<Correspondence, 2> both_orders(const Prepared_shape& target) const;
  std::vector<Transferred_label> transferred_labels(const std::vector<Part_label>& labels,
                                                    const Prepared_shape& target) const;
  double lower_bound(const Prepared_shape& target, double unmatched_energy) const;

private:
  using Shared_shape = Matching_problem::Shared_shape;
  using Alignments = Prepared_shape::Alignments;

  // Shared by all methods

  Shared_shape aligned(const Prepared_shape& target, int quarter_turns) const;
  // The turns of the target that are tried, the first guess first.
  std::vector<int> tried_turns(const Prepared_shape& target) const;
  Match_constraints constraints(const Aligned_shape& source, const Aligned_shape& target) const
  {
    return Match_constraints(source, target, options_.matching);
  }
  static void take_roles(const Correspondence& known, Correspondence& correspondence);
  static void mark_cancelled(std::size_t done, std::size_t runs, Correspondence& correspondence);

  // By parts

  // An alignment that is tried: the turn of the target into the source's frame, and, by roles, the quarter turns from
  // the given orientations with which the shapes look to +z.
  struct Way
  {
    int turn = 0, source_front = 0, target_front = 0;
    bool by_roles = false;
  };

  // What `Search_method::PARTS` finds, before it is rated by the energy.
  struct Found
  {
    Part_matching matching; // of the source and the target in the alignment
    Shared_shape target;    // aligned
    Way way;
    Correspondence known;           // roles, category and warnings
    std::size_t done = 0, ways = 0; // alignments
  };

  // What trees tell of the two shapes.
  struct Pair_votes
  {
    const Role_votes &source, &target;
  };

  Found matched_parts(const Prepared_shape& target) const;
  // The alignments that are tried, the first guess first. \param category of both shapes, if roles tell one
  std::vector<Way> ways(const Prepared_shape& target, Pair_category& category) const;
  // Those in which the fronts coincide that the roles of parts of a category tell. If there is to be one, and it is the
  // given one, none.
  std::vector<Way> ways_by_roles(const Prepared_shape& target, std::size_t category) const;
  Part_matching matched_way(const Prepared_shape& target, const Shared_shape& shape, const Way& way) const;
  Part_matching matched_in_common_frame(const Prepared_shape& target, const Shared_shape& shape, int turn) const;
  // With either shape turned from its own frame.
  Part_matching matched_in_frames(const Prepared_shape& target, const Aligned_shape& shape, int source_turn,
                                  int target_turn) const;
  std::shared_ptr<const Shape_features> features(const Prepared_shape& of, const Shared_shape& shape, int turn) const;
  static void warn_of_fronts(const Way& way, Correspondence& result);
  void join_roles(const Prepared_shape& target, const Aligned_shape& aligned_target, const Pair_category& category,
                  const Way& way, Part_matching& matching, Correspondence& result) const;
  // \param result gets the roles, or why there are none
  std::optional<Pair_votes> votes_of(const Prepared_shape& target, const Pair_category& category, const Way& way,
                                     Correspondence& result) const;
  // Without the pairs of less than the least confidence.
  Found without_unsure(Found found) const;
  // The correspondence by which the source is deformed.
  Correspondence rated(const Shared_shape& source, const Found& found) const;
  // The correspondence by which the target is deformed. \pre it is not turned
  Correspondence rated_backwards(Found found) const;
  bool takes_shapes_as_they_are() const;

  // By least energy

  std::vector<Correspondence> least_energy(const Prepared_shape& target) const;
  // The options with `Matching_options::role_costs`, as far as roles are asked for and known. \param result as above
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
