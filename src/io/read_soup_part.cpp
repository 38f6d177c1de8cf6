// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/model_parts.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Simple_cartesian.h>

#include <fstream>

namespace CGAL::Shape_correspondence::IO {
namespace {

using Soup_point = Simple_cartesian<double>::Point_3;
using Soup_points = std::vector<Soup_point>;
using Soup_polygons = std::vector<std::vector<std::size_t>>;

bool is_ply(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  std::string magic(3, ' ');
  in.read(magic.data(), 3);
  return magic == "ply";
}

} // namespace

std::vector<Model_part> read_soup_part(const std::string& file)
{
  Soup_points points;
  Soup_polygons polygons;
  std::ifstream in(file, std::ios::binary);
  const auto silent = CGAL::parameters::verbose(false);
  if (is_ply(file)) {
    // assimp knows more dialects, at single precision
    if (!CGAL::IO::read_PLY(in, points, polygons, silent)) return read_parts_with_assimp(file);
  } else if (!CGAL::IO::read_OFF(in, points, polygons, silent))
    throw Invalid_input(file + ": it cannot be read as an OFF model; it is another kind of file or damaged (a number "
                               "that is none, a face that uses a missing vertex)");
  if (polygons.empty()) throw Invalid_input(file + ": there is no face in it; a model needs a mesh for every part");
  Model_part part;
  std::vector<Point> polygon;
  for (const std::vector<std::size_t>& indices : polygons) {
    polygon.clear();
    for (std::size_t i : indices) {
      if (i >= points.size())
        throw Invalid_input(file + ": a face uses vertex " + std::to_string(i) + ", but there are only " +
                            std::to_string(points.size()) + " (numbered from 0)");
      polygon.emplace_back(points[i].x(), points[i].y(), points[i].z());
    }
    add_polygon(polygon, part.corners);
  }
  return {part};
}

} // namespace CGAL::Shape_correspondence::IO
