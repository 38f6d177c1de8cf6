// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Part_map.h>

#include <algorithm>
#include <map>

namespace CGAL::Shape_correspondence {

Part_map part_map(const Correspondence& correspondence)
{
  Part_map result;
  for (const Part_correspondence& pair : correspondence.pairs)
    result.pairs.push_back({pair.source, pair.target, pair.has_confidence() ? pair.confidence : 1});
  return result;
}

Part_map identity_part_map(std::size_t parts)
{
  Part_map result;
  for (std::size_t part = 0; part < parts; ++part)
    result.pairs.push_back({part, part, 1});
  return result;
}

Part_map inverse(const Part_map& map)
{
  Part_map result;
  for (const Part_correspondence& pair : map.pairs)
    result.pairs.push_back(inverse(pair));
  std::sort(result.pairs.begin(), result.pairs.end(), is_before);
  return result;
}

Part_map composed(const Part_map& first, const Part_map& second)
{
  std::map<std::pair<std::size_t, std::size_t>, double> confidences;
  for (const Part_correspondence& pair : first.pairs) {
    const Part_correspondence begin{pair.target, 0};
    for (auto next = std::lower_bound(second.pairs.begin(), second.pairs.end(), begin, is_before);
         next != second.pairs.end() && next->source == pair.target; ++next) {
      double& confidence = confidences[{pair.source, next->target}];
      confidence = std::max(confidence, pair.confidence * next->confidence);
    }
  }
  Part_map result;
  for (const auto& [pair, confidence] : confidences)
    result.pairs.push_back({pair.first, pair.second, confidence});
  return result;
}

} // namespace CGAL::Shape_correspondence
