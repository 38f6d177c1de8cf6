// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/library_call.h"
#include "base/planar_hull.h"
#include "base/quantized.h"
#include "map/Charted_mesh.h"
#include "map/Piece_pair.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// A directed edge between vertices, counter-clockwise around the interior of a section.
using Section_side = std::array<int, 2>;

/// A triangulation of a planar section of a solid.
struct Section_filling
{
  Planar_points vertices; ///< vertices of the section, then intersections of its sides
  std::vector<std::array<int, 3>> triangles;
};

class Section_filler
{
public:
  Section_filler(const Planar_points& vertices, const std::vector<Section_side>& sides) : filling_{vertices, {}}
  {
    for (const Eigen::Vector2d& p : vertices) {
      handles_.push_back(triangulation_.insert({p.x(), p.y()}));
      set_number(handles_.back(), int(handles_.size()) - 1);
    }
    for (const Section_side& side : sides) {
      const Section_side places = in_order(side);
      if (places[0] == places[1] || constraints_.count(places)) continue;
      constraints_[places] =
          triangulation_.insert_constraint(handles_[std::size_t(places[0])], handles_[std::size_t(places[1])]);
    }
    for (const auto vertex : triangulation_.finite_vertex_handles())
      if (set_number(vertex, int(filling_.vertices.size())))
        filling_.vertices.emplace_back(vertex->point().x(), vertex->point().y());
    for (const Section_side& side : sides)
      add_strip(side);
    add_faces();
  }

  const Section_filling& operator()() const { return filling_; }

private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::optional<int>, Kernel>;
  using Face_base = CGAL::Triangulation_face_base_with_info_2<std::optional<int>, Kernel>;
  using Structure =
      CGAL::Triangulation_data_structure_2<Vertex, CGAL::Constrained_triangulation_face_base_2<Kernel, Face_base>>;
  using Triangulation = CGAL::Constrained_triangulation_plus_2<
      CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>>;
  using Handle = Triangulation::Vertex_handle;
  using Face = Triangulation::Face_handle;

  static int number(Handle vertex) { return *vertex->info(); }
  static bool set_number(Handle vertex, int number)
  {
    if (vertex->info()) return false;
    vertex->info() = number;
    return true;
  }

  /// The representative vertices of a side's ends (the first at the same position), the smaller one first.
  Section_side in_order(const Section_side& side) const
  {
    const int a = number(handles_[std::size_t(side[0])]), b = number(handles_[std::size_t(side[1])]);
    return {std::min(a, b), std::max(a, b)};
  }

  /// Adds the degenerate triangles between a side and the edges of the triangulation along it, and counts these edges.
  void add_strip(const Section_side& side)
  {
    std::vector<int> strip;
    const Section_side places = in_order(side);
    if (places[0] == places[1]) {
      strip = {places[0]};
    } else {
      const Triangulation::Constraint_id constraint = constraints_.at(places);
      for (auto vertex = triangulation_.vertices_in_constraint_begin(constraint);
           vertex != triangulation_.vertices_in_constraint_end(constraint); ++vertex)
        strip.push_back(number(*vertex));
      if (strip.front() == number(handles_[std::size_t(side[0])])) std::reverse(strip.begin(), strip.end());
    }
    for (std::size_t i = 0; i + 1 < strip.size(); ++i) {
      ++runs_[{strip[i + 1], strip[i]}];
      --runs_[{strip[i], strip[i + 1]}];
    }
    strip.insert(strip.begin(), side[1]);
    for (std::size_t i = 0; i + 1 < strip.size(); ++i)
      if (side[0] != strip[i] && side[0] != strip[i + 1] && strip[i] != strip[i + 1])
        filling_.triangles.push_back({side[0], strip[i], strip[i + 1]});
  }

