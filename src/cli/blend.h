// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/load_shape.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

struct Blend_output
{
  std::string path;
  std::string format = "obj";
  std::string schedule = "best";
  std::optional<Blend_size> size; ///< empty: the given heights
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

/// \throw Usage_error if the name of the output contradicts other options
void check_output(const Blend_output& output);

Blend_options blend_options(const Blend_output& output);

/// Writes the blend. \param appearance appearance of the models; null: corresponding parts have one colour
/// \param finish writes related files: after a file, or before a folder gets its name, which makes all appear at once
void write_blend(const Blend_output& output, const Shape_blend& blend, const Correspondence& correspondence,
                 const IO::Blend_appearance* appearance, const std::function<void()>& finish);

/// Removes pairs of confidence below `least`. \return a warning for each of them
std::vector<std::string> remove_unlikely(Correspondence& correspondence, double least, const Loaded_shape& source,
                                         const Loaded_shape& target);

/// The default size of the frames; `SAME`, with a warning, for shapes that seem to have different units.
Blend_size likely_size(const Loaded_shape& source, const Loaded_shape& target, std::vector<std::string>& warnings);

/// Tells which parts are exchanged for their counterparts, and why they do not morph.
void warn_of_obstacles(const Shape_blend& blend, const Loaded_shape& source, const Loaded_shape& target,
                       std::vector<std::string>& warnings);

} // namespace CGAL::Shape_correspondence::cli
