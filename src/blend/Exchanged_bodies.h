// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/Disjoint_sets.h"
#include "blend/Blend_part.h"
#include "map/matched_members.h"

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

class Blend_structure;

/// Bodies: sets of parts that correspond but do not morph, where they are alike in place and size. A body of the source
/// is exchanged for that of the target. Bodies are numbered in the order in which they are placed: those that touch
/// matched parts or bodies before them come first, of these the largest.
class Exchanged_bodies
{
public:
  static constexpr std::size_t none = std::size_t(-1);
  using Boxes = std::array<contacts::Box, 2>; ///< by end

  /// The smallest bodies none of which is inside another.
  Exchanged_bodies(const Blend_structure& blend, const Part_pairs& unlike);

  std::size_t size() const { return boxes_.size(); }
  const Boxes& boxes(std::size_t body) const { return boxes_[body]; }
  /// The body that a part of the blend belongs to, or `none`.
  std::size_t of(std::size_t part) const { return bodies_[part]; }

  /// Makes two bodies one; of a body and `none`, no body. Numbers of bodies stay until `renumber()`.
  void unite(std::size_t a, std::size_t b);
  void renumber();

private:
  bool unite_nested();
  void put_in_order();

  const Blend_structure& blend_;
  Disjoint_sets sets_;              ///< of the parts
  std::vector<char> is_exchanged_;  ///< by part
  std::vector<std::size_t> bodies_; ///< by part
  std::vector<Boxes> boxes_;        ///< by body
};

} // namespace CGAL::Shape_correspondence::internal
