// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_PART_ABSTRACTION_IMPL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_PART_ABSTRACTION_IMPL_H

#include <CGAL/Shape_correspondence/Part_abstraction.h>
#include <CGAL/Shape_correspondence/internal/curve_and_sheet_geometry.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <variant>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
CGAL_SHAPE_CORRESPONDENCE_INLINE
Point Curve::operator()(double t) const
{
  const std::vector<double> lengths = internal::arc_lengths(*this);
  return internal::point_at_length(*this, lengths, std::clamp(t, 0., 1.) * lengths.back());
}

CGAL_SHAPE_CORRESPONDENCE_INLINE
Point Sheet::operator()(double u, double v) const
{
  const internal::Cell_position row = internal::locate_cell(u, rows - 1);
  const internal::Cell_position col = internal::locate_cell(v, cols - 1);
  const auto along_row = [&](int i) -> Point {
    return (1 - col.fraction) * points.col(i * cols + col.cell) + col.fraction * points.col(i * cols + col.cell + 1);
  };
  return (1 - row.fraction) * along_row(row.cell) + row.fraction * along_row(row.cell + 1);
}

CGAL_SHAPE_CORRESPONDENCE_INLINE
const Points& Part_abstraction::control_points() const
{
  return std::visit([](const auto& g) -> const Points& { return g.points; }, geometry);
}

CGAL_SHAPE_CORRESPONDENCE_INLINE
Points sample(const Curve& curve, int e)
{
  CGAL_precondition(e >= 2);
  const std::vector<double> lengths = internal::arc_lengths(curve);
  const double intervals = curve.closed ? e : e - 1;
  Points result(3, e);
  for (int k = 0; k < e; ++k) {
    result.col(k) = internal::point_at_length(curve, lengths, lengths.back() * (k / intervals));
  }
  return result;
}

CGAL_SHAPE_CORRESPONDENCE_INLINE
Points sample(const Sheet& sheet, int e)
{
  CGAL_precondition(e >= 2);
  Points result(3, static_cast<Eigen::Index>(e) * e);
  for (int i = 0; i < e; ++i) {
    for (int j = 0; j < e; ++j) {
      result.col(static_cast<Eigen::Index>(i) * e + j) = sheet(i / (e - 1.), j / (e - 1.));
    }
  }
  return result;
}

CGAL_SHAPE_CORRESPONDENCE_INLINE
Points sample(const Part_abstraction& part, int e)
{
  return std::visit([e](const auto& g) { return sample(g, e); }, part.geometry);
}

CGAL_SHAPE_CORRESPONDENCE_INLINE
Eigen::Vector2d nearest_parameter(const Part_abstraction& part, const Point& p)
{
  return part.is_sheet() ? internal::nearest_parameter_on_sheet(std::get<Sheet>(part.geometry), p)
                         : internal::nearest_parameter_on_curve(std::get<Curve>(part.geometry), p);
}

CGAL_SHAPE_CORRESPONDENCE_INLINE
Point evaluate(const Part_abstraction& part, const Eigen::Vector2d& parameter)
{
  return part.is_sheet() ? std::get<Sheet>(part.geometry)(parameter[0], parameter[1])
                         : std::get<Curve>(part.geometry)(parameter[0]);
}

CGAL_SHAPE_CORRESPONDENCE_INLINE
double solidity(double volume, double hull_volume)
{
  return volume > 0 && hull_volume > 0 ? std::min(1., volume / hull_volume) : 1.;
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_PART_ABSTRACTION_IMPL_H
