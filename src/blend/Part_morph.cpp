// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Part_morph.h"

#include "base/quantized.h"
#include "blend/Surface_smoother.h"
#include "map/Charted_mesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

Point extents_along(const Points& surface, const Eigen::Matrix3d& axes)
{
  const Points local = axes.transpose() * surface;
  return local.rowwise().maxCoeff() - local.rowwise().minCoeff();
}

/// The axes of the world, or the surface's own axes if its box along these is much smaller.
Eigen::Matrix3d box_axes(const Points& surface, const Eigen::Matrix3d& own_axes)
{
  constexpr double much = 0.45; // ratio of volumes; a square turned by 45 degrees is above it
  const auto volume = [&](const Eigen::Matrix3d& axes) {
    return extents_along(surface, axes).cwiseMax(2 * Part_chart::least_half_extent).prod();
  };
  const Eigen::Matrix3d world = Eigen::Matrix3d::Identity();
  return volume(own_axes) < much * volume(world) ? own_axes : world;
}

double angle_of(const Eigen::Matrix3d& rotation) { return std::acos(std::clamp((rotation.trace() - 1) / 2, -1., 1.)); }

/// Charts with the longest axis of the boxes as the first and the shortest as the last one. For round parts that are
/// not plates, such as lampshades, the first axis is the axis of revolution.
Pair_charts charts_along(const std::array<const Points*, 2>& surfaces, std::array<Eigen::Matrix3d, 2> axes)
{
  constexpr double flat = 0.3;   // shortest extent of a plate, over the middle one
  constexpr double alike = 1.15; // largest ratio of extents that count as equal
  const std::array<Point, 2> extents = {extents_along(*surfaces[0], axes[0]), extents_along(*surfaces[1], axes[1])};
  const Point sum = extents[0] + extents[1];
  std::array<int, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return quantized(sum[a]) > quantized(sum[b]); });
  const bool are_plates = sum[order[2]] < flat * sum[order[1]];
  const auto may_be_round = [&](const Point& e) { // the two longest extents agree
    return e[order[0]] < alike * e[order[1]] && e[order[1]] < alike * e[order[0]];
  };
  if (!are_plates && std::all_of(extents.begin(), extents.end(), may_be_round))
    std::rotate(order.begin(), order.begin() + 2, order.end());
  Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i)
    turn(order[std::size_t(i)], i) = 1;
  if (turn.determinant() < 0) turn.col(2) *= -1;
  const auto chart = [&](std::size_t end) {
    const Eigen::Matrix3d turned = axes[end] * turn;
    return are_plates ? Part_chart::plate(*surfaces[end], turned) : Part_chart::box(*surfaces[end], turned);
  };
  return {chart(0), chart(1)};
}

} // namespace

Pair_charts pair_boxes(const std::array<const Points*, 2>& surfaces, const std::array<Eigen::Matrix3d, 2>& own_axes)
{
  const Eigen::Matrix3d from = box_axes(*surfaces[0], own_axes[0]), to = box_axes(*surfaces[1], own_axes[1]);
  const Point extents = extents_along(*surfaces[0], from), other_extents = extents_along(*surfaces[1], to);
  Eigen::Matrix3d best = to;
  std::tuple<Steps, Steps> least(std::numeric_limits<Steps>::max(), 0);
  for (const Eigen::Matrix3d& rotation : cube_rotations()) {
    const Eigen::Matrix3d turned = to * rotation;
    const Point difference = extents - (rotation.transpose() * other_extents).cwiseAbs();
    const std::tuple<Steps, Steps> cost(quantized(angle_of(turned * from.transpose())), quantized(difference.norm()));
    if (cost < least) least = cost, best = turned;
  }
  return charts_along(surfaces, {from, best});
}

Laid_morph::Laid_morph(const Pair_charts& charts, const Part_mesh& source, const Part_mesh& target)
    : charts_{charts.source, charts.target}
{
  constexpr double longest_edge = 0.3; // in chart coordinates, which range from -1 to 1
  for (std::size_t end : {0u, 1u}) {
    Charted_mesh mesh = finely_charted(end == 0 ? source : target, charts_[end], longest_edge);
    outlines_[end] = Chart_outline(charts_[end].is_sheet(), mesh.coordinates);
    for (auto k : mesh.coordinates.colwise())
      k = outlines_[end].relative(k);
    triangles_[end] = mesh.triangles;
    surfaces_[end] = {chart_normals(mesh), {mesh.coordinates, mesh.coordinates}, {mesh.offsets, mesh.offsets}};
  }
  surfaces_[0].lay(1, surfaces_[1], triangles_);
  surfaces_[1].lay(0, surfaces_[0], triangles_);
}

double Laid_morph::misfit(bool at_change) const
{
  double result = 0;
  for (std::size_t surface : {0u, 1u}) {
    const Moving_surface &mesh = surfaces_[surface], &other = surfaces_[1 - surface];
    const std::size_t when = at_change ? 1 - surface : surface;
    const contacts::Triangle_tree tree = tree_of(other.coordinates[1 - when], triangles_[1 - surface]);
    double sum = 0, all = 0;
    for (Eigen::Index t = 0; t < triangles_[surface].cols(); ++t) {
      const contacts::Triangle corners = triangle_of(mesh.coordinates[when], triangles_[surface], t);
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

Points Laid_morph::points(int surface, double t) const
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

void Laid_morph::Moving_surface::lay(std::size_t when, const Moving_surface& onto,
                                     const std::array<Eigen::Matrix3Xi, 2>& triangles)
{
  // In chart coordinates: large-scale motion first, then details
  constexpr std::array<double, 3> lengths = {0.6, 0.3, 0.15};
  const Points &places = onto.coordinates[1], given = coordinates[when];
  const Place_finder finder(places, triangles[when], onto.normals);
  const auto place = [&](Eigen::Index i) { return finder(coordinates[when].col(i), normals.col(i)); };
  const Surface_smoother smoothed(given, triangles[1 - when]);
  for (double length : lengths) {
    Points ways(3, given.cols());
    for (Eigen::Index i = 0; i < ways.cols(); ++i)
      ways.col(i) = place(i).of(places, triangles[when]) - given.col(i);
    coordinates[when] = given + smoothed(ways, length);
  }
  for (Eigen::Index i = 0; i < given.cols(); ++i)
    offsets[when].col(i) = place(i).of(onto.offsets[1], triangles[when]);
}

} // namespace CGAL::Shape_correspondence::internal
