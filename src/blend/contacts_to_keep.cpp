// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/contacts_to_keep.h"

#include "blend/Blend_stage.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace CGAL::Shape_correspondence::internal {
namespace {

using Gaps = std::map<std::array<std::size_t, 2>, double>; // of two parts, the smaller index first

/// The gaps of matched parts whose given parts touch at an end.
Gaps gaps_at(int end, const Blend_stage& stage, const std::vector<Blend_part>& parts, double tolerance)
{
  Gaps result;
  for (const Contact& contact : structure(stage.graphs[std::size_t(end)]).contacts) {
    const auto first = parts_of(parts, end, contact.parts[0]), second = parts_of(parts, end, contact.parts[1]);
    const bool are_whole = first.size() == 1 && second.size() == 1;
    for (std::size_t a : first)
      for (std::size_t b : second) {
        if (a == b) continue;
        const double gap = std::sqrt(parts[a].end_tree(end).nearly_closest(parts[b].end_tree(end)).squared);
        if (are_whole || gap <= tolerance) result[{std::min(a, b), std::max(a, b)}] = gap;
      }
  }
  return result;
}

} // namespace

std::vector<Kept_contact> contacts_to_keep(const Blend_stage& stage, const std::vector<Blend_part>& parts,
                                           double tolerance)
{
  const Gaps source = gaps_at(0, stage, parts, tolerance), target = gaps_at(1, stage, parts, tolerance);
  std::vector<Kept_contact> result;
  for (const auto& [pair, gap] : source)
    if (const auto other = target.find(pair); other != target.end()) result.push_back({pair, {gap, other->second}});
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
