// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "base/quantized.h"
#include "matching/Alignments.h"
#include "matching/Search_run.h"
#include "matching/aligned_matching.h"
#include "matching/match_parts.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/exact_search.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

void check(const Search_options& options)
{
  const Energy_weights& weights = options.matching.weights;
  for (double weight : {weights.distortion, weights.connectedness, weights.split})
    if (!(weight >= 0 && weight <= largest_number))
      throw Invalid_input("find_correspondence: the weights of E_d, E_c and E_s must not be negative or beyond 1e50");
  if (!(weights.roles >= 0 && weights.roles <= largest_number))
    throw Invalid_input("find_correspondence: the weight of roles must not be negative or beyond 1e50");
  if (!(options.matching.unmatched_cost >= 0))
    throw Invalid_input("find_correspondence: the cost of leaving a part unmatched must not be negative");
  if (options.maximum_parts < 0 || options.alignments < 0)
    throw Invalid_input("find_correspondence: the numbers of parts and of alignments must not be negative");
  if (!(options.min_confidence >= 0 && options.min_confidence <= 1))
    throw Invalid_input("find_correspondence: the least confidence must be between 0 and 1");
  if (options.roles && !options.category.empty()) options.roles->roles(options.category); // throws if there is none
  if (options.solutions < 1) throw Invalid_input("find_correspondence: at least one solution must be asked for");
}

// Pairs of connected parts, and parts that touch nothing.
std::size_t number_of_counted_pairs(const Aligned_shape& shape)
{
  std::vector<char> touches(shape.parts.size(), 0);
  for (const Aligned_shape::Contact& contact : shape.contacts)
    touches[contact.parts[0]] = touches[contact.parts[1]] = 1;
  const auto alone = std::size_t(std::count(touches.begin(), touches.end(), 0));
  return std::max<std::size_t>(1, shape.contacts.size() + alone);
}

// The turns of the target that are tried.
std::vector<int> tried_turns(const Shape_frame& source, const Shape_frame& target, int alignments)
{
  std::vector<int> turns = alignment_turns(source, target);
  if (alignments > 0 && turns.size() > std::size_t(alignments)) turns.resize(std::size_t(alignments));
  return turns;
}

// Before the work: `method` would deform more groups than it can within seconds.
void check_size(const Aligned_shape& deformed, const std::string& name, Search_method method)
{
  const bool is_beam = method == Search_method::BEAM;
  const std::size_t most = is_beam ? most_beam_groups : most_exact_groups;
  if (deformed.number_of_groups() <= most) return;
  throw Invalid_input("find_correspondence: shape '" + name + "' has " + std::to_string(deformed.number_of_groups()) +
                      " groups of parts, and " + (is_beam ? "beam" : "exact") + " search takes at most " +
                      std::to_string(most) + ": match its largest parts only, or use the default method");
}

void mark_cancelled(std::size_t done, std::size_t runs, Correspondence& correspondence)
{
  correspondence.complete = correspondence.optimal = false;
  correspondence.warnings.push_back("The search was cancelled after " + std::to_string(done) + " of " +
                                    std::to_string(runs) + " runs; this is the best result up to then.");
}

void take_roles(const Correspondence& known, Correspondence& correspondence)
{
  correspondence.category = known.category;
  correspondence.source_roles = known.source_roles;
  correspondence.target_roles = known.target_roles;
  correspondence.warnings.insert(correspondence.warnings.end(), known.warnings.begin(), known.warnings.end());
}

// The shape as far as it takes part. \param chosen indices in the structural graph; empty: all
Matching_problem::Shared_shape participating(Matching_problem::Shared_shape shape,
                                             const std::vector<std::size_t>& chosen)
{
  if (chosen.empty()) return shape;
  std::vector<char> is_kept(shape->parts.size(), 0);
  for (std::size_t part : chosen) {
    const auto found = std::find(shape->original.begin(), shape->original.end(), part);
    if (found == shape->original.end())
      throw Invalid_input("find_correspondence: there is no part number " + std::to_string(part) +
                          " to choose, the shape has " + std::to_string(shape->parts.size()) + " parts");
    is_kept[std::size_t(found - shape->original.begin())] = 1;
  }
  return std::make_shared<Deformable_shape>(restricted(*shape, is_kept));
}

