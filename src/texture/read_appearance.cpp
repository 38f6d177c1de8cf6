// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/clamped.h"
#include "io/read/read_objects.h"
#include "io/read/text_words.h"
#include "io/system/colours.h"
#include "io/system/input_file.h"
#include "texture/image_file.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr std::uintmax_t largest_file = std::uintmax_t(64) << 20; // limit for a library or a texture, in bytes
constexpr std::uintmax_t most_bytes = std::uintmax_t(256) << 20;  // limit for all such files of a model, in bytes
constexpr float largest_coordinate_of_texture =
    1e4f; // number of repetitions of a texture beyond which single precision is too coarse

/// A material of a library: its colour, and its texture, which is not loaded yet and has no name if there is none.
struct Library_material
{
  Eigen::Vector4d colour = Eigen::Vector4d::Ones();
  Texture texture;
};

/// Reads the texture of a material: options, and a file name that may contain blanks. \return whether there is a name
bool read_texture(std::string_view line, Texture& result)
{
  Texture texture;
  for (std::string_view rest = trimmed(line); !rest.empty() && rest[0] == '-';) {
    const std::string_view option = next_word(rest);
    if (option == "-s" || option == "-o" || option == "-t" || option == "-mm") {
      double number = 0;
      for (std::string_view after = rest; parse(next_word(after), number);)
        rest = after;
    } else if (next_word(rest) == "on" && option == "-clamp")
      texture.wrap_u = texture.wrap_v = Texture_wrap::CLAMP;
    line = rest = trimmed(rest);
  }
  texture.name = trimmed(line);
  if (texture.name.empty()) return false;
  result = texture;
  return true;
}

/// Reads a statement, ignoring unknown ones. \return whether it is undamaged
bool read_statement(std::string_view keyword, std::string_view line, Library_material& material)
{
  if (keyword == "map_kd") return read_texture(line, material.texture);
  if (keyword == "kd") {
    Colour given;
    for (double& value : given)
      if (!parse(next_word(line), value)) return false;
    material.colour.head<3>() = linear_colour(given);
  } else if (keyword == "d" || keyword == "tr") {
    double value = 1;
    if (!parse(next_word(line), value)) return false;
    material.colour[3] = keyword == "d" ? value : 1 - value;
  }
  return true;
}

std::map<std::string, Library_material> read_library(std::string_view text, std::size_t& damaged_statements)
{
  std::map<std::string, Library_material> result;
  Library_material* material = nullptr;
  while (!text.empty()) {
    std::string_view line = trimmed(without_comment(next_line(text)));
    const std::string keyword = lower(next_word(line));
    if (keyword == "newmtl")
      material = &result[std::string(trimmed(line))];
    else if (material && !read_statement(keyword, line, *material))
      ++damaged_statements;
  }
  return result;
}

/// The materials, by name, of all libraries of an OBJ file; of equal names, the first counts.
std::map<std::string, Library_material>
read_libraries(const Named_files& files, const std::vector<std::string>& statements, std::vector<std::string>& warnings)
{
  std::map<std::string, Library_material> result;
  for (const std::string& statement : statements) {
    // The statement is a single name with blanks, or else several names
    std::vector<std::pair<std::string, Named_file>> libraries{{statement, files.read(statement)}};
    if (!libraries[0].second.fault.empty()) {
      libraries.clear();
      std::string_view rest = statement;
      for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest))
        libraries.emplace_back(word, files.read(std::string(word)));
    }
    for (auto& [name, file] : libraries) {
      if (is_wide_text(file.bytes)) file = {"", "is text in UTF-16; save it as UTF-8"};
      if (!file.fault.empty())
        warnings.push_back("The materials of " + cited_file(name) + " were left out: it " + file.fault + ".");
      std::size_t damaged = 0;
      result.merge(read_library(file.bytes, damaged));
      if (damaged > 0)
        warnings.push_back("Statements of '" + name +
                           "' that cannot be read were left out: " + std::to_string(damaged) + ".");
    }
  }
  return result;
}

