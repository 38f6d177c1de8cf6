// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Disjoint sets of the numbers 0, 1, …, initially with one number each. Unlike in Boost, a set is identified by its
/// smallest number, whatever the order of unions.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(std::size_t size = 0) : sets_(size), smallest_(size), number_of_sets_(size)
  {
    std::iota(smallest_.begin(), smallest_.end(), std::size_t(0));
  }

  std::size_t size() const { return smallest_.size(); }
  std::size_t number_of_sets() const { return number_of_sets_; }

  /// Smallest number of the set that contains i. Not thread-safe: paths are compressed.
  std::size_t operator[](std::size_t i) const { return smallest_[sets_.find_set(i)]; }

  /// Unites the sets of two numbers. \return whether they were different
  bool unite(std::size_t a, std::size_t b)
  {
    const std::size_t first = sets_.find_set(a), second = sets_.find_set(b);
    if (first == second) return false;
    sets_.link(first, second);
    smallest_[first] = smallest_[second] = std::min(smallest_[first], smallest_[second]);
    --number_of_sets_;
    return true;
  }

private:
  mutable boost::disjoint_sets_with_storage<> sets_;
  std::vector<std::size_t> smallest_; ///< smallest number of a set, indexed by its representative in Boost
  std::size_t number_of_sets_;
};

} // namespace CGAL::Shape_correspondence::internal
