// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_parts.h"
#include "io/read/text_words.h"
#include "io/system/colours.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

// An own reader for OFF: CGAL's trusts the counts in the file.

namespace CGAL::Shape_correspondence::IO {
namespace {

class Off_reader
{
public:
  Off_reader(std::string_view text, const std::string& file) : lines_(text, file), file_(file) {}

  Model_content read()
  {
    std::string_view line = next_line_of_words();
    check_keyword(next_word(line));
    if (trimmed(line) == "BINARY") fail("is binary, and only OFF as text is read; convert it, or write PLY or OBJ");
    if (trimmed(line).empty()) line = next_line_of_words();
    const std::size_t vertices = number<std::size_t>(line), faces = number<std::size_t>(line);
    constexpr std::size_t least_vertex = 6, least_face = 2; // bytes of a line
    if (vertices > lines_.rest().size() / least_vertex || faces > lines_.rest().size() / least_face)
      fail("says that it has " + std::to_string(vertices) + " vertices and " + std::to_string(faces) +
               " faces, which is more than the file holds: it is cut off or damaged",
           remedy::save_again);
    if (faces == 0) throw Invalid_input(file_ + ": there is no face in it; give every part a mesh");
    for (std::size_t i = 0; i < vertices; ++i)
      read_vertex();
    Model_content result;
    result.parts.emplace_back();
    for (std::size_t i = 0; i < faces; ++i)
      read_face(result);
    if (!has_colours_) result.parts[0].appearance.colours.clear();
    return result;
  }

private:
  [[noreturn]] void fail(const std::string& what, const char* remedy = remedy::correct_text) const
  {
    lines_.fail("it cannot be read as an OFF model: it " + what, remedy);
  }

  /// The next line that is more than blanks and a comment.
  std::string_view next_line_of_words()
  {
    while (!lines_.rest().empty()) {
      const std::string_view line = lines_.next();
      const std::string_view words = trimmed(line.substr(0, line.find('#')));
      if (!words.empty()) return words;
    }
    fail("ends before all of its vertices and faces are there: the file is cut off", remedy::save_again);
  }

  /// Normals, colours and texture coordinates follow the coordinates; colours are read.
  void check_keyword(std::string_view word)
  {
    constexpr std::string_view keyword = "OFF";
    if (word.size() < keyword.size() || word.substr(word.size() - keyword.size()) != keyword)
      fail("does not begin with the word OFF", remedy::check_kind);
    if (word.find_first_not_of("STCNOF") != std::string_view::npos)
      fail("is not three-dimensional", remedy::save_as_other_format);
    const std::string_view letters = word.substr(0, word.size() - keyword.size());
    vertices_have_colours_ = letters.find('C') != std::string_view::npos;
    vertices_have_normals_ = letters.find('N') != std::string_view::npos;
  }

  /// The colour at the beginning of the rest of a line, white where there is none: whole numbers are up to 255, others
  /// up to 1.
  Eigen::Vector3f colour(std::string_view line)
  {
    Eigen::Vector3d result;
    bool is_whole = true;
    for (double& value : result) {
      const std::string_view word = next_word(line);
      if (!parse(word, value)) return Eigen::Vector3f::Ones();
      is_whole = is_whole && word.find('.') == std::string_view::npos;
    }
    has_colours_ = true;
    return linear_colour(is_whole ? Eigen::Vector3d(result / 255) : result).cast<float>();
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
    points_.push_back(point);
    if (!vertices_have_colours_) return;
    for (int i = 0; vertices_have_normals_ && i < 3; ++i)
      next_word(line);
    colours_.push_back(colour(line));
  }

  void read_face(Model_content& result)
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
    const Eigen::Vector3f of_face = vertices_have_colours_ ? Eigen::Vector3f::Ones() : colour(line);
    Model_part& part = result.parts[0];
    for (std::size_t corner : triangles_of_polygon(polygon_)) {
      part.corners.push_back(polygon_[corner]);
      part.appearance.colours.push_back(vertices_have_colours_ ? colours_[vertices[corner]] : of_face);
    }
  }

  Model_lines lines_;
  const std::string& file_;
  std::vector<Point> points_, polygon_;
  std::vector<Eigen::Vector3f> colours_; ///< of vertices
  bool vertices_have_colours_ = false, vertices_have_normals_ = false, has_colours_ = false;
};

} // namespace

Model_content read_off_part(std::string_view text, const std::string& file) { return Off_reader(text, file).read(); }

} // namespace CGAL::Shape_correspondence::IO
