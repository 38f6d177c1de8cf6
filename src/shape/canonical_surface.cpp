// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/canonical_surface.h"
#include "base/generic_direction.h"
#include "base/library_call.h"
#include "shape/all_vertices.h"
#include "shape/has_area.h"
#include "shape/meshes.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

using Corners = std::array<int, 3>;
using Link = std::array<int, 2>; // from a vertex to another one

constexpr int no_number = -1;

enum class Side { UNKNOWN, INSIDE, OUTSIDE };

using Planar_triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Mesh_kernel,
    CGAL::Triangulation_data_structure_2<
        CGAL::Triangulation_vertex_base_with_info_2<int, Mesh_kernel>,
        CGAL::Triangulation_face_base_with_info_2<Side, Mesh_kernel,
                                                  CGAL::Constrained_triangulation_face_base_2<Mesh_kernel>>>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;

/// An edge of a triangle; `along`: it runs from the lower vertex to the higher one.
struct Side_of_triangle
{
  Link vertices; ///< the lower one first
  int triangle;
  int number; ///< of the side in the triangle
  bool along;
};

Corners lowest_first(Corners corners)
{
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

Corners sorted(Corners corners)
{
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// The connected flat faces of a mesh.
class Flat_faces
{
public:
  /// \param direction along which vertices are sorted
  Flat_faces(const Part_mesh& mesh, const Point& direction, double tolerance) : tolerance_(tolerance)
  {
    take_vertices(mesh, direction);
    find_sides();
    grow_faces();
  }

  /// \param stretch a linear map before Delaunay triangulations, which settles ties
  std::vector<Corners> divided(const Eigen::Matrix3d& stretch) const
  {
    std::vector<char> is_whole(members_.size(), 0); // faces that keep their triangles
    while (true) {
      const Outline outline = outline_of(is_whole);
      std::vector<Corners> result;
      bool failed = false;
      for (std::size_t face = 0; face < members_.size(); ++face) {
        if (is_whole[face]) {
          for (int t : members_[face])
            result.push_back(triangles_[std::size_t(t)]);
        } else if (!divide(face, outline, stretch, result)) {
          is_whole[face] = 1;
          failed = true;
        }
      }
      if (!failed) return result;
    }
  }

  const std::vector<Point>& points() const { return points_; }

private:
  /// Edges of the faces, and the vertices that stay.
  struct Outline
  {
    std::vector<int> degree;      ///< by vertex, number of edges
    std::vector<Link> neighbours; ///< of a vertex of degree 2
    std::vector<char> is_kept;    ///< by vertex
  };

  const Point& point(int v) const { return points_[std::size_t(v)]; }

  Point area_vector_of(const Corners& corners) const
  {
    return (point(corners[1]) - point(corners[0])).cross(point(corners[2]) - point(corners[0]));
  }

  /// Vertices and triangles, equal ones once, sorted.
  void take_vertices(const Part_mesh& mesh, const Point& direction)
  {
    const Point low = mesh.points.rowwise().minCoeff();
    const auto place = [&](int v) {
      const Point p = mesh.points.col(v);
      return std::tuple(direction.dot(p - low), p.x(), p.y(), p.z());
    };
    std::vector<int> used(mesh.triangles.data(), mesh.triangles.data() + mesh.triangles.size());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    std::sort(used.begin(), used.end(), [&](int a, int b) { return place(a) < place(b); });
    std::vector<int> number(std::size_t(mesh.points.cols()), no_number);
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (i == 0 || place(used[i]) != place(used[i - 1])) points_.push_back(mesh.points.col(used[i]));
      number[std::size_t(used[i])] = int(points_.size()) - 1;
    }
    for (const auto& t : mesh.triangles.colwise()) {
      const Corners corners{number[std::size_t(t[0])], number[std::size_t(t[1])], number[std::size_t(t[2])]};
      if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
        triangles_.push_back(lowest_first(corners));
    }
    std::sort(triangles_.begin(), triangles_.end());
  }

  void find_sides()
  {
    sides_.reserve(3 * triangles_.size());
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        const int a = triangles_[t][std::size_t(k)], b = triangles_[t][std::size_t((k + 1) % 3)];
        sides_.push_back({{std::min(a, b), std::max(a, b)}, int(t), k, a < b});
      }
    std::sort(sides_.begin(), sides_.end(), [](const Side_of_triangle& a, const Side_of_triangle& b) {
      return std::tie(a.vertices, a.triangle) < std::tie(b.vertices, b.triangle);
    });
    neighbours_.assign(triangles_.size(), {no_number, no_number, no_number});
    for_each_edge([&](std::size_t begin, std::size_t end) {
      if (end - begin == 2 || end - begin == 4) join_sides(begin, end);
    });
  }

  int& neighbour_at(const Side_of_triangle& side)
  {
    return neighbours_[std::size_t(side.triangle)][std::size_t(side.number)];
  }

  /// Makes neighbours of triangles that are turned alike; where a sheet has a back, of those of one side.
  void join_sides(std::size_t begin, std::size_t end)
  {
    const auto normal = [&](std::size_t i) {
      return area_vector_of(triangles_[std::size_t(sides_[i].triangle)]).normalized();
    };
    for (std::size_t i = begin; i < end; ++i) {
      if (!sides_[i].along) continue;
      std::pair best(-2., end);
      for (std::size_t j = begin; j < end; ++j)
        if (!sides_[j].along && neighbour_at(sides_[j]) == no_number)
          best = std::max(best, std::pair(end - begin == 2 ? 1 : normal(i).dot(normal(j)), j));
      if (best.second == end) continue;
      neighbour_at(sides_[i]) = sides_[best.second].triangle;
      neighbour_at(sides_[best.second]) = sides_[i].triangle;
    }
  }

  template <typename Function>
  void for_each_edge(const Function& function) const
  {
    for (std::size_t begin = 0, end = 0; begin < sides_.size(); begin = end) {
      while (end < sides_.size() && sides_[end].vertices == sides_[begin].vertices)
        ++end;
      function(begin, end);
    }
  }

  /// Joins triangles to flat faces, from the largest triangle on.
  void grow_faces()
  {
    const double steps = 3; // per unit of the logarithm of an area: rounding does not decide between equal areas
    std::vector<double> areas;
    for (const Corners& corners : triangles_) {
      const double area = area_vector_of(corners).norm();
      areas.push_back(area > 0 ? std::round(steps * std::log(area)) : std::numeric_limits<double>::lowest());
    }
    std::vector<std::size_t> order(triangles_.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return areas[a] > areas[b]; });
    face_.assign(triangles_.size(), no_number);
    for (std::size_t t : order)
      if (face_[t] == no_number) grow(int(t));
  }

  void grow(int seed)
  {
    const int face = int(members_.size());
    std::vector<int> members{seed};
    face_[std::size_t(seed)] = face;
    Point normal = Point::Zero(), moment = Point::Zero(); // area vectors; centres by area
    double area = 0;
    for (std::size_t i = 0; i < members.size(); ++i) {
      const Corners& corners = triangles_[std::size_t(members[i])];
      const Point added = area_vector_of(corners);
      normal += added;
      area += added.norm();
      moment += added.norm() * (point(corners[0]) + point(corners[1]) + point(corners[2])) / 3;
      for (int next : neighbours_[std::size_t(members[i])]) {
        if (next == no_number || face_[std::size_t(next)] != no_number || !(area > 0)) continue;
        if (!is_flat(triangles_[std::size_t(next)], normal.normalized(), moment / area)) continue;
        face_[std::size_t(next)] = face;
        members.push_back(next);
      }
    }
    std::sort(members.begin(), members.end());
    members_.push_back(std::move(members));
  }

  /// Whether a triangle lies in a plane, without being folded over.
  bool is_flat(const Corners& corners, const Point& normal, const Point& centre) const
  {
    const double least_cosine = 0.5;
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::abs(normal.dot(point(corners[k]) - centre)) > tolerance_) return false;
      longest = std::max(longest, (point(corners[(k + 1) % 3]) - point(corners[k])).norm());
    }
    const Point area = area_vector_of(corners);
    return area.dot(normal) > least_cosine * area.norm() || area.norm() <= tolerance_ * longest;
  }

  bool is_within_face(std::size_t begin, std::size_t end, const std::vector<char>& is_whole) const
  {
    return std::all_of(sides_.begin() + std::ptrdiff_t(begin), sides_.begin() + std::ptrdiff_t(end),
                       [&](const Side_of_triangle& side) {
                         const int next = neighbours_[std::size_t(side.triangle)][std::size_t(side.number)];
                         const int face = face_[std::size_t(side.triangle)];
                         return next != no_number && face_[std::size_t(next)] == face && !is_whole[std::size_t(face)];
                       });
  }

  Outline outline_of(const std::vector<char>& is_whole) const
  {
    Outline result{std::vector<int>(points_.size(), 0), std::vector<Link>(points_.size(), {no_number, no_number}),
                   std::vector<char>(points_.size(), 0)};
    for_each_edge([&](std::size_t begin, std::size_t end) {
      if (is_within_face(begin, end, is_whole)) return;
      const auto [a, b] = sides_[begin].vertices;
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
        int& degree = result.degree[std::size_t(from)];
        if (degree < 2) result.neighbours[std::size_t(from)][std::size_t(degree)] = to;
        ++degree;
      }
    });
    for (std::size_t v = 0; v < points_.size(); ++v)
      result.is_kept[v] = result.degree[v] > 0 && !(result.degree[v] == 2 && is_straight(result, v));
    for (std::size_t face = 0; face < members_.size(); ++face)
      if (is_whole[face])
        for (int t : members_[face])
          for (int v : triangles_[std::size_t(t)])
            result.is_kept[std::size_t(v)] = 1;
    keep_bends(result);
    return result;
  }

  bool is_near_line(const Point& p, const Point& a, const Point& b) const
  {
    const Point along = b - a, way = p - a;
    const double place = way.dot(along);
    return place > 0 && place < along.squaredNorm() && along.cross(way).norm() <= tolerance_ * along.norm();
  }

  bool is_straight(const Outline& outline, std::size_t v) const
  {
    const Link& ends = outline.neighbours[v];
    return is_near_line(points_[v], point(ends[0]), point(ends[1]));
  }

  /// The next vertex of a chain of vertices that are left out.
  static int next_of(const Outline& outline, int before, int at)
  {
    const Link& ends = outline.neighbours[std::size_t(at)];
    return ends[0] == before ? ends[1] : ends[0];
  }

  /// Keeps further vertices of chains that bend slowly, or that nothing else holds.
  void keep_bends(Outline& outline) const
  {
    std::vector<char> is_done(points_.size(), 0);
    for (std::size_t v = 0; v < points_.size(); ++v) {
      if (outline.is_kept[v] || outline.degree[v] == 0 || is_done[v]) continue;
      std::vector<int> chain = chain_around(outline, int(v));
      for (int w : chain)
        is_done[std::size_t(w)] = 1;
      if (chain.front() == chain.back()) {
        for (int w : chain)
          outline.is_kept[std::size_t(w)] = 1;
        continue;
      }
      if (chain.front() > chain.back()) std::reverse(chain.begin(), chain.end());
      const std::size_t longest = 1000; // vertices that are left out in a row, for the time
      std::size_t last = 0;
      for (std::size_t i = 2; i < chain.size(); ++i) {
        bool is_straight = i - last < longest;
        for (std::size_t k = last + 1; k < i && is_straight; ++k)
          is_straight = is_near_line(point(chain[k]), point(chain[last]), point(chain[i]));
        if (is_straight) continue;
        last = i - 1;
        outline.is_kept[std::size_t(chain[last])] = 1;
      }
    }
  }

  /// The vertices from one that is kept to the next one that is, by way of `v`; a cycle begins and ends with `v`.
  std::vector<int> chain_around(const Outline& outline, int v) const
  {
    std::vector<int> result{v};
    for (int direction = 0; direction < 2; ++direction) {
      int before = v, at = outline.neighbours[std::size_t(v)][std::size_t(direction)];
      result.push_back(at);
      while (!outline.is_kept[std::size_t(at)]) {
        if (at == v) return result;
        const int next = next_of(outline, before, at);
        before = at;
        at = next;
        result.push_back(at);
      }
      std::reverse(result.begin(), result.end());
    }
    std::reverse(result.begin(), result.end());
    return result;
  }

  /// The border of a face, from vertex to vertex that is kept, the face on the left.
  std::vector<Link> border_of(std::size_t face, const Outline& outline) const
  {
    std::vector<Link> result;
    for (int t : members_[face])
      for (std::size_t k = 0; k < 3; ++k) {
        const int next = neighbours_[std::size_t(t)][k];
        if (next != no_number && face_[std::size_t(next)] == int(face)) continue;
        int from = triangles_[std::size_t(t)][k], to = triangles_[std::size_t(t)][(k + 1) % 3];
        if (!outline.is_kept[std::size_t(from)]) continue;
        const int start = from;
        while (!outline.is_kept[std::size_t(to)]) {
          const int after = next_of(outline, from, to);
          from = to;
          to = after;
        }
        result.push_back({start, to});
      }
    std::sort(result.begin(), result.end());
    return result;
  }

  /// Adds the triangles of a face. \return whether it can be divided
  bool divide(std::size_t face, const Outline& outline, const Eigen::Matrix3d& stretch,
              std::vector<Corners>& result) const
  {
    const std::vector<Link> border = border_of(face, outline);
    const Point origin = border.empty() ? Point::Zero() : point(border[0][0]);
    Point normal = Point::Zero();
    double length = 0, area = 0;
    for (const auto& [a, b] : border) {
      normal += (point(a) - origin).cross(point(b) - origin);
      length += (point(b) - point(a)).norm();
    }
    for (int t : members_[face])
      area += area_vector_of(triangles_[std::size_t(t)]).norm();
    const double error = tolerance_ * length + 1e-3 * area; // of twice the area
    if (std::abs(normal.norm() - area) > error) return false;
    if (normal.norm() <= tolerance_ * length) return border.size() < 3; // next to nothing
    if (std::adjacent_find(border.begin(), border.end()) != border.end()) return false;
    std::vector<Corners> added = border.size() == 3   ? triangle_of_border(border)
                                 : border.size() == 4 ? quad_of_border(border, normal.normalized(), stretch)
                                                      : std::vector<Corners>();
    if (added.empty()) // CGAL throws on borders that cross
      added = library_call(
          "flat face",
          [&] { return triangulated(border, points_within(face, border, outline), normal.normalized(), stretch); },
          [] { return std::vector<Corners>(); });
    double sum = 0;
    for (const Corners& corners : added)
      sum += area_vector_of(corners).norm();
    if (added.empty() || std::abs(sum - area) > error) return false;
    result.insert(result.end(), added.begin(), added.end());
    return true;
  }

  static int after(const std::vector<Link>& border, int v)
  {
    const auto found = std::lower_bound(border.begin(), border.end(), Link{v, 0});
    return found == border.end() || (*found)[0] != v ? no_number : (*found)[1];
  }

  static std::vector<Corners> triangle_of_border(const std::vector<Link>& border)
  {
    const int a = border[0][0], b = border[0][1], c = after(border, b);
    if (c == no_number || after(border, c) != a) return {};
    return {{a, b, c}};
  }

  /// The better one of the two ways to divide a quadrangle.
  std::vector<Corners> quad_of_border(const std::vector<Link>& border, const Point& normal,
                                      const Eigen::Matrix3d& stretch) const
  {
    const int a = border[0][0], b = border[0][1], c = after(border, b);
    const int d = c == no_number ? no_number : after(border, c);
    if (d == no_number || d == a || after(border, d) != a) return {};
    const std::array<std::vector<Corners>, 2> ways{std::vector<Corners>{{a, b, c}, {a, c, d}},
                                                   std::vector<Corners>{{b, c, d}, {b, d, a}}};
    std::array<bool, 2> is_valid{};
    for (std::size_t i = 0; i < 2; ++i)
      is_valid[i] = std::all_of(ways[i].begin(), ways[i].end(),
                                [&](const Corners& corners) { return area_vector_of(corners).dot(normal) > 0; });
    if (!is_valid[0] && !is_valid[1]) return {};
    if (is_valid[0] != is_valid[1]) return ways[is_valid[0] ? 0 : 1];
    const auto angle = [&](int at, int p, int q) {
      const Point u = stretch * (point(p) - point(at)), v = stretch * (point(q) - point(at));
      return std::atan2(u.cross(v).norm(), u.dot(v));
    };
    return ways[angle(b, a, c) + angle(d, a, c) <= angle(a, b, d) + angle(c, b, d) ? 0 : 1];
  }

  /// Vertices that are kept for other faces, though they are within this one.
  std::vector<int> points_within(std::size_t face, const std::vector<Link>& border, const Outline& outline) const
  {
    std::vector<int> on_border, kept, result;
    for (const Link& link : border)
      on_border.insert(on_border.end(), link.begin(), link.end());
    std::sort(on_border.begin(), on_border.end());
    for (int t : members_[face])
      for (int v : triangles_[std::size_t(t)])
        if (outline.is_kept[std::size_t(v)]) kept.push_back(v);
    std::sort(kept.begin(), kept.end());
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    std::set_difference(kept.begin(), kept.end(), on_border.begin(), on_border.end(), std::back_inserter(result));
    return result;
  }

  std::vector<Corners> triangulated(const std::vector<Link>& border, const std::vector<int>& within,
                                    const Point& normal, const Eigen::Matrix3d& stretch) const
  {
    const Point up = (stretch.inverse().transpose() * normal).normalized();
    const Point u = up.unitOrthogonal(), v = up.cross(u);
    const Point origin = point(border[0][0]);
    Planar_triangulation triangulation;
    bool is_doubled = false;
    std::vector<std::pair<int, Planar_triangulation::Vertex_handle>> handles; // sorted
    const auto insert = [&](int number) {
      const auto found =
          std::lower_bound(handles.begin(), handles.end(), std::pair(number, Planar_triangulation::Vertex_handle()),
                           [](const auto& a, const auto& b) { return a.first < b.first; });
      if (found != handles.end() && found->first == number) return;
      const Point p = stretch * (point(number) - origin);
      const std::size_t before = triangulation.number_of_vertices();
      const auto near = handles.empty() ? Planar_triangulation::Face_handle() : handles.back().second->face();
      const auto handle = triangulation.insert({p.dot(u), p.dot(v)}, near);
      is_doubled = is_doubled || triangulation.number_of_vertices() == before;
      handle->info() = number;
      handles.insert(found, {number, handle});
    };
    for (const Link& link : border)
      insert(link[0]);
    for (int number : within)
      insert(number);
    if (is_doubled) return {};
    const auto handle_of = [&](int number) {
      return std::lower_bound(handles.begin(), handles.end(), number, [](const auto& a, int b) { return a.first < b; })
          ->second;
    };
    for (const Link& link : border)
      triangulation.insert_constraint(handle_of(link[0]), handle_of(link[1]));
    if (triangulation.dimension() < 2) return {};
    return inside_of(triangulation, border, handle_of);
  }

  template <typename Handle_of>
  static std::vector<Corners> inside_of(Planar_triangulation& triangulation, const std::vector<Link>& border,
                                        const Handle_of& handle_of)
  {
    for (auto face : triangulation.all_face_handles())
      face->info() = Side::UNKNOWN;
    std::vector<Planar_triangulation::Face_handle> front;
    bool is_clear = true;
    const auto mark = [&](Planar_triangulation::Face_handle face, Side side) {
      if (face->info() == Side::UNKNOWN) {
        face->info() = side;
        front.push_back(face);
      }
      is_clear = is_clear && face->info() == side;
    };
    for (const Link& link : border) {
      Planar_triangulation::Face_handle face;
      int opposite = 0;
      if (!triangulation.is_edge(handle_of(link[0]), handle_of(link[1]), face, opposite)) return {};
      // The edge of a face runs from its vertex ccw(opposite) to cw(opposite), the face on the left
      const bool is_left = face->vertex(triangulation.ccw(opposite)) == handle_of(link[0]);
      mark(face, is_left ? Side::INSIDE : Side::OUTSIDE);
      mark(face->neighbor(opposite), is_left ? Side::OUTSIDE : Side::INSIDE);
    }
    while (!front.empty()) {
      const auto face = front.back();
      front.pop_back();
      for (int k = 0; k < 3; ++k)
        if (!face->is_constrained(k)) mark(face->neighbor(k), face->info());
    }
    std::vector<Corners> result;
    for (auto face : triangulation.finite_face_handles())
      if (face->info() == Side::INSIDE)
        result.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    return is_clear ? result : std::vector<Corners>();
  }

  double tolerance_;
  std::vector<Point> points_;
  std::vector<Corners> triangles_;
  std::vector<Side_of_triangle> sides_;   ///< those of one edge beside each other
  std::vector<Corners> neighbours_;       ///< by triangle and side, the only other triangle there, turned alike
  std::vector<int> face_;                 ///< by triangle
  std::vector<std::vector<int>> members_; ///< triangles of the faces
};

