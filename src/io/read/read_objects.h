// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/read/model_parts.h"

#include <CGAL/Shape_correspondence/Role_model.h>
#include <CGAL/Shape_correspondence/split_parts.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// The beginning of the warning that a list of labels beside a model cannot be used.
constexpr const char* labels_left_out = "The labels of faces beside the model were left out: ";

/// The objects of a model, as its files have them.
struct Model_objects
{
  Segmented_shape shape;
  /// By object and triangle, the number of the material, as in `Part_splitting_options`; empty if no object has
  /// several, and for a folder.
  std::vector<std::vector<int>> materials;
  std::vector<std::string> warnings; ///< of the reader
  bool says_up = false;              ///< whether the files say which axis is up, which the shape then has
  bool are_labelled = false;         ///< they are labels of faces
  /// By object and triangle, the number of its face in the file, and how many there are; empty for a folder.
  std::vector<std::vector<std::size_t>> faces = {};
  std::size_t number_of_faces = 0;
  Shape_appearance appearance = {}; ///< from the model's own file, or completed from the files that it names
};

/// Completes materials and textures from the files that a model file names, and checks them.
using Complete_looks =
    std::function<void(const std::string& file, Model_content& content, std::vector<std::string>& warnings)>;

/// The robot (URDF) that a folder is of: the one such file in it, or in its folder `urdf` or `robots`.
std::optional<std::string> robot_in(const std::string& folder);

/// The same as `read_segmented_shape()`, with materials. \param complete may be empty
Model_objects read_objects(const std::string& path, const Point& up, const Reading_options& options = {},
                           const Complete_looks& complete = {});

/// A digest of all that `read_objects()` reads of a folder of part meshes: the names and the bytes of its files, and
/// the name of the shape. None if it is no such folder, or has files that name other files.
/// \throw Invalid_input if a file cannot be read
std::optional<std::string> digest_of_folder(const std::string& path);

/// The same as `split_parts()`, but in mode `AUTO` pieces end where the material changes only if with this the parts
/// are nearer to labelled parts of a category.
/// \param roles null: they never do
Part_split split_parts_by_roles(const Segmented_shape& objects, const Part_splitting_options& options,
                                const Role_model* roles);

} // namespace CGAL::Shape_correspondence::IO
