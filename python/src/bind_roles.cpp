// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings.h"
#include "handles.h"
#include "options.h"
#include "work.h"

#include "cli/jobs.h"
#include "cli/run.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/train_role_model.h>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <ostream>
#include <tuple>

namespace shape_correspondence_python {

namespace {

std::string predict(const Graph& graph, const Role_model& model, const std::string& category)
{
  const SC::Part_roles found = SC::cli::predicted_roles(graph.file, graph.shape.graph, *model.model, category);
  return text([&](std::ostream& out) { SC::cli::write_labels_json(out, graph.shape.graph, found); });
}

/// A shape that roles are learned from: graph, category, labels (coarse, fine) by part, weight.
using Example =
    std::tuple<std::shared_ptr<Graph>, std::string, std::vector<std::pair<std::string, std::string>>, double>;

std::vector<SC::Labelled_graph> labelled_graphs(const std::vector<Example>& examples)
{
  std::vector<SC::Labelled_graph> shapes;
  for (const auto& [graph, category, labels, weight] : examples) {
    shapes.push_back({&graph->shape.graph, category, {}, weight});
    for (const auto& [coarse, fine] : labels)
      shapes.back().labels.push_back({coarse, fine});
  }
  return shapes;
}

SC::Role_training_options training_options(int trees, std::uint64_t seed)
{
  if (trees < 1) throw SC::Invalid_input("trees must be at least 1, not " + std::to_string(trees));
  SC::Role_training_options options;
  options.trees = trees;
  options.seed = seed;
  return options;
}

Role_model train(const std::vector<Example>& examples, int trees, std::uint64_t seed, const py::object& progress)
{
  const std::vector<SC::Labelled_graph> shapes = labelled_graphs(examples);
  const SC::Role_training_options options = training_options(trees, seed);
  Work work;
  return work.run(progress, [&](Work&) {
    return Role_model{std::make_shared<const SC::Role_model>(SC::train_role_model(shapes, options))};
  });
}

Role_model train_of_folders(const std::vector<std::string>& folders, int trees, std::uint64_t seed,
                            const py::dict& options, const py::object& progress)
{
  SC::cli::Role_training training;
  training.folders = folders;
  training.options = training_options(trees, seed);
  const SC::cli::Common_options common = model_options(options);
  Work work;
  return work.run(progress, [&](Work&) {
    const std::shared_ptr<void> limit = SC::cli::limit_threads(common.threads);
    return Role_model{std::make_shared<const SC::Role_model>(SC::cli::train_roles(training, common).model)};
  });
}

Role_model extend(const Role_model& model, const std::vector<Example>& examples, std::uint64_t seed,
                  const py::object& progress)
{
  const std::vector<SC::Labelled_graph> shapes = labelled_graphs(examples);
  SC::Role_training_options options;
  options.seed = seed;
  Work work;
  return work.run(progress, [&](Work&) {
    return Role_model{std::make_shared<const SC::Role_model>(SC::extend_role_model(*model.model, shapes, options))};
  });
}

} // namespace

void bind_roles(py::module_& module)
{
  py::class_<Role_model>(module, "RoleModel")
      .def_property_readonly("categories", [](const Role_model& model) { return model.model->categories(); })
      .def("roles", [](const Role_model& model, const std::string& category) { return model.model->roles(category); })
      .def("save", [](const Role_model& model, const std::filesystem::path& path) {
        SC::IO::write_role_model(path.string(), *model.model);
      });
  module.def("shipped_roles", [] { return Role_model{SC::IO::shipped_role_model()}; });
  module.def("load_roles", [](const std::string& path) {
    return Role_model{std::make_shared<const SC::Role_model>(SC::IO::read_role_model(path))};
  });
  module.def("predict_roles", predict, py::call_guard<py::gil_scoped_release>());
  module.def("train_roles", train);
  module.def("extend_roles", extend);
  module.def("train_roles_of_folders", train_of_folders);
}

} // namespace shape_correspondence_python
