// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Matching_problem.h"
#include "base/quantized.h"
#include "energy/Contact_table.h"
#include "energy/cut_curves.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

// Least and greatest coordinates of a group.
Eigen::Matrix<double, 6, 1> extremes(const Aligned_shape::Group& group)
{
  Eigen::Matrix<double, 6, 1> result;
  result << group.box.min(), group.box.max();
  return result;
}

// The target groups that a source group may be matched to: all that the symmetry allows, or any if it allows none, or
// the nearest ones, in their order.
std::vector<std::size_t> candidates(const Aligned_shape::Group& group, const Aligned_shape& target)
{
  const bool none_may = std::none_of(target.groups.begin(), target.groups.end(),
                                     [&](const Aligned_shape::Group& other) { return may_match(group, other); });
  std::vector<std::pair<long, std::size_t>> nearest;
  for (std::size_t h = 0; h < target.groups.size(); ++h)
    if (none_may || may_match(group, target.groups[h]))
      nearest.emplace_back(quantized((extremes(group) - extremes(target.groups[h])).norm()), h);
  if (nearest.size() > maximum_labels) {
    std::sort(nearest.begin(), nearest.end());
    nearest.resize(maximum_labels);
  }
  std::vector<std::size_t> result;
  for (const auto& candidate : nearest)
    result.push_back(candidate.second);
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<Group_label> labels_of_group(const Aligned_shape& source, std::size_t group, const Aligned_shape& target,
                                         const Matching_options& options)
{
  const std::vector<std::size_t> matched = candidates(source.groups[group], target);
  std::vector<Group_label> result;
  result.reserve(2 * matched.size() + 1);
  for (std::size_t candidate : matched)
    result.push_back(match_groups(source, group, target, candidate));
  for (std::size_t l = 0; options.cut_curves && l < matched.size(); ++l) {
    if (result[l].operation == Operation::MATCH) continue; // one to one
    Group_label cut = cut_curves(source, group, target, result[l]);
    if (cut.operation == Operation::CUT || cut.operation == Operation::JOIN) result.push_back(std::move(cut));
  }
  if (options.unmatched_cost < Matching_options::never) {
    result.emplace_back();
    result.back().images.resize(source.groups[group].parts.size());
  }
  return result;
}

std::vector<std::vector<Group_label>> all_labels(const Aligned_shape& source, const Aligned_shape& target,
                                                 const Matching_options& options)
{
  std::vector<std::vector<Group_label>> result;
  for (std::size_t g = 0; g < source.groups.size(); ++g)
    result.push_back(labels_of_group(source, g, target, options));
  return result;
}

} // namespace

Matching_problem::Matching_problem(Shared_shape source, Shared_shape target, const Matching_options& options)
    : Matching_problem(source, target, all_labels(*source, *target, options), options)
{
  has_shortlists_ = target_->groups.size() > maximum_labels;
}

Matching_problem::Matching_problem(Aligned_shape source, Aligned_shape target, const Matching_options& options)
    : Matching_problem(std::make_shared<Deformable_shape>(std::move(source)),
                       std::make_shared<Deformable_shape>(std::move(target)), options)
{}

Matching_problem::Matching_problem(Shared_shape source, Shared_shape target,
                                   std::vector<std::vector<Group_label>> labels, const Matching_options& options)
    : source_(std::move(source)),
      target_(std::move(target)),
      options_(options),
      labels_(std::move(labels)),
      fitted_(*source_, *target_, labels_),
      rods_(&source_->rods())
{
  fill_contact_energies();
  fill_cut_energies();
  add_up_energy();
}

void Matching_problem::fill_contact_energies()
{
  std::size_t count = 0;
  for (const Aligned_shape::Contact& contact : source().contacts) {
    contact_begin_.push_back(count);
    count +=
        number_of_labels(source().group_of[contact.parts[0]]) * number_of_labels(source().group_of[contact.parts[1]]);
  }
  contact_energies_.reserve(count);
  constexpr std::size_t at_once = 8192; // keeps what is listed in cache
  Contact_table table(*this);
  for (std::size_t contact = 0; contact < source().contacts.size(); ++contact) {
    table.list(contact);
    if (table.size() > at_once) table.compute(contact_energies_);
  }
  table.compute(contact_energies_);
}

