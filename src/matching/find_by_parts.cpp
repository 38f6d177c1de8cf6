// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/number_text.h"
#include "base/quarter_turn.h"
#include "matching/Correspondence_finder_impl.h"
#include "matching/aligned_matching.h"
#include "matching/rate.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

// For each part of `from`, its index in `to`, another alignment of the same shape.
std::vector<std::size_t> places_of_parts(const Aligned_shape& from, const Aligned_shape& to)
{
  std::vector<std::size_t> result;
  for (std::size_t part : from.original)
    result.push_back(place_of(to, part));
  return result;
}

// Whether the energy of a matching is computed fast: all counterparts of parts in contact are compared pairwise.
bool is_rated_fast(const Part_matching& matching, const Aligned_shape& source)
{
  constexpr double most_comparisons = 2e7; // number of pairs of counterparts that takes about a fifth of a second
  std::vector<double> counterparts(source.parts.size(), 0);
  for (const Part_correspondence& pair : matching.pairs)
    ++counterparts[pair.source];
  double comparisons = 0;
  for (const Aligned_shape::Contact& contact : source.contacts)
    comparisons += counterparts[contact.parts[0]] * counterparts[contact.parts[1]];
  return comparisons <= most_comparisons;
}

// The matching reduced to the likeliest counterpart of every source part, of several the first.
Part_matching likeliest_only(const Part_matching& matching)
{
  std::map<std::size_t, Part_correspondence> best;
  for (const Part_correspondence& pair : matching.pairs)
    if (const auto [known, is_new] = best.emplace(pair.source, pair);
        !is_new && pair.confidence > known->second.confidence)
      known->second = pair;
  Part_matching result;
  for (const auto& [source, pair] : best)
    result.pairs.push_back(pair);
  return result;
}

} // namespace

Part_matching Correspondence_finder::Impl::matched_in_frames(const Prepared_shape& target, const Aligned_shape& shape,
                                                             int source_turn, int target_turn,
                                                             const Deadline* deadline) const
{
  const Shared_shape b = aligned(target, target_turn),
                     a = participating(prepared_source_.alignments_->aligned(source_turn), source_->original,
                                       pinned_.source);
  Part_matching result =
      renumbered(match_parts(*features(prepared_source_, a, source_turn), *features(target, b, target_turn),
                             options_.parts, constraints(*a, *b), deadline),
                 places_of_parts(*a, *source_), places_of_parts(*b, shape));
  std::sort(result.pairs.begin(), result.pairs.end(), is_before);
  return result;
}

std::shared_ptr<const Shape_features> Correspondence_finder::Impl::features(const Prepared_shape& of,
                                                                            const Shared_shape& shape, int turn) const
{
  Alignments& shapes = *of.alignments_;
  return shape == shapes.aligned(turn) ? shapes.features(turn, options_.parts)
                                       : std::make_shared<Shape_features>(*shape, options_.parts);
}

std::vector<Alignment_candidate> Correspondence_finder::Impl::candidates(const Prepared_shape& target,
                                                                         Pair_category& category) const
{
  std::vector<Alignment_candidate> result;
  if (options_.roles) {
    const Role_model_data& model = Role_model_access::data(*options_.roles);
    category.index = model.index(options_.category);
    if (options_.category.empty()) category = recognised(target);
    if (category.index < model.categories.size() && !(options_.alignments == 1 && options_.front_is_sure))
      result = candidates_by_roles(target, category.index);
  }
  // Ties of alignments go to the first; this order makes it the same one, whichever shape is the source
  if (!result.empty() && rank_of(*aligned(target, 0)) < rank_of(*source_))
    std::stable_sort(result.begin(), result.end(), [](const Alignment_candidate& a, const Alignment_candidate& b) {
      return a.target_front < b.target_front;
    });
  if (result.empty())
    for (int turn : tried_turns(target))
      result.push_back({turn, 0, 0, false});
  return result;
}

