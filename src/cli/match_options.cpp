// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/match_options.h"
#include "cli/command_line.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace CGAL::Shape_correspondence::cli {

namespace po = boost::program_options;

namespace {

/// Of a contact of a group that is left unmatched; about what a badly deformed contact costs.
constexpr double default_unmatched_cost = 0.5;

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
  Energy_weights weights;
  weights.connectedness = parse_weight(text.substr(0, comma));
  weights.split = parse_weight(text.substr(comma + 1));
  return weights;
}

void switch_off(const std::string& term, Energy_weights& weights)
{
  check_word("without", term, {"distortion", "connectedness", "split"});
  (term == "distortion" ? weights.distortion : term == "split" ? weights.split : weights.connectedness) = 0;
}

int parse_alignments(const Match_options& match, bool is_front_given)
{
  if (match.alignments == "auto") return match.front == "given" && (is_front_given || !match.paper) ? 1 : 0;
  const int number = parse_number<int>("alignments", match.alignments);
  check_at_least("alignments", number, 1);
  return number;
}

/// Options that only a search for the least energy has, and the method that they ask for.
const std::pair<const char*, Search_method> energy_options[] = {
    {"beam-width", Search_method::BEAM},       {"expansions", Search_method::BEAM},
    {"allow-unmatched", Search_method::EXACT}, {"search-time-limit", Search_method::EXACT},
    {"min-marginals", Search_method::EXACT},   {"solutions", Search_method::EXACT}};

Search_method search_method(const Match_options& match, const po::variables_map& values)
{
  if (match.paper && match.method != "auto" && match.method != "beam")
    throw Usage_error("--paper is --search beam; it does not go with --search " + match.method);
  if (match.method == "beam" || match.paper) return Search_method::BEAM;
  if (match.method == "exact") return Search_method::EXACT;
  for (const auto& [option, method] : energy_options) {
    if (!is_given(values, option)) continue;
    if (match.method == "parts")
      throw Usage_error("--" + std::string(option) + " needs a search for the least energy: --search beam or exact");
    return method;
  }
  return Search_method::PARTS;
}

/// Roles are for matching by parts.
std::shared_ptr<const Role_model> role_model(const Match_options& match, const po::variables_map& values,
                                             const Search_options& search)
{
  if (match.roles == "none") return nullptr;
  if (search.method != Search_method::PARTS) {
    for (const char* option : {"roles", "category"})
      if (is_given(values, option)) throw Usage_error("--" + std::string(option) + " needs --search parts");
    return nullptr;
  }
  return match.roles == "auto" ? IO::shipped_role_model()
                               : std::make_shared<const Role_model>(IO::read_role_model(match.roles));
}

} // namespace

