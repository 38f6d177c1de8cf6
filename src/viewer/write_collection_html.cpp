// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/colours.h"
#include "viewer/collection_page.h"
#include "viewer/html_text.h"

#include <CGAL/Shape_correspondence/IO/write_collection_html.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr int curve_points = 9, sheet_points = 4; // of a picture
constexpr int picture_grid = 1000;                // steps of a coordinate

/// Whole numbers about the middle of the shape, and their largest distance from it.
Json shape_json(const Structural_graph& graph, const std::string& name, const std::vector<int>& labels)
{
  const Shape_structure& shape = structure(graph);
  std::vector<Points> drawn;
  Point low = Point::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Part_abstraction& part : shape.parts) {
    drawn.push_back(shape.frame.to_frame(sample(part, part.is_sheet() ? sheet_points : curve_points)));
    low = low.cwiseMin(drawn.back().rowwise().minCoeff());
    high = high.cwiseMax(drawn.back().rowwise().maxCoeff());
  }
  const Point middle = (low + high) / 2;
  const double size = std::max((high - low).norm(), 1e-9);
  double radius = 0;
  Json parts = Json::array();
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    Json points = Json::array();
    const auto add = [&](const Point& p) {
      const Point q = (p - middle) / size * picture_grid;
      radius = std::max(radius, q.norm());
      points.push_back({std::lround(q.x()), std::lround(q.y()), std::lround(q.z())});
    };
    for (Eigen::Index k = 0; k < drawn[i].cols(); ++k)
      add(drawn[i].col(k));
    if (shape.parts[i].is_closed_curve()) add(drawn[i].col(0));
    parts.push_back({{"name", shape.parts[i].name},
                     {"label", labels[i]},
                     {"columns", shape.parts[i].is_sheet() ? sheet_points : 0},
                     {"points", std::move(points)}});
  }
  return {{"name", name}, {"radius", std::ceil(radius)}, {"parts", std::move(parts)}};
}

Json notes_of(const Collection& collection)
{
  Json result = Json::array();
  result.push_back("Parts of one cluster have one colour; parts like no others are grey. Click two shapes to see their "
                   "match.");
  for (const std::string& warning : collection.warnings)
    result.push_back("Warning: " + warning);
  return result;
}

double rounded(double energy) { return std::round(energy * 1e4) / 1e4; }

Json tree_json(const Collection& collection)
{
  Json result = Json::array();
  for (const auto& [a, b] : collection.tree) {
    const auto i = Eigen::Index(a), j = Eigen::Index(b);
    result.push_back({a, b, rounded((collection.energies(i, j) + collection.energies(j, i)) / 2)});
  }
  return result;
}

/// By "source,target", the smaller index first: the energies of both directions, and pairs of parts with per cent.
Json maps_json(const Collection& collection, const std::vector<Shape_pair_map>& maps)
{
  Json result = Json::object();
  for (const Shape_pair_map& map : maps) {
    if (map.source > map.target) continue;
    Json pairs = Json::array();
    for (const Part_correspondence& pair : map.map.pairs)
      pairs.push_back({pair.source, pair.target, std::lround(100 * pair.confidence)});
    const auto i = Eigen::Index(map.source), j = Eigen::Index(map.target);
    result[std::to_string(map.source) + ',' + std::to_string(map.target)] = {
        {"energies", {rounded(collection.energies(i, j)), rounded(collection.energies(j, i))}},
        {"pairs", std::move(pairs)}};
  }
  return result;
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
  result.energies.resize(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t shape = shapes[std::size_t(i)];
    result.shapes.push_back(whole.shapes[shape]);
    result.co_analysis.labels.push_back(whole.co_analysis.labels[shape]);
    if (shape == whole.medoid) result.medoid = std::size_t(i);
    for (Eigen::Index j = 0; j < n; ++j)
      result.energies(i, j) = whole.energies(Eigen::Index(shape), Eigen::Index(shapes[std::size_t(j)]));
  }
  result.tree = minimum_spanning_tree(symmetric_distances(result.energies));
  result.co_analysis.number_of_labels = whole.co_analysis.number_of_labels;
  result.warnings = whole.warnings;
  return result;
}

/// The maps between some of the shapes, by their places among these.
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

Json page_data(const Collection& collection, const std::function<Structural_graph(std::size_t)>& graph,
               const std::vector<Shape_pair_map>& maps)
{
  Json data;
  data["notes"] = notes_of(collection);
  data["total"] = collection.shapes.size();
  data["medoid"] = collection.medoid;
  std::size_t most_parts = std::size_t(collection.co_analysis.number_of_labels);
  data["shapes"] = Json::array();
  for (std::size_t i = 0; i < collection.shapes.size(); ++i) {
    data["shapes"].push_back(shape_json(graph(i), collection.shapes[i].name, collection.co_analysis.labels[i]));
    most_parts = std::max(most_parts, collection.shapes[i].parts.size());
  }
  data["colours"] = Json::array();
  for (const Colour& colour : distinct_colours(most_parts))
    data["colours"].push_back(css_colour(colour));
  data["tree"] = tree_json(collection);
  data["maps"] = maps_json(collection, maps);
  return data;
}

} // namespace

void write_collection_html(std::ostream& out, const Collection& collection,
                           const std::function<Structural_graph(std::size_t)>& graph,
                           const std::vector<Shape_pair_map>& maps)
{
  const std::vector<std::size_t> shown = pictured(collection);
  Json data;
  if (shown.size() == collection.shapes.size()) {
    data = page_data(collection, graph, maps);
  } else {
    data = page_data(
        part_of(collection, shown), [&](std::size_t i) { return graph(shown[i]); }, maps_between(maps, shown));
    data["total"] = collection.shapes.size();
    data["notes"].push_back("Shown are " + std::to_string(shown.size()) +
                            " of the shapes, the medoid and others evenly from all branches of the spanning tree of "
                            "all; the tree below is that of the shapes shown.");
  }
  write_collection_page(out, data);
}

} // namespace CGAL::Shape_correspondence::IO
