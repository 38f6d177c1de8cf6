// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "abstraction/canonical_form.h"
#include "shape/convex_hull.h"
#include "abstraction/surface_samples.h"
#include "abstraction/deadline.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/abstract_part.h>

#include <string>
#include <variant>

namespace CGAL::Shape_correspondence::internal {

constexpr std::size_t surface_points_of_a_part = 256;

inline bool is_valid(const Curve& curve) { return curve.points.cols() >= 2; }

inline bool is_valid(const Sheet& sheet)
{
  return sheet.rows >= 2 && sheet.cols >= 2 && sheet.points.cols() == Eigen::Index(sheet.rows) * sheet.cols;
}

/// The options' abstractor is anybody's.
inline void check_abstraction(const std::string& name, const Part_abstraction& abstraction)
{
  const bool valid = std::visit([](const auto& g) { return is_valid(g); }, abstraction.geometry);
  if (!valid || !abstraction.control_points().allFinite()) {
    throw Invalid_input("part '" + name + "': the abstractor returned " +
                        (valid ? "points that are not finite" : "too few points") + "; correct it or use another one");
  }
}

/// Finds the abstraction of a part whose mesh is in canonical form.
inline Part_abstraction abstract_mesh(const Shape_part& part, const Abstraction_options& options)
{
  Stop_watch watch;
  Part_abstraction result = options.abstractor(part, options);
  check_abstraction(part.name, result);
  std::visit([](auto& g) { make_canonical(g); }, result.geometry);
  watch.lap();
  result.name = part.name;
  result.area = surface_area(part.mesh);
  result.surface = even_surface_points(part.mesh, surface_points_of_a_part);
  const Convex_hull hull = convex_hull(part.mesh.points);
  result.hull = hull.vertices;
  result.hull_volume = hull.volume;
  result.report.phases.measure = watch.lap();
  result.report.milliseconds = 1e3 * watch.seconds();
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
