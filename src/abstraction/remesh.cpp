// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/Closed_triangulation.h"
#include "abstraction/repair.h"
#include "abstraction/surface_samples.h"
#include "shape/Triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

class Remesher
{
public:
  Remesher(const Part_mesh& solid, double edge_length, const Deadline& deadline)
      : mesh_(solid),
        surface_(triangles_of(solid)),
        hints_(std::size_t(solid.points.cols()), 0),
        edge_length_(edge_length),
        most_vertices_(mesh_.number_of_vertices() + most_new_vertices),
        thickness_(2 * enclosed_volume(solid) / surface_area(solid)),
        deadline_(&deadline)
  {}

  Part_mesh run()
  {
    const int rounds = 3;
    collapse_needles();
    for (int round = 0; round < rounds; ++round) {
      split_long_edges();
      collapse_short_edges();
      spread_vertices();
    }
    return mesh_.mesh();
  }

private:
  // Thresholds of edge lengths, over the wanted length
  static constexpr double needle_edge = 0.6, short_edge = 4. / 5., long_edge = 4. / 3.;

  // Limit of vertices added by splitting, a thousand times what the usual 2000 triangles need. Without it, edges that
  // do not shrink because of rounding would be split until memory is exhausted
  static constexpr int most_new_vertices = 1'000'000;

  using Entry = std::pair<double, int>; // squared length, halfedge

  void split_long_edges()
  {
    const double most = square(long_edge * edge_length_);
    std::priority_queue<Entry> queue;
    const auto push = [&](int h) {
      if (mesh_.squared_length(h) > most) queue.emplace(mesh_.squared_length(h), h);
    };
    for (int h = 0; h < mesh_.number_of_halfedges(); ++h)
      if (is_edge(h)) push(h);
    while (!queue.empty()) {
      deadline_->check();
      if (mesh_.number_of_vertices() > most_vertices_) throw Flow_failure("its surface cannot be meshed evenly");
      const auto [squared, h] = queue.top();
      queue.pop();
      if (mesh_.squared_length(h) == squared) {
        const std::size_t hint = hints_[std::size_t(mesh_.source(h))];
        const int middle = mesh_.split(h);
        hints_.push_back(hint);
        mesh_.for_each_out(middle, [&](int around) {
          push(around);
          push(mesh_.next(around)); // the halfedges may have been renumbered
          return true;
        });
      }
    }
  }

  /// Collapses short edges, the shortest first, if that hardly changes the surface. The rounds would collapse them,
  /// too, but only after splitting the needles whose short sides they are.
  void collapse_needles()
  {
    const double length = needle_edge * edge_length_;
    const double tolerance = 0.1 * std::min(length, thickness_);
    collapse_edges(length, [&](int h) { return hardly_changes(h, tolerance); });
  }

  void collapse_short_edges()
  {
    collapse_edges(short_edge * edge_length_, [&](int h) { return turns_no_face(h) && makes_no_long_edge(h); });
  }

  /// Collapses edges shorter than `length`, the shortest first, in an allowed direction.
  template <typename Test>
  void collapse_edges(double length, const Test& is_allowed)
  {
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const auto push = [&](int h) {
      if (mesh_.squared_length(h) < length * length) queue.emplace(mesh_.squared_length(h), h);
    };
    for (int h = 0; h < mesh_.number_of_halfedges(); ++h)
      if (is_edge(h)) push(h);
    while (!queue.empty()) {
      deadline_->check();
      auto [squared, h] = queue.top();
      queue.pop();
      if (mesh_.is_removed(h) || mesh_.squared_length(h) != squared) continue;
      if (!is_allowed(h)) {
        h = mesh_.opposite(h);
        if (!is_allowed(h)) continue;
      }
      if (!mesh_.can_collapse(h)) continue;
      const int kept = mesh_.target(h);
      mesh_.collapse(h);
      mesh_.for_each_out(kept, [&](int around) {
        push(around);
        return true;
      });
    }
  }

  /// Whether moving the source of a halfedge to its target hardly changes the surface: the vertex stays near the planes
  /// of its faces, and none of these faces turns much.
  bool hardly_changes(int h, double tolerance) const
  {
    const double least_cosine = 0.5; // cosine of the greatest angle by which a face may turn
    const Point step = mesh_.point(mesh_.target(h)) - mesh_.point(mesh_.source(h));
    return for_each_moved_face(h, [&](const Point& before, const Point& after) {
      return std::abs(before.dot(step)) <= tolerance * before.norm() &&
             before.dot(after) > least_cosine * before.norm() * after.norm();
    });
  }

  bool turns_no_face(int h) const
  {
    const double least_cosine = 0.7; // cosine of 45 degrees
    return for_each_moved_face(h, [&](const Point& before, const Point& after) {
      return before.dot(after) > least_cosine * before.norm() * after.norm();
    });
  }

  bool makes_no_long_edge(int h) const
  {
    const Point& to = mesh_.point(mesh_.target(h));
    return mesh_.for_each_out(mesh_.source(h), [&](int around) {
      return (mesh_.point(mesh_.target(around)) - to).squaredNorm() <= square(long_edge * edge_length_);
    });
  }

  /// Tests the normals, before and after, of the faces that remain when the source of a halfedge moves to its target.
  template <typename Test>
  bool for_each_moved_face(int h, const Test& test) const
  {
    const int kept = mesh_.target(h);
    const Point &from = mesh_.point(mesh_.source(h)), &to = mesh_.point(kept);
    return mesh_.for_each_out(mesh_.source(h), [&](int around) {
      const int u = mesh_.target(around), v = mesh_.apex(around);
      if (u == kept || v == kept) return true;
      const Point &a = mesh_.point(u), &b = mesh_.point(v);
      return test((a - from).cross(b - from), (a - to).cross(b - to));
    });
  }

  /// Moves every vertex to the centre of its neighbours, along the surface.
  void spread_vertices()
  {
    deadline_->check();
    std::vector<Point> moved(std::size_t(mesh_.number_of_vertices()));
    for (int v = 0; v < mesh_.number_of_vertices(); ++v)
      if (!mesh_.is_removed_vertex(v)) moved[std::size_t(v)] = spread(v);
    for (int v = 0; v < mesh_.number_of_vertices(); ++v)
      if (!mesh_.is_removed_vertex(v)) mesh_.point(v) = moved[std::size_t(v)];
  }

  Point spread(int v)
  {
    Point sum = Point::Zero(), normal = Point::Zero();
    mesh_.for_each_out(v, [&](int h) {
      sum += mesh_.point(mesh_.target(h));
      normal += mesh_.normal(h);
      return true;
    });
    normal.normalize();
    const Point step = sum / mesh_.degree(v) - mesh_.point(v);
    return surface_.nearest(mesh_.point(v) + step - normal.dot(step) * normal, hints_[std::size_t(v)]);
  }

  /// Whether a halfedge is the one of the two that represents its edge.
  bool is_edge(int h) const { return !mesh_.is_removed(h) && h < mesh_.opposite(h); }

  static double square(double x) { return x * x; }

  Closed_triangulation mesh_;
  contacts::Triangle_tree surface_;
  std::vector<std::size_t> hints_; ///< for each vertex, the triangle of the surface that it was last on
  double edge_length_;
  int most_vertices_;
  double thickness_; ///< thickness of a plate with the volume and area of the part
  const Deadline* deadline_;
};

} // namespace

Part_mesh remeshed(const Part_mesh& solid, double edge_length, const Deadline& deadline)
{
  return Remesher(solid, edge_length, deadline).run();
}

} // namespace CGAL::Shape_correspondence::internal
