// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ABSTRACTION_ABSTRACT_MESH_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ABSTRACTION_ABSTRACT_MESH_H

#include <CGAL/Shape_correspondence/abstract_part.h>
#include <CGAL/Shape_correspondence/internal/abstraction/bounding_box.h>
#include <CGAL/Shape_correspondence/internal/abstraction/canonical_form.h>
#include <CGAL/Shape_correspondence/internal/abstraction/fit_curve.h>
#include <CGAL/Shape_correspondence/internal/abstraction/fit_sheet.h>
#include <CGAL/Shape_correspondence/internal/abstraction/hull.h>
#include <CGAL/Shape_correspondence/internal/abstraction/intrinsic_extent.h>
#include <CGAL/Shape_correspondence/internal/abstraction/repair.h>
#include <CGAL/Shape_correspondence/internal/abstraction/skeletonize.h>
#include <CGAL/Shape_correspondence/internal/abstraction/surface_samples.h>

#include <exception>
#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

constexpr std::size_t surface_points_of_a_part = 256;

/// What a meso-skeleton looks like when it is measured along itself.
enum class Intrinsic_kind { ELONGATED, FLAT, COMPACT };

inline Intrinsic_kind intrinsic_kind(const Eigen::Vector3d& extents, double area_kept)
{
  const double least_area = 0.1;
  if (is_compact(extents)) {
    return Intrinsic_kind::COMPACT;
  }
  return is_flat(extents) && area_kept > least_area ? Intrinsic_kind::FLAT : Intrinsic_kind::ELONGATED;
}

/// 2 of a closed connected surface without handles, less by two for each handle.
inline int euler_characteristic(const Surface& mesh)
{
  return static_cast<int>(mesh.number_of_vertices()) - static_cast<int>(mesh.number_of_edges()) +
         static_cast<int>(mesh.number_of_faces());
}

/// Finds the abstraction of one mesh in canonical form.
class Mesh_abstraction
{
public:
  Mesh_abstraction(const Part_mesh& mesh, const Abstraction_options& options)
      : mesh_(mesh), options_(options), diagonal_(diagonal(mesh.points))
  {}

  Part_abstraction run(const std::string& name)
  {
    result_.name = name;
    measure();
    try {
      skeletonize();
    } catch (const std::exception&) {
      use_bounding_box();
    }
    if (!result_.control_points().allFinite()) {
      use_bounding_box();
    }
    std::visit([](auto& g) { make_canonical(g); }, result_.geometry);
    result_.report.milliseconds = 1e3 * watch_.seconds();
    return std::move(result_);
  }

private:
  using Method = Abstraction_report::Method;

  /// What the original surface says without any repair.
  void measure()
  {
    result_.area = surface_area(mesh_);
    result_.surface = even_surface_points(mesh_, surface_points_of_a_part);
    const Convex_hull hull = convex_hull(mesh_.points);
    result_.hull = hull.vertices;
    result_.hull_volume = hull.volume;
  }

  void skeletonize()
  {
    Repaired_part repaired = repair_part(mesh_);
    result_.report.repair = repaired.repair;
    result_.report.several_components = repaired.several_components;
    result_.volume = repaired.volume;
    remesh_evenly(repaired.mesh, options_.edge_length * diagonal(repaired.mesh));
    require_fit_for_flow(repaired.mesh);
    Stepwise_flow flow(repaired.mesh, {options_.maximum_iterations, options_.time_limit, &watch_});
    try {
      follow(flow, repaired.mesh);
    } catch (const std::exception&) {
      result_.report.time_limit = flow.out_of_time();
      result_.report.iterations = flow.iterations();
      throw;
    }
    result_.report.iterations = flow.iterations();
  }

  static void require_fit_for_flow(const Surface& mesh)
  {
    const std::size_t fewest_vertices = 50;
    if (mesh.number_of_vertices() < fewest_vertices || !CGAL::is_closed(mesh)) {
      throw Flow_failure("the remeshed part is no solid");
    }
  }

  void follow(Stepwise_flow& flow, const Surface& solid)
  {
    const Points solid_points = vertex_positions(solid);
    const bool has_handle = euler_characteristic(solid) < 2;
    flow.run_to_volume(options_.stop_volume);
    const Spatial_graph meso = flow.meso_skeleton();
    const double area_kept = flow.area_kept();
    Spatial_graph_view layer(meso);
    layer.connect_near(options_.edge_length * diagonal(solid_points));
    const Intrinsic_layout layout = intrinsic_layout(layer);
    const Intrinsic_kind kind = intrinsic_kind(layout.extents, area_kept);
    if (kind == Intrinsic_kind::FLAT && !has_handle) {
      use_sheet(meso);
      return;
    }
    flow.run_to_convergence();
    const Fitted_curve fitted = fit_curve(flow.curve_skeleton(), solid_points, options_.curve_points);
    const double tube_area = 0.5;
    if (fitted.curve.closed && area_kept <= tube_area) {
      use_curve(fitted);
    } else if (fitted.curve.closed || kind == Intrinsic_kind::FLAT) {
      result_.report.tube = fitted.curve.closed;
      use_sheet(meso);
    } else {
      result_.report.blob = kind == Intrinsic_kind::COMPACT;
      use_curve(fitted);
    }
  }

  void use_curve(const Fitted_curve& fitted)
  {
    const double shortest = 0.2;
    const double least_coverage = 0.8;
    if (fitted.curve.points.cols() < 2 || arc_lengths(fitted.curve).back() < shortest * diagonal_) {
      throw Flow_failure("the skeleton is a point");
    }
    result_.geometry = fitted.curve;
    result_.report.method = Method::SKELETON;
    result_.report.coverage = fitted.coverage;
    result_.report.branching = fitted.coverage < least_coverage;
    result_.report.residual = fitted.residual / diagonal_;
  }

  void use_sheet(const Spatial_graph& meso)
  {
    const Fitted_sheet fitted = fit_sheet(meso.points, mesh_.points, options_.sheet_points);
    result_.geometry = fitted.sheet;
    result_.report.method = Method::MESO_SKELETON;
    result_.report.residual = fitted.residual / diagonal_;
  }

  void use_bounding_box()
  {
    const Oriented_box box = oriented_box(mesh_.points);
    result_.geometry = medial_geometry(box, options_.curve_points, options_.sheet_points);
    result_.report.method = Method::BOUNDING_BOX;
    result_.report.blob = is_compact(box.extents);
  }

  const Part_mesh& mesh_;
  const Abstraction_options& options_;
  double diagonal_;
  Stop_watch watch_;
  Part_abstraction result_;
};

inline Part_abstraction abstract_mesh(const std::string& name, const Part_mesh& mesh,
                                      const Abstraction_options& options)
{
  return Mesh_abstraction(mesh, options).run(name);
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ABSTRACTION_ABSTRACT_MESH_H
