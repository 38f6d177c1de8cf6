// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/report_text.h"
#include "io/system/quoting.h"
#include "io/write/Json.h"
#include "structure/align_shapes.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_formats.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/graph/graphml.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>

namespace CGAL::Shape_correspondence::IO {
namespace {

Json point(const Point& p) { return {p.x(), p.y(), p.z()}; }

Json frame(const Shape_frame& frame)
{
  return {{"origin", point(frame.origin)},     {"side", point(frame.axes.col(0))}, {"up", point(frame.axes.col(1))},
          {"front", point(frame.axes.col(2))}, {"height", frame.height},           {"mirror_side", frame.mirror_x},
          {"mirror_front", frame.mirror_z}};
}

Json points(const Points& points, Eigen::Index begin, Eigen::Index end)
{
  Json result = Json::array();
  for (Eigen::Index i = begin; i < end; ++i)
    result.push_back(point(points.col(i)));
  return result;
}

void set_geometry(Json& part, const Curve& curve)
{
  part["type"] = "curve";
  part["closed"] = curve.closed;
  part["points"] = points(curve.points, 0, curve.points.cols());
}

void set_geometry(Json& part, const Sheet& sheet)
{
  part["type"] = "sheet";
  Json rows = Json::array();
  for (int i = 0; i < sheet.rows; ++i)
    rows.push_back(points(sheet.points, Eigen::Index(i) * sheet.cols, Eigen::Index(i + 1) * sheet.cols));
  part["grid"] = rows;
}

Json part(const Part_abstraction& part)
{
  Json result;
  result["name"] = part.name;
  std::visit([&](const auto& geometry) { set_geometry(result, geometry); }, part.geometry);
  result["volume"] = part.volume;
  result["hull_volume"] = part.hull_volume;
  result["area"] = part.area;
  if (part.surface.cols() > 0)
    result["surface"] = points(part.surface, 0, std::min<Eigen::Index>(part.surface.cols(), surface_samples));
  Json& abstraction = result["abstraction"];
  abstraction["method"] = word_of(part.report.method, method_words);
  abstraction["repair"] = word_of(part.report.repair, repair_words);
  abstraction["residual"] = part.report.residual;
  abstraction["coverage"] = part.report.coverage;
  abstraction["iterations"] = part.report.iterations;
  Json& flags = abstraction["flags"] = Json::array();
  for (const auto& [word, flag] : flag_words)
    if (part.report.*flag) flags.push_back(word);
  if (part.report.is_fallback()) flags.push_back("bounding_box");
  if (part.report.is_fallback()) abstraction["fallback"] = part.report.fallback;
  if (!part.report.copy_of.empty()) abstraction["copy_of"] = part.report.copy_of;
  return result;
}

void set_symmetry(Json& group, const Symmetry& symmetry)
{
  // Files say "self", without a plane, for no symmetry
  group["symmetry"] = name_of(symmetry.type == Symmetry_type::NONE ? Symmetry_type::SELF : symmetry.type);
  switch (symmetry.type) {
  case Symmetry_type::NONE:
    return;
  case Symmetry_type::SELF:
  case Symmetry_type::REFLECTION:
    group["plane"] = {{"point", point(symmetry.point)}, {"normal", point(symmetry.direction)}};
    break;
  case Symmetry_type::ROTATION:
    group["axis"] = point(symmetry.direction);
    group["point"] = point(symmetry.point);
    group["order"] = symmetry.order;
    break;
  case Symmetry_type::TRANSLATION:
    group["vector"] = point(symmetry.direction);
    group["point"] = point(symmetry.point);
    break;
  }
  group["residual"] = symmetry.residual;
}

Json group(const Part_group& group, const Shape_structure& shape)
{
  Json result;
  result["parts"] = Json::array();
  for (std::size_t i : group.parts)
    result["parts"].push_back(shape.parts[i].name);
  set_symmetry(result, group.symmetry);
  result["volume"] = group.volume;
  result["hull_volume"] = group.hull_volume;
  return result;
}

Json parameter(const Part_abstraction& part, const Eigen::Vector2d& parameter)
{
  if (part.is_sheet()) return {parameter.x(), parameter.y()};
  return Json::array({parameter.x()});
}

/// A contact of several regions is written as several contacts of the same parts.
void add_contact(Json& list, const Contact& contact, const Shape_structure& shape)
{
  const Part_abstraction &first = shape.parts[contact.parts[0]], &second = shape.parts[contact.parts[1]];
  const auto add = [&](const Contact::Parameters& p) {
    list.push_back(
        {{"parts", {first.name, second.name}}, {"parameters", {parameter(first, p[0]), parameter(second, p[1])}}});
  };
  add(contact.parameters);
  for (const Contact::Parameters& parameters : contact.further)
    add(parameters);
}

using Vertex = boost::graph_traits<Structural_graph>::vertex_descriptor;
using Edge = boost::graph_traits<Structural_graph>::edge_descriptor;

std::string names(const Structural_graph& graph, Vertex v)
{
  std::vector<std::string> result;
  for (std::size_t part : graph[v].parts)
    result.push_back(structure(graph).parts[part].name);
  return boost::algorithm::join(result, ", ");
}

boost::dynamic_properties graphml_columns(const Structural_graph& graph)
{
  const auto parts = [&graph](Vertex v) { return quote_graphml(names(graph, v)); };
  const auto symmetry = [&graph](Vertex v) -> std::string { return name_of(graph[v].symmetry.type); };
  const auto solid = [&graph](Vertex v) { return solidity(graph[v].volume, graph[v].hull_volume); };
  const auto contacts = [&graph](const Edge& e) { return static_cast<int>(graph[e].contacts.size()); };
  boost::dynamic_properties result;
  result.property("parts", boost::make_function_property_map<Vertex, std::string>(parts));
  result.property("symmetry", boost::make_function_property_map<Vertex, std::string>(symmetry));
  result.property("solidity", boost::make_function_property_map<Vertex, double>(solid));
  result.property("contacts", boost::make_function_property_map<Edge, int>(contacts));
  return result;
}

} // namespace

void write_structural_graph_json(std::ostream& out, const Structural_graph& graph)
{
  const Shape_structure& shape = structure(graph);
  Json result;
  result["format"] = "shape_correspondence/graph";
  result["version"] = 1;
  result["name"] = shape.name;
  if (!shape.content.empty()) result["content"] = shape.content;
  if (shape.automatic_parts) result["segmentation"] = "automatic";
  result["up"] = point(shape.frame.axes.col(1));
  result["frame"] = frame(shape.frame);
  result["parts"] = Json::array();
  for (const Part_abstraction& p : shape.parts)
    result["parts"].push_back(part(p));
  result["groups"] = Json::array();
  for (std::size_t v = 0; v < num_vertices(graph); ++v)
    result["groups"].push_back(group(graph[v], shape));
  result["contacts"] = Json::array();
  for (const Contact& c : shape.contacts)
    add_contact(result["contacts"], c, shape);
  result["warnings"] = shape.warnings;
  result.write(out);
}

void write_structural_graph_graphml(std::ostream& out, const Structural_graph& graph)
{
  boost::write_graphml(out, graph, graphml_columns(graph), true);
}

void write_structural_graph_dot(std::ostream& out, const Structural_graph& graph)
{
  out << "graph G {\n";
  for (std::size_t v = 0; v < num_vertices(graph); ++v)
    out << v << " [label=" << quote_dot(names(graph, v))
        << ", solidity=" << solidity(graph[v].volume, graph[v].hull_volume)
        << ", symmetry=" << name_of(graph[v].symmetry.type) << "];\n";
  for (auto [edge, last] = edges(graph); edge != last; ++edge)
    out << source(*edge, graph) << "--" << target(*edge, graph) << " [contacts=" << graph[*edge].contacts.size()
        << "];\n";
  out << "}\n";
}

} // namespace CGAL::Shape_correspondence::IO
