// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ABSTRACTION_ABSTRACT_MESH_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ABSTRACTION_ABSTRACT_MESH_H

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/abstract_part.h>
#include <CGAL/Shape_correspondence/internal/abstraction/bounding_box.h>
#include <CGAL/Shape_correspondence/internal/abstraction/canonical_form.h>
#include <CGAL/Shape_correspondence/internal/abstraction/fit_curve.h>
#include <CGAL/Shape_correspondence/internal/abstraction/fit_sheet.h>
#include <CGAL/Shape_correspondence/internal/abstraction/hull.h>
#include <CGAL/Shape_correspondence/internal/abstraction/intrinsic_extent.h>
#include <CGAL/Shape_correspondence/internal/abstraction/medial_poles.h>
#include <CGAL/Shape_correspondence/internal/abstraction/repair.h>
#include <CGAL/Shape_correspondence/internal/abstraction/skeletonize.h>
#include <CGAL/Shape_correspondence/internal/abstraction/surface_samples.h>

#include <cmath>
#include <exception>
#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

constexpr std::size_t surface_points_of_a_part = 256;

/// What a part is like when it is measured along itself.
enum class Intrinsic_kind { ELONGATED, FLAT, COMPACT };

/// \param layout of the medial axis
/// \param thickness mean distance of the surface from the medial axis
/// \param box extents of the bounding box, longest first
inline Intrinsic_kind intrinsic_kind(const Intrinsic_layout& layout, double thickness, const Eigen::Vector3d& box)
{
  const double least_width = 0.21, least_depth = 0.5, least_thickness = 0.3, least_height = 0.32;
  const Eigen::Vector3d& extents = layout.extents;
  if (extents[1] <= least_width * extents[0]) {
    return Intrinsic_kind::ELONGATED;
  }
  const bool is_thick = thickness > least_thickness * extents[0] && box[2] > least_height * box[0];
  return is_thick || extents[2] >= least_depth * extents[1] ? Intrinsic_kind::COMPACT : Intrinsic_kind::FLAT;
}

/// 2 of a closed connected surface without handles, less by two for each handle.
inline Eigen::Index euler_characteristic(const Part_mesh& closed)
{
  return closed.points.cols() - closed.triangles.cols() / 2;
}

/// The edge length that the options ask for, longer where that would make too many triangles.
inline double target_edge_length(const Part_mesh& solid, const Abstraction_options& options)
{
  const double triangle_area = surface_area(solid) / options.triangles;
  return std::max(options.edge_length * diagonal(solid.points), std::sqrt(triangle_area * 4 / std::sqrt(3.)));
}

/// Finds the curve or sheet of one part.
class Skeletonizer
{
public:
  Skeletonizer(const Shape_part& part, const Abstraction_options& options)
      : mesh_(part.mesh),
        options_(options),
        kind_(options.kind_of(part.name)),
        deadline_(options.time_limit),
        diagonal_(diagonal(part.mesh.points))
  {}

  /// \throw Flow_failure, or what else the algorithms below throw
  void run()
  {
    watch_.lap();
    const Repaired_part repaired = repair_part(mesh_, deadline_);
    report().repair = repaired.repair;
    report().several_components = repaired.several_components;
    result_.volume = repaired.volume;
    report().phases.repair = watch_.lap();
    edge_length_ = target_edge_length(repaired.mesh, options_);
    const Part_mesh solid = remeshed(repaired.mesh, edge_length_, deadline_);
    report().phases.remesh = watch_.lap();
    const Eigen::Index fewest_vertices = 50;
    if (solid.points.cols() < fewest_vertices) {
      throw Flow_failure("its surface encloses next to nothing");
    }
    Stepwise_flow flow(solid, options_.maximum_iterations, deadline_);
    follow(flow, solid);
    report().iterations = flow.iterations();
    if (!result_.control_points().allFinite()) {
      throw Flow_failure("its skeleton is not finite");
    }
  }

  /// What is known so far, also after a failure.
  Part_abstraction& result() { return result_; }

private:
  using Method = Abstraction_report::Method;

  Abstraction_report& report() { return result_.report; }

