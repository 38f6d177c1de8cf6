// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Matching_problem.h"
#include "base/quantized.h"
#include "energy/cut_parts.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

// The Euclidean distance of two boxes as vectors of the coordinates of their six sides.
double distance(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b)
{
  Eigen::Matrix<double, 6, 1> difference;
  difference << a.min() - b.min(), a.max() - b.max();
  return difference.norm();
}

// The target groups that a source group may be matched to, ascending: the allowed ones whose symmetry permits it (all
// allowed ones if none does), and of these at most the nearest `maximum_labels`. \param allowed ascending; empty: all
std::vector<std::size_t> candidates(const Aligned_shape& source, std::size_t group, const Aligned_shape& target,
                                    std::vector<std::size_t> allowed)
{
  if (allowed.empty()) {
    allowed.resize(target.number_of_groups());
    std::iota(allowed.begin(), allowed.end(), std::size_t(0));
  }
  const auto may = [&](std::size_t h) { return may_match(source.group(group), target.group(h)); };
  const bool none_may = std::none_of(allowed.begin(), allowed.end(), may);
  std::vector<std::pair<internal::Steps, std::size_t>> nearest;
  for (std::size_t h : allowed)
    if (none_may || may(h)) nearest.emplace_back(quantized(distance(source.boxes[group], target.boxes[h])), h);
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
                                         const std::vector<std::size_t>& allowed, const Energy_options& options,
                                         const Match_constraints& constraints, const Deadline& deadline)
{
  const std::size_t first_part = source.group(group).parts[0];
  const bool is_pinned = !constraints.empty() && !constraints.pinned(first_part).empty();
  std::vector<Group_label> result;
  if (is_pinned)
    result.push_back(pinned_label(source, group, target, constraints));
  else {
    const std::vector<std::size_t> matched = candidates(source, group, target, allowed);
    result.reserve(2 * matched.size() + 1);
    for (std::size_t candidate : matched) {
      deadline.check();
      Group_label label = match_groups(source, group, target, candidate, constraints);
      if (is_allowed(label, constraints)) result.push_back(std::move(label));
    }
  }
  const std::size_t uncut = result.size();
  for (std::size_t l = 0; options.cut_curves && l < uncut; ++l) {
    deadline.check();
    if (result[l].operation == Operation::MATCH) continue; // nothing is cut in a one-to-one match
    Group_label cut = cut_curves(source, group, target, result[l]);
    if (cut.operation == Operation::CUT || cut.operation == Operation::JOIN) result.push_back(std::move(cut));
  }
  if (options.unmatched_cost < Energy_options::never && !is_pinned) {
    result.emplace_back();
    result.back().images.resize(source.group(group).parts.size());
  }
  if (result.empty())
    throw Invalid_input("find_correspondence: pinned and forbidden pairs leave nothing that part number " +
                        std::to_string(source.original[first_part]) +
                        " and the parts symmetric to it could become; take one back, or let parts stay unmatched");
  return result;
}

// Returns the labels if there is memory for the tables of the contacts' energies. \throw Too_large otherwise
std::vector<std::vector<Group_label>> small_enough(const Aligned_shape& source,
                                                   std::vector<std::vector<Group_label>> labels)
{
  double pairs = 0;
  for (const Aligned_shape::Contact& contact : source.contacts)
    pairs +=
        double(labels[source.group_of[contact.parts[0]]].size() * labels[source.group_of[contact.parts[1]]].size());
  check_bytes_of_tables((sizeof(Rod_energy) + 2 * sizeof(double)) * pairs);
  return labels;
}

std::vector<std::vector<Group_label>> all_labels(const Aligned_shape& source, const Aligned_shape& target,
                                                 const Energy_options& options, const Group_candidates& allowed,
                                                 const Deadline& deadline)
{
  const Match_constraints constraints(source, target, options);
  std::vector<std::vector<Group_label>> result;
  for (std::size_t g = 0; g < source.number_of_groups(); ++g)
    result.push_back(labels_of_group(source, g, target, allowed.empty() ? std::vector<std::size_t>() : allowed[g],
                                     options, constraints, deadline));
  return result;
}

} // namespace

Matching_problem::Matching_problem(const Shared_shape& source, const Shared_shape& target,
                                   const Energy_options& options, const Group_candidates& allowed,
                                   const Deadline& deadline)
    : Matching_problem(source, target, all_labels(*source, *target, options, allowed, deadline), options, deadline)
{
  has_shortlists_ = !allowed.empty() || target_->number_of_groups() > maximum_labels;
}

Matching_problem::Matching_problem(Aligned_shape source, Aligned_shape target, const Energy_options& options)
    : Matching_problem(std::make_shared<Deformable_shape>(std::move(source)),
                       std::make_shared<Deformable_shape>(std::move(target)), options)
{}

