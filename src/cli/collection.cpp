// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "collection_shapes.h"
#include "commands.h"
#include "common_options.h"
#include "load_shape.h"
#include "match_options.h"
#include "progress_bar.h"
#include "text_table.h"
#include "thread_limit.h"
#include "tile_store.h"
#include "tiles.h"

#include "../IO/atomic_file.h"

#include <CGAL/Shape_correspondence/IO/collection_json.h>
#include <CGAL/Shape_correspondence/IO/matrix_files.h>
#include <CGAL/Shape_correspondence/IO/write_collection_html.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/nearest_shapes.h>
#include <CGAL/Shape_correspondence/topological_medoid.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <thread>

namespace CGAL {
namespace Shape_correspondence {
namespace cli {
namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

/// To be raised with every change that makes other energies or pairs of the same graphs and options.
constexpr int matching_version = 5;

constexpr std::size_t largest_clustered_whole = 100; // shapes whose maps are all clustered, unless told otherwise
constexpr std::size_t usual_neighbours = 32;         // else
constexpr std::size_t largest_bridged = 1000;        // shapes; bridges take cubic time
constexpr std::size_t listed_bridges = 100;

const char* const help_text =
    R"(Usage: shape_correspondence collection FOLDER [options]
       shape_correspondence collection SHAPE SHAPE... [options]

Matches all ordered pairs of a set of shapes, and tells which shape represents the set (its topological medoid), which
shapes are near one another (a minimum spanning tree), where a chain of shapes matches two of them better than they match
directly (bridges), and which parts correspond over the whole set (clusters, by Markov clustering).

The entries of FOLDER are the shapes: model files, folders of part meshes, and structural graphs (.json, .xml).

With --store, finished work is kept in a folder: run the same command again after it was stopped or killed, and it goes
on where it was; what depends on a changed shape or option is done anew. Several machines share the work:

  shape_correspondence collection FOLDER --store S --tile 1/3     ... 2/3, 3/3: a job each, in any order
  shape_correspondence collection FOLDER --store S --merge --json C.json

or, where the program was built with MPI, all at once:

