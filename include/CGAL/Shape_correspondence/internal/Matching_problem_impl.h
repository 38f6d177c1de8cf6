// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MATCHING_PROBLEM_IMPL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MATCHING_PROBLEM_IMPL_H

#include <CGAL/Shape_correspondence/Matching_problem.h>
#include <CGAL/Shape_correspondence/internal/quantized.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

// Least and greatest coordinates of every group.
inline Eigen::Matrix<double, 6, Eigen::Dynamic> group_boxes(const Aligned_shape& shape)
{
  Eigen::Matrix<double, 6, Eigen::Dynamic> boxes(6, shape.groups.size());
  for (std::size_t g = 0; g < shape.groups.size(); ++g) {
    Eigen::AlignedBox3d box;
    for (std::size_t part : shape.groups[g].parts) {
      box.extend(Point(shape.parts[part].samples.rowwise().minCoeff()));
      box.extend(Point(shape.parts[part].samples.rowwise().maxCoeff()));
    }
    boxes.col(Eigen::Index(g)) << box.min(), box.max();
  }
  return boxes;
}

} // namespace internal

CGAL_SHAPE_CORRESPONDENCE_INLINE Matching_problem::Matching_problem(Aligned_shape source, Aligned_shape target,
                                                                    const Energy_weights& weights, int maximum_parts)
    : source_(std::move(source)), target_(std::move(target)), weights_(weights)
{
  choose_groups(maximum_parts);
  choose_labels();
  fit_parts();
  rods_.resize(source_.contacts.size());
  contact_energies_.resize(source_.contacts.size());
  for (std::size_t contact : active_contacts_)
    fill_contact_energies(contact);
  add_up_tables();
}

CGAL_SHAPE_CORRESPONDENCE_INLINE void Matching_problem::choose_groups(int maximum_parts)
{
  const auto prominence = [&](std::size_t group) {
    double most = 0;
    for (std::size_t part : source_.groups[group].parts)
      most = std::max(most, source_.prominence[part]);
    return most;
  };
  std::vector<std::size_t> order(source_.groups.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  if (maximum_parts > 0) {
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return prominence(a) > prominence(b); });
    std::size_t kept = 0, parts = 0;
    while (kept < order.size() &&
           (kept == 0 || parts + source_.groups[order[kept]].parts.size() <= std::size_t(maximum_parts)))
      parts += source_.groups[order[kept++]].parts.size();
    order.resize(kept);
    std::sort(order.begin(), order.end());
  }
  active_groups_ = order;

  std::vector<char> active(source_.groups.size(), 0);
  for (std::size_t group : active_groups_)
    active[group] = 1;
  for (std::size_t c = 0; c < source_.contacts.size(); ++c) {
    const auto& parts = source_.contacts[c].parts;
    if (active[source_.group_of[parts[0]]] && active[source_.group_of[parts[1]]]) active_contacts_.push_back(c);
  }
}

CGAL_SHAPE_CORRESPONDENCE_INLINE void Matching_problem::choose_labels()
{
  const Eigen::Matrix<double, 6, Eigen::Dynamic> from = internal::group_boxes(source_),
                                                 to = internal::group_boxes(target_);
  labels_.resize(source_.groups.size());
  for (std::size_t g : active_groups_) {
    std::vector<std::pair<long, std::size_t>> candidates;
    for (std::size_t h = 0; h < target_.groups.size(); ++h)
      candidates.emplace_back(internal::quantized((from.col(g) - to.col(h)).norm()), h);
    if (has_shortlists()) {
      std::sort(candidates.begin(), candidates.end());
      candidates.resize(maximum_labels);
      std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    }
    for (const auto& candidate : candidates)
      labels_[g].push_back(match_members(source_, g, target_, candidate.second));
  }
}

CGAL_SHAPE_CORRESPONDENCE_INLINE void Matching_problem::fit_parts()
{
  const std::size_t n = source_.parts.size(), m = target_.parts.size();
  deformed_.resize(n * m);
  for (std::size_t p = 0; p < n; ++p)
    for (std::size_t q = 0; q < m; ++q)
      deformed_[p * m + q] = deform_to_fit(source_.parts[p], target_.parts[q]);

  target_distance_.resize(m, m);
  for (std::size_t q = 0; q < m; ++q)
    for (std::size_t s = 0; s <= q; ++s) {
      double least = std::numeric_limits<double>::infinity();
      const Points& b = target_.parts[s].samples;
      for (Eigen::Index i = 0; i < target_.parts[q].samples.cols(); ++i)
        least = std::min(least, (b.colwise() - target_.parts[q].samples.col(i)).colwise().squaredNorm().minCoeff());
      target_distance_(q, s) = target_distance_(s, q) = std::sqrt(least);
    }
}

// Curves have two sets of samples: their own, and those lifted to a sheet's number. The rods of a contact are kept for
// every combination, at 2 * (first is lifted) + (second is lifted); a sheet is never lifted.
CGAL_SHAPE_CORRESPONDENCE_INLINE const Structural_rods&
Matching_problem::rods(std::size_t contact, Eigen::Index first_samples, Eigen::Index second_samples) const
{
  const auto& parts = source_.contacts[contact].parts;
  const bool lift_first = first_samples != source_.parts[parts[0]].samples.cols();
  const bool lift_second = second_samples != source_.parts[parts[1]].samples.cols();
  return rods_[contact][2 * lift_first + lift_second];
}

CGAL_SHAPE_CORRESPONDENCE_INLINE Rod_energy Matching_problem::clone_energy(std::size_t contact, std::size_t first_image,
                                                                           std::size_t second_image) const
{
  const auto& parts = source_.contacts[contact].parts;
  const Points &first = deformed(parts[0], first_image), &second = deformed(parts[1], second_image);
  Rod_energy result = rods(contact, first.cols(), second.cols()).energy(first, second);
  if (first_image == second_image) result.connectedness = collapsed_connectedness;
  return result;
}

