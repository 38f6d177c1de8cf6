// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/load_shape.h"
#include "cli/match_options.h"
#include "cli/match_table.h"
#include "cli/outputs.h"
#include "cli/progress_bar.h"
#include "cli/read_model.h"
#include "cli/run_report.h"
#include "cli/text_table.h"
#include "cli/thread_limit.h"
#include "io/atomic_file.h"
#include "io/quoting.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <filesystem>
#include <iostream>

namespace CGAL::Shape_correspondence::cli {

namespace po = boost::program_options;

namespace {

const char* const help_text =
    R"(Usage: shape_correspondence blend SOURCE TARGET -o FOLDER|FILE.glb [options]

Makes the in-between shapes of two segmented shapes of one category, which may differ in topology. Corresponding parts
morph into each other, split or merge; parts without counterpart shrink or grow; parts in contact stay in contact. The
first frame is the source, the last one the target.

With -o FILE.glb, all frames are one animation. Otherwise FOLDER is made, with one file for each frame: frame_000 and so
on. A part of a frame is named s~t where source part s becomes t, s~ where s vanishes, and ~t where t grows.

SOURCE and TARGET are each one of
  - a model file: OBJ with o or g, PLY, STL, OFF, glTF/GLB, COLLADA, FBX, 3DS, DXF, AC3D. Its objects or nodes are the
    parts; an object of unrelated loose pieces is split into them (--parts);
  - a folder of part meshes: one file for each part, named after the part;
  - a structural graph (.json) whose parts name their meshes (key "mesh", a path relative to the graph file).

With --match R.json, the correspondence is read from a result of `match` for the same two shapes, and options of the
search are refused.

Examples: shape_correspondence blend chair.obj swivel_chair.obj -o blend.glb
          shape_correspondence blend chair.obj swivel_chair.obj -o frames --match chair_swivel.json --frames 9

)";

struct Blend_output
{
  std::string path;
  std::string format = "obj";
  std::string match; ///< a result file, or empty
  int frames = 25;
};

po::options_description output_options(Blend_output& output, Common_options& common)
{
  po::options_description result = option_group("Output");
  auto add = result.add_options();
  add("output,o", po::value(&output.path)->value_name("PATH"),
      "an animation, FILE.glb, or a new folder for one file per frame");
  add("frames", number(output.frames)->value_name("N"),
      "number of frames at equal time steps, including source and target");
  add("format", po::value(&output.format)->value_name("FORMAT")->default_value(output.format),
      "format of the frames in a folder: obj (one object per part) or ply (binary, with the part of each face)");
  add("match", po::value(&output.match)->value_name("R.json"),
      "read the correspondence from a result that `match --json` wrote for these shapes");
  add("json", po::value(&common.json)->value_name("FILE"),
      "write the schedule of the parts and the quality of every frame as JSON; - is standard output");
  return result;
}

bool is_glb(const std::string& path) { return path.size() > 4 && path.compare(path.size() - 4, 4, ".glb") == 0; }

/// \throw Usage_error if a folder is to have the name of a file that blend does not write
void check_is_no_other_file(const std::string& folder)
{
  const std::string ending = std::filesystem::path(folder).extension().string();
  for (const char* file : {".obj", ".ply", ".stl", ".off", ".gltf", ".dae", ".json", ".html", ".png", ".gif", ".mp4"})
    if (ending == file)
      throw Usage_error("'" + folder + "' is named like a " + ending +
                        " file; blend writes an animation, FILE.glb, or one file for each frame into a folder");
}

void check(const Blend_output& output)
{
  if (output.path.empty()) throw Usage_error("-o is missing: a folder for the frames, or an animation FILE.glb");
  check_at_least("frames", output.frames, 2);
  check_word("format", output.format, {"obj", "ply"});
  if (is_glb(output.path)) return;
  check_is_no_other_file(output.path);
  IO::check_new_folder(output.path);
}

/// \throw Usage_error if an option of the search is given along with a correspondence
void check_needs_no_search(const po::options_description& search, const po::variables_map& given)
{
  for (const auto& option : search.options())
    if (is_given(given, option->long_name()))
      throw Usage_error("--match says what corresponds; leave --" + option->long_name() + " out");
}

std::string frame_name(const Blend_output& output, int frame)
{
  const std::string number = std::to_string(frame);
  return "frame_" + std::string(number.size() < 3 ? 3 - number.size() : 0, '0') + number + '.' + output.format;
}

void write_frame(const std::string& folder, const Blend_output& output, const Shape_blend& blend, int frame)
{
  const Segmented_shape shape = blend(double(frame) / (output.frames - 1));
  IO::write_atomically(folder + '/' + frame_name(output, frame), [&](std::ostream& out) {
    if (output.format == "ply")
      IO::write_segmented_shape_ply(out, shape);
    else
      IO::write_segmented_shape_obj(out, shape);
  });
}

void write_frames(const std::string& folder, const Blend_output& output, const Shape_blend& blend)
{
  internal::for_each_index<CGAL::Parallel_if_available_tag>(
      std::size_t(output.frames), [&](std::size_t frame) { write_frame(folder, output, blend, int(frame)); });
}

void write_blend(const Blend_output& output, const Shape_blend& blend, const Correspondence& correspondence)
{
  if (is_glb(output.path))
    IO::write_atomically(output.path,
                         [&](std::ostream& out) { IO::write_blend_glb(out, blend, correspondence, output.frames); });
  else
    IO::write_folder_atomically(output.path, [&](const std::string& folder) { write_frames(folder, output, blend); });
}

Blend_options with_progress(Progress_bar& bar)
{
  Blend_options result;
  result.progress = [&bar](double done) {
    constexpr std::size_t steps = 100;
    bar.show(std::size_t(done * steps), steps);
    return true;
  };
  return result;
}

void print_schedules(const Shape_blend& blend)
{
  std::vector<std::vector<std::string>> rows{{"schedule", "gap", "apart", "asymmetry", "off the ground"}};
  for (const Blend_schedule& schedule : blend.schedules())
    rows.push_back({schedule.name, short_number(schedule.quality.gap), short_number(schedule.quality.apart),
                    short_number(schedule.quality.asymmetry), short_number(schedule.quality.ground)});
  write_table(std::cout, rows);
  std::cout
      << "\nThe first schedule is used. All values are the maximum over the in-between shapes, divided by the height:\n"
         "  gap             how much wider a contact is than in the source and the target\n"
         "  apart           how far connected parts were apart before they were moved together again\n"
         "  asymmetry       distance of the shape from its mirror image\n"
         "  off the ground  distance of the feet from the ground\n";
}

struct Variables
{
  Common_options common;
  Match_options match;
  Blend_output output;
};

po::options_description all_options(Variables& v)
{
  po::options_description result;
  result.add(output_options(v.output, v.common))
      .add(match_options(v.match))
      .add(pair_options(v.common))
      .add(model_options(v.common))
      .add(common_options(v.common));
  return result;
}

} // namespace

