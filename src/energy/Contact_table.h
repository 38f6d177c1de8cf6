// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/Matching_problem.h"
#include "energy/Structural_rods.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace CGAL::Shape_correspondence {

// Computes the energies of all contacts by the labels of their two parts. Comparisons of rods are listed first, so that
// the rods of a pair of deformed pieces are found once, for all contacts that may turn into it. By samples, these are
// target pieces, which many contacts share; by extremities, each source piece is deformed into a shape of its own.
class Matching_problem::Contact_table
{
public:
  explicit Contact_table(const Matching_problem& problem);

  // Lists the comparisons that the energies of the next contact are the means of.
  void list(std::size_t contact);

  // Whether more is listed than fits in the processor's cache.
  bool is_full() const { return comparisons_.size() > maximum_comparisons || used_bytes_ > maximum_bytes; }

  // Appends the energies of the listed contacts, in their order, first label by second label, and clears the list.
  void compute(std::vector<Rod_energy>& result);

private:
  using Range = internal::Fitted_range;
  using Fitted = internal::Fitted_piece;

  static constexpr std::uint32_t none = std::uint32_t(-1);
  static constexpr std::size_t maximum_comparisons = 8192, maximum_bytes = 3u << 17;

  // Rods between two source pieces, and those after the deformation of the target pair whose list it is in.
  struct Comparison
  {
    const Structural_rods* rods;
    std::uint32_t next; // in the list of the target pair
    Rod_energy energy;
  };

  // Two deformed pieces, each named by one of the fitted pieces that have its samples.
  struct Target_pair
  {
    std::uint32_t first, second; // fitted pieces
    std::uint32_t comparison;    // first of the list
  };

  // Lists a pair of clones for each clone: it and the nearest one of the other part.
  void list(const Range& first, const Range& second);
  const std::uint32_t* nearest(std::uint32_t fitted, const Range& others);
  double distance(const Fitted& first, const Fitted& second);
  std::uint32_t comparison(std::uint32_t a, std::uint32_t b);
  std::size_t pair_index(const Fitted& first, const Fitted& second) const;
  void compare();
  const Structural_rods& rods(std::uint32_t a, std::uint32_t b);

  const Matching_problem& problem_;
  const internal::Fitted_pieces& fitted_;
  std::vector<std::uint32_t> pair_of_;  // by `pair_index()`, in `pairs_`; empty if fitted pieces share no samples
  std::vector<Target_pair> pairs_;      // with comparisons
  std::vector<Comparison> comparisons_; // contact by contact
  std::vector<std::uint32_t> counts_;   // number of comparisons by contact and labels
  std::vector<std::uint32_t> compared_; // the comparisons themselves, those of all labels in a row
  // By source lanes, between pieces of which one is no whole part
  std::map<std::array<std::size_t, 2>, Structural_rods> piece_rods_;
  std::size_t used_bytes_ = 0;                 // of `piece_rods_`
  std::vector<std::vector<double>> distances_; // by target pieces; negative where not yet known

  // Of the contact that is being listed, by side
  std::size_t contact_ = 0;
  std::array<std::size_t, 2> begin_, count_;   // the fitted pieces
  std::array<std::vector<Range>, 2> touching_; // fitted pieces that touch there, by label
  std::vector<std::uint32_t> known_;           // comparisons by two fitted pieces

  // Kept for their memory
  std::vector<const Structural_rods*> rods_;
  std::vector<double> distortions_;
  std::vector<std::uint32_t> nearest_;
};

} // namespace CGAL::Shape_correspondence
