// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_structure.h"
#include "base/quarter_turn.h"
#include "blend/Blend_ends.h"
#include "blend/surface_components.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <Eigen/Geometry>

#include <cmath>
#include <utility>

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
                                 const Blend_options& options)
    : Blend_structure(inputs, Blend_ends(inputs), correspondence, options)
{}

Blend_structure::Blend_structure(const std::array<Blend_input, 2>& inputs, const Blend_ends& ends,
                                 const Correspondence& correspondence, const Blend_options& options)
    : shapes{inputs[0].shape, inputs[1].shape},
      parts(matched_parts(ends, correspondence)),
      is_symmetric(ends.are_symmetric),
      end_asymmetry{0, 0},
      ground(ends.ground),
      widest_gap(ends.widest_gap)
{
  add_unmatched_parts(inputs, ends, parts);
  contacts = contact_constraints(inputs, ends, parts, options.contact_tolerance);
  for (std::size_t end : {0u, 1u}) {
    looks.emplace_back(parts, int(end));
    frames_[end] = structure(inputs[end].graph).frame;
    frames_[end].axes = frames_[end].axes * quarter_turn(inputs[end].quarter_turns).transpose();
    if (is_symmetric) end_asymmetry[end] = end_asymmetry_of(ends.meshes[end]);
  }
  set_size(options.size);
}

/// Scales shapes about the origin of space, as if they were given in other units.
void Blend_structure::set_size(Blend_size size)
{
  if (size == Blend_size::BLEND) return;
  const std::array<double, 2> given = {frames_[0].height, frames_[1].height};
  for (std::size_t end : {0u, 1u}) {
    const double height = size == Blend_size::SAME ? 1 : given[size == Blend_size::SOURCE ? 0 : 1];
    const double scale = height / given[end];
    if (scale == 1) continue;
    frames_[end].height = height;
    frames_[end].origin *= scale;
    Segmented_shape scaled(shapes[end].name(), shapes[end].up());
    for (const Shape_part& part : shapes[end].parts())
      scaled.add_part(part.name, {scale * part.mesh.points, part.mesh.triangles});
    shapes[end] = std::move(scaled);
  }
}

Points Blend_structure::to_world(const Points& points, double t) const
{
  const Eigen::Quaterniond from(frames_[0].axes), to(frames_[1].axes);
  const Eigen::Matrix3d axes = from.slerp(t, to).toRotationMatrix();
  const double from_height = frames_[0].height, to_height = frames_[1].height;
  const double height = std::pow(from_height, 1 - t) * std::pow(to_height, t);
  constexpr double alike = 1e-6; // of the heights: their difference is no divisor
  const double grown = to_height - from_height;
  const double share = std::abs(grown) > alike * to_height ? (height - from_height) / grown : t;
  const Point origin = (1 - share) * frames_[0].origin + share * frames_[1].origin;
  return (axes * height * points).colwise() + origin;
}

Point Blend_structure::up(double t) const
{
  const Point between = (1 - t) * shapes[0].up() + t * shapes[1].up();
  return unit_or(between, shapes[0].up());
}

} // namespace CGAL::Shape_correspondence::internal
