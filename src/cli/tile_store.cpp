// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/tile_store.h"
#include "io/system/atomic_file.h"
#include "io/system/checked_file.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>

namespace CGAL::Shape_correspondence::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* extension = ".tile";

using Small = std::uint16_t; // confidences
constexpr double largest_confidence = 65535;

/// Writes the bytes of a tile. Whole numbers are in LEB128: seven bits per byte, the low ones first.
class Byte_writer
{
public:
  template <typename Number>
  void write(const Number& number)
  {
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof number);
  }

  void write_count(std::size_t number)
  {
    for (; number > 127; number >>= 7)
      bytes_ += char((number & 127) | 128);
    bytes_ += char(number);
  }

  std::string bytes() && { return std::move(bytes_); }

private:
  std::string bytes_;
};

/// Reads the bytes of a tile; knows at the end whether all were used.
class Byte_reader
{
public:
  explicit Byte_reader(const std::string& bytes) : bytes_(bytes) {}

  template <typename Number>
  Number read()
  {
    Number number{};
    if (bytes_.size() - at_ < sizeof number) {
      failed_ = true;
      return number;
    }
    std::memcpy(&number, bytes_.data() + at_, sizeof number);
    at_ += sizeof number;
    return number;
  }

  std::size_t read_count()
  {
    std::size_t number = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      const auto byte = read<unsigned char>();
      number |= std::size_t(byte & 127) << shift;
      if (byte < 128) return number;
    }
    failed_ = true;
    return 0;
  }

  bool is_at_end() const { return failed_ || at_ == bytes_.size(); }
  bool is_good() const { return !failed_; }

private:
  const std::string& bytes_;
  std::size_t at_ = 0;
  bool failed_ = false;
};

// Stands in the place of the number of pairs plus 1: the map is the one before, inverted.
constexpr std::size_t inverse_of_last = 0;

Small as_small(double confidence) { return Small(std::lround(confidence * largest_confidence)); }

/// Of pairs that are sorted by source.
void write_map(const Part_map& map, Byte_writer& out)
{
  out.write_count(map.pairs.size() + 1);
  std::size_t last_source = 0;
  for (const Part_correspondence& pair : map.pairs) {
    out.write_count(pair.source - last_source);
    out.write_count(pair.target);
    out.write(as_small(pair.confidence));
    last_source = pair.source;
  }
}

Part_map read_map(std::size_t size, Byte_reader& in)
{
  Part_map map;
  std::size_t source = 0;
  for (std::size_t k = 0; k < size && in.is_good(); ++k) {
    source += in.read_count();
    const std::size_t target = in.read_count();
    map.pairs.push_back({source, target, in.read<Small>() / largest_confidence});
  }
  return map;
}

std::string encoded(const std::vector<Rated_map>& pairs)
{
  Byte_writer out;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    out.write(pairs[k].energy);
    if (k % 2 == 1 && pairs[k].map == inverse(pairs[k - 1].map))
      out.write_count(inverse_of_last);
    else
      write_map(pairs[k].map, out);
  }
  return std::move(out).bytes();
}

std::optional<std::vector<Rated_map>> decoded(const std::string& bytes)
{
  Byte_reader in(bytes);
  std::vector<Rated_map> pairs;
  while (!in.is_at_end()) {
    Rated_map pair;
    pair.energy = in.read<double>();
    const std::size_t size = in.read_count();
    if (size == inverse_of_last && pairs.empty()) return std::nullopt;
    pair.map = size == inverse_of_last ? inverse(pairs.back().map) : read_map(size - 1, in);
    pairs.push_back(std::move(pair));
  }
  if (!in.is_good()) return std::nullopt;
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
