// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/blend.h"
#include "cli/Pair_command.h"
#include "cli/match.h"
#include "cli/run.h"
#include "cli/text.h"
#include "matching/unlikely_pairs.h"
#include "viewer/match_page.h"
#include "viewer/page_models.h"

#include <CGAL/Shape_correspondence/IO/write_blend.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <sstream>

namespace CGAL::Shape_correspondence::cli {
namespace {

const char* const blend_help =
    R"(Usage: shape_correspondence blend SOURCE TARGET -o FOLDER|FILE.glb|FILE.html [options]

Makes the shapes in between two shapes of one category. The shapes may differ in topology. The first frame is the source,
the last one the target. All frames stand on the ground, in the axes of the source.

  - Parts that correspond morph: they move straight to the place of their counterpart and change their surface gradually,
    by the outlines of their cross-sections.
  - Parts that correspond but differ too much, such as legs and a star base, are exchanged: old parts become thin while
    new ones grow.
  - Parts without counterpart shrink into the parts that carry them, or grow out of them.

All parts that do not morph follow the motion of those that do, so that they stay attached.

The ending of -o sets what is written:
  - FILE.glb: an animation of all frames;
  - FILE.html: a web page that plays the blend and needs no network;
  - FILE.obj, FILE.ply or FILE.glb with --at T: one shape, with --solid as one closed surface;
  - FOLDER: one file for each frame, frame_000 and so on.
In a frame, a part is named s~t where source part s becomes target part t, s~ where s vanishes, and ~t where t grows.

SOURCE and TARGET are each one of
  - a model file: OBJ with o or g, PLY, STL, OFF, glTF/GLB, COLLADA, FBX, 3DS, 3MF, DXF, AC3D, URDF. Its objects,
    nodes or links are the parts. An object that is not one part is divided by the shape of its pieces (--parts);
  - a folder of part meshes: one file for each part, named after the part;
  - a structural graph (.json) whose parts name their meshes (key "mesh", a path relative to the graph file).

With --match R.json, the correspondence is read from a result of `match` for the same two shapes. Options of the search
are then errors.

Pairs with a confidence below --min-confidence are left out; their parts have no counterpart. A schedule defines when
each part changes. --schedule takes the best one, one by its name, or all whose frames differ: all are written into one
folder each (with --at: one file each), the best one first.

Examples: shape_correspondence blend chair.obj swivel_chair.obj -o blend.glb
          shape_correspondence blend chair.obj swivel_chair.obj -o frames --match chair_swivel.json --frames 9
          shape_correspondence blend chair.obj swivel_chair.obj -o print.obj --at 0.5 --solid
          shape_correspondence blend chair.obj swivel_chair.obj -o between --schedule all --at 0.5 --size same

)";

void print_schedules(const Shape_blend& blend)
{
  std::vector<std::vector<std::string>> rows{{"schedule", "support", "apart"}};
  for (const auto& [name, tasks, quality] : blend.schedules())
    rows.push_back({name, short_number(quality.support), short_number(quality.apart)});
  write_table(std::cout, rows);
  std::cout << "\nThe first schedule is used. Of the in-between shapes that were rated, the maximum of\n"
               "  support  share of the parts on the ground that is missing\n"
               "  apart    how much wider gaps it takes to join all parts than at the ends, over the height\n";
}

class Blend_command : public Pair_command
{
public:
  Blend_command() : Pair_command(blend_help)
  {
    match.search.min_confidence = Blend_options().min_confidence;
    Option_table::Group add = table.group("Output");
    add_output_options(add, output_);
    add_result_option(add);
    add("json", "FILE", &common.json,
        "write the schedule of the parts and the quality of every frame as JSON; - is standard output")
        .rare();
    add_shared_options();
  }

private:
  void check() override
  {
    Pair_command::check();
    search.min_confidence = 0; // less probable pairs are removed below, with a warning
    check_output(output_);
  }

  std::vector<std::string> output_files() const override
  {
    return {common.json, output_.is_file() ? output_.path : ""};
  }

  void read_looks()
  {
    if (!output_.may_show_materials() || output_.colours == "match") return;
    for (Loaded_shape& shape : shapes) {
      read_appearance(shape);
      append(warnings, warnings_of_appearance(shape));
    }
  }

  void write_page(const Shape_blend& blend, const Correspondence& pairs,
                  const std::function<void(std::ostream&)>& write_json) const
  {
    IO::Page page = IO::match_page({pairs}, source().graph, target().graph, source().model_pointer(),
                                   target().model_pointer(), inputs[0], inputs[1], {});
    std::ostringstream json;
    write_json(json);
    IO::add_blend(page, json.str(), blend, pairs, output_.frames);
    write_output(output_.path, [&](std::ostream& out) { IO::write_page(out, page); });
  }

