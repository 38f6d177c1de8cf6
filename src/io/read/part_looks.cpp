// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_parts.h"

#include <algorithm>
#include <iterator>

namespace CGAL::Shape_correspondence::IO {

void append_looks(Model_content& from, Model_content& to)
{
  for (Surface_material& material : from.materials)
    if (material.texture >= 0) material.texture += int(to.textures.size());
  for (Model_part& part : from.parts)
    for (int& material : part.appearance.materials)
      if (material >= 0) material += int(to.materials.size());
  const auto append = [](auto& more, auto& all) { std::move(more.begin(), more.end(), std::back_inserter(all)); };
  append(from.materials, to.materials);
  append(from.textures, to.textures);
}

Part_appearance looks_of(const Part_appearance& all, const std::vector<std::size_t>& triangles)
{
  const std::size_t needed = triangles.empty() ? 1 : triangles.back() + 1; // number of attributes in the file
  Part_appearance result;
  for (std::size_t t : triangles) {
    if (all.materials.size() >= needed) result.materials.push_back(all.materials[t]);
    for (std::size_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
      if (all.coordinates.size() >= 3 * needed) result.coordinates.push_back(all.coordinates[corner]);
      if (all.colours.size() >= 3 * needed) result.colours.push_back(all.colours[corner]);
    }
  }
  return result;
}

void add_looks(const Part_appearance& more, std::size_t more_triangles, std::size_t triangles, Part_appearance& all)
{
  const auto append = [](auto& to, std::size_t before, const auto& from, std::size_t count, const auto& none) {
    if (to.empty() && from.empty()) return;
    to.resize(before, none);
    to.insert(to.end(), from.begin(), from.end());
    to.resize(before + count, none);
  };
  append(all.materials, triangles, more.materials, more_triangles, -1);
  append(all.coordinates, 3 * triangles, more.coordinates, 3 * more_triangles, Eigen::Vector2f(0, 0));
  append(all.colours, 3 * triangles, more.colours, 3 * more_triangles, Eigen::Vector3f(1, 1, 1));
}

} // namespace CGAL::Shape_correspondence::IO
