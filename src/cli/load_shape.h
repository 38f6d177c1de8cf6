// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"
#include "io/read/read_objects.h"

#include <CGAL/Shape_correspondence/Role_model.h>
#include <CGAL/Shape_correspondence/Shape_appearance.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>
#include <CGAL/Shape_correspondence/split_parts.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// A model, its parts, and warnings about them.
struct Read_model
{
  Segmented_shape objects; ///< as the file has them
  Part_split split;
  double up_confidence = 1; ///< of the upright axis; 1 if it is given
  bool is_up_estimated = false;
  std::vector<std::string> warnings;
  std::vector<std::vector<std::size_t>> faces; ///< by object and triangle, the number of its face in the file
  std::size_t number_of_faces = 0;             ///< of the file; 0: they have no numbers
};

/// The name of an upright axis: x, y or z, or -x, -y or -z.
std::string axis_name(const Point& axis);

/// Finds the upright axis of the objects and makes parts of them, as the options say. \throw Invalid_input
Read_model model_of_objects(const std::string& path, IO::Model_objects objects, const Common_options& options);

/// Reads a model, finds its upright axis and makes its parts, as the options say. In mode `auto` the files of a folder
/// of part meshes are the parts, and y is up. \throw Invalid_input
Read_model read_model(const std::string& path, const Common_options& options);

/// The upright axis of a model estimated by the roles of its parts; none unless the parts are clearly nearer to
/// labelled ones of a category than with any other axis up, or nearer and the model stands most stably along it.
/// \param graph of the parts of the model
std::optional<Point> up_by_roles(const Read_model& model, const Structural_graph& graph, const Role_model& roles);

/// Sets the upright axis of the objects of a model, estimated by roles, and replaces the warning about it.
void turn_by_roles(const Point& up, Read_model& model);

/// Estimates the upright axis by the roles of the parts, where the model's axis is an estimate, as commands do that
/// abstract the parts. What is wrong with these is for those commands to say.
void find_up_by_roles(const std::string& path, const Common_options& options, Read_model& model);

/// The upright axes of two inputs that are estimated together, by input.
struct Pair_axes
{
  std::array<bool, 2> is_unknown{};
  std::array<std::optional<Point>, 2> by_roles; ///< estimated by roles; empty: not estimated so
};

/// Which of the axes of two inputs are estimated together: if both are models, and no option asks for one of them
/// alone, those that neither options nor files give.
Pair_axes unknown_axes(const std::vector<std::string>& paths, const Common_options& options);

/// Estimates these axes and sets them in the shapes and in `options.of_pair`. \return warnings
std::vector<std::string> find_up_of_pair(const std::vector<std::string>& paths, const Pair_axes& axes,
                                         const std::array<Segmented_shape*, 2>& shapes, Common_options& options);

/// An input of a command: its structural graph, its model where it is one, and the seconds that it took.
struct Loaded_shape
{
  std::string path; ///< names it in messages
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

/// Throws the exception that is being handled: as an `Invalid_input` that names the path, unless it says itself what it
/// is about. Those of libraries, which may fail on any surface, are among them.
[[noreturn]] void rethrow_about(const std::string& path);

/// What `read` returns; its errors name `path`.
template <typename Read>
auto with_path(const std::string& path, const Read& read)
{
  try {
    return read();
  } catch (...) {
    rethrow_about(path);
  }
}

/// Reads a model, or a structural graph from a file that ends in `.json`, and builds the graph of a model.
/// \throw Invalid_input; the message names `path`
Loaded_shape load_shape(const std::string& path, const Common_options& options);

/// The same of a model that was read. \param path names it in messages
Loaded_shape load_shape(const std::string& path, Read_model model, const Common_options& options);

/// The same for several inputs, each with its own options; graphs are built on as many threads as there are.
/// \throw Usage_error if --part-kind names a part that none of them has
std::vector<Loaded_shape> load_shapes(const std::vector<std::string>& paths, const Common_options& options);

/// The same for the source and the target of a correspondence, whose upright axes are estimated together where they are
/// not given. \param options gets the estimated axes \param warnings gets the warnings about them
std::vector<Loaded_shape> load_pair(const std::vector<std::string>& paths, Common_options& options,
                                    std::vector<std::string>& warnings);

/// Reads the meshes that a graph names, where it has no model. \throw Invalid_input if it names none
void complete_surfaces(Loaded_shape& shape);

/// Reads the materials, textures and colours of a model, which `load_shape()` leaves out; graph files have none.
/// \throw Invalid_input if the file has changed since
void read_appearance(Loaded_shape& shape);

/// The warnings about it.
std::vector<std::string> warnings_of_appearance(const Loaded_shape& shape);

/// Adds these to the notes of a table, or prints them on standard error if no table is printed.
void note_appearance(const Loaded_shape& shape, const Common_options& options, std::vector<std::string>& notes);

/// A warning if the parts of a graph were abstracted by another method than is wanted: by mean curvature flow alone, or
/// not. Empty: no warning.
std::string note_on_abstraction(const Structural_graph& graph, bool is_flow_wanted);

/// By index.
std::vector<std::string> part_names(const Structural_graph& graph);

/// Whether a path is that of a file of a structural graph.
bool is_graph_file(const std::string& path);

} // namespace CGAL::Shape_correspondence::cli
