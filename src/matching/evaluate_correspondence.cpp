// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/evaluate_correspondence.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace CGAL::Shape_correspondence {
namespace {

std::size_t number_of_common(const Part_pairs& a, const Part_pairs& b)
{
  Part_pairs common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  return common.size();
}

double share(std::size_t part, std::size_t whole) { return whole ? double(part) / double(whole) : 0; }

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

Evaluation mean_scores(const std::vector<Scored_correspondence>& scores)
{
  if (scores.empty()) throw Invalid_input("there are no scores to take means of; give one or more");
  std::map<std::string, Mean_score> categories; // sums, divided below
  const auto add = [](Mean_score& sum, double precision, double recall, double f1, double weight) {
    sum.precision += weight * precision;
    sum.recall += weight * recall;
    sum.f1 += weight * f1;
  };
  for (const auto& [category, source, target, score] : scores) {
    Mean_score& sum = categories[category];
    ++sum.correspondences;
    add(sum, score.precision(), score.recall(), score.f1(), 1);
  }
  Evaluation result;
  for (const auto& [category, sum] : categories) {
    Mean_score mean{sum.correspondences};
    add(mean, sum.precision, sum.recall, sum.f1, 1 / double(sum.correspondences));
    add(result.mean, mean.precision, mean.recall, mean.f1, 1 / double(categories.size()));
    result.mean.correspondences += mean.correspondences;
    result.categories.emplace_back(category, mean);
  }
  return result;
}

} // namespace CGAL::Shape_correspondence
