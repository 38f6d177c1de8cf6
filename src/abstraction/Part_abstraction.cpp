// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/curve_and_sheet_geometry.h"

#include <CGAL/Shape_correspondence/Part_abstraction.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <variant>
#include <vector>

namespace CGAL::Shape_correspondence {
using namespace internal;

Point Curve::operator()(double t) const
{
  const std::vector<double> lengths = arc_lengths(*this);
  return point_at_length(*this, lengths, clamped_to_unit(t) * lengths.back());
}

Point Sheet::operator()(double u, double v) const
{
  const Cell_position row = locate_cell(u, rows - 1);
  const Cell_position col = locate_cell(v, cols - 1);
  const auto along_row = [&](int i) -> Point {
    return (1 - col.fraction) * points.col(i * cols + col.cell) + col.fraction * points.col(i * cols + col.cell + 1);
  };
  return (1 - row.fraction) * along_row(row.cell) + row.fraction * along_row(row.cell + 1);
}

const Points& Part_abstraction::control_points() const
{
  return std::visit([](const auto& g) -> const Points& { return g.points; }, geometry);
}

Points sample(const Curve& curve, int e)
{
  CGAL_precondition(e >= 2);
  const std::vector<double> lengths = arc_lengths(curve);
  const double intervals = curve.closed ? e : e - 1;
  Points result(3, e);
  for (int k = 0; k < e; ++k)
    result.col(k) = point_at_length(curve, lengths, lengths.back() * (k / intervals));
  return result;
}

Points sample(const Sheet& sheet, int e)
{
  CGAL_precondition(e >= 2);
  Points result(3, Eigen::Index(e) * e);
  for (int i = 0; i < e; ++i) {
    for (int j = 0; j < e; ++j)
      result.col(Eigen::Index(i) * e + j) = sheet(i / (e - 1.), j / (e - 1.));
  }
  return result;
}

Points sample(const Part_abstraction& part, int e)
{
  return std::visit([e](const auto& g) { return sample(g, e); }, part.geometry);
}

Eigen::Vector2d nearest_parameter(const Part_abstraction& part, const Point& p)
{
  return part.is_sheet() ? nearest_parameter_on_sheet(std::get<Sheet>(part.geometry), p)
                         : nearest_parameter_on_curve(std::get<Curve>(part.geometry), p);
}

Point evaluate(const Part_abstraction& part, const Eigen::Vector2d& parameter)
{
  return part.is_sheet() ? std::get<Sheet>(part.geometry)(parameter[0], parameter[1])
                         : std::get<Curve>(part.geometry)(parameter[0]);
}

double solidity(double volume, double hull_volume)
{
  return volume > 0 && hull_volume > 0 ? std::min(1., volume / hull_volume) : 1.;
}

} // namespace CGAL::Shape_correspondence
