// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Blends pairs of models and checks every in-between shape:
//   benchmark_blend [--frames N] [--cache FOLDER] [--search parts|beam|exact] SOURCE TARGET [SOURCE TARGET]...
// A line a pair. All lengths are over the shape's height, of the in-between shapes the worst:
//   open       parts that are not closed though the parts that they are made of are
//   gap        by how much a contact that is to be kept is wider than at the ends
//   apart      the widest gap that it takes to join all parts, and the same at the ends
//   asymmetry  how much farther it is from its mirror image than the ends, root mean square
//   start, end the Hausdorff distance of what is seen from the source just after 0, and from the target just before 1
// and a line for everything that does not hold within the tolerances of `Shape_blend`.
// Ends with exit status 1 if a part is open that must not be, or an end is not the input, moved.
#include "blend_checks.h"
#include "command_line.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_cache.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>
#include <stdexcept>

namespace {

using namespace CGAL::Shape_correspondence;
using namespace blend_checks;

struct Model
{
  Segmented_shape shape;
  Structural_graph graph;
};

Model load(const std::string& path, const std::string& cache_folder)
{
  Model model{IO::read_segmented_shape(path), {}};
  const std::string content = IO::content_hash(model.shape, {});
  std::optional<IO::Structural_graph_cache> cache;
  if (!cache_folder.empty()) cache.emplace(cache_folder);
  if (std::optional<Structural_graph> known = cache ? cache->find(content) : std::nullopt) {
    model.graph = *known;
    return model;
  }
  model.graph = build_structural_graph<CGAL::Parallel_if_available_tag>(model.shape);
  structure(model.graph).content = content;
  if (cache) cache->insert(model.graph);
  return model;
}

/// Whether the parts that a part of a blend is made of are closed.
std::map<std::string, bool> must_be_closed(const Shape_blend& blend, const Model& source, const Model& target)
{
  std::map<std::string, bool> result;
  for (const Blend_surface& surface : blend.surfaces()) {
    const auto closed = [](const Model& model, std::size_t part) {
      return part == Blend_task::no_part || is_closed(model.shape.parts()[part].mesh);
    };
    result[surface.name] = closed(source, surface.task.source) && closed(target, surface.task.target);
  }
  return result;
}

struct Options
{
  int frames = 9;
  std::string cache;
  Search_options search;
  std::vector<std::string> paths; ///< source, target, source, target, …
};

bool check(const std::string& source_path, const std::string& target_path, const Options& options)
{
  const Model source = load(source_path, options.cache), target = load(target_path, options.cache);
  const Correspondence correspondence = find_correspondence(source.graph, target.graph, options.search);
  const auto begin = std::chrono::steady_clock::now();
  const Shape_blend blend(source.graph, source.shape, target.graph, target.shape, correspondence);
  const std::map<std::string, bool> closed = must_be_closed(blend, source, target);
  const double heights[] = {structure(source.graph).frame.height, structure(target.graph).frame.height};
  int open = 0, parts = 0;
  double gap = 0, apart = 0, asymmetry = 0;
  std::vector<std::string> faults;
  for (int frame = 1; frame + 1 < options.frames; ++frame) {
    const double t = double(frame) / (options.frames - 1);
    const Segmented_shape shape = blend(t);
    const auto [quality, found] = blend.check(t);
    for (const std::string& fault : found)
      faults.push_back("  t = " + std::to_string(t).substr(0, 5) + ": " + fault);
    for (const Shape_part& part : shape.parts())
      open += closed.at(part.name) && !is_closed(part.mesh);
    parts += int(shape.parts().size());
    gap = std::max(gap, quality.gap);
    asymmetry = std::max(asymmetry, quality.asymmetry);
    apart = std::max(apart, widest_gap(shape, (1 - t) * heights[0] + t * heights[1]));
  }
  const double end_apart = std::max(widest_gap(source.shape, heights[0]), widest_gap(target.shape, heights[1]));
  constexpr double just = 1e-6;
  const double start = seen_distance(blend(just), blend(0), heights[0]);
  const double end = seen_distance(blend(1 - just), blend(1), heights[1]);
  const bool exact = is_moved(blend(0), source.shape) && is_moved(blend(1), target.shape);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const auto stem = [](const std::string& path) { return std::filesystem::path(path).filename().string(); };
  std::printf("%-30s %-30s %5d %4d %7.4f %7.4f (%6.4f) %9.4f %8.1e %8.1e %s %5.1f  %s\n", stem(source_path).c_str(),
              stem(target_path).c_str(), parts, open, gap, apart, end_apart, asymmetry, start, end,
              exact ? "exact" : "NOT EXACT", seconds, blend.schedules()[0].name.c_str());
  for (const std::string& fault : faults)
    std::puts(fault.c_str());
  std::fflush(stdout);
  return open == 0 && exact;
}

Options parsed(int argc, char** argv)
{
  const std::map<std::string, Search_method> methods = {
      {"parts", Search_method::PARTS}, {"beam", Search_method::BEAM}, {"exact", Search_method::EXACT}};
  benchmark::Command_line line(argc, argv);
  Options options;
  while (!line.is_at_end()) {
    const std::string& word = line.word();
    if (word == "--frames") {
      options.frames = int(benchmark::whole_number(line.value(), "the value of --frames"));
    } else if (word == "--cache") {
      options.cache = line.value();
    } else if (word == "--search") {
      const auto method = methods.find(line.value());
      if (method == methods.end()) throw std::invalid_argument("--search is parts, beam or exact");
      options.search.method = method->second;
    } else {
      benchmark::refuse_option(word);
      options.paths.push_back(word);
    }
  }
  if (options.paths.empty() || options.paths.size() % 2 != 0) throw std::invalid_argument("models come in pairs");
  return options;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    const Options options = parsed(argc, argv);
    std::printf("%-30s %-30s %5s %4s %7s %16s %9s %8s %8s %5s %5s\n", "source", "target", "parts", "open", "gap",
                "apart (ends)", "asymmetry", "start", "end", "ends", "s");
    bool good = true;
    for (std::size_t i = 0; i < options.paths.size(); i += 2)
      good = check(options.paths[i], options.paths[i + 1], options) && good;
    return good ? 0 : 1;
  } catch (const std::invalid_argument& error) {
    std::cerr << error.what() << "\nbenchmark_blend [--frames N] [--cache FOLDER] [--search parts|beam|exact] "
              << "SOURCE TARGET [SOURCE TARGET]...\n";
    return 2;
  } catch (const Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
