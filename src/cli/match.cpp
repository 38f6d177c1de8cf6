// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/clock.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/load_shape.h"
#include "cli/match_options.h"
#include "cli/match_table.h"
#include "cli/outputs.h"
#include "cli/read_model.h"
#include "cli/thread_limit.h"
#include "viewer/match_page.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/IO/write_glb.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <iostream>

namespace CGAL::Shape_correspondence::cli {

namespace po = boost::program_options;

namespace {

const char* const help_text =
    R"(Usage: shape_correspondence match SOURCE TARGET [options]

Finds which parts of two segmented shapes of one kind correspond. A part may correspond to many, or to none.
Parts are compared by place, size and shape, and by what they are for (--roles; shapes look to +z), which agrees
best with people, and the result is rated by the energy of deforming the source into the target. With --paper, --search beam or --search exact, the
correspondence of least deformation energy is searched for instead.

SOURCE and TARGET are model files (OBJ with o/g, PLY, STL, OFF, glTF/GLB, COLLADA, FBX, 3DS, DXF, AC3D; an object or
node is a part, unless it gathers loose pieces, see --parts), folders of part meshes (one file is one part, its stem the part's name), or structural graphs (.json, .xml).

Examples: shape_correspondence match chair.obj swivel_chair.obj --json result.json --html result.html
          shape_correspondence match chair.obj stool.obj --search exact --allow-unmatched --solutions 3

)";

po::options_description output_options(Common_options& common)
{
  po::options_description result = option_group("Output");
  auto add = result.add_options();
  add("json", po::value(&common.json)->value_name("FILE"), "write the result as JSON; - is standard output");
  add("glb", po::value(&common.glb)->value_name("FILE"),
      "write a picture as binary glTF: both shapes side by side, what corresponds in one colour, the rest grey");
  add("html", po::value(&common.html)->value_name("FILE"),
      "write the same picture as a web page that needs no network, with a table of what corresponds");
  return result;
}

} // namespace

void run_match(const std::vector<std::string>& arguments)
{
  Common_options common;
  Match_options match;
  po::options_description options;
  options.add(output_options(common))
      .add(match_options(match))
      .add(pair_options(common))
      .add(model_options(common))
      .add(common_options(common));
  const Arguments parsed = parse(arguments, options, 2, 2);
  if (parsed.help) {
    std::cout << help_text << options;
    return;
  }
  Search_options search_with = search_options(match, parsed.values);
  check(common);
  check_outputs({common.json, common.glb, common.html}, parsed.inputs);
  const Thread_limit limit(common.threads);
  const std::vector<std::string>& paths = parsed.inputs;
  const std::vector<std::string> warnings_of_up = find_up_of_pair(paths, common);
  const std::vector<Loaded_shape> shapes = load_shapes(paths, common);
  const Loaded_shape &source = shapes[0], &target = shapes[1];
  search_with.source_parts = chosen_parts(match.source_parts, source.graph, paths[0]);
  search_with.target_parts = chosen_parts(match.target_parts, target.graph, paths[1]);
  const Prepared_shape prepared_source(source.graph), prepared_target(target.graph);
  const double begin_roles = now();
  for (const Prepared_shape* shape : {&prepared_source, &prepared_target})
    shape->read_roles(search_with.roles);
  const double begin = now();
  std::vector<Correspondence> ranked =
      Correspondence_finder(prepared_source, search_with).ranked(prepared_target); // the best first
  const IO::Match_seconds seconds{
      source.read_seconds + target.read_seconds, source.abstraction_seconds + target.abstraction_seconds,
      source.structure_seconds + target.structure_seconds + begin - begin_roles, now() - begin};
  std::vector<std::string> warnings = warnings_of(paths, shapes);
  warnings.insert(warnings.begin(), warnings_of_up.begin(), warnings_of_up.end());
  ranked[0].warnings.insert(ranked[0].warnings.begin(), warnings.begin(), warnings.end());
  write_output(common.json, [&](std::ostream& out) {
    IO::write_correspondences_json(out, ranked, source.graph, target.graph, paths[0], paths[1], seconds);
  });
  write_output(common.glb, [&](std::ostream& out) {
    IO::write_correspondence_glb(out, ranked[0], source.graph, target.graph, source.model_pointer(),
                                 target.model_pointer());
  });
  write_output(common.html, [&](std::ostream& out) {
    IO::write_page(out, IO::match_page(ranked, source.graph, target.graph, source.model_pointer(),
                                       target.model_pointer(), paths[0], paths[1], seconds));
  });
  if (common.prints_table()) write_match_table(std::cout, ranked[0], source.graph, target.graph);
}

} // namespace CGAL::Shape_correspondence::cli
