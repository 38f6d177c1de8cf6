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

Part_morph::Part_morph(const Pair_charts& charts, const Part_mesh& source, const Part_mesh& target)
    : charts_{charts.source, charts.target}
{
  constexpr double longest_edge = 0.3; // in coordinates, of 2 from end to end
  for (std::size_t end : {0u, 1u}) {
    Charted_mesh mesh = finely_charted(end == 0 ? source : target, charts_[end], longest_edge);
    outlines_[end] = Chart_outline(charts_[end].is_sheet(), mesh.coordinates);
    for (auto k : mesh.coordinates.colwise())
      k = outlines_[end].relative(k);
    surfaces_[end] = {
        mesh.triangles, chart_normals(mesh), {mesh.coordinates, mesh.coordinates}, {mesh.offsets, mesh.offsets}};
  }
  surfaces_[0].lay(1, surfaces_[1]);
  surfaces_[1].lay(0, surfaces_[0]);
}

double Part_morph::misfit(bool at_change) const
{
  double result = 0;
  for (std::size_t surface : {0u, 1u}) {
    const Moving_surface &mesh = surfaces_[surface], &other = surfaces_[1 - surface];
    const std::size_t when = at_change ? 1 - surface : surface;
    const contacts::Triangle_tree tree = tree_of(other.coordinates[1 - when], other.triangles);
    double sum = 0, all = 0;
    for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
      const contacts::Triangle corners = triangle_of(mesh.coordinates[when], mesh.triangles, t);
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
  const Part_chart chart = Part_chart::between(charts_[0], charts_[1], t);
  const Chart_outline outline = Chart_outline::between(outlines_[0], outlines_[1], t);
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

void Part_morph::Moving_surface::lay(std::size_t when, const Moving_surface& onto)
{
  constexpr std::array<double, 3> lengths = {0.6, 0.3, 0.15}; // in coordinates: first at large, then in detail
  const Points &places = onto.coordinates[1], given = coordinates[when];
  const Place_finder finder(places, onto.triangles, onto.normals);
  const auto place = [&](Eigen::Index i) { return finder(coordinates[when].col(i), normals.col(i)); };
  const Surface_smoother smoothed(given, triangles);
  for (double length : lengths) {
    Points ways(3, given.cols());
    for (Eigen::Index i = 0; i < ways.cols(); ++i)
      ways.col(i) = place(i).of(places, onto.triangles) - given.col(i);
    coordinates[when] = given + smoothed(ways, length);
  }
  for (Eigen::Index i = 0; i < given.cols(); ++i)
    offsets[when].col(i) = place(i).of(onto.offsets[1], onto.triangles);
}

} // namespace CGAL::Shape_correspondence::internal
