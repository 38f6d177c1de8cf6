// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_part.h"

#include "base/clamped.h"
#include "base/quantized.h"
#include "map/Charted_mesh.h"
#include "shape/sample_triangles.h"

#include <Eigen/Cholesky>
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

/// The shares of the bounding rectangles along three axes that a surface covers.
std::array<double, 3> covered_shares(const Points& points, const Eigen::Matrix3Xi& triangles,
                                     const Eigen::Matrix3d& axes)
{
  constexpr int cells = 32;
  constexpr double thin = 0.02; // least extent, over the longest
  const Points local = axes.transpose() * points;
  const Point low = local.rowwise().minCoeff(), extents = local.rowwise().maxCoeff() - low,
              sizes = extents.cwiseMax(thin * extents.maxCoeff());
  std::array<double, 3> result;
  for (std::size_t axis : {0u, 1u, 2u}) {
    const auto u = Eigen::Index((axis + 1) % 3), v = Eigen::Index((axis + 2) % 3);
    std::vector<char> marks(cells * cells, 0);
    for (const auto& corners : triangles.colwise()) {
      const auto place = [&](int i) -> Eigen::Vector2d {
        return cells * Eigen::Vector2d((local(u, i) - low[u]) / sizes[u], (local(v, i) - low[v]) / sizes[v]);
      };
      mark_covered({place(corners[0]), place(corners[1]), place(corners[2])}, cells, marks);
    }
    result[axis] = double(std::count(marks.begin(), marks.end(), 1)) / (cells * cells);
  }
  return result;
}

constexpr double most_effort = 0.035; // `Part_morph::effort()` above which parts do not morph, but are exchanged

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
  return {Part_chart::box(*surfaces[0], from), Part_chart::box(*surfaces[1], best)};
}

Part_morph::Part_morph(const Pair_charts& charts, const Part_mesh& source, const Part_mesh& target, bool bends)
    : charts_{charts.source, charts.target}
{
  constexpr double fine = 0.3; // longest edge, in coordinates, of meshes from which outlines are computed
  constexpr int samples = 400; // number of points of a surface at which the misfit is measured
  const std::array<const Part_mesh*, 2> meshes = {&source, &target};
  if (bends) {
    const std::array<Charted_mesh, 2> charted = {charted_mesh(source, charts_[0], fine),
                                                 charted_mesh(target, charts_[1], fine)};
    for (std::size_t end : {0u, 1u})
      outlines_[end] = Chart_outline(charted[end].coordinates, charted[end].triangles).smoothed();
    strain_ = std::max(strain_of(0, charted[0]), strain_of(1, charted[1]));
    if (effort() > most_effort) return;
  }
  for (std::size_t end : {0u, 1u})
    add(end, *meshes[end]);
  for (std::size_t end : {0u, 1u}) {
    const contacts::Triangle_tree other = tree_at_change(1 - end);
    const Part_mesh mesh = {points(int(end), change), surfaces_[end].triangles};
    double sum = 0;
    for (const Point& p : contacts::sample_triangles(contacts::sampled_triangles_of(mesh), samples).points) {
      std::size_t triangle = 0;
      sum += (other.nearest(p, triangle) - p).squaredNorm();
    }
    const double diagonal = (mesh.points.rowwise().maxCoeff() - mesh.points.rowwise().minCoeff()).norm();
    misfit_ = std::max(misfit_, std::sqrt(sum / samples) / diagonal);
  }
}

/// The strain of a surface, without that part of its motion which is linear in its cross-sections and along the axis:
/// moved, stretched, sheared and tapered parts stay straight.
double Part_morph::strain_of(std::size_t end, const Charted_mesh& mesh) const
{
  constexpr double flat = 1e-6; // relative, added to the diagonal, so that the equations of flat parts are solvable
  const Point half = Part_chart::between(charts_[0], charts_[1], change).half_extents();
  const Chart_outline outline = Chart_outline::between(outlines_[0], outlines_[1], change);
  const Points before = half.asDiagonal() * mesh.coordinates;
  Points after(3, before.cols());
  for (Eigen::Index i = 0; i < after.cols(); ++i)
    after.col(i) = half.cwiseProduct(outline.absolute(outlines_[end].relative(mesh.coordinates.col(i))));
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(before.cols());
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    for (int corner : mesh.triangles.col(t))
      areas[corner] += contacts::area_vector(triangle_of(before, mesh.triangles, t)).norm();
  if (!(areas.sum() > 0)) return 0;
  Eigen::MatrixXd terms(before.cols(), 6);
  terms.col(0).setOnes();
  terms.middleCols<3>(1) = mesh.coordinates.transpose();
  terms.col(4) = terms.col(1).cwiseProduct(terms.col(2));
  terms.col(5) = terms.col(1).cwiseProduct(terms.col(3));
  const Eigen::MatrixXd weighed = areas.asDiagonal() * terms;
  Eigen::MatrixXd products = terms.transpose() * weighed;
  products.diagonal().array() += flat * areas.sum();
  const Eigen::MatrixXd straight = products.ldlt().solve(weighed.transpose() * after.transpose());
  const Points rest = after - (terms * straight).transpose();
  double sum = 0, all = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const contacts::Triangle from = triangle_of(before, mesh.triangles, t), to = triangle_of(rest, mesh.triangles, t);
    const double area = contacts::area_vector(from).norm();
    for (std::size_t i : {0u, 1u, 2u})
      if (area > 0)
        sum +=
            area * std::min(1., (to[(i + 1) % 3] - to[i]).squaredNorm() / (from[(i + 1) % 3] - from[i]).squaredNorm());
    all += 3 * area;
  }
  return std::sqrt(sum / all);
}

