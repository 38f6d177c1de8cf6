// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
// Transfers colours from one shape to another along their correspondence: stripes across every part of the source.
// Writes both shapes as PLY with coloured vertices.
#include <CGAL/Shape_correspondence.h>
#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>

#include <cmath>
#include <fstream>

namespace SC = CGAL::Shape_correspondence;
using Colours = std::vector<std::vector<Eigen::Vector3d>>; // by part and vertex

void write_ply(const std::string& file, const SC::Segmented_shape& shape, const Colours& colours)
{
  Eigen::Index points = 0, triangles = 0, first = 0;
  for (const SC::Shape_part& part : shape.parts())
    points += part.mesh.points.cols(), triangles += part.mesh.triangles.cols();
  std::ofstream out(file);
  out << "ply\nformat ascii 1.0\nelement vertex " << points
      << "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
      << "property uchar blue\nelement face " << triangles << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t i = 0; i < colours.size(); ++i)
    for (std::size_t v = 0; v < colours[i].size(); ++v)
      out << shape.parts()[i].mesh.points.col(Eigen::Index(v)).transpose() << ' '
          << (255 * colours[i][v]).cast<int>().transpose() << '\n';
  for (const SC::Shape_part& part : shape.parts()) {
    for (const auto& t : part.mesh.triangles.colwise())
      out << "3 " << (t.array() + int(first)).transpose() << '\n';
    first += part.mesh.points.cols();
  }
}

int main(int argc, char** argv)
{
  const SC::Segmented_shape source = SC::IO::read_segmented_shape(argc > 1 ? argv[1] : DATA_DIR "/chair_spindle");
  const SC::Segmented_shape target = SC::IO::read_segmented_shape(argc > 2 ? argv[2] : DATA_DIR "/stool");
  const SC::Structural_graph from = SC::build_structural_graph<CGAL::Parallel_if_available_tag>(source);
  const SC::Structural_graph to = SC::build_structural_graph<CGAL::Parallel_if_available_tag>(target);

  Colours colours;
  for (const SC::Part_abstraction& part : SC::structure(from).parts) {
    colours.emplace_back();
    for (const auto& p : source.parts()[colours.size() - 1].mesh.points.colwise()) {
      const Eigen::Vector2d parameter = SC::nearest_parameter(part, p);
      colours.back().emplace_back(parameter[0], parameter[1], std::fmod(8 * parameter[0], 1.) < 0.5 ? 0.9 : 0.2);
    }
  }
  const SC::Surface_map map(from, source, to, target, SC::find_correspondence(from, to));
  const Eigen::Vector3d grey(0.5, 0.5, 0.5); // colour of points without a counterpart

  write_ply("source.ply", source, colours);
  write_ply("target.ply", target, map.transferred(colours, grey));
}
