// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/transfer_labels.h"
#include "base/for_each_index.h"
#include "cli/labelled_models.h"
#include "cli/labels_json.h"
#include "cli/run.h"
#include "cli/text.h"
#include "io/system/atomic_file.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>

namespace CGAL::Shape_correspondence::cli {

namespace fs = std::filesystem;

namespace {

using Labels = std::vector<Transferred_label>; // by part

Labelled_model labelled_source(const std::string& path, const Common_options& common)
{
  std::vector<Labelled_model> models = load_labelled_models(path, common);
  if (models.size() > 1)
    throw Invalid_input(path + ": it has " + std::to_string(models.size()) +
                        " labelled shapes; --labels-from takes the folder of one");
  return std::move(models[0]);
}

/// The folder of a shape's labels: named as the file or folder of the shape.
fs::path folder_of(const Collection_shape& shape, const std::string& folder)
{
  const fs::path path = fs::absolute(shape.path).lexically_normal();
  const fs::path name = path.has_filename() ? path : path.parent_path();
  return fs::path(folder) / (fs::is_directory(name) ? name.filename() : name.stem());
}

void write_files(const Collection_shapes& shapes, const std::string& category, const std::vector<Labels>& labels,
                 const std::string& folder)
{
  std::set<fs::path> used;
  for (const Collection_shape& shape : shapes.shapes())
    if (!used.insert(folder_of(shape, folder)).second)
      throw Invalid_input(shape.path +
                          ": another shape of the set has the same name, so that its labels would go to '" +
                          folder_of(shape, folder).string() + "', too; rename one");
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const fs::path target = folder_of(shapes.shapes()[i], folder);
    fs::create_directories(target);
    IO::write_atomically((target / "labels.json").string(), [&](std::ostream& out) {
      labels_json(shapes.shapes()[i].parts, category, labels[i]).write(out);
    });
  }
}

IO::Json document(const Labelled_model& source, const Collection_shapes& shapes, const std::vector<Labels>& labels)
{
  IO::Json result;
  result["format"] = "shape_correspondence/transferred_labels";
  result["version"] = 1;
  result["source"] = source.labels.file;
  result["category"] = source.labels.category;
  result["shapes"] = IO::Json::array();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Collection_shape& shape = shapes.shapes()[i];
    result["shapes"].push_back(
        {{"name", shape.name}, {"file", shape.path}, {"parts", parts_json(shape.parts, labels[i])}});
  }
  result["warnings"] = IO::Json(shapes.skipped());
  return result;
}

void print(const Collection_shapes& shapes, const std::vector<Labels>& labels)
{
  std::vector<std::vector<std::string>> rows{{"shape", "parts", "mean confidence", "labels"}};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    double sum = 0;
    std::map<std::string, int> counts;
    for (const Transferred_label& label : labels[i]) {
      sum += label.confidence;
      ++counts[label.label.coarse];
    }
    std::string text;
    for (const auto& [label, count] : counts)
      text += (text.empty() ? "" : ", ") + std::to_string(count) + ' ' + label;
    const std::size_t parts = std::max<std::size_t>(1, labels[i].size());
    rows.push_back(
        {shapes.shapes()[i].name, std::to_string(labels[i].size()), short_number(sum / double(parts)), text});
  }
  write_table(std::cout, rows);
}

} // namespace

void transfer_labels(const Collection_shapes& shapes, const Collection_options& options, const Search_options& search,
                     const Common_options& common)
{
  const Labelled_model source = labelled_source(options.labels_from, common);
  const Correspondence_finder finder(source.graph, search);
  std::vector<Labels> labels(shapes.size());
  internal::for_each_index(shapes.size(), true, [&](std::size_t i) {
    const Structural_graph target = shapes.graph(i);
    labels[i] = finder.transfer_labels(source.part_labels, Prepared_shape(target));
  });
  if (!options.labels_to.empty()) write_files(shapes, source.labels.category, labels, options.labels_to);
  write_output(common.json, [&](std::ostream& out) { document(source, shapes, labels).write(out); });
  if (common.prints_table()) print(shapes, labels);
}

} // namespace CGAL::Shape_correspondence::cli
