// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "abstraction/curve_and_sheet_geometry.h"
#include "abstraction/inside_test.h"
#include "abstraction/spatial_graph.h"
#include "base/Nearest_points.h"

#include <CGAL/Shape_correspondence/Part_abstraction.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Least coverage (`Abstraction_report::coverage`) of a part that does not count as branching.
constexpr double least_coverage = 0.8;

/// A curve taken from a skeleton.
struct Fitted_curve
{
  Curve curve;
  double coverage = 1; ///< length of the curve over the length of the pruned skeleton
  double residual = 0; ///< root mean square distance of the skeleton from the curve, before `centre()`
};

/// The path from a leaf to the first vertex whose degree is not 2.
inline std::vector<int> leaf_chain(const Spatial_graph_view& graph, int leaf)
{
  std::vector<int> chain{leaf};
  int previous = -1, current = leaf;
  do {
    const auto next = graph.neighbours(current).begin();
    const int first = int(next[0]);
    const int step = first != previous || graph.degree(current) == 1 ? first : int(next[1]);
    previous = current;
    current = step;
    chain.push_back(current);
  } while (graph.degree(current) == 2);
  return chain;
}

inline double chain_length(const Spatial_graph_view& graph, const std::vector<int>& chain)
{
  double result = 0;
  for (std::size_t i = 1; i < chain.size(); ++i)
    result += graph.length(chain[i - 1], chain[i]);
  return result;
}

/// The longest shortest path, by a double sweep; exact on trees.
inline std::vector<int> longest_path(const Spatial_graph_view& graph)
{
  int start = 0;
  while (start + 1 < graph.size() && graph.degree(start) == 0)
    ++start;
  const int from = graph.farthest(graph.distances_from(start));
  return graph.path(from, graph.farthest(graph.distances_from(from)));
}

/// Removes twigs, the shortest first, as long as they are shorter than the part is thick at the branching, or
/// than a tenth of the longest path.
inline void prune(Spatial_graph_view& graph, const Nearest_points& surface)
{
  const double smallest_fraction = 0.1; // least length of a twig that stays, over that of the longest path
  const double smallest_radii = 2;      // least length, over the distance of the surface from the branching
  const double smallest_length = smallest_fraction * chain_length(graph, longest_path(graph));
  while (true) {
    std::vector<int> shortest;
    double least = std::numeric_limits<double>::infinity();
    for (int v = 0; v < graph.size(); ++v) {
      if (graph.degree(v) != 1) continue;
      const std::vector<int> chain = leaf_chain(graph, v);
      const double length = chain_length(graph, chain);
      const double radius = surface.distance(graph.point(chain.back()));
      if (graph.degree(chain.back()) > 2 && length < std::max(smallest_length, smallest_radii * radius) &&
          length < least) {
        least = length;
        shortest = chain;
      }
    }
    if (shortest.empty()) return;
    for (std::size_t i = 1; i < shortest.size(); ++i)
      graph.remove_edge(shortest[i - 1], shortest[i]);
  }
}

inline bool has_free_end(const Spatial_graph_view& graph)
{
  for (int v = 0; v < graph.size(); ++v)
    if (graph.degree(v) == 1) return true;
  return false;
}

/// The outer cycle of a graph without free ends; for a wheel, the rim and not the path through the hub.
inline std::vector<int> outer_cycle(Spatial_graph_view graph)
{
  const std::vector<int> across = longest_path(graph);
  if (across.size() < 2) return {};
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
  for (std::size_t i = 1; i < cycle.size(); ++i)
    graph.remove_edge(cycle[i - 1], cycle[i]);
  const std::vector<int> back = graph.path(across.back(), across.front(), outwards);
  if (back.size() < 2 || cycle.size() + back.size() < 6) return {};
  cycle.insert(cycle.end(), back.begin() + 1, back.end() - 1);
  return cycle;
}

