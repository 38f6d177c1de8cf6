// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "base/quantized.h"
#include "io/read/read_objects.h"
#include "roles/Shape_roles.h"
#include "roles/up_by_roles.h"
#include "shape/has_area.h"
#include "shape/split_patches.h"
#include "structure/outline_graph.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <string>
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

std::vector<std::size_t> parts_of_patches(const Surface_patches& surface, const std::vector<Part_node>& nodes,
                                          const std::vector<std::size_t>& cut)
{
  std::vector<std::size_t> result(surface.patches.size(), 0);
  for (std::size_t i = 0; i < cut.size(); ++i)
    for (std::size_t patch : nodes[cut[i]].patches)
      result[patch] = i;
  return result;
}

/// The category that the parts are most like, whether clearly or not; null if no parts of it were learned.
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

/// The parts alone, for their roles.
Segmented_shape shape_of_patches(const Segmented_shape& objects, const Surface_patches& surface,
                                 const std::vector<std::size_t>& part_of_patch)
{
  std::map<std::size_t, std::vector<Point>> corners; // by part, three of a triangle
  for (std::size_t i = 0; i < objects.parts().size(); ++i) {
    const Part_mesh& mesh = objects.parts()[i].mesh;
    for (std::size_t t = 0; t < surface.of_triangles[i].size(); ++t)
      for (int k = 0; k < 3; ++k)
        corners[part_of_patch[surface.of_triangles[i][t]]].push_back(
            mesh.points.col(mesh.triangles(k, Eigen::Index(t))));
  }
  Segmented_shape result(objects.name(), objects.up());
  for (const auto& [part, points] : corners) {
    Part_mesh mesh;
    mesh.points.resize(3, Eigen::Index(points.size()));
    for (std::size_t v = 0; v < points.size(); ++v)
      mesh.points.col(Eigen::Index(v)) = points[v];
    mesh.triangles.resize(3, Eigen::Index(points.size() / 3));
    std::iota(mesh.triangles.data(), mesh.triangles.data() + mesh.triangles.size(), 0);
    if (internal::has_area(mesh)) result.add_part(std::to_string(part), std::move(mesh));
  }
  return result;
}

/// Finds parts: first whatever the category, then of the category that those are most like.
std::optional<Part_split> find_parts(const Segmented_shape& objects, const std::vector<std::vector<int>>& materials,
                                     const Role_model& roles)
{
  const Part_model& model = *internal::Role_model_access::data(roles).parts;
  const Surface_patches surface = internal::patches_of_objects(objects, materials);
  if (surface.patches.size() > internal::most_patches) return std::nullopt;
  const std::vector<Part_node> nodes = internal::part_candidates(surface, model);
  std::vector<std::size_t> cut = internal::likeliest_parts(surface, nodes, model, nullptr);
  if (cut.size() < 2 || cut.size() > internal::most_parts) return std::nullopt;
  const Segmented_shape any = shape_of_patches(objects, surface, parts_of_patches(surface, nodes, cut));
  if (const Part_model::Category* category = category_of(any, roles)) {
    std::vector<std::size_t> known = internal::likeliest_parts(surface, nodes, model, category);
    if (known.size() > 1) cut = std::move(known);
  }
  Part_split split = internal::split_patches(objects, surface, materials, parts_of_patches(surface, nodes, cut));
  if (!may_be_matched(split)) return std::nullopt;
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
