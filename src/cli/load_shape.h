// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"
#include "io/read/read_objects.h"

#include <CGAL/Shape_correspondence/Role_model.h>
#include <CGAL/Shape_correspondence/Shape_appearance.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>
#include <CGAL/Shape_correspondence/split_parts.h>

#include <optional>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// A model, its parts, and warnings about them.
struct Read_model
{
  Segmented_shape objects; ///< the objects of the file
  Part_split split;
  double up_confidence = 1; ///< confidence of the upright axis; 1 if it is given
  bool is_up_estimated = false;
  std::vector<std::string> warnings;
  std::vector<std::vector<std::size_t>> faces; ///< by object and triangle, the index of its face in the file
  std::size_t number_of_faces = 0;             ///< number of faces in the file; 0: they have no indices
};

/// The name of an upright axis: x, y, z, -x, -y or -z.
std::string axis_name(const Point& axis);

/// Finds the upright axis of the objects and splits them into parts, according to the options. With `options.roles`, an
/// axis that was estimated is corrected by the roles of the parts, if they are clear. \throw Invalid_input
Read_model model_of_objects(const std::string& path, IO::Model_objects objects, const Common_options& options);

/// Reads a model, finds its upright axis and splits it into parts, according to the options. In mode `auto` the files
/// of a folder of part meshes are the parts, and y is up. \throw Invalid_input
Read_model read_model(const std::string& path, const Common_options& options);

/// Reads two models, and estimates together the upright axes that neither options nor files give. \return empty,
/// without reading the models, if there is no such axis
/// \param options receives the estimated axes \param warnings receives the warnings about them
std::vector<Read_model> read_pair(const std::vector<std::string>& paths, Common_options& options,
                                  std::vector<std::string>& warnings);

/// An input of a command: its structural graph, its model if it is one, and the seconds taken.
struct Loaded_shape
{
  std::string path; ///< names the input in messages
  Structural_graph graph;
  std::optional<Segmented_shape> model;
  Part_split split;                 ///< how the model was split; empty for a graph file
  Shape_appearance appearance = {}; ///< appearance of the parts; empty until it is read
  IO::Reading_options reading;      ///< options used to read the model and its files
  double read_seconds = 0;
  double abstraction_seconds = 0;
  double structure_seconds = 0;

  const Segmented_shape* model_pointer() const { return model ? &*model : nullptr; }
};

/// The message, prefixed with the path unless it already starts with it.
std::string message_about(const std::string& path, const std::string& message);

/// Rethrows the current exception, also one of a library, which may fail on any surface, as an `Invalid_input` whose
/// message starts with the path; a `Usage_error` or an error of the file system as it is.
[[noreturn]] void rethrow_about(const std::string& path);

/// The result of `read`; its errors name `path`.
template <typename Read>
auto with_path(const std::string& path, const Read& read)
{
  try {
    return read();
  } catch (...) {
    rethrow_about(path);
  }
}

/// Reads a model and builds its structural graph, or reads the graph from a file that ends in `.json`.
/// \throw Invalid_input, naming `path`
Loaded_shape load_shape(const std::string& path, const Common_options& options);

/// Builds the structural graph of a model that was read. \param path names the model in messages
Loaded_shape load_shape(const std::string& path, Read_model model, const Common_options& options);

/// Loads several inputs, each with its own options; graphs are built in parallel.
/// \throw Usage_error if --part-kind names a part that none of them has
std::vector<Loaded_shape> load_shapes(const std::vector<std::string>& paths, const Common_options& options);

/// Loads the source and the target of a correspondence; upright axes that are not given are estimated together.
/// \param options receives the estimated axes \param warnings receives the warnings about them
std::vector<Loaded_shape> load_pair(const std::vector<std::string>& paths, Common_options& options,
                                    std::vector<std::string>& warnings);

/// Reads the meshes named by a graph that has no model. \throw Invalid_input if it names none
void complete_surfaces(Loaded_shape& shape);

/// Reads the materials, textures and colours of a model, which `load_shape()` leaves out; graph files have none.
/// \throw Invalid_input if the file has changed
void read_appearance(Loaded_shape& shape);

std::vector<std::string> warnings_of_appearance(const Loaded_shape& shape);

/// Adds the warnings about a shape's appearance to the notes of a table, or prints them if there is no table.
void note_appearance(const Loaded_shape& shape, const Common_options& options, std::vector<std::string>& notes);

/// A warning if the parts of a graph were not abstracted by the wanted method, flow or default; empty: no warning.
std::string note_on_abstraction(const Structural_graph& graph, bool is_flow_wanted);

std::vector<std::string> part_names(const Structural_graph& graph);

bool is_graph_file(const std::string& path);

} // namespace CGAL::Shape_correspondence::cli
