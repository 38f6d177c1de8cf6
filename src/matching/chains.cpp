// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/chains.h"
#include "matching/part_assemblies.h"

#include <algorithm>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

namespace {

// Set on one half of the development set, by source family, and on the generated shapes
constexpr double largest_size_ratio = 1.25; // of the longest sides of two rings of a chain
constexpr double least_offset =
    0.25; // of the next ring, over the longest side: wheel and tyre are nearer to each other

// Are the two parts rings of like size that do not lie around one another?
bool may_be_chained(const Aligned_shape& shape, const Shape_layout& layout, std::size_t ring, std::size_t next)
{
  if (shape.parts[next].kind != Sampled_part::Kind::CLOSED_CURVE) return false;
  const Axis_box &a = layout.boxes[ring], &b = layout.boxes[next];
  const double a_size = a.sides().maxCoeff(), b_size = b.sides().maxCoeff();
  return is_less(std::max(a_size, b_size), largest_size_ratio * std::min(a_size, b_size)) &&
         is_less(least_offset * std::max(a_size, b_size), (a.centre() - b.centre()).matrix().norm());
}

} // namespace

std::vector<std::vector<std::size_t>> chains_of(const Aligned_shape& shape, const Shape_layout& layout)
{
  std::vector<std::vector<std::size_t>> result;
  std::vector<char> is_in_chain(shape.parts.size(), 0);
  for (std::size_t part = 0; part < shape.parts.size(); ++part) {
    if (is_in_chain[part] || shape.parts[part].kind != Sampled_part::Kind::CLOSED_CURVE) continue;
    std::vector<std::size_t> chain = layout.connected(
        part, [&](std::size_t ring, std::size_t next) { return may_be_chained(shape, layout, ring, next); });
    if (chain.size() < minimum_repetition) continue;
    for (std::size_t ring : chain)
      is_in_chain[ring] = 1;
    result.push_back(std::move(chain));
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
