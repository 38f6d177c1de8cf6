// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "../peers/unit_box.h"

#include <CGAL/Shape_correspondence/IO/read_part_labels.h>
#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_cache.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::experiments {

namespace fs = std::filesystem;

/// Labelled shapes of one category, and the pairs of them that are matched.
struct Category
{
  std::string name;
  std::vector<std::string> shapes;  ///< names of the shapes
  std::vector<std::string> folders; ///< folders of the parts' meshes, by shape
  std::vector<Structural_graph> graphs;
  std::vector<std::vector<Part_label>> labels; ///< by shape, and by part as in the graph
  std::vector<peers::Shape_pair> pairs;
};

using Dataset = std::vector<Category>;

inline std::vector<Part_label> labels_of(const Structural_graph& graph, const IO::Labelled_shape& shape)
{
  std::vector<Part_label> labels;
  for (const Part_abstraction& part : structure(graph).parts) {
    const std::size_t index = shape.index(part.name);
    if (index == shape.parts.size())
      throw Invalid_input(shape.file + ": there is no label of part '" + part.name + "'");
    labels.push_back(shape.labels[index]);
  }
  return labels;
}

inline Structural_graph load_graph(const Segmented_shape& model, const std::string& cache_folder)
{
  const Structure_options options;
  if (cache_folder.empty()) return build_structural_graph(model, options);
  const IO::Structural_graph_cache cache(cache_folder);
  const std::string content = IO::content_hash(model, options);
  if (auto graph = cache.find(content)) return std::move(*graph);
  Structural_graph graph = build_structural_graph(model, options);
  structure(graph).content = content;
  cache.insert(graph);
  return graph;
}

/// Sets the pairs to those that FOLDER/pairs.json lists as [category, source, target], or else to all of a category.
inline void choose_pairs(const std::string& folder, Dataset& dataset)
{
  std::map<std::string, std::vector<peers::Shape_pair>> listed;
  const fs::path file = fs::path(folder) / "pairs.json";
  std::ifstream in(file);
  for (Category& category : dataset) {
    if (in.is_open()) break;
    for (std::size_t i = 0; i < category.shapes.size(); ++i)
      for (std::size_t j = i + 1; j < category.shapes.size(); ++j)
        category.pairs.push_back({i, j});
  }
  if (!in.is_open()) return;
  for (const auto& entry : nlohmann::json::parse(in)) {
    const auto category =
        std::find_if(dataset.begin(), dataset.end(), [&](const Category& c) { return c.name == entry.at(0); });
    if (category == dataset.end()) continue; // not among the categories asked for
    const auto index = [&](const std::string& name) {
      const auto& shapes = category->shapes;
      const auto found = std::find(shapes.begin(), shapes.end(), name);
      if (found == shapes.end()) throw Invalid_input(file.string() + ": there is no shape '" + name + "'");
      return std::size_t(found - shapes.begin());
    };
    category->pairs.push_back({index(entry.at(1)), index(entry.at(2))});
  }
}

/// Reads a folder of labelled shapes, CATEGORY/SHAPE/{labels.json, parts/}.
/// \param cache folder that keeps graphs; empty: none is kept \param wanted categories to read; empty: all
inline Dataset load_dataset(const std::string& folder, const std::string& cache, const std::vector<std::string>& wanted)
{
  std::map<std::string, Category> categories;
  for (const IO::Labelled_shape& shape : IO::read_part_labels(folder)) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), shape.category) == wanted.end()) continue;
    Category& category = categories[shape.category];
    const std::string parts = (fs::path(shape.file).parent_path() / "parts").string();
    category.name = shape.category;
    category.shapes.push_back(shape.name);
    category.folders.push_back(parts);
    category.graphs.push_back(load_graph(IO::read_segmented_shape(parts, Point::UnitY()), cache));
    category.labels.push_back(labels_of(category.graphs.back(), shape));
  }
  Dataset dataset;
  for (auto& [name, category] : categories)
    dataset.push_back(std::move(category));
  choose_pairs(folder, dataset);
  return dataset;
}

} // namespace CGAL::Shape_correspondence::experiments
