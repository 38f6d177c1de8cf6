// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "structure/align_shapes.h"
#include "unit_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Shape_correspondence::peers {

/// A part of a template: mean and variance of the placements in unit boxes of the parts that it labels.
struct Template_part
{
  Eigen::Array<double, 6, 1> mean, variance; ///< middle and extents of a box
};

inline Eigen::Array<double, 6, 1> placement(const Eigen::AlignedBox3d& box)
{
  Eigen::Array<double, 6, 1> result;
  result << box.center().array(), box.diagonal().array();
  return result;
}

/// Negative logarithm of the probability density of a placement, up to a constant.
inline double misfit(const Template_part& part, const Eigen::Array<double, 6, 1>& placement)
{
  return ((placement - part.mean).square() / part.variance + part.variance.log()).sum() / 2;
}

inline std::size_t best_template_part(const std::vector<Template_part>& parts, const Eigen::AlignedBox3d& box)
{
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const double value = misfit(parts[k], placement(box));
    if (value < least) least = value, best = k;
  }
  return best;
}

/// V. G. Kim et al., *Learning part-based templates from large collections of 3D shapes*, 2013: a template of boxes is
/// fitted to all shapes of a collection and learns how its boxes vary; parts that it labels alike correspond.
/// Simplified: it is one template, it starts from the boxes of the shape with the median number of parts, whole parts
/// are labelled instead of points, and shapes are aligned by their frames.
inline std::vector<Part_pairs> match_kim_2013(const std::vector<Structural_graph>& graphs,
                                              const std::vector<Shape_pair>& pairs)
{
  constexpr double first_variance = 0.01, least_variance = 0.0025;
  constexpr int rounds = 10;
  std::vector<Boxed_shape> shapes;
  std::vector<std::pair<std::size_t, std::size_t>> by_size; // number of parts, index of shape
  for (const Structural_graph& graph : graphs) {
    by_size.emplace_back(structure(graph).parts.size(), shapes.size());
    shapes.push_back(boxed(graph, alignment_turns(structure(graphs[0]).frame, structure(graph).frame).front()));
  }
  std::nth_element(by_size.begin(), by_size.begin() + std::ptrdiff_t(by_size.size() / 2), by_size.end());
  std::vector<Template_part> parts;
  for (const Eigen::AlignedBox3d& box : shapes[by_size[by_size.size() / 2].second].boxes)
    parts.push_back({placement(box), Eigen::Array<double, 6, 1>::Constant(first_variance)});

  std::vector<std::vector<std::size_t>> labels(shapes.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t s = 0; s < shapes.size(); ++s) {
      labels[s].clear();
      for (const Eigen::AlignedBox3d& box : shapes[s].boxes)
        labels[s].push_back(best_template_part(parts, box));
    }
    for (std::size_t k = 0; k < parts.size(); ++k) {
      Eigen::Array<double, 6, 1> sum = Eigen::Array<double, 6, 1>::Zero(), squares = sum;
      double n = 0;
      for (std::size_t s = 0; s < shapes.size(); ++s)
        for (std::size_t i = 0; i < labels[s].size(); ++i) {
          if (labels[s][i] != k) continue;
          sum += placement(shapes[s].boxes[i]);
          squares += placement(shapes[s].boxes[i]).square();
          ++n;
        }
      if (n == 0) continue;
      parts[k].mean = sum / n;
      parts[k].variance = (squares / n - parts[k].mean.square()).max(least_variance);
    }
  }
  std::vector<Part_pairs> result;
  for (const auto& [s, t] : pairs) {
    Part_pairs matched;
    for (std::size_t i = 0; i < labels[s].size(); ++i)
      for (std::size_t j = 0; j < labels[t].size(); ++j)
        if (labels[s][i] == labels[t][j]) matched.emplace_back(i, j);
    result.push_back(matched);
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::peers