Pair_category Correspondence_finder::Impl::recognised(const Prepared_shape& target) const
{
  const Role_model_data& model = Role_model_access::data(*options_.roles);
  Alignments &a = *prepared_source_.alignments_, &b = *target.alignments_;
  const auto by_any_front = [&] {
    return category_of_pair(a.roles(options_.roles), b.roles(options_.roles), model, options_.parts);
  };
  if (options_.alignments != 1) return by_any_front();
  const Pair_category given =
      category_of_pair(*a.roles(options_.roles)[0], *b.roles(options_.roles)[0], model, options_.parts);
  if (given.index < model.categories.size() || options_.front_is_sure) return given;
  const Pair_category turned = by_any_front();
  const auto turns = [&](Alignments& shape) {
    return likely_front(shape.roles(options_.roles), turned.index, model.trees, options_.parts) != 0;
  };
  return turned.index < model.categories.size() && (turns(a) || turns(b)) ? turned : given;
}

std::string Correspondence_finder::Impl::source_category() const
{
  if (!options_.roles || !options_.category.empty() || number_of_parts_ == 0) return options_.category;
  const std::vector<Category_roles>& known = Role_model_access::data(*options_.roles).categories;
  const std::size_t category = recognised(prepared_source_).index;
  return category < known.size() ? known[category].name : "";
}

std::vector<Alignment_candidate> Correspondence_finder::Impl::candidates_by_roles(const Prepared_shape& target,
                                                                                  std::size_t category) const
{
  const auto fronts = [&](const Prepared_shape& shape) {
    const Turned_roles roles = shape.alignments_->roles(options_.roles);
    const int trees = Role_model_access::data(*options_.roles).trees;
    if (options_.alignments == 1) return std::vector<int>{likely_front(roles, category, trees, options_.parts)};
    return front_turns(roles, category, trees, options_.parts);
  };
  const int given = given_quarter_turns(structure(target.graph()).frame) - given_quarter_turns(source_frame_);
  const std::vector<int> of_source = fronts(prepared_source_), of_target = fronts(target);
  std::vector<Alignment_candidate> result;
  for (int from : of_source)
    for (int to : of_target)
      if (options_.alignments != 1 || from != 0 || to != 0)
        result.push_back({within_a_turn(given + to - from), from, to, true});
  return result;
}

Part_matching Correspondence_finder::Impl::matched_in(const Prepared_shape& target, const Shared_shape& shape,
                                                      const Alignment_candidate& alignment,
                                                      const Deadline* deadline) const
{
  if (alignment.by_roles)
    return matched_in_frames(target, *shape, given_quarter_turns(source_frame_) + alignment.source_front,
                             given_quarter_turns(structure(target.graph()).frame) + alignment.target_front, deadline);
  // Costs treat side and front differently, so that with an odd quarter turn the result depends on the frame of
  // comparison: that of the shape which is first in canonical order, whichever is the source
  if (alignment.turn % 2 != 0 && rank_of(*shape) < rank_of(*source_))
    return matched_in_frames(target, *shape, -alignment.turn, 0, deadline);
  return match_parts(*features(prepared_source_, source_, 0), *features(target, shape, alignment.turn), options_.parts,
                     constraints(*source_, *shape), deadline);
}

Part_match_result Correspondence_finder::Impl::matched_parts(const Prepared_shape& target, const Deadline& limit) const
{
  Part_match_result found;
  Pair_category category;
  const std::vector<Alignment_candidate> alignments = candidates(target, category);
  found.alignment = alignments.front();
  found.candidates = alignments.size();
  double best_cost = std::numeric_limits<double>::infinity();
  for (const Alignment_candidate& alignment : alignments) {
    if (options_.progress && !options_.progress(double(found.tried) / double(alignments.size())))
      found.end = search_was_cancelled;
    else if (found.tried > 0 && limit.is_over())
      found.end = time_is_over;
    if (!found.end.empty()) break;
    const Shared_shape shape = aligned(target, alignment.turn);
    // The first alignment always gets a result: with surfaces, for which some time is reserved, or with boxes only
    const Deadline of_first(std::max(limit.left(), small_time));
    Part_matching matching;
    try {
      matching = matched_in(target, shape, alignment, found.tried == 0 ? &of_first : &limit);
    } catch (const Out_of_time&) {
      found.end = time_is_over;
      if (found.tried > 0) break;
      found.known.warnings.push_back("There is no time to compare the surfaces of parts; their boxes are compared.");
      matching = matched_in(target, shape, alignment, nullptr);
    }
    const double preference = found.tried == 0 ? 1 - options_.parts.clearly_better : 1;
    ++found.tried;
    const double cost = alignments.size() == 1 ? 0 : preference * double(alignment_cost(matching, *source_, *shape));
    if (cost >= best_cost) continue;
    best_cost = cost;
    found.alignment = alignment;
    found.matching = std::move(matching);
    found.target = shape;
  }
  if (found.tried == 0) found.target = aligned(target, found.alignment.turn);
  if (options_.roles && found.tried > 0)
    join_roles(target, *found.target, category, found.alignment, found.matching, found.known);
  if (found.tried > 0) tell_features(target, found);
  return found;
}

