// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/collection.h"
#include "cli/Command.h"
#include "cli/Common_options.h"
#include "cli/jobs.h"
#include "cli/load_shape.h"
#include "cli/run.h"
#include "io/system/quoting.h"

#include <CGAL/Shape_correspondence/IO/collection_json.h>
#include <CGAL/Shape_correspondence/IO/matrix_files.h>
#include <CGAL/Shape_correspondence/IO/write_collection_html.h>
#include <CGAL/Shape_correspondence/nearest_shapes.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <thread>

namespace CGAL::Shape_correspondence::cli {
namespace {

namespace fs = std::filesystem;

const char* const collection_help =
    R"(Usage: shape_correspondence collection FOLDER [options]
       shape_correspondence collection SHAPE SHAPE... [options]

Matches all ordered pairs of a set of shapes and computes
  - the distance of each pair: its deformation energy per pair of connected parts. A pair with a part without
    counterpart counts --unmatched-energy;
  - the topological medoid, the shape with the least sum of distances, and a minimum spanning tree;
  - pairs of shapes that are matched better by way of a third one (bridges);
  - clusters of parts that correspond over the whole set, by Markov clustering.

The entries of FOLDER are the shapes: model files, folders of part meshes, and structural graphs (.json). Others
are left out, with a note.

With --labels-from, one labelled shape is matched with each shape of the set, and its labels are transferred to them.

With --store, finished work is kept in a folder. If a run was stopped, the same command continues it. Results that depend
on a changed shape or option are computed again. Several processes and machines can share the work if the package was
built with MPI. All of them need access to the folder:

  mpirun -n 8 shape_correspondence_mpi collection FOLDER --store S --json C.json

Examples: shape_correspondence collection chairs -o chairs.json -o distances.npy
          shape_correspondence collection chairs --store work -o chairs.html --search exact
          shape_correspondence collection chairs --store work --nearest stool.obj -k 3
          shape_correspondence collection chairs --labels-from my_chair --labels-to labels

)";

void print_collection(const Analysis& analysis, bool verbose)
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
  write_notes(std::cout, collection.warnings, verbose);
}

/// The number of threads of each process, since processes on one machine share its processors. \return 0: no limit
int threads_of_process(const Common_options& common, const Team& team)
{
  const std::size_t processes = team.size_here();
  if (common.threads > 0 || processes == 1) return 0;
  return int(std::max<std::size_t>(1, std::thread::hardware_concurrency() / processes));
}

/// Refuses to run as one of several processes, each of which would do all the work.
std::unique_ptr<Team> this_process()
{
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) // set by Open MPI and by MPICH
    if (const char* size = std::getenv(variable); size && std::atoi(size) > 1)
      throw Usage_error("to share the work among processes, `mpirun` takes the program shape_correspondence_mpi, which "
                        "is built with -DSHAPE_CORRESPONDENCE_MPI=ON");
  return std::make_unique<Team>();
}

class Collection_command : public Command
{
public:
  Collection_command() : Command(collection_help, 1, any_number)
  {
    add_collection_options(table, common, options_);
    add_match_options(table, match_);
    add_model_options(table, common);
    add_common_options(table, common);
  }

private:
  /// Whether any output for all pairs is requested besides --json.
  bool has_files() const { return !(common.html + options_.npy + options_.csv).empty(); }

  void check() override
  {
    for (const Option& option : table.options())
      if (option.is_given && option.is_for_pairs) refuse_option(option.name, "on a set of shapes");
    matching_.search = search_options(match_, table);
    take_graphs_of_paper(match_, table, common.structure);
    matching_.unmatched_energy = options_.unmatched_energy;
    if (table.is_given("count") && options_.nearest.empty()) throw Usage_error("-k has no effect without --nearest");
    if (!options_.nearest.empty() && (has_files() || options_.matches))
      throw Usage_error("--nearest goes with --json and --store, not with files of all pairs");
    if (!options_.labels_to.empty() && options_.labels_from.empty())
      refuse_option("labels-to", "without --labels-from");
    if (!options_.labels_from.empty() &&
        (has_files() || options_.matches || options_.agreeing || !options_.nearest.empty()))
      throw Usage_error("--labels-from goes with --labels-to, --json and --store, not with --nearest or files of all "
                        "pairs");
    if (options_.matches && common.json.empty()) refuse_option("matches", "without --json");
    if (options_.agreeing && !options_.matches && common.html.empty())
      refuse_option("agreeing", "without --matches or --html");
    paths_ = collection_paths(inputs, &left_out_);
  }

