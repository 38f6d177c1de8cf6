// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/collection_options.h"
#include "cli/command_line.h"
#include "io/system/digest.h"

#include <CGAL/Shape_correspondence/Role_model.h>
#include <CGAL/Shape_correspondence/version.h>

#include <sstream>

namespace CGAL::Shape_correspondence::cli {

namespace po = boost::program_options;

namespace {

/// To be raised with every change that makes other energies or pairs of the same graphs and options.
constexpr int matching_version = 8;

/// Options of match that have no effect on a collection.
void refuse_options_of_pairs(const po::variables_map& values)
{
  for (const char* option :
       {"solutions", "min-marginals", "source-parts", "target-parts", "pin", "forbid", "search-time-limit"})
    if (is_given(values, option)) throw Usage_error("--" + std::string(option) + " has no effect on a set of shapes");
}

void parse_tile(Collection_options& options)
{
  std::istringstream text(options.tile);
  char slash = 0;
  if (!(text >> options.tile_number >> slash >> options.tile_count) || slash != '/' || !text.eof() ||
      options.tile_number < 1 || options.tile_number > options.tile_count)
    throw Usage_error("--tile takes I/N with I from 1 to N, not '" + options.tile + "'");
}

/// The values of all options of matching, as a text.
std::string text_of(const po::options_description& options, const po::variables_map& values)
{
  std::ostringstream text;
  text << std::hexfloat;
  for (const auto& option : options.options()) {
    const po::variable_value& value = values[option->long_name()];
    text << option->long_name() << '=';
    if (const auto* word = boost::any_cast<std::string>(&value.value())) text << *word;
    if (const auto* number = boost::any_cast<int>(&value.value())) text << *number;
    if (const auto* number = boost::any_cast<std::size_t>(&value.value())) text << *number;
    if (const auto* number = boost::any_cast<double>(&value.value())) text << *number;
    if (const auto* is_set = boost::any_cast<bool>(&value.value())) text << *is_set;
    text << '\n';
  }
  return text.str();
}

} // namespace

po::options_description collection_options(Common_options& common, Collection_options& options)
{
  po::options_description result = option_group("Options of collection");
  auto add = result.add_options();
  add("json", po::value(&common.json)->value_name("FILE"), "write the result as JSON; - is standard output");
  add("npy", po::value(&options.npy)->value_name("FILE"),
      "write the distances, source by target, as a NumPy array of doubles");
  add("csv", po::value(&options.csv)->value_name("FILE"),
      "write the distances as a table with the names of the shapes");
  add("html", po::value(&common.html)->value_name("FILE"),
      "write a web page with the shapes, the medoid, the spanning tree, and the match of any two shapes that are "
      "clicked "
      "(of more than 100 shapes: of near ones; of more than 1000 shapes it shows 1000); it needs no network");
  add("matches", po::bool_switch(&options.matches),
      "write the corresponding parts of all pairs of shapes to --json, too (of more than 100 shapes: of near ones)");
  add("agreeing", po::bool_switch(&options.agreeing),
      "keep only pairs of parts that are in one cluster, in --matches and on the page of --html: fewer pairs, which "
      "are "
      "right more often");
  add("store", po::value(&options.store)->value_name("FOLDER"),
      "keep graphs and finished pairs in this folder and reuse them; recommended for large sets, of which graphs, "
      "pairs and distances then need not fit into memory");
  add("nearest", po::value(&options.nearest)->value_name("QUERY"),
      "find the shapes of the set that are nearest to this one instead, without matching all pairs");
  add("count,k", number(options.nearest_count)->value_name("K"), "how many shapes --nearest finds");
  add("labels-from", po::value(&options.labels_from)->value_name("SHAPE"),
      "transfer the labels of this shape to the set instead: a folder with labels.json and parts, one mesh file for "
      "each "
      "part. Each part gets the label of the part to which it corresponds most probably");
  add("labels-to", po::value(&options.labels_to)->value_name("FOLDER"),
      "write FOLDER/NAME/labels.json for each shape of --labels-from, with the probability of each label");
  add("tile", po::value(&options.tile)->value_name("I/N"),
      "compute the I-th of N shares of the pairs and write no result, as one of N jobs; needs --store");
  add("merge", po::bool_switch(&options.merge), "match nothing; all pairs must be in the store");
  add("tile-size", po::value(&options.block_size)->value_name("N"),
      "shapes on a side of a tile, the smallest unit of work in the store; default: by the number of shapes, at most "
      "128");
  add("skip-bad", po::bool_switch(&options.skip_bad), "leave out inputs that cannot be used, with a warning");
  add("unmatched-energy", number(options.unmatched_energy)->value_name("E"),
      "energy of a pair of connected parts of which one has no counterpart");
  add("inflation", number(options.co_analysis.clustering.inflation)->value_name("R"),
      "inflation of Markov clustering, more than 1; larger values make smaller clusters of parts");
  add("cycle-support", number(options.co_analysis.least_cycle_support)->value_name("S"),
      "use a pair of parts for clustering if at least this share of third shapes confirm it, between 0 and 1; 0: use "
      "all");
  add("neighbours", po::value(&options.neighbours)->value_name("K"),
      "cluster with the part maps of each shape to its K nearest ones only; default: all for up to 100 shapes, else "
      "32");
  return result;
}

void check(Collection_options& options, const Common_options& common, const po::variables_map& values)
{
  refuse_options_of_pairs(values);
  const bool in_parts = !options.tile.empty();
  if (in_parts) parse_tile(options);
  if ((in_parts || options.merge) && options.store.empty()) throw Usage_error("--tile and --merge need --store");
  if (in_parts && options.merge) throw Usage_error("--tile and --merge do not go together");
  if (in_parts && !(common.json + common.html + options.npy + options.csv).empty())
    throw Usage_error("--tile writes no result; --merge does when all shares are done");
  if (is_given(values, "count") && options.nearest.empty()) throw Usage_error("-k has no effect without --nearest");
  if (!options.nearest.empty() &&
      (in_parts || options.merge || !(common.html + options.npy + options.csv).empty() || options.matches))
    throw Usage_error("--nearest goes with --json and --store, not with shares of the work or files of all pairs");
  if (!options.labels_to.empty() && options.labels_from.empty())
    throw Usage_error("--labels-to has no effect without --labels-from");
  if (!options.labels_from.empty() && (in_parts || options.merge || options.matches || options.agreeing ||
                                       !(options.nearest + common.html + options.npy + options.csv).empty()))
    throw Usage_error("--labels-from goes with --labels-to, --json and --store, not with --nearest, shares of the work "
                      "or files of all pairs");
  if (options.nearest_count < 1) throw Usage_error("-k must be at least 1");
  if (values.count("tile-size") && options.block_size < 1) throw Usage_error("--tile-size must be at least 1");
  if (values.count("neighbours") && options.neighbours < 1) throw Usage_error("--neighbours must be at least 1");
  if (options.matches && common.json.empty()) throw Usage_error("--matches has no effect without --json");
  if (options.agreeing && !options.matches && common.html.empty())
    throw Usage_error("--agreeing has no effect without --matches or --html");
  if (!(options.unmatched_energy >= 0)) throw Usage_error("--unmatched-energy must not be negative");
  if (!(options.co_analysis.clustering.inflation > 1)) throw Usage_error("--inflation must be more than 1");
  if (!(options.co_analysis.least_cycle_support >= 0 && options.co_analysis.least_cycle_support <= 1))
    throw Usage_error("--cycle-support must be between 0 and 1");
}

std::string key_of(const Match_options& match, const Search_options& search, const Collection_options& options,
                   const po::variables_map& values)
{
  Match_options names = match; // for their names alone
  const std::string category = match.examples.empty() ? "" : "category=" + search.category;
  return key_of(text_of(match_options(names), values), search, options.unmatched_energy) + category;
}

std::string key_of(const std::string& match_options, const Search_options& search, double unmatched_energy)
{
  std::ostringstream key;
  key << CGAL_SHAPE_CORRESPONDENCE_VERSION << '/' << matching_version << '\n'
      << match_options << std::hexfloat << "unmatched-energy=" << unmatched_energy;
  if (search.roles) {
    std::ostringstream roles;
    search.roles->write(roles);
    key << "roles=" << IO::digest(roles.str());
  }
  return key.str();
}

} // namespace CGAL::Shape_correspondence::cli
