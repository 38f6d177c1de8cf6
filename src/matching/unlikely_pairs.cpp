// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/unlikely_pairs.h"

#include <algorithm>
#include <set>

namespace CGAL::Shape_correspondence::internal {

std::vector<Part_correspondence> remove_unlikely_pairs(Correspondence& correspondence, double least)
{
  std::vector<Part_correspondence>& pairs = correspondence.pairs;
  const auto first_removed = std::stable_partition(
      pairs.begin(), pairs.end(), [&](const Part_correspondence& pair) { return !(pair.confidence < least); });
  const std::vector<Part_correspondence> removed(first_removed, pairs.end());
  pairs.erase(first_removed, pairs.end());
  const auto add_parts_without_pair = [&](std::size_t Part_correspondence::*part, std::vector<std::size_t>& unmatched) {
    std::set<std::size_t> parts(unmatched.begin(), unmatched.end());
    for (const Part_correspondence& pair : removed)
      parts.insert(pair.*part);
    for (const Part_correspondence& pair : pairs)
      parts.erase(pair.*part);
    unmatched.assign(parts.begin(), parts.end());
  };
  add_parts_without_pair(&Part_correspondence::source, correspondence.unmatched_source);
  add_parts_without_pair(&Part_correspondence::target, correspondence.unmatched_target);
  return removed;
}

} // namespace CGAL::Shape_correspondence::internal
