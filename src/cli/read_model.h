// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"
#include "io/read/read_objects.h"

#include <CGAL/Shape_correspondence/Role_model.h>
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
};

/// The name of an upright axis: x, y or z.
char axis_name(const Point& axis);

using IO::Model_objects;

/// \throw Invalid_input
Model_objects read_objects(const std::string& path, const Common_options& options);

/// Finds the upright axis of the objects and makes parts of them, as the options say. \throw Invalid_input
Read_model model_of_objects(const std::string& path, Model_objects objects, const Common_options& options);

/// Reads a model, finds its upright axis and makes its parts, as the options say. In mode `auto` the files of a folder
/// of part meshes are the parts, and y is up. \throw Invalid_input
Read_model read_model(const std::string& path, const Common_options& options);

/// The upright axis of a model estimated by the roles of its parts; none unless the parts are clearly nearer to
/// labelled ones of a category than with any other axis up, or nearer and the model stands most stably along it.
/// \param graph of the parts of the model
std::optional<Point> up_by_roles(const Read_model& model, const Structural_graph& graph, const Role_model& roles);

/// Sets the upright axis of the objects of a model, estimated by roles, and replaces the warning about it.
void turn_by_roles(const Point& up, Read_model& model);

/// Whether the upright axes of two inputs are estimated together: both are models, and no option, file or folder gives
/// the axis of one of them.
bool finds_up_of_pair(const std::vector<std::string>& paths, const Common_options& options);

/// The upright axes of two inputs that are estimated together, by input.
struct Pair_axes
{
  std::array<bool, 2> is_unknown{};
  std::array<std::optional<Point>, 2> by_roles; ///< estimated by roles; empty: not estimated so
};

/// Which of the axes of two inputs are given by neither options nor files.
Pair_axes unknown_axes(const std::vector<std::string>& paths, const Common_options& options);

/// Estimates these axes and sets them in the shapes and in `options.of_pair`. \return warnings
std::vector<std::string> find_up_of_pair(const std::vector<std::string>& paths, const Pair_axes& axes,
                                         const std::array<Segmented_shape*, 2>& shapes, Common_options& options);

} // namespace CGAL::Shape_correspondence::cli
