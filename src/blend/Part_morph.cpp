// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Part_morph.h"

#include "blend/exchange.h"
#include "blend/smooth_places.h"
#include "map/Charted_mesh.h"
#include "map/Piece_pair.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

Part_morph::Part_morph(const Pair_charts& charts, const Part_mesh& source, const Part_mesh& target,
                       const std::optional<bool>& forward)
    : source_(charts.source), target_(charts.target)
{
  constexpr double longest_edge = 0.3; // in coordinates, of 2 from end to end
  Charted_mesh a = finely_charted(source, source_, longest_edge);
  Charted_mesh b = finely_charted(target, target_, longest_edge);
  for (Charted_mesh* mesh : {&a, &b}) {
    outlines_.emplace_back(source_.is_sheet(), mesh->coordinates);
    for (Eigen::Index i = 0; i < mesh->coordinates.cols(); ++i)
      mesh->coordinates.col(i) = outlines_.back().relative(mesh->coordinates.col(i));
  }
  if (forward) {
    forward_ = *forward;
    surfaces_ = forward_ ? surface_pair(a, b) : surface_pair(b, a);
    return;
  }
  Surface_pair ahead = surface_pair(a, b), back = surface_pair(b, a);
  forward_ = ahead.second.reach() <= back.second.reach();
  surfaces_ = std::move(forward_ ? ahead : back);
}

Part_morph Part_morph::exchange(const Pair_charts& boxes, const Part_mesh& source, const Part_mesh& target)
{
  Part_morph result(boxes);
  for (const auto& [mesh, chart, surface] : {std::tie(source, result.source_, result.surfaces_.first),
                                             std::tie(target, result.target_, result.surfaces_.second)}) {
    Charted_mesh charted{mesh.points, mesh.triangles, Points(3, mesh.points.cols()),
                         Points::Zero(3, mesh.points.cols())};
    for (Eigen::Index i = 0; i < mesh.points.cols(); ++i)
      charted.coordinates.col(i) = chart.coordinates(mesh.points.col(i));
    surface = at_rest(charted);
  }
  result.surfaces_.change = in_place.come[1];
  result.is_exchange_ = true;
  return result;
}

double Part_morph::turned_share(int surface) const
{
  constexpr double turned = 0.5; // cosine
  const Moving_surface& mesh = moving(surface);
  const Point extents = (source_.half_extents() + target_.half_extents()) / 2;
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

Points Part_morph::points(int surface, double t, double remaining) const
{
  constexpr double instant = 1e-12; // the least time for a motion
  const Part_chart chart = Part_chart::between(source_, target_, t);
  std::optional<Chart_outline> outline;
  if (!is_exchange_) outline = Chart_outline::between(outlines_[0], outlines_[1], t);
  const Moving_surface& mesh = moving(surface);
  const double own_time = forward_ ? t : 1 - t;
  const double moved = std::clamp((own_time - mesh.begin) / std::max(mesh.end - mesh.begin, instant), 0., 1.);
  const Point left = is_exchange_ ? thinning(remaining) : Point::Ones();
  const Point scale = is_exchange_ ? Point(left.cwiseProduct(narrowing(t))) : left;
  Points result(3, mesh.coordinates[0].cols());
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const Point q = (1 - moved) * mesh.coordinates[0].col(i) + moved * mesh.coordinates[1].col(i);
    const Point k = is_exchange_ ? Point(scale.cwiseProduct(q)) : outline->absolute(q);
    const Point off = left.minCoeff() * ((1 - own_time) * mesh.offsets[0].col(i) + own_time * mesh.offsets[1].col(i));
    result.col(i) = chart(k) + chart.frame(k) * off;
  }
  return result;
}

/// Neither a plate nor, lengthwise, a rod.
bool Part_morph::is_block() const
{
  constexpr double elongated = 2; // over the extents across
  const Point extents = source_.half_extents() + target_.half_extents();
  return !source_.is_sheet() && extents[0] <= elongated * std::max(extents[1], extents[2]);
}

/// By how much extents across that go over by equal factors in equal times are less than those that go over evenly: a
/// rod that is exchanged for a net is not to become as wide as the net with the net's share of the time.
Point Part_morph::narrowing(double t) const
{
  const Point a = source_.half_extents(), b = target_.half_extents();
  Point result = Point::Ones();
  for (int axis = source_.is_sheet() ? 2 : 1; axis < 3 && !is_block(); ++axis)
    result[axis] = std::pow(a[axis], 1 - t) * std::pow(b[axis], t) / ((1 - t) * a[axis] + t * b[axis]);
  return result;
}

/// What remains is as much of the volume: a plate thins, a rod across, a block as a whole.
Point Part_morph::thinning(double remaining) const
{
  if (source_.is_sheet()) return {1, 1, remaining};
  if (is_block()) return Point::Constant(std::cbrt(remaining));
  return {1, std::sqrt(remaining), std::sqrt(remaining)};
}

Point Part_morph::coordinates(int end, const Point& p) const
{
  const Point k = (end == 0 ? source_ : target_).coordinates(p);
  return is_exchange_ ? k : outlines_[std::size_t(end)].relative(k);
}

Point Part_morph::place(const Point& coordinates, double t) const
{
  const Part_chart chart = Part_chart::between(source_, target_, t);
  return chart(is_exchange_ ? narrowing(t).cwiseProduct(coordinates)
                            : Chart_outline::between(outlines_[0], outlines_[1], t).absolute(coordinates));
}

double Part_morph::Moving_surface::reach() const
{
  return std::sqrt((coordinates[1] - coordinates[0]).colwise().squaredNorm().maxCoeff());
}

Part_morph::Moving_surface Part_morph::at_rest(const Charted_mesh& mesh)
{
  Moving_surface result;
  result.triangles = mesh.triangles;
  result.coordinates = {mesh.coordinates, mesh.coordinates};
  result.offsets = {mesh.offsets, mesh.offsets};
  return result;
}

Part_morph::Surface_pair Part_morph::surface_pair(const Charted_mesh& a, const Charted_mesh& b)
{
  constexpr double shortest = 0.1; // share of the time, so that what has a short way does not take it in an instant
  Surface_pair result;
  Moving_surface& first = result.first = at_rest(a);
  const std::vector<Mesh_place> there = smooth_places(a.coordinates, a.triangles, b.coordinates, b.triangles);
  for (Eigen::Index i = 0; i < a.points.cols(); ++i) {
    const Mesh_place& place = there[std::size_t(i)];
    first.coordinates[1].col(i) = place.of(b.coordinates, b.triangles);
    first.offsets[1].col(i) = place.of(b.offsets, b.triangles);
  }
  Moving_surface& second = result.second = at_rest(b);
  const std::vector<Mesh_place> back = smooth_places(b.coordinates, b.triangles, first.coordinates[1], a.triangles);
  for (Eigen::Index i = 0; i < b.points.cols(); ++i) {
    const Mesh_place& place = back[std::size_t(i)];
    second.coordinates[0].col(i) = place.of(first.coordinates[1], a.triangles);
    second.offsets[0].col(i) = place.of(a.offsets, a.triangles);
  }
  const double first_reach = first.reach(), both = first_reach + second.reach();
  result.change = both > 0 ? std::clamp(first_reach / both, shortest, 1 - shortest) : 1;
  first.end = second.begin = result.change;
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
