// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/collection_shapes.h"

#include <CGAL/Shape_correspondence/energy_matrix.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// All ordered pairs of a collection, cut into tiles: the pairs of two blocks of shapes, either way. Every tile is
/// named by all that its result depends on, so that one whose shapes or options changed is another tile.
class Tiles
{
public:
  /// \param key says what results depend on besides the shapes \param block_size shapes; 0: some that suit the number
  Tiles(const Collection_shapes& shapes, const std::string& key, std::size_t block_size);

  std::size_t size() const { return tiles_.size(); }
  const std::string& name(std::size_t tile) const { return tiles_[tile].name; }
  std::vector<std::pair<std::size_t, std::size_t>> pairs(std::size_t tile) const;
  std::size_t number_of_pairs(std::size_t tile) const;

  /// Matches the pairs of a tile, in their order. The shapes of the last tile are kept, of which the next one mostly
  /// has a block.
  std::vector<Rated_map> computed(std::size_t tile, const Energy_matrix_options& options);

private:
  struct Range
  {
    std::size_t begin, end;
  };
  struct Tile
  {
    Range rows, columns;
    std::string name;

    bool is_diagonal() const { return rows.begin == columns.begin; }
  };
  /// Shapes that are read and prepared; these refer to the graphs.
  struct Block
  {
    std::size_t begin;
    std::vector<Structural_graph> graphs;
    std::vector<Prepared_shape> prepared;
  };
  using Shared_block = std::shared_ptr<const Block>;

  Shared_block block(const Range& shapes) const;

  const Collection_shapes& shapes_;
  std::vector<Tile> tiles_;
  std::vector<Shared_block> kept_; // of the last tile
};

} // namespace CGAL::Shape_correspondence::cli
