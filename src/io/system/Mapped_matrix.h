// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/system/operating_system.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <string>

namespace CGAL::Shape_correspondence::IO {

/// A square matrix, all 0 at first, that may be larger than memory: it is in a file without a name, of which the system
/// keeps in memory what there is room for. Columns are contiguous.
class Mapped_matrix
{
public:
  /// \param folder where the file is, whose room is free again when the matrix is gone; empty: in memory
  /// \throw Invalid_input if there is no room for it
  Mapped_matrix(const std::string& folder, std::size_t size) : size_(Eigen::Index(size))
  {
    const std::size_t bytes = std::max<std::size_t>(1, size * size) * sizeof(double);
    std::error_code error;
    entries_ = map_zeros(folder, bytes, error);
    if (error)
      throw Invalid_input((folder.empty() ? "memory" : folder) + ": there is no room for a matrix of " +
                          std::to_string(bytes >> 20) + " MB (" + error.message() + "); " +
                          (folder.empty() ? "keep it in a folder, by --store" : "choose another folder"));
  }

  Eigen::Map<Eigen::MatrixXd> operator*() { return {entries_.get(), size_, size_}; }
  Eigen::Map<const Eigen::MatrixXd> operator*() const { return {entries_.get(), size_, size_}; }

private:
  Eigen::Index size_;
  Mapped_numbers entries_;
};

} // namespace CGAL::Shape_correspondence::IO
