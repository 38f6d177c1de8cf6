// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/directions.h"
#include "base/for_each_index.h"
#include "base/limits.h"
#include "io/write/pictures.h"
#include "shape/oriented_box.h"

#include <CGAL/Shape_correspondence/IO/write_blend.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr double hold_seconds = 0.5, motion_seconds = 2; // time for which each end is shown; time between the ends

double seconds_at(double t) { return hold_seconds + t * motion_seconds; }

/// Paints corresponding parts in the same colour.
class Match_painter : public Blend_painter
{
public:
  Match_painter(Glb_file& glb, const Shape_blend& blend, const Correspondence& correspondence)
      : surfaces_(blend.surfaces()),
        points_(blend.points(0)),
        sources_(blend(0).parts().size()),
        materials_(add_match_materials(glb, correspondence, sources_, blend(1).parts().size()))
  {}

  std::vector<Drawn_mesh> end(std::size_t side, std::size_t part, const Drawn_mesh& mesh) override
  {
    Drawn_mesh result = mesh;
    result.material = materials_[side == 0 ? part : sources_ + part];
    return {std::move(result)};
  }

  std::vector<double> changes(std::size_t) const override { return {}; }

  std::vector<Painted_mesh> surface(std::size_t surface, double) override
  {
    const Blend_task& task = surfaces_[surface].task;
    Painted_mesh result;
    result.mesh.triangles = surfaces_[surface].triangles;
    result.mesh.material = materials_[task.source != Blend_task::no_part ? task.source : sources_ + task.target];
    result.points.resize(std::size_t(points_[surface].cols()));
    std::iota(result.points.begin(), result.points.end(), 0);
    return {std::move(result)};
  }

private:
  std::vector<Blend_surface> surfaces_;
  std::vector<Points> points_;
  std::size_t sources_;
  std::vector<int> materials_;
};

Json parts_of(std::size_t source, std::size_t target)
{
  Json parts = Json::array();
  for (std::size_t part : {source, target})
    parts.push_back(part == Blend_task::no_part ? -1 : int(part));
  return {{"parts", parts}};
}

/// The rotation of a blend to the axes of glTF, in which y is up.
Eigen::Matrix3d turn_of(const Shape_blend& blend)
{
  return internal::least_rotation(blend(0).up(), Point::UnitY()).toRotationMatrix();
}

int add_end(Glb_file& glb, const Shape_blend& blend, std::size_t side, Blend_painter& painter)
{
  const Segmented_shape shape = blend(double(side));
  const Eigen::Matrix3d turn = turn_of(blend);
  std::vector<int> nodes;
  for (std::size_t part = 0; part < shape.parts().size(); ++part) {
    const Part_mesh& mesh = shape.parts()[part].mesh;
    nodes.push_back(
        glb.add_node(shape.parts()[part].name, painter.end(side, part, shaded(turn * mesh.points, mesh.triangles))));
    const std::size_t none = Blend_task::no_part;
    glb.set_node_extras(nodes.back(), side == 0 ? parts_of(part, none) : parts_of(none, part));
  }
  return glb.add_node(shape.name(), nodes, Point::Zero());
}

/// Largest deviation of an animation's points, over the diagonal of the shapes' bounding box.
constexpr double animation_tolerance = 2e-3;

/// A motion of points, represented by few morph targets with weights over time: its principal components.
struct Motion
{
  std::vector<Points> targets; ///< differences to the first points
  Eigen::MatrixXf weights;     ///< weight of each target (row) at each time (column)
};

/// The principal components of the motion of points. \param points positions at each time
/// \param distance largest displacement that dropped components may cause
Motion principal_motion(const std::vector<const Points*>& points, double distance)
{
  const auto number = Eigen::Index(points.size()), size = points[0]->size();
  Eigen::MatrixXd rest(size, number);
  for (Eigen::Index i = 0; i < number; ++i)
    rest.col(i) = (*points[std::size_t(i)] - *points[0]).reshaped();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> components(rest.transpose().lazyProduct(rest));
  Motion result;
  result.weights.resize(number, number);
  const auto is_far = [&] { return rest.reshaped(3, size / 3 * number).colwise().norm().maxCoeff() > distance; };
  Eigen::Index used = 0;
  for (; used < number && is_far(); ++used) {
    const Eigen::VectorXd weights = components.eigenvectors().col(number - 1 - used);
    const Eigen::VectorXd target = rest * weights;
    rest -= target * weights.transpose();
    result.targets.emplace_back(target.reshaped(3, size / 3));
    result.weights.row(used) = weights.transpose().cast<float>();
  }
  result.weights.conservativeResize(used, number);
  return result;
}

