// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/directions.h"
#include "io/system/colours.h"
#include "io/write/pictures.h"

#include <CGAL/Shape_correspondence/IO/write_glb.h>
#include <CGAL/Shape_correspondence/correspondence_blocks.h>

#include <algorithm>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr double gap = 0.25;          // gap between the shapes, over the greater width
constexpr double tube_radius = 0.009; // radius of a tube, over the shape's diagonal
constexpr double surface_alpha = 0.25;
constexpr double coarse_tolerance = 0.002; // deviation of coarse curves and sheets, over the diagonal
const Eigen::Vector2d middle_parameter(0.5, 0.5);

Drawn_mesh on_layer(const char* layer, Drawn_mesh mesh)
{
  mesh.layer = layer;
  return mesh;
}

Drawn_mesh of_material(int material, Drawn_mesh mesh)
{
  mesh.material = material;
  return mesh;
}

/// At most `most` of the indices 0 to `count` - 1 at even steps, including the first and the last.
std::vector<int> evenly(int count, int most)
{
  const int n = std::min(count, most);
  std::vector<int> result(1, 0);
  for (int i = 1; i < n; ++i)
    result.push_back(i * (count - 1) / (n - 1));
  return result;
}

/// Whether the points of a polyline are at most `tolerance` from the lines through consecutive points of these indices.
bool is_shown(const Points& line, const std::vector<int>& indices, double tolerance)
{
  for (std::size_t k = 1; k < indices.size(); ++k) {
    const Point begin = line.col(indices[k - 1]), along = (line.col(indices[k]) - begin).normalized();
    for (int i = indices[k - 1] + 1; i < indices[k]; ++i) {
      const Point p = line.col(i) - begin;
      if ((p - along.dot(p) * along).norm() > tolerance) return false;
    }
  }
  return true;
}

/// The fewest indices at even steps, at most `most`, that show polylines of equally many points within `tolerance`.
std::vector<int> fewest(const std::vector<Points>& lines, int most, double tolerance)
{
  const int count = int(lines[0].cols());
  int n = 2;
  while (n < most && !std::all_of(lines.begin(), lines.end(),
                                  [&](const Points& line) { return is_shown(line, evenly(count, n), tolerance); }))
    ++n;
  return evenly(count, n);
}

/// The translations that put two shapes side by side.
std::array<Point, 2> side_by_side(const Drawn_shape& left, const Drawn_shape& right)
{
  const double widths[] = {left.upper().x() - left.lower().x(), right.upper().x() - right.lower().x()};
  const double half_gap = gap / 2 * std::max(widths[0], widths[1]);
  return {Point(-half_gap - left.upper().x(), 0, 0), Point(half_gap - right.lower().x(), 0, 0)};
}

int add_contacts(Glb_file& glb, const Drawn_shape& shape)
{
  const int black = glb.add_material("contacts", Colour(0.02, 0.02, 0.02));
  return glb.add_node("contacts", {of_material(black, shape.contacts())});
}

} // namespace

Drawn_shape::Drawn_shape(const Structural_graph& graph, const Segmented_shape* model, int turns)
    : structure_(structure(graph)), model_(model), turn_(internal::quarter_turn(turns))
{
  for (std::size_t part = 0; part < structure_.parts.size(); ++part) {
    const Points points = model_ ? model_->parts()[part].mesh.points : structure_.parts[part].control_points();
    const Points drawn = to_picture(points);
    lower_ = lower_.cwiseMin(drawn.rowwise().minCoeff());
    upper_ = upper_.cwiseMax(drawn.rowwise().maxCoeff());
  }
}

Drawn_mesh Drawn_shape::surface(std::size_t part) const
{
  const Part_mesh& mesh = model_->parts()[part].mesh;
  return on_layer(surface_layer, shaded(to_picture(mesh.points), mesh.triangles));
}

Drawn_mesh Drawn_shape::flat_surface(std::size_t part) const
{
  const Part_mesh& mesh = model_->parts()[part].mesh;
  return on_layer(surface_layer, {to_picture(mesh.points), {}, mesh.triangles});
}

Drawn_mesh Drawn_shape::coarse_abstraction(std::size_t part) const
{
  const int most_open = 5, most_closed = 8, most_rows = 4, sides = 4;
  const double diagonal = (upper_ - lower_).norm(), tolerance = coarse_tolerance * diagonal;
  const auto& geometry = structure_.parts[part].geometry;
  Drawn_mesh mesh;
  if (const Sheet* sheet = std::get_if<Sheet>(&geometry)) {
    std::vector<Points> along_rows, along_cols;
    for (int row = 0; row < sheet->rows; ++row)
      along_rows.push_back(sheet->points.middleCols(Eigen::Index(row) * sheet->cols, sheet->cols));
    for (int col = 0; col < sheet->cols; ++col)
      along_cols.push_back(sheet->points(Eigen::indexing::all, Eigen::seqN(col, sheet->rows, sheet->cols)));
    const std::vector<int> rows = fewest(along_cols, most_rows, tolerance),
                           cols = fewest(along_rows, most_rows, tolerance);
    Points grid(3, Eigen::Index(rows.size() * cols.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < cols.size(); ++j)
        grid.col(Eigen::Index(i * cols.size() + j)) = sheet->points.col(Eigen::Index(rows[i]) * sheet->cols + cols[j]);
    mesh = patch(to_picture(grid), int(rows.size()), int(cols.size()));
  } else {
    const Curve& curve = std::get<Curve>(geometry);
    const Points rings =
        curve.points(Eigen::indexing::all, curve.closed ? evenly(int(curve.points.cols()), most_closed)
                                                        : fewest({curve.points}, most_open, tolerance));
    mesh = open_tube(to_picture(rings), curve.closed, tube_radius * diagonal, sides);
  }
  mesh.normals.resize(3, 0);
  return on_layer(abstraction_layer, std::move(mesh));
}

Drawn_mesh Drawn_shape::abstraction(std::size_t part) const
{
  const auto& geometry = structure_.parts[part].geometry;
  if (const Sheet* sheet = std::get_if<Sheet>(&geometry))
    return on_layer(abstraction_layer, patch(to_picture(sheet->points), sheet->rows, sheet->cols));
  const Curve& curve = std::get<Curve>(geometry);
  return on_layer(abstraction_layer,
                  tube(to_picture(curve.points), curve.closed, tube_radius * (upper_ - lower_).norm()));
}

Drawn_mesh Drawn_shape::contacts() const
{
  constexpr int steps = 3; // number of segments of a line
  const auto n = static_cast<Eigen::Index>(structure_.contacts.size());
  Points ends(3, (steps + 1) * n);
  Drawn_mesh result;
  result.lines.resize(2, steps * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Contact& contact = structure_.contacts[static_cast<std::size_t>(i)];
    const Part_abstraction &first = structure_.parts[contact.parts[0]], &second = structure_.parts[contact.parts[1]];
    ends.middleCols<steps + 1>((steps + 1) * i) << evaluate(first, middle_parameter),
        evaluate(first, contact.parameters[0]), evaluate(second, contact.parameters[1]),
        evaluate(second, middle_parameter);
    for (int step = 0; step < steps; ++step)
      result.lines.col(steps * i + step) =
          Eigen::Vector2i::Constant(int((steps + 1) * i) + step) + Eigen::Vector2i(0, 1);
  }
  result.points = to_picture(ends);
  return on_layer(contact_layer, result);
}

int Drawn_shape::add_to(Glb_file& glb, const Point& translation,
                        const std::function<std::vector<Drawn_mesh>(std::size_t part)>& draw) const
{
  std::vector<int> nodes;
  for (std::size_t part = 0; part < number_of_parts(); ++part) {
    nodes.push_back(glb.add_node(name(part), draw(part)));
    glb.set_node_extras(nodes.back(), {{"part", part}});
  }
  return glb.add_node(name(), nodes, translation);
}

std::vector<int> add_match_materials(Glb_file& glb, const Correspondence& correspondence, std::size_t sources,
                                     std::size_t targets)
{
  const std::vector<Correspondence_block> blocks = correspondence_blocks(correspondence);
  std::vector<int> materials;
  std::vector<std::string> roles;
  for (const Correspondence_block& block : blocks)
    roles.push_back(block.role);
  for (const Colour& colour : colours_of_roles(roles))
    materials.push_back(glb.add_material("match_" + std::to_string(materials.size() + 1), colour));
  std::vector<int> result(sources + targets, glb.add_material("unmatched", grey()));
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    for (std::size_t part : blocks[block].source)
      result[part] = materials[block];
    for (std::size_t part : blocks[block].target)
      result[sources + part] = materials[block];
  }
  return result;
}

void write_correspondence_glb(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                              const Structural_graph& target, const Segmented_shape* source_shape,
                              const Segmented_shape* target_shape, const Add_scenes& add_scenes)
{
  const Drawn_shape left(source, source_shape, 0);
  const Drawn_shape right(target, target_shape, correspondence.target_quarter_turns);
  const std::array<Point, 2> places = side_by_side(left, right);
  const std::vector<Placed_shape> shapes = {{left, places[0]}, {right, places[1]}};
  Glb_file glb;
  const std::vector<int> materials =
      add_match_materials(glb, correspondence, left.number_of_parts(), right.number_of_parts());
  const auto scene = [&](const char* name, Drawn_mesh (Drawn_shape::*mesh)(std::size_t) const) {
    Glb_scene result{name, {}};
    const int* material = materials.data();
    for (const auto& [shape, place] : shapes) {
      const auto draw = [&, &drawn = shape](std::size_t part) {
        return std::vector<Drawn_mesh>{of_material(material[part], (drawn.*mesh)(part))};
      };
      result.roots.push_back(shape.add_to(glb, place, draw));
      material += shape.number_of_parts();
    }
    return result;
  };
  std::vector<Glb_scene> scenes{scene("correspondence", &Drawn_shape::best_mesh)};
  if (source_shape || target_shape) scenes.push_back(scene(abstraction_layer, &Drawn_shape::abstraction));
  if (add_scenes) add_scenes(glb, shapes, scenes);
  scenes.push_back({contact_layer, {}});
  for (const auto& [shape, place] : shapes)
    scenes.back().roots.push_back(glb.add_node(shape.name(), {add_contacts(glb, shape)}, place));
  glb.write(out, scenes);
}

void write_structural_graph_glb(std::ostream& out, const Structural_graph& graph, const Segmented_shape* shape,
                                const Add_scenes& add_scenes)
{
  const Drawn_shape drawn(graph, shape, 0);
  const std::vector<std::size_t> group = group_of_parts(graph);
  Glb_file glb;
  std::vector<int> solid, faint, nodes;
  for (const Colour& colour : distinct_colours(num_vertices(graph))) {
    const std::string name = "group_" + std::to_string(solid.size() + 1);
    solid.push_back(glb.add_material(name, colour));
    if (shape) faint.push_back(glb.add_material(name + "_surface", colour, surface_alpha));
  }
  for (std::size_t part = 0; part < drawn.number_of_parts(); ++part) {
    std::vector<Drawn_mesh> meshes{of_material(solid[group[part]], drawn.abstraction(part))};
    if (shape) meshes.push_back(of_material(faint[group[part]], drawn.surface(part)));
    nodes.push_back(glb.add_node(drawn.name(part), meshes));
    glb.set_node_extras(nodes.back(), {{"part", part}});
  }
  if (!structure(graph).contacts.empty()) nodes.push_back(add_contacts(glb, drawn));
  std::vector<Glb_scene> scenes{{"structural graph", {glb.add_node(drawn.name(), nodes, Point::Zero())}}};
  if (add_scenes) add_scenes(glb, {{drawn}}, scenes);
  glb.write(out, scenes);
}

void write_correspondence_glb(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                              const Structural_graph& target, const Segmented_shape* source_shape,
                              const Segmented_shape* target_shape)
{
  write_correspondence_glb(out, correspondence, source, target, source_shape, target_shape, Add_scenes());
}

void write_structural_graph_glb(std::ostream& out, const Structural_graph& graph, const Segmented_shape* shape)
{
  write_structural_graph_glb(out, graph, shape, Add_scenes());
}

} // namespace CGAL::Shape_correspondence::IO
