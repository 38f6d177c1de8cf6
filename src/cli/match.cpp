// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Command.h"
#include "cli/jobs.h"
#include "cli/run.h"
#include "io/system/quoting.h"
#include "io/write/part_labels.h"
#include "texture/dressed_meshes.h"
#include "viewer/pages.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/correspondence_blocks.h>
#include <CGAL/Shape_correspondence/energy_matrix.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace CGAL::Shape_correspondence::cli {
namespace {

const char* const match_help =
    R"(Usage: shape_correspondence match SOURCE TARGET [options]

Finds which parts of two shapes of one category correspond. A part may correspond to one part, to several, or to none.
By default, two parts are compared by place, size, shape, contacts and role, such as leg or seat (--roles). --paper,
--search beam and --search exact search for the correspondence of least deformation energy instead. Shapes should face
+z.

SOURCE and TARGET are each one of
  - a model file: OBJ with o or g, PLY, STL, OFF, glTF/GLB, COLLADA, FBX, 3DS, 3MF, DXF, AC3D, URDF. Its objects,
    nodes or links are the parts. An object that is not one part is divided by the shape of its pieces (--parts);
  - a folder of part meshes: one file for each part, named after the part;
  - a structural graph (.json) that `graph` wrote.

Each row of the table is a set of source parts and the set of target parts that it corresponds to. The operation says
how the source parts become the target parts: match (one to one), split (one to several), merge (several to fewer),
duplicate (several to more), cut (a curve into segments) or join (its inverse). The confidence is the probability that a
pair of the row is right. The deformation energy is E of the paper, Eq. 1. The distance is the energy per pair of
connected parts; `collection` compares shapes by it.

Examples: shape_correspondence match chair.obj swivel_chair.obj -o result.html -o result.json
          shape_correspondence match chair.obj stool.obj --search exact --allow-unmatched --solutions 3

)";

using Rows = std::vector<std::vector<std::string>>;
using Parts = std::vector<std::size_t>;
using Lines = std::vector<std::string>;

constexpr std::size_t narrowest_names = 16; // least width of a column of part names, in characters
constexpr std::size_t folded_lines = 4;     // largest number of lines of a cell if not all parts are listed

/// The labels of a shape's parts, for readers.
Lines labels_of(const Structural_graph& graph, const Lines& roles)
{
  return IO::part_labels(mapped(part_names(graph), [](const std::string& name) { return IO::quote_terminal(name); }),
                         roles);
}

Lines labels_of(const Parts& parts, const Lines& labels)
{
  return IO::with_ranges(mapped(parts, [&](std::size_t part) { return labels[part]; }));
}

/// A cell with the names of parts, wrapped to a width. \param all whether the number of lines is unlimited; otherwise
/// too many names are replaced by their number
Lines cell_of(const Parts& parts, const Lines& labels, std::size_t width, bool all)
{
  const Lines lines = wrapped(listed(labels_of(parts, labels)), width);
  if (all || lines.size() <= folded_lines) return lines;
  return {std::to_string(parts.size()) + " parts"};
}

std::string operation_text(const Correspondence_block& block)
{
  const std::string name = name_of(block.operation);
  if (block.source.size() == 1 && block.target.size() == 1) return name;
  return name + " " + std::to_string(block.source.size()) + ":" + std::to_string(block.target.size());
}

/// Adds a row, which takes several lines if cells do. \param cells lines of each cell
void add_row(const std::vector<Lines>& cells, Rows& rows)
{
  std::size_t lines = 1;
  for (const Lines& cell : cells)
    lines = std::max(lines, cell.size());
  for (std::size_t line = 0; line < lines; ++line) {
    rows.emplace_back();
    for (const Lines& cell : cells)
      rows.back().push_back(line < cell.size() ? cell[line] : "");
  }
}

/// The width for each of two columns of names, so that they fit a line together with columns of the widths `others`.
std::size_t width_of_names(const std::vector<std::size_t>& others)
{
  std::size_t taken = 2 * (others.size() + 2);
  for (std::size_t width : others)
    taken += width;
  return std::max(narrowest_names, (line_width - std::min(line_width, taken)) / 2);
}

