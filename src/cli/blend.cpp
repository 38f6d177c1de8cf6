// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/load_shape.h"
#include "cli/match_options.h"
#include "cli/outputs.h"
#include "cli/progress_bar.h"
#include "cli/read_model.h"
#include "cli/text_table.h"
#include "cli/thread_limit.h"
#include "io/atomic_file.h"
#include "io/quoting.h"
#include "viewer/match_page.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <filesystem>
#include <iostream>
#include <sstream>

namespace CGAL::Shape_correspondence::cli {

namespace po = boost::program_options;

namespace {

const char* const help_text =
    R"(Usage: shape_correspondence blend SOURCE TARGET -o FOLDER|FILE.glb|FILE.html [options]

Makes in-between shapes of two segmented shapes of one kind, which may differ in topology: parts that correspond
morph into each other, split or merge, parts without counterpart shrink or grow, and what touches keeps touching.
The first frame is the source, the last one the target.

With -o FILE.glb, one file with an animation; with -o FILE.html, a web page that needs no network, with the match and the
blend, to play and to step through; else a new folder with a file a frame, frame_000 and so on, in which
a part is named s~t where source part s becomes t, s~ where s vanishes and ~t where t grows.

SOURCE and TARGET are model files (OBJ with o/g, PLY, STL, OFF, glTF/GLB, COLLADA, FBX, 3DS, DXF, AC3D; an object or
node is a part, unless it gathers loose pieces, see --parts), folders of part meshes (one file is one part, its stem the part's name), or structural graphs (.json) whose parts
name their meshes (key "mesh", a file's path relative to the graph).

With --match R.json the parts correspond as in a result of `match` for the same two shapes; options of the search are
then refused.

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
      "a file that ends in .glb, for an animation, or in .html, for a web page with the match and the blend, or a "
      "folder "
      "that is not there yet, for a file a frame");
  add("frames", number(output.frames)->value_name("N"), "frames at even times, the source and the target among them");
  add("format", po::value(&output.format)->value_name("FORMAT")->default_value(output.format),
      "of the files in the folder: obj (an object a part) or ply (binary, the part a property of every face)");
  add("match", po::value(&output.match)->value_name("R.json"),
      "the correspondence: a result that `match --json` wrote for these shapes; else it is searched for");
  add("json", po::value(&common.json)->value_name("FILE"),
      "write what happens when, and how well every frame holds together, as JSON; - is standard output");
  return result;
}

bool ends_with(const std::string& path, const std::string& ending)
{
  return path.size() > ending.size() && path.compare(path.size() - ending.size(), ending.size(), ending) == 0;
}

bool is_glb(const std::string& path) { return ends_with(path, ".glb"); }
bool is_page(const std::string& path) { return ends_with(path, ".html"); }
bool is_one_file(const std::string& path) { return is_glb(path) || is_page(path); }

/// \throw Usage_error if a folder is to have the name of a file that blend does not write
void check_is_no_other_file(const std::string& folder)
{
  const std::string ending = std::filesystem::path(folder).extension().string();
  for (const char* file : {".obj", ".ply", ".stl", ".off", ".gltf", ".dae", ".json", ".png", ".gif", ".mp4"})
    if (ending == file)
      throw Usage_error(
          "'" + folder + "' is named like a " + ending +
          " file; blend writes an animation, FILE.glb, a page, FILE.html, or a file a frame into a folder");
}

void check(const Blend_output& output)
{
  if (output.path.empty())
    throw Usage_error("say with -o where the frames go: a folder, or a file that ends in .glb or .html");
  check_at_least("frames", output.frames, 2);
  check_word("format", output.format, {"obj", "ply"});
  if (is_one_file(output.path)) return;
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

/// Reads the meshes that a graph names.
void complete_surfaces(const std::string& path, Loaded_shape& shape)
{
  if (!shape.model && is_json_file(path)) shape.model = IO::read_part_meshes(path, shape.graph);
  if (!shape.model)
    throw Invalid_input(path + ": it is a structural graph without surfaces, which a blend is made of; give the model "
                               "that it was built from, or name the parts' meshes in it (key \"mesh\")");
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
  else if (!is_page(output.path))
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
  std::cout << "\nThe first schedule is taken. Lengths are over the height, the worst of the shapes in between: by how "
               "much a contact\nis wider than at the ends, how far parts came apart before they were joined again, how "
               "far the shape is from its\nmirror image, how far its feet are off the ground.\n";
}

} // namespace

void run_blend(const std::vector<std::string>& arguments)
{
  Common_options common;
  Match_options match;
  Blend_output output;
  po::options_description options;
  const po::options_description searching = match_options(match);
  options.add(output_options(output, common))
      .add(searching)
      .add(pair_options(common))
      .add(model_options(common))
      .add(common_options(common));
  const Arguments parsed = parse(arguments, options, 2, 2);
  if (parsed.help) {
    std::cout << help_text << options;
    return;
  }
  Search_options search = search_options(match, parsed.values);
  if (!output.match.empty()) check_needs_no_search(searching, parsed.values);
  check(common);
  check(output);
  std::vector<std::string> inputs = parsed.inputs;
  inputs.push_back(output.match);
  check_outputs({common.json, is_one_file(output.path) ? output.path : ""}, inputs);
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
  const auto write_json = [&](std::ostream& out) {
    IO::write_blend_json(out, blend, source.graph, target.graph, paths[0], paths[1], output.path, output.frames,
                         warnings);
  };
  write_output(common.json, write_json);
  if (is_page(output.path)) {
    IO::Page page = IO::match_page({correspondence}, source.graph, target.graph, source.model_pointer(),
                                   target.model_pointer(), paths[0], paths[1], {});
    std::ostringstream json, glb;
    write_json(json);
    IO::write_blend_glb(glb, blend, correspondence, output.frames);
    page.json.push_back({"blend", json.str()});
    page.glb.push_back({"blend.glb", glb.str()});
    write_output(output.path, [&](std::ostream& out) { IO::write_page(out, page); });
  }
  if (common.prints_table()) {
    print_schedules(blend);
    for (const std::string& warning : warnings)
      std::cout << "warning: " << IO::quote_terminal(warning) << '\n';
  }
}

} // namespace CGAL::Shape_correspondence::cli