/// Averages neighbouring points; the ends of an open curve are fixed.
inline void smooth(Curve& curve, int rounds)
{
  const Eigen::Index n = curve.points.cols();
  for (int round = 0; round < rounds; ++round) {
    const Points before = curve.points;
    for (Eigen::Index i = curve.closed ? 0 : 1; i < (curve.closed ? n : n - 1); ++i)
      curve.points.col(i) = 0.25 * before.col((i + n - 1) % n) + 0.5 * before.col(i) + 0.25 * before.col((i + 1) % n);
  }
}

/// Extends an end of a curve along its tangent up to the surface: the flow shortens tips by about half the width.
inline void extend_end(Curve& curve, bool last, const Nearest_points& surface, const Inside_test& is_inside)
{
  const int steps = 64;
  const double most_lengths = 0.2; // longest extension, over the length of the curve
  const double most_radii = 2;     // longest extension, over the distance of the surface near the end
  const Eigen::Index n = curve.points.cols();
  const Eigen::Index end = last ? n - 1 : 0;
  const Eigen::Index inner = last ? std::max<Eigen::Index>(n - 3, 0) : std::min<Eigen::Index>(2, n - 1);
  const Point tip = curve.points.col(end);
  const Point direction = (tip - curve.points.col(inner)).normalized();
  if (!direction.allFinite()) return;
  const double most =
      std::max(most_lengths * arc_lengths(curve).back(), most_radii * surface.distance(curve.points.col(inner)));
  int step = 0;
  while (step < steps && is_inside(tip + (step + 1) * (most / steps) * direction))
    ++step;
  curve.points.col(end) = tip + step * (most / steps) * direction;
}

inline Curve to_curve(const Spatial_graph_view& graph, const std::vector<int>& path, bool closed)
{
  Curve result;
  result.closed = closed;
  result.points.resize(3, Eigen::Index(path.size()));
  for (std::size_t i = 0; i < path.size(); ++i)
    result.points.col(Eigen::Index(i)) = graph.point(path[i]);
  return result;
}

/// The total turning angle of a curve; 2 π for a ring.
inline double turning(const Curve& curve)
{
  const Eigen::Index n = curve.points.cols();
  double result = 0;
  for (Eigen::Index i = curve.closed ? 0 : 1; i < (curve.closed ? n : n - 1); ++i) {
    const Point before = curve.points.col(i) - curve.points.col((i + n - 1) % n);
    const Point after = curve.points.col((i + 1) % n) - curve.points.col(i);
    result += std::atan2(before.cross(after).norm(), before.dot(after));
  }
  return result;
}

inline Curve smoothed(const Curve& raw, int samples)
{
  const int rounds = 3;
  Curve result{sample(raw, samples), raw.closed};
  smooth(result, rounds);
  return result;
}

/// Moves the points of a curve, at right angles to it, to the means of the medial points nearest to them, without those
/// that are much farther from the curve than from the surface. \param axis the medial poles of the surface's points
inline void centre(Curve& curve, const Points& axis, const Points& surface)
{
  const int rounds = 3;
  const double reach = 1.5; // greatest distance of medial points from the curve, over that from the surface
  const Eigen::Index n = curve.points.cols();
  Curve offsets{Points::Zero(3, n), curve.closed};
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(n);
  for (Eigen::Index v = 0; v < axis.cols(); ++v) {
    Eigen::Index nearest = 0;
    const double squared = (curve.points.colwise() - axis.col(v)).colwise().squaredNorm().minCoeff(&nearest);
    if (std::sqrt(squared) < reach * (axis.col(v) - surface.col(v)).norm()) {
      offsets.points.col(nearest) += axis.col(v) - curve.points.col(nearest);
      ++counts[nearest];
    }
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index before = curve.closed ? (i + n - 1) % n : std::max<Eigen::Index>(i - 1, 0);
    const Eigen::Index after = curve.closed ? (i + 1) % n : std::min(i + 1, n - 1);
    const Point direction = (curve.points.col(after) - curve.points.col(before)).normalized();
    const Point offset = offsets.points.col(i) / std::max(counts[i], 1.);
    offsets.points.col(i) = offset - direction.dot(offset) * direction;
  }
  smooth(offsets, rounds);
  curve.points += offsets.points;
}

