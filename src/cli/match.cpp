// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "common_options.h"
#include "load_shape.h"
#include "match_table.h"
#include "thread_limit.h"

#include "../IO/atomic_file.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/IO/write_glb.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <charconv>
#include <cmath>
#include <iostream>

namespace CGAL {
namespace Shape_correspondence {
namespace cli {

namespace po = boost::program_options;

namespace {

const char* const help_text =
    R"(Usage: shape_correspondence match SOURCE TARGET [options]

Finds which parts of two segmented shapes of one kind correspond: the source is deformed into the target and
the target into the source, and the correspondence that costs the least deformation energy is taken. A part
may correspond to many.

SOURCE and TARGET are model files (OBJ with o/g, PLY, STL, OFF, glTF/GLB, COLLADA: one node is one part),
folders of part meshes (one file is one part, its stem the part's name), or structural graphs (.json, .xml).

Example: shape_correspondence match chair.obj swivel_chair.obj --json result.json --glb result.glb

)";

/// The options as they are written on the command line.
struct Match_options
{
  Search_options search;
  std::string method = "beam";
  std::string direction = "both";
  std::string alignments = "auto";
  std::string front = "given";
  std::string weights = "0.6,0.4";
};

po::options_description output_options(Common_options& common)
{
  po::options_description result("Output", 100, 68);
  auto add = result.add_options();
  add("json", po::value(&common.json)->value_name("FILE"), "write the result as JSON; - is standard output");
  add("glb", po::value(&common.glb)->value_name("FILE"),
      "write a picture as binary glTF: both shapes side by side, what corresponds in one colour, the rest grey");
  return result;
}

po::options_description match_options(Match_options& match)
{
  po::options_description result("Options of match", 100, 68);
  auto add = result.add_options();
  add("search", po::value(&match.method)->value_name("METHOD")->default_value(match.method),
      "how the least energy is searched: beam (the paper's pruned beam search) or exact (with a proof)");
  add("beam-width", po::value(&match.search.beam.beam_width)->value_name("K")->default_value(20),
      "partial solutions kept at every step, the paper's K");
  add("expansions", po::value(&match.search.beam.expansions)->value_name("k")->default_value(4),
      "continuations kept of every partial solution, the paper's k");
  add("direction", po::value(&match.direction)->value_name("WHICH")->default_value(match.direction),
      "which shapes are deformed: both, or forward (the source only)");
  add("max-parts", po::value(&match.search.maximum_parts)->value_name("N"),
      "coarse correspondence of the N most prominent parts of either shape; default: all parts");
  add("front", po::value(&match.front)->value_name("HOW")->default_value(match.front),
      "of the alignments that the shapes' own symmetry leaves: given takes the one nearest to their orientation in the "
      "files, auto the one with the lowest energy");
  add("alignments", po::value(&match.alignments)->value_name("N")->default_value(match.alignments),
      "how many alignments are tried, nearest to the given orientation first; auto: one with --front given, all with "
      "--front auto");
  add("weights", po::value(&match.weights)->value_name("WC,WS")->default_value(match.weights),
      "weights of connectedness and of splits in the energy, the paper's w_c and w_s");
  return result;
}

/// A number that makes up the whole text, or an error that names the option.
template <typename Number>
Number parse_number(const std::string& option, const std::string& text)
{
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    throw Usage_error("--" + option + ": '" + text + "' is not a number that it takes");
  return number;
}

double parse_weight(const std::string& text)
{
  const double weight = parse_number<double>("weights", text);
  if (!(weight >= 0) || std::isinf(weight))
    throw Usage_error("--weights must be finite and not negative, not '" + text + "'");
  return weight;
}

Energy_weights parse_weights(const std::string& text)
{
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) throw Usage_error("--weights takes two numbers, w_c,w_s, not '" + text + "'");
  return {parse_weight(text.substr(0, comma)), parse_weight(text.substr(comma + 1))};
}

int parse_alignments(const Match_options& match)
{
  if (match.alignments == "auto") return match.front == "given" ? 1 : 0;
  const int number = parse_number<int>("alignments", match.alignments);
  check_at_least("alignments", number, 1);
  return number;
}

Search_options search_options(const Match_options& match, const po::variables_map& values)
{
  check_word("search", match.method, {"beam", "exact"});
  check_word("direction", match.direction, {"both", "forward"});
  check_word("front", match.front, {"given", "auto"});
  check_at_least("beam-width", match.search.beam.beam_width, 1);
  check_at_least("expansions", match.search.beam.expansions, 1);
  if (values.count("max-parts")) check_at_least("max-parts", match.search.maximum_parts, 1);
  Search_options search = match.search;
  search.method = match.method == "exact" ? Search_method::EXACT : Search_method::BEAM;
  search.both_directions = match.direction == "both";
  search.alignments = parse_alignments(match);
  search.weights = parse_weights(match.weights);
  return search;
}

/// What both shapes' graphs warn of comes first.
void add_warnings(const std::string& path, const Structural_graph& graph, std::vector<std::string>& warnings)
{
  for (const std::string& warning : structure(graph).warnings)
    warnings.push_back(path + ": " + warning);
}

Correspondence search(const std::vector<std::string>& paths, const Loaded_shape& source, const Loaded_shape& target,
                      const Search_options& options)
{
  Correspondence correspondence = find_correspondence(source.graph, target.graph, options);
  std::vector<std::string> warnings;
  add_warnings(paths[0], source.graph, warnings);
  add_warnings(paths[1], target.graph, warnings);
  correspondence.warnings.insert(correspondence.warnings.begin(), warnings.begin(), warnings.end());
  return correspondence;
}

} // namespace

void run_match(const std::vector<std::string>& arguments)
{
  Common_options common;
  Match_options match;
  po::options_description options;
  options.add(output_options(common)).add(match_options(match)).add(common_options(common));
  const Arguments parsed = parse(arguments, options, 2);
  if (parsed.help) {
    std::cout << help_text << options;
    return;
  }
  const Search_options search_with = search_options(match, parsed.values);
  check(common);
  const Thread_limit limit(common.threads);
  const std::vector<std::string>& paths = parsed.inputs;
  const Loaded_shape source = load_shape(paths[0], common), target = load_shape(paths[1], common);
  const double begin = now();
  const Correspondence correspondence = search(paths, source, target, search_with);
  const IO::Match_seconds seconds{source.read_seconds + target.read_seconds,
                                  source.abstraction_seconds + target.abstraction_seconds,
                                  source.structure_seconds + target.structure_seconds, now() - begin};
  if (!common.json.empty())
    IO::write_atomically(common.json, [&](std::ostream& out) {
      IO::write_correspondence_json(out, correspondence, source.graph, target.graph, paths[0], paths[1], seconds);
    });
  if (!common.glb.empty())
    IO::write_atomically(common.glb, [&](std::ostream& out) {
      IO::write_correspondence_glb(out, correspondence, source.graph, target.graph, source.model_pointer(),
                                   target.model_pointer());
    });
  if (common.prints_table()) write_match_table(std::cout, correspondence, source.graph, target.graph);
}

} // namespace cli
} // namespace Shape_correspondence
} // namespace CGAL
