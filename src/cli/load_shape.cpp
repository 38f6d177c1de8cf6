// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/load_shape.h"
#include "base/for_each_index.h"
#include "cli/clock.h"
#include "cli/outputs.h"
#include "cli/progress_bar.h"
#include "io/input_file.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_cache.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_formats.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/estimate_up.h>
#include <CGAL/Shape_correspondence/segment_mesh.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <new>

namespace CGAL::Shape_correspondence::cli {
namespace {

namespace fs = std::filesystem;

bool has_extension(const std::string& path, const char* wanted)
{
  return IO::lower_extension(path) == wanted && !fs::is_directory(path);
}

bool says_up(const std::string& model_path) { return has_extension(model_path, ".dae"); }

void load_graph(const std::string& path, const Common_options& common, const Structure_options& options,
                Loaded_shape& shape)
{
  const double begin = now();
  std::ifstream in = IO::open_input(path);
  if (has_extension(path, ".xml") && common.finds_up())
    throw Invalid_input("a graph without surfaces does not tell which way is up; give --up x, y or z");
  shape.graph = has_extension(path, ".xml") ? IO::read_structural_graph_xml(in, path, common.up_vector(), options)
                                            : IO::read_structural_graph_json(in, path, options);
  shape.read_seconds = now() - begin;
}

/// A model, and what had to be said while it was read.
struct Read_model
{
  Segmented_shape shape;
  std::vector<std::string> warnings;
};

Read_model read_model(const std::string& path, const Common_options& common)
{
  std::vector<std::string> warnings;
  Segmented_shape model = IO::read_segmented_shape(path, common.up_vector(), &warnings);
  if (common.finds_up() && !says_up(path)) model.set_up(estimate_up(model));
  if (!common.segment) return {std::move(model), std::move(warnings)};
  if (model.parts().size() > 1)
    throw Invalid_input("it has " + std::to_string(model.parts().size()) + " parts already; leave --segment out");
  Mesh_segmentation segmentation = segment_mesh(model.parts()[0].mesh, {}, model.name(), model.up());
  Read_model result{std::move(segmentation.shape), std::move(warnings)};
  if (segmentation.pieces_left_out > 0)
    result.warnings.push_back("Pieces of the mesh that the segmentation left out, since they have no area: " +
                              std::to_string(segmentation.pieces_left_out) + ".");
  return result;
}

void build_graph(const Common_options& common, const Structure_options& options, Loaded_shape& shape)
{
  Structure_times times;
  shape.graph = common.threads == 1
                    ? build_structural_graph<CGAL::Sequential_tag>(*shape.model, options, &times)
                    : build_structural_graph<CGAL::Parallel_if_available_tag>(*shape.model, options, &times);
  shape.abstraction_seconds = times.abstraction;
  shape.structure_seconds = times.structure;
  if (!common.segment) return;
  Shape_structure& structure = Shape_correspondence::structure(shape.graph);
  structure.automatic_parts = true;
  structure.warnings.insert(structure.warnings.begin(), "The parts come from an automatic segmentation.");
}

void add_warning_of_up(Loaded_shape& shape)
{
  const Point up = shape.model->up();
  const char axis = up.x() > 0.5 ? 'x' : up.y() > 0.5 ? 'y' : 'z';
  structure(shape.graph)
      .warnings.push_back(std::string("The upright axis was taken to be ") + axis +
                          ", along which the model stands best; if that is wrong, say it with --up.");
}

std::optional<Structural_graph> cached_graph(const std::string& content, const Common_options& common)
{
  if (common.cache.empty()) return std::nullopt;
  try {
    const IO::Structural_graph_cache cache(common.cache);
    std::optional<Structural_graph> graph = cache.find(content);
    if (!graph && cache.is_damaged(content))
      warn(common, common.cache + ": a graph in it is damaged; it is made again");
    return graph;
  } catch (const Invalid_input& error) {
    warn(common, error.what());
    return std::nullopt;
  }
}

/// What cannot be kept is not the worse for that.
void cache_graph(const Structural_graph& graph, const Common_options& common)
{
  if (common.cache.empty()) return;
  try {
    IO::Structural_graph_cache(common.cache).insert(graph);
  } catch (const Invalid_input& error) {
    warn(common, std::string(error.what()) + "; the graph is not kept");
  }
}

void load_model(const std::string& path, const Common_options& common, const Structure_options& options,
                Loaded_shape& shape)
{
  const double begin = now();
  Read_model model = read_model(path, common);
  shape.model = std::move(model.shape);
  const std::string content = IO::content_hash(*shape.model, options);
  std::optional<Structural_graph> known = cached_graph(content, common);
  shape.read_seconds = now() - begin;
  if (known) {
    shape.graph = std::move(*known);
  } else {
    build_graph(common, options, shape);
    structure(shape.graph).content = content;
    cache_graph(shape.graph, common);
  }
  std::vector<std::string>& warnings = structure(shape.graph).warnings;
  warnings.insert(warnings.end(), model.warnings.begin(), model.warnings.end());
  if (common.finds_up() && !says_up(path)) add_warning_of_up(shape);
}

} // namespace

bool is_json_file(const std::string& path) { return has_extension(path, ".json"); }

bool is_graph_file(const std::string& path) { return is_json_file(path) || has_extension(path, ".xml"); }

Loaded_shape load_shape(const std::string& path, const Common_options& common)
{
  Progress_bar bar(common, path);
  Structure_options options;
  options.abstraction = common.abstraction;
  options.symmetry = common.symmetry_options();
  options.contacts.tolerance = common.contact_tolerance;
  options.abstraction.progress = [&bar](std::size_t done, std::size_t total) { bar.show(done, total); };
  Loaded_shape shape;
  try {
    if (is_graph_file(path))
      load_graph(path, common, options, shape);
    else
      load_model(path, common, options, shape);
  } catch (const Invalid_input& error) {
    const std::string message = error.what();
    throw Invalid_input(message.rfind(path, 0) == 0 ? message : path + ": " + message);
  } catch (const std::bad_alloc&) {
    throw Invalid_input(path + ": it needs more memory than there is");
  }
  return shape;
}

std::vector<Loaded_shape> load_shapes(const std::vector<std::string>& paths, const Common_options& options)
{
  std::vector<Loaded_shape> shapes(paths.size());
  std::vector<std::exception_ptr> failures(paths.size());
  internal::for_each_index<CGAL::Parallel_if_available_tag>(paths.size(), [&](std::size_t i) {
    try {
      shapes[i] = load_shape(paths[i], options);
    } catch (...) {
      failures[i] = std::current_exception();
    }
  });
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  return shapes;
}

std::vector<std::string> warnings_of(const std::vector<std::string>& paths, const std::vector<Loaded_shape>& shapes)
{
  std::vector<std::string> result;
  for (std::size_t i = 0; i < paths.size(); ++i)
    for (const std::string& warning : structure(shapes[i].graph).warnings)
      result.push_back(paths[i] + ": " + warning);
  return result;
}

} // namespace CGAL::Shape_correspondence::cli
