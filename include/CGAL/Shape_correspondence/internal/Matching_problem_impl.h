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

// The index of a piece among the parts and the segments, which it joins if it is new.
inline std::size_t piece_index(const Piece& piece, std::size_t number_of_parts, std::vector<Piece>& segments,
                               std::vector<Sampled_part>& pieces)
{
  if (piece.count == 1) return piece.part;
  const auto found = std::find(segments.begin(), segments.end(), piece);
  if (found != segments.end()) return number_of_parts + std::size_t(found - segments.begin());
  segments.push_back(piece);
  pieces.push_back(segment(pieces[piece.part], piece.index, piece.count));
  return pieces.size() - 1;
}

// Which of `count` segments of a curve a sample of it is on.
inline int segment_of_sample(std::size_t sample, int count)
{
  return std::min(count - 1, int(sample) * count / (samples_per_side - 1));
}

} // namespace internal

// Buffers for the energies of a contact.
struct Matching_problem::Scratch
{
  Eigen::MatrixXi contact_of; // by pair of target pieces, the contact that `energy` was computed for
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic> distortion, connectedness;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
};

CGAL_SHAPE_CORRESPONDENCE_INLINE Matching_problem::Matching_problem(Aligned_shape source, Aligned_shape target,
                                                                    const Matching_options& options)
    : source_(std::move(source)),
      target_(std::move(target)),
      options_(options),
      source_pieces_(source_.parts),
      target_pieces_(target_.parts)
{
  choose_labels();
  make_tables();
}

CGAL_SHAPE_CORRESPONDENCE_INLINE Matching_problem::Matching_problem(Aligned_shape source, Aligned_shape target,
                                                                    std::vector<std::vector<Group_label>> labels,
                                                                    const Matching_options& options)
    : source_(std::move(source)),
      target_(std::move(target)),
      options_(options),
      labels_(std::move(labels)),
      source_pieces_(source_.parts),
      target_pieces_(target_.parts)
{
  make_tables();
}

CGAL_SHAPE_CORRESPONDENCE_INLINE void Matching_problem::make_tables()
{
  fit_parts();
  const Eigen::Index n = Eigen::Index(target_pieces_.size());
  Scratch scratch;
  scratch.contact_of = Eigen::MatrixXi::Constant(n, n, -1);
  scratch.distortion.resize(n, n);
  scratch.connectedness.resize(n, n);
  contact_energies_.resize(source_.contacts.size());
  for (std::size_t contact = 0; contact < source_.contacts.size(); ++contact)
    fill_contact_energies(contact, scratch);
  fill_cut_energies();
  add_up_energy();
}

CGAL_SHAPE_CORRESPONDENCE_INLINE void Matching_problem::choose_labels()
{
  const Eigen::Matrix<double, 6, Eigen::Dynamic> from = internal::group_boxes(source_),
                                                 to = internal::group_boxes(target_);
  has_shortlists_ = target_.groups.size() > maximum_labels;
  labels_.resize(source_.groups.size());
  std::vector<std::pair<long, std::size_t>> candidates;
  for (std::size_t g = 0; g < labels_.size(); ++g) {
    candidates.clear();
    for (std::size_t h = 0; h < target_.groups.size(); ++h)
      candidates.emplace_back(internal::quantized((from.col(Eigen::Index(g)) - to.col(Eigen::Index(h))).norm()), h);
    if (has_shortlists_) {
      std::sort(candidates.begin(), candidates.end());
      candidates.resize(maximum_labels);
      std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    }
    for (const auto& candidate : candidates)
      labels_[g].push_back(match_members(source_, g, target_, candidate.second));
    if (options_.cut_curves)
      for (std::size_t l = 0; l < candidates.size(); ++l) {
        Group_label cut = cut_members(source_, g, target_, labels_[g][l]);
        if (cut.operation == Operation::CUT || cut.operation == Operation::JOIN) labels_[g].push_back(std::move(cut));
      }
    if (options_.unmatched_cost < Matching_options::never) {
      Group_label none;
      none.images.resize(source_.groups[g].parts.size());
      labels_[g].push_back(std::move(none));
    }
  }
}

CGAL_SHAPE_CORRESPONDENCE_INLINE std::size_t Matching_problem::fit(const Image& image)
{
  const bool whole = image.source.count == 1 && image.target.count == 1;
  int* known = whole ? &fitted_index_(Eigen::Index(image.source.part), Eigen::Index(image.target.part)) : nullptr;
  if (whole && *known >= 0) return std::size_t(*known);
  if (whole) *known = int(fitted_.size());

  const std::size_t from = internal::piece_index(image.source, source_.parts.size(), source_segments_, source_pieces_);
  const std::size_t to = internal::piece_index(image.target, target_.parts.size(), target_segments_, target_pieces_);
  const Points& samples = target_pieces_[to].samples;
  fitted_.push_back({image.source, image.target, from, to, &fitting_order(source_pieces_[from], target_pieces_[to]),
                     internal::Sample_lanes()});
  const std::vector<int>& order = *fitted_.back().order;
  const int lift = int(order.size()) / int(samples.cols());
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < internal::lane_count; ++i)
      fitted_.back().samples.coordinates[axis][i] =
          i < int(order.size()) ? float(samples(axis, order[std::size_t(i)] / lift)) : internal::far_away;
  return fitted_.size() - 1;
}

