// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "io/read/read_objects.h"
#include "io/read/text_words.h"
#include "io/system/input_file.h"
#include "io/system/quoting.h"
#include "shape/sample_triangles.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>

namespace CGAL::Shape_correspondence::IO {
namespace {

namespace fs = std::filesystem;

const char* const known_formats = "OBJ, PLY, STL, OFF, glTF, GLB, COLLADA (dae), FBX, 3DS, 3MF, DXF, AC3D (ac), URDF";

using Text_reader = Model_content (*)(std::string_view, const std::string&);

Text_reader text_reader_of(const std::string& extension)
{
  if (extension == ".obj") return read_obj_parts;
  if (extension == ".off") return read_off_part;
  if (extension == ".ply") return read_ply_part;
  if (extension == ".stl") return read_stl_parts;
  return nullptr;
}

bool is_gltf(const std::string& extension) { return extension == ".gltf" || extension == ".glb"; }

bool is_urdf(const std::string& extension) { return extension == ".urdf"; }

bool is_read_by_assimp(const std::string& extension)
{
  const auto formats = {".dae", ".fbx", ".3ds", ".3mf", ".dxf", ".ac"};
  return std::find(formats.begin(), formats.end(), extension) != formats.end();
}

/// The content of a file. \throw Invalid_input if it is empty, too large, or a device
std::string content_of(const std::string& file)
{
  std::ifstream in = open_input(file);
  if (!fs::is_regular_file(file)) throw Invalid_input(file + ": it is a device; copy the model into a file");
  const std::uintmax_t size = fs::file_size(file);
  if (size == 0) refuse(file + ": the file is empty", remedy::save_again);
  if (size > largest_model)
    throw Invalid_input(file + ": it is larger than " + std::to_string(largest_model >> 30) +
                        " GB; simplify the model, or cut it into parts");
  std::string text(std::size_t(size), '\0');
  in.read(text.data(), std::streamsize(size));
  text.resize(std::size_t(in.gcount()));
  return text;
}

/// Divides the model by labels of faces from the given list, or from a list beside the model.
void label_faces(const std::string& file, const Reading_options& options, Model_content& content)
{
  if (!options.face_labels.empty()) {
    const std::string extension = lower_extension(options.face_labels);
    if (extension == ".eseg" || extension == ".sseg")
      throw Invalid_input(options.face_labels + ": it has labels of edges; give a list with a label for each face");
    if (content.number_of_faces == 0)
      throw Invalid_input(file + ": labels of faces are for models in OBJ, OFF, PLY or STL; save it as one of these");
    return divide_by_labels(
        read_face_labels(content_of(options.face_labels), options.face_labels, content.number_of_faces), content);
  }
  const fs::path list = fs::path(file).replace_extension(".seg");
  std::error_code error;
  if (content.number_of_faces == 0 || !fs::is_regular_file(list, error)) return;
  std::uintmax_t rest = largest_model;
  const Named_file found = Named_files{file, options, largest_model, rest}.read(list.filename().string());
  try {
    if (!found.fault.empty()) throw Invalid_input("it " + found.fault);
    const Face_labels labels = read_face_labels(found.bytes, list.string(), content.number_of_faces);
    const std::string name = fs::path(file).filename().string();
    if (!labels.model.empty() && labels.model != name)
      throw Invalid_input(list.string() + ": it was written for the faces of " + cited_file(labels.model) +
                          "; if it is for this model, name it in `Reading_options::face_labels`");
    divide_by_labels(labels, content);
    if (content.are_labelled)
      content.warnings.push_back("The objects are the labels of faces in " + list.filename().string() + ".");
  } catch (const Invalid_input& fault) {
    content.warnings.push_back(labels_left_out + std::string(fault.what()) + ".");
  }
}

Model_content read_parts(const std::string& file, bool are_parts, const std::string& folder,
                         const Reading_options& options, const Complete_appearance& complete,
                         std::vector<std::string>& warnings);

Model_content read_robot(const std::string& text, const std::string& file, const std::string& folder,
                         const Reading_options& options, const Complete_appearance& complete,
                         std::vector<std::string>& warnings)
{
  Model_content robot = read_urdf_parts(text, file, folder, options, [&](const std::string& mesh) {
    Model_content content = read_parts(mesh, true, folder, options, {}, warnings);
    if (complete) complete(mesh, content, warnings);
    return content;
  });
  if (complete) warnings.insert(warnings.end(), robot.appearance_warnings.begin(), robot.appearance_warnings.end());
  return robot;
}

/// Reads a file. \param complete completes the appearance of meshes that a robot names; may be empty
/// \param are_parts whether everything in the file becomes one part
Model_content read_parts(const std::string& file, bool are_parts, const std::string& folder,
                         const Reading_options& options, const Complete_appearance& complete,
                         std::vector<std::string>& warnings)
{
  const std::string extension = lower_extension(file);
  const Text_reader reader = text_reader_of(extension);
  if (!reader && !is_gltf(extension) && !is_read_by_assimp(extension) && !is_urdf(extension))
    throw Invalid_input(file + ": models are read from files of type " + known_formats +
                        (extension.empty() ? ", and this one has no extension" : ", not '" + extension + "'") + "; " +
                        remedy::save_as_other_format);
  const std::string text = content_of(file);
  // The bytes of a binary STL file may look like UTF-16
  if (extension != ".stl" || text.substr(0, 4).find('\0') != std::string::npos) check_is_not_wide(text, file);
  Model_content content = reader               ? reader(text, file)
                          : is_gltf(extension) ? read_gltf_parts(text, file, options)
                          : is_urdf(extension) ? read_robot(text, file, folder, options, complete, warnings)
                                               : import_parts(file, options);
  if (!are_parts) label_faces(file, options, content);
  for (std::string& name : content.without_faces)
    name = utf8_text(name);
  for (Model_part& part : content.parts)
    part.name = utf8_text(part.name);
  return content;
}

/// Gives nameless parts a name, and appends a number to repeated names: leg, leg#2.
/// \param shape name of the shape, used for a part that is the entire shape
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

/// Adds a part to the objects. \return whether it has a surface; otherwise it is left out
bool add_part(const std::string& file, const Model_part& part, Model_objects& objects)
{
  for (const Point& corner : part.corners) {
    if (!(corner.array().abs() <= internal::largest_coordinate).all()) // NaN fails as well
      throw Invalid_input(file + ": part '" + part.name +
                          "' has a coordinate that is not a finite number, or beyond 1e15; repair it");
  }
  std::vector<std::size_t> kept;
  Part_mesh mesh = weld(part.corners, &kept);
  if (mesh.triangles.cols() == 0 || !internal::has_area(mesh)) return false;
  try {
    objects.shape.add_part(part.name, std::move(mesh));
  } catch (const Invalid_input& error) {
    throw Invalid_input(file + ": " + error.what());
  }
  objects.appearance.parts.push_back(appearance_of(part.appearance, kept));
  std::vector<int>& vertices = objects.vertices.emplace_back();
  for (std::size_t triangle : kept)
    if (part.vertices.size() == part.corners.size())
      vertices.insert(vertices.end(), &part.vertices[3 * triangle], &part.vertices[3 * triangle] + 3);
  if (part.faces.empty()) return true;
  for (std::size_t& triangle : kept)
    triangle = part.faces[triangle];
  objects.faces.push_back(std::move(kept));
  return true;
}

void check_number_of_parts(const std::string& path, std::size_t parts)
{
  if (parts > internal::most_parts) throw Invalid_input(path + ": it has " + internal::too_many_parts(parts));
}

void warn(std::size_t number, const std::string& of_what, std::vector<std::string>& warnings,
          const std::string& names = "")
{
  if (number > 0) warnings.push_back(of_what + " were left out: " + std::to_string(number) + names + ".");
}

/// The first eight names, in brackets.
std::string in_brackets(const std::vector<std::string>& names)
{
  constexpr std::size_t most = 8;
  std::string result;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
    result += (i == 0 ? " (" : ", ") + cited(names[i]);
  return result + (names.size() > most ? ", ...)" : names.empty() ? "" : ")");
}

/// The model files in a folder. \param is_of_robots whether to return descriptions of robots, or all others
std::vector<fs::path> model_files(const fs::path& folder, bool is_of_robots = false)
{
  std::vector<fs::path> files;
  std::error_code error;
  fs::directory_iterator entries(folder, error);
  if (error)
    refuse(folder.string() + ": the folder cannot be read (" + error.message() + ")", remedy::check_permissions);
  for (const fs::directory_entry& entry : entries) {
    const std::string file = entry.path().string();
    const bool is_part = is_model_file(file) && !is_hidden(entry.path());
    if (is_part && is_urdf(lower_extension(file)) == is_of_robots && entry.is_regular_file())
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Model_part joined(const std::string& name, const std::vector<Model_part>& objects)
{
  Model_part part{name, {}};
  for (const Model_part& object : objects) {
    add_appearance(object.appearance, object.corners.size() / 3, part.corners.size() / 3, part.appearance);
    part.corners.insert(part.corners.end(), object.corners.begin(), object.corners.end());
    part.faces.insert(part.faces.end(), object.faces.begin(), object.faces.end());
    part.vertices.insert(part.vertices.end(), object.vertices.begin(), object.vertices.end());
  }
  return part;
}

/// Appends the content of a file to that of earlier files.
void add_content(Model_content more, Model_content& all)
{
  append_appearance(more, all);
  for (Model_part& part : more.parts) {
    for (std::size_t& face : part.faces)
      face += all.number_of_faces;
    for (int& vertex : part.vertices)
      vertex += int(all.number_of_vertices);
  }
  std::move(more.parts.begin(), more.parts.end(), std::back_inserter(all.parts));
  std::move(more.warnings.begin(), more.warnings.end(), std::back_inserter(all.warnings));
  std::move(more.without_faces.begin(), more.without_faces.end(), std::back_inserter(all.without_faces));
  all.faces_left_out += more.faces_left_out;
  all.number_of_faces += more.number_of_faces;
  all.number_of_vertices += more.number_of_vertices;
  all.are_labelled = more.are_labelled;
}

/// The name of the folder SHAPE, for the paths SHAPE and SHAPE/parts.
std::string folder_name(const fs::path& folder)
{
  fs::path path = fs::absolute(folder).lexically_normal();
  if (path.filename().empty()) path = path.parent_path();
  if (path.filename() == "parts") path = path.parent_path();
  return utf8_text(path.filename().string());
}

fs::path folder_of_parts(const fs::path& path) { return fs::is_directory(path / "parts") ? path / "parts" : path; }

/// The parts named by a folder's hierarchy, or one part for each file in it; for a file, the file alone.
std::vector<Part_files> files_of(const std::string& path)
{
  if (!fs::is_directory(path)) return {{"", {path}}};
  if (const std::optional<std::string> hierarchy = hierarchy_in(path)) return parts_of_hierarchy(*hierarchy);
  const fs::path folder = folder_of_parts(path);
  std::vector<Part_files> files;
  for (const fs::path& file : model_files(folder))
    files.push_back({"", {file.string()}});
  if (files.empty())
    throw Invalid_input(folder.string() + ": there is no part in the folder; give it a mesh file for every part (" +
                        known_formats + ")");
  check_number_of_parts(folder.string(), files.size());
  return files;
}

/// For each object and triangle, the index of the material; empty if no object has several.
std::vector<std::vector<int>> materials_of(const Model_objects& objects)
{
  std::vector<std::vector<int>> result;
  bool has_several = false;
  for (std::size_t i = 0; i < objects.appearance.parts.size(); ++i) {
    std::vector<int> materials = objects.appearance.parts[i].materials;
    if (materials.size() != std::size_t(objects.shape.parts()[i].mesh.triangles.cols())) materials.clear();
    has_several = has_several ||
                  std::adjacent_find(materials.begin(), materials.end(), std::not_equal_to<int>()) != materials.end();
    result.push_back(std::move(materials));
  }
  return has_several ? result : std::vector<std::vector<int>>();
}

} // namespace

bool is_model_file(const std::string& path)
{
  const std::string extension = lower_extension(path);
  return text_reader_of(extension) || is_gltf(extension) || is_read_by_assimp(extension) || is_urdf(extension);
}

std::optional<std::string> robot_in(const std::string& folder)
{
  if (!fs::is_directory(folder)) return std::nullopt;
  for (const char* place : {"", "urdf", "robots"}) {
    const fs::path below = fs::path(folder) / place;
    const std::vector<fs::path> robots = fs::is_directory(below) ? model_files(below, true) : std::vector<fs::path>();
    if (robots.size() == 1) return robots[0].string();
    if (!robots.empty()) break;
  }
  return std::nullopt;
}

Model_objects read_objects(const std::string& given, const Point& up, const Reading_options& options,
                           const Complete_appearance& complete)
{
  check_exists(given);
  const std::string path = robot_in(given).value_or(given);
  const bool is_folder = fs::is_directory(path);
  const std::vector<Part_files> files = files_of(path);
  if (is_folder && !options.face_labels.empty())
    throw Invalid_input(path + ": labels of faces are for a model file; the files of a folder are its parts");
  const std::string name = is_folder ? folder_name(path) : utf8_text(fs::path(path).stem().string());
  Model_objects result;
  Model_content content;
  bool agree = true, is_first = true;           // whether all files have the same upright axis
  bool have_faces = true, have_vertices = true; // whether `Model_part::faces` and `vertices` are known for all files
  for (const Part_files& part : files) {
    const std::size_t first = content.parts.size();
    std::string name_of_part = part.name;
    for (const std::string& file : part.files) {
      Model_content of_file = read_parts(file, is_folder, fs::is_directory(given) ? given : "", options, complete,
                                         result.appearance.warnings);
      check_number_of_parts(file, is_folder ? 1 : of_file.parts.size());
      if (complete && !is_urdf(lower_extension(file))) complete(file, of_file, result.appearance.warnings);
      if (name_of_part.empty())
        name_of_part = of_file.are_labelled && of_file.parts.size() == 1 ? of_file.parts[0].name
                                                                         : utf8_text(fs::path(file).stem().string());
      if (is_first) content.up = of_file.up;
      is_first = false;
      agree = agree && of_file.up == content.up;
      have_faces = have_faces && of_file.number_of_faces > 0;
      have_vertices = have_vertices && of_file.number_of_vertices > 0;
      add_content(std::move(of_file), content);
    }
    if (!is_folder) continue;
    const auto begin = content.parts.begin() + std::ptrdiff_t(first);
    const std::vector<Model_part> objects(std::make_move_iterator(begin), std::make_move_iterator(content.parts.end()));
    content.parts.resize(first);
    content.parts.push_back(joined(name_of_part, objects));
  }
  result.says_up = agree && content.up != Point::Zero();
  result.shape = Segmented_shape(name, result.says_up && up == Point::UnitY() ? content.up : up);
  complete_names(name, content.parts);
  std::vector<std::string> left_out = std::move(content.without_faces);
  for (std::size_t i = 0; i < content.parts.size(); ++i) {
    const std::string file = files[is_folder ? i : 0].files[0];
    const Model_part part = std::move(content.parts[i]); // moved, to free memory for the next ones
    if (add_part(file, part, result)) continue;
    if (is_folder) throw Invalid_input(file + ": all triangles have zero area; remove the file or give it a surface");
    left_out.push_back(part.name);
  }
  if (result.shape.parts().empty())
    throw Invalid_input(path + ": part " + cited(left_out.back()) +
                        ": all triangles have zero area; give it a surface");
  result.warnings = std::move(content.warnings);
  result.are_labelled = content.are_labelled && !is_folder;
  result.number_of_faces = have_faces ? content.number_of_faces : 0;
  result.number_of_vertices = have_vertices ? content.number_of_vertices : 0;
  if (!have_faces) result.faces.clear();
  warn(content.faces_left_out, "Faces of fewer than three corners", result.warnings);
  warn(left_out.size(), "Parts without a surface", result.warnings, in_brackets(left_out));
  result.appearance.materials = std::move(content.materials);
  result.appearance.textures = std::move(content.textures);
  if (!is_folder) result.materials = materials_of(result);
  return result;
}

Segmented_shape read_segmented_shape(const std::string& path, const Point& up, std::vector<std::string>* warnings,
                                     const Reading_options& options)
{
  Model_objects objects = read_objects(path, up, options);
  if (warnings) warnings->insert(warnings->end(), objects.warnings.begin(), objects.warnings.end());
  return std::move(objects.shape);
}

} // namespace CGAL::Shape_correspondence::IO
