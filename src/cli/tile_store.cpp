// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/tile_store.h"
#include "io/system/atomic_file.h"
#include "io/system/checked_file.h"
#include "io/system/little_endian.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string_view>

namespace CGAL::Shape_correspondence::cli {
namespace {

namespace fs = std::filesystem;

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
  return (fs::path(folder_) / (name + extension)).string();
}

bool Tile_store::has(const std::string& name) const
{
  return folder_.empty() ? in_memory_.count(name) > 0 : fs::exists(path(name));
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
    IO::write_checked_file(path(name), title(name), bytes);
}

} // namespace CGAL::Shape_correspondence::cli
