// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/command_line.h"
#include "cli/load_shape.h"
#include "cli/suggestion.h"
#include "cli/text_table.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace CGAL::Shape_correspondence::cli {

namespace po = boost::program_options;

namespace {

constexpr const char* inputs_key = "INPUT"; // of positional arguments
constexpr const char* abstraction_title = "Options on part abstraction";
constexpr int most_threads = 4096; // each needs memory of its own

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

po::options_description structure_options(Common_options& options)
{
  po::options_description result = option_group("Options on structural graphs");
  auto add = result.add_options();
  add("no-symmetry", po::bool_switch(&options.no_symmetry), "make every part a group of its own");
  add("symmetries", po::value(&options.symmetries)->value_name("KINDS")->default_value(options.symmetries),
      "kinds of symmetry groups to detect");
  add("symmetry-tolerance", number(options.symmetry_tolerance)->value_name("T"),
      "largest distance of a part from its image, as a fraction of the diagonal of the part");
  add("contact-tolerance", number(options.contact_tolerance)->value_name("T"),
      "largest gap between parts in contact, as a fraction of the diagonal of the shape");
  add("cache", po::value(&options.cache)->value_name("FOLDER"),
      "keep structural graphs in this folder and reuse them when model and options are the same");
  return result;
}

po::options_description abstraction_options(Abstraction_options& abstraction)
{
  po::options_description result = option_group(abstraction_title);
  auto add = result.add_options();
  add("abstraction", po::value<std::string>()->value_name("METHOD")->default_value("fitted")->notifier([&](auto& m) {
    check_word("abstraction", m, {"flow", "fitted", "boxes"});
    if (m == "flow") abstraction.abstractor = Mean_curvature_abstraction();
    if (m == "boxes") abstraction.abstractor = Bounding_box_abstraction();
  }),
      "method of part abstraction: fitted (sheets on the medial axis, curves by mean curvature flow, axes of round "
      "parts and blocks), flow (mean curvature flow alone, as in the paper) or boxes (axes of bounding boxes: fast and "
      "rough)");
  add("kind",
      po::value<std::string>()->value_name("KIND")->default_value("auto")->notifier(
          [&](const std::string& word) { abstraction.kind = parse_kind("kind", word); }),
      "abstract parts by curve, sheet, or auto (what fits each part)");
  add("part-kind", po::value<std::vector<std::string>>()->value_name("PART=KIND")->notifier([&](const auto& words) {
    for (const std::string& word : words)
      abstraction.part_kinds.insert(parse_part_kind(word));
  }),
      "the same for one part; can be repeated");
  add("edge-length", number(abstraction.edge_length)->value_name("X"),
      "edge length of the remeshed part, as a fraction of its diagonal");
  add("triangles", number(abstraction.triangles)->value_name("N"),
      "approximate maximum of triangles of the remeshed part; edges are longer where needed");
  add("stop-volume", number(abstraction.stop_volume)->value_name("X"),
      "fraction of the volume at which the flow is stopped to detect sheets and hollow parts");
  add("max-iterations", number(abstraction.maximum_iterations)->value_name("N"),
      "maximum of iterations of the flow; a part that needs more is represented by its bounding box");
  add("time-limit", po::value(&abstraction.time_limit)->value_name("SECONDS"),
      "time limit for one part; a part that needs more is represented by its bounding box, with a warning. Default: no "
      "limit, so that results do not depend on the speed of the machine");
  add("curve-points", number(abstraction.curve_points)->value_name("N"),
      "control points of a curve, and as many more for each full turn");
  add("sheet-points", number(abstraction.sheet_points)->value_name("N"), "control points along each side of a sheet");
  return result;
}

/// What is wrong for any option: an empty word, such as a variable that a script did not set, and a negative count,
/// which is read as a huge one.
void check_values(const po::variables_map& values)
{
  for (const auto& [name, value] : values) {
    if (value.defaulted()) continue;
    const auto* word = boost::any_cast<std::string>(&value.value());
    if (word && word->empty()) throw Usage_error("--" + name + " is empty");
    const auto* count = boost::any_cast<std::size_t>(&value.value());
    if (count && *count > std::numeric_limits<std::size_t>::max() / 2)
      throw Usage_error("--" + name + " must not be negative");
  }
}

std::vector<std::string> long_names(const po::options_description& options)
{
  std::vector<std::string> result;
  for (const auto& option : options.options())
    result.push_back("--" + option->long_name());
  return result;
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
  add("threads", po::value(&options.threads)->value_name("N")->notifier([](int n) {
    check_from_to("threads", n, 1, most_threads);
  }),
      "number of threads; default: all of the machine. The result does not depend on it");
  add("seed", po::value(&options.seed)->value_name("N"),
      "seed of random choices, which evaluate and roles make; default: 0. Results are reproducible");
  add("quiet,q", po::bool_switch(&options.quiet), "print errors only");
  add("verbose,v", po::bool_switch(&options.verbose),
      "print more: time and memory on standard error; match also prints the energy of every symmetry group, blend the "
      "correspondence");
  add("progress", po::value(&options.progress)->value_name("WHEN")->default_value(options.progress),
      "show a progress bar on standard error: auto (if it is a terminal), always, never");
  add("help,h", "print this text");
  return result;
}

po::options_description reading_options(Common_options& options)
{
  po::options_description result = option_group("Options on model files");
  auto add = result.add_options();
  add("up", po::value(&options.up)->value_name("AXIS"),
      "upright axis of the model: x, y, z, or auto (the axis along which the model stands most stably). Default: the "
      "one "
      "given by the file (glTF, COLLADA, graphs); y for a folder of part meshes; otherwise y unless the model clearly "
      "stands along another axis, or its parts are more like labelled ones with another axis up, with a warning");
  add("parts", po::value(&options.parts)->value_name("MODE")->default_value(options.parts),
      "how parts are made of a model file: file (its objects), components (its loose pieces), segments (loose pieces "
      "divided by thickness) or auto (its objects, but objects of unrelated loose pieces are split). "
      "`shape_correspondence parts MODEL` shows the result. Files in a folder are always parts as they are");
  add("segment", po::bool_switch()->notifier([&](bool is_set) {
    if (is_set) options.parts = "segments";
  }),
      "the same as --parts segments");
  add("allow-outside-files", po::bool_switch(&options.reading.allow_outside_files),
      "read also files that a model or a graph names outside its own folder: buffers, materials, textures, meshes of "
      "parts");
  return result;
}

po::options_description model_options(Common_options& options)
{
  po::options_description result;
  result.add(reading_options(options)).add(structure_options(options)).add(abstraction_options(options.abstraction));
  return result;
}

po::options_description pair_options(Common_options& options)
{
  po::options_description result = option_group("Options on one of two models");
  auto add = result.add_options();
  Common_options::Of_input &source = options.of_pair[0], &target = options.of_pair[1];
  add("source-up", po::value(&source.up)->value_name("AXIS"), "upright axis of the source, as --up");
  add("target-up", po::value(&target.up)->value_name("AXIS"), "the same for the target");
  add("source-parts-from", po::value(&source.parts_from)->value_name("FILE"),
      "read the parts of the source from a list of its pieces and their parts, as `graph --parts-json` writes it");
  add("target-parts-from", po::value(&target.parts_from)->value_name("FILE"), "the same for the target");
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
  } catch (const po::unknown_option& error) {
    const std::string name = error.get_option_name();
    throw Usage_error("there is no option '" + name + "'" + suggestion(name, long_names(options)));
  } catch (const po::error& error) {
    throw Usage_error(error.what());
  }
  if (is_given(result.values, "quiet") && is_given(result.values, "verbose"))
    throw Usage_error("--quiet and --verbose do not go together");
  check_values(result.values);
  if (result.values.count(inputs_key)) result.inputs = result.values[inputs_key].as<std::vector<std::string>>();
  if (std::count(result.inputs.begin(), result.inputs.end(), "") > 0)
    throw Usage_error("the name of an input is empty");
  if (result.inputs.size() < least || result.inputs.size() > most)
    throw Usage_error("it takes " + std::to_string(least) +
                      (most == any_number ? " or more"
                       : most > least     ? " or " + std::to_string(most)
                                          : "") +
                      (most == 1 ? " input" : " inputs") + ", not " + std::to_string(result.inputs.size()));
  return result;
}

void refuse_abstraction_of_graphs(const Arguments& arguments)
{
  if (!std::all_of(arguments.inputs.begin(), arguments.inputs.end(), is_graph_file)) return;
  Abstraction_options unused;
  const po::options_description options = abstraction_options(unused);
  for (const auto& option : options.options())
    if (is_given(arguments.values, option->long_name()))
      throw Usage_error("--" + option->long_name() +
                        " has no effect on structural graphs, which are abstracted already");
}

bool is_given(const po::variables_map& values, const std::string& option)
{
  const po::variable_value& value = values[option];
  return !value.empty() && !value.defaulted();
}

} // namespace CGAL::Shape_correspondence::cli
