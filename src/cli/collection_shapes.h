// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"
#include "cli/team.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <cstddef>
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

} // namespace CGAL::Shape_correspondence::cli
