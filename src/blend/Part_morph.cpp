// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Part_morph.h"

#include "base/clamped.h"
#include "base/quantized.h"
#include "map/Charted_mesh.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

Point extents_along(const Points& surface, const Eigen::Matrix3d& axes)
{
  const Points local = axes.transpose() * surface;
  return local.rowwise().maxCoeff() - local.rowwise().minCoeff();
}

/// The axes of the world, or the surface's own axes if its box along these is much smaller.
Eigen::Matrix3d box_axes(const Points& surface, const Eigen::Matrix3d& own_axes, double much)
{
  const auto volume = [&](const Eigen::Matrix3d& axes) {
    return extents_along(surface, axes).cwiseMax(2 * Part_chart::least_half_extent).prod();
  };
  const Eigen::Matrix3d world = Eigen::Matrix3d::Identity();
  return volume(own_axes) < much * volume(world) ? own_axes : world;
}

double angle_of(const Eigen::Matrix3d& rotation) { return std::acos(std::clamp((rotation.trace() - 1) / 2, -1., 1.)); }

/// Charts with the longest axis of the boxes as the first one.
Pair_charts charts_along(const std::array<const Points*, 2>& surfaces, const std::array<Eigen::Matrix3d, 2>& axes)
{
  const Point sum = extents_along(*surfaces[0], axes[0]) + extents_along(*surfaces[1], axes[1]);
  std::array<int, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return quantized(sum[a]) > quantized(sum[b]); });
  Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i)
    turn(order[std::size_t(i)], i) = 1;
  if (turn.determinant() < 0) turn.col(2) *= -1;
  return {Part_chart::box(*surfaces[0], axes[0] * turn), Part_chart::box(*surfaces[1], axes[1] * turn)};
}

/// Where the points of a mesh slide to, relative to the outline: outer ones onto the outline, but those of caps and of
/// inner surfaces stay inside.
Points places_on(const Chart_outline& outline, const Part_chart& chart, const Charted_mesh& mesh)
{
  constexpr double inwards = -0.3; // cosine
  constexpr double nearer = 0.83;  // ratio of distances, far from 1, so that rounding does not matter in a cube
  const Points normals = chart_normals(mesh);
  const Point half = chart.half_extents();
  Points result(3, mesh.coordinates.cols());
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    Point q = outline.relative(mesh.coordinates.col(i));
    const Eigen::Vector2d off = q.tail<2>();
    const double share = off.norm();
    if (share > 1e-9) {
      const Point at_rim = outline.absolute({q[0], off.x() / share, off.y() / share});
      const double depth = (at_rim - mesh.coordinates.col(i)).cwiseProduct(half).norm();
      const double to_end = (1 - std::abs(q[0])) * half[0];
      const bool is_inner = normals.col(i).tail<2>().dot(off) < inwards * share * normals.col(i).norm();
      if (share > 1 || (!is_inner && depth < nearer * to_end)) q.tail<2>() /= share;
    }
    result.col(i) = q;
  }
  return result;
}

/// What two offsets have in common: of each coordinate the smaller one, if both have the same sign.
Point common(const Point& a, const Point& b)
{
  return (a.array() * b.array() > 0).select((a.array().abs() < b.array().abs()).select(a, b), 0.);
}

/// The root mean square of offsets over a surface, over its diagonal.
double spread_of(const Points& offsets, const Points& points, const Eigen::Matrix3Xi& triangles)
{
  double sum = 0, all = 0;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const double area = contacts::area_vector(triangle_of(points, triangles, t)).norm();
    for (int corner : triangles.col(t))
      sum += area / 3 * offsets.col(corner).squaredNorm();
    all += area;
  }
  const double diagonal = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
  return all > 0 ? std::sqrt(sum / all) / diagonal : 0;
}

/// How a surface looks along three axes.
struct Look
{
  std::array<double, 3> covered; ///< share of the bounding rectangle that is covered, by axis
  double area;                   ///< over that of the bounding box
};