void Correspondence_finder::Impl::tell_features(const Prepared_shape& target, Part_match_result& found) const
{
  const auto rows = [](const Prepared_shape& shape) { return structure(shape.graph()).features.rows(); };
  const Eigen::Index dimension = std::max(rows(prepared_source_), rows(target));
  const double weight = options_.parts.weights.features;
  if (dimension == 0 || weight == 0) return;
  std::vector<std::string>& warnings = found.known.warnings;
  if (found.matching.evidence.size() == 0)
    return warnings.push_back("The features were not compared, since one of the shapes has none.");
  found.known.feature_dimension = std::size_t(dimension);
  found.known.feature_weight = weight;
  warnings.push_back("Features of " + std::to_string(dimension) + " dimensions were compared with weight " +
                     number_text(weight) + "; confidences are not calibrated for them.");
}

void Correspondence_finder::Impl::warn_of_fronts(const Alignment_candidate& alignment, Correspondence& result)
{
  const auto warn = [&](const char* shape, int front) {
    if (front != 0)
      result.warnings.push_back(std::string("By the roles of its parts, the ") + shape +
                                " does not face +z; it was matched as if turned by " + std::to_string(90 * front) +
                                "° about the up axis. If it does, say that the front is given.");
  };
  warn("source", alignment.source_front);
  warn("target", alignment.target_front);
}

Part_match_result Correspondence_finder::Impl::without_unsure(Part_match_result found) const
{
  const auto unsure = [&](const Part_correspondence& pair) { return pair.confidence < options_.min_confidence; };
  std::vector<Part_correspondence>& pairs = found.matching.pairs;
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), unsure), pairs.end());
  return found;
}

Correspondence Correspondence_finder::Impl::rated(const Shared_shape& source, const Part_match_result& found,
                                                  const Deadline& limit) const
{
  Energy_options free_unmatched = options_.energy;
  free_unmatched.unmatched_cost = 0;
  const auto rated_pairs = [&](const Part_matching& matching, const Deadline& limit) {
    const Matching_problem problem(source, found.target, group_labels(matching, *source, *found.target), free_unmatched,
                                   limit);
    return rate(problem, Assignment(source->number_of_groups(), 0), Direction::SOURCE_TO_TARGET, found.alignment.turn);
  };
  const auto rate_all = [&]() -> std::optional<Correspondence> {
    if (!is_rated_fast(found.matching, *source)) return std::nullopt;
    try {
      return rated_pairs(found.matching, limit);
    } catch (const Out_of_time&) {
      return std::nullopt;
    }
  };
  const std::optional<Correspondence> of_all = rate_all();
  Correspondence result = of_all ? *of_all : rated_pairs(likeliest_only(found.matching), Deadline());
  if (!of_all)
    result.warnings.push_back("There is no time to compute the energy of all counterparts; it is that of the likeliest "
                              "counterpart of each part.");
  result.pairs = original_pairs(found.matching, *source, *found.target);
  result.search.method = "parts";
  result.search.states = result.search.evaluations = 1;
  take_roles(found.known, result);
  if (options_.alignments == 1) warn_of_fronts(found.alignment, result);
  if (!found.end.empty()) mark_ended(found.end, found.tried, found.candidates, result);
  return result;
}

std::vector<Transferred_label> Correspondence_finder::Impl::transferred_labels(const std::vector<Part_label>& labels,
                                                                               const Prepared_shape& target) const
{
  if (options_.method != Search_method::PARTS)
    throw Invalid_input("transfer_labels: labels are transferred by Search_method::PARTS only; choose it");
  if (labels.size() != number_of_parts_)
    throw Invalid_input("transfer_labels: there are " + std::to_string(labels.size()) + " labels of " +
                        std::to_string(number_of_parts_) + " parts of the source; give one for each");
  if (has_no_pairs(target)) return std::vector<Transferred_label>(structure(target.graph()).parts.size());
  const Part_match_result best = matched_parts(target, deadline());
  std::vector<Transferred_label> result(structure(target.graph()).parts.size());
  if (best.tried == 0) return result; // the search was cancelled
  for (std::size_t j = 0; j < best.target->parts.size(); ++j) {
    const Part_correspondence from = likeliest_source(best.matching, j);
    result[best.target->original[j]] = {labels[source_->original[from.source]], from.confidence};
  }
  return result;
}

