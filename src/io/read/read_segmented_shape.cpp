// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "io/system/digest.h"
#include "io/system/input_file.h"
#include "io/read/model_appearance.h"
#include "io/read/model_parts.h"
#include "io/system/quoting.h"
#include "io/read/read_objects.h"
#include "shape/has_area.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iterator>
#include <map>
#include <set>

namespace CGAL::Shape_correspondence::IO {
namespace {

namespace fs = std::filesystem;

const char* const known_formats = "OBJ, PLY, STL, OFF, glTF, GLB, COLLADA (dae), FBX, 3DS, DXF, AC3D (ac)";

using Text_reader = Model_content (*)(std::string_view, const std::string&);

Text_reader text_reader_of(const std::string& extension)
{
  if (extension == ".obj") return read_obj_parts;
  if (extension == ".off") return read_off_part;
  if (extension == ".ply") return read_ply_part;
  if (extension == ".stl") return read_stl_parts;
  return nullptr;
}

bool is_read_by_assimp(const std::string& extension)
{
  const auto formats = {".gltf", ".glb", ".dae", ".fbx", ".3ds", ".dxf", ".ac"};
  return std::find(formats.begin(), formats.end(), extension) != formats.end();
}

/// All of a file. \throw Invalid_input if it is empty, or a device
std::string content_of(const std::string& file)
{
  std::ifstream in = open_input(file);
  if (!fs::is_regular_file(file)) throw Invalid_input(file + ": it is a device; copy the model into a file");
  const std::uintmax_t size = fs::file_size(file);
  if (size == 0) throw Invalid_input(file + ": the file is empty");
  std::string text(size, '\0');
  in.read(text.data(), std::streamsize(size));
  text.resize(std::size_t(in.gcount()));
  return text;
}

Model_content read_parts(const std::string& file)
{
  const std::string extension = lower_extension(file);
  const Text_reader reader = text_reader_of(extension);
  if (!reader && !is_read_by_assimp(extension))
    throw Invalid_input(file + ": models are read from files of type " + known_formats +
                        (extension.empty() ? ", and this one has no extension" : ", not '" + extension + "'"));
  const std::string text = content_of(file);
  const std::string mark = text.substr(0, 2);
  const bool is_wide = mark == "\xFF\xFE" || mark == "\xFE\xFF";
  if (is_wide && extension != ".stl") // a binary STL file may begin with any bytes
    throw Invalid_input(file + ": it is text in UTF-16; save it as UTF-8");
  Model_content content = reader ? reader(text, file) : read_parts_with_assimp(file);
  for (Model_part& part : content.parts)
    part.name = utf8_text(part.name);
  return content;
}

/// Gives parts that have none a name, and later ones of a name a number: leg, leg#2.
/// \param shape the name of the shape, which a part that is all of it gets
void complete_names(const std::string& shape, std::vector<Model_part>& parts)
{
  std::set<std::string> taken;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].name.empty()) parts[i].name = parts.size() == 1 ? shape : "part_" + std::to_string(i + 1);
    taken.insert(parts[i].name);
  }
  std::map<std::string, int> uses;
  for (Model_part& part : parts) {
    const std::string name = part.name;
    int& number = uses[name];
    if (++number == 1) continue;
    while (!taken.insert(name + '#' + std::to_string(number)).second)
      ++number;
    part.name = name + '#' + std::to_string(number);
  }
}

/// The looks of some triangles of a part.
Part_appearance looks_of(const Part_appearance& all, const std::vector<std::size_t>& triangles)
{
  Part_appearance result;
  for (std::size_t t : triangles) {
    if (!all.materials.empty()) result.materials.push_back(all.materials[t]);
    for (std::size_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
      if (!all.coordinates.empty()) result.coordinates.push_back(all.coordinates[corner]);
      if (!all.colours.empty()) result.colours.push_back(all.colours[corner]);
    }
  }
  return result;
}

