// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "abstraction/bounding_box.h"
#include "abstraction/canonical_form.h"
#include "abstraction/fit_curve.h"
#include "abstraction/fit_sheet.h"
#include "abstraction/hull.h"
#include "abstraction/intrinsic_extent.h"
#include "abstraction/medial_poles.h"
#include "abstraction/repair.h"
#include "abstraction/revolution_axis.h"
#include "abstraction/skeletonize.h"
#include "abstraction/surface_samples.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/abstract_part.h>

#include <cmath>
#include <exception>
#include <optional>
#include <string>

namespace CGAL::Shape_correspondence {
namespace internal {

constexpr std::size_t surface_points_of_a_part = 256;

/// What a part is like when it is measured along itself. A blade is long, but far wider than thick; a block is compact
/// and so thick that its medial axis tells no direction.
enum class Intrinsic_kind { ELONGATED, BLADE, FLAT, COMPACT, BLOCK };

/// \param layout of the medial axis
/// \param thickness mean distance of the surface from the medial axis
/// \param box extents of the bounding box, longest first
inline Intrinsic_kind intrinsic_kind(const Intrinsic_layout& layout, double thickness, const Eigen::Vector3d& box)
{
  const double least_width = 0.21;        // of a sheet, over its length
  const double least_depth = 0.5;         // of what is compact, over its width
  const double least_blade_width = 0.075; // over its length
  const double blade_thickness = 0.26;    // over its width at most; a blade is 7.7 times as wide as thick
  const double least_thickness = 0.3;     // of a block, over its length
  const double least_height = 0.32, plate_height = 0.45; // of a block's box, over its length and its width
  const Eigen::Vector3d& extents = layout.extents;
  if (extents[1] <= least_width * extents[0]) {
    const bool is_blade = extents[1] > least_blade_width * extents[0] && thickness < blade_thickness * extents[1];
    return is_blade ? Intrinsic_kind::BLADE : Intrinsic_kind::ELONGATED;
  }
  if (thickness > least_thickness * extents[0] && box[2] > least_height * box[0] && box[2] > plate_height * box[1]) {
    return Intrinsic_kind::BLOCK;
  }
  return extents[2] >= least_depth * extents[1] ? Intrinsic_kind::COMPACT : Intrinsic_kind::FLAT;
}

/// Whether a body of revolution is known by its axis rather than as a disc; with a hole through it, only a tube of a
/// thin wall is, for others are rings.
inline bool is_slender(const Revolution_axis& axis, double thickness, bool has_handle)
{
  const double least_slenderness = has_handle ? 0.15 : 1. / 3; // height over diameter
  const double thin_wall = 0.25;                               // its thickness over the height, at most
  return axis.slenderness >= least_slenderness && (!has_handle || 2 * thickness <= thin_wall * axis.height);
}

/// Whether a part that is compact along itself is so for its walls only, as a carcass of boards.
inline bool is_carcass(const Intrinsic_layout& layout, double thickness)
{
  const double thin_wall = 0.2; // half its thickness over the depth, at most
  return thickness < thin_wall * layout.extents[2];
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
    find_geometry(solid);
    if (!result_.control_points().allFinite()) {
      throw Flow_failure("its skeleton is not finite");
    }
  }

  /// What is known so far, also after a failure.
  Part_abstraction& result() { return result_; }

private:
  using Method = Abstraction_report::Method;

  Abstraction_report& report() { return result_.report; }

