// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Common_options.h"

#include "cli/run.h"
#include "io/system/input_file.h"

#include <algorithm>
#include <sstream>

namespace CGAL::Shape_correspondence::cli {

namespace {

constexpr int most_threads = 4096; // limit: each thread needs its own memory
// Limits for samples of a curve and of a sheet: more than any shape needs, at little memory
constexpr int most_curve_points = 1000;
constexpr int most_sheet_points = 200; // number along each side

const std::vector<std::string> axes{"x", "y", "z", "-x", "-y", "-z", "+x", "+y", "+z", "auto"};

const std::vector<std::pair<const char*, Abstraction_kind>> abstraction_kinds{
    {"auto", Abstraction_kind::AUTOMATIC}, {"curve", Abstraction_kind::CURVE}, {"sheet", Abstraction_kind::SHEET}};

const std::vector<std::pair<const char*, Part_splitting>> part_splittings{{"auto", Part_splitting::AUTO},
                                                                          {"file", Part_splitting::FILE},
                                                                          {"components", Part_splitting::COMPONENTS},
                                                                          {"segments", Part_splitting::SEGMENTS}};

/// The field of --part-kind, of the form PART=KIND.
Text_field part_kind(std::map<std::string, Abstraction_kind>& kinds)
{
  const auto set = [&kinds](const std::string& label, const std::string& text) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos || equals == 0)
      throw Usage_error(label + " takes the name of a part, = and its kind, not '" + text + "'");
    Abstraction_kind kind{};
    choice(kind, abstraction_kinds).set(label, text.substr(equals + 1));
    kinds.insert({text.substr(0, equals), kind});
  };
  return {{}, set, {}, /* is_repeated = */ true};
}

/// The field of a comma-separated list of kinds of symmetry.
Text_field symmetry_kinds(Symmetry_options& options)
{
  const std::vector<std::pair<std::string, bool*>> kinds{
      {"reflection", &options.reflection}, {"rotation", &options.rotation}, {"translation", &options.translation}};
  Text_field result;
  result.get = [kinds] {
    std::string text;
    for (const auto& [word, is_wanted] : kinds)
      if (*is_wanted) text += (text.empty() ? "" : ",") + word;
    return text;
  };
  result.known = {"reflection", "rotation", "translation"};
  result.set = [kinds, known = result.known](const std::string& label, const std::string& text) {
    const std::vector<std::string> words = words_of(text);
    for (const std::string& word : words)
      check_word(label, word, known);
    for (const auto& [word, is_wanted] : kinds)
      *is_wanted = std::find(words.begin(), words.end(), word) != words.end();
  };
  return result;
}

Text_field abstraction_method(Abstraction_options& options)
{
  return word_field(
      {"flow", "fitted", "boxes"}, [] { return "fitted"; },
      [&options](const std::string& word) {
        if (word == "flow") options.abstractor = Mean_curvature_abstraction();
        if (word == "boxes") options.abstractor = Bounding_box_abstraction();
      });
}

void add_structure_options(Option_table& table, Common_options& options)
{
  Option_table::Group add = table.rare_group("Options on structural graphs");
  Symmetry_options& symmetry = options.structure.symmetry;
  add(
      "no-symmetry", [&symmetry] { symmetry.enabled = false; }, "make every part a group of its own");
  add("symmetries", "KINDS", symmetry_kinds(symmetry), "kinds of symmetry groups to detect");
  add("symmetry-tolerance", "T", &symmetry.tolerance,
      "largest distance of a part from its image, as a fraction of the diagonal of the part")
      .between(0, 0.5)
      .in_python();
  add("contact-tolerance", "T", &options.structure.contacts.tolerance,
      "largest gap between parts in contact, as a fraction of the diagonal of the shape")
      .between(0, 0.5)
      .in_python();
  add("cache", "FOLDER", &options.cache,
      "keep structural graphs, and the parts found in models, in this folder, and reuse them when model and options "
      "are the same")
      .in_python();
}

void add_abstraction_options(Option_table& table, Abstraction_options& abstraction)
{
  Option_table::Group add = table.rare_group(abstraction_group);
  add(abstraction_option, "METHOD", abstraction_method(abstraction),
      "method of part abstraction: fitted (sheets on the medial axis, curves by mean curvature flow, axes of round "
      "parts and blocks), flow (mean curvature flow alone, as in the paper) or boxes (axes of bounding boxes: fast and "
      "rough)")
      .in_python();
  add("kind", "KIND", choice(abstraction.kind, abstraction_kinds),
      "abstract parts by curve, sheet, or auto (what fits each part)")
      .in_python();
  add("part-kind", "PART=KIND", part_kind(abstraction.part_kinds), "the same for one part; can be repeated")
      .in_python("part_kinds");
  add("edge-length", "X", &abstraction.edge_length, "edge length of the remeshed part, as a fraction of its diagonal")
      .more_than(0)
      .in_python();
  add("triangles", "N", &abstraction.triangles,
      "approximate maximum of triangles of the remeshed part; edges are longer where needed")
      .at_least(100)
      .in_python();
  add("stop-volume", "X", &abstraction.stop_volume,
      "fraction of the volume at which the flow is stopped to detect sheets and hollow parts")
      .more_than(0)
      .in_python();
  add("max-iterations", "N", &abstraction.maximum_iterations,
      "maximum of iterations of the flow; a part that needs more is represented by its bounding box")
      .at_least(1)
      .in_python("maximum_iterations");
  add("time-limit", "SECONDS", &abstraction.time_limit,
      "time limit for one part; a part that needs more is represented by its bounding box, with a note. Default: no "
      "limit, so that results do not depend on the speed of the machine")
      .more_than(0)
      .without_default()
      .in_python();
  add("curve-points", "N", &abstraction.curve_points, "control points of a curve, and as many more for each full turn")
      .between(2, most_curve_points)
      .in_python();
  add("sheet-points", "N", &abstraction.sheet_points, "control points along each side of a sheet")
      .between(2, most_sheet_points)
      .in_python();
}

} // namespace