CGAL_SHAPE_CORRESPONDENCE_INLINE void Matching_problem::fit_parts()
{
  fitted_index_ = Eigen::MatrixXi::Constant(Eigen::Index(source_.parts.size()), Eigen::Index(target_.parts.size()), -1);
  fitted_.reserve(source_.parts.size() * target_.parts.size());
  images_.resize(source_.parts.size());
  for (std::size_t g = 0; g < labels_.size(); ++g)
    for (const Group_label& label : labels_[g])
      for (std::size_t i = 0; i < label.images.size(); ++i) {
        auto& images = images_[source_.groups[g].parts[i]];
        images.emplace_back();
        for (const Image& image : label.images[i])
          images.back().push_back(fit(image));
      }

  touching_.resize(2 * source_.contacts.size());
  for (std::size_t contact = 0; contact < source_.contacts.size(); ++contact)
    for (std::size_t side : {0, 1})
      for (const auto& images : images_[source_.contacts[contact].parts[side]]) {
        auto& touching = touching_[2 * contact + side];
        touching.push_back(images);
        for (std::size_t image : images) {
          const Piece& piece = fitted_[image].source;
          if (piece.count > 1 &&
              piece.index == internal::segment_of_sample(source_.contacts[contact].samples[side], piece.count))
            touching.back() = {image};
        }
      }
}

CGAL_SHAPE_CORRESPONDENCE_INLINE double Matching_problem::target_distance(std::size_t first_piece,
                                                                          std::size_t second_piece) const
{
  const std::size_t n = target_.parts.size();
  if (first_piece < n && second_piece < n)
    return target_.distance(Eigen::Index(first_piece), Eigen::Index(second_piece));
  return least_distance(target_pieces_[first_piece].samples, target_pieces_[second_piece].samples);
}

