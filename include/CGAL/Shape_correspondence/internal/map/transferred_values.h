// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MAP_TRANSFERRED_VALUES_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MAP_TRANSFERRED_VALUES_H

#include <CGAL/Shape_correspondence/Correspondence_map.h>

#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

template <typename Value>
std::vector<std::vector<Value>> Surface_map::transferred(const std::vector<std::vector<Value>>& values,
                                                         const Value& none) const
{
  std::vector<std::vector<Value>> result;
  for (const auto& places : sources_) {
    result.emplace_back();
    for (const std::optional<Surface_place>& place : places) {
      if (!place) {
        result.back().push_back(none);
        continue;
      }
      const auto corner = [&](Eigen::Index i) -> const Value& {
        return values[place->part][std::size_t(triangles_[place->part](i, place->triangle))];
      };
      Eigen::Index nearest;
      place->weights.maxCoeff(&nearest);
      if constexpr (std::is_integral<Value>::value || std::is_enum<Value>::value)
        result.back().push_back(corner(nearest));
      else
        result.back().push_back(
            Value(corner(0) * place->weights[0] + corner(1) * place->weights[1] + corner(2) * place->weights[2]));
    }
  }
  return result;
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MAP_TRANSFERRED_VALUES_H
