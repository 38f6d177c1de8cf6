// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_parts.h"
#include "io/read/text_words.h"
#include "io/system/colours.h"
#include "io/system/little_endian.h"
#include "io/system/quoting.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <optional>

// This reader supports all encodings and number types; CGAL's and assimp's trust the counts in the file.

namespace CGAL::Shape_correspondence::IO {
namespace {

/// A type of numbers with its two names.
struct Ply_type
{
  const char *name, *other_name;
  std::size_t size;
  double (*in_little_endian)(const char*);
  double (*in_big_endian)(const char*);
  double white; ///< value of a full channel of a colour
};

template <typename Number>
constexpr Ply_type ply_type(const char* name, const char* other_name, double white = 1)
{
  return {name, other_name, sizeof(Number), real_in<Number>, real_in<Number, boost::endian::order::big>, white};
}

constexpr Ply_type ply_types[] = {
    ply_type<std::int8_t>("char", "int8"),    ply_type<std::uint8_t>("uchar", "uint8", 255),
    ply_type<std::int16_t>("short", "int16"), ply_type<std::uint16_t>("ushort", "uint16"),
    ply_type<std::int32_t>("int", "int32"),   ply_type<std::uint32_t>("uint", "uint32"),
    ply_type<float>("float", "float32"),      ply_type<double>("double", "float64")};

struct Ply_property
{
  std::string name;
  const Ply_type* type = nullptr;
  const Ply_type* count_type = nullptr; ///< type of a list's length; null: no list
  int use = -1;                         ///< see `use_of()`
};

// Uses of properties; 0 to 2 are coordinates
constexpr int first_channel = 3, first_texture_coordinate = 6, texture_number = 8, part_number = 9;

/// The use of a property of this name: coordinate, channel of a colour, texture coordinate, texture index, or -1.
int use_of(const std::string& name)
{
  constexpr const char* uses[][4] = {{"x"},
                                     {"y"},
                                     {"z"},
                                     {"red", "diffuse_red"},
                                     {"green", "diffuse_green"},
                                     {"blue", "diffuse_blue"},
                                     {"s", "u", "texture_s", "texture_u"},
                                     {"t", "v", "texture_t", "texture_v"},
                                     {"texnumber"}};
  for (std::size_t use = 0; use < std::size(uses); ++use)
    for (const char* known : uses[use])
      if (known && name == known) return int(use);
  return -1;
}

constexpr int most_textures = 1000; // limit for a file

/// Names of properties of faces or vertices that tell their parts, the finest first; in lower case, without underscores
/// and without CloudCompare's prefix "scalar".
constexpr const char* part_properties[] = {
    "part",         "partid",   "partlabel",  "segment",  "segmentid",  "segments", "segid",   "seg",
    "segmentation", "instance", "instanceid", "objectid", "label",      "labels",   "labelid", "facelabel",
    "vertexlabel",  "semantic", "semanticid", "category", "categoryid", "class",    "classid", "classification"};

bool is_part_property(const Ply_property& property, std::string_view wanted)
{
  std::string name = lower(property.name);
  name.erase(std::remove(name.begin(), name.end(), '_'), name.end());
  return !property.count_type && (name == wanted || name == "scalar" + std::string(wanted));
}

struct Ply_element
{
  std::string name;
  std::size_t count = 0;
  std::vector<Ply_property> properties;
};

enum class Ply_encoding { ASCII, LITTLE_ENDIAN_BYTES, BIG_ENDIAN_BYTES };

class Ply_reader
{
public:
  Ply_reader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  Model_content read()
  {
    read_header();
    for (const Ply_element& element : elements_)
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
        add_looks(i, corner, std::size_t(face[corner]), part.appearance);
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
    result_.are_labelled = result_.are_labelled || is_written_;
    return std::move(result_);
  }

private:
  [[noreturn]] void fail(const std::string& what, const char* remedy = remedy::correct_text) const
  {
    refuse(file_ + ": " + what, remedy);
  }

  /// The values of an element that are used.
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

    bool has_looks() const { return has_colours || has_coordinates || has_texture || !corners.empty(); }

