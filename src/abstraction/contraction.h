// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "abstraction/inside_test.h"
#include "abstraction/skeletonize.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A closed mesh on its way to its skeleton.
struct Contracting_mesh
{
  Part_mesh mesh;
  Points poles;            ///< a vertex's point of the medial axis; not finite where there is none
  std::vector<char> fixed; ///< vertices that have become part of the skeleton
};

/// The cotangent of the angle at `a`, at least 0 and less than that of three degrees.
inline double clamped_cotangent(const Point& a, const Point& b, const Point& c)
{
  const double most = 0.999;
  const double lengths = (b - a).norm() * (c - a).norm();
  if (!(lengths > 0)) return 0;
  const double cosine = std::clamp((b - a).dot(c - a) / lengths, 0., most);
  return cosine / std::sqrt(1 - cosine * cosine);
}

/// The vertices that a step moves, by number; -1: not moved.
struct Moved_vertices
{
  explicit Moved_vertices(const Contracting_mesh& input) : number(std::size_t(input.mesh.points.cols()), -1)
  {
    for (std::size_t v = 0; v < number.size(); ++v)
      number[v] = input.fixed[v] ? -1 : count++;
  }

  int operator[](Eigen::Index vertex) const { return number[std::size_t(vertex)]; }

  std::vector<int> number;
  int count = 0;
};

using System_matrix = Eigen::SparseMatrix<double>;

/// The cotangent Laplacians of the moved vertices: `matrix` times their positions, plus `known` from fixed vertices.
struct Laplacian
{
  System_matrix matrix;
  Eigen::MatrixX3d known;
};

inline Laplacian laplacian_of(const Part_mesh& mesh, const Moved_vertices& moved)
{
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(std::size_t(12 * mesh.triangles.cols()));
  Laplacian result{System_matrix(moved.count, moved.count), Eigen::MatrixX3d::Zero(moved.count, 3)};
  const auto connect = [&](int row, int to, double w) {
    entries.emplace_back(row, row, -w);
    if (moved[to] >= 0)
      entries.emplace_back(row, moved[to], w);
    else
      result.known.row(row) += w * mesh.points.col(to).transpose();
  };
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.triangles(k, t), b = mesh.triangles((k + 1) % 3, t), c = mesh.triangles((k + 2) % 3, t);
      const double w = clamped_cotangent(mesh.points.col(a), mesh.points.col(b), mesh.points.col(c));
      for (const auto& [from, to] : {std::array<int, 2>{b, c}, std::array<int, 2>{c, b}})
        if (moved[from] >= 0) connect(moved[from], to, w);
    }
  }
  result.matrix.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// Adds the terms w_H and w_P, which attract vertices to their old positions and poles, to the normal equations.
inline void add_attraction(const Contracting_mesh& input, const Flow_weights& weights, const Moved_vertices& moved,
                           System_matrix& normal_matrix, Eigen::MatrixX3d& right)
{
  const Inside_test is_inside(input.mesh);
  Eigen::VectorXd diagonal(moved.count);
  for (Eigen::Index v = 0; v < input.mesh.points.cols(); ++v) {
    const int i = moved[v];
    if (i < 0) continue;
    const double place = weights.velocity * weights.velocity;
    diagonal[i] = place;
    right.row(i) += place * input.mesh.points.col(v).transpose();
    const Point pole = input.poles.col(v);
    if (pole.allFinite() && is_inside(pole)) {
      const double medial = weights.medial * weights.medial;
      diagonal[i] += medial;
      right.row(i) += medial * pole.transpose();
    }
  }
  for (int i = 0; i < moved.count; ++i)
    normal_matrix.coeffRef(i, i) += diagonal[i];
}

/// One implicit step of the flow: the new positions minimise the squared cotangent Laplacians plus the weighted squared
/// distances from the old positions and from the poles that are inside. CGAL's step solves the same equations, but with
/// poles from an exact Voronoi diagram, each of which it tests twice a step (`benchmark_abstraction` has both).
inline Points contracted(const Contracting_mesh& input, const Flow_weights& weights)
{
  Points result = input.mesh.points;
  const Moved_vertices moved(input);
  if (moved.count == 0) return result;
  const Laplacian laplacian = laplacian_of(input.mesh, moved);
  System_matrix normal_matrix = laplacian.matrix.transpose() * laplacian.matrix;
  Eigen::MatrixX3d right = -(laplacian.matrix.transpose() * laplacian.known);
  add_attraction(input, weights, moved, normal_matrix, right);
  const Eigen::SimplicialLDLT<System_matrix> solver(normal_matrix);
  const Eigen::MatrixX3d solution = solver.solve(right);
  if (solver.info() != Eigen::Success || !solution.allFinite())
    throw Flow_failure("the equations of the flow have no solution");
  for (Eigen::Index v = 0; v < result.cols(); ++v)
    if (moved[v] >= 0) result.col(v) = solution.row(moved[v]).transpose();
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
