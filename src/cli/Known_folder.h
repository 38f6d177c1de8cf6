// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>

#include <optional>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// A folder of part meshes of which the cache may have the graph, under the bytes of its files: nothing is parsed to
/// find it. Of other inputs, and where options make other parts of the files, the cache knows nothing in this way.
class Known_folder
{
public:
  /// Reads the files.
  Known_folder(std::string path, const Common_options& common, const Structure_options& options);

  /// The graph with the warnings of its reader; none if the cache does not have it, or its files are damaged.
  std::optional<Structural_graph> find() const;

  /// Keeps which graph of the cache it is. \param warnings of the reader
  void keep(const Structural_graph& graph, const std::vector<std::string>& warnings) const;

private:
  std::string key() const;
  std::string entry() const;

  std::string path_, cache_;
  std::string options_; ///< hash of those that the graph depends on
  std::string key_;     ///< empty: nothing is known
};

} // namespace CGAL::Shape_correspondence::cli