// Parts that are pinned are groups of their own.
Matching_problem::Shared_shape regrouped(const Matching_problem::Shared_shape& shape,
                                         const std::vector<std::vector<std::size_t>>& sets)
{
  return sets.empty() ? shape : std::make_shared<Deformable_shape>(shape->regrouped(sets));
}

void check_indices(const Matching_options& matching, std::size_t Part_pair::*side, std::size_t parts, const char* shape)
{
  for (const auto* pairs : {&matching.pinned, &matching.forbidden})
    for (const Part_pair& pair : *pairs)
      if (pair.*side >= parts)
        throw Invalid_input("find_correspondence: there is no part number " + std::to_string(pair.*side) +
                            " to pin or forbid, the " + shape + " has " + std::to_string(parts) + " parts");
}

void check_role_costs(const Eigen::MatrixXd& costs, std::size_t source_parts, std::size_t target_parts)
{
  if (costs.size() == 0) return;
  if (costs.rows() != Eigen::Index(source_parts) || costs.cols() != Eigen::Index(target_parts))
    throw Invalid_input("find_correspondence: the costs of roles are " + std::to_string(costs.rows()) + " x " +
                        std::to_string(costs.cols()) + "; the shapes have " + std::to_string(source_parts) + " and " +
                        std::to_string(target_parts) + " parts");
  if (!(costs.array() >= 0).all() || !(costs.array() <= 1).all())
    throw Invalid_input("find_correspondence: the costs of roles must be between 0 and 1");
}

// Which of the parts take part, of equally prominent ones the same in every alignment. \param shape in its own frame
std::vector<std::size_t> participants(const Matching_problem::Shared_shape& shape,
                                      const std::vector<std::size_t>& chosen, int maximum_parts)
{
  if (maximum_parts == 0) return chosen;
  const Matching_problem::Shared_shape all = participating(shape, chosen);
  return restricted(*all, most_prominent_parts(*all, std::size_t(maximum_parts))).original;
}

} // namespace

Search_options paper_options()
{
  Search_options options;
  options.method = Search_method::BEAM;
  options.alignments = 0;
  options.coarse_target = false;
  return options;
}

class Correspondence_finder::Impl
{
public:
  Impl(const Prepared_shape& source, const Search_options& options)
      : options_(options),
        pinned_(pinned_sets(options.matching.pinned)),
        prepared_source_(source),
        source_frame_(structure(source.graph()).frame),
        number_of_parts_(structure(source.graph()).parts.size())
  {
    check(options);
    check_indices(options.matching, &Part_pair::source, number_of_parts_, "source");
    source_ = source.alignments_->aligned(0);
    source_ = participating(source_, participants(source_, options.source_parts, options.maximum_parts));
    source_ = regrouped(source_, pinned_.source);
    if (options.maximum_parts > 0 && !options.coarse_target) options_.both_directions = false;
  }

  std::vector<Correspondence> ranked(const Prepared_shape& target) const
  {
    check_indices(options_.matching, &Part_pair::target, structure(target.graph()).parts.size(), "target");
    check_role_costs(options_.matching.role_costs, number_of_parts_, structure(target.graph()).parts.size());
    std::vector<Correspondence> result;
    if (options_.method == Search_method::PARTS)
      result.push_back(rated(source_, without_unsure(matched_parts(target))));
    else
      result = least_energy(target);
    for (Correspondence& correspondence : result)
      collect_unmatched(number_of_parts_, structure(target.graph()).parts.size(), correspondence);
    return result;
  }

  std::array<Correspondence, 2> both_orders(const Prepared_shape& target) const;
  std::vector<Transferred_label> transferred_labels(const std::vector<Part_label>& labels,
                                                    const Prepared_shape& target) const;

  double lower_bound(const Prepared_shape& target, double unmatched_energy) const;

private:
  using Shared_shape = Matching_problem::Shared_shape;

