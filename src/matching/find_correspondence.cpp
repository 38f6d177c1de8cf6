// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "matching/Correspondence_finder_impl.h"
#include "matching/rate.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <memory>
#include <string>
#include <utility>

namespace CGAL::Shape_correspondence {

namespace internal {

Matching_problem::Shared_shape participating(Matching_problem::Shared_shape shape,
                                             const std::vector<std::size_t>& chosen,
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

} // namespace internal

namespace {

// The parts to match: the most prominent of the chosen ones, with ties broken alike in every alignment.
// \param shape in its own frame \param maximum_parts 0: all
std::vector<std::size_t> participants(const Matching_problem::Shared_shape& shape,
                                      const std::vector<std::size_t>& chosen, int maximum_parts)
{
  if (maximum_parts == 0) return chosen;
  const Matching_problem::Shared_shape all = participating(shape, chosen);
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

} // namespace

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

Correspondence_finder::Impl::Impl(const Prepared_shape& source, const Search_options& options)
    : options_(options),
      pinned_(pinned_sets(options.energy.pinned)),
      prepared_source_(source),
      source_frame_(structure(source.graph()).frame),
      number_of_parts_(structure(source.graph()).parts.size())
{
  check(options);
  check_indices(options.energy, &Part_pair::source, number_of_parts_, "source");
  if (number_of_parts_ == 0) return; // there will be no pairs
  source_ = source.alignments_->aligned(0);
  source_ = participating(source_, participants(source_, options.source_parts, options.maximum_parts), pinned_.source);
  if (options.maximum_parts > 0 && !options.coarse_target) options_.both_directions = false;
}

std::vector<Correspondence> Correspondence_finder::Impl::ranked(const Prepared_shape& target) const
{
  check_indices(options_.energy, &Part_pair::target, structure(target.graph()).parts.size(), "target");
  check_role_costs(options_.energy.role_costs, number_of_parts_, structure(target.graph()).parts.size());
  if (has_no_pairs(target)) return {without_pairs(target)};
  std::vector<Correspondence> result;
  if (options_.method == Search_method::PARTS) {
    const Deadline limit = deadline();
    result.push_back(rated(source_, without_unsure(matched_parts(target, limit)), limit));
  } else {
    result = least_energy(target);
  }
  for (Correspondence& correspondence : result)
    collect_unmatched(number_of_parts_, structure(target.graph()).parts.size(), correspondence);
  return result;
}

Correspondence Correspondence_finder::Impl::without_pairs(const Prepared_shape& target) const
{
  Correspondence result;
  result.complete = true;
  collect_unmatched(number_of_parts_, structure(target.graph()).parts.size(), result);
  return result;
}

Correspondence_finder::Impl::Shared_shape Correspondence_finder::Impl::aligned(const Prepared_shape& target,
                                                                               int quarter_turns) const
{
  Alignments& shapes = *target.alignments_;
  const int maximum_parts = options_.coarse_target ? options_.maximum_parts : 0;
  return participating(shapes.aligned(quarter_turns),
                       participants(shapes.aligned(0), options_.target_parts, maximum_parts), pinned_.target);
}

std::vector<int> Correspondence_finder::Impl::tried_turns(const Prepared_shape& target) const
{
  std::vector<int> turns = alignment_turns(source_frame_, structure(target.graph()).frame);
  if (options_.alignments > 0 && turns.size() > std::size_t(options_.alignments))
    turns.resize(std::size_t(options_.alignments));
  return turns;
}

void Correspondence_finder::Impl::mark_ended(const std::string& end, std::size_t done, std::size_t runs,
                                             Correspondence& correspondence)
{
  correspondence.complete = correspondence.optimal = false;
  correspondence.warnings.push_back(end + " after " + std::to_string(done) + " of " + std::to_string(runs) +
                                    " runs; this is the best result up to then.");
}

void Correspondence_finder::Impl::take_roles(const Correspondence& known, Correspondence& correspondence)
{
  correspondence.category = known.category;
  correspondence.source_roles = known.source_roles;
  correspondence.target_roles = known.target_roles;
  correspondence.feature_dimension = known.feature_dimension;
  correspondence.feature_weight = known.feature_weight;
  correspondence.warnings.insert(correspondence.warnings.end(), known.warnings.begin(), known.warnings.end());
}

Correspondence_finder::Correspondence_finder(const Prepared_shape& source, const Search_options& options)
    : impl_(std::make_shared<Impl>(source, options))
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

std::string Correspondence_finder::source_category() const { return impl_->source_category(); }

double Correspondence_finder::lower_bound(const Prepared_shape& target, double unmatched_energy) const
{
  return impl_->lower_bound(target, unmatched_energy);
}

Correspondence find_correspondence(const Structural_graph& source, const Structural_graph& target,
                                   const Search_options& options)
{
  return Correspondence_finder(source, options)(target);
}

} // namespace CGAL::Shape_correspondence
