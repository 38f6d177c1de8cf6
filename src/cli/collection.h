// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"
#include "cli/team.h"

#include <CGAL/Shape_correspondence/IO/collection_json.h>
#include <CGAL/Shape_correspondence/Search_options.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>
#include <CGAL/Shape_correspondence/co_analysis.h>
#include <CGAL/Shape_correspondence/energy_matrix.h>

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// A shape of a collection; its graph is kept elsewhere.
struct Collection_shape
{
  std::string path, name;
  std::string content; ///< digest of its graph: what all results depend on
  std::vector<std::string> parts;
  std::vector<std::string> warnings;
};

/// The shapes that inputs name: each an input, or the entries of a single folder, by name. Of a folder these are model
/// files, structural graphs, and folders of part meshes. \throw Invalid_input if they are less than two
/// \param left_out gets the names of entries that are no shapes; null: not wanted
std::vector<std::string> collection_paths(const std::vector<std::string>& inputs,
                                          std::vector<std::string>* left_out = nullptr);

/// Whether a folder has shapes: folders of part meshes, or model files of several objects, which no part has.
bool is_folder_of_shapes(const std::string& path);

/// The shapes in a folder, sorted by path. \param left_out gets the names of the other entries; null: not wanted
std::vector<std::string> shapes_in(const std::string& folder, std::vector<std::string>* left_out = nullptr);

/// The structural graphs of a collection, on demand: in a folder or, without one, in memory.
class Collection_shapes
{
public:
  /// Builds the graphs that are missing, all processes of the team together.
  /// \param folder for graphs; empty: in memory \param skip_bad leave out inputs that cannot be used
  /// \throw Invalid_input if an input cannot be used; names all of these
  Collection_shapes(const std::vector<std::string>& paths, const std::string& folder, bool skip_bad,
                    const Common_options& options, Team& team);

  /// Of graphs that are built already, by path.
  explicit Collection_shapes(const std::vector<std::pair<std::string, Structural_graph>>& graphs);

  const std::vector<Collection_shape>& shapes() const { return shapes_; }
  /// What was left out and why.
  const std::vector<std::string>& skipped() const { return skipped_; }
  std::size_t size() const { return shapes_.size(); }
  Structural_graph graph(std::size_t shape) const;
  /// The surfaces of a shape, read anew; none if its input is a graph or has other parts by now.
  std::optional<Segmented_shape> model(std::size_t shape, const Common_options& options) const;

private:
  std::string folder_;
  std::vector<Collection_shape> shapes_;
  std::vector<std::string> skipped_;
  std::vector<Structural_graph> graphs_; // in memory
};

/// The options that only `collection` has.
struct Collection_options
{
  std::string npy, csv, store, nearest, labels_from, labels_to; ///< empty: none
  bool skip_bad = false, matches = false, agreeing = false;
  std::size_t nearest_count = 5;
  std::size_t neighbours = 0; ///< 0: by the number of shapes
  double unmatched_energy = Energy_matrix_options().unmatched_energy;
  Co_analysis_options co_analysis;
};

/// Adds these options and the options for output files to the table of a command.
void add_collection_options(Option_table& table, Common_options& common, Collection_options& options);

/// Finished rows by name, as bytes, in a folder or, without one, in memory. In a folder a row is there as a whole or
/// not at all, whenever the program is killed, and many processes may use it at a time. One that is damaged counts as
/// missing.
class Row_store
{
public:
  /// \param folder is made if there is none; empty: in memory \throw Invalid_input if it cannot be used
  explicit Row_store(std::string folder);

  std::string find(const std::string& name) const; ///< empty: missing or damaged
  bool is_damaged(const std::string& name) const;
  void insert(const std::string& name, const std::string& bytes);

private:
  std::string path(const std::string& name) const;

  std::string folder_;
  std::map<std::string, std::string> in_memory_;
};

/// All that the matches of a collection depend on besides the shapes, as a text.
/// \param match_options their names and values \param search only its roles are used
std::string key_of(const std::string& match_options, const Search_options& search, double unmatched_energy);

/// All ordered pairs of a collection, matched or from a store, which has a row for every shape: its pairs, either way,
/// with the shapes that come after it. A row is named by its shape and the options, and its pairs by the other shapes,
/// so that of a changed shape only its own pairs are missing.
class Collection_work
{
public:
  /// \param store a folder; empty: in memory \param key see `key_of()`
  Collection_work(const Collection_shapes& shapes, const std::string& store, const std::string& key,
                  const Energy_matrix_options& matching, const Common_options& common);

  /// Matches what is missing, all processes of the team together.
  void run(Team& team);

  /// Calls `take` with source, target, energy and map of every ordered pair. Confidences are kept to 16 bits.
  void for_each_pair(const std::function<void(std::size_t, std::size_t, const Rated_map&)>& take);

private:
  const std::string& content(std::size_t shape) const { return shapes_.shapes()[shape].content; }
  /// The shapes after `row` whose pairs are not in its bytes.
  std::vector<std::size_t> missing(std::size_t row, const std::string& bytes) const;
  /// Matches what is missing in some rows and stores them. \param progress gets the number of pairs that were matched
  void match(const std::vector<std::size_t>& rows, const std::function<void(std::size_t)>& progress);

  const Collection_shapes& shapes_;
  Row_store store_;
  const Energy_matrix_options& matching_;
  const Common_options& common_;
  std::vector<std::string> names_; // of rows, by shape
};

/// A shape's distances from the others.
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
  std::vector<Shape_distances> distances; ///< by shape
  IO::Collection collection;              ///< refers to the energies
  std::vector<Shape_pair_map> maps;
};

/// Reads all pairs twice, first the energies and then those maps that are clustered or on bridges. Memory for n shapes:
/// 16 n² bytes for energies and distances, some hundred bytes for each of 64 n maps at most, and that of
/// `co_analysis()`.
Analysis analysed(const Collection_shapes& shapes, const Collection_options& options, Collection_work& work);

/// The shapes nearest to a query. \param file names it in the result
IO::Nearest_in_collection nearest_in_collection(const Structural_graph& query, const std::string& file,
                                                const Collection_shapes& shapes, std::size_t count,
                                                const Energy_matrix_options& matching);

/// Transfers the labels of the shape of `--labels-from` to all shapes of a collection, and writes them.
void transfer_labels(const Collection_shapes& shapes, const Collection_options& options, const Search_options& search,
                     const Common_options& common);

} // namespace CGAL::Shape_correspondence::cli