  std::vector<Correspondence> least_energy(const Prepared_shape& target) const;
  Part_matching matched_in_common_frame(const Prepared_shape& target, const Shared_shape& shape, int turn) const;
  Part_matching matched_in_frames(const Prepared_shape& target, const Aligned_shape& shape, int source_turn,
                                  int target_turn) const;

  // An alignment that is tried: the turn of the target into the source's frame, and, by roles, the quarter turns from
  // the given orientations with which the shapes look to +z.
  struct Way
  {
    int turn = 0, source_front = 0, target_front = 0;
    bool by_roles = false;
  };
  // The alignments that are tried, the first guess first. \param category of both shapes, if roles tell one
  std::vector<Way> ways(const Prepared_shape& target, Pair_category& category) const;
  Part_matching matched_way(const Prepared_shape& target, const Shared_shape& shape, const Way& way) const;

  // What `Search_method::PARTS` finds, before it is rated by the energy.
  struct Found
  {
    Part_matching matching; // of the source and the target in the alignment
    Shared_shape target;    // aligned
    Way way;
    Correspondence known;           // roles, category and warnings
    std::size_t done = 0, ways = 0; // alignments
  };
  Found matched_parts(const Prepared_shape& target) const;
  // Without the pairs of less than the least confidence.
  Found without_unsure(Found found) const;
  // The correspondence by which the source is deformed.
  Correspondence rated(const Shared_shape& source, const Found& found) const;
  // The correspondence by which the target is deformed. \pre it is not turned
  Correspondence rated_backwards(Found found) const;
  bool takes_shapes_as_they_are() const
  {
    return options_.maximum_parts == 0 && options_.source_parts.empty() && options_.target_parts.empty() &&
           options_.matching.pinned.empty() && options_.matching.forbidden.empty() &&
           options_.matching.role_costs.size() == 0;
  }

  std::shared_ptr<const Shape_features> features(const Prepared_shape& of, const Shared_shape& shape, int turn) const
  {
    Alignments& shapes = *of.alignments_;
    return shape == shapes.aligned(turn) ? shapes.features(turn, options_.parts)
                                         : std::make_shared<Shape_features>(*shape, options_.parts);
  }
  using Alignments = Prepared_shape::Alignments;
  Shared_shape aligned(const Prepared_shape& target, int quarter_turns) const
  {
    Alignments& shapes = *target.alignments_;
    const int maximum_parts = options_.coarse_target ? options_.maximum_parts : 0;
    return regrouped(participating(shapes.aligned(quarter_turns),
                                   participants(shapes.aligned(0), options_.target_parts, maximum_parts)),
                     pinned_.target);
  }
  double lower_bound(const Shared_shape& deformed, const Shared_shape& other, double unmatched_energy) const;

  // What trees tell of the two shapes.
  struct Pair_votes
  {
    const Role_votes &source, &target;
  };
  std::optional<Pair_votes> votes_of(const Prepared_shape& target, const Pair_category& category, const Way& way,
                                     Correspondence& result) const;
  // The options with `Matching_options::role_costs`, as far as roles are asked for and known. \param result as above
  Search_options with_role_costs(const Prepared_shape& target, Correspondence& result) const;
  void join_roles(const Prepared_shape& target, const Aligned_shape& aligned_target, const Pair_category& category,
                  const Way& way, Part_matching& matching, Correspondence& result) const;

  Match_constraints constraints(const Aligned_shape& source, const Aligned_shape& target) const
  {
    return Match_constraints(source, target, options_.matching);
  }

  Search_options options_;
  Pinned_sets pinned_;
  Prepared_shape prepared_source_;
  Shape_frame source_frame_;
  std::size_t number_of_parts_;
  Shared_shape source_;
};

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

// With either shape turned from its own frame.
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

