// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/load_shape.h"
#include "cli/outputs.h"
#include "cli/text_table.h"
#include "cli/thread_limit.h"
#include "io/quoting.h"
#include "io/report_text.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_formats.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/IO/write_glb.h>
#include <CGAL/Shape_correspondence/IO/write_html.h>

#include <iostream>

namespace CGAL::Shape_correspondence::cli {

namespace po = boost::program_options;

namespace {

const char* const help_text =
    R"(Usage: shape_correspondence graph MODEL [options]

Builds the structural graph of a segmented shape: a curve or a sheet for every part, groups of parts that
are symmetric, and contacts between parts.

MODEL is a file (OBJ with o/g, PLY, STL, OFF, glTF/GLB, COLLADA, FBX, 3DS, DXF, AC3D: a node is a part), a folder of part
meshes (one file is one part, its stem the part's name), or a structural graph (.json, .xml).

Example: shape_correspondence graph chair.obj -o chair.json --glb chair.glb

)";

/// Files for graph tools; empty: none.
struct Graph_files
{
  std::string graphml, dot;
};

po::options_description graph_options(Common_options& common, Graph_files& files)
{
  po::options_description result = option_group("Options of graph");
  auto add = result.add_options();
  add("json,o", po::value(&common.json)->value_name("FILE"),
      "write the graph as JSON, which match reads in place of the model; - is standard output");
  add("glb", po::value(&common.glb)->value_name("FILE"),
      "write a picture as binary glTF: surfaces faint, curves as tubes, sheets as patches, a colour a group, a dot a "
      "contact");
  add("html", po::value(&common.html)->value_name("FILE"),
      "write the same picture as a web page that needs no network, with a table of the parts");
  add("graphml", po::value(&files.graphml)->value_name("FILE"),
      "write groups and contacts as GraphML, for graph tools: names, symmetries and solidities, no geometry");
  add("dot", po::value(&files.dot)->value_name("FILE"), "the same for Graphviz");
  return result;
}

std::string touched_parts(const Shape_structure& shape, std::size_t part)
{
  std::vector<std::string> names;
  for (const Contact& contact : shape.contacts) {
    for (int side = 0; side < 2; ++side) {
      if (contact.parts[side] == part) names.push_back(shape.parts[contact.parts[1 - side]].name);
    }
  }
  return listed(names);
}

void print_graph(const std::string& path, const Structural_graph& graph)
{
  const Shape_structure& shape = structure(graph);
  std::vector<std::vector<std::string>> rows{{"group", "symmetry", "part", "type", "solidity", "touches"}};
  for (std::size_t v = 0; v < num_vertices(graph); ++v) {
    for (std::size_t part : graph[v].parts) {
      const Part_abstraction& p = shape.parts[part];
      const bool first = part == graph[v].parts[0];
      rows.push_back({first ? std::to_string(v + 1) : "", first ? IO::name_of(graph[v].symmetry) : "", p.name,
                      IO::kind_of(p), short_number(solidity(p.volume, p.hull_volume)), touched_parts(shape, part)});
    }
  }
  std::cout << IO::quote_terminal(path) << ": " << shape.parts.size() << " parts, " << num_vertices(graph)
            << " groups, " << shape.contacts.size() << " contacts\n\n";
  write_table(std::cout, rows);
  for (const std::string& warning : shape.warnings)
    std::cout << "\nwarning: " << IO::quote_terminal(warning) << '\n';
}

} // namespace

void run_graph(const std::vector<std::string>& arguments)
{
  Common_options common;
  Graph_files files;
  po::options_description options;
  options.add(graph_options(common, files)).add(model_options(common)).add(common_options(common));
  const Arguments parsed = parse(arguments, options, 1, 1);
  if (parsed.help) {
    std::cout << help_text << options;
    return;
  }
  check(common);
  check_outputs({common.json, common.glb, common.html, files.graphml, files.dot}, parsed.inputs);
  const Thread_limit limit(common.threads);
  const Loaded_shape shape = load_shape(parsed.inputs[0], common);
  write_output(common.json, [&](std::ostream& out) { IO::write_structural_graph_json(out, shape.graph); });
  write_output(common.glb,
               [&](std::ostream& out) { IO::write_structural_graph_glb(out, shape.graph, shape.model_pointer()); });
  write_output(common.html,
               [&](std::ostream& out) { IO::write_structural_graph_html(out, shape.graph, shape.model_pointer()); });
  write_output(files.graphml, [&](std::ostream& out) { IO::write_structural_graph_graphml(out, shape.graph); });
  write_output(files.dot, [&](std::ostream& out) { IO::write_structural_graph_dot(out, shape.graph); });
  if (common.prints_table()) print_graph(parsed.inputs[0], shape.graph);
}

} // namespace CGAL::Shape_correspondence::cli
