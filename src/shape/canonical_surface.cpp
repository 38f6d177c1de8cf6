// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/canonical_surface.h"
#include "base/directions.h"
#include "base/planar_hull.h"
#include "shape/Flat_faces.h"
#include "shape/divide_polygon.h"
#include "shape/oriented_box.h"
#include "shape/sample_triangles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Divides the flat faces of a surface into triangles anew.
class Divider
{
public:
  Divider(const Flat_faces& mesh, const Eigen::Matrix3d& axes) : mesh_(mesh), direction_(axes * generic_direction())
  {
    const double stretch = 0.15; // enough to settle ties, little enough for round triangles
    stretch_ = Eigen::Matrix3d::Identity() + stretch * direction_ * direction_.transpose();
    for (const Point& p : mesh.points())
      place_.push_back(direction_.dot(p - mesh.points()[0]));
  }

  Part_mesh operator()()
  {
    face_ = mesh_.nearly_flat(direction_);
    is_whole_.assign(face_.size(), 0);
    std::vector<Corners> triangles;
    while (!divide_faces(triangles))
      triangles.clear();
    return sorted_mesh(mesh_.points(), triangles, place_);
  }

private:
  const Point& point(int v) const { return mesh_.points()[std::size_t(v)]; }
  Corners corners(int t) const { return mesh_.triangles()[std::size_t(t)]; }