std::vector<Correspondence_finder::Impl::Way> Correspondence_finder::Impl::ways(const Prepared_shape& target,
                                                                                Pair_category& category) const
{
  std::vector<Way> result;
  const Shape_frame& target_frame = structure(target.graph()).frame;
  if (options_.roles) {
    const Role_model_data& model = options_.roles->data();
    category.index = model.index(options_.category);
    Alignments &a = *prepared_source_.alignments_, &b = *target.alignments_;
    if (options_.alignments == 1) {
      if (options_.category.empty())
        category = category_of_pair(*a.roles(options_.roles), *b.roles(options_.roles), model, options_.parts);
    } else {
      const Turned_roles source = a.roles_by_turn(options_.roles), of_target = b.roles_by_turn(options_.roles);
      if (options_.category.empty()) category = category_of_pair(source, of_target, model, options_.parts);
      if (category.index < model.categories.size())
        for (int from : front_turns(source, category.index, model.trees, options_.parts))
          for (int to : front_turns(of_target, category.index, model.trees, options_.parts))
            result.push_back(
                {given_quarter_turns(target_frame) + to - given_quarter_turns(source_frame_) - from, from, to, true});
    }
  }
  // Of ways that cost the same the first is taken: the same one, whichever shape is the source
  if (!result.empty() && comes_first(*aligned(target, 0), *source_))
    std::stable_sort(result.begin(), result.end(),
                     [](const Way& a, const Way& b) { return a.target_front < b.target_front; });
  if (result.empty())
    for (int turn : tried_turns(source_frame_, target_frame, options_.alignments))
      result.push_back({turn, 0, 0, false});
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
  const Shared_shape source = std::exchange(found.target, source_);
  return rated(source, found);
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
    state_confidences(model.geometric_confidence, matching);
    constrain(constraints(*source_, aligned_target), matching);
    return;
  }
  const auto& [source, of_target] = *votes;
  const Pair_terms terms =
      with_geometric_terms(role_terms(source, source_->original, of_target, aligned_target.original), matching);
  const Match_constraints constrained = constraints(*source_, aligned_target);
  const Category_roles& known = model.categories[category.index];
  matching = match_by_terms(terms, known.weights, std::move(matching), constrained, options_.parts);
  state_confidences(known.confidence, matching);
  constrain(constrained, matching);
}

// \param result gets the roles, or why there are none
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

Search_options Correspondence_finder::Impl::with_role_costs(const Prepared_shape& target, Correspondence& result) const
{
  Search_options options = options_;
  if (!(options.matching.weights.roles > 0) || !options.roles || options.matching.role_costs.size() > 0) return options;
  Pair_category category;
  const Way way = ways(target, category).front();
  if (const std::optional<Pair_votes> votes = votes_of(target, category, way, result))
    options.matching.role_costs = 1 - agreement_of_votes(votes->source, votes->target).array();
  return options;
}

std::vector<Correspondence> Correspondence_finder::Impl::least_energy(const Prepared_shape& target) const
{
  check_size(*source_, structure(prepared_source_.graph()).name, options_.method);
  const std::vector<int> turns = tried_turns(source_frame_, structure(target.graph()).frame, options_.alignments);
  Correspondence known;
  const Search_options options = with_role_costs(target, known);
  std::vector<Direction> directions{Direction::SOURCE_TO_TARGET};
  if (options_.both_directions) directions.push_back(Direction::TARGET_TO_SOURCE);

  std::unique_ptr<const Search_run> best;
  std::size_t states = 0, evaluations = 0, done = 0;
  const std::size_t run_count = turns.size() * directions.size();
  bool cancelled = false;
  for (std::size_t t = 0; t < turns.size() && !cancelled; ++t) {
    const Shared_shape shape = aligned(target, turns[t]);
    if (options.both_directions) check_size(*shape, structure(target.graph()).name, options.method);
    for (Direction direction : directions) {
      cancelled = cancelled || (options_.progress && !options_.progress(double(done) / double(run_count)));
      if (cancelled) break;
      auto run = std::make_unique<Search_run>(source_, shape, direction, turns[t], options);
      ++done;
      states += run->result.summary.states;
      evaluations += run->result.summary.evaluations;
      if (!best || quantized(run->score()) < quantized(best->score())) best = std::move(run);
    }
  }

  std::vector<Correspondence> result;
  if (best) {
    std::vector<double> min_marginals;
    if (options_.min_marginals)
      min_marginals = Exact_search(best->problem.energy(), options_.exact).min_marginals(best->result);
    for (const Solution& solution : best->result.solutions)
      result.push_back(correspondence_of(*best, solution, result.empty() ? min_marginals : std::vector<double>()));
  } else {
    result.emplace_back();
  }
  for (Correspondence& correspondence : result) {
    correspondence.search.states = states;
    correspondence.search.evaluations = evaluations;
    take_roles(known, correspondence);
    if (cancelled) mark_cancelled(done, run_count, correspondence);
  }
  return result;
}

