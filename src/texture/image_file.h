// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Shape_appearance.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL::Shape_correspondence::IO {

/// The defect of an image file's first bytes, as the end of a sentence; empty if they begin like a PNG or JPEG.
std::string fault_of_image(std::string_view bytes);

bool is_png(std::string_view bytes);

/// Limits on the decoded images of a model, since a few bytes may encode an image of any size.
struct Image_budget
{
  std::size_t pixels = std::size_t(1) << 26; ///< number of pixels, of four bytes each
  /// Number of pixels times the number of scans of a progressive JPEG, each of which takes time.
  std::size_t scanned = std::size_t(1) << 30;

  /// Subtracts an image. \throw Invalid_input, with the end of a sentence, if the rest is too small for it
  void take(std::size_t width, std::size_t height, std::size_t scans);
};

/// Decodes a PNG or JPEG of at most 8192 pixels in each direction. \throw Invalid_input with the end of a sentence
Image decoded_image(const std::string& bytes, Image_budget& budget);

std::string png_of(const Image& image);

} // namespace CGAL::Shape_correspondence::IO
