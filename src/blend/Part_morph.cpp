// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Part_morph.h"

#include "blend/Surface_smoother.h"
#include "map/Charted_mesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
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
  Moving_surface &first = surfaces_[0], &second = surfaces_[1];
  first.lay(1, second, 1);
  second.lay(0, first, 1);
}

double Part_morph::turned_share(int surface) const
{
  constexpr double turned = 0.5; // cosine
  const Moving_surface& mesh = surfaces_[std::size_t(surface)];
  const Point extents = (charts_.source.half_extents() + charts_.target.half_extents()) / 2;
  const std::array<Points, 2> places = {extents.asDiagonal() * mesh.coordinates[0],
                                        extents.asDiagonal() * mesh.coordinates[1]};
  double sum = 0, all = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const auto normal = [&](std::size_t when) {
      return contacts::area_vector(triangle_of(places[when], mesh.triangles, t));
    };
    const Point from = normal(0), to = normal(1);
    const double area = std::max(from.norm(), to.norm());
    all += area;
    if (from.dot(to) < turned * from.norm() * to.norm()) sum += area;
  }
  return all > 0 ? sum / all : 0;
}

double Part_morph::misfit(bool at_change) const
{
  const auto places = [&](std::size_t surface) -> const Points& {
    return surfaces_[surface].coordinates[at_change ? 1 - surface : surface];
  };
  double result = 0;
  for (std::size_t surface : {0u, 1u}) {
    const Moving_surface &mesh = surfaces_[surface], &other = surfaces_[1 - surface];
    const contacts::Triangle_tree tree = tree_of(places(1 - surface), other.triangles);
    double sum = 0, all = 0;
    for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
      const contacts::Triangle corners = triangle_of(places(surface), mesh.triangles, t);
      const double area = contacts::area_vector(corners).norm();
      const Point middle = contacts::centre(corners);
      std::size_t nearest = 0;
      sum += area * (tree.nearest(middle, nearest) - middle).squaredNorm();
      all += area;
    }
    if (all > 0) result = std::max(result, std::sqrt(sum / all));
  }
  return result;
}

Points Part_morph::points(int surface, double t) const
{
  const Part_chart chart = chart_at(t);
  const Chart_outline outline = outline_at(t);
  const Moving_surface& mesh = surfaces_[std::size_t(surface)];
  const double moved = std::clamp(surface == 0 ? t / change : (t - change) / (1 - change), 0., 1.);
  Points result(3, mesh.coordinates[0].cols());
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const Point k = outline.absolute((1 - moved) * mesh.coordinates[0].col(i) + moved * mesh.coordinates[1].col(i));
    const Point off = (1 - t) * mesh.offsets[0].col(i) + t * mesh.offsets[1].col(i);
    result.col(i) = chart(k) + chart.frame(k) * off;
  }
  return result;
}

Part_morph::Moving_surface::Moving_surface(const Charted_mesh& mesh)
    : triangles(mesh.triangles),
      normals(chart_normals(mesh)),
      coordinates{mesh.coordinates, mesh.coordinates},
      offsets{mesh.offsets, mesh.offsets}
{}

void Part_morph::Moving_surface::lay(std::size_t when, const Moving_surface& onto, std::size_t onto_when)
{
  constexpr std::array<double, 3> lengths = {0.6, 0.3, 0.15}; // in coordinates: first at large, then in detail
  const Points &places = onto.coordinates[onto_when], given = coordinates[when];
  const Place_finder finder(places, onto.triangles, onto.normals);
  const Surface_smoother smoothed(given, triangles);
  for (double length : lengths) {
    Points ways(3, given.cols());
    for (Eigen::Index i = 0; i < ways.cols(); ++i)
      ways.col(i) = finder(coordinates[when].col(i), normals.col(i)).of(places, onto.triangles) - given.col(i);
    coordinates[when] = given + smoothed(ways, length);
  }
  for (Eigen::Index i = 0; i < given.cols(); ++i)
    offsets[when].col(i) = finder(coordinates[when].col(i), normals.col(i)).of(onto.offsets[onto_when], onto.triangles);
}

} // namespace CGAL::Shape_correspondence::internal
