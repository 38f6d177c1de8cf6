// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ABSTRACTION_CONTRACTION_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ABSTRACTION_CONTRACTION_H

#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/internal/abstraction/deadline.h>
#include <CGAL/Shape_correspondence/internal/abstraction/inside_test.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// A closed mesh on its way to its skeleton.
struct Contracting_mesh
{
  Part_mesh mesh;
  Points poles;            ///< a vertex's point of the medial axis; not finite where there is none
  std::vector<char> fixed; ///< vertices that have become part of the skeleton
};

/// Weights of the flow (Tagliasacchi et al. 2012): w_H keeps a vertex in place, w_P draws it to its pole.
struct Flow_weights
{
  double velocity = 0.1; ///< w_H
  double medial = 0.2;   ///< w_P
};

/// The cotangent of the angle at `a`, at least 0 and less than that of three degrees.
inline double clamped_cotangent(const Point& a, const Point& b, const Point& c)
{
  const double most = 0.999;
  const double lengths = (b - a).norm() * (c - a).norm();
  if (!(lengths > 0)) {
    return 0;
  }
  const double cosine = std::clamp((b - a).dot(c - a) / lengths, 0., most);
  return cosine / std::sqrt(1 - cosine * cosine);
}

/// One implicit step of the flow: the vertices' new places minimise the squared Laplacians, with cotangent weights,
/// plus the squared distances from their old places and from their poles, as long as those are inside. The library's
/// own step gives the same but takes far longer: it computes poles by an exact Voronoi diagram and tests each twice a
/// step.
inline Points contracted(const Contracting_mesh& input, const Flow_weights& weights)
{
  const Part_mesh& mesh = input.mesh;
  const Eigen::Index n = mesh.points.cols();
  std::vector<int> unknown(static_cast<std::size_t>(n), -1);
  int unknowns = 0;
  for (std::size_t v = 0; v < unknown.size(); ++v) {
    unknown[v] = input.fixed[v] ? -1 : unknowns++;
  }
  if (unknowns == 0) {
    return mesh.points;
  }
  std::vector<Eigen::Triplet<double>> laplacian;
  laplacian.reserve(static_cast<std::size_t>(12 * mesh.triangles.cols()));
  Eigen::MatrixX3d known = Eigen::MatrixX3d::Zero(unknowns, 3);
  const auto connect = [&](int row, int to, double w) {
    laplacian.emplace_back(row, row, -w);
    if (unknown[static_cast<std::size_t>(to)] >= 0) {
      laplacian.emplace_back(row, unknown[static_cast<std::size_t>(to)], w);
    } else {
      known.row(row) += w * mesh.points.col(to).transpose();
    }
  };
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.triangles(k, t), b = mesh.triangles((k + 1) % 3, t), c = mesh.triangles((k + 2) % 3, t);
      const double w = clamped_cotangent(mesh.points.col(a), mesh.points.col(b), mesh.points.col(c));
      for (const auto& [from, to] : {std::array<int, 2>{b, c}, std::array<int, 2>{c, b}}) {
        if (unknown[static_cast<std::size_t>(from)] >= 0) {
          connect(unknown[static_cast<std::size_t>(from)], to, w);
        }
      }
    }
  }
  using Matrix = Eigen::SparseMatrix<double>;
  Matrix system(unknowns, unknowns);
  system.setFromTriplets(laplacian.begin(), laplacian.end());
  Matrix normal_matrix = system.transpose() * system;
  Eigen::MatrixX3d right = -(system.transpose() * known);

  const Inside_test is_inside(mesh);
  Eigen::VectorXd diagonal(unknowns);
  for (Eigen::Index v = 0; v < n; ++v) {
    const int i = unknown[static_cast<std::size_t>(v)];
    if (i < 0) {
      continue;
    }
    const double place = weights.velocity * weights.velocity;
    diagonal[i] = place;
    right.row(i) += place * mesh.points.col(v).transpose();
    const Point pole = input.poles.col(v);
    if (pole.allFinite() && is_inside(pole)) {
      const double medial = weights.medial * weights.medial;
      diagonal[i] += medial;
      right.row(i) += medial * pole.transpose();
    }
  }
  for (int i = 0; i < unknowns; ++i) {
    normal_matrix.coeffRef(i, i) += diagonal[i];
  }
  const Eigen::SimplicialLDLT<Matrix> solver(normal_matrix);
  const Eigen::MatrixX3d solution = solver.solve(right);
  if (solver.info() != Eigen::Success || !solution.allFinite()) {
    throw Flow_failure("the equations of the flow have no solution");
  }
  Points result = mesh.points;
  for (Eigen::Index v = 0; v < n; ++v) {
    if (unknown[static_cast<std::size_t>(v)] >= 0) {
      result.col(v) = solution.row(unknown[static_cast<std::size_t>(v)]).transpose();
    }
  }
  return result;
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ABSTRACTION_CONTRACTION_H
