// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"
#include "base/limits.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/energy_matrix.h>
#include <CGAL/Shape_correspondence/nearest_shapes.h>
#include <CGAL/Shape_correspondence/topological_medoid.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>
#include <tuple>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

void check(const Energy_matrix_options& options)
{
  if (!(options.unmatched_energy >= 0) || !std::isfinite(options.unmatched_energy))
    throw Invalid_input("energy_matrix: the energy of unmatched parts must be finite and not negative");
}

} // namespace

double distance_energy(const Correspondence& correspondence, double unmatched_energy)
{
  const bool forward = correspondence.direction == Direction::SOURCE_TO_TARGET;
  const std::vector<std::size_t>& unmatched =
      forward ? correspondence.unmatched_source : correspondence.unmatched_target;
  const auto is_unmatched = [&](std::size_t part) {
    return std::binary_search(unmatched.begin(), unmatched.end(), part);
  };
  std::vector<std::size_t> touching; // parts in contact, sorted
  std::size_t broken = 0, counted = correspondence.contacts.size();
  for (const Contact_energy& contact : correspondence.contacts) {
    broken += is_unmatched(contact.parts[0]) || is_unmatched(contact.parts[1]);
    touching.insert(touching.end(), contact.parts.begin(), contact.parts.end());
  }
  std::sort(touching.begin(), touching.end());
  for (const Group_match& group : correspondence.groups)
    for (std::size_t part : forward ? group.source : group.target) {
      if (std::binary_search(touching.begin(), touching.end(), part)) continue;
      ++counted;
      broken += is_unmatched(part);
    }
  const double charged = correspondence.terms.unmatched > 0 ? 0 : unmatched_energy * double(broken);
  return (correspondence.energy + charged) / double(std::max<std::size_t>(1, counted));
}

namespace internal { // not anonymous, since lambdas of public templates use it

/// Reports finished work to a callback, one call at a time, and records whether the callback ended the work.
class Shared_progress
{
public:
  Shared_progress(const std::function<bool(std::size_t, std::size_t)>& callback, std::size_t total)
      : callback_(callback), total_(total)
  {}

  bool is_ended() const { return ended_; }

  void add_one()
  {
    if (!callback_) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!ended_ && !callback_(++done_, total_)) ended_ = true;
  }

private:
  const std::function<bool(std::size_t, std::size_t)>& callback_;
  std::size_t total_, done_ = 0;
  std::atomic<bool> ended_{false};
  std::mutex mutex_;
};

// A pair of shapes, and the indices in a list of this pair (`place`) and, if it is there, of the reversed pair.
struct Both_orders
{
  static constexpr std::size_t none = std::size_t(-1);

  std::size_t first, second, place, reversed = none;
};

} // namespace internal

namespace {

// The pairs of a list, each joined with its reversed pair if that is in the list, too.
std::vector<Both_orders> both_orders(const std::vector<std::pair<std::size_t, std::size_t>>& pairs)
{
  // Index in `result` of pairs whose reversed pair has not been seen
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> open;
  std::vector<Both_orders> result;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto [i, j] = pairs[k];
    const auto reversed = open.find({j, i});
    if (reversed != open.end() && i != j) {
      result[reversed->second].reversed = k;
      open.erase(reversed);
    } else {
      open[pairs[k]] = result.size();
      result.push_back({i, j, k});
    }
  }
  return result;
}

} // namespace

template <typename ConcurrencyTag>
std::vector<Rated_map> match_pairs(const std::vector<Structural_graph>& shapes,
                                   const std::vector<std::pair<std::size_t, std::size_t>>& pairs,
                                   const Energy_matrix_options& options)
{
  return match_pairs<ConcurrencyTag>(std::vector<Prepared_shape>(shapes.begin(), shapes.end()), pairs, options);
}

