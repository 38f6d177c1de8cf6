// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings.h"
#include "handles.h"
#include "options.h"
#include "work.h"

#include "cli/run.h"
#include "io/system/atomic_file.h"
#include "io/system/colours.h"
#include "io/system/input_file.h"
#include "io/write/part_labels.h"
#include "io/write/pictures.h"
#include "viewer/pages.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/IO/read_features.h>
#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_formats.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/IO/write_html.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/estimate_up.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <ostream>
#include <tuple>

namespace shape_correspondence_python {

namespace {

using Vertices = py::array_t<double, py::array::c_style>;
using Faces = py::array_t<std::int64_t, py::array::c_style>;
using Named_mesh = std::tuple<std::string, Vertices, Faces>;
using Features = py::array_t<float, py::array::c_style>;

/// The mesh with these rows. \pre both arrays have three columns
SC::Part_mesh mesh_of(const Vertices& vertices, const Faces& faces)
{
  SC::Part_mesh mesh;
  mesh.points = Eigen::Map<const SC::Points>(vertices.data(), 3, vertices.shape(0));
  constexpr std::int64_t least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
  const Eigen::Map<const Eigen::Matrix<std::int64_t, 3, Eigen::Dynamic>> indices(faces.data(), 3, faces.shape(0));
  mesh.triangles = indices.cwiseMax(least).cwiseMin(most).cast<int>(); // indices beyond are those of no vertex, either
  return mesh;
}

py::tuple arrays_of(const SC::Shape_part& part)
{
  Vertices vertices({part.mesh.points.cols(), Eigen::Index(3)});
  Eigen::Map<SC::Points>(vertices.mutable_data(), 3, part.mesh.points.cols()) = part.mesh.points;
  py::array_t<std::int32_t> faces({part.mesh.triangles.cols(), Eigen::Index(3)});
  Eigen::Map<Eigen::Matrix3Xi>(faces.mutable_data(), 3, part.mesh.triangles.cols()) = part.mesh.triangles;
  return py::make_tuple(part.name, vertices, faces);
}

py::list parts_of(const Shape& shape)
{
  py::list result;
  for (const SC::Shape_part& part : shape.segmented().parts())
    result.append(arrays_of(part));
  return result;
}

SC::Segmented_shape shape_of(const std::vector<Named_mesh>& parts, const std::string& name)
{
  SC::Segmented_shape shape(name);
  for (const auto& [part, vertices, faces] : parts)
    shape.add_part(part, mesh_of(vertices, faces));
  return shape;
}

/// A shape of arrays. \param up empty: estimated \param whole the undivided mesh; empty if parts are separate meshes
Shape make_shape(const std::vector<Named_mesh>& parts, const std::string& name,
                 const std::optional<std::array<double, 3>>& up, const std::vector<Named_mesh>& whole)
{
  SC::Segmented_shape shape = shape_of(parts, name);
  shape.set_up(up ? SC::Point(up->data()) : SC::estimate_up(shape).up);
  Shape result;
  result.file = name;
  result.model.objects = whole.empty() ? shape : shape_of(whole, name);
  result.model.split.shape = shape;
  return result;
}

/// The parts of a mesh, as those of a file of one object.
Shape divide_mesh(const std::string& name, const Vertices& vertices, const Faces& faces)
{
  SC::IO::Model_objects objects;
  objects.shape = SC::Segmented_shape(name);
  objects.shape.add_part(name, mesh_of(vertices, faces));
  SC::cli::Common_options options = model_options({});
  options.up = "y";
  options.roles = SC::IO::shipped_role_model();
  return {name, SC::cli::model_of_objects(name, std::move(objects), options)};
}

Shape read(const std::string& path, const py::dict& options)
{
  SC::cli::Common_options common = model_options(options);
  common.roles = SC::IO::shipped_role_model();
  py::gil_scoped_release unlocked;
  return {path, SC::cli::read_model(path, common), common.reading_options()};
}

std::function<void(const std::string&, std::size_t, std::size_t)> reports_to(Work& work)
{
  return [&work](const std::string& what, std::size_t done, std::size_t total) { work.report(what, done, total); };
}

std::shared_ptr<Graph> build_graph(const Shape& shape, const py::dict& options, const py::object& progress)
{
  SC::cli::Common_options common = model_options(options);
  Work work;
  return work.run(progress, [&](Work& work) {
    common.on_progress = reports_to(work);
    const std::shared_ptr<void> limit = SC::cli::limit_threads(common.threads);
    auto result = std::make_shared<Graph>(Graph{shape.file, SC::cli::load_shape(shape.file, shape.model, common)});
    result->shape.reading = shape.reading;
    return result;
  });
}

Features read_features(const std::string& path)
{
  const Eigen::MatrixXf features = SC::IO::read_features(path);
  return Features({features.cols(), features.rows()}, features.data()); // rows become columns
}

/// Sets the features of a graph's parts. \param given the shape that it was built from; null: a file
/// \param features a row for each face or vertex of the file, or of all arrays
void add_features(Graph& graph, const Shape* given, const Features& features)
{
  SC::cli::Loaded_shape& shape = graph.shape;
  if (!shape.model)
    throw SC::Invalid_input(graph.file + ": features are of faces or vertices, which a structural graph does not have; "
                                         "give the model that it was built from");
  const Eigen::MatrixXf values =
      Eigen::Map<const Eigen::MatrixXf>(features.data(), features.shape(1), features.shape(0));
  py::gil_scoped_release unlocked;
  structure(shape.graph).features = given && shape.split.pieces.empty()
                                        ? SC::features_of_parts(values, given->model.objects, shape.split)
                                        : SC::IO::features_of_parts(values, shape.path, shape.split, shape.reading);
}

/// Graphs of files, several at once. If `is_pair`, upright axes that nothing gives are estimated together.
std::vector<std::shared_ptr<Graph>> load_graphs(const std::vector<std::string>& paths, bool is_pair,
                                                const py::dict& options, const py::object& progress)
{
  SC::cli::Common_options common = model_options(options);
  Work work;
  return work.run(progress, [&](Work& work) {
    common.on_progress = reports_to(work);
    common.roles = SC::IO::shipped_role_model();
    const std::shared_ptr<void> limit = SC::cli::limit_threads(common.threads);
    std::vector<std::string> warnings;
    std::vector<SC::cli::Loaded_shape> shapes =
        is_pair ? SC::cli::load_pair(paths, common, warnings) : SC::cli::load_shapes(paths, common);
    std::vector<std::shared_ptr<Graph>> result;
    for (SC::cli::Loaded_shape& shape : shapes)
      result.push_back(std::make_shared<Graph>(Graph{paths[result.size()], std::move(shape), warnings}));
    return result;
  });
}

std::string json_of(const Graph& graph)
{
  return text([&](std::ostream& out) { SC::IO::write_structural_graph_json(out, graph.shape.graph); });
}

void save_graph(const Graph& graph, const std::string& path)
{
  const SC::Structural_graph& g = graph.shape.graph;
  SC::cli::Loaded_shape shape;
  if (SC::IO::lower_extension(path) == ".glb") {
    shape = graph.shape;
    SC::cli::read_appearance(shape);
  }
  const std::map<std::string, std::function<void(std::ostream&)>> formats{
      {".json", [&](std::ostream& out) { SC::IO::write_structural_graph_json(out, g); }},
      {".graphml", [&](std::ostream& out) { SC::IO::write_structural_graph_graphml(out, g); }},
      {".dot", [&](std::ostream& out) { SC::IO::write_structural_graph_dot(out, g); }},
      {".glb",
       [&](std::ostream& out) {
         SC::IO::write_structural_graph_glb(out, g, graph.shape.model_pointer(), shape.appearance);
       }},
      {".html", [&](std::ostream& out) { SC::IO::write_structural_graph_html(out, g, graph.shape.model_pointer()); }}};
  const auto format = formats.find(SC::IO::lower_extension(path));
  if (format == formats.end())
    throw SC::Invalid_input(path + ": a graph is saved as .json, .graphml, .dot, .glb or .html");
  SC::IO::write_atomically(path, format->second);
}

void save_shape(const Shape& shape, const std::string& path)
{
  const std::string extension = SC::IO::lower_extension(path);
  if (extension != ".obj" && extension != ".ply") throw SC::Invalid_input(path + ": a shape is saved as .obj or .ply");
  SC::IO::write_atomically(path, [&](std::ostream& out) {
    if (extension == ".ply")
      SC::IO::write_segmented_shape_ply(out, shape.segmented());
    else
      SC::IO::write_segmented_shape_obj(out, shape.segmented());
  });
}

/// By part, the corners of the triangles of a simplified surface, or of the curve or sheet, one after the other.
py::list drawn_parts(const Graph& graph, int quarter_turns, std::size_t most_triangles)
{
  std::optional<SC::Segmented_shape> model;
  if (graph.shape.model) model = SC::IO::simplified_shape(*graph.shape.model, most_triangles);
  const SC::IO::Drawn_shape drawn(graph.shape.graph, model ? &*model : nullptr, quarter_turns);
  py::list result;
  for (std::size_t part = 0; part < drawn.number_of_parts(); ++part) {
    const SC::IO::Drawn_mesh mesh = model ? drawn.flat_surface(part) : drawn.coarse_abstraction(part);
    py::array_t<double> corners({mesh.triangles.size(), Eigen::Index(3)});
    for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i)
      for (Eigen::Index k = 0; k < 3; ++k)
        corners.mutable_at(i, k) = mesh.points(k, mesh.triangles.data()[i]);
    result.append(corners);
  }
  return result;
}

/// The label and the colour of every part, as pages show them.
py::tuple looks_of(const Graph& graph)
{
  const std::vector<std::string> names = SC::cli::part_names(graph.shape.graph);
  std::vector<std::string> roles = SC::IO::likeliest_roles(graph.shape.graph), colours;
  const std::vector<std::string> labels = SC::IO::part_labels(names, roles);
  roles.resize(names.size());
  for (const SC::IO::Colour& colour : SC::IO::colours_of_roles(roles))
    colours.push_back(SC::IO::css_colour(colour));
  return py::make_tuple(labels, colours);
}

} // namespace

