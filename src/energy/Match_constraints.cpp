// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Match_constraints.h"
#include "base/Disjoint_sets.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

std::size_t place_of(const Aligned_shape& shape, std::size_t part)
{
  return std::size_t(std::find(shape.original.begin(), shape.original.end(), part) - shape.original.begin());
}

namespace {

std::string name_of(const Part_pair& pair)
{
  return "part number " + std::to_string(pair.source) + " of the source and number " + std::to_string(pair.target) +
         " of the target";
}

} // namespace

Match_constraints::Match_constraints(const Aligned_shape& source, const Aligned_shape& target,
                                     const Energy_options& options)
{
  if (options.pinned.empty() && options.forbidden.empty()) return;
  const std::size_t n = source.parts.size(), m = target.parts.size();
  pinned_.resize(n);
  allowed_.assign(n, std::vector<char>(m, 1));
  std::vector<char> is_pinned_target(m, 0);
  for (const Part_pair& pair : options.pinned) {
    const std::size_t i = place_of(source, pair.source), j = place_of(target, pair.target);
    if (i == n || j == m)
      throw Invalid_input(
          "find_correspondence: " + name_of(pair) +
          " are pinned, but not both of them take part in the match; let both take part, or do not pin them");
    pinned_[i].insert(j);
    is_pinned_target[j] = 1;
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < m; ++j)
      if (!pinned_[i].empty() || is_pinned_target[j]) allowed_[i][j] = 0;
    for (std::size_t j : pinned_[i])
      allowed_[i][j] = 1;
  }
  for (const Part_pair& pair : options.forbidden) {
    const std::size_t i = place_of(source, pair.source), j = place_of(target, pair.target);
    if (i == n || j == m) continue; // the part is not in the aligned shape
    if (pinned_[i].count(j) > 0)
      throw Invalid_input("find_correspondence: " + name_of(pair) + " are pinned and forbidden; choose one of the two");
    allowed_[i][j] = 0;
  }
}

Pinned_sets pinned_sets(const std::vector<Part_pair>& pins)
{
  // Maps the indices of pinned parts, unchecked so far, to consecutive numbers
  std::map<std::size_t, std::size_t> sources, targets;
  for (const Part_pair& pin : pins)
    sources[pin.source], targets[pin.target];
  std::size_t place = 0;
  for (auto* places : {&sources, &targets})
    for (auto& part : *places)
      part.second = place++;
  Disjoint_sets joined(place);
  for (const Part_pair& pin : pins)
    joined.unite(sources[pin.source], targets[pin.target]);
  std::map<std::size_t, std::array<std::set<std::size_t>, 2>> sets;
  for (const Part_pair& pin : pins) {
    auto& [source, target] = sets[joined[sources[pin.source]]];
    source.insert(pin.source);
    target.insert(pin.target);
  }
  Pinned_sets result;
  for (const auto& [name, parts] : sets) {
    result.source.emplace_back(parts[0].begin(), parts[0].end());
    result.target.emplace_back(parts[1].begin(), parts[1].end());
  }
  return result;
}

Energy_options reversed(Energy_options options)
{
  for (auto* pairs : {&options.pinned, &options.forbidden})
    for (Part_pair& pair : *pairs)
      std::swap(pair.source, pair.target);
  options.role_costs.transposeInPlace();
  return options;
}

} // namespace CGAL::Shape_correspondence::internal