/// Adds a part to a shape. \return whether it has a surface; else it is left out
/// \param looks where not null, gets those of the part
bool add_part(const std::string& file, const Model_part& part, Segmented_shape& shape,
              std::vector<Part_appearance>* looks)
{
  for (const Point& corner : part.corners) {
    if (!(corner.array().abs() <= internal::largest_coordinate).all()) // nor is NaN
      throw Invalid_input(file + ": part '" + part.name +
                          "' has a coordinate that is not a finite number, or beyond 1e15; repair it");
  }
  std::vector<std::size_t> kept;
  Part_mesh mesh = weld(part.corners, &kept);
  if (mesh.triangles.cols() == 0 || !internal::has_area(mesh)) return false;
  shape.add_part(part.name, std::move(mesh));
  if (looks) looks->push_back(looks_of(part.appearance, kept));
  return true;
}

void check_number_of_parts(const std::string& path, std::size_t parts)
{
  if (parts > internal::most_parts) throw Invalid_input(path + ": it has " + internal::too_many_parts(parts));
}

void warn(std::size_t number, const std::string& of_what, std::vector<std::string>* warnings)
{
  if (warnings && number > 0) warnings->push_back(of_what + " were left out: " + std::to_string(number) + ".");
}

constexpr const char* poor_faces = "Faces of fewer than three corners";

/// \param appearance where not null, gets that of the shape \param looks the same of parts alone
Segmented_shape read_file(const fs::path& path, const Point& up, std::vector<std::string>* warnings,
                          Shape_appearance* appearance, std::vector<Part_appearance>* looks)
{
  const std::string file = path.string(), name = utf8_text(path.stem().string());
  Model_content content = read_parts(file);
  check_number_of_parts(file, content.parts.size());
  complete_names(name, content.parts);
  if (appearance) {
    *appearance = {};
    looks = &appearance->parts;
    complete_appearance(file, content, appearance->warnings);
    appearance->materials = std::move(content.materials);
    appearance->textures = std::move(content.textures);
  }
  Segmented_shape shape(name, up);
  std::string left_out;
  std::size_t number_left_out = 0;
  for (const Model_part& part : content.parts) {
    if (add_part(file, part, shape, looks)) continue;
    left_out = part.name;
    ++number_left_out;
  }
  if (shape.parts().empty())
    throw Invalid_input(file + ": part '" + left_out + "': all triangles have zero area; give it a surface");
  warn(content.faces_left_out, poor_faces, warnings);
  warn(number_left_out, "Parts without a surface", warnings);
  return shape;
}

