// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/match_options.h"
#include "base/limits.h"
#include "cli/command_line.h"
#include "cli/labelled_models.h"

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
    throw Usage_error("--" + option + ": '" + text + "' is not a number in its range");
  return number;
}

double parse_weight(const std::string& text)
{
  const double weight = parse_number<double>("weights", text);
  if (!(weight >= 0 && weight <= internal::largest_number))
    throw Usage_error("--weights must be between 0 and 1e50, not '" + text + "'");
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
  if (match.alignments == "auto") return match.front != "auto" && (is_front_given || !match.paper) ? 1 : 0;
  const int number = parse_number<int>("alignments", match.alignments);
  check_at_least("alignments", number, 1);
  return number;
}

/// Options that only a search for the least energy has, and the method that they ask for.
const std::pair<const char*, Search_method> energy_options[] = {
    {"beam-width", Search_method::BEAM},       {"expansions", Search_method::BEAM},
    {"allow-unmatched", Search_method::EXACT}, {"search-time-limit", Search_method::EXACT},
    {"role-weight", Search_method::EXACT},     {"min-marginals", Search_method::EXACT},
    {"solutions", Search_method::EXACT}};

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

/// Options that have an effect on some methods only.
const std::pair<const char*, std::vector<Search_method>> methods_of_options[] = {
    {"role-weight", {Search_method::BEAM, Search_method::EXACT}},
    {"min-confidence", {Search_method::PARTS}},
    {"beam-width", {Search_method::BEAM}},
    {"expansions", {Search_method::BEAM}},
    {"direction", {Search_method::BEAM, Search_method::EXACT}},
    {"no-cut", {Search_method::BEAM, Search_method::EXACT}},
    {"allow-unmatched", {Search_method::BEAM, Search_method::EXACT}},
    {"solutions", {Search_method::BEAM, Search_method::EXACT}},
    {"min-marginals", {Search_method::BEAM, Search_method::EXACT}},
    {"search-time-limit", {Search_method::EXACT}}};

const char* name_of(Search_method method)
{
  return method == Search_method::PARTS ? "parts" : method == Search_method::BEAM ? "beam" : "exact";
}

bool has_roles(const Match_options& match, Search_method method)
{
  return method == Search_method::PARTS || match.role_weight > 0;
}

/// \throw Usage_error if an option is given that changes nothing
void refuse_options_without_effect(const Match_options& match, const po::variables_map& values, Search_method method)
{
  const auto refuse = [](const std::string& option, const std::string& why) {
    throw Usage_error("--" + option + " has no effect " + why);
  };
  for (const auto& [option, methods] : methods_of_options)
    if (is_given(values, option) && std::find(methods.begin(), methods.end(), method) == methods.end())
      refuse(option, std::string("on --search ") + name_of(method) + (match.paper ? ", which --paper selects" : ""));
  for (const char* option : {"roles", "examples", "category"})
    if (is_given(values, option) && !has_roles(match, method))
      refuse(option, std::string("on --search ") + name_of(method) + (match.paper ? ", which --paper selects," : "") +
                         " without --role-weight");
  if (is_given(values, "role-weight") && match.roles == "none" && match.examples.empty())
    refuse("role-weight", "with --roles none");
  if (is_given(values, "category") && match.roles == "none" && match.examples.empty())
    refuse("category", "with --roles none");
  if (is_given(values, "max-parts-of") && !is_given(values, "max-parts")) refuse("max-parts-of", "without --max-parts");
  if (is_given(values, "front") && is_given(values, "alignments") && match.alignments != "auto")
    refuse("front", "with --alignments " + match.alignments);
  if (is_given(values, "front") && match.front == "likely") {
    if (method != Search_method::PARTS) refuse("front likely", std::string("on --search ") + name_of(method));
    if (match.roles == "none" && match.examples.empty()) refuse("front likely", "with --roles none");
  }
}