// Segments next to each other were connected.
void Matching_problem::fill_cut_energies()
{
  cut_energies_.resize(labels_.size());
  std::vector<double> distortion;
  for (std::size_t g = 0; g < labels_.size(); ++g) {
    cut_energies_[g].resize(labels_[g].size());
    for (std::size_t l = 0; l < labels_[g].size(); ++l) {
      if (labels_[g][l].operation != Operation::CUT) continue;
      for (std::size_t part : source().groups[g].parts)
        for (std::size_t a : fitted_.images(part, l))
          for (std::size_t b : fitted_.images(part, l)) {
            const Fitted_piece &first = fitted_[a], &second = fitted_[b];
            if (first.source.count < 2 || second.source.index != first.source.index + 1) continue;
            const Structural_rods rods(fitted_.source_piece(first.source_index).samples,
                                       fitted_.source_piece(second.source_index).samples);
            distortions({&rods}, fitted_.samples(first), fitted_.samples(second), distortion);
            cut_energies_[g][l].distortion += distortion[0];
            cut_energies_[g][l].connectedness += fitted_.connectedness(rods, first, second);
          }
    }
  }
}

// Eq. 1 as a sum over labels of groups and pairs of groups. The root terms are w_s E_s (`split_energy()`, Eq. 5), and a
// pooled E_d (`distortion_energy()`, Eq. 3).
void Matching_problem::add_up_energy()
{
  const Energy_weights& weights = options_.weights;
  const bool pooled = options_.norm == Energy_norm::POOLED;
  const std::size_t n = labels_.size();
  Pairwise_energy::Root_term split{weights.split, double(n), {}, {}}, rods{weights.distortion, 0, {}, {}};
  for (std::size_t g = 0; g < n; ++g) {
    const Eigen::Index count = Eigen::Index(labels_[g].size());
    energy_.unary.push_back(Eigen::VectorXd::Zero(count));
    rods.unary.push_back(Eigen::VectorXd::Zero(count));
    split.unary.push_back(Eigen::VectorXd::Zero(count));
    for (Eigen::Index l = 0; l < count; ++l) {
      const Group_label& label = labels_[g][std::size_t(l)];
      split.unary[g][l] = label.solidity_ratio * label.solidity_ratio;
      const Rod_energy& cut = cut_energies_[g][std::size_t(l)];
      energy_.unary[g][l] = weights.distortion * cut.distortion + weights.connectedness * cut.connectedness;
      if (is_unmatched(g, std::size_t(l)) && source().groups[g].contacts.empty())
        energy_.unary[g][l] = options_.unmatched_cost;
    }
  }

  Eigen::MatrixXi edge_of = Eigen::MatrixXi::Constant(Eigen::Index(n), Eigen::Index(n), -1);
  const double contact_count = double(std::max<std::size_t>(1, source().contacts.size()));
  for (std::size_t contact = 0; contact < source().contacts.size(); ++contact) {
    const auto& parts = source().contacts[contact].parts;
    const double rod_count = double(source().parts[parts[0]].samples.cols() * source().parts[parts[1]].samples.cols());
    rods.count += rod_count;
    const std::size_t g = source().group_of[parts[0]], h = source().group_of[parts[1]];
    const auto add = [&](std::size_t a, std::size_t b, double& cost, double& kept) {
      const Rod_energy energy = contact_energy(contact, a, b);
      if (pooled) kept += rod_count * (1 - energy.distortion) * (1 - energy.distortion);
      if (is_unmatched(g, a) || is_unmatched(h, b))
        cost += options_.unmatched_cost;
      else
        cost += pooled ? weights.connectedness * energy.connectedness / contact_count
                       : weights.distortion * energy.distortion + weights.connectedness * energy.connectedness;
    };
    if (g == h) {
      for (std::size_t a = 0; a < labels_[g].size(); ++a)
        add(a, a, energy_.unary[g][Eigen::Index(a)], rods.unary[g][Eigen::Index(a)]);
      continue;
    }
    const std::size_t low = std::min(g, h), high = std::max(g, h);
    int& edge = edge_of(Eigen::Index(low), Eigen::Index(high));
    if (edge < 0) {
      edge = int(energy_.edges.size());
      const Eigen::MatrixXd zero =
          Eigen::MatrixXd::Zero(Eigen::Index(labels_[low].size()), Eigen::Index(labels_[high].size()));
      energy_.edges.push_back({low, high, zero});
      rods.edge.push_back(zero);
    }
    Eigen::MatrixXd &cost = energy_.edges[std::size_t(edge)].cost, &kept = rods.edge[std::size_t(edge)];
    for (Eigen::Index a = 0; a < Eigen::Index(labels_[g].size()); ++a)
      for (Eigen::Index b = 0; b < Eigen::Index(labels_[h].size()); ++b)
        if (g == low)
          add(std::size_t(a), std::size_t(b), cost(a, b), kept(a, b));
        else
          add(std::size_t(a), std::size_t(b), cost(b, a), kept(b, a));
  }
  if (weights.split > 0) energy_.root_terms.push_back(std::move(split));
  if (pooled && weights.distortion > 0 && rods.count > 0) energy_.root_terms.push_back(std::move(rods));
}