  void find_geometry(const Part_mesh& solid)
  {
    const Spatial_graph axis = medial_graph(solid);
    const double thickness = (axis.points - solid.points).colwise().norm().mean();
    const Intrinsic_layout layout = layout_of(axis);
    const Oriented_box box = oriented_box(mesh_.points);
    const bool has_handle = euler_characteristic(solid) < 2;
    const Intrinsic_kind measured = intrinsic_kind(layout, thickness, box.extents);
    const std::optional<Revolution_axis> revolution = axis_of_revolution(solid, measured);
    report().phases.fit = watch_.lap();
    if (revolution && is_slender(*revolution, thickness, has_handle)) {
      report().tube = has_handle;
      use_axis(revolution->curve(mesh_.points, options_.curve_points));
      return;
    }
    // Flat as a whole, though not along itself: a disc on a long axle, a flat carcass
    const bool is_disc = revolution && !has_handle && measured != Intrinsic_kind::FLAT;
    const bool is_flat_carcass =
        measured == Intrinsic_kind::COMPACT && is_carcass(layout, thickness) && is_flat(box.extents);
    const Intrinsic_kind kind = is_disc || is_flat_carcass ? Intrinsic_kind::FLAT : measured;
    const auto sheet = [&] {
      return is_disc ? fit_sheet(axis.points, mesh_.points, options_.sheet_points)
             : is_flat_carcass
                 ? fit_flat_sheet({box.centre, box.axes}, axis.points, mesh_.points, options_.sheet_points)
                 : fitted_sheet(axis.points, layout, thickness);
    };
    if (kind_ == Abstraction_kind::SHEET) {
      use_sheet(sheet());
      return;
    }
    if (kind == Intrinsic_kind::BLOCK && !has_handle) {
      use_axis(medial_curve(box, options_.curve_points, distinct_axis(box)));
      return;
    }
    // Residual of a fit over the diagonal, at most: arms that branch off are no blade, and no curve goes along all
    const double most = 0.02 * diagonal_;
    if (kind_ == Abstraction_kind::AUTOMATIC && !has_handle &&
        (kind == Intrinsic_kind::FLAT || kind == Intrinsic_kind::BLADE)) {
      const Fitted_sheet fitted = sheet();
      if (kind == Intrinsic_kind::FLAT || fitted.residual < most) {
        use_sheet(fitted);
        return;
      }
    }
    const Fitted_curve fitted = contracted_curve(solid, axis.points);
    const bool is_net = fitted.residual > (fitted.curve.closed ? 0.5 : 1.) * most; // a ring is its whole skeleton
    if (kind_ == Abstraction_kind::AUTOMATIC &&
        (report().tube || (is_net && is_flat(box.extents)) || (kind == Intrinsic_kind::FLAT && !fitted.curve.closed))) {
      use_sheet(sheet()); // also of a propeller or a pedal
    } else if (is_net && fitted.curve.closed) {
      use_axis(medial_curve(box, options_.curve_points, distinct_axis(box))); // of a cage
    } else {
      report().blob = (kind == Intrinsic_kind::COMPACT || kind == Intrinsic_kind::BLOCK) && !fitted.curve.closed;
      use_curve(fitted);
    }
  }

  /// The curve that the flow finds. Whether the part is a tube shows on the way.
  Fitted_curve contracted_curve(const Part_mesh& solid, const Points& axis)
  {
    const double tube_area = 0.5; // share of the area that a tube has left when its volume is gone
    Stepwise_flow flow(solid, options_.maximum_iterations, deadline_);
    flow.run_to_volume(options_.stop_volume);
    const double area_kept = flow.area_kept();
    flow.run_to_convergence();
    report().iterations = flow.iterations();
    report().phases.flow = watch_.lap();
    const Fitted_curve result = fit_curve(flow.curve_skeleton(), axis, solid, options_.curve_points);
    report().tube = result.curve.closed && area_kept > tube_area;
    return result;
  }

  Intrinsic_layout layout_of(const Spatial_graph& axis) const
  {
    Spatial_graph_view layer(axis);
    layer.connect_near(edge_length_);
    return intrinsic_layout(layer);
  }

  /// That of a part that is not long, where it says more than a skeleton, which may run in any direction.
  std::optional<Revolution_axis> axis_of_revolution(const Part_mesh& solid, Intrinsic_kind kind) const
  {
    if (kind_ == Abstraction_kind::SHEET || kind == Intrinsic_kind::ELONGATED) {
      return std::nullopt;
    }
    return revolution_axis(solid.points, edge_length_);
  }

  /// A sheet as it is seen from one side, or, of a part that is bent too much for that, along the part itself.
  Fitted_sheet fitted_sheet(const Points& axis, const Intrinsic_layout& layout, double thickness) const
  {
    const double bent = 0.4; // depth over width
    const Fitted_sheet seen = fit_sheet(axis, mesh_.points, options_.sheet_points);
    const Eigen::Vector3d extents = principal_variances(axis).cwiseSqrt();
    if (extents[2] < bent * extents[1]) {
      return seen;
    }
    const Fitted_sheet along = fit_bent_sheet(axis, layout.coordinates, thickness, mesh_.points, options_.sheet_points);
    return along.residual < seen.residual ? along : seen;
  }

  void use_curve(const Fitted_curve& fitted)
  {
    const double shortest = 0.2;       // over the part's diagonal
    const double least_coverage = 0.8; // of the skeleton, of what does not branch
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

  void use_axis(const Curve& axis)
  {
    result_.geometry = axis;
    report().method = Method::REVOLUTION_AXIS;
    report().blob = !report().tube;
    report().phases.fit += watch_.lap();
  }

  void use_sheet(const Fitted_sheet& fitted)
  {
    result_.geometry = fitted.sheet;
    report().method = Method::MEDIAL_AXIS;
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
} // namespace CGAL::Shape_correspondence