Matching_problem::Matching_problem(Shared_shape source, Shared_shape target,
                                   std::vector<std::vector<Group_label>> labels, const Energy_options& options,
                                   const Deadline& deadline)
    : source_(std::move(source)),
      target_(std::move(target)),
      options_(options),
      labels_(small_enough(*source_, std::move(labels))),
      fitted_(*source_, *target_, labels_, options.fit, deadline)
{
  fill_contact_energies(deadline);
  fill_group_terms();
  add_role_costs();
  add_up_energy();
}

void Matching_problem::fill_group_terms()
{
  for (std::size_t g = 0; g < labels_.size(); ++g) {
    group_terms_.emplace_back(labels_[g].size());
    for (std::size_t l = 0; l < labels_[g].size(); ++l) {
      if (labels_[g][l].operation == Operation::CUT) add_cut_energy(g, l);
      if (is_unmatched(g, l) && is_isolated(source(), g)) group_terms_[g][l].unmatched = options_.unmatched_cost;
    }
  }
}

// Adds E_d and E_c between neighbouring segments of cut parts, which count as connected.
void Matching_problem::add_cut_energy(std::size_t group, std::size_t label)
{
  Energy_terms& terms = group_terms_[group][label];
  for (std::size_t part : source().group(group).parts)
    for (std::size_t a : fitted_.images(part, label))
      for (std::size_t b : fitted_.images(part, label)) {
        const Fitted_piece &first = fitted_[a], &second = fitted_[b];
        if (!first.source.is_segment() || second.source.index != first.source.index + 1) continue;
        const Rod_energy energy = rod_energy(fitted_.source_piece(first.source_index).samples,
                                             fitted_.source_piece(second.source_index).samples, fitted_.points(first),
                                             fitted_.points(second));
        terms.distortion += energy.distortion;
        terms.connectedness += overlap(first.target, second.target) ? collapsed_connectedness : energy.connectedness;
      }
}

void Matching_problem::add_role_costs()
{
  if (!(options_.weights.roles > 0) || options_.role_costs.size() == 0) return;
  // The weight of each part's role costs: half the number of its contacts
  std::vector<double> weight(source().parts.size(), 0);
  for (const Aligned_shape::Contact& contact : source().contacts)
    for (std::size_t part : contact.parts)
      weight[part] += 0.5;
  const double unit = pools_rods() ? 1 / double(std::max<std::size_t>(1, source().contacts.size())) : 1;
  for (std::size_t g = 0; g < labels_.size(); ++g)
    for (std::size_t l = 0; l < labels_[g].size(); ++l)
      for (const std::vector<Piece_image>& images : labels_[g][l].images) {
        double sum = 0;
        for (const Piece_image& image : images)
          sum += options_.role_costs(Eigen::Index(source().original[image.source.part]),
                                     Eigen::Index(target().original[image.target.part]));
        if (images.empty()) continue;
        const double of_part = weight[images[0].source.part];
        group_terms_[g][l].roles += unit * (of_part > 0 ? of_part : 1) * sum / double(images.size());
      }
}

// The number of rods between the samples of the two whole parts.
double Matching_problem::number_of_rods(std::size_t contact) const
{
  const auto& parts = source().contacts[contact].parts;
  return double(source().parts[parts[0]].samples.cols() * source().parts[parts[1]].samples.cols());
}

// The sum of the squared cosines of a contact's rods, recovered from its E_d, for the pooled norm.
double Matching_problem::kept_rods(std::size_t contact, const Rod_energy& energy) const
{
  return number_of_rods(contact) * (1 - energy.distortion) * (1 - energy.distortion);
}

