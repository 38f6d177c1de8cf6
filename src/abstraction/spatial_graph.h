// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/eigen_system.h"

#include <CGAL/Shape_correspondence/Points.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <Eigen/Eigenvalues>
#include <boost/graph/adjacency_list.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
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
  /// The vertices of a shortest path if edges have the given lengths.
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

/// An embedding of a graph in space that approximates its geodesic distances: bent parts become straight.
struct Intrinsic_layout
{
  Points coordinates;      ///< one column for each vertex, in principal axes, longest first
  Eigen::Vector3d extents; ///< root mean square of the coordinates along each axis
};

/// Picks vertices far from each other: each is the farthest from those before, by geodesic distance.
/// \param chosen gets the vertices \return for each of them, a column of the distances of all vertices from it
inline Eigen::MatrixXd landmark_distances(const Spatial_graph_view& graph, int landmarks, std::vector<int>& chosen)
{
  Eigen::MatrixXd result(graph.size(), landmarks);
  int next = graph.farthest(graph.distances_from(0));
  Eigen::VectorXd nearest;
  for (int k = 0; k < landmarks; ++k) {
    chosen.push_back(next);
    result.col(k) = graph.distances_from(next);
    nearest = k == 0 ? Eigen::VectorXd(result.col(0)) : Eigen::VectorXd(nearest.cwiseMin(result.col(k)));
    next = graph.farthest(nearest);
  }
  return result;
}

/// Landmark multidimensional scaling (de Silva and Tenenbaum 2004) in three dimensions.
/// \pre the graph is connected
inline Intrinsic_layout intrinsic_layout(const Spatial_graph_view& graph)
{
  const int landmarks = std::min(24, graph.size());
  std::vector<int> chosen;
  const Eigen::MatrixXd squared = landmark_distances(graph, landmarks, chosen).array().square();
  Eigen::MatrixXd between(landmarks, landmarks);
  for (int k = 0; k < landmarks; ++k)
    between.row(k) = squared.row(chosen[std::size_t(k)]);
  between = (0.5 * (between + between.transpose())).eval();
  const Eigen::VectorXd mean = between.colwise().mean();
  Eigen::MatrixXd gram = between;
  gram.colwise() -= mean;
  gram.rowwise() -= mean.transpose();
  gram.array() += mean.mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(-0.5 * gram);

  Intrinsic_layout result;
  result.coordinates = Points::Zero(3, graph.size());
  for (int d = 0; d < std::min(3, landmarks); ++d) {
    const double value = solver.eigenvalues()[landmarks - 1 - d];
    if (value > 1e-12 * solver.eigenvalues()[landmarks - 1]) {
      const Eigen::VectorXd direction = solver.eigenvectors().col(landmarks - 1 - d) / std::sqrt(value);
      result.coordinates.row(d) = -0.5 * ((squared.rowwise() - mean.transpose()) * direction).transpose();
    }
  }
  result.coordinates.colwise() -= result.coordinates.rowwise().mean().eval();
  const Eigen_system principal = eigen_system(scatter_matrix(result.coordinates) / graph.size());
  result.coordinates = (principal.vectors.rowwise().reverse().transpose() * result.coordinates).eval();
  result.extents = principal.values.reverse().cwiseMax(0.).cwiseSqrt();
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
