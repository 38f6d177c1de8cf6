// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>

namespace CGAL::Shape_correspondence::IO {

/// The content of data/roles/shapes.roles; CMake generates the source (cmake/embed_file.cmake).
extern const unsigned char shipped_roles[];
extern const std::size_t shipped_roles_size;

} // namespace CGAL::Shape_correspondence::IO
