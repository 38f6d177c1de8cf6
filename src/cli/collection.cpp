// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/collection_analysis.h"
#include "cli/collection_options.h"
#include "cli/collection_shapes.h"
#include "cli/collection_work.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/load_shape.h"
#include "cli/outputs.h"
#include "cli/run_report.h"
#include "cli/text_table.h"
#include "cli/thread_limit.h"
#include "cli/transfer_labels.h"
#include "io/system/quoting.h"

#include <CGAL/Shape_correspondence/IO/collection_json.h>
#include <CGAL/Shape_correspondence/IO/matrix_files.h>
#include <CGAL/Shape_correspondence/IO/write_collection_html.h>
#include <CGAL/Shape_correspondence/nearest_shapes.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <thread>

namespace CGAL::Shape_correspondence::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

const char* const help_text =
    R"(Usage: shape_correspondence collection FOLDER [options]
       shape_correspondence collection SHAPE SHAPE... [options]

Matches all ordered pairs of a set of shapes and computes
  - the distance of each pair: its deformation energy per pair of connected parts, where a part without counterpart
    counts --unmatched-energy;
  - the topological medoid, the shape with the least sum of distances, and a minimum spanning tree;
  - pairs of shapes that are matched better by way of a third one (bridges);
  - clusters of parts that correspond over the whole set, by Markov clustering.

The entries of FOLDER are the shapes: model files, folders of part meshes, and structural graphs (.json, .xml).

With --labels-from, the labels of one shape are transferred to all shapes of the set instead, by matching it with each.

With --store, finished work is kept in a folder. A run that was stopped or killed continues where it was when the same
command is run again; what depends on a changed shape or option is computed again. Several machines can share the work:

  shape_correspondence collection FOLDER --store S --tile 1/3     and 2/3, 3/3: one job each, in any order
  shape_correspondence collection FOLDER --store S --merge --json C.json

or, if the program was built with MPI:

  mpirun -n 8 shape_correspondence collection FOLDER --store S --json C.json

Examples: shape_correspondence collection chairs --json chairs.json --npy distances.npy
          shape_correspondence collection chairs --store work --html chairs.html --search exact
          shape_correspondence collection chairs --store work --nearest stool.obj -k 3
          shape_correspondence collection chairs --labels-from my_chair --labels-to labels

)";

void print_collection(const Analysis& analysis)
{
  const IO::Collection& collection = analysis.collection;
  std::vector<std::vector<std::string>> rows{{"shape", "parts", "mean distance", "nearest", "distance"}};
  for (std::size_t i = 0; i < collection.shapes.size(); ++i) {
    const Shape_distances& distances = analysis.distances[i];
    rows.push_back({collection.shapes[i].name, std::to_string(collection.shapes[i].parts.size()),
                    short_number(distances.mean), collection.shapes[distances.nearest].name,
                    short_number(distances.nearest_distance)});
  }
  write_table(std::cout, rows);
  std::cout << "\nmedoid: " << IO::quote_terminal(collection.shapes[collection.medoid].name)
            << "\nclusters of parts: " << collection.co_analysis.number_of_labels << " over "
            << collection.co_analysis.part_pairs << " pairs of parts, " << collection.co_analysis.rejected_pairs
            << " rejected\nordered pairs of shapes with a bridge: " << collection.bridge_count << '\n';
  for (const std::string& warning : collection.warnings)
    std::cout << "warning: " << IO::quote_terminal(warning) << '\n';
}

void write_outputs(const Analysis& analysis, const Collection_shapes& shapes, const Common_options& common,
                   const Collection_options& options)
{
  const IO::Collection& collection = analysis.collection;
  std::vector<std::string> names;
  for (const IO::Collection::Shape& shape : collection.shapes)
    names.push_back(shape.name);
  write_output(common.json, [&](std::ostream& out) { IO::write_collection_json(out, collection); });
  write_output(common.html, [&](std::ostream& out) {
    IO::write_collection_html(
        out, collection, [&](std::size_t i) { return shapes.graph(i); }, analysis.maps,
        [&](std::size_t i) { return shapes.model(i, common); });
  });
  write_output(options.npy, [&](std::ostream& out) { IO::write_npy(out, *analysis.energies); });
  write_output(options.csv, [&](std::ostream& out) { IO::write_csv(out, *analysis.energies, names); });
  if (!common.prints_table()) return;
  print_collection(analysis);
  if (!common.html.empty() && collection.shapes.size() > IO::largest_pictured)
    std::cout << IO::quote_terminal(common.html) << ": shows " << IO::largest_pictured << " of the "
              << collection.shapes.size() << " shapes; the file of --json has all\n";
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
  write_output(common.json, [&](std::ostream& out) { IO::write_nearest_json(out, found); });
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

struct Variables
{
  Common_options common;
  Match_options match;
  Collection_options options;
};

po::options_description all_options(Variables& v)
{
  po::options_description result;
  result.add(collection_options(v.common, v.options))
      .add(match_options(v.match))
      .add(model_options(v.common))
      .add(common_options(v.common));
  return result;
}

} // namespace

Command_help help_of_collection()
{
  static Variables unused;
  return {help_text, all_options(unused)};
}

void run_collection(const std::vector<std::string>& arguments)
{
  Variables variables;
  Common_options& common = variables.common;
  Match_options& match = variables.match;
  Collection_options& options = variables.options;
  const Arguments parsed = parse(arguments, all_options(variables), 1, any_number);
  if (parsed.help) return write_help(std::cout, command_of("collection"));
  const Run_report report(common);
  Energy_matrix_options matching;
  matching.search = search_options(match, parsed.values);
  matching.unmatched_energy = options.unmatched_energy;
  check(common);
  check(options, common, parsed.values);
  const std::vector<std::string> paths = collection_paths(parsed.inputs);
  std::vector<std::string> inputs = paths;
  inputs.push_back(options.nearest);
  check_outputs({common.json, common.html, options.npy, options.csv}, inputs);
  Team team;
  if (team.size() > 1 && options.store.empty())
    throw Usage_error("several processes need --store, a folder that all of them can use");
  const Thread_limit limit(number_of_threads(common, team));
  add_examples(match, common, matching.search);
  common.roles = matching.search.roles;
  const std::string store_folder = options.store;
  Tile_store store(store_folder.empty() ? "" : (fs::path(store_folder) / "tiles").string());
  if (common.cache.empty() && !store_folder.empty()) common.cache = (fs::path(store_folder) / "cache").string();
  const Collection_shapes shapes(paths, store_folder.empty() ? "" : (fs::path(store_folder) / "graphs").string(),
                                 options.skip_bad, common, team);
  if (!options.nearest.empty()) {
    if (team.is_first()) find_nearest(shapes, options, matching, common);
    return;
  }
  if (!options.labels_from.empty()) {
    if (team.is_first()) transfer_labels(shapes, options, matching.search, common);
    return;
  }
  Collection_work work(shapes, store, key_of(match, matching.search, options, parsed.values), options, matching,
                       common);
  work.run(team);
  if (options.tile.empty() && team.is_first()) write_outputs(analysed(shapes, options, work), shapes, common, options);
}

} // namespace CGAL::Shape_correspondence::cli
