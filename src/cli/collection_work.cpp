// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/collection.h"
#include "cli/run.h"
#include "io/system/atomic_file.h"
#include "io/system/bytes.h"

#include <CGAL/Shape_correspondence/Role_model.h>
#include <CGAL/Shape_correspondence/version.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string_view>

namespace CGAL::Shape_correspondence::cli {
namespace {

/// To be increased with every change that alters energies or pairs for the same graphs and options.
constexpr int matching_version = 9;

// Limits for the rows, and columns, matched at a time: their shapes are in memory; a killed process loses these rows
constexpr std::size_t least_block = 4, largest_block = 64;
constexpr std::size_t most_kept_shapes = 512; // largest set whose prepared shapes, some 1.2 MB each, are all kept
constexpr std::size_t blocks_of_process = 8;  // number of blocks of rows for each process, within the limits

constexpr const char* extension = ".row";
constexpr const char* damaged = "a row of pairs of the store is damaged; it is made again";

using Small = std::uint16_t;                 // holds indices of at most 2000 parts, sizes and confidences
constexpr double largest_confidence = 65535; // stored value of confidence 1

/// Thrown if a row ends too early.
struct Damaged_row
{};

/// Removes a number from the front of `bytes` and returns it.
template <typename Number>
Number read(std::string_view& bytes)
{
  if (bytes.size() < sizeof(Number)) throw Damaged_row();
  const auto number = IO::number_in<Number>(bytes.data());
  bytes.remove_prefix(sizeof number);
  return number;
}

std::string_view read_text(std::size_t size, std::string_view& bytes)
{
  if (bytes.size() < size) throw Damaged_row();
  const std::string_view text = bytes.substr(0, size);
  bytes.remove_prefix(size);
  return text;
}

std::string encoded(const Rated_map& rated)
{
  std::string bytes;
  IO::append_little_endian(bytes, rated.energy);
  for (const Part_correspondence& pair : rated.map.pairs)
    for (Small number :
         {Small(pair.source), Small(pair.target), Small(std::lround(pair.confidence * largest_confidence))})
      IO::append_little_endian(bytes, number);
  return bytes;
}

Rated_map decoded(std::string_view bytes, bool with_map)
{
  Rated_map rated;
  rated.energy = read<double>(bytes);
  while (with_map && !bytes.empty()) {
    const std::size_t source = read<Small>(bytes), target = read<Small>(bytes);
    rated.map.pairs.push_back({source, target, read<Small>(bytes) / largest_confidence});
  }
  return rated;
}

/// The encoded matches from a row's shape to another shape, and back.
using Both_ways = std::array<std::string_view, 2>;

/// The matches in the bytes of a row, by the digest of the other shape; empty if the row is damaged.
std::map<std::string_view, Both_ways> pairs_in(std::string_view bytes)
{
  std::map<std::string_view, Both_ways> result;
  try {
    while (!bytes.empty()) {
      const std::string_view content = read_text(read<Small>(bytes), bytes);
      for (std::string_view& way : result[content])
        way = read_text(read<std::uint32_t>(bytes), bytes);
    }
  } catch (const Damaged_row&) {
    result.clear();
  }
  return result;
}

void append_pairs(std::string& bytes, const std::string& content, const Rated_map& there, const Rated_map& back)
{
  IO::append_little_endian(bytes, Small(content.size()));
  bytes += content;
  for (const Rated_map* rated : {&there, &back}) {
    const std::string way = encoded(*rated);
    IO::append_little_endian(bytes, std::uint32_t(way.size()));
    bytes += way;
  }
}

std::string title(const std::string& name) { return "shape_correspondence row 1 " + name; }

} // namespace

Row_store::Row_store(std::string folder) : folder_(std::move(folder))
{
  if (!folder_.empty()) IO::make_folder(folder_, "a store");
}

std::string Row_store::path(const std::string& name) const
{
  return (std::filesystem::path(folder_) / (name + extension)).string();
}

std::string Row_store::find(const std::string& name) const
{
  if (!folder_.empty()) return IO::read_checked_file(path(name), title(name)).value_or("");
  const auto found = in_memory_.find(name);
  return found == in_memory_.end() ? "" : found->second;
}

bool Row_store::is_damaged(const std::string& name) const
{
  std::error_code error;
  return !folder_.empty() && std::filesystem::exists(path(name), error) && find(name).empty();
}

void Row_store::insert(const std::string& name, const std::string& bytes)
{
  if (folder_.empty())
    in_memory_[name] = bytes;
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
  for (std::size_t i = 0; i < shapes.size(); ++i)
    names_.push_back(IO::digest(key + '\n' + content(i)));
}

std::vector<std::size_t> Collection_work::missing(std::size_t row, const std::string& bytes) const
{
  const std::map<std::string_view, Both_ways> known = pairs_in(bytes);
  std::vector<std::size_t> result;
  for (std::size_t other = row + 1; other < shapes_.size(); ++other)
    if (known.count(content(other)) == 0) result.push_back(other);
  return result;
}

void Collection_work::run(Team& team)
{
  std::vector<std::size_t> rows;
  std::set<std::string> seen; // equal shapes share the row of the first
  for (std::size_t row = 0; row + 1 < shapes_.size(); ++row) {
    if (!seen.insert(names_[row]).second || missing(row, store_.find(names_[row])).empty()) continue;
    rows.push_back(row);
    if (team.is_first() && store_.is_damaged(names_[row])) warn(common_, damaged);
  }
  rows = team.from_first(std::move(rows)); // other processes may have started storing rows
  const std::size_t blocks = blocks_of_process * team.size();
  const std::size_t size = std::clamp((shapes_.size() + blocks - 1) / blocks, least_block, largest_block);
  std::vector<std::vector<std::size_t>> bands;
  std::vector<std::size_t> before{0}; // cumulative number of pairs, by band
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (k % size == 0) bands.emplace_back(), before.push_back(before.back());
    bands.back().push_back(rows[k]);
    before.back() += 2 * (shapes_.size() - 1 - rows[k]); // upper bound
  }
  Progress_bar bar(common_, "matching", "pair");
  team.for_each(bands.size(), [&](std::size_t k) {
    match(bands[k], [&](std::size_t done) { bar.show(std::min(before[k] + done, before[k + 1]), before.back()); });
    bar.show(before[k + 1], before.back());
  });
  kept_.clear();
}

