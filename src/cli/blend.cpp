// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"
#include "cli/blend_warnings.h"
#include "cli/choose_parts.h"
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
#include "viewer/match_page.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>
#include <sstream>

namespace CGAL::Shape_correspondence::cli {

namespace po = boost::program_options;

namespace {

const char* const help_text =
    R"(Usage: shape_correspondence blend SOURCE TARGET -o FOLDER|FILE.glb|FILE.html [options]

Makes the in-between shapes of two segmented shapes of one category, which may differ in topology. Corresponding parts
morph into each other, split or merge; parts without counterpart shrink or grow; parts in contact stay in contact. The
first frame is the source, the last one the target.

With -o FILE.glb, all frames are one animation; with -o FILE.html, a web page that needs no network shows the match and
plays the blend; with --at T, one shape is written, FILE.obj or FILE.ply. Otherwise FOLDER is made, with one file for
each frame: frame_000 and so on. A part of a frame is named s~t where source part s becomes t, s~ where s vanishes, and
~t where t grows.

SOURCE and TARGET are each one of
  - a model file: OBJ with o or g, PLY, STL, OFF, glTF/GLB, COLLADA, FBX, 3DS, DXF, AC3D. Its objects or nodes are the
    parts; an object of unrelated loose pieces is split into them (--parts);
  - a folder of part meshes: one file for each part, named after the part;
  - a structural graph (.json) whose parts name their meshes (key "mesh", a path relative to the graph file).

With --match R.json, the correspondence is read from a result of `match` for the same two shapes, and options of the
search are refused.

Parts that correspond with a probability below --min-confidence are not believed: they shrink and grow. What happens
when is a schedule: --schedule takes one by its name, the best one, or all that make different shapes in between, each
into a folder of its own (with --at, a file), the best one first.

Examples: shape_correspondence blend chair.obj swivel_chair.obj -o blend.glb
          shape_correspondence blend chair.obj swivel_chair.obj -o frames --match chair_swivel.json --frames 9
          shape_correspondence blend chair.obj swivel_chair.obj -o between --schedule all --at 0.5 --size same

)";

struct Blend_output
{
  std::string path;
  std::string format = "obj";
  std::string match; ///< a result file, or empty
  std::string schedule = "best";
  std::string size = "blend";
  int frames = 25;
  double at = whole_blend;

  static constexpr double whole_blend = -1;
  bool is_one_shape() const { return at != whole_blend; }
};

/// A schedule's name as it is written on the command line.
std::string schedule_word(const std::string& name)
{
  std::string result;
  for (char c : name)
    if (std::isalpha(static_cast<unsigned char>(c)))
      result += c;
    else if (!result.empty() && result.back() != '-')
      result += '-';
  return result;
}

std::vector<std::string> schedule_words()
{
  std::vector<std::string> result = {"best", "all"};
  for (const std::string& name : Shape_blend::schedule_names())
    result.push_back(schedule_word(name));
  return result;
}

std::string listed(const std::vector<std::string>& words)
{
  std::string result;
  for (std::size_t i = 0; i < words.size(); ++i)
    result += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + words[i];
  return result;
}

po::options_description output_options(Blend_output& output, Common_options& common)
{
  po::options_description result = option_group("Output");
  auto add = result.add_options();
  add("output,o", po::value(&output.path)->value_name("PATH"),
      "an animation, FILE.glb, a web page, FILE.html, or a new folder for one file per frame");
  add("frames", number(output.frames)->value_name("N"),
      "number of frames at equal time steps, including source and target");
  add("format", po::value(&output.format)->value_name("FORMAT")->default_value(output.format),
      "format of the frames in a folder: obj (one object per part) or ply (binary, with the part of each face)");
  add("match", po::value(&output.match)->value_name("R.json"),
      "read the correspondence from a result that `match --json` wrote for these shapes");
  add("schedule", po::value(&output.schedule)->value_name("NAME")->default_value(output.schedule),
      ("order of the tasks: " + listed(schedule_words()) +
       "; best takes the one in which shapes hold together best, all makes a folder for each one that differs from "
       "better ones")
          .c_str());
  add("at", number(output.at)->value_name("T")->default_value(output.at, "the whole blend"),
      "make one shape only, that at time T between 0, the source, and 1, the target");
  add("size", po::value(&output.size)->value_name("SIZE")->default_value(output.size),
      "size of the frames: blend (from the source's to the target's), source, target, or same (height 1)");
  add("json", po::value(&common.json)->value_name("FILE"),
      "write the schedule of the parts and the quality of every frame as JSON; - is standard output");
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
          " file; blend writes an animation, FILE.glb, a web page, FILE.html, or one file for each frame into a "
          "folder");
}