Command_help help_of_blend()
{
  static Variables unused;
  return {help_text, all_options(unused)};
}

void run_blend(const std::vector<std::string>& arguments)
{
  Variables variables;
  Common_options& common = variables.common;
  Match_options& match = variables.match;
  Blend_output& output = variables.output;
  const Arguments parsed = parse(arguments, all_options(variables), 2, 2);
  if (parsed.help) return write_help(std::cout, command_of("blend"));
  const Run_report report(common);
  refuse_abstraction_of_graphs(parsed);
  Search_options search = search_options(match, parsed.values);
  if (!output.match.empty()) check_needs_no_search(match_options(match), parsed.values);
  check(common);
  check(output);
  std::vector<std::string> inputs = parsed.inputs;
  inputs.push_back(output.match);
  check_outputs({common.json, is_glb(output.path) ? output.path : ""}, inputs);
  const Thread_limit limit(common.threads);
  const std::vector<std::string>& paths = parsed.inputs;
  const std::vector<std::string> warnings_of_up = find_up_of_pair(paths, common);
  std::vector<Loaded_shape> shapes = load_shapes(paths, common);
  for (std::size_t i : {0u, 1u})
    complete_surfaces(paths[i], shapes[i]);
  const Loaded_shape &source = shapes[0], &target = shapes[1];
  search.source_parts = chosen_parts(match.source_parts, source.graph, paths[0]);
  search.target_parts = chosen_parts(match.target_parts, target.graph, paths[1]);
  const Correspondence correspondence =
      output.match.empty()
          ? find_correspondence(source.graph, target.graph, search)
          : IO::correspondence_of(IO::read_correspondence_json(output.match), source.graph, target.graph, output.match);

  Progress_bar bar(common, "blend");
  const Shape_blend blend(source.graph, *source.model, target.graph, *target.model, correspondence, with_progress(bar));
  write_blend(output, blend, correspondence);
  std::vector<std::string> warnings = warnings_of(paths, shapes);
  warnings.insert(warnings.begin(), warnings_of_up.begin(), warnings_of_up.end());
  warnings.insert(warnings.end(), correspondence.warnings.begin(), correspondence.warnings.end());
  write_output(common.json, [&](std::ostream& out) {
    IO::write_blend_json(out, blend, source.graph, target.graph, paths[0], paths[1], output.path, output.frames,
                         warnings);
  });
  if (common.prints_table()) {
    if (common.verbose) {
      write_match_table(std::cout, correspondence, source.graph, target.graph);
      std::cout << '\n';
    }
    print_schedules(blend);
    for (const std::string& warning : warnings)
      std::cout << "warning: " << IO::quote_terminal(warning) << '\n';
  }
}

} // namespace CGAL::Shape_correspondence::cli
