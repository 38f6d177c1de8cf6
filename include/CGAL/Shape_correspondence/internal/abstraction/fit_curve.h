// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ABSTRACTION_FIT_CURVE_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ABSTRACTION_FIT_CURVE_H

#include <CGAL/Shape_correspondence/Part_abstraction.h>
#include <CGAL/Shape_correspondence/internal/Nearest_points.h>
#include <CGAL/Shape_correspondence/internal/abstraction/inside_test.h>
#include <CGAL/Shape_correspondence/internal/abstraction/spatial_graph.h>
#include <CGAL/Shape_correspondence/internal/curve_and_sheet_geometry.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// A curve taken from a skeleton.
struct Fitted_curve
{
  Curve curve;
  double coverage = 1;   ///< its length over the length of the pruned skeleton
  double residual = 0;   ///< root mean square distance of the skeleton's vertices from it
  bool free_ends = true; ///< of the pruned skeleton
};

/// From a leaf to the first vertex that is no link of a chain.
inline std::vector<int> leaf_chain(const Spatial_graph_view& graph, int leaf)
{
  std::vector<int> chain{leaf};
  int previous = -1, current = leaf;
  do {
    const auto& next = graph.neighbours(current);
    const int step = next[0] != previous || next.size() == 1 ? next[0] : next[1];
    previous = current;
    current = step;
    chain.push_back(current);
  } while (graph.degree(current) == 2);
  return chain;
}

inline double chain_length(const Spatial_graph_view& graph, const std::vector<int>& chain)
{
  double result = 0;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    result += graph.length(chain[i - 1], chain[i]);
  }
  return result;
}

/// The longest path, by a double sweep; exact on trees.
inline std::vector<int> longest_path(const Spatial_graph_view& graph)
{
  int start = 0;
  while (start + 1 < graph.size() && graph.degree(start) == 0) {
    ++start;
  }
  const int from = graph.farthest(graph.distances_from(start));
  return graph.path(from, graph.farthest(graph.distances_from(from)));
}

/// Removes the shortest twig as long as it is no longer than the part is thick there, or a tenth of the longest path.
inline void prune(Spatial_graph_view& graph, const Nearest_points& surface)
{
  const double smallest_fraction = 0.1, smallest_radii = 2;
  const double smallest_length = smallest_fraction * chain_length(graph, longest_path(graph));
  while (true) {
    std::vector<int> shortest;
    double least = std::numeric_limits<double>::infinity();
    for (int v = 0; v < graph.size(); ++v) {
      if (graph.degree(v) != 1) {
        continue;
      }
      const std::vector<int> chain = leaf_chain(graph, v);
      const double length = chain_length(graph, chain);
      const double radius = surface.distance(graph.point(chain.back()));
      if (graph.degree(chain.back()) > 2 && length < std::max(smallest_length, smallest_radii * radius) &&
          length < least) {
        least = length;
        shortest = chain;
      }
    }
    if (shortest.empty()) {
      return;
    }
    for (std::size_t i = 1; i < shortest.size(); ++i) {
      graph.remove_edge(shortest[i - 1], shortest[i]);
    }
  }
}

inline bool has_free_end(const Spatial_graph_view& graph)
{
  for (int v = 0; v < graph.size(); ++v) {
    if (graph.degree(v) == 1) {
      return true;
    }
  }
  return false;
}

/// The outer cycle of a graph without free ends; of a wheel the rim, not the way through the hub.
inline std::vector<int> outer_cycle(Spatial_graph_view graph)
{
  const std::vector<int> across = longest_path(graph);
  if (across.size() < 2) {
    return {};
  }
  Point centre = Point::Zero();
  int count = 0;
  for (int v = 0; v < graph.size(); ++v) {
    if (graph.degree(v) > 0) {
      centre += graph.point(v);
      ++count;
    }
  }
  centre /= count;
  const auto outwards = [&](int a, int b) {
    const double radius = std::max((0.5 * (graph.point(a) + graph.point(b)) - centre).norm(), 1e-9);
    return graph.length(a, b) / (radius * radius * radius);
  };
  std::vector<int> cycle = graph.path(across.front(), across.back(), outwards);
  for (std::size_t i = 1; i < cycle.size(); ++i) {
    graph.remove_edge(cycle[i - 1], cycle[i]);
  }
  const std::vector<int> back = graph.path(across.back(), across.front(), outwards);
  if (back.size() < 2 || cycle.size() + back.size() < 6) {
    return {};
  }
  cycle.insert(cycle.end(), back.begin() + 1, back.end() - 1);
  return cycle;
}