template <typename ConcurrencyTag>
std::vector<Rated_map> match_pairs(const std::vector<Prepared_shape>& shapes,
                                   const std::vector<std::pair<std::size_t, std::size_t>>& pairs,
                                   const Energy_matrix_options& options)
{
  check(options);
  for (const auto& [source, target] : pairs)
    for (std::size_t shape : {source, target})
      check_index("match_pairs", "shape", shape, shapes.size());
  std::vector<std::unique_ptr<const Correspondence_finder>> finders(shapes.size());
  for_each_index<ConcurrencyTag>(shapes.size(), [&](std::size_t i) {
    finders[i] = std::make_unique<Correspondence_finder>(shapes[i], options.search);
  });

  std::vector<Rated_map> result(pairs.size());
  Shared_progress progress(options.progress, pairs.size());
  const auto keep = [&](std::size_t place, const Correspondence& correspondence) {
    result[place] = {distance_energy(correspondence, options.unmatched_energy), part_map(correspondence)};
    progress.add_one();
  };
  const std::vector<Both_orders> work = both_orders(pairs);
  for_each_index<ConcurrencyTag>(work.size(), [&](std::size_t k) {
    if (progress.is_ended()) return;
    const Both_orders& pair = work[k];
    if (pair.reversed == Both_orders::none) return keep(pair.place, (*finders[pair.first])(shapes[pair.second]));
    const std::array<Correspondence, 2> found = finders[pair.first]->both_orders(shapes[pair.second]);
    keep(pair.place, found[0]);
    keep(pair.reversed, found[1]);
  });
  return result;
}

template <typename ConcurrencyTag>
Energy_matrix energy_matrix(const std::vector<Structural_graph>& shapes, const Energy_matrix_options& options)
{
  const std::size_t n = shapes.size();
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if (i != j) pairs.emplace_back(i, j);
  std::vector<Rated_map> rated = match_pairs<ConcurrencyTag>(shapes, pairs, options);

  Energy_matrix result;
  result.energies = Eigen::MatrixXd::Zero(Eigen::Index(n), Eigen::Index(n));
  result.maps.resize(n * n);
  for (std::size_t i = 0; i < n; ++i)
    result.maps[i * n + i] = identity_part_map(structure(shapes[i]).parts.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto [i, j] = pairs[k];
    result.energies(Eigen::Index(i), Eigen::Index(j)) = rated[k].energy;
    result.complete = result.complete && !std::isnan(rated[k].energy);
    result.maps[i * n + j] = std::move(rated[k].map);
  }
  return result;
}

Eigen::MatrixXd symmetric_distances(const Eigen::MatrixXd& energies) { return (energies + energies.transpose()) / 2; }

template std::vector<Rated_map>
match_pairs<CGAL::Sequential_tag>(const std::vector<Structural_graph>&,
                                  const std::vector<std::pair<std::size_t, std::size_t>>&,
                                  const Energy_matrix_options&);
template std::vector<Rated_map> match_pairs<CGAL::Parallel_tag>(const std::vector<Structural_graph>&,
                                                                const std::vector<std::pair<std::size_t, std::size_t>>&,
                                                                const Energy_matrix_options&);
template std::vector<Rated_map>
match_pairs<CGAL::Sequential_tag>(const std::vector<Prepared_shape>&,
                                  const std::vector<std::pair<std::size_t, std::size_t>>&,
                                  const Energy_matrix_options&);
template std::vector<Rated_map> match_pairs<CGAL::Parallel_tag>(const std::vector<Prepared_shape>&,
                                                                const std::vector<std::pair<std::size_t, std::size_t>>&,
                                                                const Energy_matrix_options&);

template Energy_matrix energy_matrix<CGAL::Sequential_tag>(const std::vector<Structural_graph>&,
                                                           const Energy_matrix_options&);
template Energy_matrix energy_matrix<CGAL::Parallel_tag>(const std::vector<Structural_graph>&,
                                                         const Energy_matrix_options&);

namespace {

constexpr std::size_t evaluated_at_a_time =
    4; // number of shapes; independent of the number of threads, so that every run evaluates the same ones

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

std::size_t topological_medoid(const Eigen::Ref<const Eigen::MatrixXd>& distances)
{
  CGAL_precondition(distances.rows() > 0 && distances.rows() == distances.cols());
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < distances.rows(); ++i) {
    double sum = 0; // summed one by one: the order of Eigen's sum depends on the processor
    for (Eigen::Index j = 0; j < distances.cols(); ++j)
      sum += distances(j, i); // the matrix is symmetric, and columns are contiguous
    if (sum < least) least = sum, best = std::size_t(i);
  }
  return best;
}

} // namespace CGAL::Shape_correspondence
