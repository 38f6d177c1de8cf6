// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/collection.h"
#include "cli/run.h"
#include "cli/text.h"
#include "io/system/atomic_file.h"
#include "io/system/checked_file.h"
#include "io/system/little_endian.h"

#include <CGAL/Shape_correspondence/Role_model.h>
#include <CGAL/Shape_correspondence/version.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <sstream>
#include <string_view>

namespace CGAL::Shape_correspondence::cli {
namespace {

/// Raise it with every change that makes other energies or pairs of the same graphs and options.
constexpr int matching_version = 9;

// Shapes on a side of a tile
constexpr std::size_t least_block = 4, largest_block = 128;
constexpr std::size_t usual_blocks = 8; // of a collection

std::size_t block_size(std::size_t shapes)
{
  return std::clamp((shapes + usual_blocks - 1) / usual_blocks, least_block, largest_block);
}

constexpr const char* extension = ".tile";

using Small = std::uint16_t; // confidences
constexpr double largest_confidence = 65535;

/// Whole numbers are in LEB128: seven bits per byte, the low ones first.
void append_count(std::string& bytes, std::size_t number)
{
  for (; number > 127; number >>= 7)
    bytes += char((number & 127) | 128);
  bytes += char(number);
}

/// Thrown where a tile ends too early, or has a number that is too large.
struct Damaged_tile
{};

/// Takes a number from the front.
template <typename Number>
Number read(std::string_view& bytes)
{
  if (bytes.size() < sizeof(Number)) throw Damaged_tile();
  const auto number = IO::number_in<Number>(bytes.data());
  bytes.remove_prefix(sizeof number);
  return number;
}

std::size_t read_count(std::string_view& bytes)
{
  std::size_t number = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    const auto byte = read<unsigned char>(bytes);
    number |= std::size_t(byte & 127) << shift;
    if (byte < 128) return number;
  }
  throw Damaged_tile();
}

// Stands in the place of the number of pairs plus 1: the map is the one before, inverted.
constexpr std::size_t inverse_of_last = 0;

Small as_small(double confidence) { return Small(std::lround(confidence * largest_confidence)); }

/// Of pairs that are sorted by source.
void append_map(std::string& bytes, const Part_map& map)
{
  append_count(bytes, map.pairs.size() + 1);
  std::size_t last_source = 0;
  for (const Part_correspondence& pair : map.pairs) {
    append_count(bytes, pair.source - last_source);
    append_count(bytes, pair.target);
    IO::append_little_endian(bytes, as_small(pair.confidence));
    last_source = pair.source;
  }
}

Part_map read_map(std::size_t size, std::string_view& bytes)
{
  Part_map map;
  std::size_t source = 0;
  for (std::size_t k = 0; k < size; ++k) {
    source += read_count(bytes);
    const std::size_t target = read_count(bytes);
    map.pairs.push_back({source, target, read<Small>(bytes) / largest_confidence});
  }
  return map;
}

std::string encoded(const std::vector<Rated_map>& pairs)
{
  std::string bytes;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    IO::append_little_endian(bytes, pairs[k].energy);
    if (k % 2 == 1 && pairs[k].map == inverse(pairs[k - 1].map))
      append_count(bytes, inverse_of_last);
    else
      append_map(bytes, pairs[k].map);
  }
  return bytes;
}

std::optional<std::vector<Rated_map>> decoded(std::string_view bytes)
{
  std::vector<Rated_map> pairs;
  try {
    while (!bytes.empty()) {
      Rated_map pair;
      pair.energy = read<double>(bytes);
      const std::size_t size = read_count(bytes);
      if (size == inverse_of_last && pairs.empty()) return std::nullopt;
      pair.map = size == inverse_of_last ? inverse(pairs.back().map) : read_map(size - 1, bytes);
      pairs.push_back(std::move(pair));
    }
  } catch (const Damaged_tile&) {
    return std::nullopt;
  }
  return pairs;
}

std::string title(const std::string& name) { return "shape_correspondence tile 2 " + name; }

} // namespace

Tile_store::Tile_store(std::string folder) : folder_(std::move(folder))
{
  if (folder_.empty()) return;
  IO::make_folder(folder_, "a store");
  IO::remove_leftovers(folder_);
}

std::string Tile_store::path(const std::string& name) const
{
  return (std::filesystem::path(folder_) / (name + extension)).string();
}

bool Tile_store::has(const std::string& name) const
{
  return folder_.empty() ? in_memory_.count(name) > 0 : std::filesystem::exists(path(name));
}

std::optional<std::vector<Rated_map>> Tile_store::find(const std::string& name) const
{
  if (folder_.empty()) {
    const auto found = in_memory_.find(name);
    return found == in_memory_.end() ? std::nullopt : decoded(found->second);
  }
  const std::optional<std::string> bytes = IO::read_checked_file(path(name), title(name));
  return bytes ? decoded(*bytes) : std::nullopt;
}

