// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes a model with colours as GLB and reads it back, which uses the package's program for other formats.
#include <CGAL/Shape_correspondence/IO/appearance_files.h>

#include <fstream>
#include <iostream>

namespace SC = CGAL::Shape_correspondence;

int main()
{
  SC::Part_mesh mesh{SC::Points(3, 4), Eigen::Matrix3Xi(3, 4)};
  mesh.points << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
  mesh.triangles << 0, 0, 0, 1, 2, 1, 3, 2, 1, 3, 2, 3;
  SC::Segmented_shape shape("tetrahedron");
  shape.add_part("all", mesh);
  SC::Shape_appearance red, read;
  red.materials.push_back({"red", {1, 0, 0, 1}, -1});
  red.parts.push_back({std::vector<int>(4, 0), {}, {}});
  std::ofstream out("red.glb", std::ios::binary);
  SC::IO::write_segmented_shape_glb(out, shape, red);
  out.close();
  const SC::Segmented_shape again = SC::IO::read_shape_and_appearance("red.glb", read);
  std::cout << again.parts().size() << " part, " << read.materials.at(0).name << '\n';
  return again.parts()[0].mesh.triangles.cols() == 4 && read.materials[0].colour == red.materials[0].colour ? 0 : 1;
}
