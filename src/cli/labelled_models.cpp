// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/labels.h"
#include "cli/load_shape.h"
#include "cli/run.h"
#include "cli/text.h"
#include "io/read/Json_field.h"
#include "io/system/input_file.h"
#include "roles/Role_trainer.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/train_role_model.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

namespace CGAL::Shape_correspondence::cli {

namespace fs = std::filesystem;

namespace {

using Pair = std::array<std::size_t, 2>;

/// The folder of the part meshes.
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

std::size_t index_of(const std::vector<Labelled_model>& models, const std::string& folder, const std::string& category,
                     const IO::Json_field& name)
{
  for (std::size_t i = 0; i < models.size(); ++i)
    if (models[i].folder == folder && models[i].labels.category == category && models[i].labels.name == name.text())
      return i;
  name.fail("names a shape that is not in the category '" + category + "'");
}

void add_listed(const std::vector<Labelled_model>& models, const std::string& folder, const std::string& file,
                std::vector<Pair>& pairs)
{
  for (const IO::Json_field& entry : IO::read_json_file(file).elements()) {
    const std::vector<IO::Json_field> words = entry.elements(3, "category, source and target");
    const std::string category = words[0].text();
    pairs.push_back({index_of(models, folder, category, words[1]), index_of(models, folder, category, words[2])});
  }
}

void add_spread(const std::vector<Labelled_model>& models, const std::string& folder, std::size_t most,
                std::vector<Pair>& pairs)
{
  std::map<std::string, std::vector<Pair>> all;
  for (std::size_t i = 0; i < models.size(); ++i)
    for (std::size_t j = i + 1; j < models.size(); ++j)
      if (models[i].folder == folder && models[j].folder == folder &&
          models[i].labels.category == models[j].labels.category)
        all[models[i].labels.category].push_back({i, j});
  for (const auto& [category, of_category] : all) {
    const std::size_t count = std::min(most, of_category.size());
    for (std::size_t k = 0; k < count; ++k)
      pairs.push_back(of_category[k * of_category.size() / count]);
  }
}

std::vector<Labelled_graph> labelled_graphs(const std::vector<Labelled_model>& models, std::size_t number_of_real)
{
  std::vector<Labelled_graph> result;
  for (const Labelled_model& model : models) {
    const double weight = result.size() < number_of_real ? internal::weight_of_real_shapes : 1;
    result.push_back({&model.graph, model.labels.category, model.part_labels, weight});
  }
  return result;
}

/// The shapes, folders with `parts/`, of a folder of SHAPE/ or CATEGORY/SHAPE/ that have no labels.
void find_unlabelled(const fs::path& folder, int depth, std::vector<std::string>& shapes)
{
  constexpr int deepest = 2; // as `read_part_labels()`
  if (!fs::is_directory(folder) || (depth > 0 && IO::is_hidden(folder)) || fs::exists(folder / "labels.json")) return;
  if (fs::is_directory(folder / "parts"))
    shapes.push_back(folder.string());
  else if (depth < deepest)
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
      find_unlabelled(entry.path(), depth + 1, shapes);
}

/// Says how many shapes without labels there are in folders, and which is the first. Empty: none.
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
  labelled.parts = Part_splitting::FILE; // the labelled ones
  std::vector<Labelled_model> result;
  for (const std::string& folder : folders) {
    const std::vector<IO::Labelled_shape> shapes = IO::read_part_labels(folder);
    const std::vector<Loaded_shape> loaded = load_shapes(mapped(shapes, parts_of), labelled);
    for (std::size_t i = 0; i < shapes.size(); ++i)
      result.push_back({folder, shapes[i], loaded[i].graph, labels_by_part(loaded[i].graph, shapes[i])});
  }
  return result;
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
  const std::vector<std::string> names = known.categories();
  std::vector<Labelled_graph> shapes = labelled_graphs(models, models.size());
  std::vector<std::string> left_out;
  const std::vector<Gain_of_examples> gains = gains_of_examples(known, shapes);
  for (const Gain_of_examples& gain : gains) {
    if (gain.is_clear()) continue;
    const bool is_new = !std::binary_search(names.begin(), names.end(), gain.category);
    if (always_new && is_new) continue;
    if (is_new && category == gain.category) category.clear();
    left_out.push_back(
        folder + ": the examples of the category " + gain.category + " were not used, since " +
        (gain.pairs == 0
             ? "three or more are needed to measure a gain"
             : "what was learned from the others does not make their matches better by more than chance (F1 " +
                   short_number(gain.with) + " with it, " + short_number(gain.without) + " without)") +
        "; with the model that `roles train` makes of them they are used in any case");
    shapes.erase(std::remove_if(shapes.begin(), shapes.end(),
                                [&](const Labelled_graph& shape) { return shape.category == gain.category; }),
                 shapes.end());
  }
  if (!is_asked_for && gains.size() == 1 && left_out.empty()) category = gains[0].category;
  if (!shapes.empty()) model = std::make_shared<const Role_model>(extend_role_model(known, shapes));
  return left_out;
}

std::vector<Pair> listed_pairs(const std::vector<Labelled_model>& models, std::size_t most)
{
  std::set<std::string> folders;
  std::vector<Pair> result;
  for (const Labelled_model& model : models) {
    if (!folders.insert(model.folder).second) continue;
    const fs::path file = fs::path(model.folder) / "pairs.json";
    if (fs::exists(file))
      add_listed(models, model.folder, file.string(), result);
    else
      add_spread(models, model.folder, most, result);
  }
  return result;
}

Trained_roles train_roles(const Role_training& training, const Common_options& options)
{
  Trained_roles result;
  std::vector<std::string> folders = training.folders;
  append(folders, training.generated);
  if (const std::string left_out = unlabelled_shapes(folders); !left_out.empty()) warn(options, left_out);
  result.models = load_labelled_models(training.folders, options);
  result.number_of_real = result.models.size();
  const std::vector<Pair> pairs = listed_pairs(result.models, training.most_pairs);
  append(result.models, load_labelled_models(training.generated, options));
  result.model = train_role_model(labelled_graphs(result.models, result.number_of_real), training.options, pairs);
  return result;
}

} // namespace CGAL::Shape_correspondence::cli