/// The format of the one shape that is written to a file, or empty if it is not.
std::string file_format(const Blend_output& output)
{
  if (!output.is_one_shape() || output.schedule == "all") return "";
  return std::filesystem::path(output.path).extension() == ".ply" ? "ply" : "obj";
}

void check_path(const Blend_output& output)
{
  if (output.path.empty())
    throw Usage_error("-o is missing: a folder for the frames, an animation FILE.glb, or a web page FILE.html");
  const std::string ending = std::filesystem::path(output.path).extension().string();
  if (!file_format(output).empty()) {
    if (ending != ".obj" && ending != ".ply")
      throw Usage_error("with --at, one shape is written: -o must name a file that ends in .obj or .ply");
    return;
  }
  if (is_one_file(output.path)) {
    if (output.schedule == "all") throw Usage_error("--schedule all makes several blends: -o must name a folder");
    return;
  }
  check_is_no_other_file(output.path);
  IO::check_new_folder(output.path);
}

void check(const Blend_output& output)
{
  check_at_least("frames", output.frames, 2);
  check_word("format", output.format, {"obj", "ply"});
  check_word("size", output.size, {"blend", "source", "target", "same"});
  check_word("schedule", output.schedule, schedule_words());
  if (output.is_one_shape() && !(output.at >= 0 && output.at <= 1)) throw Usage_error("--at must be between 0 and 1");
  check_path(output);
}

Blend_options blend_options(const Blend_output& output)
{
  Blend_options result;
  result.size = output.size == "source"   ? Blend_size::SOURCE
                : output.size == "target" ? Blend_size::TARGET
                : output.size == "same"   ? Blend_size::SAME
                                          : Blend_size::BLEND;
  result.rank_all = output.schedule == "all";
  for (const std::string& name : Shape_blend::schedule_names())
    if (schedule_word(name) == output.schedule) result.schedule = name;
  return result;
}

/// \throw Usage_error if an option of the search is given along with a correspondence
void check_needs_no_search(const po::options_description& search, const po::variables_map& given)
{
  for (const auto& option : search.options())
    if (is_given(given, option->long_name()) && option->long_name() != "min-confidence")
      throw Usage_error("--match says what corresponds; leave --" + option->long_name() + " out");
}

std::string frame_name(const Blend_output& output, int frame)
{
  const std::string number = std::to_string(frame);
  return "frame_" + std::string(number.size() < 3 ? 3 - number.size() : 0, '0') + number + '.' + output.format;
}

void write_shape(const std::string& path, const std::string& format, const Segmented_shape& shape)
{
  IO::write_atomically(path, [&](std::ostream& out) {
    if (format == "ply")
      IO::write_segmented_shape_ply(out, shape);
    else
      IO::write_segmented_shape_obj(out, shape);
  });
}

void write_frames(const std::string& folder, const Blend_output& output, const Shape_blend& blend)
{
  internal::for_each_index<CGAL::Parallel_if_available_tag>(std::size_t(output.frames), [&](std::size_t frame) {
    write_shape(folder + '/' + frame_name(output, int(frame)), output.format,
                blend(double(frame) / (output.frames - 1)));
  });
}

/// A folder, or a file, of every one of some blends, numbered, the best first.
void write_all(const std::string& folder, const Blend_output& output, const std::vector<Shape_blend>& blends)
{
  for (std::size_t i = 0; i < blends.size(); ++i) {
    const std::string path = folder + '/' + std::to_string(i + 1) + '_' + schedule_word(blends[i].schedules()[0].name);
    if (output.is_one_shape()) {
      write_shape(path + '.' + output.format, output.format, blends[i](output.at));
      continue;
    }
    std::filesystem::create_directory(path);
    write_frames(path, output, blends[i]);
  }
}

void write_blend(const Blend_output& output, const Shape_blend& blend, const Correspondence& correspondence)
{
  if (const std::string format = file_format(output); !format.empty())
    write_shape(output.path, format, blend(output.at));
  else if (is_glb(output.path))
    IO::write_atomically(output.path,
                         [&](std::ostream& out) { IO::write_blend_glb(out, blend, correspondence, output.frames); });
  else if (!is_page(output.path))
    IO::write_folder_atomically(output.path, [&](const std::string& folder) {
      if (output.schedule == "all")
        write_all(folder, output, blend.different_blends());
      else
        write_frames(folder, output, blend);
    });
}

/// Leaves out pairs that are less probable than `least`, and says which.
std::vector<std::string> remove_unlikely(Correspondence& correspondence, double least, const Loaded_shape& source,
                                         const Loaded_shape& target)
{
  std::vector<std::string> result;
  const auto is_unlikely = [&](const Part_correspondence& pair) {
    if (!(pair.confidence < least)) return false;
    result.push_back("'" + structure(source.graph).parts[pair.source].name + "' and '" +
                     structure(target.graph).parts[pair.target].name + "' correspond with probability " +
                     short_number(pair.confidence) + " only: they shrink and grow (--min-confidence)");
    return true;
  };
  std::vector<Part_correspondence>& pairs = correspondence.pairs;
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), is_unlikely), pairs.end());
  return result;
}

