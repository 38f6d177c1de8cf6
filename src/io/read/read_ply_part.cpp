// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/Ply_header.h"
#include "io/read/model_parts.h"
#include "io/read/text_words.h"
#include "io/system/colours.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

// This reader supports all encodings and number types; those of CGAL and assimp trust the counts in a damaged file.

namespace CGAL::Shape_correspondence::IO {
namespace {

class Ply_reader
{
public:
  Ply_reader(std::string_view text, const std::string& file)
      : text_(text), file_(file), header_(take_ply_header(text_, file))
  {}

  Model_content read()
  {
    for (const Ply_element& element : header_.elements)
      read_element(element);
    if (faces_.empty() && result_.faces_left_out == 0) fail("there is no face in it; give every part a mesh");
    Model_part part;
    std::vector<Point> polygon;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const std::vector<double>& face = faces_[i];
      polygon.clear();
      for (double index : face)
        polygon.push_back(points_[checked_index(index)]);
      for (std::size_t corner : triangles_of_polygon(polygon)) {
        part.corners.push_back(polygon[corner]);
        part.vertices.push_back(int(face[corner]));
        add_appearance(i, corner, std::size_t(face[corner]), part.appearance);
      }
      part.faces.resize(part.corners.size() / 3, numbers_[i]);
      part.appearance.materials.resize(part.faces.size(), texture_of(i));
    }
    add_textures(part.appearance);
    result_.number_of_faces = faces_.size() + result_.faces_left_out;
    result_.number_of_vertices = points_.size();
    result_.parts.push_back(std::move(part));
    if (!labels_of_vertices_.empty() && labels_.empty()) label_faces_by_vertices();
    if (!labels_.empty()) divide_by_labels(face_labels(), result_);
    if (header_.up) result_.up = *header_.up;
    result_.are_labelled = result_.are_labelled || header_.up;
    return std::move(result_);
  }

private:
  [[noreturn]] void fail(const std::string& what, const char* remedy = remedy::correct_text) const
  {
    refuse(file_ + ": " + what, remedy);
  }

  /// The values of a vertex or face that are used.
  struct Values
  {
    Point point = Point::Zero();
    int coordinates = 0; ///< number of coordinates that are given
    int texture = 0;     ///< index of the texture
    double label = 0;    ///< label of the part
    bool has_colours = false, has_coordinates = false, has_texture = false;
    Eigen::Vector3d colour = Eigen::Vector3d::Ones();
    Eigen::Vector2f at = Eigen::Vector2f::Zero(); ///< texture coordinates
    std::vector<double> corners;                  ///< texture coordinates of the corners of a face

    bool has_appearance() const { return has_colours || has_coordinates || has_texture || !corners.empty(); }

    void set(const Ply_property& property, double number)
    {
      if (property.use < 0) return;
      if (property.use < FIRST_CHANNEL) {
        ++coordinates;
        point[property.use] = number;
      } else if (property.use < FIRST_TEXTURE_COORDINATE) {
        has_colours = true;
        colour[property.use - FIRST_CHANNEL] = number / property.type->white;
      } else if (property.use == TEXTURE_NUMBER) {
        has_texture = true;
        texture = number >= 0 && number < most_ply_textures ? int(number) : -1;
      } else if (property.use == PART_NUMBER) {
        label = std::isnan(number) ? -1 : number;
      } else {
        has_coordinates = true;
        const int axis = property.use - FIRST_TEXTURE_COORDINATE;
        at[axis] = float(axis == 0 ? number : 1 - number);
      }
    }
  };

