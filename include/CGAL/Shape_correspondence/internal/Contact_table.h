// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_CONTACT_TABLE_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_CONTACT_TABLE_H

#include <CGAL/Shape_correspondence/Matching_problem.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

// The energies of a contact by what its two parts are fitted to, each computed when it is first asked for.
class Matching_problem::Contact_table
{
public:
  explicit Contact_table(const Matching_problem& problem) : problem_(problem) {}

  void start(std::size_t contact)
  {
    contact_ = contact;
    const auto& parts = problem_.source().contacts[contact].parts;
    for (std::size_t side : {0, 1}) {
      begin_[side] = problem_.fitted_begin_[parts[side]];
      count_[side] = problem_.fitted_begin_[parts[side] + 1] - begin_[side];
    }
    energies_.assign(count_[0] * count_[1], {unknown, 0});
    rods_of_pieces_.clear();
  }

  // The mean over clones, each with its nearest counterpart.
  Rod_energy mean_energy(const Images& first, const Images& second)
  {
    Rod_energy sum;
    std::size_t pairs = 0;
    const auto add = [&](std::size_t a, std::size_t b) {
      const Rod_energy& energy = this->energy(a, b);
      sum.distortion += energy.distortion;
      sum.connectedness += energy.connectedness;
      ++pairs;
    };
    if (first.size() == 1 || second.size() == 1) {
      for (std::size_t a : first)
        for (std::size_t b : second)
          add(a, b);
    } else {
      for (std::size_t a : first)
        if (!second.empty()) add(a, nearest(a, second));
      for (std::size_t b : second) {
        if (first.empty()) break;
        const std::size_t a = nearest(b, first);
        if (nearest(a, second) != b) add(a, b);
      }
    }
    if (pairs > 1) sum = {sum.distortion / double(pairs), sum.connectedness / double(pairs)};
    return sum;
  }

private:
  static constexpr double unknown = -1;

  std::size_t nearest(std::size_t fitted, const Images& others) const
  {
    const Eigen::Index from = Eigen::Index(problem_.fitted_[fitted].target_index);
    const auto distance = [&](std::size_t other) {
      return problem_.target_distances_(Eigen::Index(problem_.fitted_[other].target_index), from);
    };
    std::size_t best = *others.first;
    double least = distance(best);
    for (const std::uint32_t* other = others.first + 1; other != others.last; ++other) {
      const double d = distance(*other);
      if (d < least) least = d, best = *other;
    }
    return best;
  }

  const Rod_energy& energy(std::size_t a, std::size_t b)
  {
    Rod_energy& energy = energies_[(a - begin_[0]) * count_[1] + b - begin_[1]];
    if (energy.distortion == unknown) {
      const Fitted &first = problem_.fitted_[a], &second = problem_.fitted_[b];
      energy = problem_.fitted_energy(rods(first, second), first, second);
    }
    return energy;
  }

  const Structural_rods& rods(const Fitted& first, const Fitted& second)
  {
    const Sampled_part &a = problem_.source_pieces_[first.source_index],
                       &b = problem_.source_pieces_[second.source_index];
    const Eigen::Index n = Eigen::Index(first.order->size()), m = Eigen::Index(second.order->size());
    if (first.source.count == 1 && second.source.count == 1)
      return problem_.rods(contact_, n != a.samples.cols(), m != b.samples.cols());
    for (const Piece_rods& known : rods_of_pieces_)
      if (known.first == first.source_index && known.second == second.source_index && known.counts[0] == n &&
          known.counts[1] == m)
        return known.rods;
    rods_of_pieces_.push_back(
        {first.source_index, second.source_index, {n, m}, Structural_rods(lifted_samples(a, n), lifted_samples(b, m))});
    return rods_of_pieces_.back().rods;
  }

  // The rods between pieces of which one is a segment, with as many samples
  struct Piece_rods
  {
    std::size_t first, second;
    std::array<Eigen::Index, 2> counts;
    Structural_rods rods;
  };

  const Matching_problem& problem_;
  std::size_t contact_ = 0;
  std::array<std::size_t, 2> begin_, count_; // the fitted pieces of either side
  std::vector<Rod_energy> energies_;
  std::vector<Piece_rods> rods_of_pieces_;
};

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_CONTACT_TABLE_H