  /// Adds every face as often as its winding number, which is propagated from the outside inwards.
  void add_faces()
  {
    if (triangulation_.dimension() < 2) return;
    std::vector<Face> faces = {triangulation_.infinite_face()};
    faces[0]->info() = 0;
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (int i = 0; i < 3; ++i) {
        const Face next = faces[f]->neighbor(i);
        if (next->info()) continue;
        next->info() = *faces[f]->info() - runs_along(faces[f], i);
        faces.push_back(next);
      }
    for (const Face face : faces) {
      if (triangulation_.is_infinite(face)) continue;
      std::array<int, 3> corners = {number(face->vertex(0)), number(face->vertex(1)), number(face->vertex(2))};
      if (*face->info() < 0) std::swap(corners[0], corners[1]);
      filling_.triangles.insert(filling_.triangles.end(), std::size_t(std::abs(*face->info())), corners);
    }
  }

  /// The number of sides along an edge with the face on their left, minus the number with it on their right.
  int runs_along(Face face, int edge) const
  {
    const Handle from = face->vertex(Triangulation::ccw(edge)), to = face->vertex(Triangulation::cw(edge));
    if (triangulation_.is_infinite(from) || triangulation_.is_infinite(to)) return 0;
    const auto found = runs_.find({number(from), number(to)});
    return found == runs_.end() ? 0 : found->second;
  }

  Section_filling filling_;
  Triangulation triangulation_;
  std::vector<Handle> handles_;                                      ///< indexed by vertex of the section
  std::map<Section_side, Triangulation::Constraint_id> constraints_; ///< indexed by representative vertices
  /// For each directed edge, the number of sides along it minus that of sides in the opposite direction.
  std::map<Section_side, int> runs_;
};

/// Fills the section of a solid with triangles that use each of its sides once, so that the solid stays closed. If
/// sides cross or vertices coincide, because the solid's surface touches itself, this takes degenerate triangles.
/// Usually O(n log n) for n sides.
Section_filling fill_section(const Planar_points& vertices, const std::vector<Section_side>& sides)
{
  return library_call(
      "section", [&] { return Section_filler(vertices, sides)(); },
      [&] {
        return Section_filling{vertices, {}};
      });
}

/// Cuts parts into pieces, one side of the piece after the other.
class Part_cutter
{
public:
  Part_cutter(const Points& points, const Eigen::Matrix3Xi& triangles, const Part_chart& chart)
      : chart_(chart), mesh_(points, triangles)
  {
    add_coordinates();
  }

  /// Removes everything below (`is_low`) or above `at` in a coordinate, and fills the section if it is closed. A part
  /// that lies there entirely is shrunk to a tiny copy at its nearest point.
  void cut(int axis, double at, bool is_low)
  {
    const auto beyond = [&](int i) {
      const double beyond_at = coordinates_[std::size_t(i)][axis] - at;
      return is_low ? -beyond_at : beyond_at;
    };
    mesh_.split_edges([&](int a, int b) {
      const double x = beyond(a), y = beyond(b);
      return x * y < 0 && std::abs(x) > on_side && std::abs(y) > on_side ? x / (x - y) : -1;
    });
    for (std::size_t i = add_coordinates(); i < coordinates_.size(); ++i)
      coordinates_[i][axis] = at;
    const auto is_beyond = [&](const std::array<int, 3>& corners) {
      return std::all_of(corners.begin(), corners.end(), [&](int corner) { return beyond(corner) >= -on_side; });
    };
    int nearest = mesh_.corners(0)[0];
    bool all_beyond = true;
    for (std::size_t t = 0; t < mesh_.number_of_triangles(); ++t) {
      all_beyond = all_beyond && is_beyond(mesh_.corners(t));
      for (int corner : mesh_.corners(t))
        if (beyond(corner) < beyond(nearest)) nearest = corner;
    }
    if (all_beyond) {
      shrink_to(nearest);
      return;
    }
    mesh_.remove_triangles_if(is_beyond);
    const auto is_on_side = [&](int i) { return beyond(i) >= -on_side; };
    straighten(axis, at, is_on_side);
    close(axis, at, is_on_side);
  }

