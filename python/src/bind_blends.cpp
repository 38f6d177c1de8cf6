// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings.h"
#include "handles.h"
#include "options.h"
#include "work.h"

#include "cli/jobs.h"
#include "cli/run.h"
#include "io/system/atomic_file.h"
#include "viewer/pages.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <pybind11/stl.h>

#include <ostream>

namespace shape_correspondence_python {

namespace {

/// The graph; if it has no surfaces, with those of the meshes that its file names. \throw Invalid_input
Graph with_surfaces(Graph graph)
{
  SC::cli::complete_surfaces(graph.shape);
  return graph;
}

std::shared_ptr<Blend> blend(const std::shared_ptr<Match>& match, int threads, const py::dict& values,
                             const py::object& progress)
{
  bool has_size = false;
  SC::Blend_options options = blend_options(values, has_size);
  Work work;
  return work.run(progress, [&](Work& work) {
    options.progress = [&](double share) {
      work.report("blend", std::size_t(share * 100), 100);
      return true;
    };
    const std::shared_ptr<void> limit = SC::cli::limit_threads(threads);
    const Graph source = with_surfaces(*match->source), target = with_surfaces(*match->target);
    std::vector<std::string> warnings = match->best().warnings;
    SC::Correspondence pairs = match->best();
    for (const std::string& unlikely :
         SC::cli::remove_unlikely(pairs, options.min_confidence, source.shape, target.shape))
      warnings.push_back(unlikely);
    options.min_confidence = 0; // unlikely pairs were removed above
    if (!has_size) options.size = SC::cli::likely_size(source.shape, target.shape, warnings);
    const SC::Shape_blend blend(source.shape.graph, *source.shape.model, target.shape.graph, *target.shape.model, pairs,
                                options);
    SC::cli::warn_of_obstacles(blend, source.shape, target.shape, warnings);
    return std::make_shared<Blend>(Blend{match, pairs, blend, warnings});
  });
}

Shape shape_at(const Blend& blend, double t, bool solid)
{
  if (!(t >= 0 && t <= 1)) throw SC::Invalid_input("t is between 0 and 1");
  Shape result;
  result.model.split.shape = blend.blend(t);
  if (solid) {
    SC::Segmented_shape wrapped(result.segmented().name(), result.segmented().up());
    wrapped.add_part("solid", blend.blend.solid(t));
    result.model.split.shape = wrapped;
  }
  result.model.objects = result.segmented();
  result.file = result.segmented().name();
  return result;
}

/// The same blend by every schedule that makes other shapes, the best first.
std::vector<std::shared_ptr<Blend>> different_blends(const Blend& blend)
{
  std::vector<std::shared_ptr<Blend>> result;
  for (const SC::Shape_blend& other : blend.blend.different_blends())
    result.push_back(std::make_shared<Blend>(Blend{blend.match, blend.pairs, other, blend.warnings}));
  return result;
}

void check_frames(int frames)
{
  if (frames < 2) throw SC::Invalid_input("frames must be at least 2, not " + std::to_string(frames));
}

std::string json_of(const Blend& blend, const std::string& output, int frames)
{
  check_frames(frames);
  const Graph &source = *blend.match->source, &target = *blend.match->target;
  return text([&](std::ostream& out) {
    SC::IO::write_blend_json(out, blend.blend, source.shape.graph, target.shape.graph, source.file, target.file, output,
                             frames, blend.warnings);
  });
}

void save_glb(const Blend& blend, const std::string& path, int frames)
{
  check_frames(frames);
  SC::cli::Loaded_shape source = blend.match->source->shape, target = blend.match->target->shape;
  SC::cli::read_appearance(source);
  SC::cli::read_appearance(target);
  SC::IO::write_atomically(path, [&](std::ostream& out) {
    if (source.appearance.empty() && target.appearance.empty())
      SC::IO::write_blend_glb(out, blend.blend, blend.pairs, frames);
    else
      SC::IO::write_blend_glb(out, blend.blend, {source.appearance, target.appearance}, frames);
  });
}

void save_page(const Blend& blend, const std::string& path, int frames)
{
  const std::string json = json_of(blend, path, frames);
  const Graph &source = *blend.match->source, &target = *blend.match->target;
  SC::IO::Page page =
      SC::IO::match_page({blend.pairs}, source.shape.graph, target.shape.graph, source.shape.model_pointer(),
                         target.shape.model_pointer(), source.file, target.file, {});
  SC::IO::add_blend(page, json, blend.blend, blend.pairs, frames);
  SC::IO::write_atomically(path, [&](std::ostream& out) { SC::IO::write_page(out, page); });
}

} // namespace

void bind_blends(py::module_& module)
{
  py::class_<Blend, std::shared_ptr<Blend>>(module, "Blend")
      .def("shape", shape_at, py::call_guard<py::gil_scoped_release>())
      .def("different", different_blends, py::call_guard<py::gil_scoped_release>())
      .def("json", json_of, py::call_guard<py::gil_scoped_release>())
      .def("save_page", save_page, py::call_guard<py::gil_scoped_release>())
      .def("save_glb", save_glb, py::call_guard<py::gil_scoped_release>());
  module.def("blend", blend);
  module.def("schedule_names", SC::Shape_blend::schedule_names);
}

} // namespace shape_correspondence_python
