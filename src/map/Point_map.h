// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Piece_pair.h"

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <memory>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A location on the surface of a part.
struct Part_place
{
  std::size_t part = 0;
  Eigen::Index triangle = 0;
  Eigen::Vector3d weights = Eigen::Vector3d::Zero(); ///< barycentric coordinates
};

/// The map of a `Surface_map` for any point of the target's surface, evaluated exactly between vertices, too.
class Point_map
{
public:
  Point_map(const Structural_graph& source, const Segmented_shape& source_shape, const Structural_graph& target,
            const Segmented_shape& target_shape, const Correspondence& correspondence);

  /// The location on the source for a point in a triangle of a part. O(log n) \pre the part has a counterpart
  Part_place operator()(std::size_t target_part, Eigen::Index triangle, const Eigen::Vector3d& weights) const;

  /// The source parts to which a target part is mapped.
  std::vector<std::size_t> sources(std::size_t target_part) const;

private:
  struct Piece
  {
    std::size_t source;
    Chart_box box; ///< box in the chart coordinates of the target part
    Surface_pair surfaces;
    std::array<Points, 2> normals;
    std::unique_ptr<Place_finder> finder; ///< finder of places on the source
  };

  Charted_shape target_;
  const Segmented_shape& target_shape_;
  std::vector<std::vector<std::unique_ptr<Piece>>> pieces_; ///< indexed by target part
};

} // namespace CGAL::Shape_correspondence::internal
