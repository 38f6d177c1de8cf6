// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"
#include "cli/collection.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>
#include <CGAL/Shape_correspondence/energy_matrix.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <pybind11/pybind11.h>

namespace shape_correspondence_python {

namespace py = pybind11;
namespace SC = CGAL::Shape_correspondence;

/// Options from keyword arguments; None leaves a default. \throw TypeError for a name that `options_of()` does not list
SC::Search_options search_options(const py::dict& values, bool is_for_pair = true);
SC::cli::Common_options model_options(const py::dict& values);
/// Options of a blend from keyword arguments. \param has_size receives whether a size is among them
SC::Blend_options blend_options(const py::dict& values, bool& has_size);
SC::cli::Collection_options collection_options(const py::dict& values);

/// The options of a function: tuples of name, default and help. \param function `match`, `read`, `build_graph`,
/// `blend`, `collection`; `part_matching` has those of a part of `match`
py::list options_of(const std::string& function);

} // namespace shape_correspondence_python
