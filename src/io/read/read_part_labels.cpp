// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/document.h"
#include "io/system/input_file.h"

#include <CGAL/Shape_correspondence/IO/read_part_labels.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <filesystem>

namespace CGAL::Shape_correspondence::IO {

namespace fs = std::filesystem;

namespace {

constexpr const char* labels_name = "labels.json";

/// Greatest depth of searched folders below the given one: CATEGORY/SHAPE.
constexpr int deepest = 2;

Part_label read_label(const Json_field& part)
{
  Part_label label{part["coarse"].text(), part.has("fine") && !part["fine"].is_null() ? part["fine"].text() : ""};
  if (label.coarse.empty()) part["coarse"].fail("is empty; give every part a coarse label");
  return label;
}

Labelled_shape read_labels_file(const fs::path& file)
{
  const Json_field root = read_json_file(file.string());
  const fs::path folder = fs::absolute(file).lexically_normal().parent_path();
  Labelled_shape shape;
  shape.file = file.string();
  shape.name = folder.filename().string();
  shape.category = root.has("category") ? root["category"].text() : folder.parent_path().filename().string();
  if (root.has("source")) shape.source = root["source"].text();
  if (root.has("license")) shape.license = root["license"].text();
  for (const Json_field& part : root["parts"].elements()) {
    const std::string name = part["name"].text();
    if (shape.index(name) < shape.parts.size()) part["name"].fail("is '" + name + "', as that of another part");
    shape.parts.push_back(name);
    shape.labels.push_back(read_label(part));
  }
  if (shape.parts.empty()) root["parts"].fail("is empty");
  return shape;
}

void find_labels(const fs::path& folder, int depth, std::vector<fs::path>& files)
{
  if (fs::exists(folder / labels_name)) {
    files.push_back(folder / labels_name);
    return;
  }
  if (depth == deepest) return;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_directory() && !is_hidden(entry.path())) find_labels(entry.path(), depth + 1, files);
}

} // namespace

std::size_t Labelled_shape::index(const std::string& part) const
{
  return std::size_t(std::find(parts.begin(), parts.end(), part) - parts.begin());
}

std::vector<Labelled_shape> read_part_labels(const std::string& path)
{
  std::vector<fs::path> files;
  std::error_code error;
  if (fs::is_directory(path, error))
    find_labels(path, 0, files);
  else
    files.push_back(path);
  if (files.empty())
    throw Invalid_input(path + ": there is no " + labels_name +
                        " in it, in its folders (shapes), or in the folders of these (shapes of categories); give the "
                        "folder that has them");
  std::sort(files.begin(), files.end());
  std::vector<Labelled_shape> shapes;
  for (const fs::path& file : files)
    shapes.push_back(read_labels_file(file));
  return shapes;
}

} // namespace CGAL::Shape_correspondence::IO
