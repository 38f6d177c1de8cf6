// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/deform_to_fit.h"
#include "base/quantized.h"

#include <algorithm>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

constexpr int samples_of_curve = samples_per_side;
constexpr int samples_of_sheet = samples_per_side * samples_per_side;

using Permutation = std::vector<int>;

// The ways to run through the samples of a curve, or of a closed one from every start.
std::vector<Permutation> curve_orientations(bool closed)
{
  std::vector<Permutation> result;
  for (int start = 0; start < (closed ? samples_of_curve : 1); ++start)
    for (int step : {1, -1}) {
      Permutation p(samples_of_curve);
      for (int i = 0; i < samples_of_curve; ++i)
        p[i] = ((step > 0 ? i : samples_of_curve - 1 - i) + start) % samples_of_curve;
      result.push_back(p);
    }
  return result;
}

// The 8 ways to lay a square grid onto itself.
std::vector<Permutation> sheet_orientations()
{
  constexpr int e = samples_per_side;
  std::vector<Permutation> result;
  for (int transposed : {0, 1})
    for (int flip_u : {0, 1})
      for (int flip_v : {0, 1}) {
        Permutation p(samples_of_sheet);
        for (int i = 0; i < e; ++i)
          for (int j = 0; j < e; ++j) {
            const int u = flip_u ? e - 1 - i : i, v = flip_v ? e - 1 - j : j;
            p[i * e + j] = transposed ? v * e + u : u * e + v;
          }
        result.push_back(p);
      }
  return result;
}

const std::vector<Permutation>& orientations(const Sampled_part& source, const Sampled_part& target)
{
  static const std::vector<Permutation> open = curve_orientations(false), closed = curve_orientations(true),
                                        sheet = sheet_orientations();
  using Kind = Sampled_part::Kind;
  if (source.kind == Kind::SHEET || target.kind == Kind::SHEET) return sheet;
  return source.kind == Kind::CLOSED_CURVE || target.kind == Kind::CLOSED_CURVE ? closed : open;
}

// The samples that orientations are told apart by: the ends of a curve, the corners of a sheet, all of a closed curve.
const std::vector<int>& extremities(const Sampled_part& source, const Sampled_part& target)
{
  constexpr int last = samples_per_side - 1;
  static const std::vector<int> ends{0, last}, corners{0, last, samples_of_sheet - 1 - last, samples_of_sheet - 1},
      all{0, 1, 2, 3, 4, 5};
  using Kind = Sampled_part::Kind;
  if (source.kind == Kind::SHEET || target.kind == Kind::SHEET) return corners;
  return source.kind == Kind::CLOSED_CURVE || target.kind == Kind::CLOSED_CURVE ? all : ends;
}

} // namespace

const std::vector<int>& deform_to_fit(const Sampled_part& source, const Sampled_part& target)
{
  // A curve among sheets has e equal columns
  const bool sheets = source.kind == Sampled_part::Kind::SHEET || target.kind == Sampled_part::Kind::SHEET;
  const int from_lift = sheets && source.kind != Sampled_part::Kind::SHEET ? samples_per_side : 1;
  const int to_lift = sheets && target.kind != Sampled_part::Kind::SHEET ? samples_per_side : 1;
  const std::vector<int>& ends = extremities(source, target);
  using Ends = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, samples_per_side>;
  Ends from(3, Eigen::Index(ends.size())), to = from;
  for (Eigen::Index k = 0; k < from.cols(); ++k) {
    from.col(k) = source.samples.col(ends[std::size_t(k)] / from_lift) - source.centroid;
    to.col(k) = target.samples.col(ends[std::size_t(k)] / to_lift) - target.centroid;
  }
  const std::vector<int>* best = nullptr;
  long best_score = 0; // the sum of products: greatest where the sum of squared distances is least
  for (const std::vector<int>& candidate : orientations(source, target)) {
    double sum = 0;
    for (Eigen::Index k = 0; k < from.cols(); ++k) {
      const int end = candidate[std::size_t(ends[std::size_t(k)])]; // again one of the ends
      sum += from.col(k).dot(to.col(std::find(ends.begin(), ends.end(), end) - ends.begin()));
    }
    const long score = quantized(sum);
    if (!best || score > best_score) best = &candidate, best_score = score;
  }
  return *best;
}

} // namespace CGAL::Shape_correspondence