std::vector<fs::path> model_files(const fs::path& folder)
{
  std::vector<fs::path> files;
  std::error_code error;
  fs::directory_iterator entries(folder, error);
  if (error) throw Invalid_input(folder.string() + ": the folder cannot be read (" + error.message() + ")");
  for (const fs::directory_entry& entry : entries) {
    if (is_model_file(entry.path().string()) && entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Puts the looks of some triangles after those of others; what only one of them has gets its default.
/// \param triangles how many there are of each \param material the number of the first material of the others
void append_looks(const Part_appearance& more, std::size_t more_triangles, int material, std::size_t triangles,
                  Part_appearance& all)
{
  const auto append = [](auto& to, std::size_t before, const auto& from, std::size_t count, const auto& none) {
    if (to.empty() && from.empty()) return;
    to.resize(before, none);
    to.insert(to.end(), from.begin(), from.end());
    to.resize(before + count, none);
  };
  std::vector<int> materials = more.materials;
  for (int& number : materials)
    if (number >= 0) number += material;
  append(all.materials, triangles, materials, more_triangles, -1);
  append(all.coordinates, 3 * triangles, more.coordinates, 3 * more_triangles, Eigen::Vector2f(0, 0));
  append(all.colours, 3 * triangles, more.colours, 3 * more_triangles, Eigen::Vector3f(1, 1, 1));
}

/// One file, one part, whatever objects are in it.
/// \param appearance where not null, gets the materials and textures
Model_part read_part(const fs::path& file, std::size_t& faces_left_out, Shape_appearance* appearance)
{
  Model_part part{utf8_text(file.stem().string()), {}};
  Model_content content = read_parts(file.string());
  if (appearance) complete_appearance(file.string(), content, appearance->warnings);
  for (const Model_part& piece : content.parts) {
    if (appearance)
      append_looks(piece.appearance, piece.corners.size() / 3, int(appearance->materials.size()),
                   part.corners.size() / 3, part.appearance);
    part.corners.insert(part.corners.end(), piece.corners.begin(), piece.corners.end());
  }
  faces_left_out += content.faces_left_out;
  if (!appearance) return part;
  for (Surface_material& material : content.materials) {
    if (material.texture >= 0) material.texture += int(appearance->textures.size());
    appearance->materials.push_back(std::move(material));
  }
  std::move(content.textures.begin(), content.textures.end(), std::back_inserter(appearance->textures));
  return part;
}

/// The name of SHAPE, for SHAPE and SHAPE/parts alike.
std::string folder_name(const fs::path& folder)
{
  fs::path path = fs::absolute(folder).lexically_normal();
  if (path.filename().empty()) path = path.parent_path();
  if (path.filename() == "parts") path = path.parent_path();
  return utf8_text(path.filename().string());
}

/// Where the part meshes of a folder are.
fs::path folder_of_parts(const fs::path& path) { return fs::is_directory(path / "parts") ? path / "parts" : path; }

Segmented_shape read_folder(const fs::path& path, const Point& up, std::vector<std::string>* warnings,
                            Shape_appearance* appearance)
{
  const fs::path folder = folder_of_parts(path);
  const std::vector<fs::path> files = model_files(folder);
  if (files.empty())
    throw Invalid_input(folder.string() + ": there is no part in the folder; it needs a mesh file for every part (" +
                        known_formats + ")");
  check_number_of_parts(folder.string(), files.size());
  std::vector<Model_part> parts;
  std::size_t faces_left_out = 0;
  if (appearance) *appearance = {};
  for (const fs::path& file : files)
    parts.push_back(read_part(file, faces_left_out, appearance));
  complete_names(folder_name(path), parts);
  Segmented_shape shape(folder_name(path), up);
  for (std::size_t i = 0; i < files.size(); ++i)
    if (!add_part(files[i].string(), parts[i], shape, appearance ? &appearance->parts : nullptr))
      throw Invalid_input(files[i].string() + ": all triangles have zero area; remove the file or give it a surface");
  warn(faces_left_out, poor_faces, warnings);
  return shape;
}

} // namespace

bool is_model_file(const std::string& path)
{
  const std::string extension = lower_extension(path);
  return text_reader_of(extension) || is_read_by_assimp(extension);
}

Segmented_shape read_segmented_shape(const std::string& path, const Point& up, std::vector<std::string>* warnings,
                                     Shape_appearance* appearance)
{
  check_exists(path);
  if (fs::is_directory(path)) return read_folder(path, up, warnings, appearance);
  return read_file(path, up, warnings, appearance, nullptr);
}

std::optional<std::string> digest_of_folder(const std::string& path)
{
  if (!fs::is_directory(path)) return std::nullopt;
  std::string all = digest(folder_name(path));
  for (const fs::path& file : model_files(folder_of_parts(path))) {
    if (!text_reader_of(lower_extension(file.string()))) return std::nullopt; // a glTF file names its buffers
    all += digest(file.filename().string()) + digest(content_of(file.string()));
  }
  return digest(all);
}

Model_objects read_objects(const std::string& path, const Point& up)
{
  check_exists(path);
  Model_objects result;
  if (fs::is_directory(path)) {
    result.shape = read_folder(path, up, &result.warnings, nullptr);
    return result;
  }
  std::vector<Part_appearance> looks;
  result.shape = read_file(path, up, &result.warnings, nullptr, &looks);
  bool has_several = false;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    std::vector<int>& materials = looks[i].materials;
    if (materials.size() != std::size_t(result.shape.parts()[i].mesh.triangles.cols())) materials.clear();
    has_several = has_several ||
                  std::adjacent_find(materials.begin(), materials.end(), std::not_equal_to<int>()) != materials.end();
    result.materials.push_back(std::move(materials));
  }
  if (!has_several) result.materials.clear();
  return result;
}

} // namespace CGAL::Shape_correspondence::IO
