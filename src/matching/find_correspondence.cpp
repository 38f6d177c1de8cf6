// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "matching/Match_task.h"
#include "matching/rate.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <memory>
#include <string>
#include <utility>

namespace CGAL::Shape_correspondence {

namespace internal {

Shared_shape participating(Shared_shape shape, const std::vector<std::size_t>& chosen,
                           const std::vector<std::vector<std::size_t>>& pinned)
{
  std::vector<char> is_kept(shape->parts.size(), 0);
  for (std::size_t part : chosen) {
    const std::size_t place = place_of(*shape, part);
    if (place == is_kept.size())
      throw Invalid_input("find_correspondence: there is no part number " + std::to_string(part) +
                          " to choose, the shape has " + std::to_string(shape->parts.size()) +
                          " parts; give numbers below that");
    is_kept[place] = 1;
  }
  if (!chosen.empty()) shape = std::make_shared<Deformable_shape>(restricted(*shape, is_kept));
  return pinned.empty() ? shape : std::make_shared<Deformable_shape>(shape->regrouped(pinned));
}

namespace {

// The parts to match: the most prominent of the chosen ones, with ties broken alike in every alignment.
// \param shape in its own frame \param maximum_parts 0: all
std::vector<std::size_t> participants(const Shared_shape& shape, const std::vector<std::size_t>& chosen,
                                      int maximum_parts)
{
  if (maximum_parts == 0) return chosen;
  const Shared_shape all = participating(shape, chosen);
  return restricted(*all, most_prominent_parts(*all, std::size_t(maximum_parts))).original;
}

void check(const Search_options& options)
{
  const Energy_weights& weights = options.energy.weights;
  for (double weight : {weights.distortion, weights.connectedness, weights.split})
    if (!(weight >= 0 && weight <= largest_number))
      throw Invalid_input("find_correspondence: the weights of E_d, E_c and E_s must not be negative or beyond 1e50");
  if (!(weights.roles >= 0 && weights.roles <= largest_number))
    throw Invalid_input("find_correspondence: the weight of roles must not be negative or beyond 1e50");
  if (!(options.energy.unmatched_cost >= 0))
    throw Invalid_input("find_correspondence: the cost of leaving a part unmatched must not be negative");
  if (options.maximum_parts < 0 || options.coarse_to_fine < 0 || options.alignments < 0)
    throw Invalid_input("find_correspondence: the numbers of parts and of alignments must not be negative");
  if (!(options.min_confidence >= 0 && options.min_confidence <= 1))
    throw Invalid_input("find_correspondence: the least confidence must be between 0 and 1");
  // Throws if the category does not exist
  if (options.roles && !options.category.empty()) options.roles->roles(options.category);
  if (!(options.time_limit >= 0))
    throw Invalid_input("find_correspondence: the time limit must be a number of seconds, or 0 for none");
  if (options.solutions < 1) throw Invalid_input("find_correspondence: at least one solution must be asked for");
}

void check_indices(const Energy_options& energy, std::size_t Part_pair::*side, std::size_t parts, const char* shape)
{
  for (const auto* pairs : {&energy.pinned, &energy.forbidden})
    for (const Part_pair& pair : *pairs)
      if (pair.*side >= parts)
        throw Invalid_input("find_correspondence: there is no part number " + std::to_string(pair.*side) +
                            " to pin or forbid, the " + shape + " has " + std::to_string(parts) +
                            " parts; give numbers below that");
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

Correspondence without_pairs(const Match_task& task)
{
  Correspondence result;
  result.complete = true;
  collect_unmatched(number_of_parts(task.source), number_of_parts(task.target), result);
  return result;
}

} // namespace

Match_source::Match_source(const Prepared_shape& given, const Search_options& given_options)
    : shape(given), options(given_options), pinned(pinned_sets(options.energy.pinned))
{
  check(options);
  check_indices(options.energy, &Part_pair::source, number_of_parts(shape), "source");
  if (number_of_parts(shape) == 0) return; // there will be no pairs
  aligned = alignments_of(shape).aligned(0);
  aligned = participating(aligned, participants(aligned, options.source_parts, options.maximum_parts), pinned.source);
  if (options.maximum_parts > 0 && !options.coarse_target) options.both_directions = false;
}

Shared_shape aligned_target(const Match_task& task, int quarter_turns)
{
  Alignments& shapes = alignments_of(task.target);
  const int maximum_parts = task.options.coarse_target ? task.options.maximum_parts : 0;
  return participating(shapes.aligned(quarter_turns),
                       participants(shapes.aligned(0), task.options.target_parts, maximum_parts), task.pinned.target);
}

std::vector<int> tried_turns(const Match_task& task)
{
  std::vector<int> turns = alignment_turns(structure(task.source.graph()).frame, structure(task.target.graph()).frame);
  if (task.options.alignments > 0 && turns.size() > std::size_t(task.options.alignments))
    turns.resize(std::size_t(task.options.alignments));
  return turns;
}

void mark_ended(const std::string& end, std::size_t done, std::size_t runs, Correspondence& correspondence)
{
  correspondence.complete = correspondence.optimal = false;
  correspondence.warnings.push_back(end + " after " + std::to_string(done) + " of " + std::to_string(runs) +
                                    " runs; this is the best result up to then.");
}

void take_roles(const Correspondence& known, Correspondence& correspondence)
{
  correspondence.category = known.category;
  correspondence.source_roles = known.source_roles;
  correspondence.target_roles = known.target_roles;
  correspondence.feature_dimension = known.feature_dimension;
  correspondence.feature_weight = known.feature_weight;
  correspondence.warnings.insert(correspondence.warnings.end(), known.warnings.begin(), known.warnings.end());
}

std::vector<Correspondence> ranked(const Match_task& task)
{
  check_indices(task.options.energy, &Part_pair::target, number_of_parts(task.target), "target");
  check_role_costs(task.options.energy.role_costs, number_of_parts(task.source), number_of_parts(task.target));
  if (has_no_pairs(task)) return {without_pairs(task)};
  std::vector<Correspondence> result;
  if (task.options.method == Search_method::PARTS) {
    const Deadline limit = deadline_of(task.options);
    result.push_back(
        rated(task.aligned_source, without_unsure(matched_parts(task, limit), task.options), task.options, limit));
  } else {
    result = least_energy(task);
  }
  for (Correspondence& correspondence : result)
    collect_unmatched(number_of_parts(task.source), number_of_parts(task.target), correspondence);
  return result;
}

} // namespace internal

Search_options paper_options()
{
  Search_options options;
  options.method = Search_method::BEAM;
  options.alignments = 0;
  options.coarse_target = false;
  options.direction_by_energy = true;
  options.energy.fit = Deform_to_fit::EXTREMITIES;
  options.energy.hard_proximity = true;
  return options;
}

Correspondence_finder::Correspondence_finder(const Prepared_shape& source, const Search_options& options)
    : source_(std::make_shared<internal::Match_source>(source, options))
{}

Correspondence_finder::Correspondence_finder(const Structural_graph& source, const Search_options& options)
    : Correspondence_finder(Prepared_shape(source), options)
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
  return internal::both_orders({*source_, target});
}

std::vector<Correspondence> Correspondence_finder::ranked(const Structural_graph& target) const
{
  return ranked(Prepared_shape(target));
}

std::vector<Correspondence> Correspondence_finder::ranked(const Prepared_shape& target) const
{
  return internal::ranked({*source_, target});
}

std::vector<Transferred_label> Correspondence_finder::transfer_labels(const std::vector<Part_label>& labels,
                                                                      const Prepared_shape& target) const
{
  return internal::transferred_labels(labels, {*source_, target});
}

std::string Correspondence_finder::source_category() const { return internal::category_of(*source_); }

double Correspondence_finder::lower_bound(const Prepared_shape& target, double unmatched_energy) const
{
  return internal::lower_bound({*source_, target}, unmatched_energy);
}

Correspondence find_correspondence(const Structural_graph& source, const Structural_graph& target,
                                   const Search_options& options)
{
  return Correspondence_finder(source, options)(target);
}

} // namespace CGAL::Shape_correspondence
