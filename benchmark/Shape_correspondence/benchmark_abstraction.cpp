// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures part abstraction on folders of parts: benchmark_abstraction [--parts] [--triangles N] SHAPE_FOLDER...
// Every folder holds parts/ and, for the category, labels.json. If it also has structure.json, which states mid-lines
// and mid-surfaces, deviations from these are measured, too. --parts prints one line for each part; --triangles is that
// of the command `graph`.

#include "abstraction_error.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>

#include <CGAL/Real_timer.h>

#include <cstdio>
#include <iostream>
#include <map>
#include <string>

namespace SC = CGAL::Shape_correspondence;

namespace {

using Values = std::vector<double>;

/// Counts and measurements of the shapes of a category.
struct Totals
{
  std::size_t shapes = 0, parts = 0, copies = 0, curves = 0, closed_curves = 0, sheets = 0, fallbacks = 0, flagged = 0;
  Values seconds;                      ///< wall-clock time of each shape
  Values medialness, plain_medialness; ///< `medialness()` by curve point; `plain`: of unflagged parts in one piece
  Values sheet_residuals;              ///< by sheet, see `Abstraction_report::residual`
  Values deviations;                   ///< distances from the stated curve or sheet, over the part's diagonal
  std::size_t stated = 0, kinds_right = 0;
  SC::Phase_milliseconds phases;
};

std::string category_of(const std::string& folder)
{
  std::ifstream file(folder + "/labels.json");
  if (!file) return "-";
  const nlohmann::json document = nlohmann::json::parse(file);
  return document.contains("category") ? document["category"].get<std::string>() : "-";
}

std::string flags_of(const SC::Abstraction_report& report)
{
  std::string result;
  if (report.tube) result += " tube";
  if (report.blob) result += " blob";
  if (report.branching) result += " branching";
  if (report.several_components) result += " several_components";
  if (report.is_fallback()) result += " bounding_box (" + report.fallback + ")";
  return result;
}

void print_part(const SC::Part_abstraction& part, double medialness, double deviation)
{
  const SC::Abstraction_report& report = part.report;
  const SC::Phase_milliseconds& ms = report.phases;
  std::printf(
      "  %-24s %-6s %7.1f ms = repair %6.1f + remesh %6.1f + flow %6.1f + fit %6.1f + measure %5.1f; %3d steps, "
      "residual %.4f, medialness %.3f, deviation %.4f%s%s\n",
      part.name.c_str(),
      part.is_sheet()          ? "sheet"
      : part.is_closed_curve() ? "closed"
                               : "curve",
      report.milliseconds, ms.repair, ms.remesh, ms.flow, ms.fit, ms.measure, report.iterations, report.residual,
      medialness, deviation, report.copy_of.empty() ? "" : " copy", flags_of(report).c_str());
}

void measure_part(const SC::Part_abstraction& part, const SC::Part_mesh& mesh, const SC::Part_abstraction* stated,
                  bool print, Totals& totals)
{
  const SC::Abstraction_report& report = part.report;
  ++totals.parts;
  totals.copies += !report.copy_of.empty();
  totals.sheets += part.is_sheet();
  totals.closed_curves += part.is_closed_curve();
  totals.curves += !part.is_sheet() && !part.is_closed_curve();
  totals.fallbacks += report.is_fallback();
  totals.flagged += report.tube || report.blob || report.branching;
  totals.phases.measure += report.phases.measure;
  totals.phases.repair += report.phases.repair;
  totals.phases.remesh += report.phases.remesh;
  totals.phases.flow += report.phases.flow;
  totals.phases.fit += report.phases.fit;
  Values medialness, deviations;
  if (part.is_sheet())
    totals.sheet_residuals.push_back(report.residual);
  else
    medialness = SC::benchmark::medialness(std::get<SC::Curve>(part.geometry), mesh);
  totals.medialness.insert(totals.medialness.end(), medialness.begin(), medialness.end());
  if (flags_of(report).empty())
    totals.plain_medialness.insert(totals.plain_medialness.end(), medialness.begin(), medialness.end());
  if (stated) {
    ++totals.stated;
    totals.kinds_right += SC::benchmark::same_kind(part, *stated);
    for (double deviation : SC::benchmark::deviations(part, *stated))
      deviations.push_back(deviation / SC::benchmark::diagonal(mesh.points));
    totals.deviations.insert(totals.deviations.end(), deviations.begin(), deviations.end());
    if (!SC::benchmark::same_kind(part, *stated)) std::printf("  wrong kind: %s\n", part.name.c_str());
  }
  if (print) print_part(part, SC::benchmark::quantile(medialness, 0.5), SC::benchmark::quantile(deviations, 0.95));
}

void measure(const std::string& folder, const SC::Structure_options& options, bool print_parts,
             std::map<std::string, Totals>& by_category)
{
  CGAL::Real_timer timer;
  timer.start();
  const SC::Segmented_shape shape = SC::IO::read_segmented_shape(folder + "/parts");
  SC::Structure_times times;
  const SC::Structural_graph graph =
      SC::build_structural_graph<CGAL::Parallel_if_available_tag>(shape, options, &times);
  const double seconds = timer.time();
  Totals& totals = by_category[category_of(folder)];
  ++totals.shapes;
  totals.seconds.push_back(seconds);
  std::printf("%s: %zu parts, %.3f s, %.3f of them for abstraction, %.3f for structure\n", folder.c_str(),
              shape.parts().size(), seconds, times.abstraction, times.structure);
  const std::map<std::string, SC::Part_abstraction> stated = SC::benchmark::stated_abstractions(folder);
  for (std::size_t i = 0; i < shape.parts().size(); ++i) {
    const auto found = stated.find(shape.parts()[i].name);
    measure_part(structure(graph).parts[i], shape.parts()[i].mesh, found == stated.end() ? nullptr : &found->second,
                 print_parts, totals);
  }
}

void print(const std::string& category, const Totals& t)
{
  using SC::benchmark::quantile;
  std::printf(
      "%-11s %3zu shapes, %.3f s a shape (median); %zu parts, %zu copies; %zu curves, %zu closed, %zu sheets; %zu "
      "bounding boxes, %zu with tube, blob or branching flags\n",
      category.c_str(), t.shapes, quantile(t.seconds, 0.5), t.parts, t.copies, t.curves, t.closed_curves, t.sheets,
      t.fallbacks, t.flagged);
  std::printf(
      "            medialness of curve points: median %.3f, 90 %% %.3f, of parts in one piece without flags %.3f, "
      "%.3f; residual of sheets: median %.4f, 90 %% %.4f\n",
      quantile(t.medialness, 0.5), quantile(t.medialness, 0.9), quantile(t.plain_medialness, 0.5),
      quantile(t.plain_medialness, 0.9), quantile(t.sheet_residuals, 0.5), quantile(t.sheet_residuals, 0.9));
  std::printf("            ms in all: repair %.0f, remesh %.0f, flow %.0f, fit %.0f, measure %.0f\n", t.phases.repair,
              t.phases.remesh, t.phases.flow, t.phases.fit, t.phases.measure);
  if (t.stated > 0)
    std::printf(
        "            against what is stated: kind right %zu of %zu; deviation over diagonal: median %.4f, 95 %% "
        "%.4f\n",
        t.kinds_right, t.stated, quantile(t.deviations, 0.5), quantile(t.deviations, 0.95));
}

} // namespace

int main(int argc, char** argv)
{
  bool print_parts = false;
  SC::Structure_options options;
  std::map<std::string, Totals> by_category;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    try {
      if (argument == "--parts")
        print_parts = true;
      else if (argument == "--triangles" && i + 1 < argc)
        options.abstraction.triangles = std::stoi(argv[++i]);
      else
        measure(argument, options, print_parts, by_category);
    } catch (const std::exception& error) {
      std::cerr << argv[i] << ": " << error.what() << "\n";
      return 1;
    }
  }
  for (const auto& [category, totals] : by_category)
    print(category, totals);
}
