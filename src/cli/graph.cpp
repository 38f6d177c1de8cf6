// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/collection_shapes.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/load_shape.h"
#include "cli/outputs.h"
#include "cli/run_report.h"
#include "cli/text_table.h"
#include "cli/thread_limit.h"
#include "io/system/quoting.h"
#include "io/read/report_text.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/IO/parts_json.h>
#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_formats.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/IO/write_html.h>

#include <iostream>

namespace CGAL::Shape_correspondence::cli {

namespace po = boost::program_options;

namespace {

const char* const help_text =
    R"(Usage: shape_correspondence graph MODEL [options]

Builds the structural graph of a segmented shape: a curve or a sheet for every part, groups of symmetric parts, and
contacts between parts.

MODEL is one of
  - a model file: OBJ with o or g, PLY, STL, OFF, glTF/GLB, COLLADA, FBX, 3DS, DXF, AC3D. Its objects or nodes are the
    parts; an object of unrelated loose pieces is split into them (--parts);
  - a folder of part meshes: one file for each part, named after the part;
  - a structural graph (.json, .xml).

Example: shape_correspondence graph chair.obj -o chair.json --html chair.html

)";

/// Files for other tools and for people; empty: none.
struct Graph_files
{
  std::string graphml, dot, parts;
};

po::options_description graph_options(Common_options& common, Graph_files& files)
{
  po::options_description result = option_group("Options of graph");
  auto add = result.add_options();
  add("json,o", po::value(&common.json)->value_name("FILE"),
      "write the graph as JSON, which `match` reads in place of the model; - is standard output");
  add("glb", po::value(&common.glb)->value_name("FILE"),
      "write a picture as binary glTF: transparent surfaces, curves as tubes, sheets as patches, one colour for "
      "each group, contacts as lines");
  add("html", po::value(&common.html)->value_name("FILE"),
      "write the same as a web page with a table of the parts; it needs no network");
  add("graphml", po::value(&files.graphml)->value_name("FILE"),
      "write groups and contacts as GraphML: names, symmetries and solidities, no geometry");
  add("dot", po::value(&files.dot)->value_name("FILE"), "write the same for Graphviz");
  add("parts-json", po::value(&files.parts)->value_name("FILE"),
      "write which loose piece of the model is in which part, to be edited and read by --parts-from");
  add("parts-from", po::value(&common.parts_from)->value_name("FILE"), "read the parts of the model from such a list");
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

struct Variables
{
  Common_options common;
  Graph_files files;
};

po::options_description all_options(Variables& v)
{
  po::options_description result;
  result.add(graph_options(v.common, v.files)).add(model_options(v.common)).add(common_options(v.common));
  return result;
}

} // namespace

Command_help help_of_graph()
{
  static Variables unused;
  return {help_text, all_options(unused)};
}

void run_graph(const std::vector<std::string>& arguments)
{
  Variables variables;
  Common_options& common = variables.common;
  Graph_files& files = variables.files;
  const Arguments parsed = parse(arguments, all_options(variables), 1, 1);
  if (parsed.help) return write_help(std::cout, command_of("graph"));
  const Run_report report(common);
  refuse_abstraction_of_graphs(parsed);
  check(common);
  check_outputs({common.json, common.glb, common.html, files.graphml, files.dot, files.parts},
                {parsed.inputs[0], common.parts_from});
  const Thread_limit limit(common.threads);
  common.roles = IO::shipped_role_model();
  if (!files.parts.empty() && is_graph_file(parsed.inputs[0]))
    throw Usage_error("--parts-json is for models; a graph has no pieces");
  Loaded_shape shape = load_shape(parsed.inputs[0], common);
  check_part_kinds(common, part_names(shape.graph));
  if (!common.glb.empty()) {
    read_appearance(parsed.inputs[0], shape);
    warn_of_appearance(parsed.inputs[0], shape, common);
  }
  write_output(common.json, [&](std::ostream& out) { IO::write_structural_graph_json(out, shape.graph); });
  write_output(common.glb, [&](std::ostream& out) {
    IO::write_structural_graph_glb(out, shape.graph, shape.model_pointer(), shape.appearance);
  });
  write_output(common.html,
               [&](std::ostream& out) { IO::write_structural_graph_html(out, shape.graph, shape.model_pointer()); });
  write_output(files.graphml, [&](std::ostream& out) { IO::write_structural_graph_graphml(out, shape.graph); });
  write_output(files.parts, [&](std::ostream& out) { IO::write_parts_json(out, shape.split); });
  write_output(files.dot, [&](std::ostream& out) { IO::write_structural_graph_dot(out, shape.graph); });
  if (common.prints_table()) print_graph(parsed.inputs[0], shape.graph);
}

} // namespace CGAL::Shape_correspondence::cli
