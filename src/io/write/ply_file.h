// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

struct Ply_part
{
  std::string name;
  Part_mesh mesh;
  std::vector<std::uint8_t> colours = {}; ///< red, green, blue of each point; all parts have them or none
  std::vector<int> labels = {};           ///< label of each triangle; all parts have them or none
};

/// Writes parts as one mesh in binary PLY, with the index of the part and that of the label for every face; comments
/// list the names of parts and labels, and the upright direction.
void write_ply(std::ostream& out, const Point& up, const std::vector<Ply_part>& parts,
               const std::vector<std::string>& labels = {});

} // namespace CGAL::Shape_correspondence::IO
