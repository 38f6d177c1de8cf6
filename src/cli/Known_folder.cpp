// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Known_folder.h"
#include "io/read/read_objects.h"
#include "io/system/checked_file.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_cache.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/version.h>

#include <filesystem>
#include <sstream>
#include <utility>

namespace CGAL::Shape_correspondence::cli {
namespace {

/// Raise it with every change that reads other parts, or other warnings, from the same files.
constexpr int reader_version = 1;

/// Whether the files are the parts, and the options say which axis is up.
bool takes_files_as_parts(const Common_options& common)
{
  return (common.parts == "auto" || common.parts == "file") && common.parts_from.empty() && !common.finds_up();
}

std::string title_of_entry(const std::string& key) { return "shape_correspondence known folder " + key; }

} // namespace

Known_folder::Known_folder(std::string path, const Common_options& common, const Structure_options& options)
    : path_(std::move(path)), cache_(common.cache)
{
  if (cache_.empty() || !common.graphs_suffice || !takes_files_as_parts(common)) return;
  options_ = IO::content_hash(Segmented_shape("", common.up_vector()), options);
  key_ = key();
}

/// Empty if the cache cannot know the folder.
std::string Known_folder::key() const
{
  try {
    const std::optional<std::string> files = IO::digest_of_folder(path_);
    if (!files) return "";
    return IO::digest(std::to_string(reader_version) + ' ' + CGAL_SHAPE_CORRESPONDENCE_VERSION + ' ' + options_ + ' ' +
                      *files);
  } catch (const Invalid_input&) {
    return ""; // reported when it is read
  }
}

std::string Known_folder::entry() const { return (std::filesystem::path(cache_) / (key_ + ".folder")).string(); }

std::optional<Structural_graph> Known_folder::find() const
{
  if (key_.empty()) return std::nullopt;
  const std::optional<std::string> text = IO::read_checked_file(entry(), title_of_entry(key_));
  if (!text) return std::nullopt;
  std::istringstream lines(*text);
  std::string content;
  std::getline(lines, content);
  std::optional<Structural_graph> graph;
  try {
    graph = IO::Structural_graph_cache(cache_).find(content);
  } catch (const Invalid_input&) {
  }
  if (!graph) return std::nullopt;
  std::vector<std::string> warnings;
  for (std::string line; std::getline(lines, line);)
    warnings.push_back(line);
  structure(*graph).automatic_parts = false; // another way to the same parts may have put it there
  std::vector<std::string>& all = structure(*graph).warnings;
  all.insert(all.begin(), warnings.begin(), warnings.end());
  return graph;
}

void Known_folder::keep(const Structural_graph& graph, const std::vector<std::string>& warnings) const
{
  if (key_.empty() || key() != key_) return; // the graph may be of files that have changed meanwhile
  std::string text = structure(graph).content + '\n';
  for (const std::string& warning : warnings)
    text += warning + '\n';
  try {
    IO::write_checked_file(entry(), title_of_entry(key_), text);
  } catch (const Invalid_input&) { // it is read again the next time
  }
}

} // namespace CGAL::Shape_correspondence::cli
