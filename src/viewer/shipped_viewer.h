// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>

namespace CGAL::Shape_correspondence::IO {

/// The bytes of src/viewer/page/viewer.html, which has places for the others: @STYLE@ for viewer.css, @SCRIPT@ for
/// three.js and all modules. CMake makes the sources (cmake/bundle_viewer.cmake, cmake/embed_file.cmake).
extern const unsigned char shipped_viewer_page[], shipped_viewer_style[], shipped_viewer_script[];
extern const std::size_t shipped_viewer_page_size, shipped_viewer_style_size, shipped_viewer_script_size;
/// SHA-256 of the script.
extern const unsigned char shipped_viewer_hash[];
extern const std::size_t shipped_viewer_hash_size;
/// Whether the script has three.js.
extern const bool shipped_viewer_is_complete;

} // namespace CGAL::Shape_correspondence::IO
