// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/Disjoint_sets.h"
#include "base/limits.h"
#include "base/quantized.h"
#include "energy/match_groups.h"

#include <CGAL/Shape_correspondence/correspondence_blocks.h>

#include <Eigen/Core>

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence {
namespace {

constexpr double other_role_weight = .5; // weight of a pair whose parts have different roles
// Mean weight of the pairs between two sets, over the lesser mean inside them, below which they stay apart
constexpr double weak_bridge = .5;

/// Two parts, and the weight of all pairs of their segments; indices of target parts follow those of the source.
struct Weighted_pair
{
  std::size_t source, target;
  double weight;
};

std::vector<Weighted_pair> weighted_pairs(const Correspondence& c, std::size_t sources)
{
  std::vector<Weighted_pair> pairs;
  pairs.reserve(c.pairs.size());
  for (const Part_correspondence& pair : c.pairs) {
    const bool differ = !c.source_roles.empty() && c.source_roles[pair.source] != c.target_roles[pair.target];
    const double confidence = pair.has_confidence() ? pair.confidence : 1;
    pairs.push_back({pair.source, sources + pair.target, (differ ? other_role_weight : 1) * confidence});
  }
  const auto parts = [](const Weighted_pair& pair) { return std::pair(pair.source, pair.target); };
  const auto is_first = [&](const Weighted_pair& a, const Weighted_pair& b) { return parts(a) < parts(b); };
  if (!std::is_sorted(pairs.begin(), pairs.end(), is_first)) std::stable_sort(pairs.begin(), pairs.end(), is_first);
  std::size_t last = 0;
  for (std::size_t k = 1; k < pairs.size(); ++k)
    if (parts(pairs[last]) == parts(pairs[k]))
      pairs[last].weight += pairs[k].weight;
    else
      pairs[++last] = pairs[k];
  pairs.resize(std::min(pairs.size(), last + 1));
  return pairs;
}

/// A set of parts of both shapes.
struct Part_set
{
  std::size_t sources = 0, targets = 0;
  double inside = 0; ///< total weight of the pairs within the set

  bool has_both() const { return sources > 0 && targets > 0; }
  double mean() const { return inside / double(sources * targets); }
};

/// Sets that pairs connect, and the weights of the pairs between them. O(n²) memory for n sets.
class Connected_sets
{
public:
  explicit Connected_sets(std::vector<Part_set> sets) : sets_(std::move(sets)), set_of_(sets_.size())
  {
    const auto n = Eigen::Index(sets_.size());
    between_ = Eigen::MatrixXd::Constant(n, n, no_pairs);
    present_.resize(sets_.size());
    std::iota(present_.begin(), present_.end(), std::size_t(0));
  }

  void add_pair(std::size_t a, std::size_t b, double weight)
  {
    if (a == b)
      sets_[a].inside += weight;
    else
      add_between(a, b, weight);
  }

  /// Unites the sets with the greatest mean weight between them, all if tied, until only weak bridges are left.
  void unite()
  {
    best_.resize(sets_.size());
    for (std::size_t set : present_)
      find_best(set);
    while (unite_closest()) {
    }
  }

  std::size_t operator[](std::size_t set) const { return set_of_[set]; }

private:
  static constexpr double no_pairs = -1;
  static constexpr internal::Steps no_bridge = -1;

  /// The greatest mean weight of the pairs between a set and another one, and that set.
  struct Best
  {
    internal::Steps mean = no_bridge;
    std::size_t other = 0;
  };

  /// Weights with the same first set are contiguous.
  double& between(std::size_t a, std::size_t b) { return between_(Eigen::Index(b), Eigen::Index(a)); }

  void add_between(std::size_t a, std::size_t b, double weight)
  {
    between(a, b) = between(b, a) = std::max(between(a, b), 0.) + weight;
  }

  /// The mean weight of the pairs between two sets; `no_bridge` if there are none, or if it is weak.
  internal::Steps bridge(std::size_t a, std::size_t b)
  {
    const double weight = between(a, b);
    if (weight == no_pairs) return no_bridge;
    const Part_set &x = sets_[a], &y = sets_[b];
    const internal::Steps mean = internal::quantized(weight / double(x.sources * y.targets + y.sources * x.targets));
    const bool is_weak =
        x.has_both() && y.has_both() && mean < internal::quantized(weak_bridge * std::min(x.mean(), y.mean()));
    return is_weak ? no_bridge : mean;
  }

  void find_best(std::size_t set)
  {
    best_[set] = {};
    for (std::size_t other : present_)
      take_if_better(set, other);
  }

  void take_if_better(std::size_t set, std::size_t other)
  {
    if (other == set) return;
    const internal::Steps mean = bridge(set, other);
    if (mean > best_[set].mean) best_[set] = {mean, other};
  }

  bool unite_closest()
  {
    internal::Steps greatest = no_bridge;
    for (std::size_t set : present_)
      greatest = std::max(greatest, best_[set].mean);
    if (greatest == no_bridge) return false;
    std::vector<std::pair<std::size_t, std::size_t>> closest;
    for (std::size_t a : present_)
      for (std::size_t b : present_)
        if (best_[a].mean == greatest && a < b && bridge(a, b) == greatest) closest.emplace_back(a, b);
    std::vector<char> changes(sets_.size(), false);
    for (const auto& [a, b] : closest) {
      changes[a] = changes[b] = true;
      unite(set_of_[a], set_of_[b]);
    }
    const auto is_gone = [&](std::size_t set) { return set_of_[set] != set; };
    present_.erase(std::remove_if(present_.begin(), present_.end(), is_gone), present_.end());
    std::vector<std::size_t> changed;
    std::copy_if(present_.begin(), present_.end(), std::back_inserter(changed),
                 [&](std::size_t k) { return changes[k]; });
    for (std::size_t set : present_) {
      if (changes[set] || (best_[set].mean != no_bridge && changes[best_[set].other])) {
        find_best(set);
      } else {
        for (std::size_t other : changed)
          take_if_better(set, other);
      }
    }
    return true;
  }

  void unite(std::size_t a, std::size_t b)
  {
    if (a == b) return;
    set_of_.unite(a, b);
    const std::size_t kept = set_of_[a], left = kept == a ? b : a;
    Part_set& set = sets_[kept];
    set.sources += sets_[left].sources;
    set.targets += sets_[left].targets;
    set.inside += sets_[left].inside;
    if (between(kept, left) != no_pairs) set.inside += between(kept, left);
    for (std::size_t other : present_)
      if (set_of_[other] == other && other != kept && between(left, other) != no_pairs)
        add_between(kept, other, between(left, other));
  }

  std::vector<Part_set> sets_;
  internal::Disjoint_sets set_of_;
  std::vector<std::size_t> present_; // sets that were not united into another one, ascending
  Eigen::MatrixXd between_;          // total weight of the pairs between two sets
  std::vector<Best> best_;           // indexed by set
};

/// A partition of the parts, initially into single parts.
class Part_sets
{
public:
  Part_sets(const Correspondence& c, std::size_t sources, std::size_t targets)
      : sources_(sources), set_of_(sources + targets), pairs_(weighted_pairs(c, sources))
  {
    unite_closest_parts();
    internal::Disjoint_sets connected = set_of_;
    for (const Weighted_pair& pair : pairs_)
      connected.unite(pair.source, pair.target);
    std::map<std::size_t, std::vector<std::size_t>> sets; // key: the first of all parts that pairs connect
    for (std::size_t part = 0; part < set_of_.size(); ++part)
      if (set_of_[part] == part) sets[connected[part]].push_back(part);
    std::map<std::size_t, std::vector<Weighted_pair>> pairs;
    for (const Weighted_pair& pair : pairs_)
      if (const std::size_t first = connected[pair.source]; sets[first].size() > 1) pairs[first].push_back(pair);
    for (const auto& [first, of_one] : pairs)
      unite(sets[first], of_one);
  }

  std::size_t operator[](std::size_t part) const { return set_of_[part]; }

private:
  /// Unites the parts of all pairs of greatest weight, so that the tables of `Connected_sets` are for fewer sets.
  void unite_closest_parts()
  {
    internal::Steps greatest = -1;
    for (const Weighted_pair& pair : pairs_)
      greatest = std::max(greatest, internal::quantized(pair.weight));
    for (const Weighted_pair& pair : pairs_)
      if (internal::quantized(pair.weight) == greatest) set_of_.unite(pair.source, pair.target);
  }

  /// Unites sets by their mean weights. \param firsts the first part of each set \param pairs their pairs of parts
  void unite(const std::vector<std::size_t>& firsts, const std::vector<Weighted_pair>& pairs)
  {
    const auto index = [&](std::size_t part) {
      return std::size_t(std::lower_bound(firsts.begin(), firsts.end(), set_of_[part]) - firsts.begin());
    };
    std::vector<Part_set> sets(firsts.size());
    std::set<std::size_t> parts;
    for (const Weighted_pair& pair : pairs)
      parts.insert({pair.source, pair.target});
    for (std::size_t part : parts)
      ++(part < sources_ ? sets[index(part)].sources : sets[index(part)].targets);
    Connected_sets connected(std::move(sets));
    for (const Weighted_pair& pair : pairs)
      connected.add_pair(index(pair.source), index(pair.target), pair.weight);
    connected.unite();
    for (std::size_t i = 0; i < firsts.size(); ++i)
      set_of_.unite(firsts[i], firsts[connected[i]]);
  }

  std::size_t sources_;
  internal::Disjoint_sets set_of_;
  std::vector<Weighted_pair> pairs_;
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
  const Part_sets sets(c, sources, targets);
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
