// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/Solid_abstractor.h"
#include "abstraction/curve_and_sheet_geometry.h"
#include "abstraction/fit_sheet.h"
#include "abstraction/inside_test.h"
#include "abstraction/repair.h"
#include "abstraction/surface_samples.h"
#include "base/Nearest_points.h"
#include "shape/convex_hull.h"

#include <CGAL/Shape_correspondence/abstract_part.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <string>
#include <utility>
#include <variant>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// The edge length that the options ask for, or a greater one that bounds the number of triangles.
double target_edge_length(const Part_mesh& solid, const Abstraction_options& options)
{
  const double triangle_area = surface_area(solid) / options.triangles;
  return std::max(options.edge_length * diagonal(solid.points), std::sqrt(triangle_area * 4 / std::sqrt(3.)));
}

/// Whether points lie on a line but for rounding noise: the repaired surface would differ with the version of CGAL.
bool are_in_line(const Points& points)
{
  const double thinnest = 5e-7; // largest thickness over the length
  const Eigen::Vector3d variances = principal_variances(points);
  return variances[1] < thinnest * thinnest * variances[0];
}

} // namespace

void measure_hull(const Points& points, Part_abstraction& part)
{
  const Convex_hull hull = convex_hull(points);
  part.hull = hull.vertices;
  part.hull_volume = hull.volume;
  part.report.hull_of_box = hull.is_box;
}

double Solid_abstractor::hull_volume()
{
  if (result_.hull.cols() == 0) measure_hull(mesh().points, result_);
  return result_.hull_volume;
}

Solid_abstractor::Solid_abstractor(const Shape_part& part, const Abstraction_options& options)
    : part_(part),
      options_(options),
      wanted_kind_(options.kind_of(part.name)),
      deadline_(options.time_limit),
      diagonal_(diagonal(part.mesh.points))
{}

Part_abstraction Solid_abstractor::run()
{
  try {
    try_to_run();
    return std::move(result_);
  } catch (const Out_of_time& error) {
    return bounding_box(error.what(), true);
  } catch (const Flow_failure& error) {
    return bounding_box(error.what(), false);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return bounding_box("its surface is too degenerate for the flow", false);
  }
}

void Solid_abstractor::try_to_run()
{
  const double farthest = 1e6; // largest coordinate, over the diagonal: CGAL divides by differences of coordinates
  watch_.lap();
  if (mesh().points.cwiseAbs().maxCoeff() > farthest * diagonal_)
    throw Flow_failure("it is far from the origin for its size");
  if (are_in_line(mesh().points)) throw Flow_failure("it is as thin as a line");
  const Repaired_part repaired = repair_part(mesh(), deadline_);
  report().repair = repaired.repair;
  report().several_components = repaired.several_components;
  result_.volume = repaired.volume;
  report().phases.repair = watch_.lap();
  if (!repaired.several_components && find_geometry_from_faces(repaired)) return;
  edge_length_ = target_edge_length(repaired.mesh, options_);
  const Part_mesh solid = remeshed(repaired.mesh, edge_length_, deadline_);
  report().phases.remesh = watch_.lap();
  const Eigen::Index fewest_vertices = 50;
  if (solid.points.cols() < fewest_vertices) throw Flow_failure("its surface encloses next to nothing");
  find_geometry(solid);
  if (const Sheet* sheet = std::get_if<Sheet>(&result_.geometry)) {
    report().coverage = share_in_part(sheet->points, solid);
    report().branching = report().coverage < least_coverage;
  }
  if (!result_.control_points().allFinite()) throw Flow_failure("its skeleton is not finite");
}

double Solid_abstractor::share_in_part(const Points& points, const Part_mesh& solid) const
{
  // Greatest distance from the solid that counts as inside: a bent plate deviates less from its sheet
  const double near = 2.5 * edge_length_;
  const Inside_test is_inside(solid);
  const Nearest_points surface(solid.points);
  Eigen::Index count = 0;
  for (const auto& p : points.colwise())
    count += is_inside(p) || surface.distance(p) < near;
  return double(count) / double(points.cols());
}

Part_abstraction Solid_abstractor::bounding_box(const std::string& failure, bool time_limit) const
{
  Part_abstraction result = Bounding_box_abstraction()(part_, options_);
  result.volume = result_.volume;
  result.report.repair = result_.report.repair;
  result.report.several_components = result_.report.several_components;
  result.report.phases = result_.report.phases;
  result.report.fallback = failure;
  result.report.time_limit = time_limit;
  return result;
}

bool Solid_abstractor::is_point(const Fitted_curve& fitted) const
{
  const double shortest = 0.2; // least length of a curve, over the part's diagonal
  return fitted.curve.points.cols() < 2 || arc_lengths(fitted.curve).back() < shortest * diagonal_;
}

void Solid_abstractor::use_curve(const Fitted_curve& fitted, Method method)
{
  if (is_point(fitted)) throw Flow_failure("its skeleton is a point");
  result_.geometry = fitted.curve;
  report().method = method;
  report().coverage = fitted.coverage;
  report().branching = fitted.coverage < least_coverage;
  report().residual = fitted.residual / diagonal_;
  report().phases.fit += watch_.lap();
}

void Solid_abstractor::use_axis(const Curve& axis)
{
  result_.geometry = axis;
  report().method = Method::AXIS;
  report().blob = !report().tube;
  report().phases.fit += watch_.lap();
}

void Solid_abstractor::use_sheet(const Fitted_sheet& fitted, Method method)
{
  result_.geometry = fitted.sheet;
  report().method = method;
  report().residual = fitted.residual / diagonal_;
  report().phases.fit += watch_.lap();
}

void Solid_abstractor::use_prism(std::variant<Curve, Sheet> geometry)
{
  result_.geometry = std::move(geometry);
  report().method = Method::PRISM;
  report().phases.fit += watch_.lap();
}

} // namespace CGAL::Shape_correspondence::internal

namespace CGAL::Shape_correspondence {
using namespace internal;

Part_abstraction Bounding_box_abstraction::operator()(const Shape_part& part, const Abstraction_options& options) const
{
  const Oriented_box box = oriented_box(part.mesh.points);
  const Abstraction_kind kind = options.kind_of(part.name);
  const bool is_sheet = kind == Abstraction_kind::AUTOMATIC ? is_flat(box.extents) : kind == Abstraction_kind::SHEET;
  Part_abstraction result;
  if (is_sheet)
    result.geometry = medial_sheet(box, options.sheet_points);
  else
    result.geometry = medial_curve(box, options.curve_points);
  result.report.method = Abstraction_report::Method::BOUNDING_BOX;
  result.report.blob = !is_sheet && is_compact(box.extents);
  return result;
}

} // namespace CGAL::Shape_correspondence
