// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/directions.h"
#include "base/number_text.h"
#include "matching/Match_task.h"
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

namespace CGAL::Shape_correspondence::internal {

namespace {

// For each part of `from`, its index in `to`, another alignment of the same shape.
std::vector<std::size_t> places_of_parts(const Aligned_shape& from, const Aligned_shape& to)
{
  std::vector<std::size_t> result;
  for (std::size_t part : from.original)
    result.push_back(place_of(to, part));
  return result;
}

std::shared_ptr<const Shape_features> features(const Prepared_shape& of, const Shared_shape& shape, int turn,
                                               const Part_matching_options& options)
{
  Alignments& shapes = alignments_of(of);
  return shape == shapes.aligned(turn) ? shapes.features(turn, options)
                                       : std::make_shared<Shape_features>(*shape, options);
}

// Matches the shapes, each turned by a number of quarter turns from its own frame.
Part_matching matched_in_frames(const Match_task& task, const Aligned_shape& shape, int source_turn, int target_turn,
                                const Deadline* deadline)
{
  const Shared_shape b = aligned_target(task, target_turn),
                     a = participating(alignments_of(task.source).aligned(source_turn), task.aligned_source->original,
                                       task.pinned.source);
  Part_matching result =
      renumbered(match_parts(*features(task.source, a, source_turn, task.options.parts),
                             *features(task.target, b, target_turn, task.options.parts), task.options.parts,
                             Match_constraints(*a, *b, task.options.energy), deadline),
                 places_of_parts(*a, *task.aligned_source), places_of_parts(*b, shape));
  std::sort(result.pairs.begin(), result.pairs.end(), is_before);
  return result;
}

// Matches the shapes in an alignment. \param shape the target in this alignment \param deadline see `part_costs()`
Part_matching matched_in(const Match_task& task, const Shared_shape& shape, const Alignment_candidate& alignment,
                         const Deadline* deadline)
{
  if (alignment.by_roles)
    return matched_in_frames(
        task, *shape, given_quarter_turns(structure(task.source.graph()).frame) + alignment.source_front,
        given_quarter_turns(structure(task.target.graph()).frame) + alignment.target_front, deadline);
  // Costs treat side and front differently, so the result of an odd quarter turn depends on the frame in which parts
  // are compared. It is that of the shape with the lower rank, so that source and target may change places
  if (alignment.turn % 2 != 0 && rank_of(*shape) < rank_of(*task.aligned_source))
    return matched_in_frames(task, *shape, -alignment.turn, 0, deadline);
  return match_parts(*features(task.source, task.aligned_source, 0, task.options.parts),
                     *features(task.target, shape, alignment.turn, task.options.parts), task.options.parts,
                     Match_constraints(*task.aligned_source, *shape, task.options.energy), deadline);
}

// The category of both shapes in their given orientations. If there is none, and `front_is_sure` is false, the category
// to which they are nearest over all quarter turns, provided that one of them then clearly has another front. If
// several alignments are to be tried, always the category over all quarter turns.
Pair_category recognised(const Match_task& task)
{
  const Role_model_data& model = Role_model_access::data(*task.options.roles);
  Alignments &a = alignments_of(task.source), &b = alignments_of(task.target);
  const auto by_any_front = [&] {
    return category_of_pair(a.roles(task.options.roles), b.roles(task.options.roles), model, task.options.parts);
  };
  if (task.options.alignments != 1) return by_any_front();
  const Pair_category given =
      category_of_pair(*a.roles(task.options.roles)[0], *b.roles(task.options.roles)[0], model, task.options.parts);
  if (given.index < model.categories.size() || task.options.front_is_sure) return given;
  const Pair_category turned = by_any_front();
  const auto turns = [&](Alignments& shape) {
    return likely_front(shape.roles(task.options.roles), turned.index, model.trees, task.options.parts) != 0;
  };
  return turned.index < model.categories.size() && (turns(a) || turns(b)) ? turned : given;
}

// The alignments that make the fronts coincide, as found by the roles of a category; empty if only one alignment is
// wanted and it is the given one.
std::vector<Alignment_candidate> candidates_by_roles(const Match_task& task, std::size_t category)
{
  const auto fronts = [&](const Prepared_shape& shape) {
    const Turned_roles roles = alignments_of(shape).roles(task.options.roles);
    const int trees = Role_model_access::data(*task.options.roles).trees;
    if (task.options.alignments == 1) return std::vector<int>{likely_front(roles, category, trees, task.options.parts)};
    return front_turns(roles, category, trees, task.options.parts);
  };
  const int given = given_quarter_turns(structure(task.target.graph()).frame) -
                    given_quarter_turns(structure(task.source.graph()).frame);
  const std::vector<int> of_source = fronts(task.source), of_target = fronts(task.target);
  std::vector<Alignment_candidate> result;
  for (int from : of_source)
    for (int to : of_target)
      if (task.options.alignments != 1 || from != 0 || to != 0)
        result.push_back({within_a_turn(given + to - from), from, to, true});
  return result;
}

void join_roles(const Match_task& task, const Aligned_shape& target, const Pair_category& category,
                const Alignment_candidate& alignment, Part_matching& matching, Correspondence& result)
{
  const Role_model_data& model = Role_model_access::data(*task.options.roles);
  const std::optional<Role_votes_of_pair> votes = votes_of(task, category, alignment, result);
  const std::size_t known_category = votes ? category.index : category.nearest;
  if (!votes || !uses_roles(model.categories[known_category].weights)) {
    state_confidences(known_category < model.categories.size() ? model.categories[known_category].geometric_confidence
                                                               : model.geometric_confidence,
                      matching);
    constrain(Match_constraints(*task.aligned_source, target, task.options.energy), matching);
    return;
  }
  const Pair_terms terms =
      with_geometric_terms(role_terms(*votes->front(), task.aligned_source->original, *votes->back(), target.original),
                           matching.costs, matching.pairs);
  const Match_constraints constrained(*task.aligned_source, target, task.options.energy);
  const Category_roles& known = model.categories[category.index];
  matching = match_by_terms(terms, known.weights, std::move(matching), constrained, task.options.parts);
  state_confidences(known.confidence, matching);
  constrain(constrained, matching);
}

// Says in the result whether features were compared.
void tell_features(const Match_task& task, Part_match_result& found)
{
  const auto rows = [](const Prepared_shape& shape) { return structure(shape.graph()).features.rows(); };
  const Eigen::Index dimension = std::max(rows(task.source), rows(task.target));
  const double weight = task.options.parts.weights.features;
  if (dimension == 0 || weight == 0) return;
  std::vector<std::string>& warnings = found.known.warnings;
  if (found.matching.evidence.size() == 0)
    return warnings.push_back("The features were not compared, since one of the shapes has none.");
  found.known.feature_dimension = std::size_t(dimension);
  found.known.feature_weight = weight;
  warnings.push_back("Features of " + std::to_string(dimension) + " dimensions were compared with weight " +
                     number_text(weight) + "; confidences are not calibrated for them.");
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

// The matching reduced to the likeliest counterpart of every source part; of equally likely ones, the first.
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

void warn_of_fronts(const Alignment_candidate& alignment, Correspondence& result)
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

// The result with the energy of deforming the target. \pre the target is not turned
Correspondence rated_backwards(const Match_task& task, Part_match_result found, const Deadline& limit)
{
  for (Part_correspondence& pair : found.matching.pairs)
    pair = inverse(pair);
  std::sort(found.matching.pairs.begin(), found.matching.pairs.end(), is_before);
  std::swap(found.known.source_roles, found.known.target_roles);
  std::swap(found.alignment.source_front, found.alignment.target_front);
  const Shared_shape source = std::exchange(found.target, task.aligned_source);
  return rated(source, found, task.options, limit);
}

bool takes_shapes_as_they_are(const Search_options& options)
{
  return options.maximum_parts == 0 && options.source_parts.empty() && options.target_parts.empty() &&
         options.energy.pinned.empty() && options.energy.forbidden.empty() && options.energy.role_costs.size() == 0;
}

} // namespace

std::vector<Alignment_candidate> candidates(const Match_task& task, Pair_category& category)
{
  std::vector<Alignment_candidate> result;
  if (task.options.roles) {
    const Role_model_data& model = Role_model_access::data(*task.options.roles);
    category.index = model.index(task.options.category);
    if (task.options.category.empty()) category = recognised(task);
    if (category.index < model.categories.size() && !(task.options.alignments == 1 && task.options.front_is_sure))
      result = candidates_by_roles(task, category.index);
  }
  // Ties of alignments go to the first; this order makes it the same one, whichever shape is the source
  if (!result.empty() && rank_of(*aligned_target(task, 0)) < rank_of(*task.aligned_source))
    std::stable_sort(result.begin(), result.end(), [](const Alignment_candidate& a, const Alignment_candidate& b) {
      return a.target_front < b.target_front;
    });
  if (result.empty())
    for (int turn : tried_turns(task))
      result.push_back({turn, 0, 0, false});
  return result;
}

std::optional<Role_votes_of_pair> votes_of(const Match_task& task, const Pair_category& category,
                                           const Alignment_candidate& alignment, Correspondence& result)
{
  const Role_model_data& model = Role_model_access::data(*task.options.roles);
  if (category.index == model.categories.size()) {
    result.warnings.push_back(category.note);
    return std::nullopt;
  }
  const auto votes_of_shape = [&](const Prepared_shape& shape, int front, std::vector<std::string>& names) {
    const std::shared_ptr<const Shape_roles> roles = alignments_of(shape).roles(task.options.roles)[std::size_t(front)];
    const std::shared_ptr<const Role_votes> votes(roles, &roles->votes(category.index)); // keeps the roles alive
    for (const Part_label& label : votes->labels)
      names.push_back(label.coarse);
    return votes;
  };
  result.category = model.categories[category.index].name;
  return Role_votes_of_pair{votes_of_shape(task.source, alignment.source_front, result.source_roles),
                            votes_of_shape(task.target, alignment.target_front, result.target_roles)};
}

Part_match_result matched_parts(const Match_task& task, const Deadline& limit)
{
  Part_match_result found;
  Pair_category category;
  const std::vector<Alignment_candidate> alignments = candidates(task, category);
  found.alignment = alignments.front();
  found.candidates = alignments.size();
  double best_cost = std::numeric_limits<double>::infinity();
  for (const Alignment_candidate& alignment : alignments) {
    if (task.options.progress && !task.options.progress(double(found.tried) / double(alignments.size())))
      found.end = search_was_cancelled;
    else if (found.tried > 0 && limit.is_over())
      found.end = time_is_over;
    if (!found.end.empty()) break;
    const Shared_shape shape = aligned_target(task, alignment.turn);
    // The first alignment always gets a result: with surfaces, for which some time is reserved, or with boxes only
    const Deadline of_first(std::max(limit.left(), small_time));
    Part_matching matching;
    try {
      matching = matched_in(task, shape, alignment, found.tried == 0 ? &of_first : &limit);
    } catch (const Out_of_time&) {
      found.end = time_is_over;
      if (found.tried > 0) break;
      found.known.warnings.push_back("There is no time to compare the surfaces of parts; their boxes are compared.");
      matching = matched_in(task, shape, alignment, nullptr);
    }
    const double preference = found.tried == 0 ? 1 - task.options.parts.clearly_better : 1;
    ++found.tried;
    const double cost =
        alignments.size() == 1 ? 0 : preference * double(alignment_cost(matching, *task.aligned_source, *shape));
    if (cost >= best_cost) continue;
    best_cost = cost;
    found.alignment = alignment;
    found.matching = std::move(matching);
    found.target = shape;
  }
  if (found.tried == 0) found.target = aligned_target(task, found.alignment.turn);
  if (task.options.roles && found.tried > 0)
    join_roles(task, *found.target, category, found.alignment, found.matching, found.known);
  if (found.tried > 0) tell_features(task, found);
  return found;
}

Part_match_result without_unsure(Part_match_result found, const Search_options& options)
{
  const auto unsure = [&](const Part_correspondence& pair) { return pair.confidence < options.min_confidence; };
  std::vector<Part_correspondence>& pairs = found.matching.pairs;
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), unsure), pairs.end());
  return found;
}

