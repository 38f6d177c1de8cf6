// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_structure.h"
#include "base/quarter_turn.h"
#include "blend/Blend_ends.h"
#include "blend/surface_components.h"

#include <Eigen/Geometry>

namespace CGAL::Shape_correspondence::internal {
namespace {

double end_asymmetry_of(const std::vector<Part_mesh>& meshes)
{
  std::vector<const Points*> surfaces;
  for (const Part_mesh& mesh : meshes)
    surfaces.push_back(&mesh.points);
  const std::vector<contacts::Triangle_tree> trees = trees_of(meshes);
  return mirror_residual(surfaces, {trees.begin(), trees.end()});
}

} // namespace

Blend_structure::Blend_structure(const std::array<Blend_input, 2>& inputs, const Correspondence& correspondence,
                                 double contact_tolerance)
    : Blend_structure(inputs, Blend_ends(inputs), correspondence, contact_tolerance)
{}

Blend_structure::Blend_structure(const std::array<Blend_input, 2>& inputs, const Blend_ends& ends,
                                 const Correspondence& correspondence, double contact_tolerance)
    : shapes{inputs[0].shape, inputs[1].shape},
      parts(matched_parts(ends, correspondence)),
      is_symmetric(ends.are_symmetric),
      end_asymmetry{0, 0},
      ground(ends.ground),
      widest_gap(ends.widest_gap)
{
  add_unmatched_parts(inputs, ends, parts);
  contacts = contact_constraints(inputs, ends, parts, contact_tolerance);
  for (std::size_t end : {0u, 1u}) {
    frames_[end] = structure(inputs[end].graph).frame;
    frames_[end].axes = frames_[end].axes * quarter_turn(inputs[end].quarter_turns).transpose();
    if (is_symmetric) end_asymmetry[end] = end_asymmetry_of(ends.meshes[end]);
  }
}

Points Blend_structure::to_world(const Points& points, double t) const
{
  const Eigen::Quaterniond from(frames_[0].axes), to(frames_[1].axes);
  const Eigen::Matrix3d axes = from.slerp(t, to).toRotationMatrix();
  const double height = (1 - t) * frames_[0].height + t * frames_[1].height;
  const Point origin = (1 - t) * frames_[0].origin + t * frames_[1].origin;
  return (axes * height * points).colwise() + origin;
}

Point Blend_structure::up(double t) const
{
  const Point between = (1 - t) * shapes[0].up() + t * shapes[1].up();
  return unit_or(between, shapes[0].up());
}

} // namespace CGAL::Shape_correspondence::internal