/// Averages neighbours; the ends of an open curve stay.
inline void smooth(Curve& curve, int rounds)
{
  const Eigen::Index n = curve.points.cols();
  for (int round = 0; round < rounds; ++round) {
    const Points before = curve.points;
    for (Eigen::Index i = curve.closed ? 0 : 1; i < (curve.closed ? n : n - 1); ++i) {
      curve.points.col(i) = 0.25 * before.col((i + n - 1) % n) + 0.5 * before.col(i) + 0.25 * before.col((i + 1) % n);
    }
  }
}

/// Lengthens an end of a curve in its direction up to the surface: the flow draws tips back by about half the width.
inline void extend_end(Curve& curve, bool last, double most, const Inside_test& is_inside)
{
  const int steps = 64;
  const Eigen::Index n = curve.points.cols();
  const Eigen::Index inner = std::min<Eigen::Index>(2, n - 1);
  const Eigen::Index end = last ? n - 1 : 0;
  const Point tip = curve.points.col(end);
  const Point direction = (tip - curve.points.col(last ? n - 1 - inner : inner)).normalized();
  if (!direction.allFinite()) {
    return;
  }
  int step = 0;
  while (step < steps && is_inside(tip + (step + 1) * (most / steps) * direction)) {
    ++step;
  }
  curve.points.col(end) = tip + step * (most / steps) * direction;
}

inline Curve to_curve(const Spatial_graph_view& graph, const std::vector<int>& path, bool closed)
{
  Curve result;
  result.closed = closed;
  result.points.resize(3, static_cast<Eigen::Index>(path.size()));
  for (std::size_t i = 0; i < path.size(); ++i) {
    result.points.col(static_cast<Eigen::Index>(i)) = graph.point(path[i]);
  }
  return result;
}

/// Resamples a raw path finely, smoothes, extends and resamples it to its control points.
inline Curve finish_curve(Curve curve, int control_points, const Inside_test& is_inside)
{
  const int rounds = 3;
  const double longest_extension = 0.2;
  curve.points = sample(curve, 4 * control_points);
  smooth(curve, rounds);
  if (!curve.closed) {
    const double most = longest_extension * arc_lengths(curve).back();
    extend_end(curve, false, most, is_inside);
    extend_end(curve, true, most, is_inside);
  }
  curve.points = sample(curve, control_points);
  return curve;
}

/// \param solid the closed mesh that the skeleton is of
inline Fitted_curve fit_curve(const Spatial_graph& skeleton, const Part_mesh& solid, int control_points)
{
  const Nearest_points surface(solid.points);
  Spatial_graph_view graph(skeleton);
  prune(graph, surface);
  Fitted_curve result;
  result.free_ends = has_free_end(graph);
  std::vector<int> path;
  if (!result.free_ends) {
    path = outer_cycle(graph);
  }
  const bool closed = !path.empty();
  if (!closed) {
    path = longest_path(graph);
  }
  if (path.size() < 2) {
    return result;
  }
  const Curve raw = to_curve(graph, path, closed);
  result.coverage = std::min(1., arc_lengths(raw).back() / graph.total_length());
  result.curve = finish_curve(raw, control_points, Inside_test(solid));
  double sum = 0;
  for (const auto& [a, b] : graph.edges()) {
    const Point middle = 0.5 * (graph.point(a) + graph.point(b));
    const Point nearest = result.curve(nearest_parameter_on_curve(result.curve, middle)[0]);
    sum += graph.length(a, b) * (nearest - middle).squaredNorm();
  }
  result.residual = std::sqrt(sum / graph.total_length());
  return result;
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ABSTRACTION_FIT_CURVE_H