/// Adds the surface of an end, subdivided until its edges stay nearly straight on the way to the other end.
void Part_morph::add(std::size_t end, const Part_mesh& mesh)
{
  constexpr double bent = 0.002; // largest distance of an edge's moved middle from the straight edge, over the diagonal
  constexpr std::size_t most_triangles = 20000;
  constexpr int most_rounds = 6;
  const Part_chart &chart = charts_[end], &other = charts_[1 - end];
  const auto moved = [&](const Point& p) {
    const Point k = chart.coordinates(p), place = outlines_[end].relative(k),
                offset = chart.frame(k).inverse() * (p - chart(k)), to = outlines_[1 - end].absolute(place);
    return std::array<Point, 3>{place, offset, other(to) + other.frame(to) * offset};
  };
  const double most = bent * 2 * other.half_extents().norm();
  Subdivision fine(mesh.points, mesh.triangles);
  std::vector<std::array<Point, 3>> all; // places, offsets, and points at the other end
  for (int round = 0;; ++round) {
    while (all.size() < fine.number_of_points())
      all.push_back(moved(fine.point(int(all.size()))));
    if (round == most_rounds || fine.number_of_triangles() > most_triangles) break;
    const auto is_bent = [&](int a, int b) {
      const Point middle = (all[std::size_t(a)][2] + all[std::size_t(b)][2]) / 2;
      return quantized((moved((fine.point(a) + fine.point(b)) / 2)[2] - middle).norm()) > quantized(most);
    };
    if (!fine.split_edges([&](int a, int b) { return is_bent(a, b) ? 0.5 : -1; })) break;
  }
  const auto n = Eigen::Index(all.size());
  Moving_surface surface = {fine.triangles(), Points(3, n), Points(3, n), Points::Zero(3, n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    surface.places.col(i) = all[std::size_t(i)][0];
    surface.offsets.col(i) = all[std::size_t(i)][1];
  }
  surfaces_.push_back(std::move(surface));
}

contacts::Triangle_tree Part_morph::tree_at_change(std::size_t surface) const
{
  return tree_of(points(int(surface), change), surfaces_[surface].triangles);
}

void Part_morph::meet()
{
  const Part_chart chart = Part_chart::between(charts_[0], charts_[1], change);
  const Chart_outline outline = Chart_outline::between(outlines_[0], outlines_[1], change);
  const std::array<contacts::Triangle_tree, 2> trees = {tree_at_change(0), tree_at_change(1)};
  for (std::size_t side : {0u, 1u}) {
    const Points at_change = points(int(side), change);
    Moving_surface& surface = surfaces_[side];
    for (Eigen::Index i = 0; i < at_change.cols(); ++i) {
      std::size_t triangle = 0;
      const Point p = at_change.col(i), k = outline.absolute(surface.places.col(i));
      surface.meets.col(i) = chart.frame(k).inverse() * (trees[1 - side].nearest(p, triangle) - p) / 2;
    }
  }
}

bool Part_morph::is_faithful() const
{
  constexpr double unlike = 0.4; // difference of shares of a bounding rectangle, as of a hoop and a panel
  if (effort() > most_effort) return false;
  const Eigen::Matrix3d axes = Part_chart::between(charts_[0], charts_[1], change).axes();
  const auto first = covered_shares(points(0, change), triangles(0), axes),
             last = covered_shares(points(1, change), triangles(1), axes);
  return std::equal(first.begin(), first.end(), last.begin(),
                    [&](double a, double b) { return std::abs(a - b) <= unlike; });
}

Points Part_morph::points(int surface, double t) const
{
  constexpr double meeting = 0.06; // time in which a surface slides to where both meet, or from there
  const Part_chart chart = Part_chart::between(charts_[0], charts_[1], t);
  const Chart_outline outline = Chart_outline::between(outlines_[0], outlines_[1], t);
  const auto& [triangles, places, offsets, meets] = surfaces_[std::size_t(surface)];
  const double met = std::max(0., 1 - std::abs(t - change) / meeting);
  Points result(3, places.cols());
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const Point k = outline.absolute(places.col(i));
    result.col(i) = chart(k) + chart.frame(k) * (offsets.col(i) + met * meets.col(i));
  }
  return result;
}

std::shared_ptr<const Part_morph> best_morph(const std::vector<std::vector<Pair_charts>>& charts,
                                             const Part_mesh& source, const Part_mesh& target)
{
  constexpr double good = 0.01; // effort below which other morphs are not tried
  std::shared_ptr<Part_morph> best;
  double least = std::numeric_limits<double>::infinity();
  const auto try_out = [&](const Pair_charts& pair, bool bends) {
    if (least < good) return;
    const auto morph = std::make_shared<Part_morph>(pair, source, target, bends);
    if (morph->effort() < least && morph->is_faithful()) least = morph->effort(), best = morph;
  };
  for (const std::vector<Pair_charts>& group : charts)
    try_out(group.front(), false);
  for (const std::vector<Pair_charts>& group : charts)
    for (const Pair_charts& pair : group)
      try_out(pair, true);
  if (best) best->meet();
  return best;
}

} // namespace CGAL::Shape_correspondence::internal
