// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_structure.h"

#include "blend/surface_components.h"

#include <cmath>

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
    : Blend_structure(inputs, Blend_stage(inputs), correspondence, options)
{}

Blend_structure::Blend_structure(const std::array<Blend_input, 2>& inputs, const Blend_stage& stage,
                                 const Correspondence& correspondence, const Blend_options& options)
    : shapes(stage.moved_shapes(inputs, options.size)),
      parts(blend_parts(stage, correspondence)),
      is_symmetric(stage.are_symmetric),
      boxes(stage.boxes),
      widest_gap(stage.widest_gap),
      axes_(structure(inputs[0].graph).frame.axes),
      heights_(stage.heights(options.size))
{
  contacts = contacts_to_keep(stage, parts, options.contact_tolerance);
  for (std::size_t end : {0u, 1u}) {
    looks.emplace_back(parts, int(end));
    if (is_symmetric) end_asymmetry[end] = end_asymmetry_of(stage.meshes[end]);
  }
}

Points Blend_structure::to_world(const Points& points, double done) const
{
  return axes_ * (std::pow(heights_[0], 1 - done) * std::pow(heights_[1], done)) * points;
}

} // namespace CGAL::Shape_correspondence::internal
