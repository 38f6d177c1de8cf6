// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/system/operating_system.h"

#include <Eigen/Core>

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
  Mapped_matrix(const std::string& folder, std::size_t size);

  Eigen::Map<Eigen::MatrixXd> operator*() { return {entries_.get(), size_, size_}; }
  Eigen::Map<const Eigen::MatrixXd> operator*() const { return {entries_.get(), size_, size_}; }

private:
  Eigen::Index size_;
  Mapped_numbers entries_;
};

} // namespace CGAL::Shape_correspondence::IO
