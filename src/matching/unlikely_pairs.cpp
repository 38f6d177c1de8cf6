// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/unlikely_pairs.h"

#include <algorithm>

namespace CGAL::Shape_correspondence::internal {

namespace {

void insert_sorted(std::size_t part, std::vector<std::size_t>& parts)
{
  const auto place = std::lower_bound(parts.begin(), parts.end(), part);
  if (place == parts.end() || *place != part) parts.insert(place, part);
}

} // namespace

std::vector<Part_correspondence> remove_unlikely_pairs(Correspondence& correspondence, double least)
{
  std::vector<Part_correspondence>& pairs = correspondence.pairs;
  const auto first_removed = std::stable_partition(
      pairs.begin(), pairs.end(), [&](const Part_correspondence& pair) { return !(pair.confidence < least); });
  const std::vector<Part_correspondence> removed(first_removed, pairs.end());
  pairs.erase(first_removed, pairs.end());
  for (const Part_correspondence& unlikely : removed) {
    const auto has = [&](std::size_t Part_correspondence::*part) {
      return std::any_of(pairs.begin(), pairs.end(),
                         [&](const Part_correspondence& pair) { return pair.*part == unlikely.*part; });
    };
    if (!has(&Part_correspondence::source)) insert_sorted(unlikely.source, correspondence.unmatched_source);
    if (!has(&Part_correspondence::target)) insert_sorted(unlikely.target, correspondence.unmatched_target);
  }
  return removed;
}

} // namespace CGAL::Shape_correspondence::internal
