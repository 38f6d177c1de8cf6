// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_formats.h>

#include <boost/property_tree/xml_parser.hpp>

#include <catch2/catch.hpp>

#include <map>
#include <sstream>

using namespace CGAL::Shape_correspondence;
using Catch::Matchers::Contains;

TEST_CASE("GraphML and DOT name the groups and count the contacts")
{
  const Structural_graph graph = hand_made::chair();
  std::ostringstream graphml, dot;
  IO::write_structural_graph_graphml(graphml, graph);
  IO::write_structural_graph_dot(dot, graph);
  CHECK_THAT(dot.str(), Contains("graph G {") && Contains("seat") && Contains("contacts=") && Contains("--"));

  std::istringstream in(graphml.str());
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(in, tree);
  std::map<std::string, std::size_t> count;
  for (const auto& child : tree.get_child("graphml.graph"))
    ++count[child.first];
  CHECK(count["node"] == num_vertices(graph));
  CHECK(count["edge"] == num_edges(graph));
  CHECK_THAT(graphml.str(), Contains("seat"));
}
