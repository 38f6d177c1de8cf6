// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "abstraction/spatial_graph.h"
#include "base/eigen_system.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// An embedding of a graph in space that approximates its geodesic distances: bent parts become straight.
struct Intrinsic_layout
{
  Points coordinates;      ///< one column for each vertex, in principal axes, longest first
  Eigen::Vector3d extents; ///< root mean square coordinates
};

/// Picks vertices far from each other: each is the farthest from those before, by geodesic distance.
/// \return one column for each landmark, the distances of all vertices from it
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
