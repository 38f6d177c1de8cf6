// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/mean_differences.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/evaluate_correspondence.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <tuple>

namespace CGAL::Shape_correspondence {
namespace {

std::size_t number_of_common(const Part_pairs& a, const Part_pairs& b)
{
  Part_pairs common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  return common.size();
}

double share(std::size_t part, std::size_t whole) { return whole ? double(part) / double(whole) : 0; }

/// Precision, recall, F1, coarse precision.
using Figures = std::array<double, 4>;

Figures figures(const Correspondence_score& s) { return {s.precision(), s.recall(), s.f1(), s.coarse_precision()}; }

void add(Figures& sum, const Figures& figures, double weight)
{
  for (std::size_t k = 0; k < sum.size(); ++k)
    sum[k] += weight * figures[k];
}

/// The scores of one category, ready to be drawn from.
class Category_bootstrap
{
public:
  /// \param others scores to subtract; empty: none
  explicit Category_bootstrap(const std::vector<const Scored_correspondence*>& scores,
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

  /// The means where every shape is drawn once.
  Figures mean() const { return *weighted_mean(std::vector<int>(shapes_, 1)); }

  /// The means of shapes drawn with replacement, again until a correspondence has both of its shapes drawn.
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

Estimate estimate(double mean, const std::vector<Figures>& draws, std::size_t figure, double confidence)
{
  std::vector<double> values;
  for (const Figures& draw : draws)
    values.push_back(draw[figure]);
  std::sort(values.begin(), values.end());
  const std::size_t outside = std::size_t((1 - confidence) / 2 * double(values.size()));
  return {mean, values[outside], values[values.size() - 1 - outside]};
}

void set_estimates(Mean_score& score, const Figures& mean, const std::vector<Figures>& draws, double confidence)
{
  Estimate* const estimates[] = {&score.precision, &score.recall, &score.f1, &score.coarse_precision};
  for (std::size_t k = 0; k < mean.size(); ++k)
    *estimates[k] = estimate(mean[k], draws, k, confidence);
}

void check(const std::vector<Scored_correspondence>& scores, const Evaluation_options& options)
{
  if (scores.empty()) throw Invalid_input("there are no scores to take means of; give one or more");
  if (options.resamples < 1) throw Invalid_input("the bootstrap needs at least one resample");
  if (!(options.confidence > 0 && options.confidence < 1))
    throw Invalid_input("the confidence of intervals must be between 0 and 1");
}

/// \param others scores to subtract; empty: none
Evaluation means_of(const std::vector<Scored_correspondence>& scores, const std::vector<Scored_correspondence>& others,
                    const Evaluation_options& options)
{
  check(scores, options);
  std::map<std::string, std::vector<const Scored_correspondence*>> categories, of_others;
  for (const Scored_correspondence& score : scores)
    categories[score.category].push_back(&score);
  for (const Scored_correspondence& other : others)
    of_others[other.category].push_back(&other);

  Evaluation result;
  std::mt19937_64 random(options.seed);
  const double weight = 1. / double(categories.size());
  Figures mean{};
  std::vector<Figures> mean_draws(std::size_t(options.resamples), Figures{});
  for (const auto& [name, of_category] : categories) {
    const Category_bootstrap bootstrap(of_category, of_others[name]);
    std::vector<Figures> draws;
    for (Figures& sum : mean_draws) {
      draws.push_back(bootstrap.draw(random));
      add(sum, draws.back(), weight);
    }
    add(mean, bootstrap.mean(), weight);
    Mean_score score;
    score.correspondences = of_category.size();
    for (const Scored_correspondence* s : of_category)
      score.empty += s->score.matched == 0;
    set_estimates(score, bootstrap.mean(), draws, options.confidence);
    result.mean.correspondences += score.correspondences;
    result.mean.empty += score.empty;
    result.categories.emplace_back(name, score);
  }
  set_estimates(result.mean, mean, mean_draws, options.confidence);
  return result;
}

} // namespace

double Correspondence_score::precision() const { return share(right, matched); }

double Correspondence_score::recall() const { return expected == 0 && matched == 0 ? 1 : share(right, expected); }

double Correspondence_score::f1() const
{
  const double p = precision(), r = recall();
  return p + r > 0 ? 2 * p * r / (p + r) : 0;
}

double Correspondence_score::coarse_precision() const { return share(right_coarse, matched); }

Correspondence_score evaluate_correspondence(Part_pairs pairs, const Ground_truth& truth)
{
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return {pairs.size(), truth.pairs.size(), number_of_common(pairs, truth.pairs),
          number_of_common(pairs, truth.coarse_pairs)};
}

Evaluation mean_scores(const std::vector<Scored_correspondence>& scores, const Evaluation_options& options)
{
  return means_of(scores, {}, options);
}

Evaluation internal::mean_differences(const std::vector<Scored_correspondence>& scores,
                                      const std::vector<Scored_correspondence>& others,
                                      const Evaluation_options& options)
{
  const auto key = [](const Scored_correspondence& s) { return std::tie(s.category, s.source, s.target); };
  if (!std::equal(scores.begin(), scores.end(), others.begin(), others.end(),
                  [&](const auto& a, const auto& b) { return key(a) == key(b); }))
    throw Invalid_input("differences of scores need scores of the same correspondences, in the same order");
  return means_of(scores, others, options);
}

} // namespace CGAL::Shape_correspondence