  void work() override
  {
    load();
    for (Loaded_shape& shape : shapes)
      complete_surfaces(shape);
    Correspondence pairs = correspondence();
    const std::vector<std::string> unlikely = remove_unlikely(pairs, match.search.min_confidence, source(), target());

    Progress_bar bar(common, "blend");
    Blend_options options = blend_options(output_);
    if (!output_.size) options.size = likely_size(source(), target(), warnings);
    options.min_confidence = 0; // unlikely pairs were removed before
    options.progress = [&bar](double done) {
      constexpr std::size_t steps = 100;
      bar.show(std::size_t(done * steps), steps);
      return true;
    };
    const IO::Page_models models({source().model_pointer(), target().model_pointer()},
                                 output_.is_page() ? IO::largest_blend_page_triangles
                                                   : std::numeric_limits<std::size_t>::max());
    if (models.are_simplified())
      warnings.push_back("the page shows the shapes with fewer triangles, so that browsers can play it; files do not");
    const Shape_blend blend(source().graph, *models[0], target().graph, *models[1], pairs, options);
    read_looks();
    const IO::Blend_appearance appearance{source().appearance, target().appearance};
    const bool has_materials = !appearance.source.empty() || !appearance.target.empty();
    append(warnings, pairs.warnings);
    append(warnings, unlikely);
    warn_of_obstacles(blend, source(), target(), warnings);
    const auto write_json = [&](std::ostream& out) {
      IO::write_blend_json(out, blend, source().graph, target().graph, inputs[0], inputs[1], output_.path,
                           output_.frames, warnings);
    };
    write_blend(output_, blend, pairs, output_.colours == "materials" || has_materials ? &appearance : nullptr,
                [&] { write_output(common.json, write_json); });
    if (output_.is_page()) write_page(blend, pairs, write_json);
    if (!common.prints_table()) return;
    if (common.verbose) {
      write_match_table(std::cout, pairs, source().graph, target().graph, true);
      std::cout << '\n';
      print_schedules(blend);
    }
    write_notes(std::cout, warnings, common.verbose);
  }

  Blend_output output_;
};

} // namespace

Blend_size likely_size(const Loaded_shape& source, const Loaded_shape& target, std::vector<std::string>& warnings)
{
  constexpr double most = 2; // larger ratios of heights mostly come from different units
  const double from = structure(source.graph).frame.height, to = structure(target.graph).frame.height;
  if (std::max(from, to) <= most * std::min(from, to)) return Blend_size::BLEND;
  warnings.push_back("one shape is " + short_number(std::max(from, to) / std::min(from, to)) +
                     " times as high as the other; both get height 1, but for --size blend, source or target");
  return Blend_size::SAME;
}

std::vector<std::string> remove_unlikely(Correspondence& correspondence, double least, const Loaded_shape& source,
                                         const Loaded_shape& target)
{
  std::vector<std::string> result;
  for (const Part_correspondence& pair : internal::remove_unlikely_pairs(correspondence, least))
    result.push_back("'" + structure(source.graph).parts[pair.source].name + "' and '" +
                     structure(target.graph).parts[pair.target].name + "' correspond with probability " +
                     short_number(pair.confidence) + " only: they come and go (--min-confidence)");
  return result;
}

void warn_of_obstacles(const Shape_blend& blend, const Loaded_shape& source, const Loaded_shape& target,
                       std::vector<std::string>& warnings)
{
  const std::vector<Blend_task>& tasks = blend.schedules()[0].tasks;
  const auto add_name = [](std::string& names, const Loaded_shape& shape, std::size_t part) {
    names += (names.empty() ? "'" : ", '") + structure(shape.graph).parts[part].name + "'";
  };
  for (const auto& [reason, why] :
       {std::pair(Blend_obstacle::TORN, "no outlines of cross-sections describe both"),
        std::pair(Blend_obstacle::UNLIKE, "their proportions, places or numbers differ too much, or they would come off what they touch")}) {
    std::string names, others;
    for (const Blend_task& task : tasks) {
      if (task.obstacle != reason) continue;
      if (task.source != Blend_task::no_part) add_name(names, source, task.source);
      if (task.target != Blend_task::no_part) add_name(others, target, task.target);
    }
    if (!names.empty()) warnings.push_back(names + " are exchanged for " + others + ": " + why);
  }
}

std::unique_ptr<Command> blend_command() { return std::make_unique<Blend_command>(); }

} // namespace CGAL::Shape_correspondence::cli
