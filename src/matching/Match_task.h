// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/Once.h"
#include "energy/Matching_problem.h"
#include "matching/Shape_features.h"
#include "matching/match_parts.h"
#include "roles/Shape_roles.h"

#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

using Shared_shape = Matching_problem::Shared_shape;

/// A shape turned by each number of quarter turns about the up axis; aligned on demand. Thread-safe.
class Turned_shapes
{
public:
  explicit Turned_shapes(const Structural_graph& graph) : graph_(graph) {}

  const Structural_graph& graph() const { return graph_; }
  Shared_shape aligned(int quarter_turns);

  static constexpr std::size_t turns = 4;

private:
  const Structural_graph& graph_;
  std::array<Once, turns> is_aligned_;
  std::array<Shared_shape, turns> shapes_;
};

/// What all matches of a shape share: its alignments, features and roles, computed on demand. Thread-safe.
struct Alignments
{
  explicit Alignments(const Structural_graph& graph) : shapes_(std::make_shared<Turned_shapes>(graph)) {}

  Shared_shape aligned(int quarter_turns) { return shapes_->aligned(quarter_turns); }

  /// The features in an alignment; cached for the last options only, since shapes are hardly ever matched with several.
  std::shared_ptr<const Shape_features> features(int quarter_turns, const Part_matching_options& options);

  /// The roles predicted by a model for the four quarter turns of the shape from its given orientation.
  Turned_roles roles(const std::shared_ptr<const Role_model>& model);

private:
  std::shared_ptr<Turned_shapes> shapes_;
  std::mutex features_mutex_;
  std::array<std::shared_ptr<const Shape_features>, Turned_shapes::turns> features_;
  std::mutex roles_mutex_;
  std::map<std::shared_ptr<const Role_model>, Turned_roles> roles_;
};

constexpr const char* search_was_cancelled = "The search was cancelled";
constexpr const char* time_is_over = "The time limit ended the search";
constexpr double small_time = 1; // seconds granted to the fallback when the time limit left no time for a search

/// A source shape and the options by which it is matched with any target.
struct Match_source
{
  /// \throw Invalid_input if an option is out of range or names a part that does not exist
  Match_source(const Prepared_shape& shape, const Search_options& options);

  Prepared_shape shape;
  Search_options options;
  Pinned_sets pinned;
  Shared_shape aligned; ///< the participating parts in the frame of the shape; null if the shape has no parts
};

/// A source and a target to match.
struct Match_task
{
  Match_task(const Match_source& from, const Prepared_shape& target)
      : source(from.shape), target(target), options(from.options), pinned(from.pinned), aligned_source(from.aligned)
  {}

  const Prepared_shape &source, &target;
  const Search_options& options;
  const Pinned_sets& pinned;
  const Shared_shape& aligned_source;
};

/// An alignment of two shapes to try.
struct Alignment_candidate
{
  int turn = 0; ///< quarter turns of the target into the frame of the source
  /// If `by_roles`: the quarter turns from the given orientations after which the shapes face +z.
  int source_front = 0, target_front = 0;
  bool by_roles = false;
};

/// The result of `Search_method::PARTS` before its energy is computed.
struct Part_match_result
{
  Part_matching matching;                ///< the matching; its indices are those of the aligned shapes
  Shared_shape target;                   ///< the target in the alignment
  Alignment_candidate alignment;         ///< the alignment of least cost
  Correspondence known;                  ///< roles, category and warnings
  std::size_t tried = 0, candidates = 0; ///< numbers of alignments that were tried, and to be tried
  std::string end;                       ///< why alignments were not tried; empty if all were
};

/// The votes of a category's forest for the roles of the parts of the source and of the target.
using Role_votes_of_pair = std::array<std::shared_ptr<const Role_votes>, 2>;

inline std::size_t number_of_parts(const Prepared_shape& shape) { return structure(shape.graph()).parts.size(); }

inline bool has_no_pairs(const Match_task& task)
{
  return number_of_parts(task.source) == 0 || number_of_parts(task.target) == 0;
}

inline Deadline deadline_of(const Search_options& options)
{
  return Deadline(options.time_limit > 0 ? options.time_limit : Deadline::never);
}

// The shape restricted to the chosen parts, with each set of pinned parts as a group.
// \param chosen indices in the structural graph; empty: all \throw Invalid_input if the shape lacks one of them
Shared_shape participating(Shared_shape shape, const std::vector<std::size_t>& chosen,
                           const std::vector<std::vector<std::size_t>>& pinned = {});

// The participating parts of the target, turned.
Shared_shape aligned_target(const Match_task& task, int quarter_turns);
// The quarter turns of the target to try, the likeliest first.
std::vector<int> tried_turns(const Match_task& task);

void take_roles(const Correspondence& known, Correspondence& correspondence);
// Marks a result as incomplete, with a warning. \param end `search_was_cancelled` or `time_is_over`
void mark_ended(const std::string& end, std::size_t done, std::size_t runs, Correspondence& correspondence);

std::vector<Correspondence> ranked(const Match_task& task);

// Matching by parts, in `find_by_parts.cpp`

// The alignments to try, the likeliest first. \param category set to the category of both shapes, if roles tell one
std::vector<Alignment_candidate> candidates(const Match_task& task, Pair_category& category);
// The votes for the roles of all parts; none without a category. \param result receives the roles, or a warning
std::optional<Role_votes_of_pair> votes_of(const Match_task& task, const Pair_category& category,
                                           const Alignment_candidate& alignment, Correspondence& result);
Part_match_result matched_parts(const Match_task& task, const Deadline& limit);
// Removes pairs of confidence below `Search_options::min_confidence`.
Part_match_result without_unsure(Part_match_result found, const Search_options& options);
// The correspondence, with the energy of deforming the source into all counterparts or, if that takes long, only into
// the likeliest counterpart of each part.
Correspondence rated(const Shared_shape& source, const Part_match_result& found, const Search_options& options,
                     const Deadline& limit);
std::array<Correspondence, 2> both_orders(const Match_task& task);
std::vector<Transferred_label> transferred_labels(const std::vector<Part_label>& labels, const Match_task& task);
std::string category_of(const Match_source& source);

// The search for the least energy, in `find_by_energy.cpp`

std::vector<Correspondence> least_energy(const Match_task& task);
double lower_bound(const Match_task& task, double unmatched_energy);

} // namespace CGAL::Shape_correspondence::internal
