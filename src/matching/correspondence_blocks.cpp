// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/Disjoint_sets.h"
#include "base/check_number.h"
#include "base/limits.h"
#include "base/quantized.h"
#include "energy/match_groups.h"

#include <CGAL/Shape_correspondence/correspondence_blocks.h>

#include <algorithm>
#include <map>
#include <utility>

namespace CGAL::Shape_correspondence {
namespace {

constexpr double other_role_weight = .5; // weight of a pair whose parts have different roles
// Mean weight of the pairs between two sets, over that inside them, below which they stay apart
constexpr double weak_bridge = .5;

/// Parts of both shapes; indices of target parts follow those of the source.
struct Part_set
{
  std::size_t sources = 0, targets = 0;
  double inside = 0; ///< total weight of the pairs within the set

  bool has_both() const { return sources > 0 && targets > 0; }
  double mean() const { return inside / double(sources * targets); }
};

/// A partition of the parts, initially into single parts, and the weights of the pairs between its sets.
class Part_sets
{
public:
  Part_sets(const Correspondence& c, std::size_t sources, std::size_t targets)
      : set_of_(sources + targets), sets_(sources + targets)
  {
    for (std::size_t i = 0; i < sets_.size(); ++i)
      (i < sources ? sets_[i].sources : sets_[i].targets) = 1;
    for (const Part_correspondence& pair : c.pairs) {
      const bool differ = !c.source_roles.empty() && c.source_roles[pair.source] != c.target_roles[pair.target];
      const double confidence = pair.has_confidence() ? pair.confidence : 1;
      between_[{pair.source, sources + pair.target}] += (differ ? other_role_weight : 1) * confidence;
    }
  }

  /// Unites the sets with the greatest mean weight between them, all if tied. \return whether there were any
  bool unite_closest()
  {
    internal::Steps greatest = -1;
    std::vector<std::pair<std::size_t, std::size_t>> closest;
    for (const auto& [sets, weight] : between_) {
      const double mean = mean_between(sets.first, sets.second, weight);
      if (is_weak_bridge(sets_[sets.first], sets_[sets.second], mean)) continue;
      const internal::Steps step = internal::quantized(mean);
      if (step > greatest) closest.clear();
      if (step >= greatest) closest.push_back(sets);
      greatest = std::max(greatest, step);
    }
    for (const auto& [a, b] : closest)
      set_of_.unite(a, b);
    if (!closest.empty()) collect();
    return !closest.empty();
  }

  std::size_t operator[](std::size_t part) const { return set_of_[part]; }

private:
  double mean_between(std::size_t a, std::size_t b, double weight) const
  {
    return weight / double(sets_[a].sources * sets_[b].targets + sets_[b].sources * sets_[a].targets);
  }

  static bool is_weak_bridge(const Part_set& a, const Part_set& b, double mean)
  {
    using internal::quantized;
    return a.has_both() && b.has_both() && quantized(mean) < quantized(weak_bridge * std::min(a.mean(), b.mean()));
  }

  /// Collects the members of sets that were united.
  void collect()
  {
    for (std::size_t i = 0; i < sets_.size(); ++i) {
      const std::size_t set = set_of_[i];
      if (set == i) continue;
      sets_[set].sources += sets_[i].sources;
      sets_[set].targets += sets_[i].targets;
      sets_[set].inside += sets_[i].inside;
      sets_[i] = {};
    }
    std::map<std::pair<std::size_t, std::size_t>, double> between;
    for (const auto& [sets, weight] : between_) {
      const auto [a, b] = std::minmax({set_of_[sets.first], set_of_[sets.second]});
      a == b ? sets_[a].inside += weight : between[{a, b}] += weight;
    }
    between_ = std::move(between);
  }

  internal::Disjoint_sets set_of_;
  std::vector<Part_set> sets_; ///< ordered by first part
  std::map<std::pair<std::size_t, std::size_t>, double> between_;
};

/// The most frequent role of the parts; of equally frequent ones, the first in alphabetical order.
std::string role_of(const Correspondence_block& block, const Correspondence& c)
{
  std::map<std::string, int> counts;
  for (std::size_t part : block.source)
    ++counts[c.source_roles[part]];
  for (std::size_t part : block.target)
    ++counts[c.target_roles[part]];
  return std::max_element(counts.begin(), counts.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

} // namespace

std::vector<Correspondence_block> correspondence_blocks(const Correspondence& c)
{
  std::size_t sources = 0, targets = 0;
  for (const Part_correspondence& pair : c.pairs) {
    sources = std::max(sources, pair.source + 1);
    targets = std::max(targets, pair.target + 1);
    for (std::size_t part : {pair.source, pair.target})
      internal::check_index("correspondence_blocks", "part", part, internal::most_parts);
  }
  if (!c.source_roles.empty() && (c.source_roles.size() < sources || c.target_roles.size() < targets))
    throw Invalid_input("correspondence_blocks: there is not a role for every part; give one for each, or none");
  Part_sets sets(c, sources, targets);
  while (sets.unite_closest()) {
  }

  std::vector<Correspondence_block> by_first(sources + targets), result;
  for (std::size_t part = 0; part < sources + targets; ++part) {
    Correspondence_block& block = by_first[sets[part]];
    part < sources ? block.source.push_back(part) : block.target.push_back(part - sources);
  }
  std::vector<double> sums(sources, 0);
  std::vector<std::size_t> counts(sources, 0);
  for (const Part_correspondence& pair : c.pairs) {
    const std::size_t set = sets[pair.source];
    Correspondence_block& block = by_first[set];
    if (set != sets[sources + pair.target]) continue;
    sums[set] += pair.confidence;
    ++counts[set];
    if (!pair.source_segment.is_whole_part()) block.operation = Operation::CUT;
    if (!pair.target_segment.is_whole_part()) block.operation = Operation::JOIN;
  }
  for (std::size_t set = 0; set < sources; ++set) {
    Correspondence_block& block = by_first[set];
    if (counts[set] == 0) continue;
    block.confidence = sums[set] / double(counts[set]);
    if (block.operation == Operation::MATCH)
      block.operation = topological_operation(block.source.size(), block.target.size());
    if (!c.source_roles.empty()) block.role = role_of(block, c);
    result.push_back(std::move(block));
  }
  return result;
}

} // namespace CGAL::Shape_correspondence
