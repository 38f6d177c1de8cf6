// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_MATCHING_CHAINS_H
#define CGAL_SHAPE_CORRESPONDENCE_MATCHING_CHAINS_H

#include "matching/Shape_layout.h"
#include "matching/part_assemblies.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

// Set on one half of the development set, by source family, and on the generated shapes
constexpr double link_ratio = 1.25;  // of their longest sides: links of a chain are no more unlike
constexpr double link_offset = 0.25; // of a link's longest side: the next one is farther off than wheel and tyre

// Are the two closed curves of like size, and not around one another?
inline bool are_linked(const Aligned_shape& shape, const Shape_layout& layout, std::size_t part, std::size_t next)
{
  if (shape.parts[next].kind != Sampled_part::Kind::CLOSED_CURVE) return false;
  const Axis_box &a = layout.boxes[part], &b = layout.boxes[next];
  const double a_size = a.sides().maxCoeff(), b_size = b.sides().maxCoeff();
  return is_less(std::max(a_size, b_size), link_ratio * std::min(a_size, b_size)) &&
         is_less(link_offset * std::max(a_size, b_size), (a.centre() - b.centre()).matrix().norm());
}

// The links of every chain of the shape.
inline std::vector<std::vector<std::size_t>> chains_of(const Aligned_shape& shape, const Shape_layout& layout)
{
  std::vector<std::vector<std::size_t>> result;
  std::vector<char> is_link(shape.parts.size(), 0);
  for (std::size_t part = 0; part < shape.parts.size(); ++part) {
    if (is_link[part] || shape.parts[part].kind != Sampled_part::Kind::CLOSED_CURVE) continue;
    std::vector<std::size_t> chain = layout.connected(
        part, [&](std::size_t link, std::size_t next) { return are_linked(shape, layout, link, next); });
    if (chain.size() < whole_group_size) continue;
    for (std::size_t link : chain)
      is_link[link] = 1;
    result.push_back(std::move(chain));
  }
  return result;
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_MATCHING_CHAINS_H
