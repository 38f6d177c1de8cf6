// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/directions.h"
#include "base/eigen_system.h"
#include "shape/Triangle_tree.h"
#include "shape/oriented_box.h"
#include "shape/triangle_distance.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The affine map x → linear * x + offset, a rigid motion or reflection.
struct Motion
{
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Point offset = Point::Zero();

  Points operator()(const Points& points) const { return (linear * points).colwise() + offset; }
};

/// Invariants of a surface under rigid motions and reflections, with its centre and principal axes. They are exact
/// integrals, independent of the triangulation of flat faces. Aligned, since the order in which Eigen adds, and thus
/// the last bit of a sum, depends on the alignment of its operands.
struct alignas(EIGEN_MAX_ALIGN_BYTES) Mesh_signature
{
  explicit Mesh_signature(const Part_mesh& mesh) : mesh(&mesh), size(diagonal(mesh.points))
  {
    const Point origin = mesh.points.col(0);
    for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
      const contacts::Triangle corners = triangle_of(mesh, t);
      const double twice = contacts::area_vector(corners).norm();
      area += twice / 2;
      centre += twice / 2 * (contacts::centre(corners) - origin);
      for (const Point& corner :
           {corners[0], corners[1], corners[2], Point(3 * contacts::centre(corners) - 2 * origin)})
        moments += twice / 24 * (corner - origin) * (corner - origin).transpose();
    }
    if (area > 0) {
      centre /= area;
      moments = moments / area - centre * centre.transpose();
    }
    centre += origin;
    const Eigen_system system = eigen_system(moments);
    principal_axes = system.vectors;
    lengths = system.values.cwiseMax(0.).cwiseSqrt();
  }

  const Part_mesh* mesh;
  double size; ///< diagonal of the bounding box
  double area = 0;
  Point centre = Point::Zero();
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d principal_axes;
  Eigen::Vector3d lengths; ///< root mean square distances from the centre along the principal axes, least first
};

inline bool may_be_congruent(const Mesh_signature& a, const Mesh_signature& b)
{
  const double tolerance = 1e-3; // largest difference of areas, over the area, and of lengths, over the greatest
  return std::abs(a.area - b.area) <= tolerance * a.area &&
         (a.lengths - b.lengths).cwiseAbs().maxCoeff() <= tolerance * a.lengths[2];
}

/// Orthonormal axes, the first along the first vector, the second in the plane of both.
inline Eigen::Matrix3d axes_of_two(const Point& first, const Point& second)
{
  Eigen::Matrix3d result;
  result.col(0) = first.normalized();
  result.col(2) = first.cross(second).normalized();
  result.col(1) = result.col(2).cross(result.col(0));
  return result;
}

/// Adds motions that map two corners, the outermost one and the one farthest from the line to it, to corners of `to` at
/// the same distances. They are needed where two lengths are equal, so that the principal axes are arbitrary.
inline void add_motions_of_corners(const Mesh_signature& from, const Mesh_signature& to,
                                   std::vector<Eigen::Matrix3d>& motions)
{
  const double alike = 0.01, tolerance = 2e-3 * to.size; // alike: relative difference of lengths that count as equal
  const std::size_t most_motions = 128;
  const Eigen::Vector3d& lengths = from.lengths;
  if (std::min(lengths[1] - lengths[0], lengths[2] - lengths[1]) > alike * lengths[2]) return;
  const Points corners = from.mesh->points.colwise() - from.centre, images = to.mesh->points.colwise() - to.centre;
  Eigen::Index outermost = 0, aside = 0;
  corners.colwise().squaredNorm().maxCoeff(&outermost);
  const Point first = corners.col(outermost);
  (corners - first.normalized() * (first.normalized().transpose() * corners)).colwise().squaredNorm().maxCoeff(&aside);
  const Point second = corners.col(aside);
  if (first.cross(second).norm() <= tolerance * first.norm()) return;
  const Eigen::Matrix3d axes = axes_of_two(first, second);
  for (const auto& p : images.colwise()) {
    if (std::abs(p.norm() - first.norm()) > tolerance) continue;
    for (const auto& q : images.colwise()) {
      if (std::abs(q.norm() - second.norm()) > tolerance) continue;
      if (std::abs((p - q).norm() - (first - second).norm()) > tolerance) continue;
      Eigen::Matrix3d image = axes_of_two(p, q);
      for (int side = 0; side < 2; ++side, image.col(2) *= -1)
        motions.push_back(image * axes.transpose());
      if (motions.size() >= most_motions) return;
    }
  }
}