  /// Divides all faces. \return whether it succeeded; else the faces that it could not divide are now smaller ones
  bool divide_faces(std::vector<Corners>& result)
  {
    find_outlines();
    const Groups faces(face_);
    bool is_done = true;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Groups::Range members = faces[i];
      if (members.size() == 0) continue;
      if (is_whole_[std::size_t(*members.begin())]) {
        for (int t : members)
          result.push_back(corners(t));
      } else if (!divide(members, result)) {
        break_up(members, int(faces.size()));
        is_done = false;
      }
    }
    return is_done;
  }

  /// Divides a nearly flat face into its exactly flat ones; an exactly flat face will keep its triangles.
  void break_up(const Groups::Range& members, int faces)
  {
    const std::vector<int>& exact = mesh_.exactly_flat();
    const auto is_same = [&](int t) { return exact[std::size_t(t)] == exact[std::size_t(*members.begin())]; };
    const bool is_exact = std::all_of(members.begin(), members.end(), is_same);
    for (int t : members)
      if (is_exact)
        is_whole_[std::size_t(t)] = 1;
      else
        face_[std::size_t(t)] = faces + exact[std::size_t(t)];
  }

  bool is_within_face(const Side_range& sides) const
  {
    return std::all_of(sides.first, sides.second, [&](const Side_of_triangle& side) {
      const auto t = std::size_t(side.triangle());
      const int next = mesh_.neighbour(side.corner);
      return next >= 0 && face_[std::size_t(next)] == face_[t] && !is_whole_[t];
    });
  }

  /// Finds the edges of faces, and the vertices that become corners of triangles.
  void find_outlines()
  {
    const std::size_t n = mesh_.points().size();
    degree_.assign(n, 0);
    neighbours_.assign(n, {-1, -1});
    mesh_.for_each_edge([&](const Side_range& sides) {
      if (is_within_face(sides)) return;
      const Corners c = corners(sides.first->triangle());
      const auto k = std::size_t(sides.first->corner % 3);
      const int a = c[k], b = c[(k + 1) % 3];
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
        int& degree = degree_[std::size_t(from)];
        if (degree < 2) neighbours_[std::size_t(from)][std::size_t(degree)] = to;
        ++degree;
      }
    });
    is_kept_.assign(n, 0);
    for (std::size_t v = 0; v < n; ++v)
      is_kept_[v] = degree_[v] > 0 && degree_[v] != 2;
    for (std::size_t t = 0; t < face_.size(); ++t)
      if (is_whole_[t])
        for (int v : corners(int(t)))
          is_kept_[std::size_t(v)] = 1;
    keep_bends();
  }

  bool is_near_line(int v, int from, int to, double tolerance) const
  {
    const Point along = point(to) - point(from), way = point(v) - point(from);
    const double place = way.dot(along);
    return place > 0 && place < along.squaredNorm() && along.cross(way).norm() <= tolerance * along.norm();
  }

  bool is_before(int v, int w) const
  {
    return std::tie(place_[std::size_t(v)], v) < std::tie(place_[std::size_t(w)], w);
  }

  /// Keeps the vertices where the edges of faces bend, and all vertices of a cycle that would have less than three.
  void keep_bends()
  {
    std::vector<char> is_done = is_kept_;
    for (std::size_t v = 0; v < is_done.size(); ++v) {
      if (is_done[v] || degree_[v] != 2) continue;
      const std::vector<int> chain = directed(chain_around(int(v)));
      for (int w : chain)
        is_done[std::size_t(w)] = 1;
      // Vertices on exact lines are removed first, since whether a vertex is a bend depends on its neighbours
      std::vector<int> bends = bends_of(bends_of(chain, mesh_.exact_tolerance()), mesh_.tolerance());
      if (chain.front() == chain.back() && bends.size() < 4) bends = chain;
      for (int w : bends)
        is_kept_[std::size_t(w)] = 1;
    }
  }

  /// The next vertex of a chain that comes from `before` to `at`.
  int next_of(int before, int at) const
  {
    const Link& ends = neighbours_[std::size_t(at)];
    return ends[0] == before ? ends[1] : ends[0];
  }

  /// The chain of vertices through `v`, from a kept vertex to the next kept one; a cycle begins and ends with `v`.
  std::vector<int> chain_around(int v) const
  {
    std::vector<int> result{v};
    for (std::size_t side = 0; side < 2; ++side) {
      int before = v, at = neighbours_[std::size_t(v)][side];
      result.push_back(at);
      while (!is_kept_[std::size_t(at)]) {
        if (at == v) return result;
        const int next = next_of(before, at);
        before = at;
        at = next;
        result.push_back(at);
      }
      std::reverse(result.begin(), result.end());
    }
    return result;
  }

  /// The chain in canonical direction: an open one from its lower end, a cycle from its lowest bend (`is_before()`).
  std::vector<int> directed(std::vector<int> chain) const
  {
    if (chain.front() == chain.back() && !is_kept_[std::size_t(chain.front())]) {
      chain.pop_back();
      const auto is_better = [&](int v, int w) {
        const bool bends_v = is_bend(v), bends_w = is_bend(w);
        return bends_v == bends_w ? is_before(v, w) : bends_v;
      };
      std::rotate(chain.begin(), std::min_element(chain.begin(), chain.end(), is_better), chain.end());
      chain.push_back(chain.front());
    }
    const bool is_cycle = chain.front() == chain.back();
    if (is_cycle ? is_before(chain[chain.size() - 2], chain[1]) : is_before(chain.back(), chain.front()))
      std::reverse(chain.begin(), chain.end());
    return chain;
  }

  bool is_bend(int v) const
  {
    const Link& ends = neighbours_[std::size_t(v)];
    return !is_near_line(v, ends[0], ends[1], mesh_.exact_tolerance());
  }

  /// The ends of a chain, and vertices between them such that all others are near the lines from one to the next.
  std::vector<int> bends_of(const std::vector<int>& chain, double tolerance) const
  {
    const std::size_t longest = 1000; // number of vertices left out in a row; it bounds the time
    std::vector<int> result{chain[0]};
    std::size_t last = 0;
    const auto keep = [&](std::size_t i) {
      result.push_back(chain[i]);
      last = i;
    };
    for (std::size_t i = 1; i < chain.size(); ++i) {
      bool is_straight = i - last < longest;
      for (std::size_t k = last + 1; k < i && is_straight; ++k)
        is_straight = is_near_line(chain[k], chain[last], chain[i], tolerance);
      if (!is_straight) keep(i - 1);
      if (i + 1 == chain.size() || !is_near_line(chain[i], chain[i - 1], chain[i + 1], tolerance)) keep(i);
    }
    return result;
  }

  /// The border of a face, as links from each kept vertex to the next; the face is on the left.
  std::vector<Link> border_of(const Groups::Range& members) const
  {
    const int face = face_[std::size_t(*members.begin())];
    std::vector<Link> result;
    for (int t : members)
      for (int k = 0; k < 3; ++k) {
        const int next = mesh_.neighbour(3 * t + k);
        if (next >= 0 && face_[std::size_t(next)] == face) continue;
        int from = corners(t)[std::size_t(k)], to = corners(t)[std::size_t((k + 1) % 3)];
        if (!is_kept_[std::size_t(from)]) continue;
        const int start = from;
        while (!is_kept_[std::size_t(to)])
          from = std::exchange(to, next_of(from, to));
        result.push_back({start, to});
      }
    std::sort(result.begin(), result.end());
    return result;
  }

  /// Adds the triangles of a face. \return whether it can be divided
  bool divide(const Groups::Range& members, std::vector<Corners>& result) const
  {
    const std::vector<Link> border = border_of(members);
    if (members.size() == 1 && border.size() == 3) { // the triangle itself
      result.push_back(corners(*members.begin()));
      return true;
    }
    const double tolerance = mesh_.tolerance();
    const Point origin = border.empty() ? Point::Zero() : point(border[0][0]);
    Point normal = Point::Zero();
    double length = 0, area = 0, sum = 0;
    for (const auto& [a, b] : border) {
      normal += (point(a) - origin).cross(point(b) - origin);
      length += (point(b) - point(a)).norm();
    }
    for (int t : members)
      area += mesh_.area_vector(t).norm();
    const double error = tolerance * length + 1e-3 * area; // largest error of twice the area
    if (std::abs(normal.norm() - area) > error) return false;
    if (normal.norm() <= tolerance * length) return border.size() < 3; // it has no area
    if (std::adjacent_find(border.begin(), border.end()) != border.end()) return false;
    const std::vector<Corners> added =
        divide_polygon(mesh_.points(), border, points_within(members, border), normal.normalized(), stretch_);
    for (const Corners& c : added)
      sum += (point(c[1]) - point(c[0])).cross(point(c[2]) - point(c[0])).norm();
    if (added.empty() || std::abs(sum - area) > error) return false;
    result.insert(result.end(), added.begin(), added.end());
    return true;
  }

  /// Vertices inside a face that are kept, since edges of other faces end there.
  std::vector<int> points_within(const Groups::Range& members, const std::vector<Link>& border) const
  {
    std::vector<int> on_border, kept, result;
    for (const Link& link : border)
      on_border.push_back(link[0]);
    for (int t : members)
      for (int v : corners(t))
        if (is_kept_[std::size_t(v)]) kept.push_back(v);
    std::sort(kept.begin(), kept.end());
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    std::set_difference(kept.begin(), kept.end(), on_border.begin(), on_border.end(), std::back_inserter(result));
    return result;
  }

  const Flat_faces& mesh_;
  Point direction_;
  Eigen::Matrix3d stretch_;
  std::vector<double> place_;    ///< indexed by vertex: place along the direction
  std::vector<int> face_;        ///< indexed by triangle: the number of its face
  std::vector<char> is_whole_;   ///< indexed by triangle: whether it is kept as it is
  std::vector<int> degree_;      ///< indexed by vertex: number of face edges that end there
  std::vector<Link> neighbours_; ///< indexed by vertex: its neighbours along face edges, if its degree is 2
  std::vector<char> is_kept_;    ///< indexed by vertex: whether it becomes a corner of triangles
};

