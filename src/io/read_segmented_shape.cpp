// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/input_file.h"
#include "io/model_parts.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <filesystem>

namespace CGAL::Shape_correspondence::IO {
namespace {

namespace fs = std::filesystem;

const char* const known_formats = "OBJ, PLY, STL, OFF, glTF, GLB, COLLADA (dae)";

using Reader = std::vector<Model_part> (*)(const std::string&);

/// The reader of a file's format; null if it is no format of models.
Reader reader_of(const fs::path& file)
{
  const std::string extension = lower_extension(file.string());
  if (extension == ".obj") return read_obj_parts;
  if (extension == ".off" || extension == ".ply") return read_soup_part;
  for (const char* known : {".stl", ".gltf", ".glb", ".dae"}) {
    if (extension == known) return read_parts_with_assimp;
  }
  return nullptr;
}

void check_readable(const fs::path& file)
{
  open_input(file.string());
  std::error_code error;
  if (fs::file_size(file, error) == 0 && !error) throw Invalid_input(file.string() + ": the file is empty");
}

std::vector<Model_part> read_parts(const fs::path& file)
{
  const Reader reader = reader_of(file);
  if (!reader)
    throw Invalid_input(file.string() + ": models are read from files of type " + known_formats + ", not '" +
                        file.extension().string() + "'");
  check_readable(file);
  return reader(file.string());
}

void add_part(const std::string& file, const Model_part& part, Segmented_shape& shape)
{
  for (const Point& corner : part.corners) {
    if (!corner.allFinite())
      throw Invalid_input(file + ": part '" + part.name + "' has a coordinate that is not a finite number; repair it");
  }
  try {
    shape.add_part(part.name, weld(part.corners));
  } catch (const Invalid_input& error) {
    throw Invalid_input(file + ": " + error.what());
  }
}

void check_names(const std::string& file, const std::vector<Model_part>& parts)
{
  std::vector<std::string> names;
  for (const Model_part& part : parts)
    names.push_back(part.name);
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end())
    throw Invalid_input(file + ": two parts are named '" + *twice + "'; give every part a name of its own");
}

Segmented_shape shape_of_parts(const std::string& file, const std::string& name, const std::vector<Model_part>& parts,
                               const Point& up)
{
  check_names(file, parts);
  Segmented_shape shape(name, up);
  for (const Model_part& part : parts)
    add_part(file, part, shape);
  return shape;
}

Segmented_shape read_file(const fs::path& file, const Point& up)
{
  const std::string stem = file.stem().string();
  std::vector<Model_part> parts = read_parts(file);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].name.empty()) parts[i].name = parts.size() == 1 ? stem : "part_" + std::to_string(i + 1);
  }
  return shape_of_parts(file.string(), stem, parts, up);
}

std::vector<fs::path> model_files(const fs::path& folder)
{
  std::vector<fs::path> files;
  std::error_code error;
  fs::directory_iterator entries(folder, error);
  if (error) throw Invalid_input(folder.string() + ": the folder cannot be read (" + error.message() + ")");
  for (const fs::directory_entry& entry : entries) {
    if (reader_of(entry.path()) && entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// One file, one part, whatever objects are in it.
Model_part read_part(const fs::path& file)
{
  Model_part part{file.stem().string(), {}};
  for (const Model_part& piece : read_parts(file))
    part.corners.insert(part.corners.end(), piece.corners.begin(), piece.corners.end());
  return part;
}

/// The name of SHAPE, for SHAPE and SHAPE/parts alike.
std::string folder_name(const fs::path& folder)
{
  fs::path path = fs::absolute(folder).lexically_normal();
  if (path.filename().empty()) path = path.parent_path();
  if (path.filename() == "parts") path = path.parent_path();
  return path.filename().string();
}

Segmented_shape read_folder(const fs::path& path, const Point& up)
{
  const fs::path folder = fs::is_directory(path / "parts") ? path / "parts" : path;
  const std::vector<fs::path> files = model_files(folder);
  if (files.empty())
    throw Invalid_input(folder.string() + ": there is no part in the folder; it needs a mesh file for every part (" +
                        known_formats + ")");
  Segmented_shape shape(folder_name(path), up);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (i > 0 && files[i].stem() == files[i - 1].stem())
      throw Invalid_input(files[i].string() + ": two parts are named '" + files[i].stem().string() +
                          "'; give every part a name of its own");
    add_part(files[i].string(), read_part(files[i]), shape);
  }
  return shape;
}

} // namespace

bool is_model_file(const std::string& path) { return reader_of(path) != nullptr; }

Segmented_shape read_segmented_shape(const std::string& path, const Point& up)
{
  std::error_code error;
  if (!fs::exists(path, error)) throw Invalid_input(path + ": there is no such file or folder");
  if (fs::is_directory(path, error)) return read_folder(path, up);
  return read_file(path, up);
}

} // namespace CGAL::Shape_correspondence::IO