  std::vector<std::string> input_files() const override
  {
    std::vector<std::string> result = paths_;
    result.push_back(options_.nearest);
    return result;
  }

  /// The path of a folder in the store; empty if there is no store.
  std::string stored(const char* name) const
  {
    return options_.store.empty() ? "" : (fs::path(options_.store) / name).string();
  }

  void work() override
  {
    const std::unique_ptr<Team> made = make_team();
    Team& team = *made;
    if (team.size() > 1 && options_.store.empty())
      throw Usage_error("several processes need --store, a folder that all of them can use");
    if (!team.is_first()) common.progress = "never"; // the first process shows the progress of all
    std::shared_ptr<void> limit = limit_threads(threads_of_process(common, team));
    if (!left_out_.empty() && team.is_first())
      warn(common, inputs[0] + ": left out, since they are no shapes: " + listed(left_out_));
    for (const std::string& left_out :
         add_examples(match_.examples, common, matching_.search.roles, matching_.search.category))
      if (team.is_first()) warn(common, left_out);
    common.roles = matching_.search.roles;
    common.keeps_reading = !common.cache.empty(); // a cache in the store keeps graphs only, or it would grow too large
    if (common.cache.empty()) common.cache = stored("cache");
    const Collection_shapes shapes(paths_, stored("graphs"), options_.skip_bad, common, team);
    if (!options_.nearest.empty()) {
      if (team.is_first()) find_nearest(shapes);
    } else if (!options_.labels_from.empty()) {
      if (team.is_first()) transfer_labels(shapes, options_, matching_.search, common);
    } else {
      Collection_work work(shapes, stored("pairs"), key(), matching_, common);
      work.run(team);
      limit.reset(); // no other process of the machine has work left, so this one takes all threads
      if (team.is_first()) write_outputs(analysed(shapes, options_, work), shapes);
    }
  }

  /// A key of everything that energies and pairs depend on besides the shapes.
  std::string key() const
  {
    const Search_options& search = matching_.search;
    const std::string category = match_.examples.empty() ? "" : "category=" + search.category;
    return key_of(table.values_of(match_group), search, matching_.unmatched_energy) + category;
  }

  /// Finds the shapes nearest to a query instead of matching all pairs.
  void find_nearest(const Collection_shapes& shapes) const
  {
    const IO::Nearest_in_collection found = nearest_in_collection(
        load_shape(options_.nearest, common).graph, options_.nearest, shapes, options_.nearest_count, matching_);
    write_output(common.json, [&](std::ostream& out) { IO::write_nearest_json(out, found); });
    if (!common.prints_table()) return;
    std::vector<std::vector<std::string>> rows{{"nearest", "category", "distance", "pairs of parts"}};
    for (const Near_shape& near : found.nearest.shapes)
      rows.push_back({found.shapes[near.shape].name, near.category.empty() ? "-" : near.category,
                      short_number(near.distance), std::to_string(near.map.pairs.size())});
    write_table(std::cout, rows);
    if (!found.nearest.category.empty()) std::cout << "\ncategory of the query: " << found.nearest.category;
    std::cout << "\nmatched with " << found.nearest.evaluations << " of " << shapes.size() << " shapes\n";
  }

  void write_outputs(const Analysis& analysis, const Collection_shapes& shapes) const
  {
    const IO::Collection& collection = analysis.collection;
    const std::vector<std::string> names = mapped(collection.shapes, &IO::Collection::Shape::name);
    write_output(common.json, [&](std::ostream& out) { IO::write_collection_json(out, collection); });
    write_output(common.html, [&](std::ostream& out) {
      IO::write_collection_html(
          out, collection, [&](std::size_t i) { return shapes.graph(i); }, analysis.maps,
          [&](std::size_t i) { return shapes.model(i, common); });
    });
    write_output(options_.npy, [&](std::ostream& out) { IO::write_npy(out, analysis.energies); });
    write_output(options_.csv, [&](std::ostream& out) { IO::write_csv(out, analysis.energies, names); });
    if (!common.prints_table()) return;
    print_collection(analysis, common.verbose);
    if (!common.html.empty() && names.size() > IO::largest_pictured)
      std::cout << IO::quote_terminal(common.html) << ": shows " << IO::largest_pictured << " of the " << names.size()
                << " shapes; the file of --json has all\n";
  }