  /// The piece, without unused vertices.
  Part_mesh mesh() const
  {
    const Points points = mesh_.points();
    Part_mesh result{Points(3, points.cols()), mesh_.triangles()};
    std::vector<int> number(std::size_t(points.cols()), -1);
    int count = 0;
    for (Eigen::Index t = 0; t < result.triangles.cols(); ++t)
      for (int& corner : result.triangles.col(t)) {
        int& own = number[std::size_t(corner)];
        if (own < 0) {
          own = count++;
          result.points.col(own) = points.col(corner);
        }
        corner = own;
      }
    result.points.conservativeResize(3, count);
    return result;
  }

private:
  static constexpr double on_side = 1e-9;  ///< distance from a cut, in chart coordinates, up to which points are on it
  static constexpr double straight = 1e-3; ///< least deviation from the chart of edges to split, over the height
  static constexpr int most_rounds = 8;    ///< number of rounds of splitting edges that deviate more

  /// Computes the coordinates of new points. \return the previous number of points
  std::size_t add_coordinates()
  {
    const std::size_t before = coordinates_.size();
    for (std::size_t i = before; i < mesh_.number_of_points(); ++i)
      coordinates_.push_back(chart_.coordinates(mesh_.point(int(i))));
    return before;
  }

  void shrink_to(int point)
  {
    constexpr double speck = 1e-3; // factor of the part's size
    const Point to = mesh_.point(point);
    for (int i = 0; i < int(coordinates_.size()); ++i) {
      mesh_.move(i, to + speck * (mesh_.point(i) - to));
      coordinates_[std::size_t(i)] = chart_.coordinates(mesh_.point(i));
    }
  }

  /// Splits the sides of the section until they are straight in the chart.
  template <typename Is_on_side>
  void straighten(int axis, double at, const Is_on_side& is_on_side)
  {
    const auto where = [&](int a, int b) {
      if (!is_on_side(a) || !is_on_side(b)) return -1.;
      Point k = chart_.coordinates((mesh_.point(a) + mesh_.point(b)) / 2);
      k[axis] = at;
      const Point straight_on = (coordinates_[std::size_t(a)] + coordinates_[std::size_t(b)]) / 2;
      return (chart_(k) - chart_(straight_on)).norm() > straight ? 0.5 : -1.;
    };
    for (int round = 0; round < most_rounds && mesh_.split_edges(where); ++round)
      for (std::size_t i = add_coordinates(); i < coordinates_.size(); ++i)
        coordinates_[i][axis] = at;
  }

