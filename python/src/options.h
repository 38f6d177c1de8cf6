// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>
#include <CGAL/Shape_correspondence/co_analysis.h>
#include <CGAL/Shape_correspondence/energy_matrix.h>
#include <CGAL/Shape_correspondence/evaluate_correspondence.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <pybind11/pybind11.h>

namespace shape_correspondence_python {

namespace py = pybind11;
namespace SC = CGAL::Shape_correspondence;

/// Options from keyword arguments, by the names that `default_options()` lists. \throw TypeError of another name
SC::Search_options search_options(const py::dict& options);
SC::cli::Common_options model_options(const py::dict& options);
SC::Blend_options blend_options(const py::dict& options);
SC::Energy_matrix_options energy_matrix_options(const py::dict& options);
SC::Co_analysis_options co_analysis_options(const py::dict& options);
SC::Evaluation_options evaluation_options(const py::dict& options);

/// The names of all options and their defaults in the library, by function.
py::dict default_options();

} // namespace shape_correspondence_python