po::options_description match_options(Match_options& match)
{
  po::options_description result = option_group("Options of match");
  auto add = result.add_options();
  add("search", po::value(&match.method)->value_name("METHOD")->default_value(match.method),
      "parts (what parts cost standing for one another; agrees best with people), beam (least deformation energy by "
      "the "
      "paper's pruned beam search) or exact (the same, proven for each direction; of the directions, the one of less "
      "energy per connected pair of parts is "
      "taken); auto: parts, or what the other "
      "options need");
  add("paper", po::bool_switch(&match.paper),
      "match as the paper does: --search beam --front auto, and --max-parts of the source alone");
  add("roles", po::value(&match.roles)->value_name("MODEL")->default_value(match.roles),
      "what parts are for, joined with their costs by --search parts where the shapes are upright and look to +z: auto "
      "(the model that comes with the program), none, or a file that `roles train` wrote");
  add("category", po::value(&match.search.category)->value_name("NAME"),
      "the category of both shapes, whose roles are taken, such as chair; default: the one that they are most like");
  add("min-confidence", number(match.search.min_confidence)->value_name("P"),
      "leave out pairs of parts that are less probable, between 0 and 1; of --search parts");
  add("beam-width", number(match.search.beam.beam_width)->value_name("K"),
      "partial solutions kept at every step, the paper's K");
  add("expansions", number(match.search.beam.expansions)->value_name("k"),
      "continuations kept of every partial solution, the paper's k");
  add("direction", po::value(&match.direction)->value_name("WHICH")->default_value(match.direction),
      "which shapes are deformed: both, or forward (the source only)");
  add("max-parts", po::value(&match.search.maximum_parts)->value_name("N"),
      "coarse correspondence of the N most prominent parts; default: all parts");
  add("max-parts-of", po::value(&match.coarse_shapes)->value_name("WHICH")->default_value(match.coarse_shapes),
      "the shapes that --max-parts selects parts of: both, or source (the paper's way; the source is deformed into all "
      "of "
      "the target); auto: source with --paper, else both");
  add("front", po::value(&match.front)->value_name("HOW")->default_value(match.front),
      "of the alignments that the shapes' own symmetry leaves: given takes the one nearest to their orientation in the "
      "files; auto finds the fronts of shapes of a known category by the roles of their parts, and else takes the "
      "best-scoring alignment (the default with --paper)");
  add("alignments", po::value(&match.alignments)->value_name("N")->default_value(match.alignments),
      "how many alignments are tried, nearest to the given orientation first; auto: one with --front given, all with "
      "--front auto");
  add("weights", po::value(&match.weights)->value_name("WC,WS")->default_value(match.weights),
      "weights of connectedness and of splits in the energy, the paper's w_c and w_s");
  add("without", po::value(&match.without)->value_name("TERM"),
      "switch one term of the energy off: distortion, connectedness or split");
  add("norm", po::value(&match.norm)->value_name("NORM")->default_value(match.norm),
      "sum adds the energies of connected pairs of parts (the paper's); pooled takes one norm over all of their rods");
  add("no-cut", po::bool_switch(), "never cut curves into segments, only split, duplicate and merge");
  add("allow-unmatched",
      po::value(&match.search.matching.unmatched_cost)->value_name("COST")->implicit_value(default_unmatched_cost),
      "groups of parts may be left unmatched, at this cost for each of their contacts (0.5 if no number is given); for "
      "shapes of which one is a part of the other");
  add("solutions", number(match.search.solutions)->value_name("N"),
      "write the N best correspondences into the result, ranked by their energy");
  add("min-marginals", po::bool_switch(&match.search.min_marginals),
      "say of every group by how much the energy rises if it may not have its match: how sure the match is");
  add("search-time-limit", po::value(&match.search.exact.time_limit)->value_name("SECONDS"),
      "end an exact search that takes longer with the best result so far and the gap to its lower bound");
  add("source-parts", po::value(&match.source_parts)->value_name("NAMES"),
      "match only these parts of the source, their names separated by commas");
  add("target-parts", po::value(&match.target_parts)->value_name("NAMES"), "the same for the target");
  return result;
}

Search_options search_options(const Match_options& match, const po::variables_map& values)
{
  check_word("search", match.method, {"auto", "parts", "beam", "exact"});
  check_word("direction", match.direction, {"both", "forward"});
  check_word("front", match.front, {"given", "auto"});
  check_word("max-parts-of", match.coarse_shapes, {"auto", "both", "source"});
  check_word("norm", match.norm, {"sum", "pooled"});
  check_at_least("solutions", match.search.solutions, 1);
  if (!(match.search.min_confidence >= 0 && match.search.min_confidence <= 1))
    throw Usage_error("--min-confidence must be between 0 and 1");
  if (!(match.search.matching.unmatched_cost >= 0)) throw Usage_error("--allow-unmatched must not be negative");
  if (!(match.search.exact.time_limit >= 0)) throw Usage_error("--search-time-limit must not be negative");
  check_at_least("beam-width", match.search.beam.beam_width, 1);
  check_at_least("expansions", match.search.beam.expansions, 1);
  if (values.count("max-parts")) check_at_least("max-parts", match.search.maximum_parts, 1);
  Search_options search = match.search;
  search.method = search_method(match, values);
  search.both_directions = match.direction == "both";
  search.alignments = parse_alignments(match, is_given(values, "front"));
  search.coarse_target = match.coarse_shapes == "both" || (match.coarse_shapes == "auto" && !match.paper);
  search.roles = role_model(match, values, search);
  search.matching.weights = parse_weights(match.weights);
  if (values.count("without")) switch_off(match.without, search.matching.weights);
  search.matching.norm = match.norm == "pooled" ? Energy_norm::POOLED : Energy_norm::SUM;
  search.matching.cut_curves = !values["no-cut"].as<bool>();
  return search;
}

std::vector<std::size_t> chosen_parts(const std::string& names, const Structural_graph& graph, const std::string& path)
{
  std::vector<std::size_t> result;
  const auto& parts = structure(graph).parts;
  for (const std::string& name : words_of(names)) {
    const auto found =
        std::find_if(parts.begin(), parts.end(), [&](const Part_abstraction& part) { return part.name == name; });
    if (found == parts.end())
      throw Invalid_input(path + ": there is no part '" + name +
                          "' to choose; `shape_correspondence graph` lists the parts");
    result.push_back(std::size_t(found - parts.begin()));
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::cli
