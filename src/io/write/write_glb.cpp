// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/colours.h"
#include "io/write/drawn_shape.h"
#include "io/write/dressed_mesh.h"
#include "io/write/picture_geometry.h"

#include <CGAL/Shape_correspondence/IO/write_glb.h>

#include <Eigen/Geometry>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr double glb_surface_alpha = 0.25;

/// A node for each part. \param materials of the shape's parts, from here on
int add_shape(Glb_builder& glb, const Drawn_shape& shape, const int* materials, const Point& translation,
              Drawn_mesh (Drawn_shape::*mesh)(std::size_t) const)
{
  std::vector<int> nodes;
  for (std::size_t part = 0; part < shape.number_of_parts(); ++part) {
    nodes.push_back(glb.add_node(shape.part(part).name, {{(shape.*mesh)(part), materials[part]}}));
    glb.set_node_extras(nodes.back(), {{"part", part}});
  }
  return glb.add_node(shape.name(), nodes, translation);
}

/// A node for all contacts.
int add_contacts(Glb_builder& glb, const Drawn_shape& shape)
{
  return glb.add_node("contacts", {{shape.contacts(), glb.add_material("contacts", Colour(0.02, 0.02, 0.02))}});
}

/// The same with the shape's own materials.
int add_dressed_shape(Glb_builder& glb, const Drawn_shape& shape, const Shape_appearance* appearance,
                      const Point& translation)
{
  const Shape_appearance none;
  const Shape_appearance& looks = appearance ? *appearance : none;
  Glb_materials materials(glb, looks);
  std::vector<int> nodes;
  for (std::size_t part = 0; part < shape.number_of_parts(); ++part) {
    const Part_appearance unknown;
    const Part_appearance& of_part = part < looks.parts.size() ? looks.parts[part] : unknown;
    Drawn_mesh mesh = shape.best_mesh(part);
    mesh.layer = material_layer;
    nodes.push_back(glb.add_node(shape.part(part).name, dressed(mesh, of_part, materials)));
    glb.set_node_extras(nodes.back(), {{"part", part}});
  }
  return glb.add_node(shape.name(), nodes, translation);
}

bool is_dressed(const Shape_appearance* appearance) { return appearance && !appearance->empty(); }

} // namespace

void write_correspondence_glb(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                              const Structural_graph& target, const Segmented_shape* source_shape,
                              const Segmented_shape* target_shape, const Shape_appearance* source_appearance,
                              const Shape_appearance* target_appearance)
{
  const Drawn_shape left(source, source_shape, 0);
  const Drawn_shape right(target, target_shape, correspondence.target_quarter_turns);
  Glb_builder glb;
  const std::vector<int> materials =
      add_match_materials(glb, correspondence, left.number_of_parts(), right.number_of_parts());
  const std::array<Point, 2> places = side_by_side(left, right);
  const auto scene = [&](const char* name, Drawn_mesh (Drawn_shape::*mesh)(std::size_t) const) {
    return Glb_scene{name,
                     {add_shape(glb, left, materials.data(), places[0], mesh),
                      add_shape(glb, right, materials.data() + left.number_of_parts(), places[1], mesh)}};
  };
  std::vector<Glb_scene> scenes{scene("correspondence", &Drawn_shape::best_mesh)};
  if (left.has_mesh() || right.has_mesh()) scenes.push_back(scene(abstraction_layer, &Drawn_shape::abstraction));
  if (is_dressed(source_appearance) || is_dressed(target_appearance))
    scenes.push_back({material_layer,
                      {add_dressed_shape(glb, left, source_appearance, places[0]),
                       add_dressed_shape(glb, right, target_appearance, places[1])}});
  scenes.push_back({contact_layer, {}});
  for (const auto& [shape, place] : {std::pair(&left, places[0]), std::pair(&right, places[1])})
    scenes.back().roots.push_back(glb.add_node(shape->name(), {add_contacts(glb, *shape)}, place));
  glb.write(out, scenes);
}

void write_structural_graph_glb(std::ostream& out, const Structural_graph& graph, const Segmented_shape* shape,
                                const Shape_appearance* appearance)
{
  const Drawn_shape drawn(graph, shape, 0);
  const std::vector<std::size_t> group = group_of_parts(graph);
  const std::vector<Colour> colours = distinct_colours(num_vertices(graph));
  Glb_builder glb;
  std::vector<int> solid, faint, nodes;
  for (std::size_t v = 0; v < num_vertices(graph); ++v) {
    const std::string name = "group_" + std::to_string(v + 1);
    solid.push_back(glb.add_material(name, colours[v]));
    if (drawn.has_mesh()) faint.push_back(glb.add_material(name + "_surface", colours[v], glb_surface_alpha));
  }
  for (std::size_t part = 0; part < drawn.number_of_parts(); ++part) {
    std::vector<std::pair<Drawn_mesh, int>> meshes{{drawn.abstraction(part), solid[group[part]]}};
    if (drawn.has_mesh()) meshes.emplace_back(drawn.surface(part), faint[group[part]]);
    nodes.push_back(glb.add_node(drawn.part(part).name, meshes));
    glb.set_node_extras(nodes.back(), {{"part", part}});
  }
  if (!structure(graph).contacts.empty()) nodes.push_back(add_contacts(glb, drawn));
  std::vector<Glb_scene> scenes{{"structural graph", {glb.add_node(drawn.name(), nodes, Point::Zero())}}};
  if (is_dressed(appearance))
    scenes.push_back({material_layer, {add_dressed_shape(glb, drawn, appearance, Point::Zero())}});
  glb.write(out, scenes);
}

void write_segmented_shape_glb(std::ostream& out, const Segmented_shape& shape, const Shape_appearance& appearance)
{
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity(); // glTF has y up
  if (shape.up() != Point::UnitY())
    turn = Eigen::Quaterniond::FromTwoVectors(shape.up(), Point::UnitY()).toRotationMatrix();
  Glb_builder glb;
  Glb_materials materials(glb, appearance);
  std::vector<int> nodes;
  for (std::size_t part = 0; part < shape.parts().size(); ++part) {
    const Part_appearance unknown;
    const Part_mesh& mesh = shape.parts()[part].mesh;
    const Part_appearance& looks = part < appearance.parts.size() ? appearance.parts[part] : unknown;
    const Points points = turn * mesh.points;
    nodes.push_back(glb.add_node(shape.parts()[part].name, dressed(shaded(points, mesh.triangles), looks, materials)));
  }
  glb.write(out, {{shape.name(), {glb.add_node(shape.name(), nodes, Point::Zero())}}});
}

} // namespace CGAL::Shape_correspondence::IO
