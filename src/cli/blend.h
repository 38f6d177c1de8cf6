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

/// The options of the output of `blend`.
struct Blend_output
{
  std::string path;
  std::string format = "obj";
  std::string schedule = "best";
  std::optional<Blend_size> size; ///< empty: as the heights are
  std::string colours = "auto";   ///< auto, materials or match
  int frames = 25;
  double at =
      std::numeric_limits<double>::quiet_NaN(); ///< the time of the one shape that is made; NaN: the whole blend
  bool solid = false;                           ///< that shape is one closed surface

  bool is_one_shape() const { return !std::isnan(at); }
  bool is_page() const;
  /// Whether the output is a file, not a folder.
  bool is_file() const;
  /// Whether something is written that may have the models' own materials.
  bool may_show_materials() const;
};

void add_output_options(Option_table::Group& add, Blend_output& output);

/// \throw Usage_error if the name of the output contradicts the other options
void check_output(const Blend_output& output);

Blend_options blend_options(const Blend_output& output);

/// Writes the blend. \param appearance of the models; null: corresponding parts have one colour
/// \param finish writes what goes with it: before a folder gets its name, so that there is all or nothing, or after a file
void write_blend(const Blend_output& output, const Shape_blend& blend, const Correspondence& correspondence,
                 const IO::Blend_appearance* appearance, const std::function<void()>& finish);

/// Removes pairs that are less probable than `least`. \return a warning for each of them
std::vector<std::string> remove_unlikely(Correspondence& correspondence, double least, const Loaded_shape& source,
                                         const Loaded_shape& target);

/// The size of the frames where none is asked for: `SAME`, with a warning, for shapes that seem to be in other units.
Blend_size likely_size(const Loaded_shape& source, const Loaded_shape& target, std::vector<std::string>& warnings);

/// Tells which parts are exchanged for their counterparts, and why they do not morph.
void warn_of_obstacles(const Shape_blend& blend, const Loaded_shape& source, const Loaded_shape& target,
                       std::vector<std::string>& warnings);

} // namespace CGAL::Shape_correspondence::cli
