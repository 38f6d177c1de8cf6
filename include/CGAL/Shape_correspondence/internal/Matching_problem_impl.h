// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MATCHING_PROBLEM_IMPL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MATCHING_PROBLEM_IMPL_H

#include <CGAL/Shape_correspondence/Matching_problem.h>
#include <CGAL/Shape_correspondence/internal/Contact_table.h>
#include <CGAL/Shape_correspondence/internal/quantized.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

// Least and greatest coordinates of a group.
inline Eigen::Matrix<double, 6, 1> extremes(const Aligned_shape::Group& group)
{
  Eigen::Matrix<double, 6, 1> result;
  result << group.box.min(), group.box.max();
  return result;
}

// Which of `count` segments of a curve a sample of it is on.
inline int segment_of_sample(std::size_t sample, int count)
{
  return std::min(count - 1, int(sample) * count / (samples_per_side - 1));
}

} // namespace internal

CGAL_SHAPE_CORRESPONDENCE_INLINE Matching_problem::Matching_problem(Shared_shape source, Shared_shape target,
                                                                    const Matching_options& options)
    : source_(std::move(source)),
      target_(std::move(target)),
      options_(options),
      source_pieces_(*source_),
      target_pieces_(*target_)
{
  choose_labels();
  make_tables();
}

CGAL_SHAPE_CORRESPONDENCE_INLINE Matching_problem::Matching_problem(Aligned_shape source, Aligned_shape target,
                                                                    const Matching_options& options)
    : Matching_problem(std::make_shared<Aligned_shape>(std::move(source)),
                       std::make_shared<Aligned_shape>(std::move(target)), options)
{}

CGAL_SHAPE_CORRESPONDENCE_INLINE Matching_problem::Matching_problem(Shared_shape source, Shared_shape target,
                                                                    std::vector<std::vector<Group_label>> labels,
                                                                    const Matching_options& options)
    : source_(std::move(source)),
      target_(std::move(target)),
      options_(options),
      labels_(std::move(labels)),
      source_pieces_(*source_),
      target_pieces_(*target_)
{
  make_tables();
}

CGAL_SHAPE_CORRESPONDENCE_INLINE void Matching_problem::make_tables()
{
  fit_parts();
  measure_target_pieces();
  fill_contact_energies();
  fill_cut_energies();
  add_up_energy();
}

CGAL_SHAPE_CORRESPONDENCE_INLINE void Matching_problem::choose_labels()
{
  has_shortlists_ = target().groups.size() > maximum_labels;
  labels_.resize(source().groups.size());
  std::vector<std::pair<long, std::size_t>> candidates;
  for (std::size_t g = 0; g < labels_.size(); ++g) {
    candidates.clear();
    for (std::size_t h = 0; h < target().groups.size(); ++h)
      candidates.emplace_back(
          internal::quantized((internal::extremes(source().groups[g]) - internal::extremes(target().groups[h])).norm()),
          h);
    if (has_shortlists_) {
      std::sort(candidates.begin(), candidates.end());
      candidates.resize(maximum_labels);
      std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    }
    labels_[g].reserve(2 * candidates.size() + 1);
    for (const auto& candidate : candidates)
      labels_[g].push_back(match_members(source(), g, target(), candidate.second));
    for (std::size_t l = 0; options_.cut_curves && l < candidates.size(); ++l) {
      if (labels_[g][l].operation == Operation::MATCH) continue; // one to one
      Group_label cut = cut_members(source(), g, target(), labels_[g][l]);
      if (cut.operation == Operation::CUT || cut.operation == Operation::JOIN) labels_[g].push_back(std::move(cut));
    }
    if (options_.unmatched_cost < Matching_options::never) {
      Group_label none;
      none.images.resize(source().groups[g].parts.size());
      labels_[g].push_back(std::move(none));
    }
  }
}

// The index of a fitted piece among those of its part, the last part that has any.
CGAL_SHAPE_CORRESPONDENCE_INLINE std::size_t Matching_problem::fit(const Image& image)
{
  const std::size_t from = source_pieces_.index(image.source), to = target_pieces_.index(image.target);
  for (std::size_t known = fitted_begin_.back(); known < fitted_.size(); ++known)
    if (fitted_[known].source_index == from && fitted_[known].target_index == to) return known;

  const Points& samples = target_pieces_[to].samples;
  const std::vector<int>& order = fitting_order(source_pieces_[from], target_pieces_[to]);
  if (lanes_of_.size() <= to) lanes_of_.resize(target_pieces_.size());
  std::size_t lanes = lanes_.size();
  for (const auto& known : lanes_of_[to])
    if (known.first == &order) lanes = known.second;
  if (lanes == lanes_.size()) {
    lanes_of_[to].emplace_back(&order, lanes);
    lanes_.push_back(internal::Sample_lanes(samples, order));
  }
  const bool lifted = Eigen::Index(order.size()) != source_pieces_[from].samples.cols();
  fitted_.push_back({image.source, image.target, from, to, &order, lifted, lanes});
  return fitted_.size() - 1;
}

