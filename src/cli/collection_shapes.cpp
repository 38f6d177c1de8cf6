// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"
#include "cli/collection.h"
#include "cli/load_shape.h"
#include "cli/run.h"
#include "io/read/document.h"
#include "io/read/model_parts.h"
#include "io/read/read_objects.h"
#include "io/system/atomic_file.h"
#include "io/system/input_file.h"
#include "io/write/Json.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <sstream>

namespace CGAL::Shape_correspondence::cli {
namespace {

namespace fs = std::filesystem;

bool is_shape_file(const std::string& path) { return is_graph_file(path) || IO::is_model_file(path); }

std::vector<std::string> model_files(const fs::path& folder)
{
  std::vector<std::string> result;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && !IO::is_hidden(entry.path()) && IO::is_model_file(entry.path().string()))
      result.push_back(entry.path().string());
  return result;
}

bool has_several_objects(const std::string& model)
{
  try {
    return IO::read_objects(model, Point::UnitY()).shape.parts().size() > 1;
  } catch (const Invalid_input&) { // reported when it is read
    return false;
  }
}

/// Whether the model files of a folder are shapes, as each has several objects, rather than parts of one shape.
bool are_shapes(const std::vector<std::string>& models)
{
  return !models.empty() && std::all_of(models.begin(), models.end(), has_several_objects);
}

/// Whether a shape's parts are in a sub-folder.
bool is_divided(const fs::path& folder)
{
  return fs::is_directory(folder / "parts") || IO::hierarchy_in(folder.string());
}

/// Whether a folder, or its sub-folder for parts, contains the part meshes of a shape.
bool is_shape_folder(const fs::path& folder)
{
  if (is_divided(folder)) return true;
  const std::vector<std::string> models = model_files(folder);
  return !models.empty() && !are_shapes(models);
}

struct Loaded_input
{
  Collection_shape shape;
  std::string failure;                   ///< empty: none
  std::optional<Structural_graph> graph; ///< none if it is in a folder only

  bool is_loaded() const { return !(failure + shape.content).empty(); }
};

std::string text_of(const Structural_graph& graph)
{
  std::ostringstream text;
  IO::write_structural_graph_json(text, graph);
  return text.str();
}

std::string graph_file(const std::string& folder, const std::string& content)
{
  return (fs::path(folder) / (content + ".json")).string();
}

/// The text of a graph in the folder; none if it is missing or damaged.
std::optional<std::string> stored_text(const std::string& folder, const std::string& content)
{
  const std::string text = IO::bytes_of_file(graph_file(folder, content));
  return IO::digest(text) == content ? std::optional(text) : std::nullopt;
}

/// Stores a graph in the folder, if there is one. \return the digest of the graph, which is its name there
std::string store_graph(const std::string& folder, const Common_options& options, const Structural_graph& graph)
{
  const std::string text = text_of(graph);
  const std::string content = IO::digest(text);
  if (folder.empty()) return content;
  const std::string file = graph_file(folder, content);
  if (stored_text(folder, content)) return content;
  std::error_code error;
  if (fs::exists(file, error)) warn(options, file + ": it is damaged; it is made again");
  IO::write_entry(file, [&](std::ostream& out) { out << text; });
  return content;
}

/// The description of a graph, without its digest.
Collection_shape described(const std::string& path, const Structural_graph& graph)
{
  const Shape_structure& structure = Shape_correspondence::structure(graph);
  return {path, structure.name, "", part_names(graph), structure.warnings};
}

Loaded_input load_input(const std::string& path, const std::string& folder, const Common_options& options)
{
  Loaded_input result;
  try {
    result.graph = load_shape(path, options).graph;
  } catch (const Invalid_input& error) {
    result.failure = error.what();
    return result;
  }
  result.shape = described(path, *result.graph);
  result.shape.content = store_graph(folder, options, *result.graph);
  return result;
}

/// The message by which a process tells the others about an input.
IO::Json message(std::size_t index, const Loaded_input& input)
{
  return {{"index", index},
          {"failure", input.failure},
          {"name", input.shape.name},
          {"content", input.shape.content},
          {"parts", input.shape.parts},
          {"warnings", input.shape.warnings}};
}

void take(const IO::Json_field& message, Loaded_input& input)
{
  input.failure = message["failure"].text();
  input.shape.name = message["name"].text();
  input.shape.content = message["content"].text();
  input.shape.parts = message["parts"].texts();
  input.shape.warnings = message["warnings"].texts();
}

/// Exchanges the inputs loaded by this process with those loaded by the others.
void exchange(std::vector<Loaded_input>& inputs, Team& team)
{
  IO::Json messages = IO::Json::array();
  for (std::size_t i = 0; i < inputs.size(); ++i)
    if (inputs[i].is_loaded()) messages.push_back(message(i, inputs[i]));
  for (const std::string& text : team.gathered(messages.line())) {
    std::istringstream in(text);
    for (const IO::Json_field& one : IO::read_json(in, "message").elements())
      take(one, inputs[std::size_t(one["index"].integer())]);
  }
}

constexpr std::size_t most_graphs_in_memory = 256; // limit for graphs that are also in a folder, some .1 MB each
constexpr std::size_t inputs_at_a_time = 8;        // number of inputs handed to one of several processes at a time

/// Loads all inputs, distributed over the processes of the team; each process keeps the graphs that it loaded.
std::vector<Loaded_input> load_inputs(const std::vector<std::string>& paths, const std::string& folder,
                                      const Common_options& options, Team& team)
{
  Common_options quiet = options; // there is one bar for all inputs
  quiet.progress = "never";
  Progress_bar bar(options, "graphs", "shape");
  std::vector<Loaded_input> inputs(paths.size());
  std::mutex mutex;
  std::size_t done = 0;
  const std::size_t chunk = team.size() == 1 ? paths.size() : inputs_at_a_time;
  team.for_each((paths.size() + chunk - 1) / chunk, [&](std::size_t c) {
    const std::size_t begin = c * chunk, end = std::min(paths.size(), begin + chunk);
    internal::for_each_index<CGAL::Parallel_if_available_tag>(end - begin, [&](std::size_t k) {
      const std::size_t i = begin + k;
      inputs[i] = load_input(paths[i], folder, quiet);
      if (!folder.empty() && i >= most_graphs_in_memory) inputs[i].graph.reset();
      const std::lock_guard<std::mutex> lock(mutex);
      bar.show(++done, paths.size());
    });
  });
  if (team.size() > 1) exchange(inputs, team);
  for (std::size_t i = 0; i < inputs.size(); ++i)
    inputs[i].shape.path = paths[i];
  return inputs;
}

/// Names shapes with equal or empty names by their paths.
void make_names_unique(std::vector<Collection_shape>& shapes)
{
  std::map<std::string, int> uses;
  for (const Collection_shape& shape : shapes)
    ++uses[shape.name];
  for (Collection_shape& shape : shapes)
    if (uses[shape.name] > 1 || shape.name.empty()) shape.name = shape.path;
}

} // namespace