double Correspondence_finder::Impl::lower_bound(const Prepared_shape& target, double unmatched_energy) const
{
  const bool both_directions = options_.both_directions && options_.method != Search_method::PARTS;
  double bound = std::numeric_limits<double>::infinity();
  for (int turn : tried_turns(source_frame_, structure(target.graph()).frame, options_.alignments)) {
    const Shared_shape shape = aligned(target, turn);
    bound = std::min(bound, lower_bound(source_, shape, unmatched_energy));
    if (both_directions) bound = std::min(bound, lower_bound(shape, source_, unmatched_energy));
  }
  constexpr double rounding = 1e-9; // sums are added up in another order
  return std::max(0., bound * (1 - rounding) - rounding);
}

double Correspondence_finder::Impl::lower_bound(const Shared_shape& deformed, const Shared_shape& other,
                                                double unmatched_energy) const
{
  const double pairs = double(number_of_counted_pairs(*deformed));
  if (options_.method != Search_method::PARTS)
    return Matching_problem(deformed, other, deformed == source_ ? options_.matching : reversed(options_.matching))
               .energy()
               .lower_bound() /
           pairs;
  if (options_.matching.norm == Energy_norm::POOLED) return 0;
  Matching_options matching = options_.matching;
  matching.cut_curves = false;
  matching.pinned.clear(); // without them the energy is not greater
  matching.forbidden.clear();
  matching.role_costs.resize(0, 0);
  matching.unmatched_cost = unmatched_energy;
  const Matching_problem problem(std::make_shared<Deformable_shape>(deformed->ungrouped()),
                                 std::make_shared<Deformable_shape>(other->ungrouped()), matching);
  return problem.has_shortlists() ? 0 : problem.energy().lower_bound() / pairs;
}

Correspondence_finder::Correspondence_finder(const Structural_graph& source, const Search_options& options)
    : Correspondence_finder(Prepared_shape(source), options)
{}

Correspondence_finder::Correspondence_finder(const Prepared_shape& source, const Search_options& options)
    : impl_(std::make_shared<Impl>(source, options))
{}

Correspondence Correspondence_finder::operator()(const Structural_graph& target) const
{
  return (*this)(Prepared_shape(target));
}

Correspondence Correspondence_finder::operator()(const Prepared_shape& target) const
{
  return std::move(ranked(target).front());
}

std::array<Correspondence, 2> Correspondence_finder::both_orders(const Prepared_shape& target) const
{
  return impl_->both_orders(target);
}

std::vector<Correspondence> Correspondence_finder::ranked(const Structural_graph& target) const
{
  return ranked(Prepared_shape(target));
}

std::vector<Correspondence> Correspondence_finder::ranked(const Prepared_shape& target) const
{
  return impl_->ranked(target);
}

std::vector<Transferred_label> Correspondence_finder::transfer_labels(const std::vector<Part_label>& labels,
                                                                      const Prepared_shape& target) const
{
  return impl_->transferred_labels(labels, target);
}

double Correspondence_finder::lower_bound(const Prepared_shape& target, double unmatched_energy) const
{
  return impl_->lower_bound(target, unmatched_energy);
}

Correspondence find_correspondence(const Structural_graph& source, const Structural_graph& target,
                                   const Search_options& options)
{
  return Correspondence_finder(source, options)(target);
}

std::vector<Correspondence> find_correspondences(const Structural_graph& source, const Structural_graph& target,
                                                 const Search_options& options)
{
  return Correspondence_finder(source, options).ranked(target);
}

} // namespace CGAL::Shape_correspondence
