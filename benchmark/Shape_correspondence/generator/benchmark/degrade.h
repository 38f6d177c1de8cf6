// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "../assembly.h"
#include "random.h"

namespace CGAL::Shape_correspondence::generator {

/// Ways of degrading shapes, which give them flaws of real models.
struct Degradation
{
  bool segmentation = false; ///< parts cut in two, and touching parts of one label joined
  bool openings = false;     ///< surfaces that lack a patch
  bool gaps = false;         ///< parts that stop short of their neighbours
  bool noise = false;        ///< vertices moved by random offsets
  bool scale = false;        ///< axes scaled by random factors
  bool rotation = false;     ///< shape turned about the up axis by a random angle
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

/// The two pieces of a part that is cut across its longest extent; the part itself if a piece would have too few faces.
std::vector<Part> cut(const Part& part);

/// Joins two parts to one, whose fine label is empty unless both have the same.
Part joined(Part part, const Part& other);

void degrade_segmentation(Assembly& shape, Random& random);

/// Removes the faces at a random side of the part's box, if more than half of the faces remain.
void open_surface(Mesh& mesh, Random& random);

/// Scales a part so that each side of its box moves inwards by `gap`, at most by a tenth of the extent.
void shrink(Mesh& mesh, double gap);

/// Moves every coordinate by a random offset of at most 0.2 of the median edge length and 0.005 of the part's diagonal.
void add_noise(Mesh& mesh, Random& random);

/// The shape degraded in the given ways. Each way has a seed of its own, so that a further way does not change the
/// effects of the others. Symmetry groups, contacts and mid-lines are removed.
Assembly degraded(Assembly shape, const Degradation& ways, std::uint64_t seed);

} // namespace CGAL::Shape_correspondence::generator
