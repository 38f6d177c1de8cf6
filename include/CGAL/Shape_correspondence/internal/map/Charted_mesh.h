// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MAP_CHARTED_MESH_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MAP_CHARTED_MESH_H

#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/internal/contacts/Triangle_tree.h>
#include <CGAL/Shape_correspondence/internal/map/Part_pair.h>

#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// A mesh under subdivision. Edges are split for all of their triangles alike, so that a closed mesh stays closed.
class Subdivision
{
public:
  Subdivision(const Points& points, const Eigen::Matrix3Xi& triangles)
      : points_(points.cols()), triangles_(triangles.cols())
  {
    for (std::size_t i = 0; i < points_.size(); ++i)
      points_[i] = points.col(Eigen::Index(i));
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      triangles_[t] = {triangles(0, Eigen::Index(t)), triangles(1, Eigen::Index(t)), triangles(2, Eigen::Index(t))};
  }

  std::size_t number_of_points() const { return points_.size(); }
  std::size_t number_of_triangles() const { return triangles_.size(); }
  const Point& point(int i) const { return points_[std::size_t(i)]; }

  /// Splits every edge (a, b), a < b, at the fraction `where(a, b)` of the way from a to b if that is between 0 and 1.
  /// Returns whether there was one.
  template <typename Where>
  bool split_edges(const Where& where)
  {
    std::map<std::pair<int, int>, int> middles; // -1: none
    const auto middle = [&](int a, int b) {
      const std::pair<int, int> edge = std::minmax(a, b);
      const auto [known, is_new] = middles.try_emplace(edge, -1);
      if (!is_new) return known->second;
      const double f = where(edge.first, edge.second);
      if (f > 0 && f < 1) {
        known->second = int(points_.size());
        points_.push_back((1 - f) * point(edge.first) + f * point(edge.second));
      }
      return known->second;
    };
    std::vector<std::array<int, 3>> result;
    for (std::array<int, 3> t : triangles_) {
      std::array<int, 3> m;
      for (int i = 0; i < 3; ++i)
        m[std::size_t(i)] = middle(t[std::size_t(i)], t[std::size_t((i + 1) % 3)]);
      split(t, m, result);
    }
    const bool any = result.size() > triangles_.size();
    triangles_.swap(result);
    return any;
  }

  Points points() const
  {
    Points result(3, Eigen::Index(points_.size()));
    for (std::size_t i = 0; i < points_.size(); ++i)
      result.col(Eigen::Index(i)) = points_[i];
    return result;
  }

  Eigen::Matrix3Xi triangles() const
  {
    Eigen::Matrix3Xi result(3, Eigen::Index(triangles_.size()));
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      result.col(Eigen::Index(t)) << triangles_[t][0], triangles_[t][1], triangles_[t][2];
    return result;
  }

private:
  /// \param m by edge from corner i to i + 1, the point that splits it or -1
  static void split(std::array<int, 3> t, std::array<int, 3> m, std::vector<std::array<int, 3>>& result)
  {
    const auto is_split = [&](int i) { return m[std::size_t(i)] >= 0; };
    const int count = is_split(0) + is_split(1) + is_split(2);
    const auto rotate = [&] {
      std::rotate(t.begin(), t.begin() + 1, t.end());
      std::rotate(m.begin(), m.begin() + 1, m.end());
    };
    if (count == 0) {
      result.push_back(t);
    } else if (count == 1) {
      while (!is_split(0))
        rotate();
      result.insert(result.end(), {{t[0], m[0], t[2]}, {m[0], t[1], t[2]}});
    } else if (count == 2) {
      while (is_split(2))
        rotate();
      result.insert(result.end(), {{m[0], t[1], m[1]}, {t[0], m[0], m[1]}, {t[0], m[1], t[2]}});
    } else {
      result.insert(result.end(), {{t[0], m[0], m[2]}, {m[0], t[1], m[1]}, {m[2], m[1], t[2]}, {m[0], m[1], m[2]}});
    }
  }

  std::vector<Point> points_;
  std::vector<std::array<int, 3>> triangles_;
};

