// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SHAPE_CORRESPONDENCE_BLEND_CHECKS_H
#define SHAPE_CORRESPONDENCE_BLEND_CHECKS_H

#include "blend/schedules.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace blend_checks {

using CGAL::Shape_correspondence::Part_mesh;
using CGAL::Shape_correspondence::Point;
using CGAL::Shape_correspondence::Points;
using CGAL::Shape_correspondence::Segmented_shape;
using CGAL::Shape_correspondence::Shape_part;
using CGAL::Shape_correspondence::internal::contacts::Triangle_tree;

/// Whether every edge is traversed equally often in both directions.
inline bool is_closed(const Part_mesh& mesh)
{
  std::map<std::pair<int, int>, int> balance;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    for (int i = 0; i < 3; ++i) {
      const int a = mesh.triangles(i, t), b = mesh.triangles((i + 1) % 3, t);
      if (a != b) balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  return std::all_of(balance.begin(), balance.end(), [](const auto& edge) { return edge.second == 0; });
}

inline std::vector<Triangle_tree> trees_of(const Segmented_shape& shape, double scale = 1)
{
  std::vector<Triangle_tree> result;
  for (const Shape_part& part : shape.parts())
    result.push_back(CGAL::Shape_correspondence::internal::tree_of(scale * part.mesh.points, part.mesh.triangles));
  return result;
}

/// The width of the widest gap that has to be bridged to join all parts, divided by the shape's height.
inline double widest_gap(const Segmented_shape& shape, double height)
{
  const std::vector<Triangle_tree> trees = trees_of(shape, 1 / height);
  return CGAL::Shape_correspondence::internal::widest_gap(CGAL::Shape_correspondence::internal::pointers_to(trees));
}

/// Whether a point is in a closed mesh, by the solid angle that the surface subtends.
inline bool is_inside(const Point& p, const Part_mesh& mesh)
{
  double angle = 0; // half of the solid angle
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Point a = mesh.points.col(mesh.triangles(0, t)) - p, b = mesh.points.col(mesh.triangles(1, t)) - p;
    const Point c = mesh.points.col(mesh.triangles(2, t)) - p;
    const double lengths[] = {a.norm(), b.norm(), c.norm()};
    angle += std::atan2(a.dot(b.cross(c)), lengths[0] * lengths[1] * lengths[2] + a.dot(b) * lengths[2] +
                                               b.dot(c) * lengths[0] + c.dot(a) * lengths[1]);
  }
  return std::abs(angle) > EIGEN_PI;
}

inline double area(const Part_mesh& mesh)
{
  double sum = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const auto corner = [&](int i) -> Point { return mesh.points.col(mesh.triangles(i, t)); };
    sum += (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2;
  }
  return sum;
}

/// The largest distance of the vertices of one shape from the surface of another.
/// \param is_left_out predicate of a part of `from` and one of its points: whether that point does not count
template <typename Is_left_out>
double distance(const Segmented_shape& from, const Segmented_shape& to, const Is_left_out& is_left_out)
{
  const std::vector<Triangle_tree> trees = trees_of(to);
  double farthest = 0;
  for (const Shape_part& part : from.parts())
    for (Eigen::Index i = 0; i < part.mesh.points.cols(); ++i) {
      const Point p = part.mesh.points.col(i);
      double squared = std::numeric_limits<double>::infinity();
      Point nearest;
      std::size_t triangle;
      for (const Triangle_tree& tree : trees)
        if (tree.box().squaredExteriorDistance(p) < squared) tree.improve_nearest(p, nearest, squared, triangle);
      if (squared > farthest && !is_left_out(part, p)) farthest = squared;
    }
  return std::sqrt(farthest);
}

inline double distance(const Segmented_shape& from, const Segmented_shape& to)
{
  return distance(from, to, [](const Shape_part&, const Point&) { return false; });
}

/// The Hausdorff distance, estimated at vertices.
inline double hausdorff_distance(const Segmented_shape& a, const Segmented_shape& b)
{
  return std::max(distance(a, b), distance(b, a));
}

/// The Hausdorff distance of an in-between shape and an input, divided by the height. Of the in-between shape, parts
/// that have shrunk to nothing do not count, nor points inside the input's parts, where pieces of divided parts meet.
inline double seen_distance(const Segmented_shape& blended, const Segmented_shape& input, double height)
{
  constexpr double least_area = 1e-5; // over the squared height: the area below which a part has shrunk to nothing
  const auto is_left_out = [&](const Shape_part& part, const Point& p) {
    return area(part.mesh) < least_area * height * height ||
           std::any_of(input.parts().begin(), input.parts().end(),
                       [&](const Shape_part& other) { return is_inside(p, other.mesh); });
  };
  return std::max(distance(blended, input, is_left_out), distance(input, blended)) / height;
}

