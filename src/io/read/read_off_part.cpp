// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_parts.h"
#include "io/read/text_words.h"
#include "io/system/colours.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <cstdint>

// CGAL's reader is not used, since it trusts the counts in a damaged file.

namespace CGAL::Shape_correspondence::IO {
namespace {

// Channel of a colour above which white must be 255 rather than 1.
constexpr double brightest_channel = 1.5;

/// A colour as in the file; white if there is none.
struct Off_colour
{
  enum Scale { UNIT, OF_FILE }; ///< whether white is 1, or a value determined for the whole file

  Eigen::Vector3d channels = Eigen::Vector3d::Ones();
  Scale scale = UNIT;
};

class Off_reader
{
public:
  Off_reader(std::string_view text, const std::string& file) : lines_(text, file), file_(file) {}

  Model_content read()
  {
    line_ = next_line_of_words();
    read_keyword();
    if (trimmed(line_) == "BINARY") fail("is binary, and only OFF as text is read; convert it, or write PLY or OBJ");
    if (has_dimension_ && number_in_any_line<int>() != 3)
      fail("is not three-dimensional", remedy::save_as_other_format);
    const auto vertices = number_in_any_line<std::size_t>(), faces = number_in_any_line<std::size_t>();
    skip_number_of_edges();
    constexpr std::size_t least_vertex = 6, least_face = 2; // least number of bytes of a line
    if (vertices > lines_.rest().size() / least_vertex || faces > lines_.rest().size() / least_face)
      fail("says that it has " + std::to_string(vertices) + " vertices and " + std::to_string(faces) +
               " faces, which is more than the file holds: it is cut off or damaged",
           remedy::save_again);
    if (faces == 0) throw Invalid_input(file_ + ": there is no face in it; give every part a mesh");
    for (std::size_t i = 0; i < vertices; ++i)
      read_vertex();
    Model_content result;
    result.parts.emplace_back();
    result.number_of_faces = faces;
    result.number_of_vertices = vertices;
    for (std::size_t i = 0; i < faces; ++i)
      read_face(i, result);
    for (const Off_colour& colour : colours_of_corners_)
      if (has_colours_) result.parts[0].appearance.colours.push_back(linear(colour));
    return result;
  }

private:
  [[noreturn]] void fail(const std::string& what, const char* remedy = remedy::correct_text) const
  {
    lines_.fail("it cannot be read as an OFF model: it " + what, remedy);
  }

  /// The next line that has words, without its comment.
  std::string_view next_line_of_words()
  {
    while (!lines_.rest().empty()) {
      const std::string_view line = lines_.next();
      const std::string_view words = trimmed(line.substr(0, line.find('#')));
      if (!words.empty()) return words;
    }
    fail("ends before all of its vertices and faces are there: the file is cut off", remedy::save_again);
  }

  /// Reads the keyword, which tells what follows the coordinates. It may be missing, or directly followed by numbers.
  void read_keyword()
  {
    std::string_view rest = line_;
    const std::string_view word = next_word(rest);
    if (double number = 0; parse(word, number)) return;
    const std::size_t at = std::min(word.find("OFF"), word.find("off"));
    const std::string_view letters = word.substr(0, at);
    if (at == std::string_view::npos || letters.find_first_not_of("STCN4nstc") != std::string_view::npos)
      fail("does not begin with the word OFF", remedy::check_kind);
    line_.remove_prefix(std::size_t(word.data() - line_.data()) + at + 3);
    has_weights_ = letters.find('4') != std::string_view::npos;
    has_dimension_ = letters.find('n') != std::string_view::npos && word[at] == 'O';
    if (has_weights_ && has_dimension_) fail("is not three-dimensional", remedy::save_as_other_format);
    const std::size_t colour = letters.find_first_of("Cc"), normal = letters.find_first_of("Nn");
    vertices_have_colours_ = colour != std::string_view::npos;
    normals_come_first_ = !has_dimension_ && normal != std::string_view::npos &&
                          (normal > colour || !vertices_have_colours_); // MeshLab writes NC, with colours first
  }

  /// Skips the number of edges, which may be missing or on a line of its own.
  void skip_number_of_edges()
  {
    const bool is_there = !next_word(line_).empty();
    if (has_weights_ && !trimmed(line_).empty())
      fail("is not three-dimensional", remedy::save_as_other_format); // the header also has a number of cells
    std::string_view rest = lines_.rest();
    if (std::size_t edges = 0; !is_there && parse(trimmed(next_line(rest)), edges)) next_line_of_words();
  }