/// Points and triangles, each once, sorted by their places along a direction.
Part_mesh sorted_mesh(const std::vector<Point>& points, std::vector<Corners> triangles, const Point& direction)
{
  for (Corners& corners : triangles)
    corners = lowest_first(corners);
  std::sort(triangles.begin(), triangles.end(),
            [](const Corners& a, const Corners& b) { return std::pair(sorted(a), a) < std::pair(sorted(b), b); });
  const auto is_same = [](const Corners& a, const Corners& b) { return sorted(a) == sorted(b); };
  triangles.erase(std::unique(triangles.begin(), triangles.end(), is_same), triangles.end());
  std::vector<int> order;
  for (const Corners& corners : triangles)
    order.insert(order.end(), corners.begin(), corners.end());
  std::sort(order.begin(), order.end());
  order.erase(std::unique(order.begin(), order.end()), order.end());
  std::vector<double> place(points.size());
  for (int v : order)
    place[std::size_t(v)] = direction.dot(points[std::size_t(v)] - points[0]);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return place[std::size_t(a)] < place[std::size_t(b)]; });
  std::vector<int> number(points.size(), no_number);
  Part_mesh result;
  result.points.resize(3, Eigen::Index(order.size()));
  for (std::size_t i = 0; i < order.size(); ++i) {
    number[std::size_t(order[i])] = int(i);
    result.points.col(Eigen::Index(i)) = points[std::size_t(order[i])];
  }
  std::vector<std::pair<double, Corners>> keyed;
  for (const Corners& corners : triangles) {
    const Corners c = lowest_first(
        {number[std::size_t(corners[0])], number[std::size_t(corners[1])], number[std::size_t(corners[2])]});
    double sum = 0;
    for (int v : sorted(c))
      sum += place[std::size_t(order[std::size_t(v)])];
    keyed.emplace_back(sum, c);
  }
  std::sort(keyed.begin(), keyed.end());
  result.triangles.resize(3, Eigen::Index(keyed.size()));
  for (std::size_t t = 0; t < keyed.size(); ++t)
    result.triangles.col(Eigen::Index(t)) << keyed[t].second[0], keyed[t].second[1], keyed[t].second[2];
  return result;
}

} // namespace

Part_mesh canonical_surface(const Part_mesh& mesh, double tolerance, const Eigen::Matrix3d& axes)
{
  const double stretch = 0.15; // enough to settle ties, little enough for round triangles
  const double exact = 2e-4;   // flatness of what is exactly flat, as a fraction of the tolerance
  const Point direction = axes * generic_direction();
  const Eigen::Matrix3d stretched = Eigen::Matrix3d::Identity() + stretch * direction * direction.transpose();
  Part_mesh result = mesh;
  // What is exactly flat first, since which of nearly flat triangles make a face depends on the triangles
  for (const double flat : {exact * tolerance, tolerance}) {
    const Flat_faces faces(result, direction, flat);
    result = sorted_mesh(faces.points(), faces.divided(stretched), direction);
    if (result.triangles.cols() == 0 || !has_area(result)) return mesh;
  }
  return result;
}

Segmented_shape canonical_shape(const Segmented_shape& shape, const Eigen::Matrix3d& axes)
{
  const double size = diagonal(axes.transpose() * all_vertices(shape)); // turns do not change it
  Segmented_shape result(shape.name(), shape.up());
  for (const Shape_part& part : shape.parts())
    result.add_part(part.name, canonical_surface(part.mesh, flatness_tolerance(size), axes));
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