/// The table rows of blocks: role, source, target, operation, confidence; role and confidence only if known.
Rows rows_of(const Correspondence& c, const Lines& source, const Lines& target, bool all)
{
  const std::vector<Correspondence_block> blocks = correspondence_blocks(c);
  const bool has_roles = !c.category.empty(), has_confidence = !blocks.empty() && !std::isnan(blocks[0].confidence);
  std::vector<std::size_t> others{has_roles ? std::string("role").size() : 0, std::string("operation").size(),
                                  std::string("conf.").size()};
  for (const Correspondence_block& block : blocks) {
    others[0] = std::max(others[0], block.role.size());
    others[1] = std::max(others[1], operation_text(block).size());
  }
  const std::size_t width = width_of_names(others);
  Rows rows;
  const auto add = [&](const std::string& role, const Lines& left, const Lines& right, const std::string& operation,
                       const std::string& confidence) {
    std::vector<Lines> cells{left, right, {operation}};
    if (has_roles) cells.insert(cells.begin(), Lines{role});
    if (has_confidence) cells.push_back({confidence});
    add_row(cells, rows);
  };
  add("role", {"source"}, {"target"}, "operation", "conf.");
  for (const Correspondence_block& block : blocks)
    add(block.role, cell_of(block.source, source, width, all), cell_of(block.target, target, width, all),
        operation_text(block), has_confidence ? percentage(block.confidence) : "");
  return rows;
}

/// Writes a text in lines; all but the first are indented.
void write_wrapped(std::ostream& out, const std::string& text)
{
  const char* indent = "";
  for (const std::string& line : wrapped(text, line_width - 2)) {
    out << indent << line << '\n';
    indent = "  ";
  }
}

/// A text of the form `3 of 12 parts: a, b, c`.
std::string unmatched_text(const Parts& parts, const Lines& labels)
{
  if (parts.empty()) return "-";
  return std::to_string(parts.size()) + " of " + std::to_string(labels.size()) +
         " parts: " + listed(labels_of(parts, labels));
}

/// Writes a row for each symmetry group of the deformed shape: the parts matched to it, and its share of the energy.
void write_group_table(std::ostream& out, const Correspondence& c, const Structural_graph& source,
                       const Structural_graph& target)
{
  Rows rows{{"group in the source", "target", "operation", "energy", "distortion", "connectedness"}};
  if (c.direction == Direction::TARGET_TO_SOURCE)
    rows[0][0] = "source", rows[0][1] = "group in the target", rows[0][2] = "operation on the target";
  const std::size_t width = width_of_names({9, 6, 10, 13}); // operation, energy, distortion, connectedness
  const Lines source_labels = labels_of(source, c.source_roles), target_labels = labels_of(target, c.target_roles);
  for (const Group_match& group : c.groups)
    add_row({wrapped(listed(labels_of(group.source, source_labels)), width),
             wrapped(listed(labels_of(group.target, target_labels)), width),
             {name_of(group.operation)},
             {short_number(group.energy)},
             {short_number(group.distortion)},
             {short_number(group.connectedness)}},
            rows);
  out << '\n';
  write_table(out, rows);
}

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
      read_appearance(shapes[i]);
      note_appearance(shapes[i], common, notes);
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

Matched_shapes match_shapes(const Loaded_shape& source, const Loaded_shape& target, const Search_options& options)
{
  const Prepared_shape prepared_source(source.graph), prepared_target(target.graph);
  const double begin_roles = now();
  for (const Prepared_shape* shape : {&prepared_source, &prepared_target})
    shape->read_roles(options.roles);
  const double begin = now();
  Matched_shapes result{Correspondence_finder(prepared_source, options).ranked(prepared_target), {}};
  result.seconds = {source.read_seconds + target.read_seconds, source.abstraction_seconds + target.abstraction_seconds,
                    source.structure_seconds + target.structure_seconds + begin - begin_roles, now() - begin};
  return result;
}

void write_match_table(std::ostream& out, const Correspondence& c, const Structural_graph& source,
                       const Structural_graph& target, bool verbose)
{
  const Lines source_labels = labels_of(source, c.source_roles), target_labels = labels_of(target, c.target_roles);
  write_table(out, rows_of(c, source_labels, target_labels, verbose));
  out << '\n';
  if (!c.category.empty()) out << "category: " << c.category << '\n';
  write_wrapped(out, "unmatched in the source: " + unmatched_text(c.unmatched_source, source_labels));
  write_wrapped(out, "unmatched in the target: " + unmatched_text(c.unmatched_target, target_labels));
  out << "deformation energy: " << short_number(c.energy) << " (distortion " << short_number(c.terms.distortion)
      << ", connectedness " << short_number(c.terms.connectedness) << ", split " << short_number(c.terms.split)
      << ")\n  the "
      << (c.direction == Direction::SOURCE_TO_TARGET ? "source deformed into the target"
                                                     : "target deformed into the source")
      << (c.complete ? "" : ", incomplete") << (c.optimal ? ", proven minimal for this direction" : "") << '\n';
  out << "distance: " << short_number(distance_energy(c, Energy_matrix_options().unmatched_energy))
      << " (energy per pair of connected parts)\n";
}

std::unique_ptr<Command> match_command() { return std::make_unique<Match_command>(); }

} // namespace CGAL::Shape_correspondence::cli
