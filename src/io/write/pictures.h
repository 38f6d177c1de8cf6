// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/write/Json.h"

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Points.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <Eigen/Core>

#include <functional>
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
  std::map<std::string, int> shared_accessors_; ///< indices of accessors by content; vertices are not shared
};

constexpr const char *surface_layer = "surfaces", *abstraction_layer = "curves and sheets", *contact_layer = "contacts",
                     *material_layer = "materials";

/// A surface with smooth shading where faces meet at less than 35°, and sharp edges elsewhere.
Drawn_mesh shaded(const Points& points, const Eigen::Matrix3Xi& triangles);

/// A tube along a polyline, without caps.
Drawn_mesh open_tube(const Points& polyline, bool closed, double radius, int sides);

/// A tube along a polyline, with round ends.
Drawn_mesh tube(const Points& polyline, bool closed, double radius);

/// The surface of a grid of points, stored row by row.
Drawn_mesh patch(const Points& grid, int rows, int cols);

/// The shape with fewer triangles: edges are collapsed (Lindstrom and Turk 1998), in equal shares of all parts.
/// \param most_triangles approximate number of remaining triangles; every part keeps enough to show its shape
Segmented_shape simplified_shape(const Segmented_shape& shape, std::size_t most_triangles);

std::size_t number_of_triangles(const Segmented_shape& shape);

class Drawn_shape
{
public:
  /// \param model may be null: then only curves and sheets are drawn
  /// \param turns quarter turns about the up axis
  Drawn_shape(const Structural_graph& graph, const Segmented_shape* model, int turns);

  const Segmented_shape* model() const { return model_; }
  std::size_t number_of_parts() const { return structure_.parts.size(); }
  const std::string& name() const { return structure_.name; }
  const std::string& name(std::size_t part) const { return structure_.parts[part].name; }
  const Point& lower() const { return lower_; }
  const Point& upper() const { return upper_; }

  Drawn_mesh surface(std::size_t part) const;
  /// The surface with flat shading, which takes less data.
  Drawn_mesh flat_surface(std::size_t part) const;
  /// A tube for a curve, or a patch for a sheet.
  Drawn_mesh abstraction(std::size_t part) const;
  /// The abstraction with few triangles and flat shading.
  Drawn_mesh coarse_abstraction(std::size_t part) const;
  Drawn_mesh best_mesh(std::size_t part) const { return model_ ? surface(part) : abstraction(part); }
  /// A line for each contact, via the contact, between the middles of the curves or sheets of its two parts.
  Drawn_mesh contacts() const;

  /// Adds a node with a child for each part, whose meshes `draw` makes.
  int add_to(Glb_file& glb, const Point& translation,
             const std::function<std::vector<Drawn_mesh>(std::size_t part)>& draw) const;

private:
  Points to_picture(const Points& world) const { return turn_ * structure_.frame.to_frame(world); }

  const Shape_structure& structure_;
  const Segmented_shape* model_;
  Eigen::Matrix3d turn_;
  Point lower_ = Point::Constant(1e300);
  Point upper_ = Point::Constant(-1e300);
};

/// A shape and its position in a picture.
struct Placed_shape
{
  const Drawn_shape& shape;
  Point place = Point::Zero();
};

/// Adds scenes to a picture of one or two shapes.
using Add_scenes =
    std::function<void(Glb_file& glb, const std::vector<Placed_shape>& shapes, std::vector<Glb_scene>& scenes)>;

/// Like the public functions of the same names, with further scenes.
void write_correspondence_glb(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                              const Structural_graph& target, const Segmented_shape* source_shape,
                              const Segmented_shape* target_shape, const Add_scenes& add_scenes);
void write_structural_graph_glb(std::ostream& out, const Structural_graph& graph, const Segmented_shape* shape,
                                const Add_scenes& add_scenes);

/// Adds a material for every block (`correspondence_blocks()`), and a grey one for unmatched parts.
/// \return the material of every part, the target's parts after the source's
std::vector<int> add_match_materials(Glb_file& glb, const Correspondence& correspondence, std::size_t sources,
                                     std::size_t targets);

/// The appearance of the shapes of a blend in a picture.
class Blend_painter
{
public:
  /// Triangles of a surface that share one appearance; the caller adds their points.
  struct Painted_mesh
  {
    Drawn_mesh mesh;
    std::vector<int> points; ///< indices of the surface's points that the mesh uses
  };

  virtual ~Blend_painter() = default;
  /// The meshes that show a part of the source (`side` 0) or the target (1), given by its surface `mesh`.
  virtual std::vector<Drawn_mesh> end(std::size_t side, std::size_t part, const Drawn_mesh& mesh) = 0;
  /// Times at which a surface changes its appearance, besides its own begin and end.
  virtual std::vector<double> changes(std::size_t surface) const = 0;
  /// The meshes that show a surface of the blend at time t.
  virtual std::vector<Painted_mesh> surface(std::size_t surface, double t) = 0;
};

void write_blend_animation(std::ostream& out, const Shape_blend& blend, int frames, Glb_file& glb,
                           Blend_painter& painter);

void write_blend_frame(std::ostream& out, const Shape_blend& blend, double t, Glb_file& glb, Blend_painter& painter);

} // namespace CGAL::Shape_correspondence::IO
