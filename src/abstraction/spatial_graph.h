// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/range/iterator_range.hpp>

#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A graph embedded in space: a curve skeleton, or a medial axis sampled by the vertices and edges of a mesh.
struct Spatial_graph
{
  Points points;
  std::vector<std::pair<int, int>> edges;
};

Spatial_graph edge_graph(const Part_mesh& closed);

/// Adjacency, distances and paths of a graph whose edges can be removed.
class Spatial_graph_view
{
public:
  using Edge_length = std::function<double(int, int)>;

  explicit Spatial_graph_view(const Spatial_graph& graph);

  /// Joins all pairs of vertices closer than a radius. The poles of a mesh sample a medial sheet twice, connected only
  /// at its rim; this joins the two copies.
  void connect_near(double radius);

  int size() const { return int(boost::num_vertices(graph_)); }
  Points::ConstColXpr point(int v) const { return points_->col(v); }
  /// The adjacent vertices, a range of `int` in the order in which edges were added.
  auto neighbours(int v) const { return boost::make_iterator_range(boost::adjacent_vertices(v, graph_)); }
  int degree(int v) const { return int(boost::out_degree(v, graph_)); }
  double length(int a, int b) const { return (point(a) - point(b)).norm(); }

  void remove_edge(int a, int b) { boost::remove_edge(a, b, graph_); }

  /// Edges as pairs a < b, ordered by a.
  std::vector<std::pair<int, int>> edges() const;

  double total_length() const;

  /// Distances of all vertices along edges; infinite for unreachable ones.
  Eigen::VectorXd distances_from(int source) const;

  /// The vertex of the largest finite distance, the first of several.
  int farthest(const Eigen::VectorXd& distances) const;

  /// The vertices of a shortest path; empty if there is none.
  std::vector<int> path(int from, int to) const;
  /// A shortest path by other lengths of edges.
  std::vector<int> path(int from, int to, const Edge_length& edge_length) const;

private:
  struct Shortest_paths
  {
    Eigen::VectorXd distances;     ///< infinite for unreachable vertices
    std::vector<int> predecessors; ///< the vertex itself for the source and for unreachable vertices
  };

  static std::vector<int> path(const Shortest_paths& paths, int from, int to);

  void add_edge(int a, int b);
  template <typename Length>
  Shortest_paths shortest_paths(int source, const Length& length_of) const;

  struct Edge
  {
    double length = 0;
  };

  const Points* points_;
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property, Edge> graph_;
};

} // namespace CGAL::Shape_correspondence::internal