CGAL_SHAPE_CORRESPONDENCE_INLINE std::vector<std::pair<std::size_t, std::size_t>>
Matching_problem::clone_pairs(const std::vector<std::size_t>& first, const std::vector<std::size_t>& second) const
{
  const auto nearest = [&](std::size_t image, const std::vector<std::size_t>& others) {
    return *std::min_element(others.begin(), others.end(), [&](std::size_t a, std::size_t b) {
      return target_distance_(image, a) < target_distance_(image, b);
    });
  };
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t a : first)
    pairs.emplace_back(a, nearest(a, second));
  for (std::size_t b : second)
    pairs.emplace_back(nearest(b, first), b);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

CGAL_SHAPE_CORRESPONDENCE_INLINE void Matching_problem::fill_contact_energies(std::size_t contact)
{
  const auto& parts = source_.contacts[contact].parts;
  const Sampled_part &first = source_.parts[parts[0]], &second = source_.parts[parts[1]];
  constexpr Eigen::Index lifted = samples_per_side * samples_per_side;
  for (Eigen::Index n : {first.samples.cols(), lifted})
    for (Eigen::Index m : {second.samples.cols(), lifted})
      rods_[contact].emplace_back(lifted_samples(first, n), lifted_samples(second, m));

  const std::size_t parts_count = target_.parts.size(), labels = number_of_labels();
  std::vector<Rod_energy> clone_energies(parts_count * parts_count);
  std::vector<char> known(clone_energies.size(), 0);
  const auto image_energy = [&](std::size_t a, std::size_t b) {
    const std::size_t i = a * parts_count + b;
    if (!known[i]) clone_energies[i] = clone_energy(contact, a, b), known[i] = 1;
    return clone_energies[i];
  };

  const std::size_t g = source_.group_of[parts[0]], h = source_.group_of[parts[1]];
  const auto member = [&](std::size_t group, std::size_t part) {
    const auto& members = source_.groups[group].parts;
    return std::size_t(std::find(members.begin(), members.end(), part) - members.begin());
  };
  const std::size_t i = member(g, parts[0]), j = member(h, parts[1]);
  contact_energies_[contact].resize(labels * labels);
  for (std::size_t a = 0; a < labels; ++a)
    for (std::size_t b = 0; b < labels; ++b) {
      if (g == h && a != b) continue;
      const auto pairs = clone_pairs(labels_[g][a].images[i], labels_[h][b].images[j]);
      Rod_energy& mean = contact_energies_[contact][a * labels + b];
      for (const auto& pair : pairs) {
        const Rod_energy energy = image_energy(pair.first, pair.second);
        mean.distortion += energy.distortion / double(pairs.size());
        mean.connectedness += energy.connectedness / double(pairs.size());
      }
    }
}

CGAL_SHAPE_CORRESPONDENCE_INLINE void Matching_problem::add_up_tables()
{
  const std::size_t labels = number_of_labels();
  unary_.assign(source_.groups.size(), Eigen::VectorXd::Zero(labels));
  for (std::size_t contact : active_contacts_) {
    std::size_t g = source_.group_of[source_.contacts[contact].parts[0]];
    std::size_t h = source_.group_of[source_.contacts[contact].parts[1]];
    const auto cost = [&](std::size_t a, std::size_t b) {
      const Rod_energy energy = contact_energy(contact, a, b);
      return energy.distortion + weights_.connectedness * energy.connectedness;
    };
    if (g == h) {
      for (std::size_t a = 0; a < labels; ++a)
        unary_[g][a] += cost(a, a);
      continue;
    }
    const std::size_t low = std::min(g, h), high = std::max(g, h);
    auto edge =
        std::find_if(edges_.begin(), edges_.end(), [&](const Edge& e) { return e.first == low && e.second == high; });
    if (edge == edges_.end()) {
      edges_.push_back({low, high, {}, Eigen::MatrixXd::Zero(labels, labels)});
      edge = edges_.end() - 1;
    }
    edge->contacts.push_back(contact);
    for (std::size_t a = 0; a < labels; ++a)
      for (std::size_t b = 0; b < labels; ++b)
        edge->cost(a, b) += g == low ? cost(a, b) : cost(b, a);
  }
}

CGAL_SHAPE_CORRESPONDENCE_INLINE Energy_terms Matching_problem::terms(const Assignment& assignment) const
{
  Energy_terms terms;
  for (std::size_t contact : active_contacts_) {
    const auto& parts = source_.contacts[contact].parts;
    const Rod_energy energy = contact_energy(contact, std::size_t(assignment[source_.group_of[parts[0]]]),
                                             std::size_t(assignment[source_.group_of[parts[1]]]));
    terms.distortion += energy.distortion;
    terms.connectedness += energy.connectedness;
  }
  std::vector<double> ratios;
  for (std::size_t group : active_groups_)
    ratios.push_back(label(group, std::size_t(assignment[group])).solidity_ratio);
  terms.split = split_energy(ratios);
  return terms;
}

CGAL_SHAPE_CORRESPONDENCE_INLINE double Matching_problem::lower_bound() const
{
  Energy_terms split_only;
  std::vector<double> ratios;
  double bound = 0;
  for (std::size_t group : active_groups_) {
    double best = 0;
    for (const Group_label& label : labels_[group])
      best = std::max(best, label.solidity_ratio);
    ratios.push_back(best);
    bound += unary_[group].minCoeff();
  }
  for (const Edge& edge : edges_)
    bound += edge.cost.minCoeff();
  split_only.split = split_energy(ratios);
  return bound + weighted_sum(split_only, weights_);
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif
