// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Matches the largest shapes that each method accepts, rings of boxes that all differ: benchmark_limits
// Prints one line for each method; exit status 1 if one takes more than `most_seconds`.

#include "../../test/Shape_correspondence/box_shapes.h"
#include "base/limits.h"

#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <CGAL/Timer.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <random>
#include <string>

namespace SC = CGAL::Shape_correspondence;

namespace {

constexpr double most_seconds = 30; // limit of the processor time of a match

struct Limit
{
  const char* name;
  SC::Search_method method;
  std::size_t parts;
  int coarse_parts = 0; // number of parts of each shape that are matched first; 0: all at once
};

constexpr Limit limits[] = {{"parts", SC::Search_method::PARTS, SC::internal::most_parts},
                            {"beam search", SC::Search_method::BEAM, SC::internal::most_beam_groups},
                            {"exact search", SC::Search_method::EXACT, SC::internal::most_exact_groups},
                            {"beam search, coarse to fine", SC::Search_method::BEAM, 500, 50},
                            {"exact search, coarse to fine", SC::Search_method::EXACT, SC::internal::most_parts, 50}};

// A ring of boxes of random heights, each in contact with the next.
SC::Structural_graph ring(std::size_t parts, unsigned seed)
{
  std::mt19937 random(seed);
  const double angle = 2 * EIGEN_PI / double(parts), radius = 1 / angle; // a box is 1 wide
  SC::Segmented_shape shape;
  for (std::size_t i = 0; i < parts; ++i) {
    const double height = 1 + double(random()) / double(std::mt19937::max());
    const SC::Point centre(radius, height / 2, 0), size(1, height, 1.01);
    shape.add_part("box " + std::to_string(i), box_shapes::box(centre, size, angle * double(i)));
  }
  SC::Structure_options options;
  options.abstraction.abstractor = SC::Bounding_box_abstraction();
  options.symmetry.enabled = false;
  options.contacts.tolerance = 1e-6;
  return build_structural_graph(shape, options);
}

double seconds_of_match(const Limit& limit)
{
  const SC::Structural_graph source = ring(limit.parts, 0), target = ring(limit.parts, 1);
  SC::Search_options options;
  options.method = limit.method;
  options.coarse_to_fine = limit.coarse_parts;
  CGAL::Timer timer;
  timer.start();
  const SC::Correspondence found = find_correspondence(source, target, options);
  const double seconds = timer.time();
  std::printf("%-29s %zu parts, %zu groups, %zu contacts: %.1f s, %zu pairs\n", limit.name, limit.parts,
              num_vertices(source), SC::structure(source).contacts.size(), seconds, found.pairs.size());
  return seconds;
}

} // namespace

int main()
{
  try {
    bool is_exceeded = false;
    for (const Limit& limit : limits)
      is_exceeded |= seconds_of_match(limit) > most_seconds;
    return is_exceeded ? EXIT_FAILURE : EXIT_SUCCESS;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "benchmark_limits: %s\n", e.what());
    return EXIT_FAILURE;
  }
}
