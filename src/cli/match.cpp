// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Pair_command.h"
#include "cli/match_shapes.h"
#include "cli/run.h"
#include "cli/text.h"
#include "texture/dressed_meshes.h"
#include "viewer/match_page.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>

#include <iostream>

namespace CGAL::Shape_correspondence::cli {
namespace {

const char* const match_help =
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

Examples: shape_correspondence match chair.obj swivel_chair.obj -o result.html -o result.json
          shape_correspondence match chair.obj stool.obj --search exact --allow-unmatched --solutions 3

)";

class Match_command : public Pair_command
{
public:
  Match_command() : Pair_command(match_help)
  {
    Option_table::Group add = table.group("Output");
    add("output,o", "FILE", output_by_ending({{".html", &common.html}, {".json", &common.json}, {".glb", &common.glb}}),
        "what --html, --json or --glb writes, by the ending of FILE; can be repeated");
    add("json", "FILE", &common.json, "write the result as JSON; - is standard output").output();
    add("glb", "FILE", &common.glb,
        "write both shapes side by side as binary glTF; corresponding parts have one colour, unmatched parts are grey; "
        "a further scene, 'materials', has the materials of the models")
        .output()
        .rare();
    add("html", "FILE", &common.html,
        "write the same as a web page with a table of corresponding parts; it needs no network")
        .output();
    add_shared_options();
  }

private:
  void work() override
  {
    const bool shows_looks = !common.glb.empty() || !common.html.empty();
    common.graphs_suffice = !shows_looks;
    load();
    Matched_shapes matched = match_shapes(source(), target(), search);
    const std::vector<Correspondence>& ranked = matched.ranked;
    std::vector<std::string>& of_match = matched.ranked[0].warnings;
    of_match.insert(of_match.begin(), warnings.begin(), warnings.end());
    write_output(common.json, [&](std::ostream& out) {
      IO::write_correspondences_json(out, ranked, source().graph, target().graph, inputs[0], inputs[1],
                                     matched.seconds);
    });
    std::vector<std::string> notes = of_match;
    for (std::size_t i = 0; shows_looks && i < 2; ++i) {
      read_appearance(inputs[i], shapes[i]);
      note_appearance(inputs[i], shapes[i], common, notes);
    }
    write_output(common.glb, [&](std::ostream& out) {
      IO::write_correspondence_glb(out, ranked[0], source().graph, target().graph, source().model_pointer(),
                                   target().model_pointer(), source().appearance, target().appearance);
    });
    write_output(common.html, [&](std::ostream& out) {
      IO::write_page(out, IO::match_page(ranked, source().graph, target().graph, source().model_pointer(),
                                         target().model_pointer(), inputs[0], inputs[1], matched.seconds,
                                         IO::dressed_scenes({{source().model_pointer(), &source().appearance},
                                                             {target().model_pointer(), &target().appearance}},
                                                            IO::largest_page_textures)));
    });
    if (!common.prints_table()) return;
    write_match_table(std::cout, ranked[0], source().graph, target().graph, common.verbose);
    write_notes(std::cout, notes, common.verbose);
    if (common.verbose) write_group_table(std::cout, ranked[0], source().graph, target().graph);
  }
};

} // namespace

std::unique_ptr<Command> match_command() { return std::make_unique<Match_command>(); }

} // namespace CGAL::Shape_correspondence::cli
