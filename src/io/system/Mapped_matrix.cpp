// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/Mapped_matrix.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>

namespace CGAL::Shape_correspondence::IO {
namespace {

std::size_t bytes_of(std::size_t size) { return std::max<std::size_t>(1, size * size) * sizeof(double); }

Mapped_numbers zeros(const std::string& folder, std::size_t bytes)
{
  std::error_code error;
  Mapped_numbers result = map_zeros(folder, bytes, error);
  if (!error) return result;
  const std::string place = folder.empty() ? "memory" : folder;
  throw Invalid_input(place + ": there is no room for a matrix of " + std::to_string(bytes >> 20) + " MB (" +
                      error.message() + "); " +
                      (folder.empty() ? "keep it in a folder, by --store" : "choose another folder"));
}

} // namespace

Mapped_matrix::Mapped_matrix(const std::string& folder, std::size_t size)
    : size_(Eigen::Index(size)), entries_(zeros(folder, bytes_of(size)))
{}

} // namespace CGAL::Shape_correspondence::IO
