// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "abstraction/spatial_graph.h"
#include "base/deadline.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/version.h>

#include <memory>

namespace CGAL::Shape_correspondence::internal {

/// What moves the vertices in a step of the flow.
enum class Contraction {
  CGAL,         ///< `CGAL::Mean_curvature_flow_skeletonization`, as it is
  NEAREST_POLES ///< `contracted()`: the same equations, poles found by shrinking balls, which is faster
};

/// The mean curvature flow of one closed mesh (Tagliasacchi et al. 2012), run step by step.
class Stepwise_flow
{
public:
  /// \param iterations the flow fails that needs more
  Stepwise_flow(const Part_mesh& mesh, Contraction contraction, int iterations, const Deadline& deadline);
  ~Stepwise_flow();
  Stepwise_flow(const Stepwise_flow&) = delete;
  Stepwise_flow& operator=(const Stepwise_flow&) = delete;

  /// Runs until the enclosed volume falls under a fraction of the original one, or until nothing changes any more.
  /// \throw Flow_failure
  void run_to_volume(double fraction);
  /// Runs until nothing changes any more. \throw Flow_failure
  void run_to_convergence();

  int iterations() const;
  /// Area of the meso-skeleton over that of the mesh.
  double area_kept() const;
  /// What the flow has made of the mesh so far.
  Part_mesh meso_skeleton() const;
  /// \pre the flow has converged
  Spatial_graph curve_skeleton();

private:
  class State;
  std::unique_ptr<State> state_;
};

} // namespace CGAL::Shape_correspondence::internal
