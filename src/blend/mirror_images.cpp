// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/mirror_images.h"

#include "base/quantized.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Whether the mirror image of a box is near to another box.
bool are_mirror_images(const contacts::Box& box, const contacts::Box& other, double tolerance)
{
  const contacts::Box image = contacts::Box(mirrored(box.min())).extend(mirrored(box.max()));
  return (image.min() - other.min()).cwiseAbs().maxCoeff() <= tolerance &&
         (image.max() - other.max()).cwiseAbs().maxCoeff() <= tolerance;
}

} // namespace

double mirror_residual(const std::vector<const Points*>& surfaces, const Tree_pointers& trees)
{
  constexpr Eigen::Index samples = 24; // of a surface
  double sum = 0;
  int count = 0;
  std::size_t last = 0; // what is nearest to a point is likely to be that to the next one, too
  for (const Points* points : surfaces) {
    const Eigen::Index n = std::min(points->cols(), samples);
    for (Eigen::Index i = 0; i < n; ++i) {
      Point p = mirrored(Point(points->col(i * points->cols() / n))), nearest;
      std::size_t triangle;
      double squared = std::numeric_limits<double>::infinity();
      const auto improve = [&](std::size_t tree) {
        if (contacts::squared_distance(trees[tree]->box(), p) < squared &&
            trees[tree]->improve_nearest(p, nearest, squared, triangle))
          last = tree;
      };
      improve(last);
      for (std::size_t tree = 0; tree < trees.size(); ++tree)
        improve(tree);
      sum += squared;
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

/// Pairs of parts nearest to being mirror images of each other come first.
Mirror_images mirror_images(const std::vector<const Points*>& parts, const std::vector<contacts::Triangle_tree>& trees)
{
  constexpr double tolerance = 0.05; // of the height: how far a part is from the mirror image of another at most
  std::vector<std::tuple<Steps, std::size_t, std::size_t>> likely;
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = i; j < parts.size(); ++j) {
      if (!are_mirror_images(trees[i].box(), trees[j].box(), 2 * tolerance)) continue;
      const double distance =
          std::max(mirror_residual({parts[i]}, {&trees[j]}), mirror_residual({parts[j]}, {&trees[i]}));
      if (distance <= tolerance) likely.emplace_back(quantized(distance), i, j);
    }
  std::sort(likely.begin(), likely.end());
  Mirror_images result(parts.size());
  for (const auto& [distance, i, j] : likely)
    if (!result[i] && !result[j]) result[i] = j, result[j] = i;
  return result;
}

void add_mirrored(Part_pairs& pairs, const Mirror_images& source, const Mirror_images& target)
{
  for (std::size_t i = 0, count = pairs.size(); i < count; ++i) {
    const auto s = source[pairs[i].first], t = target[pairs[i].second];
    if (s && t) pairs.emplace_back(*s, *t);
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

} // namespace CGAL::Shape_correspondence::internal