// E as a sum over labels of groups and pairs of groups. The root terms are w_s E_s (Eq. 5) and a pooled E_d (Eq. 3).
void Matching_problem::add_up_energy()
{
  const Energy_weights& weights = options_.weights;
  const std::size_t n = labels_.size();
  Pairwise_energy::Root_term split{weights.split, double(n), {}, {}}, rods{weights.distortion, 0, {}, {}};
  for (std::size_t g = 0; g < n; ++g) {
    const Eigen::Index count = Eigen::Index(labels_[g].size());
    energy_.unary.push_back(Eigen::VectorXd::Zero(count));
    if (pools_rods()) rods.unary.push_back(Eigen::VectorXd::Zero(count));
    split.unary.push_back(Eigen::VectorXd::Zero(count));
    for (Eigen::Index l = 0; l < count; ++l) {
      const double ratio = labels_[g][std::size_t(l)].solidity_ratio;
      split.unary[g][l] = ratio * ratio;
      energy_.unary[g][l] = deformation_energy(group_terms(g, std::size_t(l)), weights);
    }
  }

  const double contact_count = double(std::max<std::size_t>(1, source().contacts.size()));
  // Adds the energy of a contact with labels a and b of its groups to `cost`, and its sum of squared cosines to `kept`,
  // which is null unless rods are pooled
  const auto add = [&](std::size_t contact, std::size_t a, std::size_t b, double& cost, double* kept) {
    const Rod_energy energy = contact_energy(contact, a, b);
    const auto [first, second] = groups_of_contact(contact);
    Energy_terms terms;
    if (is_unmatched(first, a) || is_unmatched(second, b)) terms.unmatched = options_.unmatched_cost;
    if (pools_rods()) {
      *kept += kept_rods(contact, energy);
      terms.connectedness = energy.connectedness / contact_count;
    } else {
      terms.distortion = energy.distortion;
      terms.connectedness = energy.connectedness;
    }
    cost += deformation_energy(terms, weights);
  };
  for (std::size_t contact = 0; contact < source().contacts.size(); ++contact) {
    rods.count += number_of_rods(contact);
    const auto [g, other] = groups_of_contact(contact);
    if (g != other) continue; // handled as an edge of the graph
    for (std::size_t a = 0; a < labels_[g].size(); ++a)
      add(contact, a, a, energy_.unary[g][Eigen::Index(a)], pools_rods() ? &rods.unary[g][Eigen::Index(a)] : nullptr);
  }
  const Aligned_shape::Graph& graph = source().graph;
  for (const auto& edge : boost::make_iterator_range(edges(graph))) {
    const auto [low, high] = std::minmax({boost::source(edge, graph), boost::target(edge, graph)});
    Eigen::MatrixXd cost = Eigen::MatrixXd::Zero(Eigen::Index(labels_[low].size()), Eigen::Index(labels_[high].size()));
    Eigen::MatrixXd kept;
    if (pools_rods()) kept = cost;
    for (std::size_t contact : graph[edge].contacts) {
      const bool forward = groups_of_contact(contact)[0] == low;
      for (Eigen::Index a = 0; a < cost.rows(); ++a)
        for (Eigen::Index b = 0; b < cost.cols(); ++b)
          add(contact, std::size_t(forward ? a : b), std::size_t(forward ? b : a), cost(a, b),
              pools_rods() ? &kept(a, b) : nullptr);
    }
    energy_.edges.push_back({low, high, std::move(cost)});
    if (pools_rods()) rods.edge.push_back(std::move(kept));
  }
  if (weights.split > 0) energy_.root_terms.push_back(std::move(split));
  if (pools_rods() && weights.distortion > 0 && rods.count > 0) energy_.root_terms.push_back(std::move(rods));
}

Energy_terms Matching_problem::terms(const Assignment& assignment) const
{
  std::vector<Rod_energy> contacts;
  for (std::size_t contact = 0; contact < source().contacts.size(); ++contact)
    contacts.push_back(contact_energy(contact, assignment));
  return terms(assignment, contacts);
}

Energy_terms Matching_problem::terms(const Assignment& assignment, const std::vector<Rod_energy>& contacts) const
{
  std::vector<char> unmatched(labels_.size());
  for (std::size_t g = 0; g < labels_.size(); ++g)
    unmatched[g] = assignment[g] != unassigned && is_unmatched(g, std::size_t(assignment[g]));
  Energy_terms terms;
  double kept = 0, rod_count = 0;
  for (std::size_t contact = 0; contact < contacts.size(); ++contact) {
    const auto [first, second] = groups_of_contact(contact);
    if (unmatched[first] || unmatched[second]) terms.unmatched += options_.unmatched_cost;
    terms.distortion += contacts[contact].distortion;
    terms.connectedness += contacts[contact].connectedness;
    if (!pools_rods()) continue;
    rod_count += number_of_rods(contact);
    kept += kept_rods(contact, contacts[contact]);
  }
  if (rod_count > 0) {
    terms.distortion = distortion_energy(kept / rod_count);
    terms.connectedness /= double(contacts.size());
  }
  std::vector<double> solidity_ratios(labels_.size(), 1);
  for (std::size_t g = 0; g < labels_.size(); ++g) {
    if (assignment[g] == unassigned) continue;
    const std::size_t l = std::size_t(assignment[g]);
    const Energy_terms& of_group = group_terms(g, l);
    solidity_ratios[g] = labels_[g][l].solidity_ratio;
    terms.distortion += of_group.distortion;
    terms.connectedness += of_group.connectedness;
    terms.roles += of_group.roles;
    terms.unmatched += of_group.unmatched;
  }
  terms.split = split_energy(solidity_ratios);
  return terms;
}

} // namespace CGAL::Shape_correspondence
