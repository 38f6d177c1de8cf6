// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_ABSTRACTION_SPATIAL_GRAPH_H
#define CGAL_SHAPE_CORRESPONDENCE_ABSTRACTION_SPATIAL_GRAPH_H

#include <CGAL/Shape_correspondence/Points.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// A graph embedded in space: a curve skeleton, or a medial axis as far as a mesh's vertices and edges show it.
struct Spatial_graph
{
  Points points;
  std::vector<std::pair<int, int>> edges;
};

/// Adjacency, distances and paths of a graph whose vertices and edges can be removed.
class Spatial_graph_view
{
public:
  explicit Spatial_graph_view(const Spatial_graph& graph)
      : points_(&graph.points), neighbours_(static_cast<std::size_t>(graph.points.cols()))
  {
    for (const auto& [a, b] : graph.edges) {
      if (a != b && std::find(neighbours(a).begin(), neighbours(a).end(), b) == neighbours(a).end()) {
        neighbours_[static_cast<std::size_t>(a)].push_back(b);
        neighbours_[static_cast<std::size_t>(b)].push_back(a);
      }
    }
  }

  /// Joins all vertices that are nearer to each other than a radius. The two sides of a medial axis, as its poles show
  /// it, are connected at its rim only; this makes them one layer.
  void connect_near(double radius)
  {
    std::vector<int> order(neighbours_.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [this](int a, int b) { return point(a).x() != point(b).x() ? point(a).x() < point(b).x() : a < b; });
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t j = i + 1; j < order.size() && point(order[j]).x() - point(order[i]).x() < radius; ++j) {
        const int a = order[i], b = order[j];
        if (length(a, b) < radius && std::find(neighbours(a).begin(), neighbours(a).end(), b) == neighbours(a).end()) {
          neighbours_[static_cast<std::size_t>(a)].push_back(b);
          neighbours_[static_cast<std::size_t>(b)].push_back(a);
        }
      }
    }
  }

  int size() const { return static_cast<int>(neighbours_.size()); }
  Points::ConstColXpr point(int v) const { return points_->col(v); }
  const std::vector<int>& neighbours(int v) const { return neighbours_[static_cast<std::size_t>(v)]; }
  int degree(int v) const { return static_cast<int>(neighbours(v).size()); }
  double length(int a, int b) const { return (point(a) - point(b)).norm(); }

  void remove_edge(int a, int b)
  {
    const auto erase = [this](int from, int to) {
      auto& list = neighbours_[static_cast<std::size_t>(from)];
      list.erase(std::remove(list.begin(), list.end(), to), list.end());
    };
    erase(a, b);
    erase(b, a);
  }

  /// Edges as pairs a < b.
  std::vector<std::pair<int, int>> edges() const
  {
    std::vector<std::pair<int, int>> result;
    for (int a = 0; a < size(); ++a) {
      for (int b : neighbours(a)) {
        if (a < b) {
          result.emplace_back(a, b);
        }
      }
    }
    return result;
  }

  double total_length() const
  {
    double result = 0;
    for (const auto& [a, b] : edges()) {
      result += length(a, b);
    }
    return result;
  }

  /// Distances of all vertices along edges; infinite where there is no path.
  Eigen::VectorXd distances_from(int source) const
  {
    return distances_from(source, nullptr, [this](int a, int b) { return length(a, b); });
  }

  /// The same by Dijkstra's algorithm with other lengths of edges.
  template <typename Edge_length>
  Eigen::VectorXd distances_from(int source, std::vector<int>* parents, const Edge_length& edge_length) const
  {
    using Entry = std::pair<double, int>;
    Eigen::VectorXd result = Eigen::VectorXd::Constant(size(), std::numeric_limits<double>::infinity());
    if (parents) {
      parents->assign(static_cast<std::size_t>(size()), -1);
    }
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    result[source] = 0;
    queue.emplace(0., source);
    while (!queue.empty()) {
      const auto [distance, a] = queue.top();
      queue.pop();
      if (distance > result[a]) {
        continue;
      }
      for (int b : neighbours(a)) {
        const double candidate = distance + edge_length(a, b);
        if (candidate < result[b]) {
          result[b] = candidate;
          queue.emplace(candidate, b);
          if (parents) {
            (*parents)[static_cast<std::size_t>(b)] = a;
          }
        }
      }
    }
    return result;
  }

  /// The vertex of the largest finite distance, the first of several.
  int farthest(const Eigen::VectorXd& distances) const
  {
    int result = 0;
    double largest = -1;
    for (int v = 0; v < size(); ++v) {
      if (distances[v] > largest && distances[v] < std::numeric_limits<double>::infinity()) {
        largest = distances[v];
        result = v;
      }
    }
    return result;
  }

  /// The vertices of a shortest path; empty where there is none.
  std::vector<int> path(int from, int to) const
  {
    return path(from, to, [this](int a, int b) { return length(a, b); });
  }

  template <typename Edge_length>
  std::vector<int> path(int from, int to, const Edge_length& edge_length) const
  {
    std::vector<int> parents;
    if (!(distances_from(from, &parents, edge_length)[to] < std::numeric_limits<double>::infinity())) {
      return {};
    }
    std::vector<int> result{to};
    while (result.back() != from) {
      result.push_back(parents[static_cast<std::size_t>(result.back())]);
    }
    std::reverse(result.begin(), result.end());
    return result;
  }

private:
  const Points* points_;
  std::vector<std::vector<int>> neighbours_;
};

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_ABSTRACTION_SPATIAL_GRAPH_H
