// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/Json_field.h"
#include "io/read/model_parts.h"
#include "io/system/input_file.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>

#include <filesystem>

namespace CGAL::Shape_correspondence::IO {

std::optional<Segmented_shape> read_part_meshes(const std::string& graph_file, const Structural_graph& graph,
                                                const Reading_options& options)
{
  const std::vector<Json_field> parts = read_json_file(graph_file)["parts"].elements();
  std::size_t named = 0;
  for (const Json_field& part : parts)
    named += part.has("mesh");
  if (named == 0) return std::nullopt;
  const Shape_structure& shape = structure(graph);
  Segmented_shape result(shape.name, shape.frame.axes.col(1));
  for (const Json_field& part : parts) {
    const std::filesystem::path folder = std::filesystem::path(graph_file).parent_path();
    const std::string file = (folder / part["mesh"].text()).string();
    if (!options.allow_outside_files && std::filesystem::exists(file) && !is_in_folder_of(graph_file, file))
      part["mesh"].fail("names a file outside the folder of the graph; read it with --allow-outside-files");
    Part_mesh mesh; // all of the file
    const Segmented_shape shape_of_file = read_segmented_shape(file, Point::UnitY(), nullptr, options);
    for (const Shape_part& of_file : shape_of_file.parts())
      add_mesh(of_file.mesh, mesh);
    result.add_part(part["name"].text(), mesh);
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::IO
