// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"

#include <CGAL/Shape_correspondence/Role_model.h>

#include <iosfwd>
#include <string>

namespace CGAL::Shape_correspondence::cli {

/// The roles of a shape's parts. \param path names the shape in messages \param category empty: the likeliest
/// \throw Invalid_input if the shape is of no category of the model
Part_roles predicted_roles(const std::string& path, const Structural_graph& graph, const Role_model& model,
                           const std::string& category);

/// Writes the likeliest label of every part, in the form of `labels.json`.
void write_labels_json(std::ostream& out, const Structural_graph& graph, const Part_roles& found);

/// What labels are predicted by.
struct Label_options
{
  std::string roles;    ///< file of the role model; empty: the one that comes with the program
  std::string examples; ///< folder of labelled shapes that are learned in addition; empty: none
  std::string category; ///< of the shape; empty: the one that it is like
};

/// Prints the likeliest role of every part of a shape, and writes them in the form of `labels.json`.
/// \param output file of the labels; - is standard output; empty: none
/// \throw Invalid_input if the shape is of no category of the model
void label_shape(const std::string& path, const Label_options& options, const std::string& output,
                 const Common_options& common);

} // namespace CGAL::Shape_correspondence::cli