/// Root of height² + width², with the height along y and the greatest horizontal width: no rotation about y changes it.
double upright_diagonal(const Points& points)
{
  Planar_points seen_from_above;
  for (const auto& p : points.colwise())
    seen_from_above.emplace_back(p.x(), p.z());
  const Planar_points hull = planar_hull(std::move(seen_from_above));
  double squared_width = 0;
  for (const Eigen::Vector2d& p : hull)
    for (const Eigen::Vector2d& q : hull)
      squared_width = std::max(squared_width, (p - q).squaredNorm());
  const double height = points.row(1).maxCoeff() - points.row(1).minCoeff();
  return std::sqrt(height * height + squared_width);
}

} // namespace

Canonical_surface::Canonical_surface(const Part_mesh& mesh, double tolerance)
    : given_(&mesh), faces_(std::make_shared<Flat_faces>(mesh, tolerance))
{}

Part_mesh Canonical_surface::mesh(const Eigen::Matrix3d& axes) const
{
  Part_mesh result = Divider(*faces_, axes)();
  return result.triangles.cols() == 0 || !has_area(result) ? *given_ : result;
}

std::vector<Canonical_surface> canonical_surfaces(const Segmented_shape& shape, const Eigen::Matrix3d& axes)
{
  const double size = upright_diagonal(axes.transpose() * all_vertices(shape));
  std::vector<Canonical_surface> result;
  for (const Shape_part& part : shape.parts())
    result.emplace_back(part.mesh, flatness_tolerance(size));
  return result;
}

Segmented_shape canonical_shape(const Segmented_shape& shape, const std::vector<Canonical_surface>& surfaces,
                                const Eigen::Matrix3d& axes)
{
  Segmented_shape result(shape.name(), shape.up());
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    result.add_part(shape.parts()[i].name, surfaces[i].mesh(axes));
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
