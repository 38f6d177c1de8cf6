// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/number_text.h"
#include "cli/Common_options.h"
#include "cli/jobs.h"
#include "cli/run.h"
#include "matching/match_parts.h"

#include <CGAL/Shape_correspondence/paper_structure_options.h>

#include <limits>

namespace CGAL::Shape_correspondence::cli {

const std::vector<std::pair<const char*, Search_method>> search_methods{
    {"parts", Search_method::PARTS}, {"beam", Search_method::BEAM}, {"exact", Search_method::EXACT}};

namespace {

/// Default energy of each contact of an unmatched group: about that of a badly deformed contact.
constexpr double default_unmatched_cost = 0.5;

/// Parses the entire text as a number; the error names the option.
template <typename Number>
Number parse_number(const std::string& label, const std::string& text)
{
  Number number{};
  const auto [end, error] = internal::read_number(text, number);
  if (error != std::errc() || end != text.data() + text.size())
    throw Usage_error(label + ": '" + text + "' is not a number in its range");
  return number;
}

Text_field number_of_alignments(std::optional<int>& number)
{
  return {[] { return "auto"; },
          [&number](const std::string& label, const std::string& text) {
            if (text == "auto") return;
            number = parse_number<int>(label, text);
            if (*number < 1) throw Usage_error(label + " must be at least 1, not " + text);
          }};
}

std::string name_of(Search_method method) { return choice(method, search_methods).get(); }

/// The field of --search; without a value, other options select the method.
Text_field method_or_auto(std::optional<Search_method>& method)
{
  std::vector<std::pair<const char*, std::optional<Search_method>>> words{{"auto", std::nullopt}};
  words.insert(words.end(), search_methods.begin(), search_methods.end());
  return choice(method, words);
}

Search_method search_method(const Match_options& match, const Option_table& given)
{
  if (match.paper && match.method.value_or(Search_method::BEAM) != Search_method::BEAM)
    throw Usage_error("--paper is --search beam; it does not go with --search " + name_of(*match.method));
  if (match.paper) return Search_method::BEAM;
  if (match.method.value_or(Search_method::PARTS) != Search_method::PARTS) return *match.method;
  for (const Option& option : given.options()) {
    if (!option.is_given || option.asked_mode.empty()) continue;
    if (match.method && option.modes.empty()) continue;
    if (match.method)
      throw Usage_error("--" + option.name + " needs a search for the least energy: --search beam or exact");
    return option.asked_mode == "beam" ? Search_method::BEAM : Search_method::EXACT;
  }
  return Search_method::PARTS;
}

bool has_roles(const Match_options& match, Search_method method)
{
  return method == Search_method::PARTS || match.search.energy.weights.roles > 0;
}

/// Refuses given options that change nothing with this method. \throw Usage_error
void refuse_options_without_effect(const Match_options& match, const Option_table& given, Search_method method)
{
  const std::string on_search = "on --search " + name_of(method),
                    selected = match.paper ? ", which --paper selects" : "";
  given.refuse_other_modes(name_of(method), on_search + selected);
  const auto refuse = [&](const char* name, bool has_no_effect, const std::string& why) {
    if (has_no_effect && given.is_given(name)) refuse_option(name, why);
  };
  for (const char* name : {"roles", "examples", "category"})
    refuse(name, !has_roles(match, method), on_search + selected + (match.paper ? "," : "") + " without --role-weight");
  const bool has_no_model = match.roles == "none" && match.examples.empty();
  for (const char* name : {"role-weight", "category"})
    refuse(name, has_no_model, "with --roles none");
  for (const char* name : {"source-features", "target-features", "feature-weight"})
    refuse(name, match.features[0].empty() || match.features[1].empty(),
           "without --source-features and --target-features, as those of both shapes are compared");
  refuse("front", match.alignments.has_value(), "with --alignments " + std::to_string(match.alignments.value_or(0)));
  if (!given.is_given("front") || match.front != "likely") return;
  if (method != Search_method::PARTS) refuse_option("front likely", on_search);
  if (has_no_model) refuse_option("front likely", "with --roles none");
}

std::shared_ptr<const Role_model> role_model(const Match_options& match, Search_method method)
{
  if (match.roles == "none" || !has_roles(match, method)) return nullptr;
  return role_model_of(match.roles == "auto" ? "" : match.roles);
}

} // namespace

void add_match_options(Option_table& table, Match_options& match)
{
  Search_options& search = match.search;
  const std::vector<std::string> by_energy{"beam", "exact"};
  Option_table::Group add = table.rare_group(match_group);
  add("search", "METHOD", method_or_auto(match.method),
      "parts (compares parts by place, size, shape and role; scores highest against human labels), beam (least "
      "deformation energy by the beam search of the paper) or exact (least deformation energy, proven for each "
      "direction; of both directions, the one with less energy per pair of connected parts). auto: parts, unless "
      "another option asks for beam or exact")
      .usual();
  add("paper", &match.paper,
      "the method of the paper: --search beam --front auto --abstraction flow, with its rules where the default has "
      "others: contacts are hard constraints at closest points, curved parts keep their bend, the direction with less "
      "energy is taken, and --max-parts applies to the source only")
      .usual();
  add("roles", "MODEL", &match.roles,
      "role model for --search parts and --role-weight: auto (the one that comes with the program), none, or a file "
      "that `roles train` wrote. Shapes must be upright and face +z");
  add("examples", "FOLDER", &match.examples,
      "also learn roles from these labelled shapes of your own, in the form that `roles train` takes. A category that "
      "the model does not know needs three or more. If all are of one category, both shapes are taken to be of it")
      .usual();
  add("category", "NAME", &search.category,
      "category of both shapes for --roles, such as chair; default: the most similar one")
      .in_python()
      .usual();
  add("min-confidence", "P", &search.min_confidence,
      "leave out pairs of parts of lower confidence, between 0 and 1; for --search parts")
      .between(0, 1)
      .only_for({"parts"})
      .in_python();
  add("beam-width", "K", &search.beam.beam_width,
      "partial solutions kept at every level of the beam search, the paper's K")
      .at_least(1)
      .only_for({"beam"})
      .asks_for("beam")
      .in_python();
  add("expansions", "k", &search.beam.expansions, "expansions kept of every partial solution, the paper's k")
      .at_least(1)
      .only_for({"beam"})
      .asks_for("beam")
      .in_python();
  add("max-parts", "N", &search.maximum_parts,
      "match the N largest parts only (coarse correspondence); default: all parts")
      .at_least(1)
      .without_default()
      .in_python("maximum_parts");
  add("coarse-to-fine", "K", &search.coarse_to_fine,
      "match the K largest parts of either shape first, then the others near them; for shapes of hundreds of symmetry "
      "groups, by beam and exact search. Default: all at once")
      .at_least(1)
      .without_default()
      .only_for(by_energy)
      .asks_for("beam")
      .in_python();
  add("front", "HOW", &match.front,
      "which way shapes face: given (as in the files), likely (as in the files, but a shape is turned by a multiple of "
      "90° if the roles of its parts clearly say that it faces another way) or auto (any way: it is estimated from the "
      "roles of parts, or else the best of all alignments that the symmetry of the shapes allows is taken). Default "
      "with --paper: auto")
      .words({"given", "likely", "auto"});
  add("alignments", "N", number_of_alignments(match.alignments),
      "number of alignments to try, nearest to the given orientation first; auto: as --front says");
  add("role-weight", "W", &search.energy.weights.roles,
      "weight of the disagreement of roles in the energy, for beam and exact search; 0: roles are not used, as in the "
      "paper")
      .between(0, std::numeric_limits<double>::max())
      .only_for(by_energy)
      .asks_for("exact")
      .in_python();
  add(
      "no-cut", [&search] { search.energy.cut_curves = false; },
      "do not cut curves into segments; for beam and exact search")
      .only_for(by_energy);
  add("allow-unmatched", "COST", &search.energy.unmatched_cost,
      "allow symmetry groups without counterpart, at this cost for each of their contacts (0.5 if no number is given); "
      "for shapes of which one is a part of the other; for beam and exact search")
      .implies(default_unmatched_cost)
      .at_least(0)
      .without_default()
      .only_for(by_energy)
      .asks_for("exact")
      .in_python("unmatched_cost");
  add("solutions", "N", &search.solutions,
      "write the N best correspondences by energy to --json; for beam and exact search")
      .at_least(1)
      .only_for(by_energy)
      .asks_for("exact")
      .for_pairs()
      .in_python();
  add("min-marginals", &search.min_marginals,
      "write to --json for every symmetry group by how much the energy rises without its match; for beam and exact "
      "search")
      .only_for(by_energy)
      .asks_for("exact")
      .for_pairs()
      .in_python();
  add("search-time-limit", "SECONDS", &search.time_limit,
      "time limit of a match; its best result up to then is written, exact search with the gap to its lower bound, or "
      "that of --search parts if there is none yet")
      .at_least(0)
      .without_default()
      .asks_for("exact")
      .for_pairs();
  add("source-features", "F.npy", &match.features[0],
      "features of the faces or vertices of the source, such as those of a neural network: an array of NumPy with a "
      "row for each of them, in the order of the model file (OBJ, OFF, PLY, STL, or a folder of these). They are "
      "averaged over parts and compared")
      .input()
      .only_for({"parts"})
      .for_pairs();
  add("target-features", "F.npy", &match.features[1], "the same for the target; of the same network")
      .input()
      .only_for({"parts"})
      .for_pairs();
  add("feature-weight", "W", &search.parts.weights.features,
      "weight of the cosine distance of these features in the cost of a pair of parts; 0: they are not used")
      .between(0, largest_feature_weight)
      .only_for({"parts"})
      .for_pairs()
      .in_python();
  add("source-parts", "NAMES", &match.source_parts,
      "match these parts of the source only; names are separated by commas")
      .for_pairs();
  add("target-parts", "NAMES", &match.target_parts, "the same for the target").for_pairs();
  add("pin", "A=B", &match.pinned,
      "source part A corresponds to target part B, and both to nothing else; can be repeated, also for the same part")
      .for_pairs()
      .usual();
  add("forbid", "A=B", &match.forbidden, "source part A does not correspond to target part B; can be repeated")
      .for_pairs();
}

Search_options search_options(const Match_options& match, const Option_table& given)
{
  Search_options search = match.search;
  search.method = search_method(match, given);
  refuse_options_without_effect(match, given, search.method);
  const bool has_one_front = match.front != "auto" && (given.is_given("front") || !match.paper);
  search.alignments = match.alignments.value_or(has_one_front ? 1 : 0);
  search.front_is_sure = match.front == "given";
  if (match.paper) {
    const Search_options paper = paper_options();
    search.direction_by_energy = paper.direction_by_energy;
    search.coarse_target = paper.coarse_target;
    search.energy.fit = paper.energy.fit;
    search.energy.hard_proximity = paper.energy.hard_proximity;
  }
  search.roles = role_model(match, search.method);
  return search;
}

void take_graphs_of_paper(const Match_options& match, const Option_table& given, Structure_options& options)
{
  if (!match.paper) return;
  const Structure_options paper = paper_structure_options();
  if (!given.is_given(abstraction_option)) options.abstraction.abstractor = paper.abstraction.abstractor;
  options.contacts.closest_points = paper.contacts.closest_points;
}

} // namespace CGAL::Shape_correspondence::cli