Common_options Common_options::of_input(std::size_t index) const
{
  Common_options result = *this;
  if (index >= of_pair.size()) return result;
  if (!of_pair[index].up.empty()) result.up = of_pair[index].up;
  if (!of_pair[index].parts_from.empty()) result.parts_from = of_pair[index].parts_from;
  result.features = of_pair[index].features;
  return result;
}

bool Common_options::has_face_labels() const
{
  const auto endings = {".seg", ".txt", ".label", ".labels", ".lab", ".csv", ".eseg", ".sseg"};
  return std::find(endings.begin(), endings.end(), IO::lower_extension(parts_from)) != endings.end();
}

IO::Reading_options Common_options::reading_options() const
{
  IO::Reading_options result = reading;
  if (has_face_labels()) result.face_labels = parts_from;
  return result;
}

Point Common_options::up_vector() const
{
  if (up.empty() || finds_up()) return Point::UnitY();
  return (up[0] == '-' ? -1 : 1) * Point::Unit(up.back() - 'x');
}

Text_field output_by_ending(const std::vector<std::pair<std::string, std::string*>>& files)
{
  const auto set = [files](const std::string& label, const std::string& path) {
    const std::string ending = path == "-" ? ".json" : IO::lower_extension(path);
    for (const auto& [wanted, file] : files) {
      if (ending != wanted) continue;
      if (!file->empty() && *file != path)
        throw Usage_error(label + ": there are two files " + wanted + ", " + *file + " and " + path);
      *file = path;
      return;
    }
    const auto ending_of = [](const auto& known) { return known.first; };
    throw Usage_error(label + ": '" + path +
                      "' is named like no file that this command writes: " + listed(mapped(files, ending_of)));
  };
  return {{}, set, {}, /* is_repeated = */ true};
}

std::vector<std::string> words_of(const std::string& list)
{
  std::vector<std::string> words;
  std::istringstream in(list);
  for (std::string word; std::getline(in, word, ',');)
    words.push_back(word);
  return words;
}

void add_common_options(Option_table& table, Common_options& options)
{
  Option_table::Group add = table.rare_group("Options of all commands");
  add("threads", "N", &options.threads,
      "number of threads; default: all of the machine. The result does not depend on it")
      .between(1, most_threads)
      .without_default()
      .in_python();
  add("quiet,q", &options.quiet, "print errors only").usual();
  add("verbose,v", &options.verbose,
      "print more: all notes, time and memory; match also prints the energy of every symmetry group, blend the "
      "correspondence")
      .usual();
  add("progress", "WHEN", &options.progress,
      "show a progress bar on standard error: auto (if it is a terminal), always, never")
      .words({"auto", "always", "never"});
  add("help,h", &options.help, "print what the command does, and its usual options").usual();
  add("help-all", &options.help_all, "print all options").usual();
}

void add_reading_options(Option_table& table, Common_options& options)
{
  Option_table::Group add = table.rare_group(reading_group);
  add("up", "AXIS", &options.up,
      "upright axis of the model: x, y, z, -x, -y, -z, or auto (the axis along which the model stands most stably). "
      "Default: the axis that the file names (glTF, COLLADA, FBX, URDF, 3MF, graphs), or y for a folder of part "
      "meshes. For other files it is y, unless the model clearly stands along another axis, or its parts are more "
      "similar to labelled parts with another axis up; a note says so")
      .words(axes)
      .in_python()
      .usual();
  add("parts", "MODE", choice(options.parts, part_splittings),
      "how parts are made of a model file: file (its objects), components (its loose pieces), segments (loose pieces "
      "divided where they are concave) or auto (its objects; objects of unrelated loose pieces are divided by the "
      "shape of the pieces). `shape_correspondence parts MODEL` shows the result. Files in a folder are always parts "
      "as they are")
      .in_python()
      .usual();
  add(
      "segment", [&options] { options.parts = Part_splitting::SEGMENTS; }, "the same as --parts segments");
  add("allow-outside-files", &options.reading.allow_outside_files,
      "read also files that a model or a graph names outside its own folder: buffers, materials, textures, meshes of "
      "parts")
      .in_python();
}

void add_model_options(Option_table& table, Common_options& options)
{
  add_reading_options(table, options);
  add_structure_options(table, options);
  add_abstraction_options(table, options.structure.abstraction);
}

void add_pair_options(Option_table& table, Common_options& options)
{
  Option_table::Group add = table.rare_group("Options on one of two models");
  Common_options::Of_input &source = options.of_pair[0], &target = options.of_pair[1];
  add("source-up", "AXIS", &source.up, "upright axis of the source, as --up").words(axes);
  add("target-up", "AXIS", &target.up, "the same for the target").words(axes);
  add("source-parts-from", "FILE", &source.parts_from,
      "read the parts of the source from a list of its pieces and their parts, as `graph --parts-json` writes it, or "
      "of labels of its faces");
  add("target-parts-from", "FILE", &target.parts_from, "the same for the target");
}

} // namespace CGAL::Shape_correspondence::cli