  mpirun -n 8 shape_correspondence collection FOLDER --store S --json C.json

Examples: shape_correspondence collection chairs --json chairs.json --npy energies.npy
          shape_correspondence collection chairs --store work --html chairs.html --search exact
          shape_correspondence collection chairs --store work --nearest stool.obj -k 3

)";

/// The options that only this command has.
struct Collection_options
{
  std::string npy, csv, store, tile, nearest;
  bool merge = false, skip_bad = false;
  std::size_t block_size = 0, neighbours = 0, nearest_count = 5;
  double unmatched_energy = 0.5;
  Co_analysis_options co_analysis;
  std::size_t tile_number = 0, tile_count = 1;
};

po::options_description collection_options(Common_options& common, Collection_options& options)
{
  po::options_description result("Options of collection", 100, 68);
  auto add = result.add_options();
  add("json", po::value(&common.json)->value_name("FILE"), "write the result as JSON; - is standard output");
  add("npy", po::value(&options.npy)->value_name("FILE"),
      "write the energies, source by target, as a NumPy array of doubles");
  add("csv", po::value(&options.csv)->value_name("FILE"), "write the energies as a table with the shapes' names");
  add("html", po::value(&common.html)->value_name("FILE"),
      "write a web page that needs no network: pictures of all shapes, the medoid, the spanning tree, and the match of "
      "two shapes that are clicked (of more than 100 shapes, of near ones; of more than 1000 it shows 1000)");
  add("store", po::value(&options.store)->value_name("FOLDER"),
      "keep graphs and finished pairs in this folder, and take them from there; a must for very large collections, "
      "which then need memory for the energies alone");
  add("nearest", po::value(&options.nearest)->value_name("QUERY"),
      "find the shapes of the collection that are nearest to this one instead, without matching all; the result is "
      "written by --json");
  add("count,k", po::value(&options.nearest_count)->value_name("K")->default_value(options.nearest_count),
      "how many of them");
  add("tile", po::value(&options.tile)->value_name("I/N"),
      "do the I-th of N shares of the pairs and write no result: a job of an array; needs --store");
  add("merge", po::bool_switch(&options.merge), "match nothing, all pairs must be in the store");
  add("tile-size", po::value(&options.block_size)->value_name("N"),
      "shapes on a side of a tile, the least work that is kept; default: by the number of shapes, 64 at most");
  add("skip-bad", po::bool_switch(&options.skip_bad), "leave out inputs that cannot be used, with a warning");
  add("unmatched-energy",
      po::value(&options.unmatched_energy)->value_name("E")->default_value(options.unmatched_energy, "0.5"),
      "what a pair of connected parts counts of which one has no counterpart");
  add("inflation",
      po::value(&options.co_analysis.clustering.inflation)
          ->value_name("R")
          ->default_value(options.co_analysis.clustering.inflation, "2"),
      "of Markov clustering: more of it makes smaller clusters of parts");
  add("cycle-support",
      po::value(&options.co_analysis.least_cycle_support)
          ->value_name("S")
          ->default_value(options.co_analysis.least_cycle_support, "0.5"),
      "a pair of parts is clustered if this share of the third shapes that could confirm it do; 0: every pair");
  add("neighbours", po::value(&options.neighbours)->value_name("K"),
      "cluster the part maps of every shape with its K nearest ones only; default: with all of up to 100 shapes, with "
      "32 "
      "of more");
  return result;
}

/// Options of match that say nothing on a collection.
void refuse_options_of_pairs(const po::variables_map& values)
{
  for (const char* option : {"solutions", "min-marginals", "source-parts", "target-parts", "search-time-limit"}) {
    const auto& value = values[option];
    const bool is_given = !value.empty() && !value.defaulted();
    if (is_given) throw Usage_error("--" + std::string(option) + " is for a pair of shapes, not for a collection");
  }
}

void parse_tile(Collection_options& options)
{
  std::istringstream text(options.tile);
  char slash = 0;
  if (!(text >> options.tile_number >> slash >> options.tile_count) || slash != '/' || !text.eof() ||
      options.tile_number < 1 || options.tile_number > options.tile_count)
    throw Usage_error("--tile takes I/N with I from 1 to N, not '" + options.tile + "'");
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
  if (!options.nearest.empty() && (in_parts || options.merge || !(common.html + options.npy + options.csv).empty()))
    throw Usage_error("--nearest goes with --json and --store, not with shares of the work or files of all pairs");
  if (options.nearest_count < 1) throw Usage_error("-k must be at least 1");
  if (values.count("tile-size") && options.block_size < 1) throw Usage_error("--tile-size must be at least 1");
  if (values.count("neighbours") && options.neighbours < 1) throw Usage_error("--neighbours must be at least 1");
  if (!(options.unmatched_energy >= 0)) throw Usage_error("--unmatched-energy must not be negative");
  if (!(options.co_analysis.clustering.inflation > 1)) throw Usage_error("--inflation must be more than 1");
  if (!(options.co_analysis.least_cycle_support >= 0 && options.co_analysis.least_cycle_support <= 1))
    throw Usage_error("--cycle-support must be between 0 and 1");
  std::set<std::string> outputs{common.json, common.html};
  for (const std::string& file : {options.npy, options.csv}) {
    if (file.empty()) continue;
    if (!outputs.insert(file).second) throw Usage_error("two outputs are the same file, " + file);
    IO::check_writable(file);
  }
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

/// All that energies and pairs depend on besides the shapes.
std::string key_of(const Match_options& match, const Collection_options& options, const po::variables_map& values)
{
  Match_options names = match; // for their names alone
  std::ostringstream key;
  key << CGAL_SHAPE_CORRESPONDENCE_VERSION << '/' << matching_version << '\n'
      << text_of(match_options(names), values) << std::hexfloat << "unmatched-energy=" << options.unmatched_energy;
  return key.str();
}

/// The pairs of a collection, from the store or matched.
class Collection_work
{
public:
  Collection_work(const Collection_shapes& shapes, Tile_store& store, const std::string& key,
                  const Collection_options& options, const Energy_matrix_options& matching,
                  const Common_options& common)
      : store_(store), tiles_(shapes, key, options.block_size), options_(options), matching_(matching), common_(common)
  {}

  /// Matches what is missing of this share.
  void run(Team& team)
  {
    std::vector<std::size_t> todo;
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile)
      if (is_mine(tile) && !store_.has(tiles_.name(tile))) todo.push_back(tile);
    todo = team.from_first(std::move(todo)); // others may have begun
    std::vector<std::size_t> before;         // pairs, by place in the list
    std::size_t total = 0;
    for (std::size_t tile : todo) {
      before.push_back(total);
      total += tiles_.number_of_pairs(tile);
    }
    if (options_.merge && !todo.empty())
      throw Invalid_input(
          options_.store + ": " + std::to_string(total) +
          " pairs of shapes are missing; run the shares (--tile) that are not done, or leave --merge out");
    Common_options shown = common_;
    shown.quiet = common_.quiet || !team.is_first();
    Progress_bar bar(shown, "matching", "pair");
    team.for_each(todo.size(), [&](std::size_t k) {
      Energy_matrix_options matching = matching_;
      matching.progress = [&](std::size_t done, std::size_t) {
        bar.show(before[k] + done, total);
        return true;
      };
      store_.insert(tiles_.name(todo[k]), tiles_.computed(todo[k], matching));
    });
  }

  /// Calls `take` with every ordered pair and what it is.
  template <typename Take>
  void for_each_pair(const Take& take)
  {
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile) {
      const std::vector<std::pair<std::size_t, std::size_t>> pairs = tiles_.pairs(tile);
      std::optional<std::vector<Rated_map>> rated = store_.find(tiles_.name(tile));
      if (!rated || rated->size() != pairs.size()) { // damaged
        store_.insert(tiles_.name(tile), tiles_.computed(tile, matching_));
        rated = store_.find(tiles_.name(tile));
      }
      for (std::size_t k = 0; k < pairs.size(); ++k)
        take(pairs[k].first, pairs[k].second, (*rated)[k]);
    }
  }

private:
  bool is_mine(std::size_t tile) const
  {
    return options_.tile.empty() || tile % options_.tile_count + 1 == options_.tile_number;
  }