Correspondence rated(const Shared_shape& source, const Part_match_result& found, const Search_options& options,
                     const Deadline& limit)
{
  Energy_options free_unmatched = options.energy;
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
  std::optional<Correspondence> of_all = rate_all();
  Correspondence result = of_all ? std::move(*of_all) : rated_pairs(likeliest_only(found.matching), Deadline());
  if (!of_all)
    result.warnings.push_back("There is no time to compute the energy of all counterparts; it is that of the likeliest "
                              "counterpart of each part.");
  result.pairs = original_pairs(found.matching, *source, *found.target);
  result.search.method = "parts";
  result.search.states = result.search.evaluations = 1;
  take_roles(found.known, result);
  if (options.alignments == 1) warn_of_fronts(found.alignment, result);
  if (!found.end.empty()) mark_ended(found.end, found.tried, found.candidates, result);
  return result;
}

std::array<Correspondence, 2> both_orders(const Match_task& task)
{
  if (task.options.method == Search_method::PARTS && takes_shapes_as_they_are(task.options) && !has_no_pairs(task)) {
    const Deadline limit = deadline_of(task.options);
    Part_match_result found = without_unsure(matched_parts(task, limit), task.options);
    if (found.alignment.turn == 0 && found.candidates == 1) {
      std::array<Correspondence, 2> result{rated(task.aligned_source, found, task.options, limit),
                                           rated_backwards(task, std::move(found), limit)};
      const std::size_t of_target = number_of_parts(task.target);
      collect_unmatched(number_of_parts(task.source), of_target, result[0]);
      collect_unmatched(of_target, number_of_parts(task.source), result[1]);
      return result;
    }
  }
  const Match_source back(task.target, task.options);
  return {std::move(ranked(task).front()), std::move(ranked(Match_task(back, task.source)).front())};
}

