// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/IO/write_glb.h>

#include "colours.h"
#include "glb_builder.h"
#include "picture_geometry.h"

#include <algorithm>
#include <numeric>

namespace CGAL {
namespace Shape_correspondence {
namespace IO {
namespace {

constexpr double gap = 0.25;             // between the shapes, over the wider one's width
constexpr double tube_radius = 0.009;    // over the shape's diagonal
constexpr double contact_radius = 0.014; // over the shape's diagonal
constexpr double surface_alpha = 0.25;

Eigen::Matrix3d quarter_turns(int turns)
{
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d quarter;
  quarter << 0, 0, 1, 0, 1, 0, -1, 0, 0; // counter-clockwise about y
  for (int i = 0; i < ((turns % 4) + 4) % 4; ++i)
    turn = quarter * turn;
  return turn;
}

/// A shape in the frame in which it is drawn.
class Drawn_shape
{
public:
  Drawn_shape(const Structural_graph& graph, const Segmented_shape* shape, int turns)
      : structure_(structure(graph)), shape_(shape), turn_(quarter_turns(turns))
  {
    for (std::size_t part = 0; part < structure_.parts.size(); ++part) {
      const Points points = has_mesh() ? shape_->parts()[part].mesh.points : structure_.parts[part].control_points();
      const Points drawn = to_picture(points);
      lower_ = lower_.cwiseMin(drawn.rowwise().minCoeff());
      upper_ = upper_.cwiseMax(drawn.rowwise().maxCoeff());
    }
  }

  bool has_mesh() const { return shape_ != nullptr; }
  std::size_t number_of_parts() const { return structure_.parts.size(); }
  const std::string& name() const { return structure_.name; }
  const std::string& part_name(std::size_t part) const { return structure_.parts[part].name; }
  const Point& lower() const { return lower_; }
  const Point& upper() const { return upper_; }
  double diagonal() const { return (upper_ - lower_).norm(); }

  Points to_picture(const Points& world) const { return turn_ * structure_.frame.to_frame(world); }

  Drawn_mesh surface(std::size_t part) const
  {
    const Part_mesh& mesh = shape_->parts()[part].mesh;
    return shaded(to_picture(mesh.points), mesh.triangles);
  }

  Drawn_mesh abstraction(std::size_t part) const
  {
    const auto& geometry = structure_.parts[part].geometry;
    if (const Sheet* sheet = std::get_if<Sheet>(&geometry))
      return patch(to_picture(sheet->points), sheet->rows, sheet->cols);
    const Curve& curve = std::get<Curve>(geometry);
    return tube(to_picture(curve.points), curve.closed, tube_radius * diagonal());
  }

  Drawn_mesh contacts() const
  {
    std::vector<Drawn_mesh> spheres;
    for (const Contact& contact : structure_.contacts) {
      for (int side = 0; side < 2; ++side) {
        const Points world = evaluate(structure_.parts[contact.parts[side]], contact.parameters[side]);
        spheres.push_back(sphere(to_picture(world), contact_radius * diagonal()));
      }
    }
    return joined(spheres);
  }

private:
  const Shape_structure& structure_;
  const Segmented_shape* shape_;
  Eigen::Matrix3d turn_;
  Point lower_ = Point::Constant(1e300);
  Point upper_ = Point::Constant(-1e300);
};

/// Sets of things that belong together, by union and find.
class Components
{
public:
  explicit Components(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t(0)); }

  std::size_t find(std::size_t i) const
  {
    while (parent_[i] != i)
      i = parent_[i];
    return i;
  }

