// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/spatial_graph.h"

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

Spatial_graph edge_graph(const Part_mesh& closed)
{
  Spatial_graph result;
  result.points = closed.points;
  for (Eigen::Index t = 0; t < closed.triangles.cols(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int a = closed.triangles(k, t), b = closed.triangles((k + 1) % 3, t);
      if (a < b) { // takes one of the two halfedges of every edge
        result.edges.emplace_back(a, b);
      }
    }
  }
  return result;
}

Spatial_graph_view::Spatial_graph_view(const Spatial_graph& graph)
    : points_(&graph.points), graph_(std::size_t(graph.points.cols()))
{
  for (const auto& [a, b] : graph.edges)
    if (a != b) add_edge(a, b);
}

void Spatial_graph_view::add_edge(int a, int b)
{
  const auto next = neighbours(a);
  if (std::find(next.begin(), next.end(), b) == next.end()) boost::add_edge(a, b, Edge{length(a, b)}, graph_);
}

void Spatial_graph_view::connect_near(double radius)
{
  std::vector<int> order(static_cast<std::size_t>(size()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [this](int a, int b) { return point(a).x() != point(b).x() ? point(a).x() < point(b).x() : a < b; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size() && point(order[j]).x() - point(order[i]).x() < radius; ++j)
      if (length(order[i], order[j]) < radius) add_edge(order[i], order[j]);
  }
}

std::vector<std::pair<int, int>> Spatial_graph_view::edges() const
{
  std::vector<std::pair<int, int>> result;
  for (int a = 0; a < size(); ++a) {
    for (const auto neighbour : neighbours(a)) {
      const int b = int(neighbour);
      if (a < b) result.emplace_back(a, b);
    }
  }
  return result;
}

double Spatial_graph_view::total_length() const
{
  double result = 0;
  for (const auto& [a, b] : edges())
    result += length(a, b);
  return result;
}

template <typename Length>
Spatial_graph_view::Shortest_paths Spatial_graph_view::shortest_paths(int source, const Length& length_of) const
{
  // (distance, vertex): of equally distant vertices, the one of lowest index comes first
  using Distance = std::pair<double, int>;
  const auto n = std::size_t(size());
  std::vector<Distance> distances(n);
  Shortest_paths result{Eigen::VectorXd(size()), std::vector<int>(n)};
  const auto index = boost::get(boost::vertex_index, graph_);
  const auto length_and_target = [&](auto edge) { return Distance(length_of(edge), int(boost::target(edge, graph_))); };
  using Descriptor = boost::graph_traits<decltype(graph_)>::edge_descriptor;
  boost::dijkstra_shortest_paths(
      graph_, source,
      boost::weight_map(boost::make_function_property_map<Descriptor>(length_and_target))
          .distance_map(boost::make_iterator_property_map(distances.begin(), index))
          .predecessor_map(boost::make_iterator_property_map(result.predecessors.begin(), index))
          .distance_compare(std::less<Distance>())
          .distance_combine(
              [](const Distance& d, const Distance& step) { return Distance(d.first + step.first, step.second); })
          .distance_inf(Distance(std::numeric_limits<double>::infinity(), -1))
          .distance_zero(Distance(0, -1)));
  for (int v = 0; v < size(); ++v)
    result.distances[v] = distances[std::size_t(v)].first;
  return result;
}

Eigen::VectorXd Spatial_graph_view::distances_from(int source) const
{
  return shortest_paths(source, [this](auto edge) { return graph_[edge].length; }).distances;
}

int Spatial_graph_view::farthest(const Eigen::VectorXd& distances) const
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

std::vector<int> Spatial_graph_view::path(int from, int to) const
{
  return path(shortest_paths(from, [this](auto edge) { return graph_[edge].length; }), from, to);
}

std::vector<int> Spatial_graph_view::path(int from, int to, const Edge_length& edge_length) const
{
  const auto length_of = [&](auto edge) {
    return edge_length(int(boost::source(edge, graph_)), int(boost::target(edge, graph_)));
  };
  return path(shortest_paths(from, length_of), from, to);
}

std::vector<int> Spatial_graph_view::path(const Shortest_paths& paths, int from, int to)
{
  if (!(paths.distances[to] < std::numeric_limits<double>::infinity())) return {};
  std::vector<int> result{to};
  while (result.back() != from)
    result.push_back(paths.predecessors[std::size_t(result.back())]);
  std::reverse(result.begin(), result.end());
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
