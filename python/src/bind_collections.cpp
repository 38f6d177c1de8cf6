// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings.h"
#include "handles.h"
#include "options.h"
#include "work.h"

#include "cli/collection.h"
#include "cli/jobs.h"
#include "cli/run.h"

#include <CGAL/Shape_correspondence/IO/collection_json.h>
#include <CGAL/Shape_correspondence/IO/write_collection_html.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include "io/system/atomic_file.h"

#include <pybind11/stl.h>

#include <map>
#include <ostream>
#include <tuple>
#include <utility>

namespace shape_correspondence_python {

namespace {

using Graphs = std::vector<std::shared_ptr<Graph>>;

SC::cli::Collection_shapes shapes_of(const Graphs& graphs)
{
  std::vector<std::pair<std::string, SC::Structural_graph>> by_path;
  for (const auto& graph : graphs)
    by_path.emplace_back(graph->file, graph->shape.graph);
  return SC::cli::Collection_shapes(by_path);
}

SC::Energy_matrix_options matching_options(const std::optional<Role_model>& roles, const py::dict& search,
                                           double unmatched_energy = SC::Energy_matrix_options().unmatched_energy)
{
  SC::Energy_matrix_options options;
  options.unmatched_energy = unmatched_energy;
  options.search = search_options(search, /* is_for_pair = */ false);
  if (roles) options.search.roles = roles->model;
  return options;
}

/// The key of finished work in a store: the options that it depends on.
std::string key_of(const py::dict& search, const SC::Energy_matrix_options& matching)
{
  std::map<std::string, std::string> values;
  for (const auto& [name, value] : search)
    values[name.cast<std::string>()] = py::repr(value).cast<std::string>();
  std::string text = "python\n";
  for (const auto& [name, value] : values)
    text += name + '=' + value + '\n';
  return SC::cli::key_of(text, matching.search, matching.unmatched_energy);
}

/// The JSON of a collection. \param page file for its web page; empty: none
std::string collection(const Graphs& graphs, const std::optional<Role_model>& roles, int threads,
                       const py::dict& search, const py::dict& values, const std::string& page,
                       const py::object& progress)
{
  const SC::cli::Collection_options options = collection_options(values);
  const SC::Energy_matrix_options matching = matching_options(roles, search, options.unmatched_energy);
  const std::string key = options.store.empty() ? "" : key_of(search, matching);
  Work work;
  return work.run(progress, [&](Work& work) {
    const std::shared_ptr<void> limit = SC::cli::limit_threads(threads);
    SC::cli::Common_options common;
    common.quiet = true;
    common.on_progress = [&](const std::string& what, std::size_t done, std::size_t total) {
      work.report(what, done, total);
    };
    SC::cli::Team team;
    const SC::cli::Collection_shapes shapes = shapes_of(graphs);
    SC::cli::Collection_work pairs(shapes, options.store.empty() ? "" : options.store + "/pairs", key, matching,
                                   common);
    pairs.run(team);
    const SC::cli::Analysis analysis = SC::cli::analysed(shapes, options, pairs);
    if (!page.empty())
      SC::IO::write_atomically(page, [&](std::ostream& out) {
        SC::IO::write_collection_html(
            out, analysis.collection, [&](std::size_t i) { return shapes.graph(i); }, analysis.maps,
            [&](std::size_t i) { return graphs[i]->shape.model; });
      });
    return text([&](std::ostream& out) { SC::IO::write_collection_json(out, analysis.collection); });
  });
}

std::string nearest(const std::shared_ptr<Graph>& query, const Graphs& graphs, std::size_t count,
                    const std::optional<Role_model>& roles, int threads, const py::dict& search, const py::dict& values,
                    const py::object& progress)
{
  SC::Energy_matrix_options matching = matching_options(roles, search, collection_options(values).unmatched_energy);
  Work work;
  return work.run(progress, [&](Work& work) {
    const std::shared_ptr<void> limit = SC::cli::limit_threads(threads);
    matching.progress = [&](std::size_t done, std::size_t total) {
      work.report("matching", done, total);
      return true;
    };
    const SC::IO::Nearest_in_collection found =
        SC::cli::nearest_in_collection(query->shape.graph, query->file, shapes_of(graphs), count, matching);
    return text([&](std::ostream& out) { SC::IO::write_nearest_json(out, found); });
  });
}

using Label = std::tuple<std::string, std::string, double>; ///< coarse, fine, confidence

/// The labels that the parts of every target have from the source. \param labels coarse and fine, by part of the source
std::vector<std::vector<Label>> transfer_labels(const std::shared_ptr<Graph>& source,
                                                const std::vector<std::pair<std::string, std::string>>& labels,
                                                const Graphs& targets, const std::optional<Role_model>& roles,
                                                int threads, const py::dict& search, const py::object& progress)
{
  const SC::Energy_matrix_options matching = matching_options(roles, search);
  std::vector<SC::Part_label> part_labels;
  for (const auto& [coarse, fine] : labels)
    part_labels.push_back({coarse, fine});
  Work work;
  return work.run(progress, [&](Work& work) {
    const std::shared_ptr<void> limit = SC::cli::limit_threads(threads);
    const SC::Correspondence_finder finder(source->shape.graph, matching.search);
    std::vector<std::vector<Label>> result;
    for (const auto& target : targets) {
      result.emplace_back();
      for (const SC::Transferred_label& label :
           finder.transfer_labels(part_labels, SC::Prepared_shape(target->shape.graph)))
        result.back().emplace_back(label.label.coarse, label.label.fine, label.confidence);
      work.report("matching", result.size(), targets.size());
    }
    return result;
  });
}

SC::cli::Named_result named(const Match& match)
{
  SC::cli::Named_result result{match.source->file + " -> " + match.target->file, {}};
  const SC::Correspondence& best = match.best();
  SC::IO::Named_correspondence& named = result.correspondence;
  named = {match.source->file, match.target->file, {}, best.complete, best.target_quarter_turns, {}, {}, {}};
  for (const SC::Part_correspondence& pair : best.pairs)
    named.pairs.push_back({structure(match.source->shape.graph).parts[pair.source].name,
                           structure(match.target->shape.graph).parts[pair.target].name, pair.confidence});
  return result;
}

/// The JSON of the scores of results in files and of matches.
std::string evaluate(const std::vector<std::string>& files, const std::vector<std::shared_ptr<Match>>& matches,
                     const std::vector<std::string>& labels)
{
  py::gil_scoped_release unlocked;
  const std::vector<SC::IO::Labelled_shape> shapes = SC::cli::read_labels(labels);
  std::vector<SC::cli::Named_result> results = SC::cli::read_results(files);
  for (const auto& match : matches)
    results.push_back(named(*match));
  return text([&](std::ostream& out) { SC::cli::write_evaluation_json(out, results, shapes); });
}

} // namespace

void bind_collections(py::module_& module)
{
  module.def("collection_paths",
             [](const std::vector<std::string>& inputs) { return SC::cli::collection_paths(inputs); });
  module.def("collection", collection);
  module.def("nearest", nearest);
  module.def("transfer_labels", transfer_labels);
  module.def("evaluate", evaluate);
}

} // namespace shape_correspondence_python
