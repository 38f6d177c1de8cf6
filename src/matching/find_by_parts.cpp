// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/quarter_turn.h"
#include "matching/Correspondence_finder_impl.h"
#include "matching/Search_run.h"
#include "matching/aligned_matching.h"
#include "matching/match_by_roles.h"
#include "matching/participants.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

// To the side and to the front, places count differently, so that it matters by a quarter turn in whose frame shapes
// are compared: in the frame of the one that comes first, whichever is the source.
Part_matching Correspondence_finder::Impl::matched_in_common_frame(const Prepared_shape& target,
                                                                   const Shared_shape& shape, int turn) const
{
  if (turn % 2 == 0 || !comes_first(*shape, *source_))
    return match_parts(*features(prepared_source_, source_, 0), *features(target, shape, turn), options_.parts,
                       constraints(*source_, *shape));
  return matched_in_frames(target, *shape, -turn, 0);
}

Part_matching Correspondence_finder::Impl::matched_in_frames(const Prepared_shape& target, const Aligned_shape& shape,
                                                             int source_turn, int target_turn) const
{
  const Shared_shape b = aligned(target, target_turn),
                     a = regrouped(participating(prepared_source_.alignments_->aligned(source_turn), source_->original),
                                   pinned_.source);
  return renumbered(match_parts(*features(prepared_source_, a, source_turn), *features(target, b, target_turn),
                                options_.parts, constraints(*a, *b)),
                    *a, *source_, *b, shape);
}

std::shared_ptr<const Shape_features> Correspondence_finder::Impl::features(const Prepared_shape& of,
                                                                            const Shared_shape& shape, int turn) const
{
  Alignments& shapes = *of.alignments_;
  return shape == shapes.aligned(turn) ? shapes.features(turn, options_.parts)
                                       : std::make_shared<Shape_features>(*shape, options_.parts);
}

std::vector<Correspondence_finder::Impl::Way> Correspondence_finder::Impl::ways(const Prepared_shape& target,
                                                                                Pair_category& category) const
{
  std::vector<Way> result;
  if (options_.roles) {
    const Role_model_data& model = options_.roles->data();
    Alignments &a = *prepared_source_.alignments_, &b = *target.alignments_;
    category.index = model.index(options_.category);
    if (options_.category.empty())
      category = options_.alignments == 1
                     ? category_of_pair(*a.roles(options_.roles), *b.roles(options_.roles), model, options_.parts)
                     : category_of_pair(a.roles_by_turn(options_.roles), b.roles_by_turn(options_.roles), model,
                                        options_.parts);
    if (category.index < model.categories.size() && !(options_.alignments == 1 && options_.front_is_sure))
      result = ways_by_roles(target, category.index);
  }
  // Of ways that cost the same the first is taken: the same one, whichever shape is the source
  if (!result.empty() && comes_first(*aligned(target, 0), *source_))
    std::stable_sort(result.begin(), result.end(),
                     [](const Way& a, const Way& b) { return a.target_front < b.target_front; });
  if (result.empty())
    for (int turn : tried_turns(target))
      result.push_back({turn, 0, 0, false});
  return result;
}

std::vector<Correspondence_finder::Impl::Way> Correspondence_finder::Impl::ways_by_roles(const Prepared_shape& target,
                                                                                         std::size_t category) const
{
  const auto fronts = [&](const Prepared_shape& shape) {
    Alignments& shapes = *shape.alignments_;
    if (options_.alignments == 1) return std::vector<int>{shapes.front(options_.roles, category, options_.parts)};
    return front_turns(shapes.roles_by_turn(options_.roles), category, options_.roles->data().trees, options_.parts);
  };
  const int given = given_quarter_turns(structure(target.graph()).frame) - given_quarter_turns(source_frame_);
  const std::vector<int> of_source = fronts(prepared_source_), of_target = fronts(target);
  std::vector<Way> result;
  for (int from : of_source)
    for (int to : of_target)
      if (options_.alignments != 1 || from != 0 || to != 0)
        result.push_back({within_a_turn(given + to - from), from, to, true});
  return result;
}

Part_matching Correspondence_finder::Impl::matched_way(const Prepared_shape& target, const Shared_shape& shape,
                                                       const Way& way) const
{
  if (!way.by_roles) return matched_in_common_frame(target, shape, way.turn);
  return matched_in_frames(target, *shape, given_quarter_turns(source_frame_) + way.source_front,
                           given_quarter_turns(structure(target.graph()).frame) + way.target_front);
}

Correspondence_finder::Impl::Found Correspondence_finder::Impl::matched_parts(const Prepared_shape& target) const
{
  Found found;
  Pair_category category;
  const std::vector<Way> tried = ways(target, category);
  found.way = tried.front();
  found.ways = tried.size();
  double best_cost = std::numeric_limits<double>::infinity();
  for (const Way& way : tried) {
    if (options_.progress && !options_.progress(double(found.done) / double(tried.size()))) break;
    const Shared_shape shape = aligned(target, way.turn);
    Part_matching matching = matched_way(target, shape, way);
    const double preference = found.done == 0 ? 1 - options_.parts.clearly_better : 1;
    ++found.done;
    const double cost = tried.size() == 1 ? 0 : preference * double(alignment_cost(matching, *source_, *shape));
    if (cost >= best_cost) continue;
    best_cost = cost;
    found.way = way;
    found.matching = std::move(matching);
    found.target = shape;
  }
  if (found.done == 0) found.target = aligned(target, found.way.turn);
  if (options_.roles && found.done > 0)
    join_roles(target, *found.target, category, found.way, found.matching, found.known);
  return found;
}