  Match_options match_;
  Collection_options options_;
  Energy_matrix_options matching_;
  std::vector<std::string> paths_;
  std::vector<std::string> left_out_; // entries of the folder that are not shapes
};

} // namespace

std::unique_ptr<Team> (*make_team)() = this_process;

void add_collection_options(Option_table& table, Common_options& common, Collection_options& options)
{
  Option_table::Group add = table.group("Options of collection");
  add("output,o", "FILE",
      output_by_ending(
          {{".html", &common.html}, {".json", &common.json}, {".npy", &options.npy}, {".csv", &options.csv}}),
      "what --html, --json, --npy or --csv writes, by the ending of FILE; can be repeated");
  add("json", "FILE", &common.json, "write the result as JSON; - is standard output").output();
  add("npy", "FILE", &options.npy, "write the distances, source by target, as a NumPy array of doubles")
      .output()
      .rare();
  add("csv", "FILE", &options.csv, "write the distances as a table with the names of the shapes").output().rare();
  add("html", "FILE", &common.html,
      "write a web page with the shapes, the medoid, the spanning tree, and the match of any two shapes that are "
      "clicked (of more than 100 shapes: of near ones; of more than 1000 shapes it shows 1000); it needs no network")
      .output();
  add("matches", &options.matches,
      "write the corresponding parts of all pairs of shapes to --json, too (of more than 100 shapes: of near ones)")
      .rare()
      .in_python();
  add("agreeing", &options.agreeing,
      "keep only pairs of parts that are in one cluster, in --matches and on the page of --html: fewer pairs, which "
      "are right more often")
      .rare()
      .in_python();
  add("store", "FOLDER", &options.store,
      "keep graphs and finished pairs in this folder and reuse them; recommended for large sets, of which graphs "
      "and pairs then need not fit into memory")
      .in_python();
  add("nearest", "QUERY", &options.nearest,
      "find the shapes of the set that are nearest to this one instead, without matching all pairs: those of its "
      "category first, if --roles know it, then those of none that is known");
  add("count,k", "K", &options.nearest_count, "how many shapes --nearest finds").at_least(1);
  add("labels-from", "SHAPE", &options.labels_from,
      "transfer the labels of this shape to the set instead: a folder with labels.json and parts, one mesh file for "
      "each part. Each part gets the label of the part to which it corresponds most probably");
  add("labels-to", "FOLDER", &options.labels_to,
      "write FOLDER/NAME/labels.json for each shape of --labels-from, with the probability of each label");
  add("skip-bad", &options.skip_bad, "leave out inputs that cannot be used, with a note").rare();
  add("unmatched-energy", "E", &options.unmatched_energy,
      "energy of a pair of connected parts of which one has no counterpart")
      .at_least(0)
      .rare()
      .in_python();
  add("inflation", "R", &options.co_analysis.clustering.inflation,
      "inflation of Markov clustering, more than 1; larger values make smaller clusters of parts")
      .more_than(1)
      .rare()
      .in_python();
  add("cycle-support", "S", &options.co_analysis.least_cycle_support,
      "use a pair of parts for clustering if at least this share of third shapes confirm it, between 0 and 1; 0: use "
      "all")
      .between(0, 1)
      .rare()
      .in_python("least_cycle_support");
  add("neighbours", "K", &options.neighbours,
      "cluster with the part maps of each shape to its K nearest ones only; default: all for up to 100 shapes, else "
      "32")
      .at_least(1)
      .without_default()
      .rare()
      .in_python();
}

std::unique_ptr<Command> collection_command() { return std::make_unique<Collection_command>(); }

} // namespace CGAL::Shape_correspondence::cli
