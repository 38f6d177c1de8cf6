// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/deform_to_fit.h"
#include "base/quantized.h"

#include <algorithm>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

constexpr int samples_of_sheet = samples_per_side * samples_per_side;

using Kind = Sampled_part::Kind;
using Permutation = std::vector<int>;

// The 2 orders of the samples of an open curve; the 2 e orders of a closed one, which may begin with any sample.
std::vector<Permutation> curve_orders(bool closed)
{
  constexpr int e = samples_per_side;
  std::vector<Permutation> result;
  for (int start = 0; start < (closed ? e : 1); ++start)
    for (int step : {1, -1}) {
      Permutation order(e);
      for (int i = 0; i < e; ++i)
        order[std::size_t(i)] = ((step > 0 ? i : e - 1 - i) + start) % e;
      result.push_back(order);
    }
  return result;
}

// The 8 symmetries of a square grid.
std::vector<Permutation> sheet_orders()
{
  constexpr int e = samples_per_side;
  std::vector<Permutation> result;
  for (int transposed : {0, 1})
    for (int flip_u : {0, 1})
      for (int flip_v : {0, 1}) {
        Permutation order(samples_of_sheet);
        for (int i = 0; i < e; ++i)
          for (int j = 0; j < e; ++j) {
            const int u = flip_u ? e - 1 - i : i, v = flip_v ? e - 1 - j : j;
            order[std::size_t(i * e + j)] = transposed ? v * e + u : u * e + v;
          }
        result.push_back(order);
      }
  return result;
}

// The candidate orders of samples for two parts, and the samples by which the orders are compared.
struct Fits
{
  std::vector<Permutation> orders;
  std::vector<int> extremities; // ends of a curve, corners of a sheet, all samples of a closed curve
};

const Fits& fits_of(const Sampled_part& source, const Sampled_part& target)
{
  constexpr int e = samples_per_side;
  static const Fits open{curve_orders(false), {0, e - 1}}, closed{curve_orders(true), curve_orders(false)[0]},
      sheet{sheet_orders(), {0, e - 1, samples_of_sheet - e, samples_of_sheet - 1}};
  const auto any_is = [&](Kind kind) { return source.kind == kind || target.kind == kind; };
  return any_is(Kind::SHEET) ? sheet : any_is(Kind::CLOSED_CURVE) ? closed : open;
}

} // namespace

const std::vector<int>& match_extremities(const Sampled_part& source, const Sampled_part& target)
{
  const auto& [orders, extremities] = fits_of(source, target);
  const auto from_centre = [count = orders[0].size(), &extremities = extremities](const Sampled_part& part) {
    const int repeats = int(count) / int(part.samples.cols()); // e for a curve fitted to a sheet, else 1
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, samples_per_side> result(3, Eigen::Index(extremities.size()));
    for (Eigen::Index k = 0; k < result.cols(); ++k)
      result.col(k) = part.samples.col(extremities[std::size_t(k)] / repeats) - part.centroid;
    return result;
  };
  const auto from = from_centre(source), to = from_centre(target);
  const Permutation* best = nullptr;
  Steps best_score = 0; // sum of dot products, greatest where the sum of squared distances is least
  for (const Permutation& order : orders) {
    double sum = 0;
    for (Eigen::Index k = 0; k < from.cols(); ++k) {
      const int image = order[std::size_t(extremities[std::size_t(k)])]; // an extremity as well
      sum += from.col(k).dot(to.col(std::find(extremities.begin(), extremities.end(), image) - extremities.begin()));
    }
    const Steps score = quantized(sum);
    if (!best || score > best_score) best = &order, best_score = score;
  }
  return *best;
}

Points ordered_samples(const Sampled_part& target, const std::vector<int>& order)
{
  const int repeats = int(order.size()) / int(target.samples.cols());
  Points result(3, Eigen::Index(order.size()));
  for (Eigen::Index i = 0; i < result.cols(); ++i)
    result.col(i) = target.samples.col(order[std::size_t(i)] / repeats);
  return result;
}

Points deform_to_fit(const Sampled_part& source, const Sampled_part& target, Deform_to_fit fit)
{
  const Permutation& order = match_extremities(source, target);
  Points result = ordered_samples(target, order);
  const std::vector<int>& extremities = fits_of(source, target).extremities;
  if (fit == Deform_to_fit::SAMPLES || extremities.size() == order.size()) return result;

  const Points from = repeated(source.samples, int(result.cols() / source.samples.cols()));
  const Points displacement = result - from;
  result = from;
  constexpr int e = samples_per_side;
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const double u = double(i % e) / (e - 1), v = double(i / e) / (e - 1); // v is 0 on a curve
    const double weights[] = {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v};
    for (std::size_t k = 0; k < extremities.size(); ++k)
      result.col(i) += weights[k] * displacement.col(extremities[k]);
  }
  return result;
}

Points repeated(const Points& samples, int repeats)
{
  Points result(3, samples.cols() * repeats);
  for (Eigen::Index i = 0; i < result.cols(); ++i)
    result.col(i) = samples.col(i / repeats);
  return result;
}

} // namespace CGAL::Shape_correspondence
