// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Part_map.h>

#include <algorithm>
#include <map>

namespace CGAL {
namespace Shape_correspondence {

Part_map part_map(const Correspondence& correspondence)
{
  Part_map result{correspondence.pairs, correspondence.confidences};
  result.confidences.resize(result.pairs.size(), 1);
  return result;
}

Part_map identity_part_map(std::size_t parts)
{
  Part_map result;
  for (std::size_t part = 0; part < parts; ++part)
    result.pairs.emplace_back(part, part);
  result.confidences.assign(parts, 1);
  return result;
}

namespace {

// The map of a sorted table of pairs.
Part_map part_map(const std::map<std::pair<std::size_t, std::size_t>, double>& confidences)
{
  Part_map result;
  for (const auto& [pair, confidence] : confidences) {
    result.pairs.push_back(pair);
    result.confidences.push_back(confidence);
  }
  return result;
}

} // namespace

Part_map inverse(const Part_map& map)
{
  std::map<std::pair<std::size_t, std::size_t>, double> confidences;
  for (std::size_t k = 0; k < map.pairs.size(); ++k)
    confidences[{map.pairs[k].second, map.pairs[k].first}] = map.confidences[k];
  return part_map(confidences);
}

Part_map composed(const Part_map& first, const Part_map& second)
{
  std::map<std::pair<std::size_t, std::size_t>, double> confidences;
  for (std::size_t k = 0; k < first.pairs.size(); ++k) {
    const auto [part, between] = first.pairs[k];
    const std::pair<std::size_t, std::size_t> begin(between, 0);
    for (auto l = std::size_t(std::lower_bound(second.pairs.begin(), second.pairs.end(), begin) - second.pairs.begin());
         l < second.pairs.size() && second.pairs[l].first == between; ++l) {
      double& confidence = confidences[{part, second.pairs[l].second}];
      confidence = std::max(confidence, first.confidences[k] * second.confidences[l]);
    }
  }
  return part_map(confidences);
}

} // namespace Shape_correspondence
} // namespace CGAL