/// Looks up materials that a file refers to by name. \return whether each was found
std::vector<bool> look_up_materials(const Named_files& files, Model_content& content,
                                    std::vector<std::string>& warnings)
{
  std::vector<bool> known(content.materials.size(), !content.materials_are_names);
  if (!content.materials_are_names) return known;
  const std::map<std::string, Library_material> library = read_libraries(files, content.libraries, warnings);
  std::map<std::tuple<std::string, Texture_wrap, Texture_wrap>, int> textures; // index of every texture
  for (std::size_t i = 0; i < known.size(); ++i) {
    Surface_material& material = content.materials[i];
    const auto found = library.find(material.name);
    if (found == library.end()) continue;
    known[i] = true;
    material.colour = found->second.colour;
    const Texture& texture = found->second.texture;
    if (texture.name.empty()) continue;
    const auto [number, is_new] =
        textures.emplace(std::tuple(texture.name, texture.wrap_u, texture.wrap_v), int(content.textures.size()));
    if (is_new) content.textures.push_back(texture);
    material.texture = number->second;
    material.colour.head<3>().setOnes(); // the texture replaces the colour
  }
  return known;
}

void load_textures(const Named_files& files, Model_content& content, std::vector<std::string>& warnings)
{
  for (Texture& texture : content.textures) {
    auto [bytes, fault] = texture.bytes.empty() ? files.read(texture.name) : Named_file{std::move(texture.bytes), ""};
    if (fault.empty() && bytes.size() > largest_file) fault = "is larger than 64 MB";
    if (fault.empty()) fault = fault_of_image(bytes);
    texture.bytes = fault.empty() ? std::move(bytes) : "";
    if (fault.empty()) continue;
    warnings.push_back("The texture " + cited_file(texture.name) + " was left out: it " + fault + ".");
  }
  for (Surface_material& material : content.materials)
    if (material.texture >= 0 && (std::size_t(material.texture) >= content.textures.size() ||
                                  content.textures[std::size_t(material.texture)].bytes.empty()))
      material.texture = -1;
}

/// Drops appearance that does not fit the triangles. \param known by material, whether it was found
void bound(Model_part& part, const std::vector<bool>& known)
{
  Part_appearance& looks = part.appearance;
  if (looks.materials.size() != part.corners.size() / 3) looks.materials.clear();
  if (looks.coordinates.size() != part.corners.size()) looks.coordinates.clear();
  if (looks.colours.size() != part.corners.size()) looks.colours.clear();
  for (int& material : looks.materials)
    if (material < 0 || std::size_t(material) >= known.size() || !known[std::size_t(material)]) material = -1;
  for (Eigen::Vector2f& at : looks.coordinates)
    if (!(at.array().abs() <= largest_coordinate_of_texture).all()) at.setZero(); // NaN fails as well
  for (Eigen::Vector3f& colour : looks.colours)
    for (float& value : colour)
      value = value > 0 ? std::min(value, 1.f) : 0.f;
}

void complete_appearance(const Named_files& files, Model_content& content, std::vector<std::string>& warnings)
{
  warnings.insert(warnings.end(), content.appearance_warnings.begin(), content.appearance_warnings.end());
  const std::vector<bool> known = look_up_materials(files, content, warnings);
  load_textures(files, content, warnings);
  for (Surface_material& material : content.materials) {
    material.colour = material.colour.unaryExpr(&internal::clamped_to_unit);
    if (material.colour[3] == 0) material.colour[3] = 1; // some exporters confuse transparency with opacity
  }
  for (Model_part& part : content.parts)
    bound(part, known);
}

} // namespace

Segmented_shape read_shape_and_appearance(const std::string& path, Shape_appearance& appearance, const Point& up,
                                          std::vector<std::string>* warnings, const Reading_options& options)
{
  std::uintmax_t rest = most_bytes;
  Model_objects objects =
      read_objects(path, up, options, [&](const std::string& file, Model_content& content, auto& found) {
        complete_appearance({file, options, largest_file, rest}, content, found);
      });
  if (warnings) warnings->insert(warnings->end(), objects.warnings.begin(), objects.warnings.end());
  appearance = std::move(objects.appearance);
  return std::move(objects.shape);
}

} // namespace CGAL::Shape_correspondence::IO