  /// The colour at the start of `line`, which follows the coordinates or indices; white if there is none.
  Off_colour colour(std::string_view line)
  {
    Off_colour result;
    bool is_whole = true;
    for (double& value : result.channels) {
      const std::string_view word = next_word(line);
      if (!parse(word, value)) return {};
      is_whole = is_whole && word.find('.') == std::string_view::npos;
    }
    has_colours_ = true;
    const bool is_bright = result.channels.maxCoeff() > brightest_channel;
    result.scale = is_whole || is_bright ? Off_colour::OF_FILE : Off_colour::UNIT;
    if (is_bright) white_ = 255;
    return result;
  }

  Eigen::Vector3f linear(const Off_colour& colour) const
  {
    const double white = colour.scale == Off_colour::OF_FILE ? white_ : 1;
    return linear_colour(colour.channels / white).cast<float>();
  }

  /// Whether the rest of a line is three or four integers up to 255: a colour that the keyword does not announce.
  static bool is_colour(std::string_view line)
  {
    int numbers = 0;
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line), ++numbers)
      if (std::uint8_t value = 0; !parse(word, value)) return false;
    return numbers == 3 || numbers == 4;
  }

  template <typename Number>
  Number number_in_any_line()
  {
    while (trimmed(line_).empty())
      line_ = next_line_of_words();
    return number<Number>(line_);
  }

  template <typename Number>
  Number number(std::string_view& line) const
  {
    const std::string_view word = next_word(line);
    Number result{};
    if (!parse(word, result)) fail("has " + cited(word) + " where a number is expected");
    return result;
  }

  void read_vertex()
  {
    std::string_view line = next_line_of_words();
    Point point;
    for (double& coordinate : point)
      coordinate = number<double>(line);
    if (has_weights_) point /= number<double>(line);
    points_.push_back(point);
    if (!vertices_have_colours_ && !normals_come_first_ && is_colour(line)) vertices_have_colours_ = true;
    if (!vertices_have_colours_) return;
    for (int i = 0; normals_come_first_ && i < 3; ++i)
      next_word(line);
    colours_.resize(points_.size());
    colours_.back() = colour(line);
  }

  void read_face(std::size_t face, Model_content& result)
  {
    std::string_view line = next_line_of_words();
    const std::size_t corners = number<std::size_t>(line);
    if (corners > line.size()) fail("has a face of " + std::to_string(corners) + " corners, but not so many numbers");
    polygon_.clear();
    std::vector<std::size_t> vertices;
    for (std::size_t i = 0; i < corners; ++i) {
      const std::size_t index = number<std::size_t>(line);
      if (index >= points_.size())
        fail("has a face that uses vertex " + std::to_string(index) + ", but there are only " +
             std::to_string(points_.size()) + " (numbered from 0)");
      polygon_.push_back(points_[index]);
      vertices.push_back(index);
    }
    if (corners < 3) ++result.faces_left_out;
    const Off_colour of_face = vertices_have_colours_ ? Off_colour() : colour(line);
    Model_part& part = result.parts[0];
    for (std::size_t corner : triangles_of_polygon(polygon_)) {
      part.corners.push_back(polygon_[corner]);
      part.vertices.push_back(int(vertices[corner]));
      colours_of_corners_.push_back(vertices_have_colours_ ? colours_[vertices[corner]] : of_face);
    }
    part.faces.resize(part.corners.size() / 3, face);
  }

  Model_lines lines_;
  const std::string& file_;
  std::vector<Point> points_, polygon_;
  std::string_view line_;                                ///< unread part of a line of the header
  std::vector<Off_colour> colours_, colours_of_corners_; ///< colours of vertices, and of corners of triangles
  double white_ = 1;                                     ///< value of a full channel for `OF_FILE`
  bool has_weights_ = false, has_dimension_ = false, normals_come_first_ = false;
  bool vertices_have_colours_ = false, has_colours_ = false;
};

} // namespace

Model_content read_off_part(std::string_view text, const std::string& file) { return Off_reader(text, file).read(); }

} // namespace CGAL::Shape_correspondence::IO
