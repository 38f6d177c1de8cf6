// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "../assembly.h"
#include "random.h"

namespace CGAL::Shape_correspondence::generator {

/// What makes shapes worse, as shapes from other people are.
struct Degradation
{
  bool segmentation = false; ///< parts cut in two, and touching parts of one label joined
  bool openings = false;     ///< surfaces that lack a patch
  bool gaps = false;         ///< parts that stop short of their neighbours
  bool noise = false;        ///< vertices off their places
  bool scale = false;        ///< other proportions
  bool rotation = false;     ///< turned about the up axis, by any angle
};

double diagonal(const Mesh& mesh);

/// The faces for which `keep` holds of the centroid, and the points that they use.
template <typename Keep>
Mesh faces_where(const Mesh& mesh, const Keep& keep)
{
  Mesh result;
  std::vector<int> index(mesh.points.size(), -1);
  for (auto face : mesh.faces) {
    if (!keep((mesh.points[face[0]] + mesh.points[face[1]] + mesh.points[face[2]]) / 3)) continue;
    for (int& i : face) {
      if (index[i] < 0) {
        index[i] = int(result.points.size());
        result.points.push_back(mesh.points[i]);
      }
      i = index[i];
    }
    result.faces.push_back(face);
  }
  return result;
}

/// A part in two pieces, cut across its longest extent; the part alone where a piece would be next to nothing.
std::vector<Part> cut(const Part& part);

/// Two parts as one; its fine label is that of both.
Part joined(Part part, const Part& other);

void degrade_segmentation(Assembly& shape, Random& random);

/// Takes the faces at one end of the part's box away, where enough of it is left.
void open_surface(Mesh& mesh, Random& random);

/// Draws every side of the part's box in by `gap`, at most by a tenth of the extent.
void shrink(Mesh& mesh, double gap);

/// Moves every vertex by at most a fifth of the part's median edge, and by at most a part in two hundred of its size.
void add_noise(Mesh& mesh, Random& random);

/// The shape made worse in the ways that are asked for; each way draws from a seed of its own, so that asking for one
/// more changes nothing about the others. What is known of groups, contacts and mid-lines is lost.
Assembly degraded(Assembly shape, const Degradation& ways, std::uint64_t seed);

} // namespace CGAL::Shape_correspondence::generator
