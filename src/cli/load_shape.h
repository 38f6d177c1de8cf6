// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"
#include "cli/read_model.h"

#include <CGAL/Shape_correspondence/Shape_appearance.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>
#include <CGAL/Shape_correspondence/split_parts.h>

#include <optional>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// An input of a command: its structural graph, its model where it is one, and the seconds that it took.
struct Loaded_shape
{
  Structural_graph graph;
  std::optional<Segmented_shape> model;
  Part_split split;                 ///< how the model got its parts; of a graph file empty
  Shape_appearance appearance = {}; ///< of the model's parts, where it was read
  IO::Reading_options reading;      ///< with which the model was read, and files that it names are
  double read_seconds = 0;
  double abstraction_seconds = 0;
  double structure_seconds = 0;

  const Segmented_shape* model_pointer() const { return model ? &*model : nullptr; }
};

/// The message, prefixed with the path unless it begins with it.
std::string message_about(const std::string& path, const std::string& message);

/// Reads a model, or a structural graph from a file that ends in `.json` or `.xml`, and builds the graph of a model.
/// With `Common_options::graphs_suffice`, a folder of part meshes that the cache knows has no model.
/// \throw Invalid_input; the message names `path`
Loaded_shape load_shape(const std::string& path, const Common_options& options);

/// The same of a model that was read. \param path names it in messages
Loaded_shape load_shape(const std::string& path, Read_model model, const Common_options& options);

/// The same for several inputs, each with its own options; graphs are built on as many threads as there are.
std::vector<Loaded_shape> load_shapes(const std::vector<std::string>& paths, const Common_options& options);

/// The same for the source and the target of a correspondence, whose upright axes are estimated together where they are
/// not given. \param options gets the estimated axes \param warnings gets the warnings about them
std::vector<Loaded_shape> load_pair(const std::vector<std::string>& paths, Common_options& options,
                                    std::vector<std::string>& warnings);

/// Throws `Usage_error` if --part-kind names a part that is not in `parts`, the parts of all inputs.
void check_part_kinds(const Common_options& options, const std::vector<std::string>& parts);

/// Reads the meshes that a graph names, where it has no model. \throw Invalid_input if it names none
void complete_surfaces(const std::string& path, Loaded_shape& shape);

/// Reads the materials, textures and colours of a model, which `load_shape()` leaves out; graph files have none.
/// \throw Invalid_input if the file has changed since
void read_appearance(const std::string& path, Loaded_shape& shape);

/// Adds the warnings about it to the notes of a table, or prints them on standard error if no table is printed.
void note_appearance(const std::string& path, const Loaded_shape& shape, const Common_options& options,
                     std::vector<std::string>& notes);

/// The warnings of the graphs of inputs, each after the path of its input.
std::vector<std::string> warnings_of(const std::vector<std::string>& paths, const std::vector<Loaded_shape>& shapes);

/// A warning if the parts of a graph were abstracted by another method than is wanted: by mean curvature flow alone, or
/// not. Empty: no warning.
std::string note_on_abstraction(const Structural_graph& graph, bool is_flow_wanted);

/// By index.
std::vector<std::string> part_names(const Structural_graph& graph);

/// Whether a path is that of a file that ends in `.json`, and whether it is that of a structural graph.
bool is_json_file(const std::string& path);
bool is_graph_file(const std::string& path);

} // namespace CGAL::Shape_correspondence::cli