/// Marks the cells of a grid that a triangle covers, by samples.
void mark_covered(const std::array<Eigen::Vector2d, 3>& corners, int cells, std::vector<char>& marks)
{
  const auto& [a, b, c] = corners;
  const int steps = 1 + int(std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()}));
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; i + j <= steps; ++j) {
      const Eigen::Vector2d p = (double(i) * a + double(j) * b + double(steps - i - j) * c) / steps;
      marks[std::size_t(clamped_cell(p.x(), cells - 1) * cells + clamped_cell(p.y(), cells - 1))] = 1;
    }
}

Look look_of(const Points& points, const Eigen::Matrix3Xi& triangles, const Eigen::Matrix3d& axes)
{
  constexpr int cells = 32;
  constexpr double thin = 0.02; // least extent, over the longest
  const Points local = axes.transpose() * points;
  const Point low = local.rowwise().minCoeff(), extents = local.rowwise().maxCoeff() - low,
              sizes = extents.cwiseMax(thin * extents.maxCoeff());
  Look result = {{}, 0};
  for (std::size_t axis : {0u, 1u, 2u}) {
    const auto u = Eigen::Index((axis + 1) % 3), v = Eigen::Index((axis + 2) % 3);
    std::vector<char> marks(cells * cells, 0);
    for (const auto& corners : triangles.colwise()) {
      const auto place = [&](int i) -> Eigen::Vector2d {
        return cells * Eigen::Vector2d((local(u, i) - low[u]) / sizes[u], (local(v, i) - low[v]) / sizes[v]);
      };
      mark_covered({place(corners[0]), place(corners[1]), place(corners[2])}, cells, marks);
    }
    result.covered[axis] = double(std::count(marks.begin(), marks.end(), 1)) / (cells * cells);
  }
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    result.area += contacts::area_vector(triangle_of(local, triangles, t)).norm();
  result.area /= 4 * (sizes[0] * sizes[1] + sizes[1] * sizes[2] + sizes[2] * sizes[0]);
  return result;
}

} // namespace