  /// The smallest element stands for its component.
  void join(std::size_t i, std::size_t j)
  {
    const std::size_t a = find(i), b = find(j);
    parent_[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::size_t> parent_;
};

/// Parts of both shapes that groups and pairs connect; target parts are numbered after the source's.
Components connected_parts(const Correspondence& correspondence, std::size_t sources, std::size_t targets)
{
  Components components(sources + targets);
  for (const Group_match& group : correspondence.groups) {
    if (group.source.empty() || group.target.empty()) continue;
    for (std::size_t s : group.source)
      components.join(group.source[0], s);
    for (std::size_t t : group.target)
      components.join(group.source[0], sources + t);
  }
  for (const auto& [s, t] : correspondence.pairs)
    components.join(s, sources + t);
  return components;
}

/// The material of every part, the target's after the source's: one a component, grey for parts in no pair.
std::vector<int> match_materials(const Correspondence& correspondence, std::size_t sources, std::size_t targets,
                                 Glb_builder& glb)
{
  const Components components = connected_parts(correspondence, sources, targets);
  std::vector<bool> matched(sources + targets, false);
  for (const auto& [s, t] : correspondence.pairs)
    matched[s] = matched[sources + t] = true;
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < matched.size(); ++i) {
    if (matched[i] && std::find(roots.begin(), roots.end(), components.find(i)) == roots.end())
      roots.push_back(components.find(i));
  }
  const std::vector<Colour> colours = distinct_colours(roots.size());
  std::vector<int> material_of_root;
  for (std::size_t i = 0; i < roots.size(); ++i)
    material_of_root.push_back(glb.add_material("match_" + std::to_string(i + 1), colours[i]));
  const int unmatched = glb.add_material("unmatched", grey());
  std::vector<int> materials(matched.size(), unmatched);
  for (std::size_t i = 0; i < matched.size(); ++i) {
    if (matched[i])
      materials[i] = material_of_root[std::find(roots.begin(), roots.end(), components.find(i)) - roots.begin()];
  }
  return materials;
}

/// \param materials of the shape's parts, from here on
int add_shape(Glb_builder& glb, const Drawn_shape& shape, const int* materials, const Point& translation)
{
  std::vector<int> nodes;
  for (std::size_t part = 0; part < shape.number_of_parts(); ++part) {
    const Drawn_mesh mesh = shape.has_mesh() ? shape.surface(part) : shape.abstraction(part);
    nodes.push_back(glb.add_node(shape.part_name(part), {{mesh, materials[part]}}));
  }
  return glb.add_node(shape.name(), nodes, translation);
}

} // namespace

void write_correspondence_glb(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                              const Structural_graph& target, const Segmented_shape* source_shape,
                              const Segmented_shape* target_shape)
{
  const Drawn_shape left(source, source_shape, 0);
  const Drawn_shape right(target, target_shape, correspondence.target_quarter_turns);
  Glb_builder glb;
  const std::vector<int> materials =
      match_materials(correspondence, left.number_of_parts(), right.number_of_parts(), glb);
  const double widths[] = {left.upper().x() - left.lower().x(), right.upper().x() - right.lower().x()};
  const double half_gap = gap / 2 * std::max(widths[0], widths[1]);
  const int first = add_shape(glb, left, materials.data(), Point(-half_gap - left.upper().x(), 0, 0));
  const int second =
      add_shape(glb, right, materials.data() + left.number_of_parts(), Point(half_gap - right.lower().x(), 0, 0));
  glb.write(out, {first, second});
}

void write_structural_graph_glb(std::ostream& out, const Structural_graph& graph, const Segmented_shape* shape)
{
  const Drawn_shape drawn(graph, shape, 0);
  const std::vector<std::size_t> group = group_of_parts(graph);
  const std::vector<Colour> colours = distinct_colours(num_vertices(graph));
  Glb_builder glb;
  std::vector<int> solid, faint, nodes;
  for (std::size_t v = 0; v < num_vertices(graph); ++v) {
    const std::string name = "group_" + std::to_string(v + 1);
    solid.push_back(glb.add_material(name, colours[v]));
    if (drawn.has_mesh()) faint.push_back(glb.add_material(name + "_surface", colours[v], surface_alpha));
  }
  for (std::size_t part = 0; part < drawn.number_of_parts(); ++part) {
    std::vector<std::pair<Drawn_mesh, int>> meshes{{drawn.abstraction(part), solid[group[part]]}};
    if (drawn.has_mesh()) meshes.emplace_back(drawn.surface(part), faint[group[part]]);
    nodes.push_back(glb.add_node(drawn.part_name(part), meshes));
  }
  const Drawn_mesh contacts = drawn.contacts();
  if (contacts.triangles.cols() > 0)
    nodes.push_back(glb.add_node("contacts", {{contacts, glb.add_material("contacts", Colour(0.02, 0.02, 0.02))}}));
  glb.write(out, {glb.add_node(drawn.name(), nodes, Point::Zero())});
}

} // namespace IO
} // namespace Shape_correspondence
} // namespace CGAL
