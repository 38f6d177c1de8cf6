// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/skeletonize.h"
#include "abstraction/contraction.h"
#include "abstraction/reproducible_flow.h"
#include "abstraction/surface_samples.h"
#include "shape/meshes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
class Stepwise_flow::State
{
public:
  /// \param poles of the vertices; null: as CGAL finds them
  State(const Part_mesh& mesh, const Points* poles, int iterations, const Deadline& deadline)
      : has_poles_(poles != nullptr),
        most_iterations_(iterations),
        deadline_(&deadline),
        flow_(to_halfedge_mesh(mesh)),
        original_vertices_(std::size_t(mesh.points.cols())),
        original_area_(surface_area(mesh)),
        original_volume_(enclosed_volume(mesh)),
        mesh_(mesh_of_flow()),
        area_(original_area_),
        volume_(original_volume_)
  {
    if (has_poles_) {
      for (auto v : vertices(flow_mesh()))
        v->pole = to_mesh_point(poles->col(Eigen::Index(v->vertices.front().idx())));
    }
  }

  void step()
  {
    if (iterations_ == most_iterations_) throw Flow_failure("the flow needs more iterations than allowed");
    ++iterations_;
    if (has_poles_)
      contract_to_poles();
    else
      flow_.contract_geometry();
    deadline_->check();
    flow_.collapse_edges();
    deadline_->check();
    flow_.split_faces();
    deadline_->check();
    flow_.detect_degeneracies();
    if (flow_mesh().size_of_vertices() < 4) throw Flow_failure("the flow collapses the part to a point");
    // As in the library's own convergence test
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
    weights_ = weights;
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
    result.points.resize(3, Eigen::Index(flow_mesh().size_of_vertices()));
    result.triangles.resize(3, Eigen::Index(flow_mesh().size_of_facets()));
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

  /// Its descriptors, like those of every face graph of CGAL, give access to what they describe, so that vertices can
  /// be moved between the steps of the flow.
  const Flow_mesh& flow_mesh() const { return flow_.meso_skeleton(); }

  Contracting_mesh contracting_mesh() const
  {
    Contracting_mesh result;
    result.mesh = mesh_;
    result.poles.setConstant(3, result.mesh.points.cols(), std::numeric_limits<double>::quiet_NaN());
    Eigen::Index i = 0;
    for (auto v : vertices(flow_mesh())) {
      result.fixed.push_back(v->is_fixed);
      // Vertices that splits have made have no pole.
      if (v->id() < original_vertices_) result.poles.col(i) = to_point(v->pole);
      ++i;
    }
    return result;
  }

  void contract_to_poles()
  {
    const Points moved = contracted(contracting_mesh(), weights_);
    Eigen::Index i = 0;
    for (auto v : vertices(flow_mesh()))
      v->point() = to_mesh_point(moved.col(i++));
  }

  bool has_poles_;
  int most_iterations_;
  const Deadline* deadline_;
  Flow flow_;
  Flow_weights weights_;
  std::size_t original_vertices_;
  double original_area_, original_volume_;
  Part_mesh mesh_; // what the flow has made of the mesh
  double area_, volume_;
  int iterations_ = 0;
  bool converged_ = false;
};

Stepwise_flow::Stepwise_flow(const Part_mesh& mesh, int iterations, const Deadline& deadline)
    : state_(std::make_unique<State>(mesh, nullptr, iterations, deadline))
{}

Stepwise_flow::Stepwise_flow(const Part_mesh& mesh, const Points& poles, int iterations, const Deadline& deadline)
    : state_(std::make_unique<State>(mesh, &poles, iterations, deadline))
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
