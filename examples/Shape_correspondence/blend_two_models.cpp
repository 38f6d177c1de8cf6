// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
// Blends the shapes of two model files: prints the tasks that lead from one to the other, writes shapes in between.
#include <CGAL/Shape_correspondence.h>
#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/IO/write_blend.h>

#include <fstream>
#include <iostream>

namespace SC = CGAL::Shape_correspondence;

int main(int argc, char** argv)
{
  const std::string source_file = argc > 1 ? argv[1] : DATA_DIR "/chair_four_legged";
  const std::string target_file = argc > 2 ? argv[2] : DATA_DIR "/chair_slatted";
  try {
    const SC::Segmented_shape source = SC::IO::read_segmented_shape(source_file);
    const SC::Segmented_shape target = SC::IO::read_segmented_shape(target_file);
    const auto source_graph = SC::build_structural_graph<CGAL::Parallel_if_available_tag>(source);
    const auto target_graph = SC::build_structural_graph<CGAL::Parallel_if_available_tag>(target);
    const SC::Correspondence correspondence = SC::find_correspondence(source_graph, target_graph);

    const SC::Shape_blend blend(source_graph, source, target_graph, target, correspondence);

    static constexpr const char* names[] = {"morph", "split", "merge", "shrink", "grow"};
    for (const SC::Blend_task& task : blend.schedules()[0].tasks) {
      std::cout << task.begin << " to " << task.end << ": " << names[int(task.type)];
      if (task.source != task.no_part) std::cout << ' ' << source.parts()[task.source].name;
      if (task.target != task.no_part) std::cout << " -> " << target.parts()[task.target].name;
      std::cout << '\n';
    }
    for (int i = 0; i <= 4; ++i) {
      std::ofstream out("blend_" + std::to_string(i) + ".obj");
      SC::IO::write_segmented_shape_obj(out, blend(i / 4.));
    }
    std::ofstream animation("blend.glb", std::ios::binary);
    SC::IO::write_blend_glb(animation, blend, correspondence, 25);
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
