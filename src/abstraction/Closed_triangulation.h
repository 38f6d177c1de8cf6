// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A closed triangle mesh whose edges can be split and collapsed. The halfedges of face f are 3f, 3f + 1 and 3f + 2;
/// only their sources and opposites are stored (directed edges; Campagna, Kobbelt and Seidel 1998).
class Closed_triangulation
{
public:
  /// \pre the mesh is a closed manifold
  explicit Closed_triangulation(const Part_mesh& mesh)
      : out_(std::size_t(mesh.points.cols()), none), degrees_(out_.size(), 0)
  {
    for (Eigen::Index v = 0; v < mesh.points.cols(); ++v)
      points_.push_back(mesh.points.col(v));
    std::unordered_map<std::uint64_t, int> halfedges;
    const auto key = [](int a, int b) { return std::uint64_t(std::uint32_t(a)) << 32 | std::uint32_t(b); };
    for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
      add_face();
      set_face(int(t), mesh.triangles(0, t), mesh.triangles(1, t), mesh.triangles(2, t));
    }
    for (int h = 0; h < number_of_halfedges(); ++h) {
      halfedges[key(source(h), target(h))] = h;
      ++degrees_[at(source(h))];
    }
    for (int h = 0; h < number_of_halfedges(); ++h)
      opposite_[at(h)] = halfedges.at(key(target(h), source(h)));
  }

  int number_of_halfedges() const { return int(source_.size()); }
  int number_of_vertices() const { return int(points_.size()); }
  bool is_removed(int h) const { return source_[at(h)] == none; }
  bool is_removed_vertex(int v) const { return out_[at(v)] == none; }

  int next(int h) const { return h % 3 == 2 ? h - 2 : h + 1; }
  int previous(int h) const { return h % 3 == 0 ? h + 2 : h - 1; }
  int opposite(int h) const { return opposite_[at(h)]; }
  int source(int h) const { return source_[at(h)]; }
  int target(int h) const { return source(next(h)); }
  /// The vertex opposite to a halfedge in its face.
  int apex(int h) const { return source(previous(h)); }

  Point& point(int v) { return points_[at(v)]; }
  const Point& point(int v) const { return points_[at(v)]; }
  double squared_length(int h) const { return (point(target(h)) - point(source(h))).squaredNorm(); }
  /// Normal of a halfedge's face, of length twice the area.
  Point normal(int h) const { return (point(target(h)) - point(source(h))).cross(point(apex(h)) - point(source(h))); }

  /// Calls `f` with every outgoing halfedge of a vertex until it returns false. \return whether all calls returned true
  template <typename Function>
  bool for_each_out(int v, const Function& f) const
  {
    int h = out_[at(v)];
    do {
      if (!f(h)) return false;
      h = opposite(previous(h));
    } while (h != out_[at(v)]);
    return true;
  }

  bool are_adjacent(int v, int w) const
  {
    return !for_each_out(v, [&](int h) { return target(h) != w; });
  }

  /// Splits an edge in the middle. \return the new vertex
  int split(int h)
  {
    const int o = opposite(h), a = source(h), b = target(h), c = apex(h), d = apex(o);
    const int bc = opposite(next(h)), ca = opposite(previous(h)), ad = opposite(next(o)), db = opposite(previous(o));
    const int f = h / 3, g = o / 3, f_new = add_face(), g_new = add_face();
    const int m = number_of_vertices();
    points_.push_back(0.5 * (point(a) + point(b)));
    out_.push_back(none);
    degrees_.push_back(4);
    ++degrees_[at(c)];
    ++degrees_[at(d)];
    set_face(f, a, m, c);
    set_face(f_new, m, b, c);
    set_face(g, m, a, d);
    set_face(g_new, b, m, d);
    link(3 * f, 3 * g);
    link(3 * f_new, 3 * g_new);
    link(3 * f + 1, 3 * f_new + 2);
    link(3 * g + 2, 3 * g_new + 1);
    link(3 * f + 2, ca);
    link(3 * f_new + 1, bc);
    link(3 * g + 1, ad);
    link(3 * g_new + 2, db);
    return m;
  }

  /// Whether collapsing an edge keeps the mesh a manifold.
  bool can_collapse(int h) const
  {
    const int a = source(h), b = target(h), c = apex(h), d = apex(opposite(h));
    if (c == d || degree(c) == 3 || degree(d) == 3) return false;
    const int most_common = 2; // largest number of vertices adjacent to both ends of the edge
    int common = 0;
    return for_each_out(a, [&](int around) { return (common += are_adjacent(target(around), b)) <= most_common; });
  }

  /// Collapses an edge: the source of `h` becomes its target. \pre `can_collapse(h)`
  void collapse(int h)
  {
    const int o = opposite(h), a = source(h), b = target(h), c = apex(h), d = apex(o);
    const int bc = opposite(next(h)), ca = opposite(previous(h)), ad = opposite(next(o)), db = opposite(previous(o));
    std::vector<int> moved;
    for_each_out(a, [&](int around) {
      moved.push_back(around);
      return true;
    });
    for (int around : moved)
      source_[at(around)] = b;
    degrees_[at(b)] += degrees_[at(a)] - 4;
    --degrees_[at(c)];
    --degrees_[at(d)];
    remove_face(h / 3);
    remove_face(o / 3);
    link(bc, ca);
    link(ad, db);
    out_[at(a)] = none;
    out_[at(b)] = ca;
    out_[at(c)] = bc;
    out_[at(d)] = ad;
  }

  int degree(int v) const { return degrees_[at(v)]; }

  Part_mesh mesh() const
  {
    std::vector<int> index(points_.size(), none);
    Part_mesh result;
    result.points.resize(3, number_of_vertices());
    int vertices = 0;
    for (int v = 0; v < number_of_vertices(); ++v) {
      if (!is_removed_vertex(v)) {
        result.points.col(vertices) = point(v);
        index[at(v)] = vertices++;
      }
    }
    result.points.conservativeResize(3, vertices);
    result.triangles.resize(3, number_of_halfedges() / 3);
    Eigen::Index triangles = 0;
    for (int h = 0; h < number_of_halfedges(); h += 3) {
      if (!is_removed(h))
        result.triangles.col(triangles++) << index[at(source(h))], index[at(source(h + 1))], index[at(source(h + 2))];
    }
    result.triangles.conservativeResize(3, triangles);
    return result;
  }

private:
  static constexpr int none = -1;

  static std::size_t at(int i) { return std::size_t(i); }

  int add_face()
  {
    source_.insert(source_.end(), 3, none);
    opposite_.insert(opposite_.end(), 3, none);
    return number_of_halfedges() / 3 - 1;
  }

  void set_face(int f, int a, int b, int c)
  {
    const std::array<int, 3> corners{a, b, c};
    for (int k = 0; k < 3; ++k) {
      source_[at(3 * f + k)] = corners[at(k)];
      out_[at(corners[at(k)])] = 3 * f + k;
    }
  }

  void remove_face(int f) { std::fill_n(source_.begin() + std::ptrdiff_t(3) * f, 3, none); }

  void link(int h, int o)
  {
    opposite_[at(h)] = o;
    opposite_[at(o)] = h;
  }

  std::vector<Point> points_;
  std::vector<int> source_, opposite_; ///< indexed by halfedge
  std::vector<int> out_;               ///< indexed by vertex: one of its outgoing halfedges
  std::vector<int> degrees_;           ///< indexed by vertex
};

} // namespace CGAL::Shape_correspondence::internal
