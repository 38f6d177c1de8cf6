// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/load_shape.h"
#include "io/system/checked_file.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_cache.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/version.h>

#include <filesystem>
#include <sstream>

namespace CGAL::Shape_correspondence::cli {
namespace {

/// Raise it with every change that reads other parts, or other warnings, from the same files.
constexpr int reader_version = 2;

/// Whether the files are the parts, and the options say which axis is up.
bool takes_files_as_parts(const Common_options& common)
{
  return (common.parts == Part_splitting::AUTO || common.parts == Part_splitting::FILE) && common.parts_from.empty() &&
         !common.finds_up();
}

std::string title_of_entry(const std::string& key) { return "shape_correspondence known folder " + key; }

std::string entry(const std::string& key, const std::string& cache)
{
  return (std::filesystem::path(cache) / (key + ".folder")).string();
}

} // namespace

std::string key_of_folder(const std::string& path, const Common_options& common)
{
  if (common.cache.empty() || !common.graphs_suffice || !takes_files_as_parts(common)) return "";
  try {
    const std::optional<std::string> files = IO::digest_of_folder(path);
    if (!files) return "";
    const std::string options = IO::content_hash(Segmented_shape("", common.up_vector()), common.structure);
    return IO::digest(std::to_string(reader_version) + ' ' + CGAL_SHAPE_CORRESPONDENCE_VERSION + ' ' + options + ' ' +
                      *files);
  } catch (const Invalid_input&) {
    return ""; // reported when it is read
  }
}

std::optional<Structural_graph> known_graph(const std::string& key, const Common_options& common)
{
  if (key.empty()) return std::nullopt;
  const std::optional<std::string> text = IO::read_checked_file(entry(key, common.cache), title_of_entry(key));
  if (!text) return std::nullopt;
  std::istringstream lines(*text);
  std::string content;
  std::getline(lines, content);
  std::optional<Structural_graph> graph;
  try {
    graph = IO::Structural_graph_cache(common.cache).find(content);
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

void keep_known(const std::string& path, const std::string& key, const Common_options& common,
                const Structural_graph& graph, const std::vector<std::string>& warnings)
{
  if (key.empty() || key_of_folder(path, common) != key)
    return; // the graph may be of files that have changed meanwhile
  std::string text = structure(graph).content + '\n';
  for (const std::string& warning : warnings)
    text += warning + '\n';
  try {
    IO::write_checked_entry(entry(key, common.cache), title_of_entry(key), text);
  } catch (const Invalid_input&) { // it is read again the next time
  }
}

} // namespace CGAL::Shape_correspondence::cli
