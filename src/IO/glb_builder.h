// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_SRC_IO_GLB_BUILDER_H
#define CGAL_SHAPE_CORRESPONDENCE_SRC_IO_GLB_BUILDER_H

#include "json_text.h"

#include <CGAL/Shape_correspondence/Points.h>

#include <Eigen/Core>

#include <iosfwd>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace IO {

/// Triangles ready to be drawn: a normal a vertex.
struct Drawn_mesh
{
  Points points;
  Points normals; ///< unit vectors
  Eigen::Matrix3Xi triangles;
};

/// A binary glTF 2.0 file under construction. Everything is referred to by the index that its `add_` returned.
class Glb_builder
{
public:
  Glb_builder();

  /// \param colour linear red, green, blue in [0, 1] \param alpha below 1: see-through
  int add_material(const std::string& name, const Eigen::Vector3d& colour, double alpha = 1);

  /// A node with a mesh; each drawn mesh with its material. Empty drawn meshes are left out.
  int add_node(const std::string& name, const std::vector<std::pair<Drawn_mesh, int>>& meshes);

  /// A node with children, moved along by `translation`.
  int add_node(const std::string& name, const std::vector<int>& children, const Point& translation);

  /// Writes the file with `roots` as its scene.
  void write(std::ostream& out, const std::vector<int>& roots) const;

private:
  Json primitive(const Drawn_mesh& mesh, int material);
  int add_vectors(const Points& vectors, bool with_bounds);
  int add_indices(const Eigen::Matrix3Xi& triangles);
  int add_accessor(const std::string& bytes, int target, Json accessor);

  Json document_;
  std::string buffer_;
};

} // namespace IO
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_SRC_IO_GLB_BUILDER_H