    void set(const Ply_property& property, double number)
    {
      if (property.use < 0) return;
      if (property.use < first_channel) {
        ++coordinates;
        point[property.use] = number;
      } else if (property.use < first_texture_coordinate) {
        has_colours = true;
        colour[property.use - first_channel] = number / property.type->white;
      } else if (property.use == texture_number) {
        has_texture = true;
        texture = number >= 0 && number < most_textures ? int(number) : -1;
      } else if (property.use == part_number) {
        label = std::isnan(number) ? -1 : number;
      } else {
        has_coordinates = true;
        const int axis = property.use - first_texture_coordinate;
        at[axis] = float(axis == 0 ? number : 1 - number);
      }
    }
  };

  void add_looks(std::size_t face, std::size_t corner, std::size_t vertex, Part_appearance& appearance) const
  {
    const auto colour = [](const Values& looks) -> Eigen::Vector3f {
      return linear_colour(looks.colour).cast<float>();
    };
    const Values* of_vertex = vertex < vertices_.size() ? &vertices_[vertex] : nullptr;
    const Values* of_face = face < face_looks_.size() ? &face_looks_[face] : nullptr;
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
    const Values* looks = face < face_looks_.size() && face_looks_[face].has_texture ? &face_looks_[face]
                          : vertex < vertices_.size()                                ? &vertices_[vertex]
                                                                                     : nullptr;
    const int number = looks ? looks->texture : 0;
    return number < int(textures_.size()) ? number : -1;
  }

  void add_textures(Part_appearance& appearance)
  {
    if (textures_.empty() || appearance.coordinates.empty()) return appearance.materials.clear();
    for (const std::string& texture : textures_) {
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
      const auto name = names_.find(part_property_ + ' ' + number);
      result.names.push_back(name == names_.end() ? part_property_ + '_' + number : name->second);
    }
    result.of_faces.assign(result_.number_of_faces, 0);
    for (std::size_t i = 0; i < labels_.size(); ++i)
      result.of_faces[numbers_[i]] = known[labels_[i]];
    return result;
  }

  void read_header()
  {
    // In a header with CR line ends, the first byte of binary data may equal LF
    const std::size_t end = text_.find_first_of("\r\n");
    const bool has_cr_alone = end != std::string_view::npos && text_[end] == '\r' && text_.substr(end, 2) != "\r\n";
    if (trimmed(next_line(text_)) != "ply")
      fail("it cannot be read as a PLY model: it does not begin with 'ply'", remedy::check_kind);
    for (;;) {
      if (text_.empty()) fail("its PLY header has no end: the file is cut off", remedy::save_again);
      std::string_view line = next_line(text_);
      const std::string_view keyword = next_word(line);
      if (keyword == "end_header") {
        if (has_cr_alone && text_.data()[-1] == '\n') text_ = {text_.data() - 1, text_.size() + 1};
        return choose_part_property();
      }
      if (keyword == "format")
        read_format(next_word(line));
      else if (keyword == "element")
        read_element_statement(line);
      else if (keyword == "property")
        read_property(line);
      else if (keyword == "comment")
        read_comment(line);
    }
  }

  /// Reads the name of a texture, or comments written by this program: the name for the number of a part or label.
  void read_comment(std::string_view line)
  {
    if (const std::optional<Point> up = up_in_mark(trimmed(line))) {
      result_.up = *up;
      is_written_ = true;
    }
    const std::string_view keyword = next_word(line);
    if (keyword == "TextureFile" && textures_.size() < most_textures) textures_.emplace_back(trimmed(line));
    if (keyword != "part" && keyword != "label") return;
    const std::string_view number = next_word(line);
    names_.emplace(std::string(keyword) + ' ' + std::string(number), percent_decoded(std::string(trimmed(line))));
  }

  /// Finds the property of faces, or else of vertices, that defines parts.
  void choose_part_property()
  {
    for (const char* wanted : {"face", "vertex"})
      for (Ply_element& element : elements_)
        for (const char* name : part_properties)
          for (Ply_property& property : element.properties)
            if (element.name == wanted && part_property_.empty() && is_part_property(property, name)) {
              property.use = part_number;
              part_property_ = lower(property.name);
              vertices_are_labelled_ = element.name == "vertex";
            }
  }