bool is_folder_of_shapes(const std::string& path)
{
  if (!fs::is_directory(path) || is_divided(path) || IO::robot_in(path)) return false;
  const std::vector<std::string> models = model_files(path);
  if (!models.empty()) return are_shapes(models);
  const fs::directory_iterator entries(path);
  return std::any_of(begin(entries), end(entries), [](const fs::directory_entry& entry) {
    return entry.is_directory() && !IO::is_hidden(entry.path()) && is_shape_folder(entry.path());
  });
}

std::vector<std::string> shapes_in(const std::string& folder, std::vector<std::string>* left_out)
{
  std::vector<std::string> result;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (IO::is_hidden(entry.path())) continue;
    if (entry.is_directory() ? is_shape_folder(entry.path()) : is_shape_file(entry.path().string()))
      result.push_back(entry.path().string());
    else if (left_out)
      left_out->push_back(entry.path().filename().string());
  }
  std::sort(result.begin(), result.end());
  if (left_out) std::sort(left_out->begin(), left_out->end());
  return result;
}

std::vector<std::string> collection_paths(const std::vector<std::string>& inputs, std::vector<std::string>* left_out)
{
  std::vector<std::string> result = inputs;
  if (inputs.size() == 1) {
    const fs::path folder = inputs[0];
    IO::check_exists(inputs[0]);
    if (!fs::is_directory(folder))
      throw Invalid_input(inputs[0] + ": it is one file; give a folder of shapes, or several inputs");
    result = shapes_in(inputs[0], left_out);
  }
  if (result.size() < 2)
    throw Invalid_input(inputs[0] + ": there are " + std::to_string(result.size()) +
                        " shapes in it; give two or more (model files, graphs, or folders of part meshes)");
  return result;
}

Collection_shapes::Collection_shapes(const std::vector<std::string>& paths, const std::string& folder, bool skip_bad,
                                     const Common_options& options, Team& team)
    : folder_(folder)
{
  if (!folder_.empty()) IO::make_folder(folder_, "a store");
  std::string failures;
  for (Loaded_input& input : load_inputs(paths, folder_, options, team)) {
    if (input.failure.empty()) {
      if (input.graph) graphs_.emplace(shapes_.size(), std::move(*input.graph));
      shapes_.push_back(std::move(input.shape));
      continue;
    }
    failures += (failures.empty() ? "" : "\n") + input.failure;
    skipped_.push_back("Left out: " + input.failure);
  }
  if (!failures.empty() && !skip_bad)
    throw Invalid_input(failures +
                        "\nthe collection needs all of its shapes; repair these, or leave them out by --skip-bad");
  if (shapes_.size() < 2) throw Invalid_input(failures + "\nfewer than two shapes are left; give more of them");
  make_names_unique(shapes_);
}

Collection_shapes::Collection_shapes(const std::vector<std::pair<std::string, Structural_graph>>& graphs)
{
  for (const auto& [path, graph] : graphs) {
    graphs_.emplace(shapes_.size(), graph);
    shapes_.push_back(described(path, graph));
    shapes_.back().content = IO::digest(text_of(graph));
  }
  if (shapes_.size() < 2) throw Invalid_input("a collection has at least two shapes; give more of them");
  make_names_unique(shapes_);
}

Structural_graph Collection_shapes::graph(std::size_t shape) const
{
  if (const auto kept = graphs_.find(shape); kept != graphs_.end()) return kept->second;
  const std::string path = graph_file(folder_, shapes_[shape].content);
  const std::optional<std::string> text = stored_text(folder_, shapes_[shape].content);
  if (!text) throw Invalid_input(path + ": it was damaged or removed meanwhile; run the command again");
  std::istringstream in(*text);
  return IO::read_structural_graph_json(in, path);
}

std::optional<Segmented_shape> Collection_shapes::model(std::size_t shape, const Common_options& options) const
{
  const Collection_shape& wanted = shapes_[shape];
  if (is_graph_file(wanted.path)) return std::nullopt;
  try {
    Read_model read = read_model(wanted.path, options);
    if (mapped(read.split.shape.parts(), &Shape_part::name) != wanted.parts) return std::nullopt;
    return std::move(read.split.shape);
  } catch (const Invalid_input&) { // removed meanwhile
  }
  return std::nullopt;
}

} // namespace CGAL::Shape_correspondence::cli