std::vector<Transferred_label> transferred_labels(const std::vector<Part_label>& labels, const Match_task& task)
{
  if (task.options.method != Search_method::PARTS)
    throw Invalid_input("transfer_labels: labels are transferred by Search_method::PARTS only; choose it");
  if (labels.size() != number_of_parts(task.source))
    throw Invalid_input("transfer_labels: there are " + std::to_string(labels.size()) + " labels of " +
                        std::to_string(number_of_parts(task.source)) + " parts of the source; give one for each");
  if (has_no_pairs(task)) return std::vector<Transferred_label>(number_of_parts(task.target));
  const Part_match_result best = matched_parts(task, deadline_of(task.options));
  std::vector<Transferred_label> result(number_of_parts(task.target));
  if (best.tried == 0) return result; // a callback or the time limit ended the matching: no labels
  for (std::size_t j = 0; j < best.target->parts.size(); ++j) {
    const Part_correspondence from = likeliest_source(best.matching, j);
    result[best.target->original[j]] = {labels[task.aligned_source->original[from.source]], from.confidence};
  }
  return result;
}

std::string category_of(const Match_source& source)
{
  if (!source.options.roles || !source.options.category.empty() || number_of_parts(source.shape) == 0)
    return source.options.category;
  const std::vector<Category_roles>& known = Role_model_access::data(*source.options.roles).categories;
  const std::size_t category = recognised(Match_task(source, source.shape)).index;
  return category < known.size() ? known[category].name : "";
}

} // namespace CGAL::Shape_correspondence::internal