CGAL_SHAPE_CORRESPONDENCE_INLINE void Matching_problem::fit_parts()
{
  for (std::size_t part = 0; part < source().parts.size(); ++part) {
    const std::size_t group = source().group_of[part];
    const auto& parts = source().groups[group].parts;
    const std::size_t member = std::size_t(std::find(parts.begin(), parts.end(), part) - parts.begin());
    fitted_begin_.push_back(fitted_.size());
    label_begin_.push_back(image_begin_.size());
    for (const Group_label& label : labels_[group]) {
      image_begin_.push_back(images_.size());
      for (const Image& image : label.images[member])
        images_.push_back(std::uint32_t(fit(image)));
    }
  }
  fitted_begin_.push_back(fitted_.size());
  image_begin_.push_back(images_.size());
}

CGAL_SHAPE_CORRESPONDENCE_INLINE Matching_problem::Images Matching_problem::images(std::size_t part,
                                                                                   std::size_t label) const
{
  const std::size_t i = label_begin_[part] + label;
  return {images_.data() + image_begin_[i], images_.data() + image_begin_[i + 1]};
}

CGAL_SHAPE_CORRESPONDENCE_INLINE Matching_problem::Images Matching_problem::touching(std::size_t contact, int side,
                                                                                     std::size_t label) const
{
  const Aligned_shape::Contact& c = source().contacts[contact];
  const Images clones = images(c.parts[std::size_t(side)], label);
  for (const std::uint32_t& image : clones) {
    const Piece& piece = fitted_[image].source;
    if (piece.count > 1 && piece.index == internal::segment_of_sample(c.samples[std::size_t(side)], piece.count))
      return {&image, &image + 1};
  }
  return clones;
}

// Those of whole parts are known.
CGAL_SHAPE_CORRESPONDENCE_INLINE void Matching_problem::measure_target_pieces()
{
  const Eigen::Index parts = Eigen::Index(target_pieces_.number_of_parts()), n = Eigen::Index(target_pieces_.size());
  target_distances_ = target().distance;
  if (n == parts) return;
  target_distances_.conservativeResize(n, n);
  std::vector<internal::Sample_lanes> lanes;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Points& samples = target_pieces_[std::size_t(i)].samples;
    lanes.emplace_back(samples);
    for (Eigen::Index j = 0; i >= parts && j <= i; ++j)
      target_distances_(i, j) = target_distances_(j, i) = least_distance(
          lanes.back(), int(samples.cols()), lanes[std::size_t(j)], int(target_pieces_[std::size_t(j)].samples.cols()));
  }
}

CGAL_SHAPE_CORRESPONDENCE_INLINE double Matching_problem::connectedness(const Structural_rods& rods,
                                                                        const Fitted& first, const Fitted& second) const
{
  if (first.target_index == second.target_index) return collapsed_connectedness;
  return rods.connectedness(target_distances_(Eigen::Index(first.target_index), Eigen::Index(second.target_index)));
}

CGAL_SHAPE_CORRESPONDENCE_INLINE void Matching_problem::fill_contact_energies()
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
CGAL_SHAPE_CORRESPONDENCE_INLINE void Matching_problem::fill_cut_energies()
{
  cut_energies_.resize(labels_.size());
  for (std::size_t g = 0; g < labels_.size(); ++g) {
    cut_energies_[g].resize(labels_[g].size());
    for (std::size_t l = 0; l < labels_[g].size(); ++l) {
      if (labels_[g][l].operation != Operation::CUT) continue;
      for (std::size_t part : source().groups[g].parts)
        for (std::size_t a : images(part, l))
          for (std::size_t b : images(part, l)) {
            const Fitted &first = fitted_[a], &second = fitted_[b];
            if (first.source.count < 2 || second.source.index != first.source.index + 1) continue;
            const Structural_rods rods(source_pieces_[first.source_index].samples,
                                       source_pieces_[second.source_index].samples);
            cut_energies_[g][l].distortion += rods.energy(samples(first), samples(second)).distortion;
            cut_energies_[g][l].connectedness += connectedness(rods, first, second);
          }
    }
  }
}

CGAL_SHAPE_CORRESPONDENCE_INLINE void Matching_problem::add_up_energy()
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

CGAL_SHAPE_CORRESPONDENCE_INLINE Energy_terms Matching_problem::terms(const Assignment& assignment) const
{
  std::vector<Rod_energy> contacts(source().contacts.size());
  for (std::size_t contact = 0; contact < contacts.size(); ++contact) {
    const auto& parts = source().contacts[contact].parts;
    contacts[contact] = contact_energy(contact, std::size_t(assignment[source().group_of[parts[0]]]),
                                       std::size_t(assignment[source().group_of[parts[1]]]));
  }
  return terms(assignment, contacts);
}

CGAL_SHAPE_CORRESPONDENCE_INLINE Energy_terms Matching_problem::terms(const Assignment& assignment,
                                                                      const std::vector<Rod_energy>& contacts) const
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
    terms.distortion = 1 - std::sqrt(kept / rod_count);
    terms.connectedness /= double(contacts.size());
  }
  double ratios = 0;
  for (std::size_t g = 0; g < labels_.size(); ++g) {
    if (assignment[g] == unassigned) {
      ratios += 1;
      continue;
    }
    const std::size_t l = std::size_t(assignment[g]);
    ratios += labels_[g][l].solidity_ratio * labels_[g][l].solidity_ratio;
    terms.distortion += cut_energies_[g][l].distortion;
    terms.connectedness += cut_energies_[g][l].connectedness;
    if (is_unmatched(g, l) && source().groups[g].contacts.empty()) terms.unmatched += options_.unmatched_cost;
  }
  terms.split = 1 - std::sqrt(ratios / double(labels_.size()));
  return terms;
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MATCHING_PROBLEM_IMPL_H
