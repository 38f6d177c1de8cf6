// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/write/Json.h"

#include <CGAL/Shape_correspondence/Points.h>

#include <Eigen/Core>

#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// Triangles, or lines, to be drawn.
struct Drawn_mesh
{
  Points points;
  Points normals = {}; ///< unit vectors, one for each point; empty: flat shading
  Eigen::Matrix3Xi triangles = {};
  Eigen::Matrix2Xi lines = {};       ///< drawn if there are no triangles
  std::string layer = {};            ///< name of a layer that viewers may switch on and off; empty: none
  int material = 0;                  ///< index in the file
  Eigen::Matrix2Xf coordinates = {}; ///< texture coordinates, one for each point; or empty
  Eigen::Matrix3Xf colours = {};     ///< factors of the material's colour, one for each point; or empty
  std::vector<Points> morphs = {};   ///< displacements of the points; equally many for all meshes of a node

  bool empty() const { return triangles.cols() == 0 && lines.cols() == 0; }
};

/// Nodes that are shown together. Viewers that do not let users choose show the first scene.
struct Glb_scene
{
  std::string name;
  std::vector<int> roots;
};

/// A binary glTF 2.0 file under construction. Objects are referred to by the index returned when they were added.
class Glb_file
{
public:
  Glb_file();

  /// Adds an object to a list of the glTF document, such as "images".
  int add(const char* list, Json object);

  /// Adds bytes to the buffer. \return their buffer view
  int add_bytes(const std::string& bytes);

  /// Adds a material. \param colour linear red, green, blue in [0, 1] \param alpha opacity in [0, 1]
  /// \param texture index of its texture; -1: none
  int add_material(const std::string& name, const Eigen::Vector3d& colour, double alpha = 1, int texture = -1);

  /// Adds a node with meshes; empty ones are left out. \param name may be empty
  int add_node(const std::string& name, const std::vector<Drawn_mesh>& meshes);

  /// Adds a node with children, translated by `translation`.
  int add_node(const std::string& name, const std::vector<int>& children, const Point& translation);

  /// Animates the morphs of a node's meshes. \param times in seconds \param weights by morph (row) and time (column)
  void animate_morphs(int node, const std::vector<double>& times, const Eigen::MatrixXf& weights);

  /// Shows a node only from `begin` to `end`, in seconds.
  void animate_visibility(int node, double begin, double end);

  /// Sets data for viewers that know this package: an object, for a node or for the animation.
  void set_node_extras(int node, Json extras);
  void set_animation_extras(Json extras);

  void write(std::ostream& out, const std::vector<Glb_scene>& scenes) const;

private:
  /// A buffer view that accessors of one kind share.
  struct Shared_view
  {
    int view;
    std::string bytes;
  };

  Shared_view& shared_view(int target, std::size_t stride);
  template <typename Scalar>
  int add_accessor(const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& elements, int target, bool has_bounds);
  Json primitive(const Drawn_mesh& mesh);
  void add_channel(int node, const char* path, const char* interpolation, const std::vector<double>& times,
                   const Eigen::MatrixXf& values);

  Json document_;
  std::string buffer_;
  std::map<std::pair<int, std::size_t>, Shared_view> shared_views_; ///< by buffer target and element size in bytes
  std::map<std::string, int> shared_accessors_;                     ///< indices by content, of all but vertices
};

} // namespace CGAL::Shape_correspondence::IO
