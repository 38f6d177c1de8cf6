// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"

#include <CGAL/Shape_correspondence/IO/read_part_labels.h>
#include <CGAL/Shape_correspondence/Role_model.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

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

/// Loads generated shapes likewise, but without curves, sheets and symmetries, as only features of parts are needed.
std::vector<Labelled_model> load_generated_models(const std::vector<std::string>& folders,
                                                  const Common_options& options);

/// The role model in a file; empty: the one that comes with the program.
std::shared_ptr<const Role_model> role_model_of(const std::string& file);

/// Adds the labelled shapes of a folder, if one is given, to a role model, see `extend_role_model()`: those of
/// categories in the model, and those of new categories with at least three examples. If all are of one category, and
/// none is given, that category is selected.
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
