// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/jobs.h"
#include "cli/load_shape.h"
#include "cli/run.h"
#include "io/system/input_file.h"
#include "roles/Role_trainer.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/train_role_model.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace CGAL::Shape_correspondence::cli {

namespace fs = std::filesystem;

namespace {

// Number of examples needed for a new category: fewer lower the mean F1 of matches (manual, "Accuracy").
constexpr std::size_t least_examples = 3;

std::string parts_of(const IO::Labelled_shape& shape)
{
  return (fs::path(shape.file).parent_path() / "parts").string();
}

std::vector<Part_label> labels_by_part(const Structural_graph& graph, const IO::Labelled_shape& labels)
{
  std::vector<Part_label> result;
  for (const Part_abstraction& part : structure(graph).parts) {
    const std::size_t index = labels.index(part.name);
    if (index == labels.parts.size())
      throw Invalid_input(labels.file + ": there is no label of the part '" + part.name + "'; add one");
    result.push_back(labels.labels[index]);
  }
  return result;
}

std::vector<Labelled_graph> labelled_graphs(const std::vector<Labelled_model>& models, std::size_t number_of_real)
{
  std::vector<Labelled_graph> result;
  for (const Labelled_model& model : models) {
    const bool is_real = result.size() < number_of_real;
    result.push_back({&model.graph, model.labels.category, model.part_labels,
                      is_real ? internal::weight_of_real_shapes : 1, !is_real});
  }
  return result;
}

/// Finds shapes without labels (folders with `parts/`) in a folder of SHAPE/ or CATEGORY/SHAPE/.
void find_unlabelled(const fs::path& folder, int depth, std::vector<std::string>& shapes)
{
  constexpr int deepest = 2; // same depth as in `read_part_labels()`
  if (!fs::is_directory(folder) || (depth > 0 && IO::is_hidden(folder)) || fs::exists(folder / "labels.json")) return;
  if (fs::is_directory(folder / "parts"))
    shapes.push_back(folder.string());
  else if (depth < deepest)
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
      find_unlabelled(entry.path(), depth + 1, shapes);
}

/// A note with the number of unlabelled shapes in folders, and the first of these; empty if there are none.
std::string unlabelled_shapes(const std::vector<std::string>& folders)
{
  std::vector<std::string> shapes;
  for (const std::string& folder : folders)
    find_unlabelled(folder, 0, shapes);
  if (shapes.empty()) return "";
  const std::string first = *std::min_element(shapes.begin(), shapes.end());
  return std::to_string(shapes.size()) + (shapes.size() == 1 ? " shape has" : " shapes have") + " no labels.json and " +
         (shapes.size() == 1 ? "is" : "are") + " left out: " + first + (shapes.size() == 1 ? "" : " and others");
}

} // namespace

std::vector<Labelled_model> load_labelled_models(const std::vector<std::string>& folders, const Common_options& options)
{
  Common_options labelled = options;
  labelled.parts = Part_splitting::FILE; // the parts that are labelled
  std::vector<Labelled_model> result;
  for (const std::string& folder : folders) {
    const std::vector<IO::Labelled_shape> shapes = IO::read_part_labels(folder);
    const std::vector<Loaded_shape> loaded = load_shapes(mapped(shapes, parts_of), labelled);
    for (std::size_t i = 0; i < shapes.size(); ++i)
      result.push_back({folder, shapes[i], loaded[i].graph, labels_by_part(loaded[i].graph, shapes[i])});
  }
  return result;
}

std::vector<Labelled_model> load_generated_models(const std::vector<std::string>& folders,
                                                  const Common_options& options)
{
  Common_options quick = options; // features of parts are the same without curves, sheets and symmetries
  quick.structure.abstraction.abstractor = Bounding_box_abstraction();
  quick.structure.symmetry.enabled = false;
  return load_labelled_models(folders, quick);
}

std::shared_ptr<const Role_model> role_model_of(const std::string& file)
{
  return file.empty() ? IO::shipped_role_model() : std::make_shared<const Role_model>(IO::read_role_model(file));
}

std::vector<std::string> add_examples(const std::string& folder, const Common_options& options,
                                      std::shared_ptr<const Role_model>& model, std::string& category, bool always_new)
{
  if (folder.empty()) return {};
  const std::vector<Labelled_model> models = load_labelled_models({folder}, options);
  const bool is_asked_for = !category.empty();
  const Role_model known = model ? *model : Role_model();
  std::vector<Labelled_graph> shapes = labelled_graphs(models, models.size());
  std::map<std::string, std::size_t> counts;
  for (const Labelled_graph& shape : shapes)
    ++counts[shape.category];
  std::vector<std::string> left_out;
  for (const auto& [name, count] : counts) {
    const std::vector<std::string> names = known.categories();
    if (always_new || count >= least_examples || std::binary_search(names.begin(), names.end(), name)) continue;
    if (category == name) category.clear();
    left_out.push_back(folder + ": the examples of the category " + name + " were not used, since there are only " +
                       std::to_string(count) + " of it; add some, until there are " + std::to_string(least_examples));
    shapes.erase(std::remove_if(shapes.begin(), shapes.end(),
                                [of = name](const Labelled_graph& shape) { return shape.category == of; }),
                 shapes.end());
  }
  if (!is_asked_for && counts.size() == 1 && left_out.empty()) category = counts.begin()->first;
  if (!shapes.empty()) model = std::make_shared<const Role_model>(extend_role_model(known, shapes));
  return left_out;
}

Trained_roles train_roles(const Role_training& training, const Common_options& options)
{
  Trained_roles result;
  std::vector<std::string> folders = training.folders;
  append(folders, training.generated);
  if (const std::string left_out = unlabelled_shapes(folders); !left_out.empty()) warn(options, left_out);
  result.models = load_labelled_models(training.folders, options);
  result.number_of_real = result.models.size();
  append(result.models, load_generated_models(training.generated, options));
  result.model = train_role_model(labelled_graphs(result.models, result.number_of_real), training.options);
  return result;
}

} // namespace CGAL::Shape_correspondence::cli
