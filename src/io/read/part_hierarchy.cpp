// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/document.h"
#include "io/read/read_objects.h"
#include "io/system/input_file.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <filesystem>
#include <set>

namespace CGAL::Shape_correspondence::IO {
namespace {

namespace fs = std::filesystem;

class Hierarchy_reader
{
public:
  explicit Hierarchy_reader(const std::string& hierarchy)
      : hierarchy_(hierarchy), folder_(fs::path(hierarchy).parent_path() / "objs")
  {}

  std::vector<Part_files> read()
  {
    for (const Json_field& root : read_json_file(hierarchy_).elements())
      visit(root);
    if (parts_.empty())
      throw Invalid_input(hierarchy_ + ": none of its nodes lists files (key \"objs\"); give one for each part");
    return std::move(parts_);
  }

private:
  void visit(const Json_field& node)
  {
    if (node.has("children"))
      for (const Json_field& child : node["children"].elements())
        visit(child);
    if (!node.has("objs")) return;
    Part_files part{node["name"].text(), {}};
    for (const Json_field& name : node["objs"].elements())
      if (taken_.insert(name.text()).second) part.files.push_back(file_of(name));
    if (!part.files.empty()) parts_.push_back(std::move(part));
  }

  std::string file_of(const Json_field& name) const
  {
    const std::string file = (folder_ / (name.text() + ".obj")).string();
    std::error_code error;
    if (!fs::is_regular_file(file, error) || !is_in_folder_of((folder_ / "file").string(), file))
      name.fail("is '" + name.text() + "', but there is no such OBJ file in objs/; put it there, or remove the name");
    return file;
  }

  const std::string& hierarchy_;
  fs::path folder_;
  std::set<std::string> taken_;
  std::vector<Part_files> parts_;
};

} // namespace

std::optional<std::string> hierarchy_in(const std::string& folder)
{
  for (const char* name : {"result_after_merging.json", "result.json"})
    if (const fs::path file = fs::path(folder) / name; fs::is_directory(fs::path(folder) / "objs") && fs::exists(file))
      return file.string();
  return std::nullopt;
}

std::vector<Part_files> parts_of_hierarchy(const std::string& hierarchy) { return Hierarchy_reader(hierarchy).read(); }

} // namespace CGAL::Shape_correspondence::IO
