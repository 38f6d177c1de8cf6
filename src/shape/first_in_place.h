// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// For each point, the index of the first point at the same place, so that triangles that share no point are connected.
inline std::vector<int> first_in_place(const Eigen::Ref<const Points>& points)
{
  const auto place = [&](int i) { return std::tuple(points(0, i), points(1, i), points(2, i)); };
  std::vector<int> order(std::size_t(points.cols())), result(order.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return place(a) < place(b); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_first = i == 0 || place(order[i]) != place(order[i - 1]);
    result[std::size_t(order[i])] = is_first ? order[i] : result[std::size_t(order[i - 1])];
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
