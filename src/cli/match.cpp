// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/choose_parts.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/load_shape.h"
#include "cli/match_options.h"
#include "cli/match_shapes.h"
#include "cli/match_table.h"
#include "cli/outputs.h"
#include "cli/run_report.h"
#include "cli/thread_limit.h"
#include "texture/dressed_meshes.h"
#include "viewer/match_page.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <iostream>

namespace CGAL::Shape_correspondence::cli {

namespace po = boost::program_options;

namespace {

const char* const help_text =
    R"(Usage: shape_correspondence match SOURCE TARGET [options]

Finds which parts of two segmented shapes of one category correspond. A part may correspond to one part, to several, or
to none. By default, parts are matched by the cost of substituting one for the other (place, size, shape, contacts) and
by their roles, such as leg or seat (--roles). With --paper, --search beam or --search exact, the correspondence of
least deformation energy is searched for instead. Shapes are assumed to face +z.

SOURCE and TARGET are each one of
  - a model file: OBJ with o or g, PLY, STL, OFF, glTF/GLB, COLLADA, FBX, 3DS, DXF, AC3D. Its objects or nodes are the
    parts; an object of unrelated loose pieces is split into them (--parts);
  - a folder of part meshes: one file for each part, named after the part;
  - a structural graph (.json, .xml) that `graph` wrote.

The table lists sets of parts that correspond. The operation is how the source becomes the target: match (one to one),
split (one to several), merge (several to fewer), duplicate (several to more), cut (a curve into segments) and join (its
inverse). The confidence is the probability that a pair is right. The deformation energy is E of the paper, Eq. 1; the
distance is the energy per pair of connected parts, by which `collection` compares shapes.

Examples: shape_correspondence match chair.obj swivel_chair.obj --json result.json --html result.html
          shape_correspondence match chair.obj stool.obj --search exact --allow-unmatched --solutions 3

)";

po::options_description output_options(Common_options& common)
{
  po::options_description result = option_group("Output");
  auto add = result.add_options();
  add("json", po::value(&common.json)->value_name("FILE"), "write the result as JSON; - is standard output");
  add("glb", po::value(&common.glb)->value_name("FILE"),
      "write both shapes side by side as binary glTF; corresponding parts have one colour, unmatched parts are grey; a "
      "further scene, 'materials', has the materials of the models");
  add("html", po::value(&common.html)->value_name("FILE"),
      "write the same as a web page with a table of corresponding parts; it needs no network");
  return result;
}

struct Variables
{
  Common_options common;
  Match_options match;
};

po::options_description all_options(Variables& v)
{
  po::options_description result;
  result.add(output_options(v.common))
      .add(match_options(v.match))
      .add(pair_options(v.common))
      .add(model_options(v.common))
      .add(common_options(v.common));
  return result;
}

} // namespace

Command_help help_of_match()
{
  static Variables unused;
  return {help_text, all_options(unused)};
}

void run_match(const std::vector<std::string>& arguments)
{
  Variables variables;
  Common_options& common = variables.common;
  Match_options& match = variables.match;
  const Arguments parsed = parse(arguments, all_options(variables), 2, 2);
  if (parsed.help) return write_help(std::cout, command_of("match"));
  const Run_report report(common);
  refuse_abstraction_of_graphs(parsed);
  Search_options search_with = search_options(match, parsed.values);
  check(common);
  check_outputs({common.json, common.glb, common.html}, parsed.inputs);
  const Thread_limit limit(common.threads);
  const std::vector<std::string>& paths = parsed.inputs;
  common.roles = search_with.roles;
  common.graphs_suffice = common.glb.empty() && common.html.empty();
  std::vector<std::string> warnings_of_up;
  std::vector<Loaded_shape> shapes = load_pair(paths, common, warnings_of_up);
  const Loaded_shape &source = shapes[0], &target = shapes[1];
  add_examples(match, common, search_with);
  choose_parts(match, {source.graph, paths[0]}, {target.graph, paths[1]}, search_with);
  Matched_shapes matched = match_shapes(source, target, search_with);
  std::vector<Correspondence>& ranked = matched.ranked;
  std::vector<std::string> warnings = warnings_of(paths, shapes);
  warnings.insert(warnings.begin(), warnings_of_up.begin(), warnings_of_up.end());
  ranked[0].warnings.insert(ranked[0].warnings.begin(), warnings.begin(), warnings.end());
  write_output(common.json, [&](std::ostream& out) {
    IO::write_correspondences_json(out, ranked, source.graph, target.graph, paths[0], paths[1], matched.seconds);
  });
  for (std::size_t i = 0; !(common.glb.empty() && common.html.empty()) && i < 2; ++i) {
    read_appearance(paths[i], shapes[i]);
    warn_of_appearance(paths[i], shapes[i], common);
  }
  write_output(common.glb, [&](std::ostream& out) {
    IO::write_correspondence_glb(out, ranked[0], source.graph, target.graph, source.model_pointer(),
                                 target.model_pointer(), source.appearance, target.appearance);
  });
  write_output(common.html, [&](std::ostream& out) {
    IO::write_page(out, IO::match_page(ranked, source.graph, target.graph, source.model_pointer(),
                                       target.model_pointer(), paths[0], paths[1], matched.seconds,
                                       IO::dressed_scenes({{source.model_pointer(), &source.appearance},
                                                           {target.model_pointer(), &target.appearance}},
                                                          IO::largest_page_textures)));
  });
  if (!common.prints_table()) return;
  write_match_table(std::cout, ranked[0], source.graph, target.graph);
  if (common.verbose) write_group_table(std::cout, ranked[0], source.graph, target.graph);
}

} // namespace CGAL::Shape_correspondence::cli