  Tile_store& store_;
  Tiles tiles_;
  const Collection_options& options_;
  const Energy_matrix_options& matching_;
  const Common_options& common_;
};

/// Ordered pairs of shapes.
using Pairs = std::set<std::pair<std::size_t, std::size_t>>;

/// The pairs of shapes whose maps are clustered, either way.
Pairs clustered_pairs(const Eigen::MatrixXd& distances, std::size_t neighbours)
{
  const auto n = std::size_t(distances.rows());
  if (neighbours == 0) neighbours = n > largest_clustered_whole ? usual_neighbours : n;
  Pairs pairs;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<std::pair<double, std::size_t>> others;
    for (std::size_t j = 0; j < n; ++j)
      if (j != i) others.emplace_back(distances(Eigen::Index(i), Eigen::Index(j)), j);
    const std::size_t k = std::min(neighbours, others.size());
    std::partial_sort(others.begin(), others.begin() + std::ptrdiff_t(k), others.end());
    for (std::size_t m = 0; m < k; ++m) {
      pairs.emplace(i, others[m].second);
      pairs.emplace(others[m].second, i);
    }
  }
  return pairs;
}

/// The ordered pairs for which a chain costs less, the largest gain first.
std::vector<IO::Collection::Bridge> bridges_of(const Eigen::MatrixXd& energies, const std::vector<Shape_pair>& tree)
{
  std::vector<IO::Collection::Bridge> result;
  for (std::size_t source = 0; source < std::size_t(energies.rows()); ++source) {
    std::vector<Shape_chain> chains = best_chains(energies, tree, source);
    for (std::size_t target = 0; target < chains.size(); ++target) {
      if (chains[target].is_direct()) continue;
      const double direct = energies(Eigen::Index(source), Eigen::Index(target));
      result.push_back({source, target, {std::move(chains[target]), direct, {}}});
    }
  }
  const auto gain = [](const IO::Collection::Bridge& bridge) {
    return bridge.correspondence.direct_energy - bridge.correspondence.chain.energy;
  };
  std::stable_sort(result.begin(), result.end(), [&](const auto& a, const auto& b) { return gain(a) > gain(b); });
  return result;
}

void add_chain(const Shape_chain& chain, Pairs& pairs)
{
  for (std::size_t k = 1; k < chain.shapes.size(); ++k)
    pairs.emplace(chain.shapes[k - 1], chain.shapes[k]);
}

Part_map composed_map(const Shape_chain& chain, const std::map<std::pair<std::size_t, std::size_t>, Part_map>& maps)
{
  Part_map map = maps.at({chain.shapes[0], chain.shapes[1]});
  for (std::size_t k = 2; k < chain.shapes.size(); ++k)
    map = composed(map, maps.at({chain.shapes[k - 1], chain.shapes[k]}));
  return map;
}

/// What is found out, and the maps that it is made of.
struct Analysis
{
  IO::Collection collection;
  std::vector<Shape_pair_map> maps;
};

Analysis analysed(const Collection_shapes& shapes, const Collection_options& options, Collection_work& work)
{
  Analysis analysis;
  IO::Collection& result = analysis.collection;
  result.warnings = shapes.skipped();
  std::vector<std::size_t> part_counts;
  for (const Collection_shape& shape : shapes.shapes()) {
    result.shapes.push_back({shape.name, shape.path, shape.parts});
    part_counts.push_back(shape.parts.size());
    for (const std::string& warning : shape.warnings)
      result.warnings.push_back(shape.path + ": " + warning);
  }
  const auto n = Eigen::Index(shapes.size());
  result.energies = Eigen::MatrixXd::Zero(n, n);
  work.for_each_pair([&](std::size_t i, std::size_t j, const Rated_map& rated) {
    result.energies(Eigen::Index(i), Eigen::Index(j)) = rated.energy;
  });
  const Eigen::MatrixXd distances = symmetric_distances(result.energies);
  result.medoid = topological_medoid(distances);
  result.tree = minimum_spanning_tree(distances);

  if (shapes.size() <= largest_bridged)
    result.bridges = bridges_of(result.energies, result.tree);
  else
    result.warnings.push_back("Bridges are looked for in collections of up to " + std::to_string(largest_bridged) +
                              " shapes only.");
  result.bridge_count = result.bridges.size();
  if (result.bridges.size() > listed_bridges) result.bridges.resize(listed_bridges);
  const Pairs clustered = clustered_pairs(distances, options.neighbours);
  Pairs wanted = clustered;
  for (const IO::Collection::Bridge& bridge : result.bridges)
    add_chain(bridge.correspondence.chain, wanted);

  std::map<std::pair<std::size_t, std::size_t>, Part_map> maps;
  work.for_each_pair([&](std::size_t i, std::size_t j, const Rated_map& rated) {
    if (wanted.count({i, j})) maps[{i, j}] = rated.map;
  });
  for (IO::Collection::Bridge& bridge : result.bridges)
    bridge.correspondence.map = composed_map(bridge.correspondence.chain, maps);
  for (const auto& [i, j] : clustered)
    analysis.maps.push_back({i, j, std::move(maps.at({i, j}))});
  result.co_analysis = co_analysis(part_counts, analysis.maps, options.co_analysis);
  result.co_analysis_shape_pairs = clustered.size() / 2;
  return analysis;
}

void print_collection(const IO::Collection& collection)
{
  const Eigen::MatrixXd distances = symmetric_distances(collection.energies);
  const auto n = std::size_t(distances.rows());
  std::vector<std::vector<std::string>> rows{{"shape", "parts", "mean distance", "nearest", "distance"}};
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t nearest = i == 0 ? 1 : 0;
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const double d = distances(Eigen::Index(i), Eigen::Index(j));
      sum += d;
      if (j != i && d < distances(Eigen::Index(i), Eigen::Index(nearest))) nearest = j;
    }
    rows.push_back({collection.shapes[i].name, std::to_string(collection.shapes[i].parts.size()),
                    short_number(sum / double(n - 1)), collection.shapes[nearest].name,
                    short_number(distances(Eigen::Index(i), Eigen::Index(nearest)))});
  }
  write_table(std::cout, rows);
  std::cout << "\nmedoid: " << collection.shapes[collection.medoid].name
            << "\nclusters of parts: " << collection.co_analysis.number_of_labels << " over "
            << collection.co_analysis.part_pairs << " pairs of parts, " << collection.co_analysis.rejected_pairs
            << " more rejected\nordered pairs of shapes that a chain matches at less energy: "
            << collection.bridge_count << '\n';
  for (const std::string& warning : collection.warnings)
    std::cout << "warning: " << warning << '\n';
}

