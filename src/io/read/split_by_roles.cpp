// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "base/quantized.h"
#include "io/read/read_objects.h"
#include "roles/up_by_roles.h"
#include "structure/outline_graph.h"

#include <algorithm>
#include <vector>

namespace CGAL::Shape_correspondence::IO {
namespace {

bool are_same_parts(const Part_split& a, const Part_split& b)
{
  const auto triangles = [](const Part_split& split) {
    std::vector<Eigen::Index> result;
    for (const Shape_part& part : split.shape.parts())
      result.push_back(part.mesh.triangles.cols());
    std::sort(result.begin(), result.end());
    return result;
  };
  return triangles(a) == triangles(b);
}

bool may_be_matched(const Part_split& split)
{
  const std::size_t parts = split.shape.parts().size();
  return parts > 1 && parts <= internal::most_parts;
}

} // namespace

Part_split split_parts_by_roles(const Segmented_shape& objects, const Part_splitting_options& options,
                                const Role_model* roles)
{
  Part_splitting_options whole = options;
  whole.divide_by_materials = false;
  Part_split split = split_parts(objects, whole);
  if (options.mode != Part_splitting::AUTO || options.materials.empty() || !roles) return split;
  Part_split divided = split_parts(objects, options);
  if (!may_be_matched(split) || !may_be_matched(divided) || are_same_parts(split, divided)) return split;
  const auto distance = [&](const Part_split& parts) {
    return internal::quantized(internal::distance_of_nearest_category(internal::outline_graph(parts.shape), *roles));
  };
  return distance(divided) < distance(split) ? divided : split;
}

} // namespace CGAL::Shape_correspondence::IO