std::shared_ptr<const Role_model> role_model(const Match_options& match, Search_method method)
{
  if (match.roles == "none" || !has_roles(match, method)) return nullptr;
  return match.roles == "auto" ? IO::shipped_role_model()
                               : std::make_shared<const Role_model>(IO::read_role_model(match.roles));
}

} // namespace

po::options_description match_options(Match_options& match)
{
  po::options_description result = option_group("Options of match");
  auto add = result.add_options();
  add("search", po::value(&match.method)->value_name("METHOD")->default_value(match.method),
      "parts (least cost of substituting parts for each other; scores highest against human labels), beam (least "
      "deformation energy by the beam search of the paper) or exact (least deformation energy with a proof for each "
      "direction; the direction with less energy per pair of connected parts is taken). auto: parts, unless another "
      "option asks for beam or exact");
  add("paper", po::bool_switch(&match.paper),
      "the method of the paper: --search beam --front auto, and --max-parts of the source only");
  add("roles", po::value(&match.roles)->value_name("MODEL")->default_value(match.roles),
      "role model for --search parts and --role-weight: auto (the one that comes with the program), none, or a file "
      "that `roles train` "
      "wrote. Shapes must be upright and face +z");
  add("examples", po::value(&match.examples)->value_name("FOLDER"),
      "labelled shapes of your own, as `roles train` takes them, from which roles are learned in addition; three or "
      "more "
      "of a category that the model does not know help. If they are of one category, both shapes are taken to be of "
      "it");
  add("category", po::value(&match.search.category)->value_name("NAME"),
      "category of both shapes for --roles, such as chair; default: the most similar one");
  add("min-confidence", number(match.search.min_confidence)->value_name("P"),
      "leave out pairs of parts of lower confidence, between 0 and 1; for --search parts");
  add("beam-width", number(match.search.beam.beam_width)->value_name("K"),
      "partial solutions kept at every level of the beam search, the paper's K");
  add("expansions", number(match.search.beam.expansions)->value_name("k"),
      "expansions kept of every partial solution, the paper's k");
  add("direction", po::value(&match.direction)->value_name("WHICH")->default_value(match.direction),
      "shapes that beam and exact search deform: both, or forward (the source only)");
  add("max-parts", po::value(&match.search.maximum_parts)->value_name("N"),
      "match the N largest parts only (coarse correspondence); default: all parts");
  add("max-parts-of", po::value(&match.coarse_shapes)->value_name("WHICH")->default_value(match.coarse_shapes),
      "shapes to which --max-parts applies: both, or source (as in the paper); auto: source with --paper, otherwise "
      "both");
  add("front", po::value(&match.front)->value_name("HOW")->default_value(match.front),
      "which alignments are tried: given (the one nearest to the orientation in the files), likely (the same, but a "
      "shape is turned by a multiple of 90° if the roles of its parts clearly say that its front is another side) or "
      "auto (any front is as likely: the fronts estimated from the roles of parts; otherwise the best of all "
      "alignments that the symmetry of the shapes allows). Default with --paper: auto");
  add("alignments", po::value(&match.alignments)->value_name("N")->default_value(match.alignments),
      "number of alignments to try, nearest to the given orientation first; auto: as --front says");
  add("weights", po::value(&match.weights)->value_name("WC,WS")->default_value(match.weights),
      "weights of connectedness and split in the energy, w_c and w_s of the paper");
  add("role-weight", number(match.role_weight)->value_name("W"),
      "weight of the disagreement of roles in the energy, for beam and exact search; 0: roles are not used, as in the "
      "paper");
  add("without", po::value(&match.without)->value_name("TERM"),
      "leave out a term of the energy: distortion, connectedness or split");
  add("norm", po::value(&match.norm)->value_name("NORM")->default_value(match.norm),
      "distortion of all pairs of connected parts: sum (of the norms of each pair, as in the paper) or pooled (one "
      "norm "
      "over the rods of all pairs)");
  add("no-cut", po::bool_switch(), "do not cut curves into segments; for beam and exact search");
  add("allow-unmatched",
      po::value(&match.search.matching.unmatched_cost)->value_name("COST")->implicit_value(default_unmatched_cost),
      "allow symmetry groups without counterpart, at this cost for each of their contacts (0.5 if no number is given); "
      "for shapes of which one is a part of the other; for beam and exact search");
  add("solutions", number(match.search.solutions)->value_name("N"),
      "write the N best correspondences by energy to --json; for beam and exact search");
  add("min-marginals", po::bool_switch(&match.search.min_marginals),
      "write to --json for every symmetry group by how much the energy rises without its match; for beam and exact "
      "search");
  add("search-time-limit", po::value(&match.search.exact.time_limit)->value_name("SECONDS"),
      "time limit of the exact search; it then returns its best result and the gap to its lower bound");
  add("source-parts", po::value(&match.source_parts)->value_name("NAMES"),
      "match these parts of the source only; names are separated by commas");
  add("target-parts", po::value(&match.target_parts)->value_name("NAMES"), "the same for the target");
  add("pin", po::value(&match.pinned)->value_name("A=B"),
      "source part A corresponds to target part B, and both to nothing else; can be repeated, also for the same "
      "part");
  add("forbid", po::value(&match.forbidden)->value_name("A=B"),
      "source part A does not correspond to target part B; can be repeated");
  return result;
}

