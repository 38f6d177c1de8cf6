// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_parts.h"
#include "io/read/text_words.h"
#include "io/system/colours.h"
#include "io/system/little_endian.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>

// An own reader for PLY, of all its encodings and number types: CGAL's and assimp's trust the counts in the file.

namespace CGAL::Shape_correspondence::IO {
namespace {

enum class Ply_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64 };

struct Ply_property
{
  std::string name;
  Ply_type type = Ply_type::INT8;
  bool is_list = false;
  Ply_type count_type = Ply_type::INT8; ///< of a list
  int look = -1;                        ///< red, green, blue or a texture coordinate: which of them
};

/// The look that a property of this name is: 0 to 2 a channel of a colour, 3 and 4 a texture coordinate, -1 none.
int look_of(const std::string& name)
{
  static const std::map<std::string, int> looks{
      {"red", 0},          {"green", 1},     {"blue", 2},      {"diffuse_red", 0}, {"diffuse_green", 1},
      {"diffuse_blue", 2}, {"s", 3},         {"t", 4},         {"u", 3},           {"v", 4},
      {"texture_u", 3},    {"texture_v", 4}, {"texture_s", 3}, {"texture_t", 4}};
  const auto found = looks.find(name);
  return found == looks.end() ? -1 : found->second;
}

struct Ply_element
{
  std::string name;
  std::size_t count = 0;
  std::vector<Ply_property> properties;
};

enum class Ply_encoding { ASCII, LITTLE_ENDIAN_BYTES, BIG_ENDIAN_BYTES };

std::size_t size_of(Ply_type type)
{
  constexpr std::array<std::size_t, 8> sizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[std::size_t(type)];
}

class Ply_reader
{
public:
  Ply_reader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  Model_content read()
  {
    read_header();
    for (const Ply_element& element : elements_)
      read_element(element);
    if (faces_.empty() && result_.faces_left_out == 0)
      fail("there is no face in it; a model needs a mesh for every part");
    Model_part part;
    std::vector<Point> polygon;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const std::vector<double>& face = faces_[i];
      polygon.clear();
      for (double index : face)
        polygon.push_back(points_[checked_index(index)]);
      for (std::size_t corner : triangles_of_polygon(polygon)) {
        part.corners.push_back(polygon[corner]);
        add_looks(i, corner, std::size_t(face[corner]), part.appearance);
      }
    }
    if (!texture_.empty() && !part.appearance.coordinates.empty()) {
      result_.textures.push_back({texture_, "", {}});
      result_.materials.push_back({texture_, Eigen::Vector4d::Ones(), 0});
      part.appearance.materials.assign(part.corners.size() / 3, 0);
    }
    result_.parts.push_back(std::move(part));
    return std::move(result_);
  }

private:
  [[noreturn]] void fail(const std::string& what) const { throw Invalid_input(file_ + ": " + what); }

  /// Colour and texture coordinates of an element.
  struct Looks
  {
    bool has_colours = false, has_coordinates = false;
    Eigen::Vector3d colour = Eigen::Vector3d::Ones();
    Eigen::Vector2f at = Eigen::Vector2f::Zero();
    std::vector<double> corners; ///< of a face, texture coordinates

    void set(const Ply_property& property, double number)
    {
      if (property.look < 0) return;
      if (property.look < 3) {
        has_colours = true;
        colour[property.look] = property.type == Ply_type::UINT8 ? number / 255 : number;
      } else {
        has_coordinates = true;
        at[property.look - 3] = float(property.look == 3 ? number : 1 - number);
      }
    }
  };

  void add_looks(std::size_t face, std::size_t corner, std::size_t vertex, Part_appearance& appearance) const
  {
    const auto colour = [](const Looks& looks) -> Eigen::Vector3f { return linear_colour(looks.colour).cast<float>(); };
    const Looks* of_vertex = vertex < vertices_.size() ? &vertices_[vertex] : nullptr;
    const Looks* of_face = face < face_looks_.size() ? &face_looks_[face] : nullptr;
    if (of_vertex && of_vertex->has_colours)
      appearance.colours.push_back(colour(*of_vertex));
    else if (of_face && of_face->has_colours)
      appearance.colours.push_back(colour(*of_face));
    if (faces_have_coordinates_) {
      const std::vector<double>& at = face_looks_[face].corners;
      const bool is_there = at.size() >= 2 * corner + 2;
      appearance.coordinates.push_back(is_there ? Eigen::Vector2f(float(at[2 * corner]), float(1 - at[2 * corner + 1]))
                                                : Eigen::Vector2f(0, 0));
    } else if (of_vertex && of_vertex->has_coordinates)
      appearance.coordinates.push_back(of_vertex->at);
  }