/// Whether `b` is `a` moved by a rotation and a translation: compares the distances of all points from four points of
/// the first part.
inline bool is_moved(const Segmented_shape& a, const Segmented_shape& b)
{
  constexpr double rounding = 1e-9;
  if (a.parts().size() != b.parts().size()) return false;
  const Points &first = a.parts()[0].mesh.points, &second = b.parts()[0].mesh.points;
  if (first.cols() != second.cols()) return false;
  const auto orientation = [](const Segmented_shape& shape) { // 6 times the volume; changes sign under reflection
    Point middle = Point::Zero();
    for (const Shape_part& part : shape.parts())
      middle += part.mesh.points.rowwise().mean() / double(shape.parts().size());
    double sum = 0;
    for (const Shape_part& part : shape.parts())
      for (const auto triangle : part.mesh.triangles.colwise()) {
        const auto corner = [&](int i) { return Point(part.mesh.points.col(triangle[i]) - middle); };
        sum += corner(0).dot(corner(1).cross(corner(2)));
      }
    return sum;
  };
  if (std::abs(orientation(a) - orientation(b)) > rounding * std::abs(orientation(a))) return false;
  const std::array<Eigen::Index, 4> some = {0, first.cols() / 3, first.cols() / 2, first.cols() - 1};
  return std::equal(a.parts().begin(), a.parts().end(), b.parts().begin(), [&](const auto& p, const auto& q) {
    if (p.name != q.name || p.mesh.triangles != q.mesh.triangles) return false;
    return std::all_of(some.begin(), some.end(), [&](Eigen::Index i) {
      const auto distances = [i](const Points& points, const Points& from) {
        return (points.colwise() - from.col(i)).colwise().norm().eval();
      };
      return distances(p.mesh.points, first).isApprox(distances(q.mesh.points, second), rounding);
    });
  });
}

/// A blend with measures of its in-between shapes; lengths are divided by the height of the shape.
class Measured_blend
{
public:
  template <typename Model> // has `graph` and `shape`
  Measured_blend(const Model& source, const Model& target,
                 const CGAL::Shape_correspondence::Correspondence& correspondence)
      : blend_({Input{source.graph, source.shape, 0},
                Input{target.graph, target.shape, correspondence.target_quarter_turns}},
               correspondence, {}),
        tasks_(CGAL::Shape_correspondence::internal::ranked_schedules(blend_, {})[0].tasks)
  {}

  /// For matched parts that touch in source and target: the largest excess of their gap at time t over the gap
  /// interpolated between both.
  double gap(double t) const
  {
    const auto seen = Shape(blend_, tasks_, t).seen(); // matched parts come first
    double worst = 0;
    for (const auto& [a, b] : blend_.touches) {
      if (!blend_.parts[a].is_matched() || !blend_.parts[b].is_matched()) continue;
      const auto at_end = [&, a = a, b = b](int end) {
        return std::sqrt(blend_.parts[a].end_tree(end).nearly_closest(blend_.parts[b].end_tree(end)).squared);
      };
      const double allowed = (1 - t) * at_end(0) + t * at_end(1);
      if (std::max(at_end(0), at_end(1)) < touching)
        worst = std::max(worst, std::sqrt(seen[a].tree.nearly_closest(seen[b].tree).squared) - allowed);
    }
    return worst;
  }

  /// Distance of the in-between shape from its mirror image, minus the larger of these distances of source and target.
  double asymmetry(double t) const
  {
    CGAL::Shape_correspondence::internal::Tree_pointers trees;
    std::vector<const Points*> points;
    const auto seen = Shape(blend_, tasks_, t).seen();
    for (const auto& surface : seen) {
      points.push_back(&surface.points);
      trees.push_back(&surface.tree);
    }
    return CGAL::Shape_correspondence::internal::mirror_residual(points, trees) -
           std::max(asymmetry_of_end(0), asymmetry_of_end(1));
  }

private:
  using Input = CGAL::Shape_correspondence::internal::Blend_input;
  using Shape = CGAL::Shape_correspondence::internal::In_between_shape;
  static constexpr double touching = 0.02; // gap below which parts touch

  double asymmetry_of_end(std::size_t end) const
  {
    std::vector<const Points*> points;
    std::vector<Triangle_tree> trees;
    for (const Part_mesh& mesh : blend_.stage.meshes[end]) {
      points.push_back(&mesh.points);
      trees.push_back(CGAL::Shape_correspondence::internal::tree_of(mesh.points, mesh.triangles));
    }
    return CGAL::Shape_correspondence::internal::mirror_residual(
        points, CGAL::Shape_correspondence::internal::pointers_to(trees));
  }

  CGAL::Shape_correspondence::internal::Blend_structure blend_;
  std::vector<CGAL::Shape_correspondence::Blend_task> tasks_;
};

/// Relative deviation of the height at time t from the geometric interpolation between the heights of both ends.
inline double height_error(const CGAL::Shape_correspondence::Shape_blend& blend, double t)
{
  const auto height = [&](double time) {
    Eigen::AlignedBox3d box;
    const Segmented_shape shape = blend(time);
    for (const Shape_part& part : shape.parts())
      box.extend(Eigen::AlignedBox3d(part.mesh.points.rowwise().minCoeff(), part.mesh.points.rowwise().maxCoeff()));
    return box.sizes().dot(shape.up().cwiseAbs());
  };
  return std::abs(height(t) / (std::pow(height(0), 1 - t) * std::pow(height(1), t)) - 1);
}

} // namespace blend_checks

#endif // SHAPE_CORRESPONDENCE_BLEND_CHECKS_H
