// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"
#include "collection/Shared_progress.h"

#include <CGAL/Shape_correspondence/nearest_shapes.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

constexpr std::size_t evaluated_at_a_time =
    4; // independent of the number of threads, so that every run evaluates the same shapes

} // namespace

template <typename ConcurrencyTag>
Nearest_shapes nearest_shapes(const Structural_graph& query, std::size_t number_of_shapes,
                              const std::function<Structural_graph(std::size_t)>& graph, std::size_t k,
                              const Energy_matrix_options& options)
{
  check(options);
  const Prepared_shape prepared_query(query);
  const Correspondence_finder from_query(prepared_query, options.search);
  Nearest_shapes result;
  result.category = from_query.source_category();
  std::vector<double> bounds(number_of_shapes);
  std::vector<std::string> categories(number_of_shapes);
  for_each_index<ConcurrencyTag>(number_of_shapes, [&](std::size_t i) {
    const Structural_graph shape = graph(i);
    const Prepared_shape prepared(shape);
    const Correspondence_finder to_query(prepared, options.search);
    bounds[i] = (from_query.lower_bound(prepared, options.unmatched_energy) +
                 to_query.lower_bound(prepared_query, options.unmatched_energy)) /
                2;
    categories[i] = to_query.source_category();
  });
  const auto rank = [&](std::size_t i) {
    return result.category.empty() || categories[i] == result.category ? 0 : categories[i].empty() ? 1 : 2;
  };
  const auto bound = [&](std::size_t i) { return std::pair(rank(i), bounds[i]); };
  const auto place = [&](const Near_shape& near) { return std::tuple(rank(near.shape), near.distance, near.shape); };
  std::vector<std::size_t> order(number_of_shapes);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return bound(i) < bound(j); });

  std::vector<Near_shape>& nearest = result.shapes;
  while (result.evaluations < number_of_shapes && k > 0) {
    const std::size_t begin = result.evaluations;
    if (nearest.size() == k && bound(order[begin]) > std::pair(rank(nearest.back().shape), nearest.back().distance))
      break;
    const std::size_t end = std::min(number_of_shapes, begin + evaluated_at_a_time);
    std::vector<Near_shape> evaluated(end - begin);
    for_each_index<ConcurrencyTag>(end - begin, [&](std::size_t e) {
      const std::size_t i = order[begin + e];
      const Structural_graph shape = graph(i);
      const Prepared_shape prepared(shape);
      const auto [there, back] = from_query.both_orders(prepared);
      evaluated[e] = {
          i, (distance_energy(there, options.unmatched_energy) + distance_energy(back, options.unmatched_energy)) / 2,
          part_map(there), categories[i]};
    });
    nearest.insert(nearest.end(), evaluated.begin(), evaluated.end());
    std::sort(nearest.begin(), nearest.end(),
              [&](const Near_shape& a, const Near_shape& b) { return place(a) < place(b); });
    if (nearest.size() > k) nearest.resize(k);
    result.evaluations = end;
  }
  return result;
}

template Nearest_shapes nearest_shapes<CGAL::Sequential_tag>(const Structural_graph&, std::size_t,
                                                             const std::function<Structural_graph(std::size_t)>&,
                                                             std::size_t, const Energy_matrix_options&);
template Nearest_shapes nearest_shapes<CGAL::Parallel_tag>(const Structural_graph&, std::size_t,
                                                           const std::function<Structural_graph(std::size_t)>&,
                                                           std::size_t, const Energy_matrix_options&);

} // namespace CGAL::Shape_correspondence
