// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/load_shape.h"
#include "base/for_each_index.h"
#include "cli/run.h"
#include "io/system/input_file.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/IO/read_features.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_cache.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <new>
#include <utility>

namespace CGAL::Shape_correspondence::cli {
namespace {

namespace fs = std::filesystem;

bool has_extension(const std::string& path, const char* wanted)
{
  return IO::lower_extension(path) == wanted && !fs::is_directory(path);
}

/// Whether the parts were abstracted by mean curvature flow alone; empty if their reports do not show that.
std::optional<bool> is_of_flow(const Structural_graph& graph)
{
  using Method = Abstraction_report::Method;
  for (const Part_abstraction& part : structure(graph).parts) {
    if (part.report.method == Method::MESO_SKELETON) return true;
    if (part.report.method == Method::MEDIAL_AXIS || part.report.method == Method::PRISM) return false;
  }
  return std::nullopt;
}

Loaded_shape read_graph(const std::string& path, const Common_options& common)
{
  if (!common.features.empty())
    throw Invalid_input(path + ": " + common.features +
                        " has features of faces or vertices, which a structural graph does not have; give the model "
                        "that it was built from");
  const Structure_options& options = common.structure;
  const double begin = now();
  Loaded_shape shape;
  shape.path = path;
  shape.reading = common.reading_options();
  std::ifstream in = IO::open_input(path);
  shape.graph = IO::read_structural_graph_json(in, path, options);
  const bool is_flow_wanted = options.abstraction.abstractor.target<Mean_curvature_abstraction>() != nullptr;
  if (const std::string note = note_on_abstraction(shape.graph, is_flow_wanted); !note.empty())
    structure(shape.graph).warnings.push_back(note);
  shape.read_seconds = now() - begin;
  return shape;
}

/// Checks the number of parts. \throw Invalid_input if there are fewer than two
void check_has_parts(const Part_split& split, const Common_options& common)
{
  if (split.shape.parts().size() > 1) return;
  std::string why = "of one piece, which has no segments either; cut it into objects in a program for modelling";
  if (split.pieces.size() > 1)
    why = "of " + std::to_string(split.pieces.size()) + " pieces; " +
          (common.parts_from.empty() ? "say --parts components" : "name several parts in " + common.parts_from);
  else if (!split.by_segments && common.parts != Part_splitting::COMPONENTS)
    why = "of one piece; use --parts segments";
  throw Invalid_input("it has only one part, " + why + ": correspondences are between shapes of two parts or more");
}

/// Calls `use` with the cache, if there is one; failures become warnings. \param consequence ends the warning
template <typename Use>
void with_cache(const Common_options& common, const std::string& consequence, const Use& use)
{
  if (common.cache.empty()) return;
  try {
    use(IO::Structural_graph_cache(common.cache));
  } catch (const Invalid_input& error) {
    warn(common, error.what() + consequence);
  }
}

/// Builds the graph of a model, or finds it in the cache.
Structural_graph graph_of(const Segmented_shape& model, const Common_options& common, const Structure_options& options,
                          Loaded_shape& shape)
{
  const double begin = now();
  const std::string content = IO::content_hash(model, options);
  std::optional<Structural_graph> known;
  with_cache(common, "", [&](const IO::Structural_graph_cache& cache) {
    known = cache.find(content);
    if (!known && cache.is_damaged(content))
      warn(common, common.cache + ": a graph in it is damaged; it is made again");
  });
  shape.read_seconds += now() - begin;
  if (known) return std::move(*known);
  Structure_times times;
  Structural_graph graph = build_structural_graph<CGAL::Parallel_if_available_tag>(model, options, &times);
  shape.abstraction_seconds = times.abstraction;
  shape.structure_seconds = times.structure;
  structure(graph).content = content;
  with_cache(common, "; the graph is not kept", [&](const auto& cache) { cache.insert(graph); });
  return graph;
}

/// Throws `Usage_error` if an option names a part that none of the shapes has.
void check_part_kinds(const Common_options& options, const std::vector<Loaded_shape>& shapes)
{
  std::vector<std::string> parts;
  for (const Loaded_shape& shape : shapes)
    append(parts, part_names(shape.graph));
  for (const auto& [part, kind] : options.structure.abstraction.part_kinds)
    if (std::find(parts.begin(), parts.end(), part) == parts.end())
      throw Usage_error("--part-kind: there is no part '" + part + "'" + suggestion(part, parts) +
                        "; `shape_correspondence graph` lists the parts");
}

} // namespace

std::string note_on_abstraction(const Structural_graph& graph, bool is_flow_wanted)
{
  if (is_of_flow(graph) != !is_flow_wanted) return "";
  return is_flow_wanted
             ? "The parts of this graph were not abstracted by mean curvature flow, as the paper's method has it."
             : "The parts of this graph were abstracted by mean curvature flow, as for the paper's method alone.";
}

std::string message_about(const std::string& path, const std::string& message)
{
  return message.rfind(path, 0) == 0 ? message : path + ": " + message;
}

bool is_graph_file(const std::string& path) { return has_extension(path, ".json"); }

void rethrow_about(const std::string& path)
{
  try {
    throw;
  } catch (const Invalid_input& error) {
    throw Invalid_input(message_about(path, error.what()));
  } catch (const std::bad_alloc&) {
    throw Invalid_input(path + ": it needs more memory than there is; " + IO::remedy::make_smaller);
  } catch (const Usage_error&) {
    throw;
  } catch (const fs::filesystem_error&) {
    throw;
  } catch (const std::exception& error) {
    const std::string what = error.what();
    throw Invalid_input(path + ": a computation on its surface failed (" + what.substr(0, what.find('\n')) +
                        "); repair or remesh the model in a program for modelling");
  }
}

Loaded_shape load_shape(const std::string& path, const Common_options& options)
{
  if (is_graph_file(path)) return with_path(path, [&] { return read_graph(path, options); });
  const double begin = now();
  Read_model model = read_model(path, options);
  const double seconds = now() - begin;
  Loaded_shape shape = load_shape(path, std::move(model), options);
  shape.read_seconds += seconds;
  return shape;
}

Loaded_shape load_shape(const std::string& path, Read_model model, const Common_options& common)
{
  Progress_bar bar(common, path);
  Structure_options options = common.structure;
  options.abstraction.progress = [&bar](std::size_t done, std::size_t total) { bar.show(done, total); };
  Loaded_shape shape;
  with_path(path, [&] {
    check_has_parts(model.split, common);
    shape.path = path;
    shape.reading = common.reading_options();
    shape.split = std::move(model.split);
    shape.model = shape.split.shape;
    shape.graph = graph_of(*shape.model, common, options, shape);
    // Not from the cached graph, since the same parts may have been found in another way
    structure(shape.graph).automatic_parts = shape.split.by_segments;
    std::vector<std::string>& warnings = structure(shape.graph).warnings;
    warnings.insert(warnings.begin(), model.warnings.begin(), model.warnings.end());
  });
  if (common.features.empty()) return shape;
  structure(shape.graph).features = with_path(common.features, [&] { // the features are not cached either
    return IO::features_of_parts(IO::read_features(common.features), path, shape.split, shape.reading);
  });
  return shape;
}

std::vector<Loaded_shape> load_shapes(const std::vector<std::string>& paths, const Common_options& options)
{
  std::vector<Loaded_shape> shapes(paths.size());
  // Graph files are read in sequence, which takes less time than starting threads
  const bool are_graphs = std::all_of(paths.begin(), paths.end(), is_graph_file);
  internal::for_each_index(paths.size(), !are_graphs,
                           [&](std::size_t i) { shapes[i] = load_shape(paths[i], options.of_input(i)); });
  check_part_kinds(options, shapes);
  return shapes;
}

std::vector<Loaded_shape> load_pair(const std::vector<std::string>& paths, Common_options& options,
                                    std::vector<std::string>& warnings)
{
  const double begin = now();
  std::vector<Read_model> models = read_pair(paths, options, warnings);
  if (models.empty()) return load_shapes(paths, options);
  const double seconds = now() - begin;
  std::vector<Loaded_shape> shapes(2);
  internal::for_each_index<CGAL::Parallel_if_available_tag>(
      2, [&](std::size_t i) { shapes[i] = load_shape(paths[i], std::move(models[i]), options.of_input(i)); });
  shapes[0].read_seconds += seconds; // the two were read at the same time
  check_part_kinds(options, shapes);
  return shapes;
}

void complete_surfaces(Loaded_shape& shape)
{
  if (!shape.model && has_extension(shape.path, ".json"))
    shape.model = IO::read_part_meshes(shape.path, shape.graph, shape.reading);
  if (!shape.model)
    throw Invalid_input(shape.path + ": it is a structural graph without surfaces, which a blend is made of; give the "
                                     "model that it was built from, or name the parts' meshes in it (key \"mesh\")");
}

void read_appearance(Loaded_shape& shape)
{
  shape.appearance = {};
  if (!shape.model || is_graph_file(shape.path) || shape.split.pieces.empty() || !fs::exists(shape.path)) return;
  Shape_appearance of_objects;
  const Segmented_shape objects =
      IO::read_shape_and_appearance(shape.path, of_objects, Point::UnitY(), nullptr, shape.reading);
  for (const Model_piece& piece : shape.split.pieces)
    if (piece.object >= objects.parts().size())
      throw Invalid_input(shape.path + ": the file has changed since it was read; try again");
  of_objects.warnings = mapped(of_objects.warnings, in_program_words);
  shape.appearance = appearance_of_parts(objects, of_objects, shape.split);
}

std::vector<std::string> warnings_of_appearance(const Loaded_shape& shape)
{
  return about(shape.path, shape.appearance.warnings);
}

void note_appearance(const Loaded_shape& shape, const Common_options& options, std::vector<std::string>& notes)
{
  const std::vector<std::string> warnings = warnings_of_appearance(shape);
  if (options.prints_table()) return append(notes, warnings);
  for (const std::string& warning : warnings)
    warn(options, warning);
}

std::vector<std::string> part_names(const Structural_graph& graph)
{
  return mapped(structure(graph).parts, &Part_abstraction::name);
}

} // namespace CGAL::Shape_correspondence::cli
