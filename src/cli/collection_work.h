// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/collection_options.h"
#include "cli/collection_shapes.h"
#include "cli/outputs.h"
#include "cli/team.h"
#include "cli/tile_store.h"
#include "cli/tiles.h"

#include <CGAL/Shape_correspondence/energy_matrix.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

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
  void run(Team& team);

  /// Calls `take` with every ordered pair and what it is.
  template <typename Take>
  void for_each_pair(const Take& take)
  {
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile) {
      const std::vector<std::pair<std::size_t, std::size_t>> pairs = tiles_.pairs(tile);
      std::optional<std::vector<Rated_map>> rated = store_.find(tiles_.name(tile));
      if (!rated || rated->size() != pairs.size()) {
        warn(common_, "a tile of the store is damaged; it is made again");
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

} // namespace CGAL::Shape_correspondence::cli
