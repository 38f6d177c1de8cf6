// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/documents/collection_json.h"
#include "io/system/colours.h"
#include "io/write/part_labels.h"
#include "io/write/pictures.h"
#include "viewer/pages.h"

#include <CGAL/Shape_correspondence/IO/write_collection_html.h>
#include <CGAL/Shape_correspondence/correspondence_blocks.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <sstream>

namespace CGAL::Shape_correspondence::IO {
namespace {

using Models = std::function<std::optional<Segmented_shape>(std::size_t)>;

// Limit for the triangles of all shapes, which share it equally, and the least share of a shape
constexpr std::size_t collection_triangles = 400000, fewest_of_shape = 400;
constexpr std::size_t most_fine = 50; // shapes up to which curves and sheets are drawn as finely as for one pair

/// The GLB of the shapes: simplified surfaces, or else curves and sheets; parts have the colours of their clusters.
class Collection_models
{
public:
  Collection_models(std::size_t shapes, int labels)
      : triangles_of_shape_(std::max(fewest_of_shape, collection_triangles / std::max<std::size_t>(1, shapes))),
        is_coarse_(shapes > most_fine),
        unclustered_(labels)
  {}

  /// Adds a shape. \param model null: curves and sheets are shown \param labels the cluster of each part; -1: none
  void add(const Structural_graph& graph, const Segmented_shape* model, const std::vector<int>& labels)
  {
    std::optional<Segmented_shape> simplified;
    if (model) simplified = simplified_shape(*model, triangles_of_shape_);
    const Drawn_shape drawn(graph, simplified ? &*simplified : nullptr, 0);
    std::vector<int> nodes;
    for (std::size_t part = 0; part < drawn.number_of_parts(); ++part) {
      Drawn_mesh mesh = drawn.model() ? drawn.flat_surface(part)
                        : is_coarse_  ? drawn.coarse_abstraction(part)
                                      : drawn.abstraction(part);
      mesh.material = labels[part] == Co_analysis::none ? unclustered_ : labels[part];
      mesh.layer.clear(); // the layer is an extra of the shape's node, and names are in the page's JSON
      nodes.push_back(glb_.add_node("", {std::move(mesh)}));
    }
    roots_.push_back(glb_.add_node(drawn.name(), nodes, Point::Zero()));
    glb_.set_node_extras(roots_.back(), {{"layer", drawn.model() ? surface_layer : abstraction_layer}});
  }

