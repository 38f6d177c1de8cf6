// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Shape_appearance.h>

#include <string>
#include <string_view>

namespace CGAL::Shape_correspondence::IO {

/// What is wrong with the bytes of an image file, as the end of a sentence; empty if they begin like a PNG or JPEG.
std::string fault_of_image(std::string_view bytes);

bool is_png(std::string_view bytes);

/// Decodes a PNG or JPEG of at most 8192 pixels in each direction. \throw Invalid_input; the message ends a sentence
Image decoded_image(const std::string& bytes);

/// A picture as a PNG file.
std::string png_of(const Image& image);

} // namespace CGAL::Shape_correspondence::IO