Pair_charts pair_boxes(const std::array<const Points*, 2>& surfaces, const std::array<Eigen::Matrix3d, 2>& own_axes,
                       double much)
{
  const Eigen::Matrix3d from = box_axes(*surfaces[0], own_axes[0], much),
                        to = box_axes(*surfaces[1], own_axes[1], much);
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

Part_morph::Part_morph(const Pair_charts& charts, const Part_mesh& source, const Part_mesh& target, double longest_edge)
    : charts_{charts.source, charts.target}
{
  add(charts.source, source, longest_edge);
  add(charts.target, target, longest_edge);
  meet();
}

void Part_morph::add(const Part_chart& chart, const Part_mesh& mesh, double longest_edge)
{
  const Charted_mesh fine = charted_mesh(mesh, chart, longest_edge);
  const Chart_outline& outline = outlines_.emplace_back(fine.coordinates, fine.triangles);
  Sliding_surface surface = {fine.triangles, places_on(outline, chart, fine), Points(3, fine.points.cols()),
                             Points::Zero(3, fine.points.cols()), Points::Zero(3, fine.points.cols())};
  for (Eigen::Index i = 0; i < fine.points.cols(); ++i) {
    const Point k = outline.absolute(surface.places.col(i));
    surface.offsets.col(i) = chart.frame(k).inverse() * (fine.points.col(i) - chart(k));
  }
  error_ = std::max(error_, spread_of(surface.offsets, fine.points, fine.triangles));
  surfaces_.push_back(std::move(surface));
}

/// Lets either surface slide onto the other one at the change.
void Part_morph::meet()
{
  const std::array<Points, 2> at_change = {points(0, change), points(1, change)};
  const Part_chart chart = Part_chart::between(charts_[0], charts_[1], change);
  const Chart_outline outline = Chart_outline::between(outlines_[0], outlines_[1], change);
  for (std::size_t side : {0u, 1u}) {
    const contacts::Triangle_tree other = tree_of(at_change[1 - side], surfaces_[1 - side].triangles);
    Sliding_surface& surface = surfaces_[side];
    for (Eigen::Index i = 0; i < surface.meets.cols(); ++i) {
      const Point p = at_change[side].col(i), k = outline.absolute(surface.places.col(i));
      const Mesh_place place = nearest_place(other, p);
      surface.meets.col(i) =
          chart.frame(k).inverse() * (place.of(at_change[1 - side], surfaces_[1 - side].triangles) - p);
      const Point detail = place.of(surfaces_[1 - side].offsets, surfaces_[1 - side].triangles);
      surface.details.col(i) = common(surface.offsets.col(i), detail);
    }
    misfit_ = std::max(misfit_, spread_of(surface.meets, at_change[side], surface.triangles));
  }
}

bool Part_morph::is_faithful() const
{
  constexpr double most = 0.02, most_together = 0.03; // error, misfit, and their sum
  return error_ <= most && misfit_ <= most && error_ + misfit_ <= most_together && looks_alike();
}

/// Whether both ends cover about as much along each axis, as a hoop and a panel do not, and the surface half-way covers
/// as much and is no rougher.
bool Part_morph::looks_alike() const
{
  constexpr double unlike = 0.4, more = 0.05; // shares of the bounding rectangle
  constexpr double rougher = 1.1;             // ratio of areas
  const Look first = look_of(points(0, 0), triangles(0), charts_[0].axes()),
             last = look_of(points(1, 1), triangles(1), charts_[1].axes()),
             half_way =
                 look_of(points(0, change), triangles(0), Part_chart::between(charts_[0], charts_[1], change).axes());
  for (std::size_t axis : {0u, 1u, 2u}) {
    const auto [least, most] = std::minmax(first.covered[axis], last.covered[axis]);
    if (most > least + unlike || half_way.covered[axis] < least - more || half_way.covered[axis] > most + more)
      return false;
  }
  return half_way.area <= rougher * std::max(first.area, last.area);
}

Points Part_morph::points(int surface, double t) const
{
  constexpr double meeting = 0.25; // time in which a surface slides onto the other one, or from there
  const Part_chart chart = Part_chart::between(charts_[0], charts_[1], t);
  const Chart_outline outline = Chart_outline::between(outlines_[0], outlines_[1], t);
  const auto& [triangles, places, offsets, details, meets] = surfaces_[std::size_t(surface)];
  const double left = std::clamp(surface == 0 ? 1 - t / change : (t - change) / (1 - change), 0., 1.),
               met = std::max(0., 1 - std::abs(t - change) / meeting);
  Points result(3, places.cols());
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const Point k = outline.absolute(places.col(i));
    result.col(i) =
        chart(k) + chart.frame(k) * (left * offsets.col(i) + (1 - left) * details.col(i) + met * meets.col(i));
  }
  return result;
}

std::shared_ptr<const Part_morph> best_morph(const std::vector<Pair_charts>& charts, const Part_mesh& source,
                                             const Part_mesh& target)
{
  constexpr double good = 0.015; // sum of error and misfit, below which further charts are not tried
  constexpr std::array coarser = {3.1, 0.9};
  constexpr double worse = 0.002; // by how much their sum of error and misfit may exceed that of the finest
  std::shared_ptr<const Part_morph> best;
  const Pair_charts* best_pair = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Pair_charts& pair : charts) {
    const auto morph = std::make_shared<const Part_morph>(pair, source, target);
    const double cost = morph->error() + morph->misfit();
    if (cost < least && morph->is_faithful()) least = cost, best = morph, best_pair = &pair;
    if (least < good) break;
  }
  for (double longest_edge : coarser) {
    if (!best) break;
    const auto morph = std::make_shared<const Part_morph>(*best_pair, source, target, longest_edge);
    if (morph->error() + morph->misfit() <= least + worse && morph->is_faithful()) return morph;
  }
  return best;
}

} // namespace CGAL::Shape_correspondence::internal
