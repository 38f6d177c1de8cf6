// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/topological_medoid.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence {

std::size_t topological_medoid(const Eigen::Ref<const Eigen::MatrixXd>& distances)
{
  CGAL_precondition(distances.rows() > 0 && distances.rows() == distances.cols());
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < distances.rows(); ++i) {
    double sum = 0; // one after the other: Eigen's order depends on the processor
    for (Eigen::Index j = 0; j < distances.cols(); ++j)
      sum += distances(j, i); // it is symmetric, and columns are contiguous
    if (sum < least) least = sum, best = std::size_t(i);
  }
  return best;
}

namespace {

// Lazily evaluated distances, and the best shape so far among those with all distances known.
class Medoid_search
{
public:
  Medoid_search(std::size_t n, const std::function<double(std::size_t, std::size_t)>& distance,
                const Sampled_medoid_options& options)
      : n_(n),
        evaluate_(distance),
        options_(options),
        distances_(Eigen::MatrixXd::Constant(Eigen::Index(n), Eigen::Index(n), unknown)),
        order_(n),
        sums_(n, 0)
  {
    distances_.diagonal().setZero();
    std::iota(order_.begin(), order_.end(), std::size_t(0));
    std::mt19937 random(options.seed);
    for (std::size_t i = n; i > 1; --i)
      std::swap(order_[i - 1], order_[random() % i]);
  }

  Sampled_medoid run()
  {
    std::vector<std::size_t> others; // set aside
    for (std::size_t i : candidates(others))
      evaluate_all(i);
    if (options_.failure_probability == 0) {
      std::stable_sort(others.begin(), others.end(), [&](std::size_t i, std::size_t j) { return sums_[i] < sums_[j]; });
      for (std::size_t i : others)
        if (!is_refuted(i)) evaluate_all(i);
    }
    return {best_, least_ / double(std::max<std::size_t>(1, n_ - 1)), evaluations_};
  }

private:
  double distance(std::size_t i, std::size_t j)
  {
    double& known = distances_(Eigen::Index(i), Eigen::Index(j));
    if (!std::isnan(known)) return known;
    const double d = evaluate_(std::min(i, j), std::max(i, j));
    if (!(d >= 0) || std::isinf(d))
      throw Invalid_input("sampled_medoid: the distance of shapes " + std::to_string(i) + " and " + std::to_string(j) +
                          " is not a finite number of at least 0; return one");
    ++evaluations_;
    return known = distances_(Eigen::Index(j), Eigen::Index(i)) = d;
  }

  // Sums all distances of a shape, in the order of `topological_medoid()`, so that ties stay ties.
  void evaluate_all(std::size_t i)
  {
    double sum = 0;
    for (std::size_t j = 0; j < n_; ++j)
      sum += distance(i, j);
    if (sum < least_ || (sum == least_ && i < best_)) least_ = sum, best_ = i;
  }

  // Whether a shape's mean distance is more than that of another one, judging by the first `count` shapes drawn: by the
  // differences of their distances from these (Baharav and Tse 2019), of which the mean has a confidence interval.
  bool is_worse(std::size_t i, std::size_t than, std::size_t count)
  {
    double sum = 0, squares = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const double difference = distance(i, order_[k]) - distance(than, order_[k]);
      sum += difference;
      squares += difference * difference;
    }
    const double mean = sum / double(count), variance = std::max(0., squares / double(count) - mean * mean);
    const double failure = options_.failure_probability > 0 ? options_.failure_probability : presumed_failure;
    const double left = 1 - double(count - 1) / double(n_); // draws without replacement (Serfling 1974)
    return mean > std::sqrt(2 * variance * left * std::log(double(n_) / failure) / double(count));
  }

  // Compares all shapes with random ones until few can be the medoid, which it returns; sets the others aside.
  std::vector<std::size_t> candidates(std::vector<std::size_t>& others)
  {
    std::vector<std::size_t> live(n_);
    std::iota(live.begin(), live.end(), std::size_t(0));
    for (std::size_t begin = 0; begin < n_ && live.size() > 1; begin += options_.batch) {
      const std::size_t end = std::min(n_, begin + options_.batch);
      for (std::size_t i : live)
        for (std::size_t k = begin; k < end; ++k)
          sums_[i] += distance(i, order_[k]);
      const std::size_t best = *std::min_element(live.begin(), live.end(),
                                                 [&](std::size_t i, std::size_t j) { return sums_[i] < sums_[j]; });
      const auto first_aside =
          std::stable_partition(live.begin(), live.end(), [&](std::size_t i) { return !is_worse(i, best, end); });
      for (auto i = first_aside; i != live.end(); ++i)
        sums_[*i] /= double(end);
      others.insert(others.end(), first_aside, live.end());
      live.erase(first_aside, live.end());
    }
    return live;
  }

  // Whether the sum of a shape's distances exceeds the least sum by more than rounding; stops adding as soon as it
  // does.
  bool is_refuted(std::size_t i)
  {
    constexpr double rounding = 1e-9;
    const auto row = distances_.col(Eigen::Index(i)).array(); // symmetric
    double sum = row.isNaN().select(0, row).sum();
    for (std::size_t k = 0; k < n_ && sum <= least_ * (1 + rounding); ++k)
      if (std::isnan(row[Eigen::Index(order_[k])])) sum += distance(i, order_[k]);
    return sum > least_ * (1 + rounding);
  }

  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  static constexpr double presumed_failure = 0.01; // where candidates that were set aside are checked again

  const std::size_t n_;
  const std::function<double(std::size_t, std::size_t)>& evaluate_;
  const Sampled_medoid_options& options_;
  Eigen::MatrixXd distances_;
  std::vector<std::size_t> order_;
  std::vector<double> sums_; // over the shapes drawn; of the shapes set aside, means
  std::size_t best_ = 0, evaluations_ = 0;
  double least_ = std::numeric_limits<double>::infinity();
};

} // namespace

Sampled_medoid sampled_medoid(std::size_t n, const std::function<double(std::size_t, std::size_t)>& distance,
                              const Sampled_medoid_options& options)
{
  CGAL_precondition(n > 0);
  if (!(options.failure_probability >= 0 && options.failure_probability < 1) || options.batch == 0)
    throw Invalid_input("sampled_medoid: the probability of failure must be at least 0 and below 1, the batch above 0");
  return Medoid_search(n, distance, options).run();
}

} // namespace CGAL::Shape_correspondence