/// The linear parts of motions that may map one mesh to another: reflections in the frame's axes, quarter turns about
/// the vertical, turns about it that map the horizontal moments, and maps of the principal axes and of corners. Those
/// that do not map the moments are left out.
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
  add_motions_of_corners(from, to, result);
  const double tolerance = 0.01 * to.lengths[2] * to.lengths[2];
  const auto turns_moments = [&](const Matrix3d& m) {
    return (m * from.moments * m.transpose() - to.moments).cwiseAbs().maxCoeff() <= tolerance;
  };
  result.erase(std::remove_if(result.begin(), result.end(), std::not_fn(turns_moments)), result.end());
  return result;
}

/// Whether a motion maps every vertex of one mesh, and the centre of every triangle, to the surface of another.
inline bool carries(const Motion& motion, const Mesh_signature& from, const Mesh_signature& to,
                    const contacts::Triangle_tree& target)
{
  const double tolerance = 1e-3 * to.size;
  const auto is_on_target = [&](const Point& p) {
    return target.is_near(motion.linear * p + motion.offset, tolerance * tolerance);
  };
  for (const auto& p : from.mesh->points.colwise())
    if (!is_on_target(p)) return false;
  for (Eigen::Index t = 0; t < from.mesh->triangles.cols(); ++t)
    if (!is_on_target(contacts::centre(triangle_of(*from.mesh, t)))) return false;
  return true;
}

/// The motion that maps a surface to another; none if they are not congruent.
inline std::optional<Motion> find_congruence(const Mesh_signature& from, const Mesh_signature& to,
                                             const contacts::Triangle_tree& from_tree,
                                             const contacts::Triangle_tree& to_tree)
{
  for (const Eigen::Matrix3d& linear : candidate_motions(from, to)) {
    const Motion motion{linear, to.centre - linear * from.centre};
    const Motion inverse{linear.transpose(), from.centre - linear.transpose() * to.centre};
    if (carries(motion, from, to, to_tree) && carries(inverse, to, from, from_tree)) return motion;
  }
  return std::nullopt;
}

/// The index of the original of which a mesh is a copy (or its own), and the motion that maps the original to it.
struct Congruence
{
  std::size_t original;
  Motion motion;
};

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

/// For each of several canonical meshes, its original: the first, by position, of all meshes congruent to it.
/// \param comparable whether the meshes of two indices may be in one class
inline std::vector<Congruence> find_congruences(const std::vector<Part_mesh>& meshes,
                                                const std::function<bool(std::size_t, std::size_t)>& comparable)
{
  std::vector<Mesh_signature> signatures(meshes.begin(), meshes.end());
  std::vector<std::size_t> order(meshes.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto place = [&](std::size_t i) {
    // Rounded to a coarse grid, so that noise does not decide between mirror images.
    return -std::round(1e4 * generic_direction().dot(signatures[i].centre));
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const double place_a = place(a), place_b = place(b);
    return place_a != place_b ? place_a < place_b : canonical_less(meshes[a], meshes[b]);
  });

  std::vector<Congruence> result(meshes.size());
  std::vector<std::size_t> originals;
  std::vector<std::optional<contacts::Triangle_tree>> trees(meshes.size());
  const auto tree = [&](std::size_t i) -> const contacts::Triangle_tree& {
    if (!trees[i]) trees[i].emplace(triangles_of(meshes[i]));
    return *trees[i];
  };
  for (std::size_t i : order) {
    result[i].original = i;
    for (std::size_t original : originals) {
      if (!comparable(original, i) || !may_be_congruent(signatures[original], signatures[i])) continue;
      if (const auto motion = find_congruence(signatures[original], signatures[i], tree(original), tree(i))) {
        result[i] = {original, *motion};
        break;
      }
    }
    if (result[i].original == i) originals.push_back(i);
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