/// Adds a surface for a time of constant appearance. \param points its points \param targets their morph targets
int add_surface(Glb_file& glb, const Eigen::Matrix3d& turn, const Blend_surface& surface,
                std::vector<Blend_painter::Painted_mesh> painted, const Points& points,
                const std::vector<Points>& targets = {})
{
  std::vector<Drawn_mesh> meshes;
  for (Blend_painter::Painted_mesh& some : painted) {
    some.mesh.points = turn * points(Eigen::indexing::all, some.points);
    for (const Points& target : targets)
      some.mesh.morphs.emplace_back(turn * target(Eigen::indexing::all, some.points));
    meshes.push_back(std::move(some.mesh));
  }
  return glb.add_node(surface.name, meshes);
}

} // namespace

void write_blend_animation(std::ostream& out, const Shape_blend& blend, int frames, Glb_file& glb,
                           Blend_painter& painter)
{
  internal::check_number_of_frames(frames);
  const Eigen::Matrix3d turn = turn_of(blend);
  std::vector<int> roots = {add_end(glb, blend, 0, painter)};
  glb.animate_visibility(roots[0], 0, hold_seconds);
  const auto diagonal = [&](double end) { return internal::diagonal(internal::all_vertices(blend(end))); };
  const double distance = animation_tolerance * std::max(diagonal(0), diagonal(1));
  const std::vector<Blend_surface> surfaces = blend.surfaces();
  std::vector<std::vector<Points>> points(static_cast<std::size_t>(frames)); // indexed by frame and surface
  internal::for_each_index<CGAL::Parallel_if_available_tag>(
      points.size(), [&](std::size_t frame) { points[frame] = blend.points(double(frame) / (frames - 1)); });
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    std::vector<double> times{surfaces[s].begin};
    for (double change : painter.changes(s))
      if (change > times.back() && change < surfaces[s].end) times.push_back(change);
    times.push_back(surfaces[s].end);
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      if (times[i] >= times[i + 1]) continue;
      // Includes one frame before and one after those in which the surface is present
      const int first = int(std::floor(times[i] * (frames - 1))), last = int(std::ceil(times[i + 1] * (frames - 1)));
      std::vector<double> seconds;
      std::vector<const Points*> moving;
      for (int frame = first; frame <= last; ++frame) {
        seconds.push_back(seconds_at(double(frame) / (frames - 1)));
        moving.push_back(&points[std::size_t(frame)][s]);
      }
      const Motion motion = principal_motion(moving, distance);
      roots.push_back(add_surface(glb, turn, surfaces[s], painter.surface(s, (times[i] + times[i + 1]) / 2), *moving[0],
                                  motion.targets));
      glb.animate_morphs(roots.back(), seconds, motion.weights);
      glb.animate_visibility(roots.back(), seconds_at(times[i]), seconds_at(times[i + 1]));
      glb.set_node_extras(roots.back(), parts_of(surfaces[s].task.source, surfaces[s].task.target));
    }
  }
  roots.push_back(add_end(glb, blend, 1, painter));
  glb.animate_visibility(roots.back(), seconds_at(1), seconds_at(1) + hold_seconds);
  glb.set_animation_extras({{"begin", seconds_at(0)}, {"end", seconds_at(1)}});
  glb.write(out, {{"blend", roots}});
}

void write_blend_frame(std::ostream& out, const Shape_blend& blend, double t, Glb_file& glb, Blend_painter& painter)
{
  if (t <= 0 || t >= 1) {
    const std::size_t side = t <= 0 ? 0 : 1;
    return glb.write(out, {{"blend", {add_end(glb, blend, side, painter)}}});
  }
  const std::vector<Blend_surface> surfaces = blend.surfaces();
  const std::vector<Points> points = blend.points(t);
  const Eigen::Matrix3d turn = turn_of(blend);
  std::vector<int> nodes;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const bool is_nothing = surfaces[s].task.type == Blend_task_type::GROW && t == surfaces[s].begin;
    if (t < surfaces[s].begin || t >= surfaces[s].end || is_nothing) continue;
    nodes.push_back(add_surface(glb, turn, surfaces[s], painter.surface(s, t), points[s]));
    glb.set_node_extras(nodes.back(), parts_of(surfaces[s].task.source, surfaces[s].task.target));
  }
  glb.write(out, {{"blend", {glb.add_node("blend", nodes, Point::Zero())}}});
}

void write_blend_glb(std::ostream& out, const Shape_blend& blend, const Correspondence& correspondence, int frames)
{
  Glb_file glb;
  Match_painter painter(glb, blend, correspondence);
  write_blend_animation(out, blend, frames, glb, painter);
}

} // namespace CGAL::Shape_correspondence::IO
