// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ABSTRACTION_SKELETONIZE_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ABSTRACTION_SKELETONIZE_H

#include <CGAL/Shape_correspondence/internal/abstraction/meshes.h>
#include <CGAL/Shape_correspondence/internal/abstraction/reproducible_flow.h>
#include <CGAL/Shape_correspondence/internal/abstraction/spatial_graph.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <chrono>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

class Stop_watch
{
public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Thrown inside the room only: the flow cannot treat a mesh, something else must stand in.
class Flow_failure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The mean curvature flow of one closed mesh, run step by step.
class Stepwise_flow
{
public:
  /// Limits that make the flow fail when they are passed.
  struct Limits
  {
    int iterations;
    double seconds; ///< on `watch`
    const Stop_watch* watch;
  };

  Stepwise_flow(const Surface& mesh, const Limits& limits)
      : limits_(limits),
        flow_(mesh),
        area_(to_double(CGAL::Polygon_mesh_processing::area(mesh))),
        volume_(std::abs(to_double(CGAL::Polygon_mesh_processing::volume(mesh))))
  {
    // w_H = 0.1, w_P = 0.2 and medially centred: the library's defaults, and what was measured to work.
    flow_.set_quality_speed_tradeoff(0.1);
    flow_.set_medially_centered_speed_tradeoff(0.2);
    flow_.set_is_medially_centered(true);
    last_area_ = area_;
  }

  /// Runs until the enclosed volume falls under a fraction of the original one, or until it does not change any more.
  void run_to_volume(double fraction)
  {
    while (!converged_ && current_volume() > fraction * volume_) {
      step();
    }
  }

  void run_to_convergence()
  {
    while (!converged_) {
      step();
    }
  }

  int iterations() const { return iterations_; }
  bool out_of_time() const { return out_of_time_; }
  double area_kept() const { return last_area_ / area_; }

  Spatial_graph meso_skeleton() const
  {
    const Flow_mesh& mesh = flow_.meso_skeleton();
    Spatial_graph result;
    result.points.resize(3, static_cast<Eigen::Index>(mesh.size_of_vertices()));
    std::unordered_map<std::size_t, int> index;
    for (auto v : vertices(mesh)) {
      const int i = static_cast<int>(index.size());
      index[v->id()] = i;
      result.points.col(i) = to_point(v->point());
    }
    for (auto e : edges(mesh)) {
      result.edges.emplace_back(index.at(source(e, mesh)->id()), index.at(target(e, mesh)->id()));
    }
    return result;
  }

  Spatial_graph curve_skeleton()
  {
    Flow::Skeleton skeleton;
    flow_.convert_to_skeleton(skeleton);
    Spatial_graph result;
    result.points.resize(3, static_cast<Eigen::Index>(num_vertices(skeleton)));
    for (std::size_t v = 0; v < num_vertices(skeleton); ++v) {
      result.points.col(static_cast<Eigen::Index>(v)) = to_point(skeleton[v].point);
    }
    for (auto e : CGAL::make_range(edges(skeleton))) {
      result.edges.emplace_back(static_cast<int>(source(e, skeleton)), static_cast<int>(target(e, skeleton)));
    }
    return result;
  }

private:
  void step()
  {
    if (iterations_ == limits_.iterations) {
      throw Flow_failure("the flow needs more iterations than allowed");
    }
    ++iterations_;
    flow_.contract_geometry();
    check();
    flow_.collapse_edges();
    check();
    flow_.split_faces();
    check();
    flow_.detect_degeneracies();
    update_area();
  }

  void check()
  {
    if (limits_.watch->seconds() > limits_.seconds) {
      out_of_time_ = true;
      throw Flow_failure("the flow needs more time than allowed");
    }
    if (flow_.meso_skeleton().size_of_vertices() < 4) {
      throw Flow_failure("the flow collapsed the mesh to a point");
    }
    for (auto v : vertices(flow_.meso_skeleton())) {
      const Point p = to_point(v->point());
      if (!p.allFinite()) {
        throw Flow_failure("the flow's equations have no solution");
      }
    }
  }

  void update_area()
  {
    // As in the library's own convergence test.
    const double smallest_change = 1e-4;
    const double area = to_double(CGAL::Polygon_mesh_processing::area(flow_.meso_skeleton()));
    converged_ = std::abs(area - last_area_) < smallest_change * area_;
    last_area_ = area;
  }

  double current_volume() const
  {
    return std::abs(to_double(CGAL::Polygon_mesh_processing::volume(flow_.meso_skeleton())));
  }

  Limits limits_;
  Flow flow_;
  double area_;
  double volume_;
  double last_area_ = 0;
  int iterations_ = 0;
  bool converged_ = false;
  bool out_of_time_ = false;
};

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ABSTRACTION_SKELETONIZE_H