Correspondence Correspondence_finder::Impl::rated_backwards(Part_match_result found, const Deadline& limit) const
{
  for (Part_correspondence& pair : found.matching.pairs)
    pair = inverse(pair);
  std::sort(found.matching.pairs.begin(), found.matching.pairs.end(), is_before);
  std::swap(found.known.source_roles, found.known.target_roles);
  std::swap(found.alignment.source_front, found.alignment.target_front);
  const Shared_shape source = std::exchange(found.target, source_);
  return rated(source, found, limit);
}

bool Correspondence_finder::Impl::takes_shapes_as_they_are() const
{
  return options_.maximum_parts == 0 && options_.source_parts.empty() && options_.target_parts.empty() &&
         options_.energy.pinned.empty() && options_.energy.forbidden.empty() && options_.energy.role_costs.size() == 0;
}

std::array<Correspondence, 2> Correspondence_finder::Impl::both_orders(const Prepared_shape& target) const
{
  if (options_.method == Search_method::PARTS && takes_shapes_as_they_are() && !has_no_pairs(target)) {
    const Deadline limit = deadline();
    const Part_match_result found = without_unsure(matched_parts(target, limit));
    if (found.alignment.turn == 0 && found.candidates == 1) {
      std::array<Correspondence, 2> result{rated(source_, found, limit), rated_backwards(found, limit)};
      const std::size_t of_target = structure(target.graph()).parts.size();
      collect_unmatched(number_of_parts_, of_target, result[0]);
      collect_unmatched(of_target, number_of_parts_, result[1]);
      return result;
    }
  }
  return {std::move(ranked(target).front()), std::move(Impl(target, options_).ranked(prepared_source_).front())};
}

void Correspondence_finder::Impl::join_roles(const Prepared_shape& target, const Aligned_shape& aligned_target,
                                             const Pair_category& category, const Alignment_candidate& alignment,
                                             Part_matching& matching, Correspondence& result) const
{
  const Role_model_data& model = Role_model_access::data(*options_.roles);
  const std::optional<Role_votes_of_pair> votes = votes_of(target, category, alignment, result);
  const std::size_t known_category = votes ? category.index : category.nearest;
  if (!votes || !uses_roles(model.categories[known_category].weights)) {
    state_confidences(known_category < model.categories.size() ? model.categories[known_category].geometric_confidence
                                                               : model.geometric_confidence,
                      matching);
    constrain(constraints(*source_, aligned_target), matching);
    return;
  }
  const Pair_terms terms =
      with_geometric_terms(role_terms(*votes->front(), source_->original, *votes->back(), aligned_target.original),
                           matching.costs, matching.pairs);
  const Match_constraints constrained = constraints(*source_, aligned_target);
  const Category_roles& known = model.categories[category.index];
  matching = match_by_terms(terms, known.weights, std::move(matching), constrained, options_.parts);
  state_confidences(known.confidence, matching);
  constrain(constrained, matching);
}

std::optional<Role_votes_of_pair> Correspondence_finder::Impl::votes_of(const Prepared_shape& target,
                                                                        const Pair_category& category,
                                                                        const Alignment_candidate& alignment,
                                                                        Correspondence& result) const
{
  const Role_model_data& model = Role_model_access::data(*options_.roles);
  if (category.index == model.categories.size()) {
    result.warnings.push_back(category.note);
    return std::nullopt;
  }
  const auto votes_of_shape = [&](const Prepared_shape& shape, int front, std::vector<std::string>& names) {
    const std::shared_ptr<const Shape_roles> roles = shape.alignments_->roles(options_.roles)[std::size_t(front)];
    const std::shared_ptr<const Role_votes> votes(roles, &roles->votes(category.index)); // keeps the roles alive
    for (const Part_label& label : votes->labels)
      names.push_back(label.coarse);
    return votes;
  };
  result.category = model.categories[category.index].name;
  return Role_votes_of_pair{votes_of_shape(prepared_source_, alignment.source_front, result.source_roles),
                            votes_of_shape(target, alignment.target_front, result.target_roles)};
}

} // namespace CGAL::Shape_correspondence
