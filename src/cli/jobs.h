// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"
#include "cli/load_shape.h"

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/IO/read_part_labels.h>
#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/Role_model.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>
#include <CGAL/Shape_correspondence/transfer_appearance.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <iosfwd>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

// The work of the commands on loaded shapes; the Python module calls these functions, too

/// Correspondences of two shapes, the best first, and the seconds that each phase took.
struct Matched_shapes
{
  std::vector<Correspondence> ranked;
  IO::Match_seconds seconds;
};

Matched_shapes match_shapes(const Loaded_shape& source, const Loaded_shape& target, const Search_options& options);

/// Writes a correspondence as a table, in lines of 80 characters if names allow: one row for each block
/// (`correspondence_blocks()`) with role, operation and confidence, then unmatched parts, energy and distance.
/// \param verbose whether to list all parts of large blocks
void write_match_table(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                       const Structural_graph& target, bool verbose);

struct Blend_output
{
  std::string path;
  std::string format = "obj";
  std::string schedule = "best";
  std::optional<Blend_size> size; ///< empty: see `likely_size()`
  std::string colours = "auto";   ///< auto, materials or match
  int frames = 25;
  double at = std::numeric_limits<double>::quiet_NaN(); ///< time of the only shape to write; NaN: the whole blend
  bool solid = false;                                   ///< whether that shape is converted to one closed surface

  bool is_one_shape() const { return !std::isnan(at); }
  bool is_page() const;
  /// Whether the output is a file rather than a folder.
  bool is_file() const;
  /// Whether an output may show the models' own materials.
  bool may_show_materials() const;
};

void add_output_options(Option_table::Group& add, Blend_output& output);

/// Checks the name of the output. \throw Usage_error if it contradicts other options
void check_output(const Blend_output& output);

Blend_options blend_options(const Blend_output& output);

/// Writes the blend. \param appearance appearance of the models; null: corresponding parts have one colour
/// \param finish writes related files; called after a file is written, or before a folder gets its final name, so that
/// all files appear at once
void write_blend(const Blend_output& output, const Shape_blend& blend, const Correspondence& correspondence,
                 const IO::Blend_appearance* appearance, const std::function<void()>& finish);

/// Removes pairs of confidence below `least`. \return a warning for each of them
std::vector<std::string> remove_unlikely(Correspondence& correspondence, double least, const Loaded_shape& source,
                                         const Loaded_shape& target);

/// The default size of the frames; `SAME`, with a warning, for shapes that seem to have different units.
Blend_size likely_size(const Loaded_shape& source, const Loaded_shape& target, std::vector<std::string>& warnings);

/// Adds a warning of the parts that are exchanged for their counterparts, with the reasons why they do not morph.
void warn_of_obstacles(const Shape_blend& blend, const Loaded_shape& source, const Loaded_shape& target,
                       std::vector<std::string>& warnings);

/// What to transfer, and the output.
struct Transfer_request
{
  std::string output; ///< FILE.glb, FILE.obj or FILE.ply
  std::string labels; ///< `parts`, or a file of labels of the source; empty: transfer the appearance
  Transfer_options options;
};

struct Transferred_looks
{
  Transferred_appearance result;
  std::vector<std::string> labels; ///< names of the labels; empty: the appearance was transferred
  std::vector<std::string> warnings;
};

/// Transfers the appearance or labels along a correspondence, and writes the target with them. \throw Invalid_input
Transferred_looks transfer_looks(Loaded_shape& source, Loaded_shape& target, const Correspondence& correspondence,
                                 const Transfer_request& request);

/// Writes what every target part received, in the format `shape_correspondence/transfer`, version 1.
void write_transfer_json(std::ostream& out, const Loaded_shape& source, const Loaded_shape& target,
                         const Transfer_request& request, const Transferred_looks& transferred);

/// A result, and the file by which messages and reports name it.
struct Named_result
{
  std::string file;
  IO::Named_correspondence correspondence;
};

std::vector<Named_result> read_results(const std::vector<std::string>& inputs);

/// Reads the labels of all shapes in files and folders. \throw Invalid_input
std::vector<IO::Labelled_shape> read_labels(const std::vector<std::string>& paths);

/// Scores the results. \throw Invalid_input if a result has shapes without labels
void write_evaluation_json(std::ostream& out, const std::vector<Named_result>& results,
                           const std::vector<IO::Labelled_shape>& shapes);

/// A shape with its labels.
struct Labelled_model
{
  std::string folder; ///< given folder that contains it
  IO::Labelled_shape labels;
  Structural_graph graph;
  std::vector<Part_label> part_labels; ///< indexed by part of the graph
};

/// Loads all labelled shapes of folders of SHAPE/ or CATEGORY/SHAPE/ with `labels.json` and `parts/`.
/// \throw Invalid_input if one is unusable, or a part has no label
std::vector<Labelled_model> load_labelled_models(const std::vector<std::string>& folders,
                                                 const Common_options& options);

/// Like `load_labelled_models()`, but without curves, sheets and symmetries, as only features of parts are needed.
std::vector<Labelled_model> load_generated_models(const std::vector<std::string>& folders,
                                                  const Common_options& options);

/// The role model in a file; empty: the one that comes with the program.
std::shared_ptr<const Role_model> role_model_of(const std::string& file);

/// Adds the labelled shapes of a folder, if one is given, to a role model, see `extend_role_model()`: those of
/// categories in the model, and those of new categories with at least three examples. If all are of one category, and
/// `category` is empty, it becomes that category.
/// \param model null: no model so far \param always_new whether a new category needs no minimum number of examples
/// \return warnings about shapes that are left out
std::vector<std::string> add_examples(const std::string& folder, const Common_options& options,
                                      std::shared_ptr<const Role_model>& model, std::string& category,
                                      bool always_new = false);

/// The data from which roles are learned.
struct Role_training
{
  std::vector<std::string> folders;   ///< folders of labelled shapes
  std::vector<std::string> generated; ///< folders of generated shapes, which weigh less
  Role_training_options options;
};

struct Trained_roles
{
  std::vector<Labelled_model> models; ///< the given shapes, then the generated ones
  std::size_t number_of_real = 0;
  Role_model model;
};

/// Learns roles from folders, see `train_role_model()`; used by `roles train` and Python.
Trained_roles train_roles(const Role_training& training, const Common_options& options);

/// The roles of a shape's parts. \param path names the shape in messages \param category empty: the most probable one
/// \throw Invalid_input if the shape belongs to no category of the model
Part_roles predicted_roles(const std::string& path, const Structural_graph& graph, const Role_model& model,
                           const std::string& category);

/// Writes the most probable label of every part in the format of `labels.json`.
void write_labels_json(std::ostream& out, const Structural_graph& graph, const Part_roles& found);
} // namespace CGAL::Shape_correspondence::cli
