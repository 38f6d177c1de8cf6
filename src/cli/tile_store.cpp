// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/tile_store.h"
#include "io/atomic_file.h"
#include "io/checked_file.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>

namespace CGAL::Shape_correspondence::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* extension = ".tile";

using Small = std::uint16_t; // numbers of parts, and confidences
constexpr double largest = 65535;

template <typename Number>
void append(const Number& number, std::string& bytes)
{
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// Numbers out of bytes; says at the end whether they were as many as were there.
class Byte_reader
{
public:
  explicit Byte_reader(const std::string& bytes) : bytes_(bytes) {}

  template <typename Number>
  Number next()
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

  bool is_at_end() const { return failed_ || at_ == bytes_.size(); }
  bool is_good() const { return !failed_; }

private:
  const std::string& bytes_;
  std::size_t at_ = 0;
  bool failed_ = false;
};

Small small(std::size_t number)
{
  if (number > std::size_t(largest)) throw Invalid_input("a shape of more than 65536 parts fits no collection");
  return Small(number);
}

std::string encoded(const std::vector<Rated_map>& pairs)
{
  std::string bytes;
  for (const Rated_map& pair : pairs) {
    append(pair.energy, bytes);
    append(std::uint32_t(pair.map.pairs.size()), bytes);
    for (const Part_correspondence& parts : pair.map.pairs) {
      append(small(parts.source), bytes);
      append(small(parts.target), bytes);
      append(Small(std::lround(parts.confidence * largest)), bytes);
    }
  }
  return bytes;
}

std::optional<std::vector<Rated_map>> decoded(const std::string& bytes)
{
  Byte_reader in(bytes);
  std::vector<Rated_map> pairs;
  while (!in.is_at_end()) {
    Rated_map pair;
    pair.energy = in.next<double>();
    const auto size = in.next<std::uint32_t>();
    for (std::uint32_t k = 0; k < size && in.is_good(); ++k) {
      const Small source = in.next<Small>(), target = in.next<Small>();
      pair.map.pairs.push_back({source, target, in.next<Small>() / largest});
    }
    pairs.push_back(std::move(pair));
  }
  if (!in.is_good()) return std::nullopt;
  return pairs;
}

std::string title(const std::string& name) { return "shape_correspondence tile " + name; }

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