void Collection_work::for_each_pair(const std::function<bool(std::size_t, std::size_t)>& wants_map,
                                    const std::function<void(std::size_t, std::size_t, const Rated_map&)>& take)
{
  for (std::size_t row = 0; row + 1 < shapes_.size(); ++row) {
    std::string bytes = store_.find(names_[row]);
    if (!missing(row, bytes).empty()) {
      warn(common_, damaged);
      match({row}, {});
      bytes = store_.find(names_[row]);
    }
    const std::map<std::string_view, Both_ways> pairs = pairs_in(bytes);
    for (std::size_t other = row + 1; other < shapes_.size(); ++other) {
      const Both_ways& ways = pairs.at(content(other));
      take(row, other, decoded(ways[0], wants_map(row, other)));
      take(other, row, decoded(ways[1], wants_map(other, row)));
    }
  }
}

std::vector<Prepared_shape> Collection_work::prepared(const std::vector<std::size_t>& shapes)
{
  ++requests_;
  std::size_t missing = 0;
  for (std::size_t shape : shapes)
    if (const auto kept = kept_.find(shape); kept == kept_.end())
      ++missing;
    else
      kept->second.last_request = requests_;
  const std::size_t most = shapes_.size() > most_kept_shapes ? 2 * largest_block : most_kept_shapes;
  const auto is_older = [](const auto& a, const auto& b) { return a.second.last_request < b.second.last_request; };
  while (!kept_.empty() && kept_.size() + missing > most) {
    const auto oldest = std::min_element(kept_.begin(), kept_.end(), is_older);
    if (oldest->second.last_request == requests_) break;
    kept_.erase(oldest);
  }
  std::vector<Prepared_shape> result;
  for (std::size_t shape : shapes) {
    auto kept = kept_.find(shape);
    if (kept == kept_.end()) {
      auto graph = std::make_unique<Structural_graph>(shapes_.graph(shape));
      const Prepared_shape of_graph(*graph);
      kept = kept_.emplace(shape, Kept_shape{std::move(graph), of_graph, requests_}).first;
    }
    result.push_back(kept->second.prepared);
  }
  return result;
}

void Collection_work::match(const std::vector<std::size_t>& rows, const std::function<void(std::size_t)>& progress)
{
  std::vector<std::string> bytes;
  std::vector<std::vector<std::size_t>> missing_in; // indexed by row
  std::set<std::size_t> all_columns;
  for (std::size_t row : rows) {
    bytes.push_back(store_.find(names_[row]));
    if (pairs_in(bytes.back()).empty()) bytes.back().clear();
    missing_in.push_back(missing(row, bytes.back()));
    all_columns.insert(missing_in.back().begin(), missing_in.back().end());
  }
  std::vector<std::size_t> columns(all_columns.begin(), all_columns.end());
  if (is_backward_) std::reverse(columns.begin(), columns.end());
  is_backward_ = !is_backward_; // the next call begins with the shapes that are kept
  std::size_t done = 0;
  for (auto column = columns.begin(); column != columns.end();) {
    std::vector<std::size_t> block;
    for (; column != columns.end() && block.size() < largest_block; ++column)
      block.push_back(*column);
    std::vector<std::size_t> of_block = rows;
    append(of_block, block);
    const std::vector<Prepared_shape> shapes = prepared(of_block);
    std::vector<std::pair<std::size_t, std::size_t>> pairs, places; // indices into `shapes`; (index into `rows`, shape)
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (std::size_t c = 0; c < block.size(); ++c)
        if (std::binary_search(missing_in[r].begin(), missing_in[r].end(), block[c])) {
          pairs.insert(pairs.end(), {{r, rows.size() + c}, {rows.size() + c, r}});
          places.emplace_back(r, block[c]);
        }
    Energy_matrix_options matching = matching_;
    matching.progress = [&](std::size_t matched, std::size_t) {
      if (progress) progress(done + matched);
      return true;
    };
    const std::vector<Rated_map> rated = match_pairs<CGAL::Parallel_if_available_tag>(shapes, pairs, matching);
    for (std::size_t k = 0; k < places.size(); ++k)
      append_pairs(bytes[places[k].first], content(places[k].second), rated[2 * k], rated[2 * k + 1]);
    done += pairs.size();
  }
  for (std::size_t r = 0; r < rows.size(); ++r)
    store_.insert(names_[rows[r]], bytes[r]);
}

} // namespace CGAL::Shape_correspondence::cli
