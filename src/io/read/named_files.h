// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>

#include <cstdint>
#include <string>

namespace CGAL::Shape_correspondence::IO {

/// The bytes of a file that a model names, or why there are none, as the end of a sentence.
struct Named_file
{
  std::string bytes, fault;
};

/// Reads the files that a model names: from its folder or, where they are not there by the path that it gives, beside
/// it.
struct Named_files
{
  const std::string& model;
  const Reading_options& options;
  std::uintmax_t largest; ///< bytes of a file
  std::uintmax_t& rest;   ///< bytes of files that may be read for the model; what is read is taken off

  Named_file read(const std::string& given) const;
};

} // namespace CGAL::Shape_correspondence::IO
