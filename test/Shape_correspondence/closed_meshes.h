// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/Disjoint_sets.h"
#include "generator/mesh.h"

#include <map>
#include <utility>
#include <vector>

/// Checks of the closed meshes that the generator makes.
namespace closed_meshes {

namespace gen = CGAL::Shape_correspondence::generator;

inline bool is_closed(const gen::Mesh& mesh)
{
  std::map<std::pair<int, int>, int> uses;
  for (const auto& f : mesh.faces)
    for (int i = 0; i < 3; ++i)
      ++uses[{f[i], f[(i + 1) % 3]}];
  for (const auto& [edge, n] : uses) {
    const auto opposite = uses.find({edge.second, edge.first});
    if (n != 1 || opposite == uses.end() || opposite->second != 1) return false;
  }
  return true;
}

/// The signed volume of each connected component.
inline std::vector<double> component_volumes(const gen::Mesh& mesh)
{
  CGAL::Shape_correspondence::internal::Disjoint_sets sets(mesh.points.size());
  for (const auto& f : mesh.faces) {
    sets.unite(f[0], f[1]);
    sets.unite(f[0], f[2]);
  }
  std::map<std::size_t, gen::Mesh> components;
  for (const auto& f : mesh.faces) {
    gen::Mesh& component = components[sets[f[0]]];
    component.points = mesh.points;
    component.faces.push_back(f);
  }
  std::vector<double> volumes;
  for (const auto& component : components)
    volumes.push_back(gen::volume(component.second));
  return volumes;
}

} // namespace closed_meshes
