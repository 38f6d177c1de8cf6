// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "base/quantized.h"
#include "io/read/read_objects.h"
#include "roles/Shape_roles.h"
#include "roles/up_by_roles.h"
#include "shape/Shape_in_frame.h"
#include "shape/split_patches.h"
#include "structure/outline_graph.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <set>
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

/// A graph of parts (`best_cut()`) to predict their roles: their surfaces, and which of them touch.
/// \param cut indices of the nodes that are parts
Structural_graph graph_of_cut(const Surface_patches& surface, const std::vector<Part_node>& nodes,
                              const std::vector<std::size_t>& cut)
{
  constexpr std::size_t none = Part_node::none;
  std::vector<std::size_t> part_of_patch(surface.patches.size(), none);
  Segmented_shape shape("");
  std::vector<const Part_mesh*> meshes;
  for (std::size_t i : cut) {
    std::vector<Point> corners;
    for (std::size_t patch : nodes[i].patches)
      for (const std::array<Point, 3>& triangle : surface.patches[patch].triangles)
        corners.insert(corners.end(), triangle.begin(), triangle.end());
    if (corners.empty()) continue;
    for (std::size_t patch : nodes[i].patches)
      part_of_patch[patch] = shape.parts().size();
    Part_mesh mesh;
    mesh.points = Eigen::Map<const Points>(corners[0].data(), 3, Eigen::Index(corners.size()));
    mesh.triangles.resize(3, Eigen::Index(corners.size() / 3));
    std::iota(mesh.triangles.data(), mesh.triangles.data() + mesh.triangles.size(), 0);
    shape.add_part(std::to_string(shape.parts().size()), std::move(mesh));
  }
  for (const Shape_part& part : shape.parts())
    meshes.push_back(&part.mesh);
  constexpr double touching_gap = 0.01; // largest gap between samples of touching parts, over the diagonal
  std::set<std::array<std::size_t, 2>> touching;
  for (const Surface_patches::Contact& contact : surface.contacts) {
    const auto [i, j] = std::minmax(part_of_patch[contact.first], part_of_patch[contact.second]);
    if (i != j && j != none && contact.contact.gap <= touching_gap) touching.insert({i, j});
  }
  return internal::outline_graph(shape, internal::rough_frame(meshes, Point::UnitY()), touching);
}

/// What the model has learned of the category with a name; null if it does not know this category.
const Part_model::Category* category_named(const std::string& name, const Part_model& model)
{
  const auto is_it = [&](const Part_model::Category& category) { return category.name == name; };
  const auto found = std::find_if(model.categories.begin(), model.categories.end(), is_it);
  return found == model.categories.end() ? nullptr : &*found;
}

/// A text with the number of parts of each role, and of the pieces that they are made of.
std::string in_words(const std::string& category, const std::vector<Part_label>& labels,
                     const std::vector<Part_node>& nodes, const std::vector<std::size_t>& cut)
{
  std::map<std::string, std::array<std::size_t, 2>> counts; // parts and pieces, by role
  for (std::size_t i = 0; i < std::min(labels.size(), cut.size()); ++i) {
    ++counts[labels[i].coarse][0];
    counts[labels[i].coarse][1] += nodes[cut[i]].sheets.size();
  }
  std::string result;
  for (const auto& [role, count] : counts)
    result += (result.empty() ? category + ", with " : ", ") + std::to_string(count[0]) + " × " + role + " from " +
              std::to_string(count[1]) + (count[1] == 1 ? " piece" : " pieces");
  return result;
}

/// Finds parts by the model of all categories, then by that of the category that these parts resemble most.
std::optional<Part_split> find_parts(const Segmented_shape& objects, const std::vector<std::vector<int>>& materials,
                                     const Role_model& roles)
{
  const internal::Role_model_data& data = internal::Role_model_access::data(roles);
  const Part_model& model = *data.parts;
  const Surface_patches surface = internal::patches_of_objects(objects, materials);
  if (surface.patches.size() > internal::most_patches) return std::nullopt;
  const std::vector<Part_node> nodes = internal::part_candidates(surface, model);
  std::vector<std::size_t> cut = internal::likeliest_parts(surface, nodes, model, nullptr);
  if (cut.size() < 2 || cut.size() > internal::most_parts) return std::nullopt;
  const internal::Shape_roles seen(graph_of_cut(surface, nodes, cut), roles);
  const internal::Pair_category likest = internal::category_of_pair(seen, seen, data);
  if (likest.nearest < data.categories.size())
    if (const Part_model::Category* category = category_named(data.categories[likest.nearest].name, model)) {
      std::vector<std::size_t> known = internal::likeliest_parts(surface, nodes, model, category);
      if (known.size() > 1) cut = std::move(known);
    }
  Part_split split = internal::split_patches(objects, surface, materials, nodes, cut);
  if (!may_be_matched(split)) return std::nullopt;
  if (likest.index < data.categories.size()) { // the category is clear
    const internal::Shape_roles of_cut(graph_of_cut(surface, nodes, cut), roles);
    split.found_roles = in_words(data.categories[likest.index].name, of_cut.votes(likest.index).labels, nodes, cut);
  }
  return split;
}

} // namespace

Part_split split_parts_by_roles(const Segmented_shape& objects, const Part_splitting_options& options,
                                const Role_model* roles)
{
  Part_splitting_options whole = options;
  whole.divide_by_materials = false;
  if (options.mode != Part_splitting::AUTO || !roles) return split_parts(objects, whole);
  const bool finds = internal::Role_model_access::data(*roles).parts != nullptr, is_one = objects.parts().size() == 1;
  std::optional<Part_split> found;
  if (finds && is_one) found = find_parts(objects, {}, *roles);
  Part_split split = found ? std::move(*found) : split_parts(objects, whole);
  if (finds && !is_one && split.changes_objects()) {
    found = find_parts(objects, {}, *roles);
    if (found) split = std::move(*found);
  }
  if (options.materials.empty()) return split;
  std::optional<Part_split> divided;
  if (finds) divided = find_parts(objects, options.materials, *roles);
  if (!divided) divided = split_parts(objects, options);
  if (!may_be_matched(split) || !may_be_matched(*divided) || are_same_parts(split, *divided)) return split;
  const auto distance = [&](const Part_split& parts) {
    return internal::distance_of_nearest_category(internal::outline_graph(parts.shape), *roles);
  };
  const double least_gain = Role_options().clearly_better;
  const bool is_better =
      internal::quantized(distance(*divided)) < internal::quantized((1 - least_gain) * distance(split));
  return is_better ? *divided : split;
}

} // namespace CGAL::Shape_correspondence::IO
