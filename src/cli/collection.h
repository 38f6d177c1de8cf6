// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"

#include <CGAL/Shape_correspondence/IO/collection_json.h>
#include <CGAL/Shape_correspondence/Search_options.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>
#include <CGAL/Shape_correspondence/co_analysis.h>
#include <CGAL/Shape_correspondence/energy_matrix.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// The processes that work on a collection: this one, or those started by `mpirun` (`team_mpi.cpp`). All processes of a
/// team make the same calls in the same order.
class Team
{
public:
  virtual ~Team() = default;

  virtual std::size_t size() const { return 1; }
  virtual bool is_first() const { return true; }
  /// Number of processes on this machine.
  virtual std::size_t size_here() const { return 1; }

  /// Calls `work` with each number from 0 to n - 1, distributed in order over the processes as they become free;
  /// returns when all calls are done. \throw Invalid_input in all processes if `work` throws in one of them
  virtual void for_each(std::size_t n, const std::function<void(std::size_t)>& work)
  {
    for (std::size_t i = 0; i < n; ++i)
      work(i);
  }

  /// The texts passed by all processes.
  virtual std::vector<std::string> gathered(const std::string& text) { return {text}; }
  /// The numbers passed by the first process.
  virtual std::vector<std::size_t> from_first(std::vector<std::size_t> numbers) { return numbers; }
};

/// Creates the team of this process; `shape_correspondence_mpi` replaces this function.
/// \throw Usage_error
extern std::unique_ptr<Team> (*make_team)();

/// A shape of a collection, without its graph.
struct Collection_shape
{
  std::string path, name;
  std::string content; ///< digest of its graph, on which all results depend
  std::vector<std::string> parts;
  std::vector<std::string> warnings;
};

/// The paths of the shapes: the inputs themselves, or the entries of a single folder, by name: model files, structural
/// graphs, and folders of part meshes. \throw Invalid_input if there are fewer than two
/// \param left_out receives the names of entries that are not shapes; may be null
std::vector<std::string> collection_paths(const std::vector<std::string>& inputs,
                                          std::vector<std::string>* left_out = nullptr);

/// Whether a folder contains shapes: folders of part meshes, or model files that have several objects each.
bool is_folder_of_shapes(const std::string& path);

/// The shapes in a folder, sorted by path. \param left_out receives the names of the other entries; may be null
std::vector<std::string> shapes_in(const std::string& folder, std::vector<std::string>* left_out = nullptr);

/// The structural graphs of a collection, loaded on demand from a folder or kept in memory.
class Collection_shapes
{
public:
  /// Builds the missing graphs, distributed over the processes of the team.
  /// \param folder for graphs; empty: they are kept in memory \param skip_bad whether to leave out unusable inputs
  /// \throw Invalid_input, naming all unusable inputs, if there are any
  Collection_shapes(const std::vector<std::string>& paths, const std::string& folder, bool skip_bad,
                    const Common_options& options, Team& team);

  /// Takes graphs that are already built, with their paths.
  explicit Collection_shapes(const std::vector<std::pair<std::string, Structural_graph>>& graphs);

  const std::vector<Collection_shape>& shapes() const { return shapes_; }
  /// The inputs left out, with the reasons.
  const std::vector<std::string>& skipped() const { return skipped_; }
  std::size_t size() const { return shapes_.size(); }
  Structural_graph graph(std::size_t shape) const;
  /// The surfaces of a shape, read again; none if its input is a graph or has different parts by now.
  std::optional<Segmented_shape> model(std::size_t shape, const Common_options& options) const;

private:
  std::string folder_;
  std::vector<Collection_shape> shapes_;
  std::vector<std::string> skipped_;
  std::map<std::size_t, Structural_graph> graphs_; // by shape; with a folder, those of the first shapes only
};

struct Collection_options
{
  std::string npy, csv, store, nearest, labels_from, labels_to; ///< files and folders; empty: none
  bool skip_bad = false, matches = false, agreeing = false;
  std::size_t nearest_count = 5;
  std::size_t neighbours = 0; ///< number of nearest shapes of a shape, the maps to which are clustered; 0: automatic
  double unmatched_energy = Energy_matrix_options().unmatched_energy;
  Co_analysis_options co_analysis;
};

/// Adds the options of `collection` and those for output files to the table.
void add_collection_options(Option_table& table, Common_options& common, Collection_options& options);

