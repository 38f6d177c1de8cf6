// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "collection/part_matrix.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/co_analysis.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

namespace CGAL::Shape_correspondence {

namespace {

struct Counterpart
{
  std::uint32_t shape, part; // index of the part in the set
  double confidence;
};

// The counterparts of a part, sorted by shape and part.
struct Counterpart_range
{
  const Counterpart *first, *last;

  const Counterpart* begin() const { return first; }
  const Counterpart* end() const { return last; }
};

// The counterparts of all parts in one array, which takes 32 bytes for every pair of parts of a map.
class Counterparts
{
public:
  // \param first by shape, the index of its first part
  Counterparts(const std::vector<std::size_t>& first, const std::vector<Shape_pair_map>& maps)
      : first_(first), begins_(first.back() + 1, 0), ends_(first.back())
  {
    // For each pair of shapes, the number of its maps, 1 or 2
    std::map<std::pair<std::size_t, std::size_t>, int> directions;
    for (const Shape_pair_map& map : maps) {
      ++directions[std::minmax(map.source, map.target)];
      for (const Part_correspondence& pair : map.map.pairs)
        for (std::size_t part : {number(map.source, pair.source), number(map.target, pair.target)})
          ++begins_[part + 1];
    }
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    std::copy(begins_.begin(), begins_.end() - 1, ends_.begin());
    list_.resize(begins_.back());
    for (const Shape_pair_map& map : maps) {
      const double share = 1. / directions[std::minmax(map.source, map.target)];
      for (const Part_correspondence& pair : map.map.pairs) {
        const std::size_t s = number(map.source, pair.source), t = number(map.target, pair.target);
        add(s, map.target, t, share * pair.confidence);
        add(t, map.source, s, share * pair.confidence);
      }
    }
    for (std::size_t part = 0; part < size(); ++part)
      sort_and_add_up(part);
  }

  std::size_t size() const { return ends_.size(); } // number of parts
  Counterpart_range operator[](std::size_t part) const
  {
    return {list_.data() + begins_[part], list_.data() + ends_[part]};
  }

private:
  std::size_t number(std::size_t shape, std::size_t part) const
  {
    if (shape + 1 >= first_.size() || first_[shape] + part >= first_[shape + 1])
      throw Invalid_input("co_analysis: there is no part " + std::to_string(part) + " of shape " +
                          std::to_string(shape) + "; give pairs of parts that the shapes have");
    return first_[shape] + part;
  }

  void add(std::size_t to, std::size_t shape, std::size_t part, double confidence)
  {
    list_[ends_[to]++] = {std::uint32_t(shape), std::uint32_t(part), confidence};
  }

  void sort_and_add_up(std::size_t part)
  {
    const auto begin = list_.begin() + std::ptrdiff_t(begins_[part]), end = list_.begin() + std::ptrdiff_t(ends_[part]);
    std::stable_sort(begin, end, [](const Counterpart& a, const Counterpart& b) { return a.part < b.part; });
    auto last = begin;
    for (auto next = begin; next != end; ++next)
      if (last != begin && std::prev(last)->part == next->part)
        std::prev(last)->confidence += next->confidence;
      else
        *last++ = *next;
    ends_[part] = std::size_t(last - list_.begin());
  }

