// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/coarse_to_fine.h"
#include "base/quantized.h"
#include "search/beam_search.h"

#include <CGAL/Shape_correspondence/exact_search.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

namespace {

using Groups = std::set<std::size_t>;
using Shared_shape = Matching_problem::Shared_shape;

void add_all(Groups& groups, const Groups& more) { groups.insert(more.begin(), more.end()); }

bool have_common(const Groups& a, const Groups& b)
{
  return std::any_of(a.begin(), a.end(), [&](std::size_t g) { return b.count(g) > 0; });
}

/// For each group, the coarse groups that the fewest contacts separate from it; for a coarse group, itself.
std::vector<Groups> nearest_coarse(const Aligned_shape& shape, const std::vector<char>& is_coarse)
{
  const std::size_t n = shape.number_of_groups();
  std::vector<Groups> result(n);
  std::vector<std::size_t> steps(n, n), layer;
  for (std::size_t g = 0; g < n; ++g)
    if (is_coarse[g]) {
      result[g] = {g};
      steps[g] = 0;
      layer.push_back(g);
    }
  for (std::size_t step = 1; !layer.empty(); ++step) {
    std::vector<std::size_t> next;
    for (std::size_t g : layer)
      for (const auto& edge : boost::make_iterator_range(out_edges(g, shape.graph))) {
        const std::size_t other = boost::target(edge, shape.graph);
        if (steps[other] < step) continue;
        if (steps[other] > step) next.push_back(other);
        steps[other] = step;
        add_all(result[other], result[g]);
      }
    layer.swap(next);
  }
  return result;
}

/// The distance of two parts' nearest samples, and the contact at these samples.
std::pair<double, Aligned_shape::Contact> nearest_samples(const Aligned_shape& shape, std::size_t a, std::size_t b)
{
  if (a > b) std::swap(a, b);
  std::pair<double, Aligned_shape::Contact> result(std::numeric_limits<double>::infinity(), {{a, b}, {0, 0}});
  const Points &first = shape.parts[a].samples, &second = shape.parts[b].samples;
  for (Eigen::Index i = 0; i < first.cols(); ++i) {
    Eigen::Index j;
    const double distance = (second.colwise() - first.col(i)).colwise().squaredNorm().minCoeff(&j);
    if (quantized(distance) >= quantized(result.first)) continue;
    result.first = distance;
    result.second.samples = {std::size_t(i), std::size_t(j)};
  }
  return result;
}

/// A shape, and its restriction to the most prominent parts.
struct Coarse_shape
{
  const Aligned_shape& fine;
  std::vector<char> is_kept;                  ///< indexed by part
  std::vector<std::size_t> group_of_original; ///< group of the fine shape, by part of the structural graph
  std::vector<Groups> nearest;                ///< indexed by fine group, see `nearest_coarse()`
  Shared_shape coarse;

  Coarse_shape(const Aligned_shape& shape, std::size_t count) : fine(shape), is_kept(most_prominent_parts(shape, count))
  {
    std::vector<char> is_coarse(shape.number_of_groups(), 0);
    group_of_original.resize(1 + *std::max_element(shape.original.begin(), shape.original.end()));
    for (std::size_t part = 0; part < shape.parts.size(); ++part) {
      group_of_original[shape.original[part]] = shape.group_of[part];
      if (is_kept[part]) is_coarse[shape.group_of[part]] = 1;
    }
    nearest = nearest_coarse(shape, is_coarse);
    Aligned_shape bridged = shape;
    add_bridges(bridged.contacts);
    coarse = std::make_shared<Deformable_shape>(restricted(bridged, is_kept));
  }

  /// Connects coarse groups that only small parts connect, each part with the nearest one of the other group: otherwise
  /// the energy would not see their relative position.
  void add_bridges(std::vector<Aligned_shape::Contact>& contacts) const
  {
    std::set<std::array<std::size_t, 2>> pairs;
    for (const auto& edge : boost::make_iterator_range(edges(fine.graph)))
      for (std::size_t a : nearest[boost::source(edge, fine.graph)])
        for (std::size_t b : nearest[boost::target(edge, fine.graph)])
          if (a != b) pairs.insert({std::min(a, b), std::max(a, b)});
    for (const Aligned_shape::Contact& contact : fine.contacts) {
      const std::size_t a = fine.group_of[contact.parts[0]], b = fine.group_of[contact.parts[1]];
      if (is_kept[contact.parts[0]] && is_kept[contact.parts[1]]) pairs.erase({std::min(a, b), std::max(a, b)});
    }
    for (const auto& [a, b] : pairs) {
      std::map<std::array<std::size_t, 2>, Aligned_shape::Contact> found; // key: the two parts
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)})
        for (std::size_t part : fine.group(from).parts) {
          if (!is_kept[part]) continue;
          std::pair<double, Aligned_shape::Contact> best(std::numeric_limits<double>::infinity(), {});
          for (std::size_t other : fine.group(to).parts)
            if (is_kept[other])
              if (const auto near = nearest_samples(fine, part, other); quantized(near.first) < quantized(best.first))
                best = near;
          found.emplace(best.second.parts, best.second);
        }
      for (const auto& [parts, contact] : found)
        contacts.push_back(contact);
    }
  }

  bool has(std::size_t original) const { return place_of(*coarse, original) < coarse->parts.size(); }

  std::size_t fine_group(std::size_t coarse_part) const { return group_of_original[coarse->original[coarse_part]]; }

  /// For each fine group, the coarse groups nearest to it or to a group in contact with it.
  std::vector<Groups> near_coarse() const
  {
    std::vector<Groups> result = nearest;
    for (std::size_t g = 0; g < result.size(); ++g)
      for (const auto& edge : boost::make_iterator_range(out_edges(g, fine.graph)))
        add_all(result[g], nearest[boost::target(edge, fine.graph)]);
    return result;
  }
};

