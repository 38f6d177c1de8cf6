// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/tiles.h"
#include "io/system/digest.h"

#include <algorithm>

namespace CGAL::Shape_correspondence::cli {
namespace {

constexpr std::size_t least_block = 4, largest_block = 128, usual_blocks = 8;

std::size_t usual_block_size(std::size_t shapes)
{
  return std::clamp((shapes + usual_blocks - 1) / usual_blocks, least_block, largest_block);
}

} // namespace

Tiles::Tiles(const Collection_shapes& shapes, const std::string& key, std::size_t block_size) : shapes_(shapes)
{
  if (block_size == 0) block_size = usual_block_size(shapes.size());
  std::vector<Range> blocks;
  std::vector<std::string> contents;
  for (std::size_t begin = 0; begin < shapes.size(); begin += block_size) {
    blocks.push_back({begin, std::min(begin + block_size, shapes.size())});
    contents.emplace_back();
    for (std::size_t i = begin; i < blocks.back().end; ++i)
      contents.back() += shapes.shapes()[i].content + '\n';
  }
  for (std::size_t i = 0; i < blocks.size(); ++i)
    for (std::size_t j = i; j < blocks.size(); ++j)
      tiles_.push_back({blocks[i], blocks[j], IO::digest(key + '\n' + contents[i] + '\n' + contents[j])});
}

std::vector<std::pair<std::size_t, std::size_t>> Tiles::pairs(std::size_t tile) const
{
  const Tile& t = tiles_[tile];
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (std::size_t i = t.rows.begin; i < t.rows.end; ++i)
    for (std::size_t j = t.is_diagonal() ? i + 1 : t.columns.begin; j < t.columns.end; ++j) {
      result.emplace_back(i, j);
      result.emplace_back(j, i);
    }
  return result;
}

std::size_t Tiles::number_of_pairs(std::size_t tile) const
{
  const Tile& t = tiles_[tile];
  const std::size_t rows = t.rows.end - t.rows.begin, columns = t.columns.end - t.columns.begin;
  return t.is_diagonal() ? rows * (rows - 1) : 2 * rows * columns;
}

Tiles::Shared_block Tiles::block(const Range& shapes) const
{
  for (const Shared_block& kept : kept_)
    if (kept->begin == shapes.begin) return kept;
  auto result = std::make_shared<Block>();
  result->begin = shapes.begin;
  for (std::size_t i = shapes.begin; i < shapes.end; ++i)
    result->graphs.push_back(shapes_.graph(i));
  for (const Structural_graph& graph : result->graphs)
    result->prepared.emplace_back(graph);
  return result;
}

std::vector<Rated_map> Tiles::computed(std::size_t tile, const Energy_matrix_options& options)
{
  const Tile& t = tiles_[tile];
  std::vector<Shared_block> blocks{block(t.rows)};
  kept_.erase(std::remove_if(kept_.begin(), kept_.end(),
                             [&](const Shared_block& kept) { return kept->begin != t.columns.begin; }),
              kept_.end()); // no more than two are in memory
  if (!t.is_diagonal()) blocks.push_back(block(t.columns));
  kept_ = blocks;

  std::vector<Prepared_shape> shapes;
  for (const Shared_block& block : blocks)
    for (const Prepared_shape& shape : block->prepared)
      shapes.push_back(shape);
  const auto local = [&](std::size_t shape) {
    const bool is_row = shape >= t.rows.begin && shape < t.rows.end;
    return is_row ? shape - t.rows.begin : shape - t.columns.begin + (t.rows.end - t.rows.begin);
  };
  std::vector<std::pair<std::size_t, std::size_t>> local_pairs;
  for (const auto& [i, j] : pairs(tile))
    local_pairs.emplace_back(local(i), local(j));
  return match_pairs<CGAL::Parallel_if_available_tag>(shapes, local_pairs, options);
}

} // namespace CGAL::Shape_correspondence::cli
