// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_CO_ANALYSIS_IMPL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_CO_ANALYSIS_IMPL_H

#include <CGAL/Shape_correspondence/co_analysis.h>

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace CGAL {
namespace Shape_correspondence {

namespace internal {

// A counterpart of a part.
struct Counterpart
{
  std::size_t shape, part; // part: its number in the set
  double confidence;
};

using Counterparts = std::vector<std::vector<Counterpart>>; // by part, sorted by shape and part

// Which directions of pairs of shapes are given: 1 or 2, by (smaller, larger).
using Directions = std::map<std::pair<std::size_t, std::size_t>, int>;

inline std::size_t part_number(const std::vector<std::size_t>& first, std::size_t shape, std::size_t part)
{
  if (shape + 1 >= first.size() || first[shape] + part >= first[shape + 1])
    throw Invalid_input("co_analysis: there is no part " + std::to_string(part) + " of shape " + std::to_string(shape));
  return first[shape] + part;
}

inline void sort_and_add_up(std::vector<Counterpart>& parts)
{
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Counterpart& a, const Counterpart& b) { return a.part < b.part; });
  std::size_t n = 0;
  for (const Counterpart& next : parts)
    if (n > 0 && parts[n - 1].part == next.part)
      parts[n - 1].confidence += next.confidence;
    else
      parts[n++] = next;
  parts.resize(n);
}

inline Counterparts counterparts_of(const std::vector<std::size_t>& first, const std::vector<Shape_pair_map>& maps)
{
  Directions directions;
  for (const Shape_pair_map& map : maps)
    ++directions[std::minmax(map.source, map.target)];
  Counterparts result(first.back());
  for (const Shape_pair_map& map : maps) {
    const double share = 1. / directions[std::minmax(map.source, map.target)];
    for (std::size_t k = 0; k < map.map.pairs.size(); ++k) {
      const std::size_t s = part_number(first, map.source, map.map.pairs[k].first);
      const std::size_t t = part_number(first, map.target, map.map.pairs[k].second);
      result[s].push_back({map.target, t, share * map.map.confidences[k]});
      result[t].push_back({map.source, s, share * map.map.confidences[k]});
    }
  }
  for (std::vector<Counterpart>& parts : result)
    sort_and_add_up(parts);
  return result;
}

// The share of third shapes with counterparts of both parts in which they have a common one; 1 if there are none.
inline double cycle_support(const std::vector<Counterpart>& a, const std::vector<Counterpart>& b)
{
  std::size_t able = 0, confirming = 0;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    if (a[i].shape != b[j].shape) {
      a[i].shape < b[j].shape ? ++i : ++j;
      continue;
    }
    const std::size_t shape = a[i].shape;
    bool has_common = false;
    while (i < a.size() && j < b.size() && a[i].shape == shape && b[j].shape == shape) {
      has_common = has_common || a[i].part == b[j].part;
      a[i].part < b[j].part ? ++i : ++j;
    }
    while (i < a.size() && a[i].shape == shape)
      ++i;
    while (j < b.size() && b[j].shape == shape)
      ++j;
    ++able;
    confirming += has_common;
  }
  return able == 0 ? 1 : double(confirming) / double(able);
}

} // namespace internal

CGAL_SHAPE_CORRESPONDENCE_INLINE Part_matrix part_matrix(const std::vector<std::size_t>& part_counts,
                                                         const std::vector<Shape_pair_map>& maps,
                                                         double least_cycle_support)
{
  if (!(least_cycle_support >= 0 && least_cycle_support <= 1))
    throw Invalid_input("co_analysis: the least cycle support must be between 0 and 1");
  Part_matrix result;
  result.first = {0};
  for (std::size_t count : part_counts)
    result.first.push_back(result.first.back() + count);
  const internal::Counterparts counterparts = internal::counterparts_of(result.first, maps);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t part = 0; part < counterparts.size(); ++part)
    for (const internal::Counterpart& other : counterparts[part]) {
      if (other.part <= part || other.confidence == 0) continue;
      if (internal::cycle_support(counterparts[part], counterparts[other.part]) < least_cycle_support) {
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

CGAL_SHAPE_CORRESPONDENCE_INLINE Co_analysis co_analysis(const std::vector<std::size_t>& part_counts,
                                                         const std::vector<Shape_pair_map>& maps,
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

} // namespace Shape_correspondence
} // namespace CGAL

#endif
