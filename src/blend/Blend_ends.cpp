// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_ends.h"

#include "blend/surface_components.h"

#include <algorithm>
#include <limits>

namespace CGAL::Shape_correspondence::internal {
namespace {

bool is_mirrored_in_x(const Blend_input& input)
{
  const Shape_frame& frame = structure(input.graph).frame;
  return input.quarter_turns % 2 == 0 ? frame.mirror_x : frame.mirror_z;
}

} // namespace

Blend_ends::Blend_ends(const std::array<Blend_input, 2>& inputs)
{
  for (std::size_t end : {0u, 1u}) {
    add(inputs[end], end);
    are_symmetric = are_symmetric && is_mirrored_in_x(inputs[end]);
  }
  if (!are_symmetric) return;
  for (std::size_t end : {0u, 1u}) {
    images[end] = Mirror_images(meshes[end]);
    mirror_charts(meshes[end], images[end], charted[end].charts);
  }
}

void Blend_ends::add(const Blend_input& input, std::size_t end)
{
  std::vector<const Points*> surfaces;
  for (const Shape_part& part : input.shape.parts())
    surfaces.push_back(&part.mesh.points);
  charted[end] = charted_shape(input.graph, input.quarter_turns, surfaces);
  ground[end] = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const Points& points = charted[end].surfaces[i];
    meshes[end].push_back({points, input.shape.parts()[i].mesh.triangles});
    ground[end] = std::min(ground[end], points.row(1).minCoeff());
  }
  widest_gap[end] = internal::widest_gap(trees_of(meshes[end]));
}

} // namespace CGAL::Shape_correspondence::internal