Blend_options with_progress(Blend_options result, Progress_bar& bar)
{
  result.progress = [&bar](double done) {
    constexpr std::size_t steps = 100;
    bar.show(std::size_t(done * steps), steps);
    return true;
  };
  return result;
}

void print_schedules(const Shape_blend& blend)
{
  std::vector<std::vector<std::string>> rows{
      {"schedule", "gap", "apart", "asymmetry", "ground", "thinning", "area", "volume", "torn", "overlap", "wobble"}};
  for (const Blend_schedule& schedule : blend.schedules()) {
    const Blend_quality& quality = schedule.quality;
    rows.emplace_back();
    rows.back().push_back(schedule.name);
    for (double value : {quality.gap, quality.apart, quality.asymmetry, quality.ground, quality.thinning, quality.area,
                         quality.volume, quality.torn, quality.overlap, quality.wobble})
      rows.back().push_back(short_number(value));
  }
  write_table(std::cout, rows);
  std::cout << "\nThe first schedule is used. All values are the maximum over the in-between shapes; lengths are "
               "divided by the "
               "height:\n"
               "  gap        how much wider a contact is than in the source and the target\n"
               "  apart      how far connected parts were apart before they were moved together again\n"
               "  asymmetry  distance of the shape from its mirror image\n"
               "  ground     distance of the feet from the ground\n"
               "  thinning   share by which a part is thinner than in the source and the target\n"
               "  area       share by which the surface is larger\n"
               "  volume     share by which the volume is larger\n"
               "  torn       share of the surface that is torn or folded\n"
               "  overlap    share of the surface that lies inside other parts\n"
               "  wobble     how much farther a part that is the same in both shapes moves than its neighbours\n";
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
  v.match.search.min_confidence = Blend_options().min_confidence;
  result.add(output_options(v.output, v.common))
      .add(match_options(v.match))
      .add(pair_options(v.common))
      .add(model_options(v.common))
      .add(common_options(v.common));
  return result;
}

} // namespace

void warn_of_sizes(Blend_size size, const Loaded_shape& source, const Loaded_shape& target,
                   std::vector<std::string>& warnings)
{
  constexpr double most = 5; // up to about this the one is seen beside the other
  const double from = structure(source.graph).frame.height, to = structure(target.graph).frame.height;
  if (size == Blend_size::BLEND && std::max(from, to) > most * std::min(from, to))
    warnings.push_back("one shape is " + short_number(std::max(from, to) / std::min(from, to)) +
                       " times as high as the other; --size same, source or target makes them alike");
}

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
  search.min_confidence = 0; // what is less probable is left out here, and told
  if (!output.match.empty()) check_needs_no_search(match_options(match), parsed.values);
  check(common);
  check(output);
  std::vector<std::string> inputs = parsed.inputs;
  inputs.push_back(output.match);
  const bool is_file = is_one_file(output.path) || !file_format(output).empty();
  check_outputs({common.json, is_file ? output.path : ""}, inputs);
  const Thread_limit limit(common.threads);
  const std::vector<std::string>& paths = parsed.inputs;
  const std::vector<std::string> warnings_of_up = find_up_of_pair(paths, common);
  std::vector<Loaded_shape> shapes = load_shapes(paths, common);
  for (std::size_t i : {0u, 1u})
    complete_surfaces(paths[i], shapes[i]);
  const Loaded_shape &source = shapes[0], &target = shapes[1];
  choose_parts(match, {source.graph, paths[0]}, {target.graph, paths[1]}, search);
  Correspondence correspondence =
      output.match.empty()
          ? find_correspondence(source.graph, target.graph, search)
          : IO::correspondence_of(IO::read_correspondence_json(output.match), source.graph, target.graph, output.match);

  const std::vector<std::string> unlikely =
      remove_unlikely(correspondence, match.search.min_confidence, source, target);

  Progress_bar bar(common, "blend");
  const Shape_blend blend(source.graph, *source.model, target.graph, *target.model, correspondence,
                          with_progress(blend_options(output), bar));
  write_blend(output, blend, correspondence);
  std::vector<std::string> warnings = warnings_of(paths, shapes);
  warnings.insert(warnings.begin(), warnings_of_up.begin(), warnings_of_up.end());
  warnings.insert(warnings.end(), correspondence.warnings.begin(), correspondence.warnings.end());
  warnings.insert(warnings.end(), unlikely.begin(), unlikely.end());
  warn_of_sizes(blend_options(output).size, source, target, warnings);
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
