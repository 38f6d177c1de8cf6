// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Command.h"
#include "cli/load_shape.h"
#include "cli/run.h"
#include "io/read/report_text.h"
#include "io/system/quoting.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/IO/parts_json.h>
#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_formats.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/IO/write_html.h>

#include <iostream>

namespace CGAL::Shape_correspondence::cli {
namespace {

const char* const graph_help =
    R"(Usage: shape_correspondence graph MODEL [options]

Builds the structural graph of a segmented shape: a curve or a sheet for every part, groups of symmetric parts, and
contacts between parts.

MODEL is one of
  - a model file: OBJ with o or g, PLY, STL, OFF, glTF/GLB, COLLADA, FBX, 3DS, 3MF, DXF, AC3D, URDF. Its objects,
    nodes or links are the parts. An object that is not one part is divided by the shape of its pieces (--parts);
  - a folder of part meshes: one file for each part, named after the part;
  - a structural graph (.json).

Example: shape_correspondence graph chair.obj -o chair.json -o chair.html

)";

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

void print_graph(const std::string& path, const Structural_graph& graph, const std::vector<std::string>& notes,
                 bool verbose)
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
  if (!notes.empty()) std::cout << '\n';
  write_notes(std::cout, notes, verbose);
}

class Graph_command : public Command
{
public:
  Graph_command() : Command(graph_help, 1, 1)
  {
    Option_table::Group add = table.group("Options of graph");
    add("output,o", "FILE",
        output_by_ending({{".json", &common.json},
                          {".html", &common.html},
                          {".glb", &common.glb},
                          {".graphml", &graphml_},
                          {".dot", &dot_}}),
        "what an option of that name writes, by the ending of FILE: .json, .html, .glb, .graphml or .dot; can be "
        "repeated");
    add("json", "FILE", &common.json,
        "write the graph as JSON, which `match` reads in place of the model; - is standard output")
        .output();
    add("glb", "FILE", &common.glb,
        "write a picture as binary glTF: transparent surfaces, curves as tubes, sheets as patches, one colour for each "
        "group, contacts as lines")
        .output();
    add("html", "FILE", &common.html, "write the same as a web page with a table of the parts; it needs no network")
        .output();
    add("graphml", "FILE", &graphml_,
        "write groups and contacts as GraphML: names, symmetries and solidities, no geometry")
        .output()
        .rare();
    add("dot", "FILE", &dot_, "write the same for Graphviz").output().rare();
    add("parts-json", "FILE", &pieces_,
        "write which loose piece of the model is in which part, to be edited and read by --parts-from")
        .output();
    add("parts-from", "FILE", &common.parts_from,
        "read the parts of the model from such a list, or from a list with a label for each face (.seg, .txt, .labels)")
        .input();
    add_model_options(table, common);
    add_common_options(table, common);
  }

private:
  void check() override
  {
    refuse_abstraction_of_graphs();
    if (!pieces_.empty() && is_graph_file(inputs[0]))
      throw Usage_error("--parts-json is for models; a graph has no pieces");
  }

  void work() override
  {
    common.roles = IO::shipped_role_model();
    Loaded_shape shape = std::move(load_shapes(inputs, common)[0]);
    std::vector<std::string> notes = structure(shape.graph).warnings;
    if (!common.glb.empty()) {
      read_appearance(shape);
      note_appearance(shape, common, notes);
    }
    write_output(common.json, [&](std::ostream& out) { IO::write_structural_graph_json(out, shape.graph); });
    write_output(common.glb, [&](std::ostream& out) {
      IO::write_structural_graph_glb(out, shape.graph, shape.model_pointer(), shape.appearance);
    });
    write_output(common.html,
                 [&](std::ostream& out) { IO::write_structural_graph_html(out, shape.graph, shape.model_pointer()); });
    write_output(graphml_, [&](std::ostream& out) { IO::write_structural_graph_graphml(out, shape.graph); });
    write_output(pieces_, [&](std::ostream& out) { IO::write_parts_json(out, shape.split); });
    write_output(dot_, [&](std::ostream& out) { IO::write_structural_graph_dot(out, shape.graph); });
    if (common.prints_table()) print_graph(inputs[0], shape.graph, notes, common.verbose);
  }

  std::string graphml_, dot_, pieces_; // files; empty: none
};

} // namespace

std::unique_ptr<Command> graph_command() { return std::make_unique<Graph_command>(); }

} // namespace CGAL::Shape_correspondence::cli