  void read_header()
  {
    if (trimmed(next_line(text_)) != "ply") fail("it cannot be read as a PLY model: it does not begin with 'ply'");
    for (;;) {
      if (text_.empty()) fail("its PLY header has no end; the file is cut off");
      std::string_view line = next_line(text_);
      const std::string_view keyword = next_word(line);
      if (keyword == "end_header") return;
      if (keyword == "format")
        read_format(next_word(line));
      else if (keyword == "element")
        read_element_statement(line);
      else if (keyword == "property")
        read_property(line);
      else if (keyword == "comment" && next_word(line) == "TextureFile")
        texture_ = trimmed(line);
    }
  }

  void read_format(std::string_view word)
  {
    if (word == "ascii")
      encoding_ = Ply_encoding::ASCII;
    else if (word == "binary_little_endian")
      encoding_ = Ply_encoding::LITTLE_ENDIAN_BYTES;
    else if (word == "binary_big_endian")
      encoding_ = Ply_encoding::BIG_ENDIAN_BYTES;
    else
      fail("its PLY format is " + cited(word) + ", which is not ascii, binary_little_endian or binary_big_endian");
  }

  void read_element_statement(std::string_view line)
  {
    Ply_element element;
    element.name = next_word(line);
    const std::string_view count = next_word(line);
    if (!parse(count, element.count))
      fail("its PLY header has " + cited(count) + " where a number of elements is expected");
    elements_.push_back(std::move(element));
  }

  void read_property(std::string_view line)
  {
    if (elements_.empty()) fail("its PLY header has a property of no element");
    Ply_property property;
    std::string_view type = next_word(line);
    property.is_list = type == "list";
    if (property.is_list) {
      property.count_type = type_of(next_word(line));
      type = next_word(line);
    }
    property.type = type_of(type);
    property.name = next_word(line);
    property.look = look_of(property.name);
    elements_.back().properties.push_back(std::move(property));
  }

  Ply_type type_of(std::string_view word) const
  {
    constexpr const char* names[][2] = {{"char", "int8"},     {"uchar", "uint8"},   {"short", "int16"},
                                        {"ushort", "uint16"}, {"int", "int32"},     {"uint", "uint32"},
                                        {"float", "float32"}, {"double", "float64"}};
    for (std::size_t i = 0; i < std::size(names); ++i)
      if (word == names[i][0] || word == names[i][1]) return Ply_type(i);
    fail("its PLY header has a property of type " + cited(word) + ", which is none");
  }

  /// The fewest bytes that an element takes.
  std::size_t least_size(const Ply_element& element) const
  {
    std::size_t result = 0;
    for (const Ply_property& property : element.properties)
      result += encoding_ == Ply_encoding::ASCII ? 2 : size_of(property.is_list ? property.count_type : property.type);
    return result;
  }

  void read_element(const Ply_element& element)
  {
    const std::size_t least = least_size(element);
    if (least == 0) return;
    // The last word of a text needs no blank after it
    if (element.count > (text_.size() + 1) / least)
      fail("its header says " + std::to_string(element.count) + " of '" + element.name +
           "', but the rest of the file is too short for them; it is cut off or damaged");
    for (std::size_t i = 0; i < element.count; ++i) {
      Point point = Point::Zero();
      int coordinates = 0;
      Looks looks;
      bool is_face = false;
      for (const Ply_property& property : element.properties) {
        if (property.is_list) {
          is_face = read_list(element, property, looks) || is_face;
          continue;
        }
        const double number = next(property.type);
        looks.set(property, number);
        for (int k = 0; k < 3; ++k) {
          if (property.name.size() != 1 || property.name[0] != "xyz"[k]) continue;
          point[k] = number;
          ++coordinates;
        }
      }
      const bool are_known = looks.has_colours || looks.has_coordinates || !looks.corners.empty();
      if (is_face) {
        if (!are_known && face_looks_.empty()) continue;
        faces_have_coordinates_ = faces_have_coordinates_ || !looks.corners.empty();
        face_looks_.resize(faces_.size());
        face_looks_.back() = std::move(looks);
        continue;
      }
      if (element.name != "vertex") continue;
      if (are_known) {
        vertices_.resize(points_.size() + 1);
        vertices_.back() = std::move(looks);
      }
      if (coordinates != 3) fail("its vertices do not have the properties x, y and z");
      points_.push_back(point);
    }
  }

