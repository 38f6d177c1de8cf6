// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Mean scores with confidence intervals.
#pragma once

#include <CGAL/Shape_correspondence/evaluate_correspondence.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::experiments {

constexpr std::size_t resamples = 1000; ///< number of draws of the bootstrap
constexpr double confidence_level = 0.95;

struct Estimate
{
  double mean = 0, low = 0, high = 0; ///< `low` and `high` are the ends of the confidence interval
};

struct Mean_estimates
{
  std::size_t correspondences = 0;
  Estimate precision, recall, f1, coarse_precision;
};

struct Estimated_scores
{
  std::vector<std::pair<std::string, Mean_estimates>> categories; ///< means by category
  Mean_estimates mean;                                            ///< mean over categories, of equal weight
};

/// Precision, recall, F1 and coarse precision, in this order.
using Figures = std::array<double, 4>;

inline Figures figures(const Correspondence_score& s)
{
  return {s.precision(), s.recall(), s.f1(), s.coarse_precision()};
}

inline void add(Figures& sum, const Figures& figures, double weight)
{
  for (std::size_t k = 0; k < sum.size(); ++k)
    sum[k] += weight * figures[k];
}

/// The bootstrap over the shapes of one category.
class Category_bootstrap
{
public:
  /// \param others scores of another method for the same pairs, to subtract; empty: none
  Category_bootstrap(const std::vector<const Scored_correspondence*>& scores,
                     const std::vector<const Scored_correspondence*>& others)
  {
    std::map<std::string, std::size_t> indices;
    const auto index = [&](const std::string& shape) { return indices.emplace(shape, indices.size()).first->second; };
    for (std::size_t i = 0; i < scores.size(); ++i) {
      const std::size_t source = index(scores[i]->source);
      entries_.push_back({source, index(scores[i]->target), figures(scores[i]->score)});
      if (!others.empty()) add(entries_.back().figures, figures(others[i]->score), -1);
    }
    shapes_ = indices.size();
  }

  /// The means over all correspondences.
  Figures mean() const { return *weighted_mean(std::vector<int>(shapes_, 1)); }

  /// Means over shapes drawn with replacement. Draws without both shapes of any correspondence are repeated.
  Figures draw(std::mt19937_64& random) const
  {
    for (;;) {
      std::vector<int> times(shapes_, 0);
      for (std::size_t i = 0; i < shapes_; ++i)
        ++times[random() % shapes_];
      if (const std::optional<Figures> mean = weighted_mean(times)) return *mean;
    }
  }

private:
  struct Entry
  {
    std::size_t source, target;
    Figures figures;
  };

  std::optional<Figures> weighted_mean(const std::vector<int>& times) const
  {
    Figures sum{};
    double total = 0;
    for (const Entry& entry : entries_) {
      const double weight = double(times[entry.source]) * times[entry.target];
      add(sum, entry.figures, weight);
      total += weight;
    }
    if (total == 0) return std::nullopt;
    for (double& value : sum)
      value /= total;
    return sum;
  }

  std::vector<Entry> entries_;
  std::size_t shapes_ = 0;
};

inline Estimate estimate(double mean, const std::vector<Figures>& draws, std::size_t figure)
{
  std::vector<double> values;
  for (const Figures& draw : draws)
    values.push_back(draw[figure]);
  std::sort(values.begin(), values.end());
  const std::size_t outside = std::size_t((1 - confidence_level) / 2 * double(values.size()));
  return {mean, values[outside], values[values.size() - 1 - outside]};
}

inline void set_estimates(Mean_estimates& score, const Figures& mean, const std::vector<Figures>& draws)
{
  Estimate* const estimates[] = {&score.precision, &score.recall, &score.f1, &score.coarse_precision};
  for (std::size_t k = 0; k < mean.size(); ++k)
    *estimates[k] = estimate(mean[k], draws, k);
}

/// Mean scores by category and over categories. The intervals are those of a bootstrap over shapes, as correspondences
/// that share a shape are not independent: shapes are drawn with replacement, and a correspondence weighs the product
/// of the numbers of times that its two shapes are drawn (A. Owen, *The pigeonhole bootstrap*, 2007). Those of paired
/// differences are narrower than those of two means suggest.
/// \param others scores of another method for the same pairs, to subtract; empty: none
inline Estimated_scores mean_estimates(const std::vector<Scored_correspondence>& scores,
                                       const std::vector<Scored_correspondence>& others = {}, std::uint64_t seed = 0)
{
  std::map<std::string, std::vector<const Scored_correspondence*>> categories, of_others;
  for (const Scored_correspondence& score : scores)
    categories[score.category].push_back(&score);
  for (const Scored_correspondence& other : others)
    of_others[other.category].push_back(&other);

  Estimated_scores result;
  std::mt19937_64 random(seed);
  const double weight = 1. / double(categories.size());
  Figures mean{};
  std::vector<Figures> mean_draws(resamples, Figures{});
  for (const auto& [name, of_category] : categories) {
    const Category_bootstrap bootstrap(of_category, of_others[name]);
    std::vector<Figures> draws;
    for (Figures& sum : mean_draws) {
      draws.push_back(bootstrap.draw(random));
      add(sum, draws.back(), weight);
    }
    add(mean, bootstrap.mean(), weight);
    Mean_estimates score;
    score.correspondences = of_category.size();
    set_estimates(score, bootstrap.mean(), draws);
    result.mean.correspondences += score.correspondences;
    result.categories.emplace_back(name, score);
  }
  set_estimates(result.mean, mean, mean_draws);
  return result;
}

} // namespace CGAL::Shape_correspondence::experiments