void Correspondence_finder::Impl::warn_of_fronts(const Way& way, Correspondence& result)
{
  const auto warn = [&](const char* shape, int front) {
    if (front != 0)
      result.warnings.push_back(std::string("By the roles of its parts, the ") + shape +
                                " does not face +z; it was matched as if turned by " + std::to_string(90 * front) +
                                "° about the up axis. If it does, say so by --front given (`front_is_sure`).");
  };
  warn("source", way.source_front);
  warn("target", way.target_front);
}

Correspondence_finder::Impl::Found Correspondence_finder::Impl::without_unsure(Found found) const
{
  const auto unsure = [&](const Part_correspondence& pair) { return pair.confidence < options_.min_confidence; };
  std::vector<Part_correspondence>& pairs = found.matching.pairs;
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), unsure), pairs.end());
  return found;
}

Correspondence Correspondence_finder::Impl::rated(const Shared_shape& source, const Found& found) const
{
  const Search_run run(source, found.target, found.way.turn, group_labels(found.matching, *source, *found.target),
                       options_);
  Correspondence result = correspondence_of(run, run.result.best(), {});
  result.pairs = original_pairs(found.matching, *source, *found.target);
  take_roles(found.known, result);
  if (options_.alignments == 1) warn_of_fronts(found.way, result);
  if (found.done < found.ways) mark_cancelled(found.done, found.ways, result);
  return result;
}

std::vector<Transferred_label> Correspondence_finder::Impl::transferred_labels(const std::vector<Part_label>& labels,
                                                                               const Prepared_shape& target) const
{
  if (options_.method != Search_method::PARTS)
    throw Invalid_input("transfer_labels: labels are transferred by Search_method::PARTS only");
  if (labels.size() != number_of_parts_)
    throw Invalid_input("transfer_labels: there are " + std::to_string(labels.size()) + " labels of " +
                        std::to_string(number_of_parts_) + " parts of the source");
  const Found best = matched_parts(target);
  std::vector<Transferred_label> result(structure(target.graph()).parts.size());
  if (best.done == 0) return result; // it was cancelled
  for (std::size_t j = 0; j < best.target->parts.size(); ++j) {
    const Part_correspondence from = likeliest_source(best.matching, j);
    result[best.target->original[j]] = {labels[source_->original[from.source]], from.confidence};
  }
  return result;
}

Correspondence Correspondence_finder::Impl::rated_backwards(Found found) const
{
  for (Part_correspondence& pair : found.matching.pairs)
    pair = inverse(pair);
  std::sort(found.matching.pairs.begin(), found.matching.pairs.end(), is_before);
  std::swap(found.known.source_roles, found.known.target_roles);
  std::swap(found.way.source_front, found.way.target_front);
  const Shared_shape source = std::exchange(found.target, source_);
  return rated(source, found);
}

bool Correspondence_finder::Impl::takes_shapes_as_they_are() const
{
  return options_.maximum_parts == 0 && options_.source_parts.empty() && options_.target_parts.empty() &&
         options_.matching.pinned.empty() && options_.matching.forbidden.empty() &&
         options_.matching.role_costs.size() == 0;
}

std::array<Correspondence, 2> Correspondence_finder::Impl::both_orders(const Prepared_shape& target) const
{
  if (options_.method == Search_method::PARTS && takes_shapes_as_they_are()) {
    const Found found = without_unsure(matched_parts(target));
    if (found.way.turn == 0 && found.ways == 1) {
      std::array<Correspondence, 2> result{rated(source_, found), rated_backwards(found)};
      const std::size_t of_target = structure(target.graph()).parts.size();
      collect_unmatched(number_of_parts_, of_target, result[0]);
      collect_unmatched(of_target, number_of_parts_, result[1]);
      return result;
    }
  }
  return {std::move(ranked(target).front()), std::move(Impl(target, options_).ranked(prepared_source_).front())};
}

void Correspondence_finder::Impl::join_roles(const Prepared_shape& target, const Aligned_shape& aligned_target,
                                             const Pair_category& category, const Way& way, Part_matching& matching,
                                             Correspondence& result) const
{
  const Role_model_data& model = options_.roles->data();
  const std::optional<Pair_votes> votes = votes_of(target, category, way, result);
  if (!votes) {
    state_confidences(category.nearest < model.categories.size()
                          ? model.categories[category.nearest].geometric_confidence
                          : model.geometric_confidence,
                      matching);
    constrain(constraints(*source_, aligned_target), matching);
    return;
  }
  const auto& [source, of_target] = *votes;
  const Pair_terms terms = with_geometric_terms(
      role_terms(source, source_->original, of_target, aligned_target.original), matching.costs, matching.pairs);
  const Match_constraints constrained = constraints(*source_, aligned_target);
  const Category_roles& known = model.categories[category.index];
  matching = match_by_terms(terms, known.weights, std::move(matching), constrained, options_.parts);
  state_confidences(known.confidence, matching);
  constrain(constrained, matching);
}

std::optional<Correspondence_finder::Impl::Pair_votes>
Correspondence_finder::Impl::votes_of(const Prepared_shape& target, const Pair_category& category, const Way& way,
                                      Correspondence& result) const
{
  const Role_model_data& model = options_.roles->data();
  if (category.index == model.categories.size()) {
    result.warnings.push_back(category.note);
    return std::nullopt;
  }
  const Pair_votes votes{prepared_source_.alignments_->roles(options_.roles, way.source_front)->votes(category.index),
                         target.alignments_->roles(options_.roles, way.target_front)->votes(category.index)};
  result.category = model.categories[category.index].name;
  for (const Part_label& label : votes.source.labels)
    result.source_roles.push_back(label.coarse);
  for (const Part_label& label : votes.target.labels)
    result.target_roles.push_back(label.coarse);
  return votes;
}

} // namespace CGAL::Shape_correspondence