  void add_appearance(std::size_t face, std::size_t corner, std::size_t vertex, Part_appearance& appearance) const
  {
    const auto colour = [](const Values& looks) -> Eigen::Vector3f {
      return linear_colour(looks.colour).cast<float>();
    };
    const Values* of_vertex = vertex < vertices_.size() ? &vertices_[vertex] : nullptr;
    const Values* of_face = face < face_values_.size() ? &face_values_[face] : nullptr;
    if (of_vertex && of_vertex->has_colours)
      appearance.colours.push_back(colour(*of_vertex));
    else if (of_face && of_face->has_colours)
      appearance.colours.push_back(colour(*of_face));
    if (faces_have_coordinates_) {
      const std::vector<double> none, &at = of_face ? of_face->corners : none;
      const bool is_there = at.size() >= 2 * corner + 2;
      appearance.coordinates.push_back(is_there ? Eigen::Vector2f(float(at[2 * corner]), float(1 - at[2 * corner + 1]))
                                                : Eigen::Vector2f(0, 0));
    } else if (of_vertex && of_vertex->has_coordinates)
      appearance.coordinates.push_back(of_vertex->at);
  }

  /// The index of a face's texture, given for the face or for its first vertex; -1: none.
  int texture_of(std::size_t face) const
  {
    const auto vertex = std::size_t(faces_[face][0]);
    const Values* looks = face < face_values_.size() && face_values_[face].has_texture ? &face_values_[face]
                          : vertex < vertices_.size()                                  ? &vertices_[vertex]
                                                                                       : nullptr;
    const int number = looks ? looks->texture : 0;
    return number < int(header_.textures.size()) ? number : -1;
  }

  void add_textures(Part_appearance& appearance)
  {
    if (header_.textures.empty() || appearance.coordinates.empty()) return appearance.materials.clear();
    for (const std::string& texture : header_.textures) {
      result_.materials.push_back({texture, Eigen::Vector4d::Ones(), int(result_.textures.size())});
      result_.textures.push_back({texture, "", {}});
    }
  }

  /// Gives every face the most frequent label of its corners, of equally frequent ones the lowest.
  void label_faces_by_vertices()
  {
    for (const std::vector<double>& face : faces_) {
      std::map<double, int> corners; // number of corners, by label
      for (double index : face)
        ++corners[labels_of_vertices_[std::size_t(index)]];
      const auto fewer = [](const auto& one, const auto& other) { return one.second < other.second; };
      labels_.push_back(std::max_element(corners.begin(), corners.end(), fewer)->first);
    }
  }

  /// The labels of all faces of the file, in its order.
  Face_labels face_labels() const
  {
    std::map<double, int> known;
    for (double label : labels_)
      known.emplace(label, 0);
    Face_labels result;
    for (auto& [label, index] : known) {
      index = int(result.names.size());
      const std::string number = internal::number_text(label);
      const auto name = header_.names.find(header_.part_property + ' ' + number);
      result.names.push_back(name == header_.names.end() ? header_.part_property + '_' + number : name->second);
    }
    result.of_faces.assign(result_.number_of_faces, 0);
    for (std::size_t i = 0; i < labels_.size(); ++i)
      result.of_faces[numbers_[i]] = known[labels_[i]];
    return result;
  }

  /// The least number of bytes for an element.
  std::size_t least_size(const Ply_element& element) const
  {
    std::size_t result = 0;
    for (const Ply_property& property : element.properties)
      result += header_.least_size(property.count_type ? *property.count_type : *property.type);
    return result;
  }

  void read_element(const Ply_element& element)
  {
    const std::size_t least = least_size(element);
    if (least == 0) return;
    // + 1: the last word of a text needs no blank after it
    if (element.count > (text_.size() + 1) / least)
      fail("its header says " + std::to_string(element.count) + " of '" + element.name +
               "', but the rest of the file is too short for them: it is cut off or damaged",
           remedy::save_again);
    for (std::size_t i = 0; i < element.count; ++i) {
      Values values;
      bool is_face = false;
      for (const Ply_property& property : element.properties)
        if (property.count_type)
          is_face = read_list(element, property, values) || is_face;
        else
          values.set(property, next(*property.type));
      if (is_face && !header_.part_property.empty() && !header_.vertices_are_labelled) labels_.push_back(values.label);
      if (is_face && (values.has_appearance() || !face_values_.empty())) {
        faces_have_coordinates_ = faces_have_coordinates_ || !values.corners.empty();
        face_values_.resize(faces_.size());
        face_values_.back() = std::move(values);
      } else if (element.name == "vertex") {
        add_vertex(std::move(values));
      }
    }
  }

