// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings.h"
#include "handles.h"
#include "options.h"
#include "work.h"

#include "cli/jobs.h"
#include "cli/run.h"
#include "io/system/atomic_file.h"
#include "io/system/colours.h"
#include "io/system/input_file.h"
#include "io/write/part_labels.h"
#include "viewer/pages.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/Surface_map.h>
#include <CGAL/Shape_correspondence/correspondence_blocks.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstdint>
#include <ostream>

namespace shape_correspondence_python {

namespace {

/// The warnings about the shapes of a match, in the order in which the program prints them.
std::vector<std::string> warnings_of(const Graph& source, const Graph& target, bool is_flow_wanted)
{
  std::vector<std::string> result = source.warnings_of_up;
  for (const Graph* graph : {&source, &target}) {
    std::vector<std::string> warnings = structure(graph->shape.graph).warnings;
    const std::string note = SC::cli::note_on_abstraction(graph->shape.graph, is_flow_wanted);
    if (!note.empty() && std::find(warnings.begin(), warnings.end(), note) == warnings.end()) warnings.push_back(note);
    for (const std::string& warning : warnings)
      result.push_back(graph->file + ": " + warning);
  }
  return result;
}

std::shared_ptr<Match> match(const std::shared_ptr<Graph>& source, const std::shared_ptr<Graph>& target,
                             const std::string& abstraction, const std::optional<Role_model>& roles, int threads,
                             const py::dict& options, const py::object& progress)
{
  SC::Search_options search = search_options(options);
  if (roles) search.roles = roles->model;
  Work work;
  return work.run(progress, [&](Work& work) {
    search.progress = [&](double share) { return work.report_share("matching", share); };
    const std::shared_ptr<void> limit = SC::cli::limit_threads(threads);
    auto result =
        std::make_shared<Match>(Match{source, target, SC::cli::match_shapes(source->shape, target->shape, search)});
    std::vector<std::string>& warnings = result->matched.ranked[0].warnings;
    const std::vector<std::string> of_shapes = warnings_of(*source, *target, abstraction == "flow");
    warnings.insert(warnings.begin(), of_shapes.begin(), of_shapes.end());
    return result;
  });
}

/// The match in a file of `match --json`.
std::shared_ptr<Match> read_match(const std::string& path, const std::shared_ptr<Graph>& source,
                                  const std::shared_ptr<Graph>& target)
{
  auto result = std::make_shared<Match>(Match{source, target, {}});
  result->matched.ranked.push_back(SC::IO::correspondence_of(SC::IO::read_correspondence_json(path),
                                                             source->shape.graph, target->shape.graph, path));
  return result;
}

std::string json_of(const Match& match)
{
  return text([&](std::ostream& out) {
    SC::IO::write_correspondences_json(out, match.matched.ranked, match.source->shape.graph, match.target->shape.graph,
                                       match.source->file, match.target->file, match.matched.seconds);
  });
}

void save(const Match& match, const std::string& path)
{
  const std::string extension = SC::IO::lower_extension(path);
  SC::cli::Loaded_shape source = match.source->shape, target = match.target->shape;
  if (extension == ".glb") {
    SC::cli::read_appearance(source);
    SC::cli::read_appearance(target);
  }
  if (extension != ".json" && extension != ".glb" && extension != ".html")
    throw SC::Invalid_input(path + ": a match is saved as .json, .glb or .html");
  SC::IO::write_atomically(path, [&](std::ostream& out) {
    if (extension == ".json")
      out << json_of(match);
    else if (extension == ".glb")
      SC::IO::write_correspondence_glb(out, match.best(), source.graph, target.graph, source.model_pointer(),
                                       target.model_pointer(), source.appearance, target.appearance);
    else
      SC::IO::write_page(out, SC::IO::match_page(match.matched.ranked, source.graph, target.graph,
                                                 source.model_pointer(), target.model_pointer(), match.source->file,
                                                 match.target->file, match.matched.seconds));
  });
}

/// Where the vertices of a target part are on the source: by vertex the source part (-1: nowhere), the three vertices
/// of the triangle, and their weights.
py::tuple places_of(const SC::Surface_map& map, const SC::Segmented_shape& source, const SC::Shape_part& part,
                    std::size_t index)
{
  const Eigen::Index n = part.mesh.points.cols();
  py::array_t<std::int64_t> parts(n), corners({n, Eigen::Index(3)});
  py::array_t<double> weights({n, Eigen::Index(3)});
  for (Eigen::Index v = 0; v < n; ++v) {
    const std::optional<SC::Surface_place> place = map.source_of(index, v);
    parts.mutable_at(v) = place ? std::int64_t(place->part) : -1;
    for (Eigen::Index k = 0; k < 3; ++k) {
      corners.mutable_at(v, k) = place ? source.parts()[place->part].mesh.triangles(k, place->triangle) : 0;
      weights.mutable_at(v, k) = place ? place->weights[k] : 0;
    }
  }
  return py::make_tuple(parts, corners, weights);
}

py::list surface_places(const Match& match, const py::object& progress)
{
  for (const auto& graph : {match.source, match.target})
    if (!graph->shape.model)
      throw SC::Invalid_input(graph->file + ": it is a structural graph without surfaces, which values are transferred "
                                            "between; give the model that it was built from");
  const SC::Segmented_shape &source = *match.source->shape.model, &target = *match.target->shape.model;
  Work work;
  const SC::Surface_map map = work.run(progress, [&](Work&) {
    return SC::Surface_map(match.source->shape.graph, source, match.target->shape.graph, target, match.best());
  });
  py::list result;
  for (std::size_t i = 0; i < target.parts().size(); ++i)
    result.append(places_of(map, source, target.parts()[i], i));
  return result;
}

/// Transfers looks or labels, and writes the target with them. \return what the program writes as JSON
std::string transfer_looks(const Match& match, const std::string& output, int size, const std::string& labels,
                           bool new_coordinates)
{
  SC::cli::Transfer_request request;
  request.output = output;
  request.labels = labels;
  request.options.size = size;
  request.options.new_coordinates = new_coordinates;
  SC::cli::Loaded_shape source = match.source->shape, target = match.target->shape;
  SC::cli::Transferred_looks transferred = SC::cli::transfer_looks(source, target, match.best(), request);
  transferred.warnings.insert(transferred.warnings.begin(), match.best().warnings.begin(), match.best().warnings.end());
  return text([&](std::ostream& out) { SC::cli::write_transfer_json(out, source, target, request, transferred); });
}

/// By side, the label and the colour of every part, as pages show them.
py::dict looks_of(const Match& match)
{
  const SC::Correspondence& c = match.best();
  std::vector<std::string> roles_of_blocks;
  const std::vector<SC::Correspondence_block> blocks = SC::correspondence_blocks(c);
  for (const SC::Correspondence_block& block : blocks)
    roles_of_blocks.push_back(block.role);
  const std::vector<SC::IO::Colour> colours = SC::IO::colours_of_roles(roles_of_blocks);
  py::dict result;
  for (const char* side : {"source", "target"}) {
    const bool is_source = side == std::string("source");
    const std::vector<std::string> names = SC::cli::part_names((is_source ? match.source : match.target)->shape.graph);
    std::vector<std::string> of_parts(names.size(), SC::IO::css_colour(SC::IO::grey()));
    for (std::size_t block = 0; block < blocks.size(); ++block)
      for (std::size_t part : is_source ? blocks[block].source : blocks[block].target)
        of_parts[part] = SC::IO::css_colour(colours[block]);
    result[side] = py::make_tuple(SC::IO::part_labels(names, is_source ? c.source_roles : c.target_roles), of_parts);
  }
  return result;
}

} // namespace

void bind_matches(py::module_& module)
{
  py::class_<Match, std::shared_ptr<Match>>(module, "Match")
      .def_property_readonly("source", [](const Match& match) { return std::const_pointer_cast<Graph>(match.source); })
      .def_property_readonly("target", [](const Match& match) { return std::const_pointer_cast<Graph>(match.target); })
      .def("json", json_of)
      .def("save", save, py::call_guard<py::gil_scoped_release>())
      .def("looks", looks_of)
      .def("surface_places", surface_places)
      .def("transfer_looks", transfer_looks, py::call_guard<py::gil_scoped_release>());
  module.def("match", match);
  module.def("read_match", read_match);
}

} // namespace shape_correspondence_python
