// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/skeletonize.h"
#include "abstraction/reproducible_flow.h"
#include "abstraction/surface_samples.h"
#include "base/library_call.h"
#include "shape/meshes.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
class Stepwise_flow::State
{
public:
  State(const Part_mesh& mesh, int iterations, const Deadline& deadline)
      : most_iterations_(iterations),
        deadline_(&deadline),
        flow_(to_halfedge_mesh(mesh)),
        original_area_(surface_area(mesh)),
        original_volume_(enclosed_volume(mesh)),
        mesh_(mesh_of_flow()),
        area_(original_area_),
        volume_(original_volume_)
  {
    check_library_call("flow");
  }

  void step()
  {
    if (iterations_ == most_iterations_) throw Flow_failure("the flow needs more iterations than allowed");
    ++iterations_;
    flow_.contract_geometry();
    deadline_->check();
    flow_.collapse_edges();
    deadline_->check();
    flow_.split_faces();
    deadline_->check();
    flow_.detect_degeneracies();
    if (num_vertices(flow_mesh()) < 4) throw Flow_failure("the flow collapses the part to a point");
    // The value of CGAL's own convergence test
    const double smallest_change = 1e-4;
    const double last_area = area_;
    mesh_ = mesh_of_flow();
    if (!mesh_.points.allFinite()) throw Flow_failure("the equations of the flow have no solution");
    area_ = surface_area(mesh_);
    volume_ = enclosed_volume(mesh_);
    converged_ = std::abs(area_ - last_area) < smallest_change * original_area_;
  }

  void set_weights(const Flow_weights& weights)
  {
    flow_.set_quality_speed_tradeoff(weights.velocity);
    flow_.set_medially_centered_speed_tradeoff(weights.medial);
  }

  bool converged() const { return converged_; }
  int iterations() const { return iterations_; }
  double area_kept() const { return area_ / original_area_; }
  double volume_kept() const { return original_volume_ > 0 ? volume_ / original_volume_ : 0; }

  const Part_mesh& mesh() const { return mesh_; }

  Spatial_graph curve_skeleton()
  {
    Flow::Skeleton skeleton;
    flow_.convert_to_skeleton(skeleton);
    Spatial_graph result;
    result.points.resize(3, Eigen::Index(num_vertices(skeleton)));
    for (std::size_t v = 0; v < num_vertices(skeleton); ++v)
      result.points.col(Eigen::Index(v)) = to_point(skeleton[v].point);
    for (auto e : CGAL::make_range(edges(skeleton)))
      result.edges.emplace_back(int(source(e, skeleton)), int(target(e, skeleton)));
    return result;
  }

private:
  Part_mesh mesh_of_flow() const
  {
    Part_mesh result;
    result.points.resize(3, Eigen::Index(num_vertices(flow_mesh())));
    result.triangles.resize(3, Eigen::Index(num_faces(flow_mesh())));
    std::vector<int> index;
    int count = 0;
    for (auto v : vertices(flow_mesh())) {
      index.resize(std::max(index.size(), v->id() + 1));
      index[v->id()] = count;
      result.points.col(count++) = to_point(v->point());
    }
    Eigen::Index t = 0;
    for (auto f : faces(flow_mesh())) {
      int k = 0;
      for (auto v : CGAL::vertices_around_face(halfedge(f, flow_mesh()), flow_mesh()))
        result.triangles(k++, t) = index[v->id()];
      ++t;
    }
    return result;
  }

  const Flow_mesh& flow_mesh() const { return flow_.meso_skeleton(); }

  int most_iterations_;
  const Deadline* deadline_;
  Flow flow_;
  double original_area_, original_volume_;
  Part_mesh mesh_; // the mesh contracted so far
  double area_, volume_;
  int iterations_ = 0;
  bool converged_ = false;
};

Stepwise_flow::Stepwise_flow(const Part_mesh& mesh, int iterations, const Deadline& deadline)
    : state_(std::make_unique<State>(mesh, iterations, deadline))
{}

Stepwise_flow::~Stepwise_flow() = default;

void Stepwise_flow::set_weights(const Flow_weights& weights) { state_->set_weights(weights); }

void Stepwise_flow::run_to_volume(double fraction)
{
  while (!state_->converged() && state_->volume_kept() > fraction)
    state_->step();
}

void Stepwise_flow::run_to_convergence()
{
  while (!state_->converged())
    state_->step();
}

int Stepwise_flow::iterations() const { return state_->iterations(); }

double Stepwise_flow::area_kept() const { return state_->area_kept(); }

Part_mesh Stepwise_flow::meso_skeleton() const { return state_->mesh(); }

Spatial_graph Stepwise_flow::curve_skeleton() { return state_->curve_skeleton(); }

} // namespace CGAL::Shape_correspondence::internal
