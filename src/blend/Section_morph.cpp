// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Section_morph.h"

#include "blend/Rest_surface.h"
#include "map/Charted_mesh.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Where the points of a mesh slide to, relative to the outline: outer ones onto the outline, but those of caps and of inner
/// surfaces stay inside.
Points places_on(const Section_outline& outline, const Part_chart& chart, const Charted_mesh& mesh)
{
  constexpr double inwards = -0.3; // cosine
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
      if (share > 1 || (!is_inner && depth < to_end)) q.tail<2>() /= share;
    }
    result.col(i) = q;
  }
  return result;
}

/// The root mean square of offsets over the surface.
double spread_of(const Points& offsets, const Charted_mesh& mesh)
{
  double sum = 0, all = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const double area = contacts::area_vector(triangle_of(mesh.points, mesh.triangles, t)).norm();
    for (int corner : mesh.triangles.col(t))
      sum += area / 3 * offsets.col(corner).squaredNorm();
    all += area;
  }
  return all > 0 ? std::sqrt(sum / all) : 0;
}

/// The root mean square distance of a surface from another one.
double distance_from(const contacts::Triangle_tree& other, const Points& points, const Eigen::Matrix3Xi& triangles)
{
  double sum = 0, all = 0;
  std::size_t nearest = 0;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const contacts::Triangle corners = triangle_of(points, triangles, t);
    const double area = contacts::area_vector(corners).norm();
    const Point middle = contacts::centre(corners);
    sum += area * (other.nearest(middle, nearest) - middle).squaredNorm();
    all += area;
  }
  return all > 0 ? std::sqrt(sum / all) : 0;
}

} // namespace

Section_morph::Section_morph(const Pair_charts& charts, const Part_mesh& source, const Part_mesh& target)
    : charts_{charts.source, charts.target}
{
  constexpr double longest_edge = 0.2; // in chart coordinates, which range from -1 to 1
  for (std::size_t end : {0u, 1u}) {
    const Part_chart& chart = charts_[end];
    const Charted_mesh mesh = charted_mesh(end == 0 ? source : target, chart, longest_edge);
    outlines_.emplace_back(mesh.coordinates, mesh.triangles);
    Points places = places_on(outlines_[end], chart, mesh), offsets(3, places.cols());
    for (Eigen::Index i = 0; i < places.cols(); ++i) {
      const Point k = outlines_[end].absolute(places.col(i));
      offsets.col(i) = chart.frame(k).inverse() * (mesh.points.col(i) - chart(k));
    }
    const double diagonal = (mesh.points.rowwise().maxCoeff() - mesh.points.rowwise().minCoeff()).norm();
    if (diagonal > 0) error_ = std::max(error_, spread_of(offsets, mesh) / diagonal);
    triangles_[end] = mesh.triangles;
    sliding_[end] = {std::move(places), std::move(offsets)};
  }
}

bool Section_morph::is_faithful() const
{
  constexpr double most_error = 0.04, most_misfit = 0.02; // over the diagonal
  constexpr double most_torn = 0.3;                       // share of a surface
  std::array<Points, 2> at_change = {points(0, change), points(1, change)};
  double misfit = 0, torn = 0;
  for (std::size_t side : {0u, 1u}) {
    const double diagonal = (at_change[side].rowwise().maxCoeff() - at_change[side].rowwise().minCoeff()).norm();
    misfit = std::max(misfit, distance_from(tree_of(at_change[1 - side], triangles_[1 - side]), at_change[side], triangles_[side]) / diagonal);
    const Rest_surface rest(points(int(side), double(side)), triangles_[side]);
    torn = std::max(torn, rest.torn_area(at_change[side]) / rest.area(at_change[side]));
  }
  if (getenv("BL")) fprintf(stderr, "    error %.4f misfit %.4f torn %.4f\n", error_, misfit, torn);
  return error_ <= most_error && misfit <= most_misfit && torn <= most_torn;
}

Points Section_morph::points(int surface, double t) const
{
  const Part_chart chart = Part_chart::between(charts_[0], charts_[1], t);
  const Section_outline outline = Section_outline::between(outlines_[0], outlines_[1], t);
  const auto& [places, offsets] = sliding_[std::size_t(surface)];
  const double left = std::clamp(surface == 0 ? 1 - t / change : (t - change) / (1 - change), 0., 1.);
  Points result(3, places.cols());
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const Point k = outline.absolute(places.col(i));
    result.col(i) = chart(k) + chart.frame(k) * (left * offsets.col(i));
  }
  return result;
}

std::shared_ptr<const Section_morph> best_section_morph(const Pair_charts& boxes, const Part_mesh& source, const Part_mesh& target)
{
  std::shared_ptr<const Section_morph> best;
  const Eigen::Matrix3d from = boxes.source.axes(), to = boxes.target.axes();
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity(), next;
  next << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  for (int axis = 0; axis < 3; ++axis, turn = turn * next) {
    const auto morph = std::make_shared<const Section_morph>(
        Pair_charts{Part_chart::box(source.points, from * turn), Part_chart::box(target.points, to * turn)}, source, target);
    if (!best || morph->error() < best->error()) best = morph;
  }
  return best;
}

} // namespace CGAL::Shape_correspondence::internal
