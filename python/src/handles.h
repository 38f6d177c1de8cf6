// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/jobs.h"
#include "cli/load_shape.h"

#include <CGAL/Shape_correspondence/Role_model.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace shape_correspondence_python {

namespace SC = CGAL::Shape_correspondence;

/// A shape that is read or given by arrays.
struct Shape
{
  std::string file; ///< file that it was read from, or else its name
  SC::cli::Read_model model;
  SC::IO::Reading_options reading = {}; ///< options with which the file was read

  const SC::Segmented_shape& segmented() const { return model.split.shape; }
};

/// A structural graph, with the surfaces that it was built from where they are known.
struct Graph
{
  std::string file;
  SC::cli::Loaded_shape shape;
  std::vector<std::string> warnings_of_up = {}; ///< warnings about the estimated axes of the pair that it was loaded in
};

/// Correspondences of two graphs, the best first.
struct Match
{
  std::shared_ptr<const Graph> source, target;
  SC::cli::Matched_shapes matched;

  const SC::Correspondence& best() const { return matched.ranked.front(); }
};

struct Blend
{
  std::shared_ptr<const Match> match;
  SC::Correspondence pairs; ///< pairs of the match without the unlikely ones
  SC::Shape_blend blend;
  std::vector<std::string> warnings; ///< warnings about the shapes, the match and the blend
};

struct Role_model
{
  std::shared_ptr<const SC::Role_model> model;
};

/// The text that `write` writes to a stream.
template <typename Write>
std::string text(const Write& write)
{
  std::ostringstream out;
  write(out);
  return out.str();
}

} // namespace shape_correspondence_python