Energy_terms Matching_problem::terms(const Assignment& assignment) const
{
  std::vector<Rod_energy> contacts(source().contacts.size());
  for (std::size_t contact = 0; contact < contacts.size(); ++contact) {
    const auto& parts = source().contacts[contact].parts;
    contacts[contact] = contact_energy(contact, std::size_t(assignment[source().group_of[parts[0]]]),
                                       std::size_t(assignment[source().group_of[parts[1]]]));
  }
  return terms(assignment, contacts);
}

Energy_terms Matching_problem::terms(const Assignment& assignment, const std::vector<Rod_energy>& contacts) const
{
  const bool pooled = options_.norm == Energy_norm::POOLED;
  const auto unmatched = [&](std::size_t group) {
    return assignment[group] != unassigned && is_unmatched(group, std::size_t(assignment[group]));
  };
  Energy_terms terms;
  double kept = 0, rod_count = 0;
  for (std::size_t contact = 0; contact < contacts.size(); ++contact) {
    const auto& parts = source().contacts[contact].parts;
    if (unmatched(source().group_of[parts[0]]) || unmatched(source().group_of[parts[1]]))
      terms.unmatched += options_.unmatched_cost;
    const Rod_energy& energy = contacts[contact];
    terms.distortion += energy.distortion;
    terms.connectedness += energy.connectedness;
    const double rods = double(source().parts[parts[0]].samples.cols() * source().parts[parts[1]].samples.cols());
    rod_count += rods;
    kept += rods * (1 - energy.distortion) * (1 - energy.distortion);
  }
  if (pooled && rod_count > 0) {
    terms.distortion = distortion_energy(kept / rod_count);
    terms.connectedness /= double(contacts.size());
  }
  std::vector<double> solidity_ratios(labels_.size(), 1);
  for (std::size_t g = 0; g < labels_.size(); ++g) {
    if (assignment[g] == unassigned) continue;
    const std::size_t l = std::size_t(assignment[g]);
    solidity_ratios[g] = labels_[g][l].solidity_ratio;
    terms.distortion += cut_energies_[g][l].distortion;
    terms.connectedness += cut_energies_[g][l].connectedness;
    if (is_unmatched(g, l) && source().groups[g].contacts.empty()) terms.unmatched += options_.unmatched_cost;
  }
  terms.split = split_energy(solidity_ratios);
  return terms;
}

} // namespace CGAL::Shape_correspondence
