// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/write/Json.h"

#include <CGAL/Shape_correspondence/Points.h>
#include <CGAL/Shape_correspondence/Shape_appearance.h>

#include <Eigen/Core>

#include <iosfwd>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// Triangles, or lines, ready to be drawn.
struct Drawn_mesh
{
  Points points;
  Points normals; ///< unit vectors, one for each point; or empty: shaded flat
  Eigen::Matrix3Xi triangles;
  Eigen::Matrix2Xi lines = {}; ///< drawn where there are no triangles
  std::string layer = {};      ///< what it shows: viewers may switch layers on and off; empty: no layer
  std::vector<Eigen::Vector2f> coordinates = {}; ///< of a texture, one for each point; or empty
  std::vector<Eigen::Vector3f> colours = {};     ///< factors of the material's colour, one for each point; or empty

  bool empty() const { return triangles.cols() == 0 && lines.cols() == 0; }
};

/// Nodes that are shown together. Viewers without a choice show the first scene.
struct Glb_scene
{
  std::string name;
  std::vector<int> roots;
};

/// A binary glTF 2.0 file under construction. Everything is referred to by the index that its `add_` returned.
class Glb_builder
{
public:
  Glb_builder();

  /// \param colour linear red, green, blue in [0, 1] \param alpha below 1: see-through
  int add_material(const std::string& name, const Eigen::Vector3d& colour, double alpha = 1);

  /// Puts a texture into the file. \pre it has bytes
  int add_texture(const Texture& texture);

  /// \param texture what `add_texture()` returned; -1: none
  int add_material(const Surface_material& material, int texture);

  /// A node with a mesh; each drawn mesh with its material. Empty drawn meshes are left out.
  int add_node(const std::string& name, const std::vector<std::pair<Drawn_mesh, int>>& meshes);

  /// A node with children, moved along by `translation`.
  int add_node(const std::string& name, const std::vector<int>& children, const Point& translation);

  /// A mesh that goes through `shapes`, the points of the same triangles at different times; the first is the one at
  /// rest. Shaded flat.
  struct Morphing_mesh
  {
    std::vector<Points> shapes; ///< at least one
    Eigen::Matrix3Xi triangles;
    int material = 0;
    std::vector<Eigen::Vector2f> coordinates = {}; ///< as of a `Drawn_mesh`
    std::vector<Eigen::Vector3f> colours = {};
  };

  /// A node of meshes that go through as many shapes. \pre not empty
  int add_morphing_node(const std::string& name, const std::vector<Morphing_mesh>& meshes);

  /// Lets the mesh of a morphing node go through its shapes, at these times in seconds.
  void animate_shapes(int node, const std::vector<double>& times);

  /// Lets a node be seen from `begin` to `end` only, in seconds.
  void animate_visibility(int node, double begin, double end);

  /// Data for viewers that know this package: an object, of a node or of the animation.
  void set_node_extras(int node, Json extras);
  void set_animation_extras(Json extras);

  void write(std::ostream& out, const std::vector<Glb_scene>& scenes) const;

private:
  Json primitive(const Drawn_mesh& mesh, int material);
  int add_vectors(const Points& vectors, bool with_bounds);
  template <typename Vectors>
  int add_attribute(const Vectors& vectors, const char* type);
  int add_indices(const int* indices, Eigen::Index count);
  int add_numbers(const std::vector<double>& numbers, const char* type, int components, bool with_bounds);
  int add_accessor(const std::string& bytes, int target, Json accessor);
  void add_channel(int node, const char* path, const char* interpolation, int times, int values);

  Json document_;
  std::string buffer_;
};

} // namespace CGAL::Shape_correspondence::IO