  /// \return whether it is the corners of a face that is kept
  bool read_list(const Ply_element& element, const Ply_property& property, Looks& looks)
  {
    const double count = next(property.count_type);
    const std::size_t least = encoding_ == Ply_encoding::ASCII ? 2 : size_of(property.type);
    if (!(count >= 0) || count * double(least) > double(text_.size() + 1) || count != std::floor(count))
      fail("it has a list of " + internal::number_text(count) +
           " numbers, which is more than the rest of the file holds; it is cut off or damaged");
    std::vector<double> list(static_cast<std::size_t>(count));
    for (double& number : list)
      number = next(property.type);
    if (element.name != "face") return false;
    if (property.name == "texcoord") {
      looks.corners = std::move(list);
      return false;
    }
    if (property.name != "vertex_indices" && property.name != "vertex_index") return false;
    if (list.size() < 3) {
      ++result_.faces_left_out;
      return false;
    }
    faces_.push_back(std::move(list));
    return true;
  }

  std::size_t checked_index(double index) const
  {
    if (!(index >= 0) || index >= double(points_.size()) || index != std::floor(index))
      fail("a face uses vertex " + internal::number_text(index) + ", but there are only " +
           std::to_string(points_.size()) + " (numbered from 0)");
    return static_cast<std::size_t>(index);
  }

  double next(Ply_type type)
  {
    if (encoding_ == Ply_encoding::ASCII) {
      const std::string_view word = next_word(text_);
      double number = 0;
      if (word.empty()) fail("it ends before all of its elements are there; the file is cut off");
      if (!parse(word, number)) fail("it has " + cited(word) + " where a number is expected");
      return number;
    }
    switch (type) {
    case Ply_type::INT8:
      return next_bytes<std::int8_t>();
    case Ply_type::UINT8:
      return next_bytes<std::uint8_t>();
    case Ply_type::INT16:
      return next_bytes<std::int16_t>();
    case Ply_type::UINT16:
      return next_bytes<std::uint16_t>();
    case Ply_type::INT32:
      return next_bytes<std::int32_t>();
    case Ply_type::UINT32:
      return next_bytes<std::uint32_t>();
    case Ply_type::FLOAT32:
      return next_bytes<float>();
    case Ply_type::FLOAT64:
      break;
    }
    return next_bytes<double>();
  }

  template <typename Number>
  double next_bytes()
  {
    if (text_.size() < sizeof(Number)) fail("it ends before all of its elements are there; the file is cut off");
    const char* const bytes = text_.data();
    text_.remove_prefix(sizeof(Number));
    return double(encoding_ == Ply_encoding::LITTLE_ENDIAN_BYTES ? number_in<Number>(bytes)
                                                                 : number_in<Number, boost::endian::order::big>(bytes));
  }

  std::string_view text_;
  std::string file_;
  Ply_encoding encoding_ = Ply_encoding::ASCII;
  std::vector<Ply_element> elements_;
  std::vector<Point> points_;
  std::vector<std::vector<double>> faces_;
  std::vector<Looks> vertices_, face_looks_; ///< of `points_` and `faces_`, as far as they are known
  bool faces_have_coordinates_ = false;
  std::string texture_; ///< a file
  Model_content result_;
};

} // namespace

Model_content read_ply_part(std::string_view text, const std::string& file) { return Ply_reader(text, file).read(); }

} // namespace CGAL::Shape_correspondence::IO
