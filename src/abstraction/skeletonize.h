// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "abstraction/repair.h"
#include "abstraction/spatial_graph.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <memory>

namespace CGAL::Shape_correspondence::internal {

/// Weights of the flow: w_H keeps a vertex in place, w_P pulls it to its pole. CGAL calls them
/// `quality_speed_tradeoff()` and `medially_centered_speed_tradeoff()`; the larger they are, the slower is the flow.
struct Flow_weights
{
  double velocity = 0.1; ///< w_H, which keeps a vertex in place
  double medial = 0.2;   ///< w_P, which pulls a vertex to its pole
};

/// Weights for the meso-skeleton: with CGAL's, a narrow sheet may become a curve in the first step.
constexpr Flow_weights slow_flow{0.3, 0.6};

/// Mean curvature flow of a closed mesh (Tagliasacchi et al. 2012), run step by step: a wrapper of
/// `CGAL::Mean_curvature_flow_skeletonization`.
class Stepwise_flow
{
public:
  /// \param iterations number of iterations after which the flow fails
  Stepwise_flow(const Part_mesh& mesh, int iterations, const Deadline& deadline);
  ~Stepwise_flow();
  Stepwise_flow(const Stepwise_flow&) = delete;
  Stepwise_flow& operator=(const Stepwise_flow&) = delete;

  void set_weights(const Flow_weights& weights);
  /// Runs until the enclosed volume is below a fraction of the original one, or the mesh no longer changes.
  /// \throw Flow_failure
  void run_to_volume(double fraction);
  /// Runs until the mesh no longer changes. \throw Flow_failure
  void run_to_convergence();

  int iterations() const;
  /// Area of the meso-skeleton over that of the mesh.
  double area_kept() const;
  /// The mesh contracted so far.
  Part_mesh meso_skeleton() const;
  /// The curve skeleton to which the mesh has contracted. \pre the flow has converged
  Spatial_graph curve_skeleton();

private:
  class State;
  std::unique_ptr<State> state_;
};

} // namespace CGAL::Shape_correspondence::internal
