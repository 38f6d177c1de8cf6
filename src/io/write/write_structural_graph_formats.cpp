// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/report_text.h"
#include "io/system/quoting.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_formats.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/graph/graphml.hpp>
#include <boost/property_map/function_property_map.hpp>

namespace CGAL::Shape_correspondence::IO {
namespace {

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