/// Root mean square distance of a skeleton from a curve.
inline double skeleton_residual(const Spatial_graph_view& graph, const Curve& curve)
{
  double sum = 0;
  for (const auto& [a, b] : graph.edges()) {
    const Point middle = 0.5 * (graph.point(a) + graph.point(b));
    const Point nearest = curve(nearest_parameter_on_curve(curve, middle)[0]);
    sum += graph.length(a, b) * (nearest - middle).squaredNorm();
  }
  return std::sqrt(sum / graph.total_length());
}

/// The path that represents a pruned skeleton: the outer cycle, or the longest path if there is none.
inline Curve main_path(const Spatial_graph_view& graph)
{
  const std::vector<int> cycle = has_free_end(graph) ? std::vector<int>() : outer_cycle(graph);
  return cycle.empty() ? to_curve(graph, longest_path(graph), false) : to_curve(graph, cycle, true);
}

/// A path of a skeleton, smoothed and finely sampled.
struct Skeleton_path
{
  Fitted_curve fitted;
  int turns = 0; ///< number of full turns that the curve makes
};

/// The number of control points of a curve with some full turns, since few segments would cut corners.
inline int number_of_points(int control_points, int turns) { return control_points * (1 + turns); }

/// Prunes a skeleton and takes its main path. \return an empty curve if nothing is left
inline Skeleton_path skeleton_path(const Spatial_graph& skeleton, const Nearest_points& surface, int control_points)
{
  const int samples = 4;     // samples of the path for each control point
  const double nearly = 0.1; // share of a full turn that a curve may lack to count as making it
  Spatial_graph_view graph(skeleton);
  prune(graph, surface);
  Skeleton_path result;
  const Curve path = main_path(graph);
  if (path.points.cols() < 2) return result;
  result.fitted.coverage = std::min(1., arc_lengths(path).back() / graph.total_length());
  Curve& curve = result.fitted.curve;
  curve = smoothed(path, samples * control_points);
  const double angle = turning({sample(curve, control_points), path.closed});
  result.turns = int(angle / (2 * EIGEN_PI) + nearly);
  if (result.turns > 0) curve = smoothed(path, samples * number_of_points(control_points, result.turns));
  result.fitted.residual = skeleton_residual(graph, curve);
  return result;
}

/// The smoothed main path of a skeleton, neither extended to the surface nor centred. \param solid the closed part
inline Fitted_curve skeleton_curve(const Spatial_graph& skeleton, const Part_mesh& solid, int control_points)
{
  auto [result, turns] = skeleton_path(skeleton, Nearest_points(solid.points), control_points);
  if (result.curve.points.cols() > 0)
    result.curve.points = sample(result.curve, number_of_points(control_points, turns));
  return result;
}

/// The curve of a skeleton, extended to the surface and, if it is bent, moved to the middle of the medial axis.
/// \param axis the medial poles of the vertices of `solid`
inline Fitted_curve fit_curve(const Spatial_graph& skeleton, const Points& axis, const Part_mesh& solid,
                              int control_points)
{
  const Nearest_points surface(solid.points);
  auto [result, turns] = skeleton_path(skeleton, surface, control_points);
  Curve& curve = result.curve;
  if (curve.points.cols() == 0) return result;
  if (turns > 0) { // the flow pulls bends inwards
    centre(curve, axis, solid.points);
  }
  if (!curve.closed) {
    const Inside_test is_inside(solid);
    extend_end(curve, false, surface, is_inside);
    extend_end(curve, true, surface, is_inside);
  }
  curve.points = sample(curve, number_of_points(control_points, turns));
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
