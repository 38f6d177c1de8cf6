// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Abstracts damaged part meshes: fuzz_abstraction [CASES [FIRST_SEED [LARGEST]]], 2000 cases from seed 0 with up to
// 200000 triangles by default. Every result must be valid, or an error that names the part, and come in time. Prints
// one line for each failure, and a summary; exit status 1 if there are failures.

#include "../../test/Shape_correspondence/damaged_meshes.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/abstract_part.h>

#include <CGAL/Timer.h>

#include <cstdio>
#include <cstdlib>
#include <map>

namespace SC = CGAL::Shape_correspondence;

namespace {

// Limit of the abstraction of a part, and time beyond it for steps that cannot be interrupted; in seconds.
#ifdef __SANITIZE_ADDRESS__
constexpr double time_limit = 60, slack = 60; // sanitized code is ten times slower
#else
constexpr double time_limit = 5, slack = 5;
#endif
constexpr unsigned long progress_step = 100;

struct Summary
{
  int valid = 0, refused = 0, failed = 0;
  double slowest = 0;
  std::map<std::string, int> fallbacks;
};

bool is_valid(const SC::Part_abstraction& part)
{
  return part.control_points().cols() >= 2 && part.control_points().allFinite() && part.surface.allFinite() &&
         part.hull.allFinite() && std::isfinite(part.volume) && std::isfinite(part.hull_volume) && part.area > 0;
}

void fail(unsigned long seed, const char* what, Summary& summary)
{
  std::printf("seed %lu: %s\n", seed, what);
  ++summary.failed;
}

void run_case(unsigned long seed, double largest, Summary& summary)
{
  SC::Part_mesh mesh = damaged_meshes::damaged_mesh(seed, largest);
  const auto triangles = static_cast<long>(mesh.triangles.cols());
  SC::Abstraction_options options;
  options.time_limit = time_limit;
  CGAL::Timer timer; // processor time, so that no case fails because the machine is busy
  timer.start();
  try {
    SC::Segmented_shape shape;
    shape.add_part("damaged", std::move(mesh));
    const SC::Part_abstraction part = SC::abstract_part(shape.parts()[0], options);
    if (!is_valid(part)) return fail(seed, "the result is not valid", summary);
    ++summary.valid;
    ++summary.fallbacks[part.report.fallback];
  } catch (const SC::Invalid_input& error) {
    if (std::string(error.what()).find("'damaged'") == std::string::npos) return fail(seed, error.what(), summary);
    ++summary.refused;
  } catch (const std::exception& error) {
    return fail(seed, error.what(), summary);
  }
  if (timer.time() > time_limit + slack)
    fail(seed,
         ("it took " + std::to_string(timer.time()) + " s for " + std::to_string(triangles) + " triangles").c_str(),
         summary);
  summary.slowest = std::max(summary.slowest, timer.time());
}

} // namespace

int main(int argc, char** argv)
{
  const unsigned long cases = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 2000;
  const unsigned long first = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 0;
  const double largest = argc > 3 ? std::strtod(argv[3], nullptr) : 200000;
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  Summary summary;
  for (unsigned long seed = first; seed < first + cases; ++seed) {
    run_case(seed, largest, summary);
    if ((seed + 1 - first) % progress_step == 0) std::fprintf(stderr, "%lu cases done\n", seed + 1 - first);
  }
  std::printf("%lu cases: %d valid, %d refused by name, %d failed; slowest %.2f s\n", cases, summary.valid,
              summary.refused, summary.failed, summary.slowest);
  for (const auto& [reason, count] : summary.fallbacks)
    std::printf("  %5d %s\n", count, reason.empty() ? "curves and sheets of the flow" : ("boxes: " + reason).c_str());
  return summary.failed > 0;
}
