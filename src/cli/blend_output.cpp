// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"
#include "base/limits.h"
#include "cli/blend.h"
#include "cli/run.h"
#include "cli/text.h"
#include "io/system/atomic_file.h"

#include <CGAL/Shape_correspondence/IO/write_blend.h>

#include <cctype>
#include <filesystem>

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

/// \throw Usage_error if the name of a folder looks like a file that blend does not write
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

namespace {

std::string frame_name(const Blend_output& output, int frame)
{
  const std::string number = std::to_string(frame);
  return "frame_" + std::string(number.size() < 3 ? 3 - number.size() : 0, '0') + number + '.' + output.format;
}

/// The shape at time t; if `solid`, its wrap, one closed surface.
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

} // namespace

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

} // namespace CGAL::Shape_correspondence::cli
