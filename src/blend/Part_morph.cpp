// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Part_morph.h"

#include "map/Charted_mesh.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Shape_correspondence::internal {

Part_morph::Part_morph(const Pair_charts& charts, const Part_mesh& source, const Part_mesh& target) : charts_(charts)
{
  constexpr double longest_edge = 0.3; // in coordinates, of 2 from end to end
  for (std::size_t end : {0u, 1u}) {
    const Part_mesh& given = end == 0 ? source : target;
    Part_chart& chart = end == 0 ? charts_.source : charts_.target;
    Charted_mesh mesh = finely_charted(given, chart, longest_edge);
    outlines_[end] = Chart_outline(chart.is_sheet(), mesh.coordinates);
    for (Eigen::Index i = 0; i < mesh.coordinates.cols(); ++i)
      mesh.coordinates.col(i) = outlines_[end].relative(mesh.coordinates.col(i));
    surfaces_.emplace_back(mesh);
  }
  lay();
}

/// Lays the surfaces on each other.
void Part_morph::lay()
{
  constexpr double shortest = 0.1; // share of the time, so that what has a short way does not take it in an instant
  Moving_surface &first = surfaces_[0], &second = surfaces_[1];
  first.lay(1, second.coordinates[1], second.offsets[1], second.triangles);
  second.lay(0, first.coordinates[1], first.offsets[0], first.triangles);
  const double both = first.reach() + second.reach();
  first.end = second.begin = both > 0 ? std::clamp(first.reach() / both, shortest, 1 - shortest) : 1;
}

double Part_morph::turned_share(int surface) const
{
  constexpr double turned = 0.5; // cosine
  const Moving_surface& mesh = surfaces_[std::size_t(surface)];
  const Point extents = (charts_.source.half_extents() + charts_.target.half_extents()) / 2;
  double sum = 0, all = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const auto normal = [&](const Points& at) -> Point {
      const auto corner = [&](int i) -> Point { return extents.cwiseProduct(at.col(mesh.triangles(i, t))); };
      return (corner(1) - corner(0)).cross(corner(2) - corner(0));
    };
    const Point from = normal(mesh.coordinates[0]), to = normal(mesh.coordinates[1]);
    const double area = std::max(from.norm(), to.norm());
    all += area;
    if (from.dot(to) < turned * from.norm() * to.norm()) sum += area;
  }
  return all > 0 ? sum / all : 0;
}

Points Part_morph::points(int surface, double t) const
{
  constexpr double instant = 1e-12; // the least time for a motion
  const Part_chart chart = chart_at(t);
  const Chart_outline outline = outline_at(t);
  const Moving_surface& mesh = surfaces_[std::size_t(surface)];
  const double moved = std::clamp((t - mesh.begin) / std::max(mesh.end - mesh.begin, instant), 0., 1.);
  Points result(3, mesh.coordinates[0].cols());
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const Point k = outline.absolute((1 - moved) * mesh.coordinates[0].col(i) + moved * mesh.coordinates[1].col(i));
    const Point off = (1 - t) * mesh.offsets[0].col(i) + t * mesh.offsets[1].col(i);
    result.col(i) = chart(k) + chart.frame(k) * off;
  }
  return result;
}

Point Part_morph::coordinates(int end, const Point& p) const
{
  return outlines_[std::size_t(end)].relative((end == 0 ? charts_.source : charts_.target).coordinates(p));
}

Point Part_morph::place(const Point& coordinates, double t) const
{
  return chart_at(t)(outline_at(t).absolute(coordinates));
}

double Part_morph::Moving_surface::reach() const
{
  return std::sqrt((coordinates[1] - coordinates[0]).colwise().squaredNorm().maxCoeff());
}

Part_morph::Moving_surface::Moving_surface(const Charted_mesh& mesh)
    : triangles(mesh.triangles), coordinates{mesh.coordinates, mesh.coordinates}, offsets{mesh.offsets, mesh.offsets}
{}

void Part_morph::Moving_surface::lay(std::size_t when, const Points& onto, const Points& onto_offsets,
                                     const Eigen::Matrix3Xi& onto_triangles)
{
  const contacts::Triangle_tree tree = tree_of(onto, onto_triangles);
  for (Eigen::Index i = 0; i < coordinates[when].cols(); ++i) {
    const Mesh_place place = nearest_place(tree, coordinates[when].col(i));
    coordinates[when].col(i) = place.of(onto, onto_triangles);
    offsets[when].col(i) = place.of(onto_offsets, onto_triangles);
  }
}

} // namespace CGAL::Shape_correspondence::internal
