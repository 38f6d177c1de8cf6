// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/command_line.h"
#include "cli/text_table.h"

#include <utility>

namespace CGAL::Shape_correspondence::cli {

namespace po = boost::program_options;

namespace {

// Names that a user is not to write
constexpr const char* inputs_key = "INPUT";

Abstraction_kind parse_kind(const std::string& option, const std::string& word)
{
  check_word(option, word, {"auto", "curve", "sheet"});
  return word == "curve"   ? Abstraction_kind::CURVE
         : word == "sheet" ? Abstraction_kind::SHEET
                           : Abstraction_kind::AUTOMATIC;
}

std::pair<std::string, Abstraction_kind> parse_part_kind(const std::string& word)
{
  const std::size_t equals = word.rfind('=');
  if (equals == std::string::npos || equals == 0)
    throw Usage_error("--part-kind takes the name of a part, = and its kind, not '" + word + "'");
  return {word.substr(0, equals), parse_kind("part-kind", word.substr(equals + 1))};
}

} // namespace

po::options_description option_group(const std::string& title)
{
  constexpr unsigned width = 100, least_description = 68;
  return po::options_description(title, width, least_description);
}

po::typed_value<double>* number(double& variable)
{
  return po::value(&variable)->default_value(variable, short_number(variable));
}

po::typed_value<int>* number(int& variable) { return po::value(&variable)->default_value(variable); }

po::typed_value<std::size_t>* number(std::size_t& variable) { return po::value(&variable)->default_value(variable); }

po::options_description common_options(Common_options& options)
{
  po::options_description result = option_group("Options of all commands");
  auto add = result.add_options();
  add("threads", po::value(&options.threads)->value_name("N")->notifier([](int n) { check_at_least("threads", n, 1); }),
      "threads to use; default: all of the machine. The result is the same for any number");
  add("seed", po::value(&options.seed)->value_name("N"),
      "seed of random choices: those of the intervals of evaluate. Every result is reproducible");
  add("quiet", po::bool_switch(&options.quiet), "print nothing but errors");
  add("progress", po::value(&options.progress)->value_name("WHEN")->default_value(options.progress),
      "a progress bar on standard error: auto (when it is a terminal), always, never");
  add("help,h", "this text");
  return result;
}

po::options_description model_options(Common_options& options)
{
  Abstraction_options& abstraction = options.abstraction;
  po::options_description result = option_group("Options on models");
  auto add = result.add_options();
  add("up", po::value(&options.up)->value_name("AXIS"),
      "the upright axis of model files: x, y, z, or auto, the one along which the model stands best. Default: what the "
      "file says (glTF, COLLADA, a graph), y for a folder of part meshes, and else y unless the model clearly stands "
      "along another axis, which a warning then says");
  add("parts", po::value(&options.parts)->value_name("MODE")->default_value(options.parts),
      "what the parts of a model file are: file, its objects (groups, nodes); components, its loose pieces; segments, "
      "these divided by thickness; or auto, the objects, but for those of loose pieces that do not belong together, "
      "which are split. `shape_correspondence parts MODEL` shows it. The files of a folder are parts as they are");
  add("no-symmetry", po::bool_switch(&options.no_symmetry), "take every part as a group of its own");
  add("symmetries", po::value(&options.symmetries)->value_name("KINDS")->default_value(options.symmetries),
      "the kinds of symmetry groups that are looked for");
  add("symmetry-tolerance", number(options.symmetry_tolerance)->value_name("T"),
      "how far a part may be from its image, over the part's diagonal");
  add("contact-tolerance", number(options.contact_tolerance)->value_name("T"),
      "the widest gap between parts in contact, over the shape's diagonal");
  add("cache", po::value(&options.cache)->value_name("FOLDER"),
      "keep structural graphs in this folder, and take them from there when the model and the options are the same");
  add("segment", po::bool_switch()->notifier([&](bool is_set) {
    if (is_set) options.parts = "segments";
  }),
      "the same as --parts segments");
  add("abstraction", po::value<std::string>()->value_name("METHOD")->default_value("fitted")->notifier([&](auto& m) {
    check_word("abstraction", m, {"flow", "fitted", "boxes"});
    if (m == "flow") abstraction.abstractor = Mean_curvature_abstraction();
    if (m == "boxes") abstraction.abstractor = Bounding_box_abstraction();
  }),
      "how parts become curves and sheets: flow (mean curvature flow alone: converged for curves, stopped for sheets), "
      "fitted (curves by the flow, sheets on the medial axis, axes of round parts and blocks) or boxes (bounding "
      "boxes: "
      "rough, at once)");
  add("kind",
      po::value<std::string>()->value_name("KIND")->default_value("auto")->notifier(
          [&](const std::string& word) { abstraction.kind = parse_kind("kind", word); }),
      "what parts become: curve, sheet, or auto, what suits each");
  add("part-kind", po::value<std::vector<std::string>>()->value_name("PART=KIND")->notifier([&](const auto& words) {
    for (const std::string& word : words)
      abstraction.part_kinds.insert(parse_part_kind(word));
  }),
      "the same for one part; may be given many times");
  add("edge-length", number(abstraction.edge_length)->value_name("X"), "edges of the remeshed part, over its diagonal");
  add("triangles", number(abstraction.triangles)->value_name("N"),
      "about how many triangles the remeshed part may have; its edges are longer if need be");
  add("stop-volume", number(abstraction.stop_volume)->value_name("X"),
      "fraction of the volume at which the flow shows sheets, and whether a part is hollow");
  add("max-iterations", number(abstraction.maximum_iterations)->value_name("N"),
      "steps of the flow; the bounding box stands in for a part that needs more");
  add("time-limit", po::value(&abstraction.time_limit)->value_name("SECONDS"),
      "for a part; the bounding box stands in for one that needs more, and a warning says so; default: none, so that "
      "no result depends on the speed of the machine");
  add("curve-points", number(abstraction.curve_points)->value_name("N"),
      "control points of a curve; as many again for every full turn that it makes");
  add("sheet-points", number(abstraction.sheet_points)->value_name("N"), "control points along a side of a sheet");
  return result;
}

po::options_description pair_options(Common_options& options)
{
  po::options_description result = option_group("Options on one of two models");
  auto add = result.add_options();
  Common_options::Of_input &source = options.of_pair[0], &target = options.of_pair[1];
  add("source-up", po::value(&source.up)->value_name("AXIS"), "the upright axis of the source, as --up");
  add("target-up", po::value(&target.up)->value_name("AXIS"), "the same of the target");
  add("source-parts-from", po::value(&source.parts_from)->value_name("FILE"),
      "take the parts of the source from a list of its pieces and their parts, as `graph --parts-json` writes it");
  add("target-parts-from", po::value(&target.parts_from)->value_name("FILE"), "the same of the target");
  return result;
}

Arguments parse(const std::vector<std::string>& arguments, const po::options_description& options, std::size_t least,
                std::size_t most)
{
  po::options_description all;
  all.add(options).add_options()(inputs_key, po::value<std::vector<std::string>>());
  po::positional_options_description positional;
  positional.add(inputs_key, -1);
  Arguments result;
  try {
    const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(arguments).options(all).positional(positional).style(style).run(), result.values);
    result.help = result.values.count("help") > 0;
    if (result.help) return result;
    po::notify(result.values);
  } catch (const po::error& error) {
    throw Usage_error(error.what());
  }
  if (result.values.count(inputs_key)) result.inputs = result.values[inputs_key].as<std::vector<std::string>>();
  if (result.inputs.size() < least || result.inputs.size() > most)
    throw Usage_error("it takes " + std::to_string(least) + (most > least ? " or more" : "") +
                      (most == 1 ? " input" : " inputs") + ", not " + std::to_string(result.inputs.size()));
  return result;
}

bool is_given(const po::variables_map& values, const std::string& option)
{
  const po::variable_value& value = values[option];
  return !value.empty() && !value.defaulted();
}

} // namespace CGAL::Shape_correspondence::cli