  const std::vector<std::size_t>& first_;
  std::vector<std::size_t> begins_, ends_; // for each part, the range of its counterparts in `list_`
  std::vector<Counterpart> list_;
};

// Of the third shapes in which both parts have counterparts, the share with a common counterpart; 1 if there are none.
double cycle_support(const Counterpart_range& of_a, const Counterpart_range& of_b)
{
  std::size_t able = 0, confirming = 0;
  const Counterpart *a = of_a.begin(), *b = of_b.begin();
  while (a != of_a.end() && b != of_b.end()) {
    if (a->shape != b->shape) {
      a->shape < b->shape ? ++a : ++b;
      continue;
    }
    const std::uint32_t shape = a->shape;
    bool has_common = false;
    while (a != of_a.end() && b != of_b.end() && a->shape == shape && b->shape == shape) {
      has_common = has_common || a->part == b->part;
      a->part < b->part ? ++a : ++b;
    }
    while (a != of_a.end() && a->shape == shape)
      ++a;
    while (b != of_b.end() && b->shape == shape)
      ++b;
    ++able;
    confirming += has_common;
  }
  return able == 0 ? 1 : double(confirming) / double(able);
}

} // namespace

Part_matrix part_matrix(const std::vector<std::size_t>& part_counts, const std::vector<Shape_pair_map>& maps,
                        double least_cycle_support)
{
  if (!(least_cycle_support >= 0 && least_cycle_support <= 1))
    throw Invalid_input("co_analysis: the least cycle support must be between 0 and 1");
  Part_matrix result;
  result.first = {0};
  for (std::size_t count : part_counts) {
    if (count > internal::most_parts)
      throw Invalid_input("co_analysis: a shape has " + internal::too_many_parts(count));
    result.first.push_back(result.first.back() + count);
  }
  const Counterparts counterparts(result.first, maps);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t part = 0; part < counterparts.size(); ++part)
    for (const Counterpart& other : counterparts[part]) {
      if (other.part <= part || other.confidence == 0) continue;
      if (cycle_support(counterparts[part], counterparts[other.part]) < least_cycle_support) {
        ++result.rejected;
        continue;
      }
      entries.emplace_back(int(part), int(other.part), other.confidence);
      entries.emplace_back(int(other.part), int(part), other.confidence);
    }
  result.confidences.resize(Eigen::Index(counterparts.size()), Eigen::Index(counterparts.size()));
  result.confidences.setFromTriplets(entries.begin(), entries.end());
  return result;
}

Co_analysis co_analysis(const std::vector<std::size_t>& part_counts, const std::vector<Shape_pair_map>& maps,
                        const Co_analysis_options& options)
{
  const Part_matrix matrix = part_matrix(part_counts, maps, options.least_cycle_support);
  const Markov_clustering clusters = markov_clustering(matrix.confidences, options.clustering);
  const std::size_t n = clusters.number_of_clusters;
  std::vector<std::size_t> sizes(n, 0);
  std::vector<std::set<std::size_t>> shapes(n);
  for (std::size_t shape = 0; shape < part_counts.size(); ++shape)
    for (std::size_t part = matrix.first[shape]; part < matrix.first[shape + 1]; ++part) {
      ++sizes[clusters.labels[part]];
      shapes[clusters.labels[part]].insert(shape);
    }
  std::vector<std::size_t> order;
  for (std::size_t cluster = 0; cluster < n; ++cluster)
    if (shapes[cluster].size() > 1) order.push_back(cluster);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  std::vector<int> label_of(n, Co_analysis::none);
  for (std::size_t k = 0; k < order.size(); ++k)
    label_of[order[k]] = int(k);

  Co_analysis result;
  for (std::size_t shape = 0; shape < part_counts.size(); ++shape) {
    result.labels.emplace_back();
    for (std::size_t part = matrix.first[shape]; part < matrix.first[shape + 1]; ++part)
      result.labels.back().push_back(label_of[clusters.labels[part]]);
  }
  result.number_of_labels = int(order.size());
  result.part_pairs = std::size_t(matrix.confidences.nonZeros()) / 2;
  result.rejected_pairs = matrix.rejected;
  return result;
}

std::vector<Shape_pair_map> agreeing_maps(std::vector<Shape_pair_map> maps, const Co_analysis& analysis)
{
  for (Shape_pair_map& map : maps) {
    const std::vector<int>&source = analysis.labels[map.source], &target = analysis.labels[map.target];
    std::vector<Part_correspondence>& pairs = map.map.pairs;
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                               [&](const Part_correspondence& pair) {
                                 return source[pair.source] == Co_analysis::none ||
                                        source[pair.source] != target[pair.target];
                               }),
                pairs.end());
  }
  return maps;
}

} // namespace CGAL::Shape_correspondence