  template <typename Is_on_side>
  void close(int axis, double at, const Is_on_side& is_on_side)
  {
    std::vector<int> points; // indexed by vertex of the section
    std::map<int, int> vertex;
    const auto number = [&](int point) {
      const auto [known, is_new] = vertex.try_emplace(point, int(points.size()));
      if (is_new) points.push_back(point);
      return known->second;
    };
    std::vector<Section_side> sides;
    for (std::size_t t = 0; t < mesh_.number_of_triangles(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const int a = mesh_.corners(t)[i], b = mesh_.corners(t)[(i + 1) % 3];
        if (is_on_side(a) && is_on_side(b)) sides.push_back({number(b), number(a)});
      }
    Planar_points vertices;
    for (int point : points) {
      const Point& k = coordinates_[std::size_t(point)];
      vertices.emplace_back(k[(axis + 1) % 3], k[(axis + 2) % 3]);
    }
    if (sides.empty() || !is_closed(sides, vertices)) return;
    add_filling(axis, at, points, sides, fill_section(vertices, sides));
  }

  /// Adds a filling to the mesh. \param points indices in the mesh of the section's vertices, first in the filling
  void add_filling(int axis, double at, std::vector<int> points, const std::vector<Section_side>& sides,
                   const Section_filling& filling)
  {
    const std::size_t given = points.size();
    Points places(3, Eigen::Index(filling.vertices.size()));
    std::vector<Point> coordinates;
    for (std::size_t i = 0; i < filling.vertices.size(); ++i) {
      Point k;
      k[axis] = at;
      k[(axis + 1) % 3] = filling.vertices[i].x();
      k[(axis + 2) % 3] = filling.vertices[i].y();
      places.col(Eigen::Index(i)) = i < given ? mesh_.point(points[i]) : chart_(k);
      coordinates.push_back(k);
    }
    Subdivision section(places, triangles_of(filling));
    bend(section, coordinates, sides);
    for (std::size_t i = given; i < coordinates.size(); ++i) {
      points.push_back(mesh_.add_point(section.point(int(i))));
      coordinates_.push_back(coordinates[i]);
    }
    for (std::size_t t = 0; t < section.number_of_triangles(); ++t) {
      const std::array<int, 3>& corners = section.corners(t);
      mesh_.add_triangle(
          {points[std::size_t(corners[0])], points[std::size_t(corners[1])], points[std::size_t(corners[2])]});
    }
  }

  static Eigen::Matrix3Xi triangles_of(const Section_filling& filling)
  {
    Eigen::Matrix3Xi result(3, Eigen::Index(filling.triangles.size()));
    for (Eigen::Index t = 0; t < result.cols(); ++t)
      for (int i = 0; i < 3; ++i)
        result(i, t) = filling.triangles[std::size_t(t)][std::size_t(i)];
    return result;
  }

  /// Splits the inner edges of a filling until it follows the chart, which long edges in a bent part do not.
  void bend(Subdivision& section, std::vector<Point>& coordinates, const std::vector<Section_side>& sides) const
  {
    std::set<Section_side> kept;
    for (const auto& [a, b] : sides)
      kept.insert({std::min(a, b), std::max(a, b)});
    const auto bend_of = [&](int a, int b) -> Point {
      const Point &k = coordinates[std::size_t(a)], &l = coordinates[std::size_t(b)];
      return chart_((k + l) / 2) - (chart_(k) + chart_(l)) / 2;
    };
    std::vector<Section_side> bent;
    const auto error = [&](int i) { return (chart_(coordinates[std::size_t(i)]) - section.point(i)).norm(); };
    const auto where = [&](int a, int b) {
      const double by = bend_of(a, b).norm();
      if (kept.count({a, b}) || by <= straight || by <= error(a) + error(b)) return -1.;
      bent.push_back({a, b});
      return 0.5;
    };
    for (int round = 0; round < most_rounds && section.split_edges(where); ++round) {
      for (const auto& [a, b] : bent) {
        const int middle = int(coordinates.size());
        section.move(middle, section.point(middle) + bend_of(a, b));
        coordinates.push_back((coordinates[std::size_t(a)] + coordinates[std::size_t(b)]) / 2);
      }
      bent.clear();
    }
  }

  /// Whether the sides form closed curves: at every position as many of them end as begin.
  static bool is_closed(const std::vector<Section_side>& sides, const Planar_points& vertices)
  {
    std::map<std::array<std::int64_t, 2>, int> balance;
    const auto place = [&](int vertex) {
      const Eigen::Vector2d& p = vertices[std::size_t(vertex)];
      return std::array<std::int64_t, 2>{quantized(p.x()), quantized(p.y())};
    };
    for (const auto& [a, b] : sides)
      --balance[place(a)], ++balance[place(b)];
    return std::all_of(balance.begin(), balance.end(), [](const auto& place) { return place.second == 0; });
  }

  const Part_chart& chart_;
  Subdivision mesh_;
  std::vector<Point> coordinates_;
};

} // namespace

Part_mesh piece_of(const Part_mesh& part, const Part_chart& chart, const Chart_box& box)
{
  if (is_whole(box)) return part;
  Part_cutter cutter(part.points, part.triangles, chart);
  for (int axis = 0; axis < 3; ++axis) {
    if (box.min()[axis] > -1) cutter.cut(axis, box.min()[axis], true);
    if (box.max()[axis] < 1) cutter.cut(axis, box.max()[axis], false);
  }
  return cutter.mesh();
}

} // namespace CGAL::Shape_correspondence::internal
