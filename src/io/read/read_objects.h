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

/// Start of the warning that a list of labels beside a model cannot be used.
constexpr const char* labels_left_out = "The labels of faces beside the model were left out: ";

struct Model_objects
{
  Segmented_shape shape;
  /// Index of the material by object and triangle (`Part_splitting_options`); empty if no object has several.
  std::vector<std::vector<int>> materials;
  std::vector<std::string> warnings; ///< warnings of the reader
  bool says_up = false;              ///< whether the files give the upright axis, which is then that of the shape
  bool are_labelled = false;         ///< whether labels of faces, or this program's mark, define the objects
  /// For each object and triangle, the index of its face in the file, and the number of faces; of a folder, counted
  /// through its files in their order. Empty and 0 if faces have no indices.
  std::vector<std::vector<std::size_t>> faces = {};
  std::size_t number_of_faces = 0;
  /// For each object and corner of its triangles, the index of its vertex, and the number of vertices, as for faces.
  std::vector<std::vector<int>> vertices = {};
  std::size_t number_of_vertices = 0;
  Shape_appearance appearance = {}; ///< appearance in the model's own file, completed from the files that it names
};

/// Completes and checks materials and textures, using the files that a model file names.
using Complete_appearance =
    std::function<void(const std::string& file, Model_content& content, std::vector<std::string>& warnings)>;

/// The robot description (URDF) in a folder: the only such file in it, or in its sub-folder `urdf` or `robots`.
std::optional<std::string> robot_in(const std::string& folder);

/// Reads a model like `read_segmented_shape()`, with its materials. \param complete may be empty
Model_objects read_objects(const std::string& path, const Point& up, const Reading_options& options = {},
                           const Complete_appearance& complete = {});

/// Splits objects like `split_parts()`, but in mode `AUTO` pieces end at changes of the material only if that brings
/// the parts nearer to labelled parts of a category.
/// \param roles null: pieces never end at changes of the material
Part_split split_parts_by_roles(const Segmented_shape& objects, const Part_splitting_options& options,
                                const Role_model* roles);

/// A part with the mesh files that it consists of.
struct Part_files
{
  std::string name;
  std::vector<std::string> files;
};

/// The hierarchy of parts in a PartNet folder: the content of `result_after_merging.json`, or else `result.json`, which
/// name files in its folder `objs`. None if there is neither file.
std::optional<std::string> hierarchy_in(const std::string& folder);

/// The parts of a PartNet hierarchy: every node becomes a part of the files listed in the node itself.
/// \throw Invalid_input
std::vector<Part_files> parts_of_hierarchy(const std::string& hierarchy);

} // namespace CGAL::Shape_correspondence::IO
