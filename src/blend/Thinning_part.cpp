// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Thinning_part.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Shape_correspondence::internal {
namespace {

constexpr int ring_stations = 48;

/// Whether the least extent is more than a share of the greatest one.
bool is_block(const Point& half_extents)
{
  constexpr double thick = 0.6;
  return half_extents.minCoeff() > thick * half_extents.maxCoeff();
}

} // namespace

Thinning_part::Thinning_part(const Part_abstraction& part, const Points& control_points, const Part_chart& chart,
                             const Part_mesh& mesh)
    : chart_(chart), mesh_(mesh), middles_(3, mesh.points.cols()), lines_(3, mesh.points.cols())
{
  form_ = part.is_closed_curve()           ? Form::RING
          : is_block(chart.half_extents()) ? Form::BLOCK
          : chart.is_sheet()               ? Form::PLATE
                                           : Form::ROD;
  if (form_ == Form::RING) {
    const Curve curve{control_points, true};
    ring_.resize(3, ring_stations);
    for (int i = 0; i < ring_stations; ++i)
      ring_.col(i) = curve(double(i) / ring_stations);
  }
  for (Eigen::Index i = 0; i < mesh.points.cols(); ++i) {
    const Middle middle = middle_of(mesh.points.col(i));
    middles_.col(i) = middle.middle;
    lines_.col(i) = middle.line;
  }
}

Thinning_part::Middle Thinning_part::middle_of(const Point& p) const
{
  switch (form_) {
  case Form::BLOCK:
    return {chart_(Point::Zero()), chart_(Point::Zero())};
  case Form::RING: {
    Eigen::Index nearest = 0;
    (ring_.colwise() - p).colwise().squaredNorm().minCoeff(&nearest);
    return {ring_.col(nearest), ring_.col(nearest)};
  }
  case Form::ROD: {
    const Point on_curve = chart_(Point(chart_.coordinates(p)[0], 0, 0));
    return {on_curve, on_curve};
  }
  default:
    constexpr double square = 1.5; // the most of the longer extent over the shorter one
    const Point half = chart_.half_extents(), k = chart_.coordinates(p);
    const int length = half[0] < half[1] ? 1 : 0;
    const bool is_square = half[length] < square * half[1 - length];
    return {chart_(Point(k[0], k[1], 0)), chart_((is_square ? 0 : k[length]) * Point::Unit(length))};
  }
}

/// The volume goes with the square of the scale across a curve, and with the third power of that of a block.
Thinning_part::Scales Thinning_part::scales(double remaining) const
{
  constexpr double narrowing = 0.4; // what remains when a plate begins to narrow
  if (form_ == Form::BLOCK) return {std::cbrt(remaining), 1};
  if (form_ != Form::PLATE) return {std::sqrt(remaining), 1};
  return {remaining, std::min(1., remaining / narrowing)};
}

Points Thinning_part::points(double remaining) const
{
  if (remaining >= 1) return mesh_.points;
  const Scales scale = scales(remaining);
  return scale.to_middle * (mesh_.points - middles_) + scale.to_line * (middles_ - lines_) + lines_;
}

Point Thinning_part::place(const Point& p, double remaining) const
{
  if (remaining >= 1) return p;
  const Middle at = middle_of(p);
  const Scales scale = scales(remaining);
  return scale.to_middle * (p - at.middle) + scale.to_line * (at.middle - at.line) + at.line;
}

} // namespace CGAL::Shape_correspondence::internal
