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
#include <queue>
#include <set>
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
  double inside = 0;                     ///< total weight of the pairs within the set
  std::size_t changes = 0;               ///< number of times that it was united with others
  std::map<std::size_t, double> between; ///< weight of the pairs with each other set

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
    std::vector<Weighted_pair> pairs = weighted_pairs(c, sources);
    internal::Steps greatest = -1;
    for (const Weighted_pair& pair : pairs)
      greatest = std::max(greatest, internal::quantized(pair.weight));
    for (const Weighted_pair& pair : pairs) // the closest sets of one part, before anything is kept of each pair
      if (internal::quantized(pair.weight) == greatest) set_of_.unite(pair.source, pair.target);
    for (std::size_t part = 0; part < sets_.size(); ++part) {
      Part_set& set = sets_[set_of_[part]];
      ++(part < sources ? set.sources : set.targets);
    }
    for (const Weighted_pair& pair : pairs) {
      const std::size_t a = set_of_[pair.source], b = set_of_[pair.target];
      if (a == b)
        sets_[a].inside += pair.weight;
      else
        add_between(a, b, pair.weight);
    }
    for (std::size_t set = 0; set < sets_.size(); ++set)
      push_bridges(set);
  }

  /// Unites the sets with the greatest mean weight between them, all if tied. \return whether there were any
  bool unite_closest()
  {
    std::vector<Bridge> closest;
    while (!bridges_.empty() && (closest.empty() || bridges_.top().mean == closest[0].mean)) {
      if (is_present(bridges_.top())) closest.push_back(bridges_.top());
      bridges_.pop();
    }
    std::set<std::size_t> changed;
    for (const Bridge& bridge : closest)
      unite(set_of_[bridge.a], set_of_[bridge.b]);
    for (const Bridge& bridge : closest)
      if (const std::size_t set = set_of_[bridge.a]; changed.insert(set).second) ++sets_[set].changes;
    for (std::size_t set : changed)
      push_bridges(set);
    return !closest.empty();
  }

  std::size_t operator[](std::size_t part) const { return set_of_[part]; }

private:
  /// Two parts, and the weight of all pairs of their segments.
  struct Weighted_pair
  {
    std::size_t source, target;
    double weight;
  };

  static std::vector<Weighted_pair> weighted_pairs(const Correspondence& c, std::size_t sources)
  {
    std::vector<Weighted_pair> pairs;
    for (const Part_correspondence& pair : c.pairs) {
      const bool differ = !c.source_roles.empty() && c.source_roles[pair.source] != c.target_roles[pair.target];
      const double confidence = pair.has_confidence() ? pair.confidence : 1;
      pairs.push_back({pair.source, sources + pair.target, (differ ? other_role_weight : 1) * confidence});
    }
    const auto parts = [](const Weighted_pair& pair) { return std::pair(pair.source, pair.target); };
    std::stable_sort(pairs.begin(), pairs.end(),
                     [&](const Weighted_pair& a, const Weighted_pair& b) { return parts(a) < parts(b); });
    std::vector<Weighted_pair> result;
    for (const Weighted_pair& pair : pairs)
      if (!result.empty() && parts(result.back()) == parts(pair))
        result.back().weight += pair.weight;
      else
        result.push_back(pair);
    return result;
  }

  /// Two sets with pairs between them.
  struct Bridge
  {
    internal::Steps mean; ///< of the weights
    std::size_t a, b;
    std::size_t changes_of_a, changes_of_b; ///< of the sets when it was measured

    friend bool operator<(const Bridge& x, const Bridge& y) { return x.mean < y.mean; }
  };

  void add_between(std::size_t a, std::size_t b, double weight)
  {
    sets_[a].between[b] += weight;
    sets_[b].between[a] += weight;
  }

  bool is_present(const Bridge& bridge) const
  {
    return sets_[bridge.a].changes == bridge.changes_of_a && sets_[bridge.b].changes == bridge.changes_of_b;
  }

  /// The bridges of a set that are not weak.
  void push_bridges(std::size_t a)
  {
    for (const auto& [b, weight] : sets_[a].between) {
      const internal::Steps mean = internal::quantized(mean_between(sets_[a], sets_[b], weight));
      if (!is_weak_bridge(sets_[a], sets_[b], mean)) bridges_.push({mean, a, b, sets_[a].changes, sets_[b].changes});
    }
  }

  static double mean_between(const Part_set& a, const Part_set& b, double weight)
  {
    return weight / double(a.sources * b.targets + b.sources * a.targets);
  }

  static bool is_weak_bridge(const Part_set& a, const Part_set& b, internal::Steps mean)
  {
    return a.has_both() && b.has_both() && mean < internal::quantized(weak_bridge * std::min(a.mean(), b.mean()));
  }

  void unite(std::size_t a, std::size_t b)
  {
    if (a == b) return;
    set_of_.unite(a, b);
    const std::size_t kept = set_of_[a], left = kept == a ? b : a;
    Part_set gone = std::exchange(sets_[left], {});
    sets_[left].changes = gone.changes + 1;
    Part_set& set = sets_[kept];
    set.sources += gone.sources;
    set.targets += gone.targets;
    set.inside += gone.inside;
    if (const auto inside = gone.between.find(kept); inside != gone.between.end()) {
      set.inside += inside->second;
      gone.between.erase(inside);
      set.between.erase(left);
    }
    for (const auto& [other, weight] : gone.between) {
      sets_[other].between.erase(left);
      add_between(kept, other, weight);
    }
  }

  internal::Disjoint_sets set_of_;
  std::vector<Part_set> sets_; ///< indexed by first part
  std::priority_queue<Bridge> bridges_;
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
