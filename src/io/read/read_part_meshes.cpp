// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/Json_field.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <filesystem>

namespace CGAL::Shape_correspondence::IO {
namespace {

/// All of a file as one mesh.
Part_mesh read_mesh(const std::string& path)
{
  const Segmented_shape file = read_segmented_shape(path);
  Part_mesh result = file.parts()[0].mesh;
  for (std::size_t i = 1; i < file.parts().size(); ++i) {
    const Part_mesh& next = file.parts()[i].mesh;
    const Eigen::Index points = result.points.cols(), triangles = result.triangles.cols();
    result.points.conservativeResize(Eigen::NoChange, points + next.points.cols());
    result.points.rightCols(next.points.cols()) = next.points;
    result.triangles.conservativeResize(Eigen::NoChange, triangles + next.triangles.cols());
    result.triangles.rightCols(next.triangles.cols()) = next.triangles.array() + int(points);
  }
  return result;
}

} // namespace

std::optional<Segmented_shape> read_part_meshes(const std::string& graph_file, const Structural_graph& graph)
{
  const std::vector<Json_field> parts = read_json_file(graph_file)["parts"].elements();
  std::size_t named = 0;
  for (const Json_field& part : parts)
    named += part.has("mesh");
  if (named == 0) return std::nullopt;
  const Shape_structure& shape = structure(graph);
  Segmented_shape result(shape.name, shape.frame.axes.col(1));
  for (const Json_field& part : parts) {
    const std::filesystem::path mesh = part["mesh"].text();
    result.add_part(part["name"].text(), read_mesh((std::filesystem::path(graph_file).parent_path() / mesh).string()));
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::IO
