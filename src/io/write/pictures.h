// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/write/Glb_file.h"

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// The layers of pictures.
constexpr const char *surface_layer = "surfaces", *abstraction_layer = "curves and sheets", *contact_layer = "contacts",
                     *material_layer = "materials";

/// A surface that is smooth where faces meet at less than 35° and has edges elsewhere.
Drawn_mesh shaded(const Points& points, const Eigen::Matrix3Xi& triangles);

/// A tube along a polyline, without caps.
Drawn_mesh open_tube(const Points& polyline, bool closed, double radius, int sides);

/// A round tube along a polyline.
Drawn_mesh tube(const Points& polyline, bool closed, double radius);

/// The surface of a grid of points, row by row.
Drawn_mesh patch(const Points& grid, int rows, int cols);

/// The shape with fewer triangles: edges are collapsed as in Lindstrom and Turk 1998, and every part keeps its share of
/// the triangles.
/// \param most_triangles about as many are left; a part keeps those that give it a shape, though
Segmented_shape simplified_shape(const Segmented_shape& shape, std::size_t most_triangles);

std::size_t number_of_triangles(const Segmented_shape& shape);

/// A shape in the frame in which it is drawn.
class Drawn_shape
{
public:
  /// \param model may be null: there is nothing but curves and sheets then
  /// \param turns by quarters about up
  Drawn_shape(const Structural_graph& graph, const Segmented_shape* model, int turns);

  const Segmented_shape* model() const { return model_; }
  std::size_t number_of_parts() const { return structure_.parts.size(); }
  const std::string& name() const { return structure_.name; }
  const std::string& name(std::size_t part) const { return structure_.parts[part].name; }
  const Point& lower() const { return lower_; }
  const Point& upper() const { return upper_; }

  Drawn_mesh surface(std::size_t part) const;
  /// The same, shaded flat: less data.
  Drawn_mesh flat_surface(std::size_t part) const;
  /// A tube or a patch.
  Drawn_mesh abstraction(std::size_t part) const;
  /// The same with few triangles, shaded flat.
  Drawn_mesh coarse_abstraction(std::size_t part) const;
  /// The surface, or the abstraction if there is none.
  Drawn_mesh best_mesh(std::size_t part) const { return model_ ? surface(part) : abstraction(part); }
  /// A line for each contact, from the middle of one part's curve or sheet by way of the contact to that of the other.
  Drawn_mesh contacts() const;

  /// Adds a node with a node for each part, whose meshes `draw` makes.
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

/// A shape, and where it is drawn.
struct Placed_shape
{
  const Drawn_shape& shape;
  Point place = Point::Zero();
};

/// Adds scenes to a picture of one or two shapes.
using Add_scenes =
    std::function<void(Glb_file& glb, const std::vector<Placed_shape>& shapes, std::vector<Glb_scene>& scenes)>;

/// The same as the public functions, with further scenes.
void write_correspondence_glb(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                              const Structural_graph& target, const Segmented_shape* source_shape,
                              const Segmented_shape* target_shape, const Add_scenes& add_scenes);
void write_structural_graph_glb(std::ostream& out, const Structural_graph& graph, const Segmented_shape* shape,
                                const Add_scenes& add_scenes);

/// Adds a material for every block (`correspondence_blocks()`), and a grey one for parts in no pair.
/// \return the material of every part, the target's parts after the source's
std::vector<int> add_match_materials(Glb_file& glb, const Correspondence& correspondence, std::size_t sources,
                                     std::size_t targets);

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
