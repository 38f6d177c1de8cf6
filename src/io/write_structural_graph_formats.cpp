// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/report_text.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_formats.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/graph/graphml.hpp>
#include <boost/graph/graphviz.hpp>
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

/// The columns of both formats. \param label what the parts' names are called
boost::dynamic_properties properties(const Structural_graph& graph, const std::string& label)
{
  const auto parts = [&graph](Vertex v) { return names(graph, v); };
  const auto symmetry = [&graph](Vertex v) -> std::string { return name_of(graph[v].symmetry.type); };
  const auto solid = [&graph](Vertex v) { return solidity(graph[v].volume, graph[v].hull_volume); };
  const auto contacts = [&graph](const Edge& e) { return static_cast<int>(graph[e].contacts.size()); };
  boost::dynamic_properties result;
  result.property(label, boost::make_function_property_map<Vertex, std::string>(parts));
  result.property("symmetry", boost::make_function_property_map<Vertex, std::string>(symmetry));
  result.property("solidity", boost::make_function_property_map<Vertex, double>(solid));
  result.property("contacts", boost::make_function_property_map<Edge, int>(contacts));
  return result;
}

} // namespace

void write_structural_graph_graphml(std::ostream& out, const Structural_graph& graph)
{
  boost::write_graphml(out, graph, properties(graph, "parts"), true);
}

void write_structural_graph_dot(std::ostream& out, const Structural_graph& graph)
{
  boost::dynamic_properties columns = properties(graph, "label");
  columns.property("node_id", get(boost::vertex_index, graph));
  boost::write_graphviz_dp(out, graph, columns);
}

} // namespace CGAL::Shape_correspondence::IO