/// The piece of a part that a box of its chart cuts out, closed if the part is: the surface outside is pressed flat
/// onto the sides of the box and so caps the piece. All of it for the whole chart.
inline Part_mesh piece_of(const Points& points, const Eigen::Matrix3Xi& triangles, const Part_chart& chart,
                          const Chart_box& box)
{
  if (is_whole(box)) return {points, triangles};
  constexpr double on_side = 1e-9;
  Subdivision mesh(points, triangles);
  std::vector<Point> k;
  const auto update = [&] {
    for (std::size_t i = k.size(); i < mesh.number_of_points(); ++i)
      k.push_back(chart.coordinates(mesh.point(int(i))));
  };
  for (int axis = 0; axis < 3; ++axis)
    for (double side : {box.min()[axis], box.max()[axis]}) {
      if (std::abs(side) >= 1) continue;
      update();
      mesh.split_edges([&](int a, int b) {
        const double x = k[std::size_t(a)][axis] - side, y = k[std::size_t(b)][axis] - side;
        return x * y < 0 && std::abs(x) > on_side && std::abs(y) > on_side ? x / (x - y) : -1;
      });
    }
  update();
  // What is outside goes to the section along which it is cut off, no farther across than that reaches
  constexpr double near_section = 0.02;
  struct Side
  {
    int axis;
    double at;
    Chart_box section;
  };
  std::vector<Side> sides;
  for (int axis = 0; axis < 3; ++axis)
    for (double at : {box.min()[axis], box.max()[axis]}) {
      if (std::abs(at) >= 1) continue;
      sides.push_back({axis, at, {}});
      for (const Point& p : k)
        if (std::abs(p[axis] - at) <= near_section) sides.back().section.extend(p);
    }
  Part_mesh result{mesh.points(), mesh.triangles()};
  Eigen::AlignedBox3d kept; // in space: no cap sticks out of it
  for (Eigen::Index i = 0; i < result.points.cols(); ++i)
    if (Chart_box(box.min().array() - near_section, box.max().array() + near_section).contains(k[std::size_t(i)]))
      kept.extend(Point(result.points.col(i)));
  for (Eigen::Index i = 0; i < result.points.cols(); ++i) {
    const Point outside = k[std::size_t(i)];
    Point inside = outside;
    for (const Side& side : sides) {
      const bool is_low = side.at == box.min()[side.axis];
      if (is_low ? outside[side.axis] >= side.at - on_side : outside[side.axis] <= side.at + on_side) continue;
      if (!side.section.isEmpty()) inside = inside.cwiseMax(side.section.min()).cwiseMin(side.section.max());
      inside[side.axis] = side.at;
    }
    if (inside == outside) continue;
    const Point off = chart.frame(outside).inverse() * (result.points.col(i) - chart(outside));
    result.points.col(i) = chart(inside) + chart.frame(inside) * off;
    if (!kept.isEmpty()) result.points.col(i) = result.points.col(i).cwiseMax(kept.min()).cwiseMin(kept.max());
  }
  return result;
}

/// A mesh in the coordinates of a chart.
struct Charted_mesh
{
  Points points; ///< in space
  Eigen::Matrix3Xi triangles;
  Points coordinates; ///< in the chart
  Points offsets;     ///< from where the chart has the coordinates to the points, in its frames
};

inline contacts::Triangle triangle_of(const Points& points, const Eigen::Matrix3Xi& triangles, std::size_t t)
{
  const auto corners = triangles.col(Eigen::Index(t));
  return {points.col(corners[0]), points.col(corners[1]), points.col(corners[2])};
}

inline contacts::Triangle_tree tree_of(const Points& points, const Eigen::Matrix3Xi& triangles)
{
  std::vector<contacts::Triangle> list(std::size_t(triangles.cols()));
  for (std::size_t t = 0; t < list.size(); ++t)
    list[t] = triangle_of(points, triangles, t);
  return contacts::Triangle_tree(std::move(list));
}

/// Subdivides a mesh until its edges are short in the chart, so that it can be bent.
inline Charted_mesh charted_mesh(const Part_mesh& mesh, const Part_chart& chart, double longest_edge)
{
  constexpr std::size_t most_triangles = 20000; // a fine mesh is left as it is
  constexpr int most_rounds = 8;
  Subdivision fine(mesh.points, mesh.triangles);
  std::vector<Point> k;
  bool changed = true;
  for (int round = 0; changed; ++round) {
    for (std::size_t i = k.size(); i < fine.number_of_points(); ++i)
      k.push_back(chart.coordinates(fine.point(int(i))));
    changed = round < most_rounds && fine.number_of_triangles() < most_triangles && fine.split_edges([&](int a, int b) {
      return (k[std::size_t(a)] - k[std::size_t(b)]).norm() > longest_edge ? 0.5 : -1;
    });
  }
  Charted_mesh result{fine.points(), fine.triangles(), {}, {}};
  result.coordinates.resize(3, result.points.cols());
  result.offsets.resize(3, result.points.cols());
  for (Eigen::Index i = 0; i < result.points.cols(); ++i) {
    const Point& at = k[std::size_t(i)];
    result.coordinates.col(i) = at;
    result.offsets.col(i) = chart.frame(at).inverse() * (result.points.col(i) - chart(at));
  }
  return result;
}

/// The same, in a chart that is centred on the way.
inline Charted_mesh finely_charted(const Part_mesh& mesh, Part_chart& chart, double longest_edge)
{
  const Charted_mesh result = charted_mesh(mesh, chart, longest_edge);
  chart = chart.centred(result.points);
  return charted_mesh({result.points, result.triangles}, chart, std::numeric_limits<double>::infinity());
}

