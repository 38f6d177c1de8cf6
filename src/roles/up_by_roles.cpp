// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "roles/up_by_roles.h"
#include "base/quantized.h"
#include "roles/Shape_roles.h"

#include <algorithm>
#include <limits>

namespace CGAL::Shape_correspondence::internal {

double distance_of_nearest_category(const Structural_graph& graph, const Role_model& model)
{
  const Shape_roles roles(graph, model);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t category = 0; category < Role_model_access::data(model).categories.size(); ++category)
    least = std::min(least, roles.distance(category));
  return least;
}

Up_by_roles up_by_roles(const Structural_graph& graph, const std::array<Shape_frame, 3>& frames,
                        const Role_model& model, const Role_options& options)
{
  Up_by_roles result;
  if (Role_model_access::data(model).categories.empty()) return result;
  std::array<double, 3> distances;
  Structural_graph turned = graph;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    structure(turned).frame = frames[axis];
    distances[axis] = distance_of_nearest_category(turned, model);
  }
  for (std::size_t axis : {2u, 0u}) // y stays unless another axis is nearer
    if (quantized(distances[axis]) < quantized(distances[result.axis])) result.axis = axis;
  double second = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (axis != result.axis) second = std::min(second, distances[axis]);
  result.is_nearer = quantized(distances[result.axis]) <= quantized((1 - options.clearly_better) * second);
  result.is_clear = quantized(distances[result.axis]) <= quantized(options.category_ratio * second);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
