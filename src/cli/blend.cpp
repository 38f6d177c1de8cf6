// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"
#include "base/limits.h"
#include "cli/Command.h"
#include "cli/jobs.h"
#include "cli/run.h"
#include "io/system/atomic_file.h"
#include "matching/unlikely_pairs.h"
#include "viewer/pages.h"

#include <CGAL/Shape_correspondence/IO/write_blend.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>
#include <limits>
#include <sstream>

namespace CGAL::Shape_correspondence::cli {
namespace {

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
  append(result, mapped(Shape_blend::schedule_names(), schedule_word));
  return result;
}

std::string alternatives(const std::vector<std::string>& words)
{
  std::string result;
  for (std::size_t i = 0; i < words.size(); ++i)
    result += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + words[i];
  return result;
}

std::string ending_of(const std::string& path) { return std::filesystem::path(path).extension().string(); }

bool is_glb(const std::string& path) { return ending_of(path) == ".glb"; }

/// Refuses a name for a folder that looks like a file which `blend` does not write. \throw Usage_error
void check_is_no_other_file(const std::string& folder)
{
  const std::string ending = ending_of(folder);
  for (const char* file : {".obj", ".ply", ".stl", ".off", ".gltf", ".dae", ".json", ".png", ".gif", ".mp4"})
    if (ending == file)
      throw Usage_error(
          "'" + folder + "' is named like a " + ending +
          " file; blend writes an animation, FILE.glb, a web page, FILE.html, or one file for each frame into a "
          "folder");
}

/// The format of the file for a single shape; empty if none is written.
std::string file_format(const Blend_output& output)
{
  if (!output.is_one_shape() || output.schedule == "all") return "";
  const std::string ending = ending_of(output.path);
  return ending == ".ply" ? "ply" : ending == ".glb" ? "glb" : "obj";
}

std::string frame_name(const Blend_output& output, int frame)
{
  const std::string number = std::to_string(frame);
  return "frame_" + std::string(number.size() < 3 ? 3 - number.size() : 0, '0') + number + '.' + output.format;
}

/// The shape at time t; if `solid`, one closed surface around it (alpha wrapping).
Segmented_shape shape_at(const Shape_blend& blend, double t, bool solid)
{
  if (!solid) return blend(t);
  Segmented_shape result(blend(t).name(), blend(t).up());
  result.add_part("solid", blend.solid(t));
  return result;
}

void write_shape(const std::string& path, const std::string& format, const Shape_blend& blend,
                 const IO::Blend_appearance& appearance, double t, bool solid = false)
{
  IO::write_atomically(path, [&](std::ostream& out) {
    if (format == "glb")
      IO::write_blend_frame_glb(out, blend, appearance, t);
    else if (format == "ply")
      IO::write_segmented_shape_ply(out, shape_at(blend, t, solid));
    else
      IO::write_segmented_shape_obj(out, shape_at(blend, t, solid));
  });
}

void write_frames(const std::string& folder, const Blend_output& output, const Shape_blend& blend,
                  const IO::Blend_appearance& appearance)
{
  internal::for_each_index<CGAL::Parallel_if_available_tag>(std::size_t(output.frames), [&](std::size_t frame) {
    write_shape(folder + '/' + frame_name(output, int(frame)), output.format, blend, appearance,
                double(frame) / (output.frames - 1));
  });
}

/// Writes every blend to its own numbered folder or file, the best first.
void write_all(const std::string& folder, const Blend_output& output, const std::vector<Shape_blend>& blends,
               const IO::Blend_appearance& appearance)
{
  for (std::size_t i = 0; i < blends.size(); ++i) {
    const std::string path = folder + '/' + std::to_string(i + 1) + '_' + schedule_word(blends[i].schedules()[0].name);
    if (output.is_one_shape()) {
      write_shape(path + '.' + output.format, output.format, blends[i], appearance, output.at, output.solid);
      continue;
    }
    std::filesystem::create_directory(path);
    write_frames(path, output, blends[i], appearance);
  }
}

const char* const blend_help =
    R"(Usage: shape_correspondence blend SOURCE TARGET -o FOLDER|FILE.glb|FILE.html [options]

Makes the shapes in between two shapes of one category. The shapes may differ in topology. The first frame is the source,
the last one the target. All frames stand on the ground, in the axes of the source.