void refuse_search_options(const po::variables_map& given)
{
  Match_options unused;
  const po::options_description search = match_options(unused);
  for (const auto& option : search.options())
    if (is_given(given, option->long_name()) && option->long_name() != "min-confidence")
      throw Usage_error("the correspondence is given by --match; leave --" + option->long_name() + " out");
}

Search_options search_options(const Match_options& match, const po::variables_map& values)
{
  check_word("search", match.method, {"auto", "parts", "beam", "exact"});
  check_word("direction", match.direction, {"both", "forward"});
  check_word("front", match.front, {"given", "likely", "auto"});
  check_word("max-parts-of", match.coarse_shapes, {"auto", "both", "source"});
  check_word("norm", match.norm, {"sum", "pooled"});
  check_at_least("solutions", match.search.solutions, 1);
  if (!(match.search.min_confidence >= 0 && match.search.min_confidence <= 1))
    throw Usage_error("--min-confidence must be between 0 and 1");
  if (!(match.role_weight >= 0) || std::isinf(match.role_weight))
    throw Usage_error("--role-weight must be finite and not negative");
  if (!(match.search.matching.unmatched_cost >= 0)) throw Usage_error("--allow-unmatched must not be negative");
  if (!(match.search.exact.time_limit >= 0)) throw Usage_error("--search-time-limit must not be negative");
  check_at_least("beam-width", match.search.beam.beam_width, 1);
  check_at_least("expansions", match.search.beam.expansions, 1);
  if (values.count("max-parts")) check_at_least("max-parts", match.search.maximum_parts, 1);
  Search_options search = match.search;
  search.method = search_method(match, values);
  refuse_options_without_effect(match, values, search.method);
  search.both_directions = match.direction == "both";
  search.alignments = parse_alignments(match, is_given(values, "front"));
  search.front_is_sure = match.front == "given";
  search.coarse_target = match.coarse_shapes == "both" || (match.coarse_shapes == "auto" && !match.paper);
  search.roles = role_model(match, search.method);
  search.matching.weights = parse_weights(match.weights);
  search.matching.weights.roles = match.role_weight;
  if (values.count("without")) switch_off(match.without, search.matching.weights);
  search.matching.norm = match.norm == "pooled" ? Energy_norm::POOLED : Energy_norm::SUM;
  search.matching.cut_curves = !values["no-cut"].as<bool>();
  return search;
}

void add_examples(const Match_options& match, const Common_options& common, Search_options& search)
{
  if (!match.examples.empty()) add_examples(match.examples, common, search.roles, search.category);
}

} // namespace CGAL::Shape_correspondence::cli