  void add_vertex(Values values)
  {
    if (values.coordinates != 3) fail("its vertices do not have the properties x, y and z");
    points_.push_back(values.point);
    if (header_.vertices_are_labelled) labels_of_vertices_.push_back(values.label);
    if (!values.has_appearance()) return;
    vertices_.resize(points_.size());
    vertices_.back() = std::move(values);
  }

  /// Reads a list. \return whether it has the corners of a face, and the face is kept
  bool read_list(const Ply_element& element, const Ply_property& property, Values& values)
  {
    const double count = next(*property.count_type);
    if (!(count >= 0) || count * double(header_.least_size(*property.type)) > double(text_.size() + 1) ||
        count != std::floor(count))
      fail("it has a list of " + internal::number_text(count) +
               " numbers, which is more than the rest of the file holds: it is cut off or damaged",
           remedy::save_again);
    std::vector<double> list(static_cast<std::size_t>(count));
    for (double& number : list)
      number = next(*property.type);
    const bool are_vertices = property.name == "vertex_indices" || property.name == "vertex_index";
    if (element.name == "tristrips" && are_vertices) add_strips(list);
    if (element.name != "face") return false;
    if (property.name == "texcoord") {
      values.corners = std::move(list);
      return false;
    }
    if (!are_vertices) return false;
    if (list.size() < 3) {
      ++result_.faces_left_out;
      return false;
    }
    add_face(std::move(list));
    return true;
  }

  void add_face(std::vector<double> vertices)
  {
    numbers_.push_back(faces_.size() + result_.faces_left_out);
    faces_.push_back(std::move(vertices));
  }

  /// Adds the triangles of strips: each vertex forms a triangle with the two before it, in alternating orientation; -1
  /// ends a strip.
  void add_strips(const std::vector<double>& vertices)
  {
    constexpr double unsigned_end = std::numeric_limits<std::uint32_t>::max(); // -1 as an unsigned number
    std::size_t begin = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (vertices[i] == -1 || vertices[i] == unsigned_end)
        begin = i + 1;
      else if (i >= begin + 2)
        add_face((i - begin) % 2 == 0 ? std::vector<double>{vertices[i - 2], vertices[i - 1], vertices[i]}
                                      : std::vector<double>{vertices[i - 1], vertices[i - 2], vertices[i]});
    }
  }

  std::size_t checked_index(double index) const
  {
    if (!(index >= 0) || index >= double(points_.size()) || index != std::floor(index))
      fail("a face uses vertex " + internal::number_text(index) + ", but there are only " +
           std::to_string(points_.size()) + " (numbered from 0)");
    return static_cast<std::size_t>(index);
  }

  double next(const Ply_type& type)
  {
    if (header_.encoding == Ply_encoding::ASCII) {
      const std::string_view word = next_word(text_);
      double number = 0;
      if (word.empty()) fail("it ends before all of its elements are there: the file is cut off", remedy::save_again);
      if (!parse(word, number)) fail("it has " + cited(word) + " where a number is expected");
      return number;
    }
    if (text_.size() < type.size)
      fail("it ends before all of its elements are there: the file is cut off", remedy::save_again);
    const char* const bytes = text_.data();
    text_.remove_prefix(type.size);
    return header_.encoding == Ply_encoding::LITTLE_ENDIAN_BYTES ? type.in_little_endian(bytes)
                                                                 : type.in_big_endian(bytes);
  }

  std::string_view text_;
  std::string file_;
  Ply_header header_;
  std::vector<Point> points_;
  std::vector<std::vector<double>> faces_;
  std::vector<Values> vertices_, face_values_; ///< values for `points_` and `faces_`; may be shorter
  std::vector<std::size_t> numbers_;           ///< indices in the file of `faces_`
  bool faces_have_coordinates_ = false;
  std::vector<double> labels_, labels_of_vertices_; ///< values that assign `faces_` or `points_` to parts
  Model_content result_;
};

} // namespace

Model_content read_ply_part(std::string_view text, const std::string& file) { return Ply_reader(text, file).read(); }

} // namespace CGAL::Shape_correspondence::IO
