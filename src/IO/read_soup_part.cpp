// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_parts.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <fstream>

namespace CGAL {
namespace Shape_correspondence {
namespace IO {
namespace {

using Soup_point = Exact_predicates_inexact_constructions_kernel::Point_3;
using Soup_points = std::vector<Soup_point>;
using Soup_polygons = std::vector<std::vector<std::size_t>>;

bool read_soup(const std::string& file, Soup_points& points, Soup_polygons& polygons)
{
  std::ifstream in(file, std::ios::binary);
  const std::string magic{static_cast<char>(in.get()), static_cast<char>(in.get()), static_cast<char>(in.get())};
  in.seekg(0);
  if (magic == "ply") return CGAL::IO::read_PLY(in, points, polygons);
  return CGAL::IO::read_OFF(in, points, polygons);
}

} // namespace

std::vector<Model_part> read_soup_part(const std::string& file)
{
  Soup_points points;
  Soup_polygons polygons;
  // assimp knows more dialects, at single precision
  if (!read_soup(file, points, polygons) || polygons.empty()) return read_parts_with_assimp(file);
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

} // namespace IO
} // namespace Shape_correspondence
} // namespace CGAL