  - Parts that correspond morph: they move straight to the place of their counterpart and change their surface gradually.
  - Parts that correspond but differ too much, such as legs and a star base, are exchanged: new parts take the place of
    old ones in an instant.
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
    add("html", "FILE", &common.html, "the same as -o FILE.html").output();
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
    if (!common.html.empty()) {
      if (!output_.path.empty())
        throw Usage_error("--html FILE is the same as -o FILE.html: give one of them, and run blend again for the "
                          "other file");
      output_.path = common.html;
      if (!output_.is_page())
        throw Usage_error("--html writes a web page: its name '" + common.html + "' must end in .html");
    }
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

bool Blend_output::is_page() const { return ending_of(path) == ".html"; }

bool Blend_output::may_show_materials() const
{
  if (const std::string one = file_format(*this); !one.empty()) return one == "glb";
  return is_glb(path) || (!is_page() && format == "glb");
}

bool Blend_output::is_file() const { return is_glb(path) || is_page() || !file_format(*this).empty(); }

void add_output_options(Option_table::Group& add, Blend_output& output)
{
  add("output,o", "PATH", &output.path,
      "what to write: an animation, FILE.glb; a web page, FILE.html; or a new folder with one file for each frame");
  add("frames", "N", &output.frames, "number of frames at equal time steps, including source and target")
      .between(2, internal::most_frames);
  add("format", "FORMAT", &output.format,
      "format of the frames in a folder: obj (one object per part), ply (binary, with the part of each face) or glb "
      "(with materials and textures)")
      .words({"obj", "ply", "glb"})
      .rare();
  add("schedule", "NAME", &output.schedule,
      "order of the tasks: " + alternatives(schedule_words()) +
          "; best takes the one in which shapes hold together best, all writes a folder for each one whose frames "
          "differ from those of better ones")
      .words(schedule_words());
  add("at", "T", &output.at, "write only the shape at time T; 0 is the source, 1 the target. Default: the whole blend")
      .between(0, 1)
      .without_default();
  add("solid", &output.solid,
      "with --at: wrap the shape into one closed surface, for printing and Boolean operations (.obj or .ply)");
  add("size", "SIZE",
      choice<std::optional<Blend_size>>(output.size, {{"auto", std::nullopt},
                                                      {"blend", Blend_size::BLEND},
                                                      {"source", Blend_size::SOURCE},
                                                      {"target", Blend_size::TARGET},
                                                      {"same", Blend_size::SAME}}),
      "size of the frames: blend (from the source's to the target's), source, target, same (height 1), or auto (blend; "
      "same if one shape is more than twice as high as the other, which most often means other units)")
      .in_python();
  add("colours", "COLOURS", &output.colours,
      "colours of a .glb animation: materials (those of the models, with textures), match (one for corresponding "
      "parts) or auto (materials if a model has them)")
      .words({"auto", "materials", "match"})
      .rare();
}

void check_output(const Blend_output& output)
{
  if (output.path.empty())
    throw Usage_error("-o is missing: a folder for the frames, an animation FILE.glb, or a web page FILE.html");
  if (output.solid && !output.is_one_shape()) throw Usage_error("--solid makes one shape: --at T says which");
  const std::string ending = ending_of(output.path);
  if (output.solid && (output.format == "glb" || file_format(output) == "glb"))
    throw Usage_error("--solid writes a surface without materials: .obj or .ply");
  if (!file_format(output).empty()) {
    if (ending != ".obj" && ending != ".ply" && ending != ".glb")
      throw Usage_error("with --at, one shape is written: -o must name a file that ends in .obj, .ply or .glb");
    return;
  }
  if ((is_glb(output.path) || output.is_page())) {
    if (output.schedule == "all") throw Usage_error("--schedule all makes several blends: -o must name a folder");
    return;
  }
  check_is_no_other_file(output.path);
  IO::check_new_folder(output.path);
}

Blend_options blend_options(const Blend_output& output)
{
  Blend_options result;
  result.size = output.size.value_or(Blend_size::BLEND);
  for (const std::string& name : Shape_blend::schedule_names())
    if (schedule_word(name) == output.schedule) result.schedule = name;
  return result;
}

void write_blend(const Blend_output& output, const Shape_blend& blend, const Correspondence& correspondence,
                 const IO::Blend_appearance* appearance, const std::function<void()>& finish)
{
  const IO::Blend_appearance none, &looks = appearance ? *appearance : none;
  if (!output.is_file())
    return IO::write_folder_atomically(output.path, [&](const std::string& folder) {
      if (output.schedule == "all")
        write_all(folder, output, blend.different_blends(), looks);
      else
        write_frames(folder, output, blend, looks);
      finish();
    });
  if (const std::string format = file_format(output); !format.empty()) {
    write_shape(output.path, format, blend, looks, output.at, output.solid);
    output_is_whole(output.path);
  } else if (is_glb(output.path)) {
    write_output(output.path, [&](std::ostream& out) {
      if (appearance)
        IO::write_blend_glb(out, blend, *appearance, output.frames);
      else
        IO::write_blend_glb(out, blend, correspondence, output.frames);
    });
  }
  finish();
}

Blend_size likely_size(const Loaded_shape& source, const Loaded_shape& target, std::vector<std::string>& warnings)
{
  constexpr double most = 2; // limit for the ratio of heights; larger ones mostly come from different units
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
       {std::pair(Blend_obstacle::TORN, "their surfaces are too different"),
        std::pair(Blend_obstacle::UNLIKE,
                  "their proportions, places or numbers differ too much, or they would come off what they touch")}) {
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
