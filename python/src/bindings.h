// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <pybind11/pybind11.h>

namespace shape_correspondence_python {

// Each adds the classes and functions of one topic to the module.
void bind_shapes(pybind11::module_& module);
void bind_matches(pybind11::module_& module);
void bind_blends(pybind11::module_& module);
void bind_collections(pybind11::module_& module);
void bind_roles(pybind11::module_& module);

} // namespace shape_correspondence_python