void write_outputs(const Analysis& analysis, const Collection_shapes& shapes, const Common_options& common,
                   const Collection_options& options)
{
  const IO::Collection& collection = analysis.collection;
  std::vector<std::string> names;
  for (const IO::Collection::Shape& shape : collection.shapes)
    names.push_back(shape.name);
  if (!common.json.empty())
    IO::write_atomically(common.json, [&](std::ostream& out) { IO::write_collection_json(out, collection); });
  if (!common.html.empty())
    IO::write_atomically(common.html, [&](std::ostream& out) {
      IO::write_collection_html(
          out, collection, [&](std::size_t i) { return shapes.graph(i); }, analysis.maps);
    });
  if (!options.npy.empty())
    IO::write_atomically(options.npy, [&](std::ostream& out) { IO::write_npy(out, collection.energies); });
  if (!options.csv.empty())
    IO::write_atomically(options.csv, [&](std::ostream& out) { IO::write_csv(out, collection.energies, names); });
  if (!common.prints_table()) return;
  print_collection(collection);
  if (!common.html.empty() && collection.shapes.size() > IO::largest_pictured)
    std::cout << common.html << ": shows " << IO::largest_pictured << " of the " << collection.shapes.size()
              << " shapes; the file of --json has all\n";
}

/// The shapes nearest to a query instead of all pairs.
void find_nearest(const Collection_shapes& shapes, const Collection_options& options,
                  const Energy_matrix_options& matching, const Common_options& common)
{
  const Structural_graph query = load_shape(options.nearest, common).graph;
  IO::Nearest_in_collection found;
  found.query = {structure(query).name, options.nearest, part_names(query)};
  for (const Collection_shape& shape : shapes.shapes())
    found.shapes.push_back({shape.name, shape.path, shape.parts});
  found.warnings = shapes.skipped();
  found.nearest = nearest_shapes<CGAL::Parallel_if_available_tag>(
      query, shapes.size(), [&](std::size_t i) { return shapes.graph(i); }, options.nearest_count, matching);
  if (!common.json.empty())
    IO::write_atomically(common.json, [&](std::ostream& out) { IO::write_nearest_json(out, found); });
  if (!common.prints_table()) return;
  std::vector<std::vector<std::string>> rows{{"nearest", "distance", "pairs of parts"}};
  for (const Near_shape& near : found.nearest.shapes)
    rows.push_back({found.shapes[near.shape].name, short_number(near.distance), std::to_string(near.map.pairs.size())});
  write_table(std::cout, rows);
  std::cout << "\nmatched with " << found.nearest.evaluations << " of " << shapes.size() << " shapes\n";
}

/// Processes on one machine share its processors.
int number_of_threads(const Common_options& common, const Team& team)
{
  const std::size_t processes = team.size_here();
  if (common.threads > 0 || processes == 1) return common.threads;
  return int(std::max<std::size_t>(1, std::thread::hardware_concurrency() / processes));
}

} // namespace

void run_collection(const std::vector<std::string>& arguments)
{
  Common_options common;
  Match_options match;
  Collection_options options;
  po::options_description all;
  all.add(collection_options(common, options))
      .add(match_options(match))
      .add(model_options(common))
      .add(common_options(common));
  const Arguments parsed = parse(arguments, all, 1, any_number);
  if (parsed.help) {
    std::cout << help_text << all;
    return;
  }
  Energy_matrix_options matching;
  matching.search = search_options(match, parsed.values);
  matching.unmatched_energy = options.unmatched_energy;
  check(common);
  check(options, common, parsed.values);
  Team team;
  if (team.size() > 1 && options.store.empty())
    throw Usage_error("several processes need --store, a folder that all reach");
  const Thread_limit limit(number_of_threads(common, team));
  const std::string store_folder = options.store;
  Tile_store store(store_folder.empty() ? "" : (fs::path(store_folder) / "tiles").string());
  if (common.cache.empty() && !store_folder.empty()) common.cache = (fs::path(store_folder) / "cache").string();
  const Collection_shapes shapes(collection_paths(parsed.inputs),
                                 store_folder.empty() ? "" : (fs::path(store_folder) / "graphs").string(),
                                 options.skip_bad, common, team);
  if (!options.nearest.empty()) {
    if (team.is_first()) find_nearest(shapes, options, matching, common);
    return;
  }
  Collection_work work(shapes, store, key_of(match, options, parsed.values), options, matching, common);
  work.run(team);
  if (options.tile.empty() && team.is_first()) write_outputs(analysed(shapes, options, work), shapes, common, options);
}

} // namespace cli
} // namespace Shape_correspondence
} // namespace CGAL