/// Finished rows of `Collection_work` as bytes, by name, in a folder or in memory. In a folder a row exists completely
/// or not at all, even if the program is killed, and several processes may share it. A damaged row counts as missing.
class Row_store
{
public:
  /// A store in a folder, which is created if missing; in memory if `folder` is empty.
  /// \throw Invalid_input if the folder cannot be used
  explicit Row_store(std::string folder);

  std::string find(const std::string& name) const; ///< the bytes of a row; empty: missing or damaged
  bool is_damaged(const std::string& name) const;
  void insert(const std::string& name, const std::string& bytes);

private:
  std::string path(const std::string& name) const;

  std::string folder_;
  std::map<std::string, std::string> in_memory_;
};

/// A text with everything that the matches of a collection depend on besides the shapes.
/// \param match_options names and values of the options \param search only its roles are used
std::string key_of(const std::string& match_options, const Search_options& search, double unmatched_energy);

/// All ordered pairs of a collection, matched or read from a store. The store has a row for every shape: its pairs, in
/// both directions, with the shapes after it. A row is identified by its shape and the options, and its pairs by the
/// other shapes, so that only the pairs of a changed shape are missing.
class Collection_work
{
public:
  /// \param store a folder; empty: in memory \param key see `key_of()`
  Collection_work(const Collection_shapes& shapes, const std::string& store, const std::string& key,
                  const Energy_matrix_options& matching, const Common_options& common);

  /// Matches the missing pairs, distributed over the processes of the team.
  void run(Team& team);

  /// Calls `take` with source, target, energy and map of every ordered pair; the map is empty if it is not wanted.
  /// Confidences are rounded to 16 bits.
  void for_each_pair(const std::function<bool(std::size_t, std::size_t)>& wants_map,
                     const std::function<void(std::size_t, std::size_t, const Rated_map&)>& take);

private:
  struct Kept_shape
  {
    std::unique_ptr<Structural_graph> graph;
    Prepared_shape prepared;
    std::size_t last_request = 0;
  };

  const std::string& content(std::size_t shape) const { return shapes_.shapes()[shape].content; }
  /// The shapes after `row` whose pairs are not in the row's bytes.
  std::vector<std::size_t> missing(std::size_t row, const std::string& bytes) const;
  /// The shapes, prepared for matching; those of the last calls are kept in memory.
  std::vector<Prepared_shape> prepared(const std::vector<std::size_t>& shapes);
  /// Matches and stores the missing pairs of some rows. \param progress called with the number of pairs matched so far
  void match(const std::vector<std::size_t>& rows, const std::function<void(std::size_t)>& progress);

  const Collection_shapes& shapes_;
  Row_store store_;
  const Energy_matrix_options& matching_;
  const Common_options& common_;
  std::vector<std::string> names_; // file names of rows, indexed by shape
  std::map<std::size_t, Kept_shape> kept_;
  std::size_t requests_ = 0;
  bool is_backward_ = false; // whether the next rows are matched from the last column to the first
};

/// The distances of a shape to all others: their mean, and the nearest shape.
struct Shape_distances
{
  double mean = 0;
  std::size_t nearest = 0;
  double nearest_distance = 0;
};

/// The analysis of a collection, with the energies and maps that it is computed from.
struct Analysis
{
  Eigen::MatrixXd energies;
  std::vector<Shape_distances> distances; ///< indexed by shape
  IO::Collection collection;              ///< refers to `energies`
  std::vector<Shape_pair_map> maps;
};

/// Analyses a collection in two passes over all pairs: the first takes the energies, the second the maps of pairs that
/// are clustered or in bridges (chains of matches). Memory for n shapes: 16 n² bytes for energies and distances, some
/// hundred bytes for each of at most 64 n maps (by default), and that of `co_analysis()`.
Analysis analysed(const Collection_shapes& shapes, const Collection_options& options, Collection_work& work);

/// The shapes nearest to a query. \param file name of the query in the result
IO::Nearest_in_collection nearest_in_collection(const Structural_graph& query, const std::string& file,
                                                const Collection_shapes& shapes, std::size_t count,
                                                const Energy_matrix_options& matching);

/// Transfers the labels of the shape given by `--labels-from` to all shapes of a collection, and writes them.
void transfer_labels(const Collection_shapes& shapes, const Collection_options& options, const Search_options& search,
                     const Common_options& common);

} // namespace CGAL::Shape_correspondence::cli
