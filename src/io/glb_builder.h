// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/Json.h"

#include <CGAL/Shape_correspondence/Points.h>

#include <Eigen/Core>

#include <iosfwd>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

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

  /// A node whose mesh goes through `shapes`, the points of the same triangles at different times; the first is the one
  /// at rest. Shaded flat. \pre not empty
  int add_morphing_node(const std::string& name, const std::vector<Points>& shapes, const Eigen::Matrix3Xi& triangles,
                        int material);

  /// Lets the mesh of a morphing node go through its shapes, at these times in seconds.
  void animate_shapes(int node, const std::vector<double>& times);

  /// Lets a node be seen from `begin` to `end` only, in seconds.
  void animate_visibility(int node, double begin, double end);

  /// Writes the file with `roots` as its scene.
  void write(std::ostream& out, const std::vector<int>& roots) const;

private:
  Json primitive(const Drawn_mesh& mesh, int material);
  int add_vectors(const Points& vectors, bool with_bounds);
  int add_indices(const Eigen::Matrix3Xi& triangles);
  int add_numbers(const std::vector<double>& numbers, const char* type, int components, bool with_bounds);
  int add_accessor(const std::string& bytes, int target, Json accessor);
  void add_channel(int node, const char* path, const char* interpolation, int times, int values);

  Json document_;
  std::string buffer_;
};

} // namespace CGAL::Shape_correspondence::IO
