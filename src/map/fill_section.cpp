// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map/fill_section.h"
#include "base/library_call.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>

namespace CGAL::Shape_correspondence::internal {
namespace {

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

} // namespace

Section_filling fill_section(const Planar_points& vertices, const std::vector<Section_side>& sides)
{
  return library_call(
      "section", [&] { return Section_filler(vertices, sides)(); },
      [&] {
        return Section_filling{vertices, {}};
      });
}

} // namespace CGAL::Shape_correspondence::internal
