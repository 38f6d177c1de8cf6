// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MAP_PART_CUTTER_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MAP_PART_CUTTER_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/internal/map/Part_pair.h>
#include <CGAL/Shape_correspondence/internal/map/Subdivision.h>
#include <CGAL/Shape_correspondence/internal/planar_hull.h>
#include <CGAL/Shape_correspondence/internal/quantized.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// What fills a section of a solid, in the plane.
struct Section_filling
{
  Planar_points vertices; ///< those of the section, then those where its sides cross each other
  std::vector<std::array<int, 3>> triangles;
};

/// Fills the section of a solid with triangles that run along each of its sides once, so that the solid stays closed.
/// Where sides cross each other or vertices are in one place, as they are if the solid's surface touches itself, that
/// takes triangles without area.
class Section_filler
{
public:
  using Side = std::array<int, 2>; ///< from vertex to vertex, counter-clockwise around what they enclose

  Section_filler(const Planar_points& vertices, const std::vector<Side>& sides) : filling_{vertices, {}}
  {
    for (const Eigen::Vector2d& p : vertices) {
      handles_.push_back(triangulation_.insert({p.x(), p.y()}));
      set_number(handles_.back(), int(handles_.size()) - 1);
    }
    for (const Side& side : sides) {
      const Side places = in_order(side);
      if (places[0] == places[1] || constraints_.count(places)) continue;
      constraints_[places] =
          triangulation_.insert_constraint(handles_[std::size_t(places[0])], handles_[std::size_t(places[1])]);
    }
    for (const auto vertex : triangulation_.finite_vertex_handles())
      if (set_number(vertex, int(filling_.vertices.size())))
        filling_.vertices.emplace_back(vertex->point().x(), vertex->point().y());
    for (const Side& side : sides)
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

  /// The first vertices in the places of a side's ends, the smaller one first.
  Side in_order(const Side& side) const
  {
    const int a = number(handles_[std::size_t(side[0])]), b = number(handles_[std::size_t(side[1])]);
    return {std::min(a, b), std::max(a, b)};
  }

  /// What is between a side and the edges of the triangulation that it runs along, which are counted.
  void add_strip(const Side& side)
  {
    std::vector<int> strip;
    const Side places = in_order(side);
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

  /// Every face as often as the sides run around it, which is told from the outside inwards.
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

  /// How many more sides run along an edge of a face with the face to their left than with it to their right.
  int runs_along(Face face, int edge) const
  {
    const Handle from = face->vertex(Triangulation::ccw(edge)), to = face->vertex(Triangulation::cw(edge));
    if (triangulation_.is_infinite(from) || triangulation_.is_infinite(to)) return 0;
    const auto found = runs_.find({number(from), number(to)});
    return found == runs_.end() ? 0 : found->second;
  }

  Section_filling filling_;
  Triangulation triangulation_;
  std::vector<Handle> handles_;                              ///< by vertex of the section
  std::map<Side, Triangulation::Constraint_id> constraints_; ///< by numbers of first vertices in their places
  std::map<Side, int> runs_;                                 ///< by directed edge, how many more sides run along it
};

/// Cuts parts into pieces, one side of the piece after the other.
class Part_cutter
{
public:
  Part_cutter(const Points& points, const Eigen::Matrix3Xi& triangles, const Part_chart& chart)
      : chart_(chart), mesh_(points, triangles)
  {
    add_coordinates();
  }

  /// Removes what is beyond `at` in a coordinate and fills the section if it is closed. A part all of which is
  /// beyond is shrunk to a speck at its nearest point.
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
    fill_section(axis, at, [&](int i) { return beyond(i) >= -on_side; });
  }

  /// What is left.
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
  static constexpr double on_side = 1e-9;

  /// Returns the number of those that there were.
  std::size_t add_coordinates()
  {
    const std::size_t before = coordinates_.size();
    for (std::size_t i = before; i < mesh_.number_of_points(); ++i)
      coordinates_.push_back(chart_.coordinates(mesh_.point(int(i))));
    return before;
  }

  void shrink_to(int point)
  {
    constexpr double speck = 1e-3; // of the part's size
    const Point to = mesh_.point(point);
    for (int i = 0; i < int(coordinates_.size()); ++i) {
      mesh_.move(i, to + speck * (mesh_.point(i) - to));
      coordinates_[std::size_t(i)] = chart_.coordinates(mesh_.point(i));
    }
  }

  template <typename Is_on_side>
  void fill_section(int axis, double at, const Is_on_side& is_on_side)
  {
    std::vector<int> points; // by vertex of the section
    std::map<int, int> vertex;
    const auto number = [&](int point) {
      const auto [known, is_new] = vertex.try_emplace(point, int(points.size()));
      if (is_new) points.push_back(point);
      return known->second;
    };
    std::vector<Section_filler::Side> sides;
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
    const Section_filling filling = Section_filler(vertices, sides)();
    for (std::size_t i = vertices.size(); i < filling.vertices.size(); ++i) {
      Point k;
      k[axis] = at;
      k[(axis + 1) % 3] = filling.vertices[i].x();
      k[(axis + 2) % 3] = filling.vertices[i].y();
      points.push_back(mesh_.add_point(chart_(k)));
      coordinates_.push_back(k);
    }
    for (const std::array<int, 3>& t : filling.triangles)
      mesh_.add_triangle({points[std::size_t(t[0])], points[std::size_t(t[1])], points[std::size_t(t[2])]});
  }

  /// Whether as many sides end in every place as begin there.
  static bool is_closed(const std::vector<Section_filler::Side>& sides, const Planar_points& vertices)
  {
    std::map<std::array<long, 2>, int> balance;
    const auto place = [&](int vertex) {
      const Eigen::Vector2d& p = vertices[std::size_t(vertex)];
      return std::array<long, 2>{quantized(p.x()), quantized(p.y())};
    };
    for (const auto& [a, b] : sides)
      --balance[place(a)], ++balance[place(b)];
    return std::all_of(balance.begin(), balance.end(), [](const auto& place) { return place.second == 0; });
  }

  const Part_chart& chart_;
  Subdivision mesh_;
  std::vector<Point> coordinates_; ///< by point
};

/// The piece of a part that a box of its chart cuts out, closed if the part is. All of it for the whole chart.
inline Part_mesh piece_of(const Points& points, const Eigen::Matrix3Xi& triangles, const Part_chart& chart,
                          const Chart_box& box)
{
  if (is_whole(box)) return {points, triangles};
  Part_cutter cutter(points, triangles, chart);
  for (int axis = 0; axis < 3; ++axis) {
    if (box.min()[axis] > -1) cutter.cut(axis, box.min()[axis], true);
    if (box.max()[axis] < 1) cutter.cut(axis, box.max()[axis], false);
  }
  return cutter.mesh();
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MAP_PART_CUTTER_H
