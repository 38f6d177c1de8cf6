// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"

#include <CGAL/Shape_correspondence/split_parts.h>

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// A model, its parts, and what has to be said of them.
struct Read_model
{
  Segmented_shape objects; ///< as the file has them
  Part_split split;
  double up_confidence = 1; ///< of the upright axis; 1 if it is given
  std::vector<std::string> warnings;
};

/// Of an upright axis: x, y or z.
char axis_name(const Point& axis);

/// The objects of a model, as its file has them.
struct Model_objects
{
  Segmented_shape shape;
  std::vector<std::string> warnings; ///< of the reader
};

/// \throw Invalid_input
Model_objects read_objects(const std::string& path, const Common_options& options);

/// Finds the upright axis of the objects and makes parts of them, as the options say. \throw Invalid_input
Read_model model_of_objects(const std::string& path, Model_objects objects, const Common_options& options);

/// Reads a model, finds its upright axis and makes its parts, as the options say. In mode `auto` the files of a folder
/// of part meshes are the parts, and y is up. \throw Invalid_input
Read_model read_model(const std::string& path, const Common_options& options);

/// Whether the upright axes of two inputs are found together: both are models, of one kind, and no option, file or
/// folder says the axis of one of them.
bool finds_up_of_pair(const std::vector<std::string>& paths, const Common_options& options);

/// Finds these axes and puts them into the shapes and into `options.of_pair`. \return what has to be said of it
std::vector<std::string> find_up_of_pair(const std::vector<std::string>& paths, std::vector<Model_objects>& models,
                                         Common_options& options);

} // namespace CGAL::Shape_correspondence::cli
