// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "structure/align_shapes.h"

#include <CGAL/Shape_correspondence/Energy_options.h>

#include <cstddef>
#include <set>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Index in an aligned shape of a part of its structural graph; the shape's number of parts if it lacks that part.
std::size_t place_of(const Aligned_shape& shape, std::size_t part);

/// The parts of two aligned shapes that may and that must correspond, by `Energy_options::pinned` and `forbidden`.
class Match_constraints
{
public:
  Match_constraints() = default;

  /// Reads `options`. \throw Invalid_input if a pinned part is not in its aligned shape, or a pinned pair is forbidden
  Match_constraints(const Aligned_shape& source, const Aligned_shape& target, const Energy_options& options);

  bool empty() const { return pinned_.empty(); }

  bool allows(std::size_t source, std::size_t target) const { return empty() || allowed_[source][target]; }

  /// The target parts that a source part is pinned to, ascending.
  const std::set<std::size_t>& pinned(std::size_t source) const { return pinned_[source]; }

private:
  std::vector<std::set<std::size_t>> pinned_; // indexed by source part
  std::vector<std::vector<char>> allowed_;    // indexed by source part and target part
};

/// The connected components of the graph of pinned pairs; indices of parts as in the pinned pairs.
struct Pinned_sets
{
  std::vector<std::vector<std::size_t>> source, target;
};

Pinned_sets pinned_sets(const std::vector<Part_pair>& pins);

/// The options with source and target exchanged, for deforming the target into the source.
Energy_options reversed(Energy_options options);

} // namespace CGAL::Shape_correspondence::internal