  /// The bytes of the GLB file. \param role_of_cluster for each cluster, the role that its colour shows
  std::string text(const std::vector<std::string>& role_of_cluster)
  {
    int number = 0; // materials, in the order of labels, are added last, as roles are known only then
    for (const Colour& colour : colours_of_roles(role_of_cluster))
      glb_.add_material("cluster_" + std::to_string(++number), colour);
    glb_.add_material("none", grey());
    std::ostringstream out;
    glb_.write(out, {{"collection", roots_}});
    return out.str();
  }

private:
  std::size_t triangles_of_shape_;
  bool is_coarse_;
  Glb_file glb_;
  int unclustered_; // material of parts in no cluster
  std::vector<int> roots_;
};

double rounded(double energy) { return std::round(energy * 1e4) / 1e4; }

/// The names of the operations, indexed by the values of `Operation`.
std::vector<std::string> names_of_operations()
{
  std::vector<std::string> result;
  for (int number = 0; number < int(Operation::NONE); ++number)
    result.push_back(name_of(Operation(number)));
  return result;
}

/// An object with, for each pair of shapes i < j, at the key "i,j": the energies of i to j and of j to i, and blocks of
/// corresponding parts, each with its operation (as a number) and its confidence in per cent.
Json maps_json(const Collection& collection, const std::vector<Shape_pair_map>& maps)
{
  std::string result;
  for (const Shape_pair_map& map : maps) {
    if (map.source > map.target) continue;
    Correspondence correspondence;
    correspondence.pairs = map.map.pairs;
    Json blocks = Json::array();
    for (const Correspondence_block& block : correspondence_blocks(correspondence))
      blocks.push_back(
          Json::array({block.source, block.target, int(block.operation), std::lround(100 * block.confidence)}));
    const std::size_t i = map.source, j = map.target;
    result +=
        (result.empty() ? "\"" : ",\"") + std::to_string(i) + ',' + std::to_string(j) + "\":" +
        Json::array({rounded(collection.energy(i, j)), rounded(collection.energy(j, i)), std::move(blocks)}).line();
  }
  return Json::of_text('{' + result + '}');
}

/// The shapes that the page shows: all, or the ones at even steps of a walk along the spanning tree from the medoid on.
std::vector<std::size_t> pictured(const Collection& collection)
{
  const std::size_t n = collection.shapes.size();
  std::vector<std::size_t> result(n);
  std::iota(result.begin(), result.end(), std::size_t(0));
  if (n <= largest_pictured) return result;
  std::vector<std::vector<std::size_t>> near(n);
  for (const auto& [a, b] : collection.tree) {
    near[a].push_back(b);
    near[b].push_back(a);
  }
  std::vector<std::size_t> walk, stack{collection.medoid};
  std::vector<char> is_seen(n, 0);
  is_seen[collection.medoid] = 1;
  while (!stack.empty()) {
    walk.push_back(stack.back());
    stack.pop_back();
    for (std::size_t next : near[walk.back()])
      if (!is_seen[next]) is_seen[next] = 1, stack.push_back(next);
  }
  result.clear();
  for (std::size_t k = 0; k < largest_pictured; ++k)
    result.push_back(walk[k * walk.size() / largest_pictured]);
  std::sort(result.begin(), result.end());
  return result;
}

/// A collection of some of the shapes of another one, with the spanning tree of its own.
Collection part_of(const Collection& whole, const std::vector<std::size_t>& shapes)
{
  Collection result;
  const auto n = Eigen::Index(shapes.size());
  Eigen::MatrixXd energies(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t shape = shapes[std::size_t(i)];
    result.shapes.push_back(whole.shapes[shape]);
    result.co_analysis.labels.push_back(whole.co_analysis.labels[shape]);
    if (shape == whole.medoid) result.medoid = std::size_t(i);
    for (Eigen::Index j = 0; j < n; ++j)
      energies(i, j) = whole.energy(shape, shapes[std::size_t(j)]);
  }
  result.tree = minimum_spanning_tree(symmetric_distances(energies));
  result.energy = [energies = std::move(energies)](std::size_t i, std::size_t j) {
    return energies(Eigen::Index(i), Eigen::Index(j));
  };
  result.co_analysis.number_of_labels = whole.co_analysis.number_of_labels;
  result.warnings = whole.warnings;
  return result;
}

/// The maps between the given shapes (sorted indices), whose indices become their positions in this list.
std::vector<Shape_pair_map> maps_between(const std::vector<Shape_pair_map>& maps,
                                         const std::vector<std::size_t>& shapes)
{
  const auto place = [&](std::size_t shape) { return std::lower_bound(shapes.begin(), shapes.end(), shape); };
  const auto is_there = [&](std::size_t shape) { return place(shape) != shapes.end() && *place(shape) == shape; };
  std::vector<Shape_pair_map> result;
  for (const Shape_pair_map& map : maps)
    if (is_there(map.source) && is_there(map.target))
      result.push_back(
          {std::size_t(place(map.source) - shapes.begin()), std::size_t(place(map.target) - shapes.begin()), map.map});
  return result;
}

using Roles = std::vector<std::string>;

/// For each cluster, the most frequent role of its parts; empty if it is not known.
Roles roles_of_clusters(const Co_analysis& clusters, const std::vector<Roles>& roles)
{
  std::vector<std::map<std::string, int>> counts(std::size_t(clusters.number_of_labels));
  for (std::size_t shape = 0; shape < roles.size(); ++shape)
    for (std::size_t part = 0; part < roles[shape].size(); ++part)
      if (const int cluster = clusters.labels[shape][part]; cluster != Co_analysis::none)
        ++counts[std::size_t(cluster)][roles[shape][part]];
  Roles result;
  for (const std::map<std::string, int>& of_cluster : counts) {
    const auto most = std::max_element(of_cluster.begin(), of_cluster.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    result.push_back(most == of_cluster.end() ? "" : most->first);
  }
  return result;
}

/// For each shape and part, the number of the cluster; -1: none.
Json clusters_json(const Collection& collection)
{
  Json result = Json::array();
  for (const std::vector<int>& labels : collection.co_analysis.labels)
    result.push_back(labels);
  return result;
}

/// The page of a collection of at most `largest_pictured` shapes. \param total number of shapes of the whole collection
Page collection_page(const Collection& collection, std::size_t total,
                     const std::function<Structural_graph(std::size_t)>& graph, const Models& model,
                     const std::vector<Shape_pair_map>& maps)
{
  Collection_models models(collection.shapes.size(), collection.co_analysis.number_of_labels);
  std::vector<Roles> roles;
  for (std::size_t i = 0; i < collection.shapes.size(); ++i) {
    const std::optional<Segmented_shape> shape = model ? model(i) : std::nullopt;
    const Structural_graph drawn = graph(i);
    roles.push_back(likeliest_roles(drawn));
    models.add(drawn, shape ? &*shape : nullptr, collection.co_analysis.labels[i]);
  }
  const Roles role_of_cluster = roles_of_clusters(collection.co_analysis, roles);
  std::ostringstream json, stored;
  Json outline = collection_outline_json(collection);
  outline["warnings"] = collection.warnings;
  outline.write(json);
  Json labels = Json::array();
  for (std::size_t i = 0; i < collection.shapes.size(); ++i)
    labels.push_back(part_labels(collection.shapes[i].parts, roles[i]));
  Json({{"total", total},
        {"labels", std::move(labels)},
        {"roles", role_of_cluster},
        {"clusters", clusters_json(collection)},
        {"operations", names_of_operations()},
        {"maps", maps_json(collection, maps)}})
      .write(stored);
  return {"Collection of shapes",
          {{"collection", json.str()}, {"maps", stored.str()}},
          {{"collection.glb", models.text(role_of_cluster)}}};
}

} // namespace

void write_collection_html(std::ostream& out, const Collection& collection,
                           const std::function<Structural_graph(std::size_t)>& graph,
                           const std::vector<Shape_pair_map>& maps, const Models& model)
{
  const std::size_t total = collection.shapes.size();
  const std::vector<std::size_t> shown = pictured(collection);
  if (shown.size() == total) {
    write_page(out, collection_page(collection, total, graph, model, maps));
    return;
  }
  const auto shown_graph = [&](std::size_t i) { return graph(shown[i]); };
  const auto shown_model = [&](std::size_t i) { return model ? model(shown[i]) : std::nullopt; };
  write_page(out,
             collection_page(part_of(collection, shown), total, shown_graph, shown_model, maps_between(maps, shown)));
}

} // namespace CGAL::Shape_correspondence::IO
