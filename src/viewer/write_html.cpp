// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/drawn_shape.h"
#include "io/report_text.h"
#include "viewer/html_page.h"

#include <CGAL/Shape_correspondence/IO/write_html.h>

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <sstream>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr double page_surface_alpha = 0.35;
constexpr const char *surfaces = "surfaces", *abstractions = "curves and sheets", *contacts = "contacts";

using boost::algorithm::join;
using Details = std::vector<std::pair<std::string, std::string>>;

std::string text_of(double number)
{
  std::ostringstream out;
  out.precision(3);
  out << number;
  return out.str();
}

std::string method_of(const Abstraction_report& report)
{
  return name_of(report.method) + (report.copy_of.empty() ? "" : std::string(" of ") + report.copy_of);
}

Details details_of(const Part_abstraction& part)
{
  const Abstraction_report& report = part.report;
  Details result{{"kind", kind_of(part)}, {"method", method_of(report)}, {"repair", name_of(report.repair)}};
  if (!flags_of(report).empty()) result.emplace_back("flags", join(flags_of(report), ", "));
  if (report.is_fallback()) result.emplace_back("bounding box, because", report.fallback);
  result.emplace_back("residual", text_of(report.residual));
  result.emplace_back("coverage", text_of(report.coverage));
  result.emplace_back("solidity", text_of(solidity(part.volume, part.hull_volume)));
  return result;
}

std::vector<std::string> part_cells(const std::string& group, const Part_abstraction& part)
{
  return {group, part.name, kind_of(part), method_of(part.report), join(flags_of(part.report), ", ")};
}

/// Adds the parts of one shape of a pair. \return the thing of each
std::vector<int> add_shape(Html_page& page, const Drawn_shape& shape, const Point& place, const int* numbers,
                           const std::vector<Colour>& colours)
{
  std::vector<int> things;
  for (std::size_t part = 0; part < shape.number_of_parts(); ++part) {
    Details details{{"shape", shape.name()}};
    const Details more = details_of(shape.part(part));
    details.insert(details.end(), more.begin(), more.end());
    things.push_back(page.add_thing(shape.part(part).name, details));
    const Colour colour = numbers[part] < 0 ? grey() : colours[static_cast<std::size_t>(numbers[part])];
    page.add_layer(things.back(), numbers[part] < 0 ? "unmatched" : "matched", shape.best_mesh(part), colour, 1, place);
  }
  return things;
}

/// One row a match: its parts on both sides.
void add_matches(Html_page& page, const Drawn_shape shapes[2], const std::vector<int> things[2],
                 const std::vector<int>& numbers, const std::vector<Colour>& colours)
{
  page.set_table_heading({shapes[0].name(), shapes[1].name()});
  const int unmatched = -1;
  for (int match = 0; match <= static_cast<int>(colours.size()); ++match) {
    const bool is_last = match == static_cast<int>(colours.size());
    std::vector<int> row;
    std::vector<std::string> names[2];
    for (std::size_t side = 0, i = 0; side < 2; ++side) {
      for (std::size_t part = 0; part < shapes[side].number_of_parts(); ++part, ++i) {
        if (numbers[i] != (is_last ? unmatched : match)) continue;
        row.push_back(things[side][part]);
        names[side].push_back(shapes[side].part(part).name);
      }
    }
    if (!row.empty())
      page.add_row(row, is_last ? grey() : colours[static_cast<std::size_t>(match)],
                   {join(names[0], ", "), join(names[1], ", ")});
  }
}

} // namespace

void write_structural_graph_html(std::ostream& out, const Structural_graph& graph, const Segmented_shape* shape)
{
  const Drawn_shape drawn(graph, shape, 0);
  const Shape_structure& all = structure(graph);
  const std::vector<Colour> colours = distinct_colours(num_vertices(graph));
  Html_page page(all.name);
  page.add_note(std::to_string(all.parts.size()) + " parts, " + std::to_string(num_vertices(graph)) + " groups, " +
                std::to_string(all.contacts.size()) + " contacts");
  for (const std::string& warning : all.warnings)
    page.add_note("Warning: " + warning);
  page.set_table_heading({"group", "part", "kind", "method", "flags"});
  for (std::size_t v = 0; v < num_vertices(graph); ++v) {
    const std::string group = std::to_string(v + 1) + ", " + name_of(graph[v].symmetry);
    for (std::size_t part : graph[v].parts) {
      Details details = details_of(all.parts[part]);
      details.emplace_back("group", group);
      const int thing = page.add_thing(all.parts[part].name, details);
      page.add_layer(thing, abstractions, drawn.abstraction(part), colours[v], 1);
      if (drawn.has_mesh()) page.add_layer(thing, surfaces, drawn.surface(part), colours[v], page_surface_alpha);
      page.add_row({thing}, colours[v], part_cells(group, all.parts[part]));
    }
  }
  page.add_layer(-1, contacts, drawn.contacts(), Colour(0.02, 0.02, 0.02), 1);
  page.write(out);
}

void write_correspondence_html(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                               const Structural_graph& target, const Segmented_shape* source_shape,
                               const Segmented_shape* target_shape)
{
  const Drawn_shape shapes[] = {Drawn_shape(source, source_shape, 0),
                                Drawn_shape(target, target_shape, correspondence.target_quarter_turns)};
  const std::size_t sources = shapes[0].number_of_parts();
  const std::vector<int> numbers = match_numbers(correspondence, sources, shapes[1].number_of_parts());
  const int matches = 1 + *std::max_element(numbers.begin(), numbers.end());
  const std::vector<Colour> colours = distinct_colours(static_cast<std::size_t>(matches));
  const std::array<Point, 2> places = side_by_side(shapes[0], shapes[1]);
  Html_page page(shapes[0].name() + " and " + shapes[1].name());
  page.add_note("Energy " + text_of(correspondence.energy) + ": distortion " +
                text_of(correspondence.terms.distortion) + ", connectedness " +
                text_of(correspondence.terms.connectedness) + ", split " + text_of(correspondence.terms.split));
  for (const std::string& warning : correspondence.warnings)
    page.add_note("Warning: " + warning);
  const std::vector<int> things[] = {add_shape(page, shapes[0], places[0], numbers.data(), colours),
                                     add_shape(page, shapes[1], places[1], numbers.data() + sources, colours)};
  add_matches(page, shapes, things, numbers, colours);
  page.write(out);
}

} // namespace CGAL::Shape_correspondence::IO