// Each clone with its nearest counterpart.
CGAL_SHAPE_CORRESPONDENCE_INLINE const std::vector<std::pair<std::size_t, std::size_t>>&
Matching_problem::clone_pairs(const std::vector<std::size_t>& first, const std::vector<std::size_t>& second,
                              Scratch& scratch) const
{
  const auto nearest = [&](std::size_t image, const std::vector<std::size_t>& others) {
    return *std::min_element(others.begin(), others.end(), [&](std::size_t a, std::size_t b) {
      return target_distance(fitted_[image].target_index, fitted_[a].target_index) <
             target_distance(fitted_[image].target_index, fitted_[b].target_index);
    });
  };
  auto& pairs = scratch.pairs;
  pairs.clear();
  if (first.empty() || second.empty()) return pairs;
  for (std::size_t a : first)
    pairs.emplace_back(a, second.size() == 1 ? second[0] : nearest(a, second));
  if (second.size() == 1) return pairs;
  for (std::size_t b : second)
    pairs.emplace_back(nearest(b, first), b);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

CGAL_SHAPE_CORRESPONDENCE_INLINE Rod_energy Matching_problem::fitted_energy(const Structural_rods& rods,
                                                                            const Fitted& first,
                                                                            const Fitted& second) const
{
  const bool collapsed = first.target_index == second.target_index;
  return {rods.distortion(first.samples, second.samples),
          collapsed ? collapsed_connectedness
                    : rods.connectedness(target_distance(first.target_index, second.target_index))};
}

CGAL_SHAPE_CORRESPONDENCE_INLINE Rod_energy Matching_problem::pair_energy(std::size_t contact, const Fitted& first,
                                                                          const Fitted& second) const
{
  const Sampled_part &a = source_pieces_[first.source_index], &b = source_pieces_[second.source_index];
  const Eigen::Index n = Eigen::Index(first.order->size()), m = Eigen::Index(second.order->size());
  if (first.source.count == 1 && second.source.count == 1)
    return fitted_energy(rods(contact, n != a.samples.cols(), m != b.samples.cols()), first, second);
  return fitted_energy(Structural_rods(lifted_samples(a, n), lifted_samples(b, m)), first, second);
}

CGAL_SHAPE_CORRESPONDENCE_INLINE void Matching_problem::fill_contact_energies(std::size_t contact, Scratch& scratch)
{
  const auto image_energy = [&](std::size_t a, std::size_t b) {
    const Fitted &first = fitted_[a], &second = fitted_[b];
    if (first.source.count > 1 || second.source.count > 1) return pair_energy(contact, first, second);
    const Eigen::Index i = Eigen::Index(first.target_index), j = Eigen::Index(second.target_index);
    if (scratch.contact_of(i, j) != int(contact)) {
      scratch.contact_of(i, j) = int(contact);
      const Rod_energy energy = pair_energy(contact, first, second);
      scratch.distortion(i, j) = energy.distortion;
      scratch.connectedness(i, j) = energy.connectedness;
    }
    return Rod_energy{scratch.distortion(i, j), scratch.connectedness(i, j)};
  };

  const auto& parts = source_.contacts[contact].parts;
  const std::size_t g = source_.group_of[parts[0]], h = source_.group_of[parts[1]];
  const std::size_t first_labels = labels_[g].size(), second_labels = labels_[h].size();
  contact_energies_[contact].resize(first_labels * second_labels);
  for (std::size_t a = 0; a < first_labels; ++a)
    for (std::size_t b = 0; b < second_labels; ++b) {
      if ((g == h && a != b) || is_unmatched(g, a) || is_unmatched(h, b)) continue;
      const auto& pairs = clone_pairs(touching(contact, 0, a), touching(contact, 1, b), scratch);
      Rod_energy& mean = contact_energies_[contact][a * second_labels + b];
      for (const auto& pair : pairs) {
        const Rod_energy energy = image_energy(pair.first, pair.second);
        mean.distortion += energy.distortion / double(pairs.size());
        mean.connectedness += energy.connectedness / double(pairs.size());
      }
    }
}

// Segments next to each other were connected.
CGAL_SHAPE_CORRESPONDENCE_INLINE void Matching_problem::fill_cut_energies()
{
  cut_energies_.resize(labels_.size());
  for (std::size_t g = 0; g < labels_.size(); ++g) {
    cut_energies_[g].resize(labels_[g].size());
    for (std::size_t l = 0; l < labels_[g].size(); ++l) {
      if (labels_[g][l].operation != Operation::CUT) continue;
      for (std::size_t part : source_.groups[g].parts) {
        const auto& images = images_[part][l];
        for (std::size_t a : images)
          for (std::size_t b : images) {
            const Fitted &first = fitted_[a], &second = fitted_[b];
            if (first.source.count < 2 || second.source.index != first.source.index + 1) continue;
            const Structural_rods rods(source_pieces_[first.source_index].samples,
                                       source_pieces_[second.source_index].samples);
            const Rod_energy energy = fitted_energy(rods, first, second);
            cut_energies_[g][l].distortion += energy.distortion;
            cut_energies_[g][l].connectedness += energy.connectedness;
          }
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
      if (is_unmatched(g, std::size_t(l)) && source_.groups[g].contacts.empty())
        energy_.unary[g][l] = options_.unmatched_cost;
    }
  }

  Eigen::MatrixXi edge_of = Eigen::MatrixXi::Constant(Eigen::Index(n), Eigen::Index(n), -1);
  const double contact_count = double(std::max<std::size_t>(1, source_.contacts.size()));
  for (std::size_t contact = 0; contact < source_.contacts.size(); ++contact) {
    const auto& parts = source_.contacts[contact].parts;
    const double rod_count = double(source_.parts[parts[0]].samples.cols() * source_.parts[parts[1]].samples.cols());
    rods.count += rod_count;
    const std::size_t g = source_.group_of[parts[0]], h = source_.group_of[parts[1]];
    const auto add = [&](std::size_t a, std::size_t b, double& cost, double& kept) {
      const Rod_energy energy = contact_energy(contact, a, b);
      kept += rod_count * (1 - energy.distortion) * (1 - energy.distortion);
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
  std::vector<Rod_energy> contacts(source_.contacts.size());
  for (std::size_t contact = 0; contact < contacts.size(); ++contact) {
    const auto& parts = source_.contacts[contact].parts;
    contacts[contact] = contact_energy(contact, std::size_t(assignment[source_.group_of[parts[0]]]),
                                       std::size_t(assignment[source_.group_of[parts[1]]]));
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
    const auto& parts = source_.contacts[contact].parts;
    if (unmatched(source_.group_of[parts[0]]) || unmatched(source_.group_of[parts[1]]))
      terms.unmatched += options_.unmatched_cost;
    const Rod_energy& energy = contacts[contact];
    terms.distortion += energy.distortion;
    terms.connectedness += energy.connectedness;
    const double rods = double(source_.parts[parts[0]].samples.cols() * source_.parts[parts[1]].samples.cols());
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
    if (is_unmatched(g, l) && source_.groups[g].contacts.empty()) terms.unmatched += options_.unmatched_cost;
  }
  terms.split = 1 - std::sqrt(ratios / double(labels_.size()));
  return terms;
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif
