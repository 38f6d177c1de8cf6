// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write/drawn_shape.h"
#include "base/quarter_turn.h"
#include "io/system/colours.h"
#include "io/write/picture_geometry.h"

#include <CGAL/Shape_correspondence/correspondence_blocks.h>

#include <algorithm>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr double gap = 0.25;          // between the shapes, over the wider one's width
constexpr double tube_radius = 0.009; // over the shape's diagonal
const Eigen::Vector2d middle_parameter(0.5, 0.5);

Drawn_mesh on_layer(const char* layer, Drawn_mesh mesh)
{
  mesh.layer = layer;
  return mesh;
}

} // namespace

Drawn_shape::Drawn_shape(const Structural_graph& graph, const Segmented_shape* shape, int turns)
    : structure_(structure(graph)), shape_(shape), turn_(internal::quarter_turn(turns))
{
  for (std::size_t part = 0; part < structure_.parts.size(); ++part) {
    const Points points = has_mesh() ? shape_->parts()[part].mesh.points : structure_.parts[part].control_points();
    const Points drawn = to_picture(points);
    lower_ = lower_.cwiseMin(drawn.rowwise().minCoeff());
    upper_ = upper_.cwiseMax(drawn.rowwise().maxCoeff());
  }
}

Drawn_mesh Drawn_shape::surface(std::size_t part) const
{
  const Part_mesh& mesh = shape_->parts()[part].mesh;
  return on_layer(surface_layer, shaded(to_picture(mesh.points), mesh.triangles));
}

Drawn_mesh Drawn_shape::flat_surface(std::size_t part) const
{
  const Part_mesh& mesh = shape_->parts()[part].mesh;
  return on_layer(surface_layer, {to_picture(mesh.points), {}, mesh.triangles});
}

Drawn_mesh Drawn_shape::abstraction(std::size_t part) const
{
  const auto& geometry = structure_.parts[part].geometry;
  if (const Sheet* sheet = std::get_if<Sheet>(&geometry))
    return on_layer(abstraction_layer, patch(to_picture(sheet->points), sheet->rows, sheet->cols));
  const Curve& curve = std::get<Curve>(geometry);
  return on_layer(abstraction_layer, tube(to_picture(curve.points), curve.closed, tube_radius * diagonal()));
}

Drawn_mesh Drawn_shape::contacts() const
{
  constexpr int steps = 3; // of a line
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

std::array<Point, 2> side_by_side(const Drawn_shape& left, const Drawn_shape& right)
{
  const double widths[] = {left.upper().x() - left.lower().x(), right.upper().x() - right.lower().x()};
  const double half_gap = gap / 2 * std::max(widths[0], widths[1]);
  return {Point(-half_gap - left.upper().x(), 0, 0), Point(half_gap - right.lower().x(), 0, 0)};
}

std::vector<int> match_numbers(const Correspondence& correspondence, std::size_t sources, std::size_t targets)
{
  std::vector<int> result(sources + targets, -1);
  int number = 0;
  for (const Correspondence_block& block : correspondence_blocks(correspondence)) {
    for (std::size_t part : block.source)
      result[part] = number;
    for (std::size_t part : block.target)
      result[sources + part] = number;
    ++number;
  }
  return result;
}

std::vector<int> add_match_materials(Glb_builder& glb, const Correspondence& correspondence, std::size_t sources,
                                     std::size_t targets)
{
  std::vector<int> result = match_numbers(correspondence, sources, targets);
  const int matches = 1 + *std::max_element(result.begin(), result.end());
  int number = 0;
  for (const Colour& colour : distinct_colours(static_cast<std::size_t>(matches)))
    glb.add_material("match_" + std::to_string(++number), colour);
  const int unmatched = glb.add_material("unmatched", grey());
  std::replace(result.begin(), result.end(), -1, unmatched);
  return result;
}

} // namespace CGAL::Shape_correspondence::IO
