// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/load_shape.h"

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// Files of the parts of a model; empty: none.
struct Parts_output
{
  std::string glb, obj, ply; ///< an object for each part; with its number for each face
  std::string seg;           ///< the numbers of the parts, a line for each face of the model file
  std::string folder;        ///< new, of an OBJ file for each part

  std::vector<std::string> files() const { return {glb, obj, ply, seg}; }
  bool is_empty() const { return (glb + obj + ply + seg + folder).empty(); }
};

/// Writes the parts of a model. \param model gets warnings \throw Invalid_input
void write_parts(const Parts_output& output, const std::string& path, const Common_options& options, Read_model& model);

} // namespace CGAL::Shape_correspondence::cli