  void follow(Stepwise_flow& flow, const Part_mesh& solid)
  {
    const bool has_handle = euler_characteristic(solid) < 2;
    const Spatial_graph axis = medial_graph(solid);
    const Intrinsic_kind kind = kind_of(axis, solid);
    report().phases.fit = watch_.lap();
    flow.run_to_volume(options_.stop_volume);
    const double area_kept = flow.area_kept();
    const Points medial = medial_points(flow.meso_skeleton().points, axis.points);
    report().phases.flow = watch_.lap();
    if (kind_ == Abstraction_kind::SHEET ||
        (kind_ == Abstraction_kind::AUTOMATIC && kind == Intrinsic_kind::FLAT && !has_handle)) {
      use_sheet(medial);
      return;
    }
    flow.run_to_convergence();
    report().phases.flow += watch_.lap();
    const Fitted_curve fitted = fit_curve(flow.curve_skeleton(), solid.points, options_.curve_points);
    const double tube_area = 0.5;
    report().tube = fitted.curve.closed && area_kept > tube_area;
    if (kind_ == Abstraction_kind::AUTOMATIC &&
        (report().tube || (kind == Intrinsic_kind::FLAT && !fitted.curve.closed))) {
      use_sheet(medial);
      return;
    }
    report().blob = kind == Intrinsic_kind::COMPACT && !fitted.curve.closed;
    use_curve(fitted);
  }

  Intrinsic_kind kind_of(const Spatial_graph& axis, const Part_mesh& solid) const
  {
    Spatial_graph_view layer(axis);
    layer.connect_near(edge_length_);
    const double thickness = (axis.points - solid.points).colwise().norm().mean();
    return intrinsic_kind(intrinsic_layout(layer), thickness, oriented_box(mesh_.points).extents);
  }

  /// What a sheet is fitted to: the meso-skeleton, or the medial axis where the flow has drawn a narrow sheet together
  /// to a line.
  static Points medial_points(const Points& meso, const Points& axis)
  {
    const double least_width_kept = 0.5;
    const auto width = [](const Points& points) {
      const Eigen::Vector3d variances = principal_variances(points);
      return std::sqrt(variances[1] / variances[0]);
    };
    return width(meso) >= least_width_kept * width(axis) ? meso : axis;
  }

  void use_curve(const Fitted_curve& fitted)
  {
    const double shortest = 0.2;
    const double least_coverage = 0.8;
    if (fitted.curve.points.cols() < 2 || arc_lengths(fitted.curve).back() < shortest * diagonal_) {
      throw Flow_failure("its skeleton is a point");
    }
    result_.geometry = fitted.curve;
    report().method = Method::SKELETON;
    report().coverage = fitted.coverage;
    report().branching = fitted.coverage < least_coverage;
    report().residual = fitted.residual / diagonal_;
    report().phases.fit += watch_.lap();
  }

  void use_sheet(const Points& medial)
  {
    const Fitted_sheet fitted = fit_sheet(medial, mesh_.points, options_.sheet_points);
    result_.geometry = fitted.sheet;
    report().method = Method::MESO_SKELETON;
    report().residual = fitted.residual / diagonal_;
    report().phases.fit += watch_.lap();
  }

  const Part_mesh& mesh_;
  const Abstraction_options& options_;
  Abstraction_kind kind_;
  Deadline deadline_;
  double diagonal_;
  double edge_length_ = 0;
  Stop_watch watch_;
  Part_abstraction result_;
};

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

} // namespace internal

CGAL_SHAPE_CORRESPONDENCE_INLINE
Part_abstraction Skeleton_abstraction::operator()(const Shape_part& part, const Abstraction_options& options) const
{
  internal::Skeletonizer skeletonizer(part, options);
  std::string failure;
  bool time_limit = false;
  try {
    skeletonizer.run();
    return std::move(skeletonizer.result());
  } catch (const internal::Out_of_time& error) {
    failure = error.what();
    time_limit = true;
  } catch (const internal::Flow_failure& error) {
    failure = error.what();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    failure = "its surface is too degenerate for the flow";
  }
  Part_abstraction result = Bounding_box_abstraction()(part, options);
  result.volume = skeletonizer.result().volume;
  const Abstraction_report& tried = skeletonizer.result().report;
  result.report.repair = tried.repair;
  result.report.several_components = tried.several_components;
  result.report.phases = tried.phases;
  result.report.fallback = failure;
  result.report.time_limit = time_limit;
  return result;
}

CGAL_SHAPE_CORRESPONDENCE_INLINE
Part_abstraction Bounding_box_abstraction::operator()(const Shape_part& part, const Abstraction_options& options) const
{
  const internal::Oriented_box box = internal::oriented_box(part.mesh.points);
  const Abstraction_kind kind = options.kind_of(part.name);
  const bool is_sheet =
      kind == Abstraction_kind::AUTOMATIC ? internal::is_flat(box.extents) : kind == Abstraction_kind::SHEET;
  Part_abstraction result;
  if (is_sheet) {
    result.geometry = internal::medial_sheet(box, options.sheet_points);
  } else {
    result.geometry = internal::medial_curve(box, options.curve_points);
  }
  result.report.method = Abstraction_report::Method::BOUNDING_BOX;
  result.report.blob = !is_sheet && internal::is_compact(box.extents);
  return result;
}
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ABSTRACTION_ABSTRACT_MESH_H