/// The pinned pairs whose two parts are in the coarse shapes.
std::vector<Part_pair> coarse_pins(const std::vector<Part_pair>& pinned, const Coarse_shape& source,
                                   const Coarse_shape& target)
{
  std::vector<Part_pair> result;
  for (const Part_pair& pin : pinned)
    if (source.has(pin.source) && target.has(pin.target)) result.push_back(pin);
  return result;
}

/// For each fine group of the source, the fine groups of the target that its coarse parts correspond to.
std::vector<Groups> images_of(const Matching_problem& problem, const Assignment& assignment, const Coarse_shape& source,
                              const Coarse_shape& target)
{
  std::vector<Groups> result(source.fine.number_of_groups());
  for (std::size_t g = 0; g < assignment.size(); ++g)
    for (std::size_t part : image_parts(problem.label(g, std::size_t(assignment[g]))))
      result[source.fine_group(problem.source().group(g).parts[0])].insert(target.fine_group(part));
  return result;
}

// Checks that there is memory for exact search, which takes four times that of the energy's tables. \throw Too_large
void check_exact_tables(const Pairwise_energy& energy)
{
  double values = 0;
  for (const Pairwise_energy::Edge& edge : energy.edges)
    values += double(edge.cost.size());
  check_bytes_of_tables(4 * sizeof(double) * values);
}

} // namespace

Exact_options until(const Deadline& deadline, Exact_options options)
{
  const double left = deadline.left();
  if (left < Deadline::never && (options.time_limit == 0 || left < options.time_limit)) options.time_limit = left;
  return options;
}

Search_result search(const Matching_problem& problem, const Search_options& options, const Deadline& deadline)
{
  Search_result result;
  if (options.method == Search_method::EXACT) {
    check_exact_tables(problem.energy());
    deadline.check();
    Exact_options exact = until(deadline, options.exact);
    exact.solutions = std::size_t(options.solutions);
    result = exact_search(problem.energy(), exact);
  } else {
    result = beam_search(problem, options.beam, deadline);
  }
  if (result.solutions.size() > std::size_t(options.solutions)) result.solutions.resize(std::size_t(options.solutions));
  result.optimal = result.optimal && !problem.has_shortlists();
  return result;
}

bool is_coarse_to_fine(const Aligned_shape& source, const Aligned_shape& target, const Search_options& options)
{
  const auto count = std::size_t(options.coarse_to_fine);
  return count > 0 && std::max(source.parts.size(), target.parts.size()) > count;
}

Group_candidates coarse_candidates(const Shared_shape& source, const Shared_shape& target,
                                   const Search_options& options, const Deadline& deadline)
{
  if (!is_coarse_to_fine(*source, *target, options)) return {};
  const auto count = std::size_t(options.coarse_to_fine);
  const Coarse_shape deformed(*source, count), other(*target, count);
  Search_options coarse = options;
  coarse.solutions = 1;
  coarse.energy.pinned = coarse_pins(options.energy.pinned, deformed, other);
  const Matching_problem problem(deformed.coarse, other.coarse, coarse.energy, {}, deadline);
  const Search_result found = search(problem, coarse, deadline);

  const std::vector<Groups> images = images_of(problem, found.best().assignment, deformed, other),
                            near = deformed.near_coarse(), target_near = other.near_coarse();
  Group_candidates result(source->number_of_groups());
  for (std::size_t g = 0; g < result.size(); ++g) {
    Groups of_coarse;
    for (std::size_t c : near[g])
      add_all(of_coarse, images[c]);
    for (std::size_t h = 0; !of_coarse.empty() && h < target_near.size(); ++h)
      if (target_near[h].empty() || have_common(target_near[h], of_coarse)) result[g].push_back(h);
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
