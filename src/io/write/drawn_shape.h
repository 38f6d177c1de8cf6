// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/write/glb_builder.h"

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <array>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// The layers of pictures.
constexpr const char *surface_layer = "surfaces", *abstraction_layer = "curves and sheets", *contact_layer = "contacts",
                     *material_layer = "materials";

/// A shape in the frame in which it is drawn.
class Drawn_shape
{
public:
  /// \param shape may be null: there is nothing but curves and sheets then
  /// \param turns by quarters about up
  Drawn_shape(const Structural_graph& graph, const Segmented_shape* shape, int turns);

  bool has_mesh() const { return shape_ != nullptr; }
  std::size_t number_of_parts() const { return structure_.parts.size(); }
  const std::string& name() const { return structure_.name; }
  const Part_abstraction& part(std::size_t part) const { return structure_.parts[part]; }
  const Point& lower() const { return lower_; }
  const Point& upper() const { return upper_; }

  Drawn_mesh surface(std::size_t part) const;
  /// The same, shaded flat: less data.
  Drawn_mesh flat_surface(std::size_t part) const;
  /// A tube or a patch.
  Drawn_mesh abstraction(std::size_t part) const;
  /// The surface, or the abstraction if there is none.
  Drawn_mesh best_mesh(std::size_t part) const { return has_mesh() ? surface(part) : abstraction(part); }
  /// A line for each contact, from the middle of one part's curve or sheet by way of the contact to that of the other.
  Drawn_mesh contacts() const;

private:
  Points to_picture(const Points& world) const { return turn_ * structure_.frame.to_frame(world); }
  double diagonal() const { return (upper_ - lower_).norm(); }

  const Shape_structure& structure_;
  const Segmented_shape* shape_;
  Eigen::Matrix3d turn_;
  Point lower_ = Point::Constant(1e300);
  Point upper_ = Point::Constant(-1e300);
};

/// Where two shapes go so that they stand side by side.
std::array<Point, 2> side_by_side(const Drawn_shape& left, const Drawn_shape& right);

/// The number of every part's block (`correspondence_blocks()`), -1 of parts in no pair. The target's parts come after
/// the source's.
std::vector<int> match_numbers(const Correspondence& correspondence, std::size_t sources, std::size_t targets);

/// Adds a material for every block, and a grey one for parts in no pair. \return the material of every part, the
/// target's parts after the source's
std::vector<int> add_match_materials(Glb_builder& glb, const Correspondence& correspondence, std::size_t sources,
                                     std::size_t targets);

} // namespace CGAL::Shape_correspondence::IO