/// Unit normals of the vertices in the chart, outwards on the whole; zero where there is none.
inline Points chart_normals(const Charted_mesh& mesh)
{
  Points result = Points::Zero(3, mesh.coordinates.cols());
  const Point middle = mesh.coordinates.rowwise().mean();
  double outwards = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Eigen::Vector3i corners = mesh.triangles.col(t);
    const Point a = mesh.coordinates.col(corners[0]), b = mesh.coordinates.col(corners[1]);
    const Point c = mesh.coordinates.col(corners[2]), normal = (b - a).cross(c - a);
    outwards += normal.dot((a + b + c) / 3 - middle);
    for (int i = 0; i < 3; ++i)
      result.col(corners[i]) += normal;
  }
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const double length = result.col(i).norm();
    result.col(i) *= length > 1e-12 ? (outwards < 0 ? -1 : 1) / length : 0;
  }
  return result;
}

/// A point on a triangle of a mesh.
struct Mesh_place
{
  Eigen::Index triangle = 0;
  Eigen::Vector3d weights = Eigen::Vector3d::Zero(); ///< barycentric coordinates

  Point of(const Points& values, const Eigen::Matrix3Xi& triangles) const
  {
    return values.col(triangles(0, triangle)) * weights[0] + values.col(triangles(1, triangle)) * weights[1] +
           values.col(triangles(2, triangle)) * weights[2];
  }
};

inline Eigen::Vector3d barycentric(const Point& p, const contacts::Triangle& t)
{
  const Point u = t[1] - t[0], v = t[2] - t[0], w = p - t[0];
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(), uw = u.dot(w), vw = v.dot(w);
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 1e-14 * uu * vv)) { // a needle: along its longest side
    const int far = uu >= vv ? 1 : 2;
    const double along = std::max(uu, vv) > 0 ? contacts::clamped((far == 1 ? uw / uu : vw / vv)) : 0;
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    result[0] = 1 - along;
    result[far] = along;
    return result;
  }
  const double a = contacts::clamped((vv * uw - uv * vw) / determinant);
  const double b = std::min(contacts::clamped((uu * vw - uv * uw) / determinant), 1 - a);
  return {1 - a - b, a, b};
}

/// The place on a mesh nearest to a point.
inline Mesh_place nearest_place(const contacts::Triangle_tree& tree, const Point& p)
{
  Point nearest = p;
  double squared = std::numeric_limits<double>::infinity();
  std::size_t triangle = 0;
  tree.improve_nearest(p, nearest, squared, triangle);
  return {Eigen::Index(tree.given_number(triangle)), barycentric(nearest, tree.triangles()[triangle])};
}

/// A mesh in its chart, to find the place of a point of another mesh in the same coordinates.
class Place_finder
{
public:
  /// \param normals of the vertices
  Place_finder(const Points& coordinates, const Eigen::Matrix3Xi& triangles, const Points& normals)
      : coordinates_(coordinates), triangles_(triangles), normals_(normals), all_(tree_of(coordinates, triangles))
  {
    for (std::size_t side = 0; side < 6; ++side) {
      std::vector<contacts::Triangle> list;
      for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
        Point normal = Point::Zero();
        for (int i = 0; i < 3; ++i)
          normal += normals.col(triangles(i, t));
        if (normal.dot(direction(side)) < facing * normal.norm()) continue;
        list.push_back(triangle_of(coordinates, triangles, std::size_t(t)));
        numbers_[side].push_back(t);
      }
      if (!list.empty()) facing_[side].emplace(std::move(list));
    }
  }

  /// The nearest place; on a thin part that of the same side, as normals tell.
  Mesh_place operator()(const Point& p, const Point& normal) const
  {
    constexpr double far = 1;       // in coordinates: no place to be taken for the sake of its normal
    constexpr double averse = -0.2; // cosine of two normals of different sides
    const Mesh_place nearest = nearest_place(all_, p);
    if (normal.dot(nearest.of(normals_, triangles_)) >= averse) return nearest;
    Mesh_place best = nearest;
    double least = far * far;
    for (std::size_t side = 0; side < 6; ++side) {
      if (!facing_[side] || normal.dot(direction(side)) < facing) continue;
      Mesh_place place = nearest_place(*facing_[side], p);
      place.triangle = numbers_[side][std::size_t(place.triangle)];
      const double squared = (place.of(coordinates_, triangles_) - p).squaredNorm();
      if (squared < least) least = squared, best = place;
    }
    return best;
  }

private:
  static constexpr double facing = 0.5; // cosine; every normal is nearer to one of the six directions

  static Point direction(std::size_t side) { return (side % 2 ? -1. : 1.) * Point::Unit(Eigen::Index(side / 2)); }

  const Points& coordinates_;
  const Eigen::Matrix3Xi& triangles_;
  const Points& normals_;
  contacts::Triangle_tree all_;
  std::array<std::optional<contacts::Triangle_tree>, 6> facing_; ///< of triangles that face the six directions
  std::array<std::vector<Eigen::Index>, 6> numbers_;
};

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MAP_CHARTED_MESH_H
