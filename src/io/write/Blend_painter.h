// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/write/Glb_file.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <cstddef>
#include <iosfwd>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// How the shapes of a blend are drawn.
class Blend_painter
{
public:
  /// Triangles of a surface to be drawn with one look; the caller adds their points.
  struct Painted_mesh
  {
    Drawn_mesh mesh;
    std::vector<int> points; ///< which of the surface's points are those of the mesh
  };

  virtual ~Blend_painter() = default;
  /// A part of the source (`side` 0) or the target (1).
  virtual std::vector<Drawn_mesh> end(std::size_t side, std::size_t part, const Drawn_mesh& mesh) = 0;
  /// Times, besides the surface's own, at which it changes its looks.
  virtual std::vector<double> changes(std::size_t surface) const = 0;
  virtual std::vector<Painted_mesh> surface(std::size_t surface, double t) = 0;
};

/// Writes all of a blend as an animation.
void write_blend_animation(std::ostream& out, const Shape_blend& blend, int frames, Glb_file& glb,
                           Blend_painter& painter);

/// Writes the shape at `t`.
void write_blend_frame(std::ostream& out, const Shape_blend& blend, double t, Glb_file& glb, Blend_painter& painter);

} // namespace CGAL::Shape_correspondence::IO
