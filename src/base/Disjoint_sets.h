// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_BASE_DISJOINT_SETS_H
#define CGAL_SHAPE_CORRESPONDENCE_BASE_DISJOINT_SETS_H

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// The numbers from 0 on in sets, to begin with one in each. Unlike Boost's, a set is named by its smallest number, so
/// that names do not depend on the order in which sets were united.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(std::size_t count = 0) : parent_(count)
  {
    std::iota(parent_.begin(), parent_.end(), std::size_t(0));
  }

  std::size_t size() const { return parent_.size(); }

  /// The set of a number.
  std::size_t operator[](std::size_t i) const
  {
    while (parent_[i] != i)
      i = parent_[i];
    return i;
  }

  /// Makes one set of those of two numbers. Returns whether they were two.
  bool unite(std::size_t a, std::size_t b)
  {
    const std::size_t first = root(a), second = root(b);
    parent_[std::max(first, second)] = std::min(first, second);
    return first != second;
  }

private:
  std::size_t root(std::size_t i)
  {
    const std::size_t result = (*this)[i];
    while (i != result)
      i = std::exchange(parent_[i], result);
    return result;
  }

  std::vector<std::size_t> parent_; ///< never greater than the number
};

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_BASE_DISJOINT_SETS_H
