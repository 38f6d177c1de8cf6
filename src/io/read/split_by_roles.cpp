// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "base/quantized.h"
#include "io/read/read_objects.h"
#include "roles/Shape_roles.h"
#include "roles/up_by_roles.h"
#include "shape/meshes.h"
#include "shape/split_patches.h"
#include "structure/outline_graph.h"

#include <algorithm>
#include <optional>
#include <utility>
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

using internal::Part_model;
using internal::Part_node;
using internal::Surface_patches;

constexpr std::size_t most_patches = 3000; // of which parts are looked for

std::vector<std::size_t> parts_of_patches(const Surface_patches& surface, const std::vector<Part_node>& nodes,
                                          const std::vector<std::size_t>& cut)
{
  std::vector<std::size_t> result(surface.patches.size(), 0);
  for (std::size_t i = 0; i < cut.size(); ++i)
    for (std::size_t patch : nodes[cut[i]].patches)
      result[patch] = i;
  return result;
}

/// The nearest category of the shape with these parts; null if it is not clear.
const Part_model::Category* category_of(const Segmented_shape& parts, const Role_model& roles)
{
  const internal::Role_model_data& data = internal::Role_model_access::data(roles);
  const internal::Shape_roles shape(internal::outline_graph(parts), roles);
  const std::size_t nearest = internal::category_of_pair(shape, shape, data).nearest;
  if (nearest == data.categories.size()) return nullptr;
  for (const Part_model::Category& category : data.parts->categories)
    if (category.name == data.categories[nearest].name) return &category;
  return nullptr;
}

/// Finds parts: first whatever the category, then of the category that those are most like.
std::optional<Part_split> find_parts(const Segmented_shape& objects, const std::vector<std::vector<int>>& materials,
                                     const Role_model& roles)
{
  const Part_model& model = *internal::Role_model_access::data(roles).parts;
  const Surface_patches surface = internal::patches_of_objects(objects, materials);
  if (surface.patches.size() > most_patches) return std::nullopt;
  const std::vector<Part_node> nodes = internal::part_candidates(surface, model);
  const auto split_at = [&](const std::vector<std::size_t>& cut) {
    return internal::split_patches(objects, surface, materials, parts_of_patches(surface, nodes, cut));
  };
  const std::vector<std::size_t> any = internal::likeliest_parts(surface, nodes, model, nullptr);
  Part_split split = split_at(any);
  if (!may_be_matched(split)) return std::nullopt;
  if (const Part_model::Category* category = category_of(split.shape, roles)) {
    const std::vector<std::size_t> cut = internal::likeliest_parts(surface, nodes, model, category);
    if (cut.size() > 1 && cut != any) split = split_at(cut);
  }
  return split;
}

} // namespace

Part_split split_parts_by_roles(const Segmented_shape& objects, const Part_splitting_options& options,
                                const Role_model* roles)
{
  Part_splitting_options whole = options;
  whole.divide_by_materials = false;
  Part_split split = split_parts(objects, whole);
  if (options.mode != Part_splitting::AUTO || !roles) return split;
  const bool are_parts = objects.parts().size() > 1 && !split.changes_objects();
  const bool finds = internal::Role_model_access::data(*roles).parts != nullptr;
  if (finds && !are_parts)
    if (std::optional<Part_split> found = find_parts(objects, {}, *roles)) split = std::move(*found);
  if (options.materials.empty()) return split;
  std::optional<Part_split> divided;
  if (finds) divided = find_parts(objects, options.materials, *roles);
  if (!divided) divided = split_parts(objects, options);
  if (!may_be_matched(split) || !may_be_matched(*divided) || are_same_parts(split, *divided)) return split;
  const auto distance = [&](const Part_split& parts) {
    return internal::quantized(internal::distance_of_nearest_category(internal::outline_graph(parts.shape), *roles));
  };
  return distance(*divided) < distance(split) ? *divided : split;
}

} // namespace CGAL::Shape_correspondence::IO