void bind_shapes(py::module_& module)
{
  py::class_<Shape, std::shared_ptr<Shape>>(module, "Shape")
      .def_readonly("file", &Shape::file)
      .def_property_readonly("name", [](const Shape& shape) { return shape.segmented().name(); })
      .def_property_readonly("up",
                             [](const Shape& shape) {
                               const SC::Point& up = shape.segmented().up();
                               return std::array<double, 3>{up.x(), up.y(), up.z()};
                             })
      .def_property_readonly("warnings", [](const Shape& shape) { return shape.model.warnings; })
      .def("parts", parts_of)
      .def("save", save_shape);
  py::class_<Graph, std::shared_ptr<Graph>>(module, "Graph")
      .def_readonly("file", &Graph::file)
      .def_property_readonly("name", [](const Graph& graph) { return structure(graph.shape.graph).name; })
      .def_property_readonly("warnings", [](const Graph& graph) { return structure(graph.shape.graph).warnings; })
      .def("drawn_parts", drawn_parts)
      .def("looks", looks_of)
      .def("part_names", [](const Graph& graph) { return SC::cli::part_names(graph.shape.graph); })
      .def("shape",
           [](const Graph& graph) {
             std::optional<Shape> result;
             if (!graph.shape.model) return result;
             result.emplace();
             result->file = graph.file;
             result->reading = graph.shape.reading;
             result->model.split = graph.shape.split;
             result->model.split.shape = result->model.objects = *graph.shape.model;
             return result;
           })
      .def("json", json_of)
      .def("save", save_graph, py::call_guard<py::gil_scoped_release>());
  module.def("make_shape", make_shape);
  module.def("divide_mesh", divide_mesh);
  module.def("read", read);
  module.def("build_graph", build_graph);
  module.def("load_graphs", load_graphs);
  module.def("read_features", read_features);
  module.def("add_features", add_features);
}

} // namespace shape_correspondence_python