  void read_format(std::string_view word)
  {
    constexpr const char* encodings[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    const auto known = std::find(std::begin(encodings), std::end(encodings), word);
    if (known == std::end(encodings))
      fail("its PLY format is " + cited(word) + ", which is not ascii, binary_little_endian or binary_big_endian");
    encoding_ = Ply_encoding(known - std::begin(encodings));
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
    if (type == "list") {
      property.count_type = &type_of(next_word(line));
      type = next_word(line);
    }
    property.type = &type_of(type);
    property.name = next_word(line);
    property.use = use_of(property.name);
    elements_.back().properties.push_back(std::move(property));
  }

  const Ply_type& type_of(std::string_view word) const
  {
    for (const Ply_type& type : ply_types)
      if (word == type.name || word == type.other_name) return type;
    fail("its PLY header has a property of type " + cited(word) + ", which is none");
  }

  /// The least number of bytes for a number, and for an element.
  std::size_t least_size(const Ply_type& type) const { return encoding_ == Ply_encoding::ASCII ? 2 : type.size; }

  std::size_t least_size(const Ply_element& element) const
  {
    std::size_t result = 0;
    for (const Ply_property& property : element.properties)
      result += least_size(property.count_type ? *property.count_type : *property.type);
    return result;
  }

  void read_element(const Ply_element& element)
  {
    const std::size_t least = least_size(element);
    if (least == 0) return;
    // The last word of a text needs no blank after it
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
      if (is_face && !part_property_.empty() && !vertices_are_labelled_) labels_.push_back(values.label);
      if (is_face && (values.has_looks() || !face_looks_.empty())) {
        faces_have_coordinates_ = faces_have_coordinates_ || !values.corners.empty();
        face_looks_.resize(faces_.size());
        face_looks_.back() = std::move(values);
      } else if (element.name == "vertex") {
        add_vertex(std::move(values));
      }
    }
  }

  void add_vertex(Values values)
  {
    if (values.coordinates != 3) fail("its vertices do not have the properties x, y and z");
    points_.push_back(values.point);
    if (vertices_are_labelled_) labels_of_vertices_.push_back(values.label);
    if (!values.has_looks()) return;
    vertices_.resize(points_.size());
    vertices_.back() = std::move(values);
  }

  /// \return whether the list is the corners of a face that is kept
  bool read_list(const Ply_element& element, const Ply_property& property, Values& values)
  {
    const double count = next(*property.count_type);
    if (!(count >= 0) || count * double(least_size(*property.type)) > double(text_.size() + 1) ||
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

  /// Adds the triangles of strips, with alternating orientation: each vertex forms one with the two before it; -1 ends
  /// one.
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
    if (encoding_ == Ply_encoding::ASCII) {
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
    return encoding_ == Ply_encoding::LITTLE_ENDIAN_BYTES ? type.in_little_endian(bytes) : type.in_big_endian(bytes);
  }

  std::string_view text_;
  std::string file_;
  Ply_encoding encoding_ = Ply_encoding::ASCII;
  std::vector<Ply_element> elements_;
  std::vector<Point> points_;
  std::vector<std::vector<double>> faces_;
  std::vector<Values> vertices_, face_looks_; ///< values for `points_` and `faces_`; may be shorter
  std::vector<std::size_t> numbers_;          ///< indices in the file of `faces_`
  bool faces_have_coordinates_ = false;
  std::vector<std::string> textures_;               ///< file names
  std::string part_property_;                       ///< defines parts; empty: there is none
  bool vertices_are_labelled_ = false;              ///< whether the property belongs to vertices rather than faces
  std::vector<double> labels_, labels_of_vertices_; ///< values of the property for `faces_` and `points_`
  bool is_written_ = false;                         ///< whether the file was written by this program
  std::map<std::string, std::string> names_;        ///< names of parts and labels, by keyword and number
  Model_content result_;
};

} // namespace

Model_content read_ply_part(std::string_view text, const std::string& file) { return Ply_reader(text, file).read(); }

} // namespace CGAL::Shape_correspondence::IO