void Tile_store::insert(const std::string& name, const std::vector<Rated_map>& pairs)
{
  std::string bytes = encoded(pairs);
  if (folder_.empty())
    in_memory_[name] = std::move(bytes);
  else
    IO::write_checked_entry(path(name), title(name), bytes);
}

std::string key_of(const std::string& match_options, const Search_options& search, double unmatched_energy)
{
  std::ostringstream key;
  key << CGAL_SHAPE_CORRESPONDENCE_VERSION << '/' << matching_version << '\n'
      << match_options << std::hexfloat << "unmatched-energy=" << unmatched_energy;
  if (search.roles) {
    std::ostringstream roles;
    search.roles->write(roles);
    key << "roles=" << IO::digest(roles.str());
  }
  return key.str();
}

Collection_work::Collection_work(const Collection_shapes& shapes, const std::string& store, const std::string& key,
                                 const Energy_matrix_options& matching, const Common_options& common)
    : shapes_(shapes), store_(store), matching_(matching), common_(common)
{
  const std::size_t size = block_size(shapes.size());
  std::vector<Range> blocks;
  std::vector<std::string> contents;
  for (std::size_t begin = 0; begin < shapes.size(); begin += size) {
    blocks.push_back({begin, std::min(begin + size, shapes.size())});
    contents.emplace_back();
    for (std::size_t i = begin; i < blocks.back().end; ++i)
      contents.back() += shapes.shapes()[i].content + '\n';
  }
  for (std::size_t i = 0; i < blocks.size(); ++i)
    for (std::size_t j = i; j < blocks.size(); ++j)
      tiles_.push_back({blocks[i], blocks[j], IO::digest(key + '\n' + contents[i] + '\n' + contents[j])});
}

std::vector<std::pair<std::size_t, std::size_t>> Collection_work::Tile::pairs() const
{
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (std::size_t i = rows.begin; i < rows.end; ++i)
    for (std::size_t j = is_diagonal() ? i + 1 : columns.begin; j < columns.end; ++j) {
      result.emplace_back(i, j);
      result.emplace_back(j, i);
    }
  return result;
}

void Collection_work::run(Team& team)
{
  std::vector<std::size_t> missing;
  for (std::size_t tile = 0; tile < tiles_.size(); ++tile)
    if (!store_.has(tiles_[tile].name)) missing.push_back(tile);
  missing = team.from_first(std::move(missing)); // others may have begun
  std::vector<std::size_t> before{0};            // pairs, by place in the list
  for (std::size_t tile : missing)
    before.push_back(before.back() + tiles_[tile].pairs().size());
  Progress_bar bar(common_, "matching", "pair");
  team.for_each(missing.size(), [&](std::size_t k) {
    Energy_matrix_options matching = matching_;
    matching.progress = [&](std::size_t done, std::size_t) {
      bar.show(before[k] + done, before.back());
      return true;
    };
    match(tiles_[missing[k]], matching);
  });
}

void Collection_work::for_each_pair(const std::function<void(std::size_t, std::size_t, const Rated_map&)>& take)
{
  for (const Tile& tile : tiles_) {
    const std::vector<std::pair<std::size_t, std::size_t>> pairs = tile.pairs();
    std::optional<std::vector<Rated_map>> rated = store_.find(tile.name);
    if (!rated || rated->size() != pairs.size()) {
      warn(common_, "a tile of the store is damaged; it is made again");
      match(tile, matching_);
      rated = store_.find(tile.name);
    }
    for (std::size_t k = 0; k < pairs.size(); ++k)
      take(pairs[k].first, pairs[k].second, (*rated)[k]);
  }
}

Collection_work::Shared_block Collection_work::block(const Range& shapes) const
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

void Collection_work::match(const Tile& tile, const Energy_matrix_options& options)
{
  std::vector<Shared_block> blocks{block(tile.rows)};
  kept_.erase(std::remove_if(kept_.begin(), kept_.end(),
                             [&](const Shared_block& kept) { return kept->begin != tile.columns.begin; }),
              kept_.end()); // no more than two are in memory
  if (!tile.is_diagonal()) blocks.push_back(block(tile.columns));
  kept_ = blocks;

  std::vector<Prepared_shape> shapes;
  for (const Shared_block& block : blocks)
    for (const Prepared_shape& shape : block->prepared)
      shapes.push_back(shape);
  const auto local = [&](std::size_t shape) {
    const bool is_row = shape >= tile.rows.begin && shape < tile.rows.end;
    return is_row ? shape - tile.rows.begin : shape - tile.columns.begin + (tile.rows.end - tile.rows.begin);
  };
  const auto pairs =
      mapped(tile.pairs(), [&](const auto& pair) { return std::pair(local(pair.first), local(pair.second)); });
  store_.insert(tile.name, match_pairs<CGAL::Parallel_if_available_tag>(shapes, pairs, options));
}

} // namespace CGAL::Shape_correspondence::cli
