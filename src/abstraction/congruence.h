// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "abstraction/surface_samples.h"
#include "base/Nearest_points.h"
#include "base/eigen_system.h"
#include "base/generic_direction.h"
#include "shape/oriented_box.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A motion: x goes to linear * x + offset.
struct Motion
{
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Point offset = Point::Zero();

  Points operator()(const Points& points) const { return (linear * points).colwise() + offset; }
};

/// Invariants of a mesh under rigid motions and reflections, and its place and orientation. Aligned, since the order in
/// which Eigen adds, and so the last bit of a sum, depends on the alignment of its operands.
struct alignas(EIGEN_MAX_ALIGN_BYTES) Mesh_signature
{
  explicit Mesh_signature(const Part_mesh& mesh)
      : mesh(&mesh), centre(mesh.points.rowwise().mean()), area(surface_area(mesh))
  {
    const Points centred = mesh.points.colwise() - centre;
    moments = scatter_matrix(centred) / double(mesh.points.cols());
    const Eigen_system system = eigen_system(moments);
    principal_axes = system.vectors;
    lengths = system.values.cwiseMax(0.).cwiseSqrt();
    size = diagonal(mesh.points);
  }

  const Part_mesh* mesh;
  Point centre;
  double area;
  Eigen::Matrix3d moments;
  Eigen::Matrix3d principal_axes;
  Eigen::Vector3d lengths; ///< root mean square along the principal axes, shortest first
  double size;             ///< diagonal of the bounding box
};

inline bool may_be_congruent(const Mesh_signature& a, const Mesh_signature& b)
{
  const double tolerance = 1e-3; // over the area, and over the length
  return a.mesh->points.cols() == b.mesh->points.cols() && a.mesh->triangles.cols() == b.mesh->triangles.cols() &&
         std::abs(a.area - b.area) <= tolerance * a.area &&
         (a.lengths - b.lengths).cwiseAbs().maxCoeff() <= tolerance * a.lengths[2];
}

/// The linear parts of motions that may carry one mesh onto another: mirror images in the frame's axes, quarter turns
/// about the vertical, turns about it that carry the horizontal moments over, and all that carry the principal axes
/// over.
inline std::vector<Eigen::Matrix3d> candidate_motions(const Mesh_signature& from, const Mesh_signature& to)
{
  using Eigen::Matrix3d;
  const auto diagonal = [](double x, double y, double z) { return Matrix3d(Point(x, y, z).asDiagonal()); };
  const auto turn = [](double angle) { return Eigen::AngleAxisd(angle, Point::UnitY()).toRotationMatrix(); };
  std::vector<Matrix3d> result{diagonal(1, 1, 1), diagonal(-1, 1, 1), diagonal(1, 1, -1), diagonal(-1, 1, -1)};
  const auto quarter = double(0.5 * EIGEN_PI);
  for (const double sign : {1., -1.}) {
    result.push_back(turn(quarter) * diagonal(sign, 1, 1));
    result.push_back(turn(-quarter) * diagonal(sign, 1, 1));
  }
  const auto heading = [](const Mesh_signature& s) {
    return 0.5 * std::atan2(-2 * s.moments(0, 2), s.moments(0, 0) - s.moments(2, 2));
  };
  for (const double half_turn : {0., double(EIGEN_PI)}) {
    result.push_back(turn(heading(to) - heading(from) + half_turn));
    result.push_back(turn(heading(to) + heading(from) + half_turn) * diagonal(1, 1, -1));
  }
  for (int signs = 0; signs < 8; ++signs) {
    const auto sign = [signs](int axis) { return (signs >> axis) & 1 ? -1. : 1.; };
    result.push_back(to.principal_axes * diagonal(sign(0), sign(1), sign(2)) * from.principal_axes.transpose());
  }
  return result;
}

/// Whether a motion carries every vertex of one mesh to a vertex of another.
inline bool carries(const Motion& motion, const Mesh_signature& from, const Mesh_signature& to,
                    const Nearest_points& target)
{
  const double tolerance = 1e-3 * to.size;
  for (Eigen::Index v = 0; v < from.mesh->points.cols(); ++v)
    if (target.distance(motion.linear * from.mesh->points.col(v) + motion.offset) > tolerance) return false;
  return true;
}

/// The motion that carries a mesh onto another, if they are copies of each other.
inline std::optional<Motion> find_congruence(const Mesh_signature& from, const Mesh_signature& to,
                                             const Nearest_points& from_points, const Nearest_points& to_points)
{
  if (!may_be_congruent(from, to)) return std::nullopt;
  for (const Eigen::Matrix3d& linear : candidate_motions(from, to)) {
    const Motion motion{linear, to.centre - linear * from.centre};
    const Motion inverse{linear.transpose(), from.centre - linear.transpose() * to.centre};
    if (carries(motion, from, to, to_points) && carries(inverse, to, from, from_points)) return motion;
  }
  return std::nullopt;
}

/// The mesh that a mesh is a copy of, or itself, and the motion from there.
struct Congruence
{
  std::size_t original;
  Motion motion;
};

/// Lexicographic order of meshes in canonical form.
inline bool canonical_less(const Part_mesh& a, const Part_mesh& b)
{
  const auto points = [](const Part_mesh& m) {
    return std::make_pair(m.points.data(), m.points.data() + m.points.size());
  };
  const auto corners = [](const Part_mesh& m) {
    return std::make_pair(m.triangles.data(), m.triangles.data() + m.triangles.size());
  };
  const auto is_less = [](const auto& x, const auto& y) {
    return std::lexicographical_compare(x.first, x.second, y.first, y.second);
  };
  if (is_less(points(a), points(b)) || is_less(points(b), points(a))) return is_less(points(a), points(b));
  return is_less(corners(a), corners(b));
}

/// Classes of congruent meshes in canonical form. Which one of a class is the original depends on places, not on the
/// order.
/// \param comparable whether the meshes of two indices may be in one class
inline std::vector<Congruence> find_congruences(const std::vector<Part_mesh>& meshes,
                                                const std::function<bool(std::size_t, std::size_t)>& comparable)
{
  std::vector<Mesh_signature> signatures(meshes.begin(), meshes.end());
  std::vector<std::size_t> order(meshes.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto place = [&](std::size_t i) {
    // Along a direction, and on a coarse grid: noise must not decide between mirror images.
    return -std::round(1e4 * generic_direction().dot(signatures[i].centre));
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const double place_a = place(a), place_b = place(b);
    return place_a != place_b ? place_a < place_b : canonical_less(meshes[a], meshes[b]);
  });

  std::vector<Congruence> result(meshes.size());
  std::vector<std::size_t> originals;
  std::vector<std::unique_ptr<Nearest_points>> vertices(meshes.size());
  for (std::size_t i : order) {
    vertices[i] = std::make_unique<Nearest_points>(meshes[i].points);
    result[i].original = i;
    for (std::size_t original : originals) {
      if (!comparable(original, i)) continue;
      if (const auto motion = find_congruence(signatures[original], signatures[i], *vertices[original], *vertices[i])) {
        result[i] = {original, *motion};
        break;
      }
    }
    if (result[i].original == i) originals.push_back(i);
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
