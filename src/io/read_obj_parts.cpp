// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/model_parts.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string_view>

// An own reader for Wavefront OBJ: assimp keeps coordinates as float, so a shape far from the origin would lose digits,
// and CGAL's reader drops the names of objects and groups.

namespace CGAL::Shape_correspondence::IO {
namespace {

std::string_view trimmed(std::string_view text)
{
  const char* const blanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// Takes the first word off `text`.
std::string_view next_word(std::string_view& text)
{
  text = trimmed(text);
  const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(end);
  return word;
}

template <typename Number>
bool parse(std::string_view word, Number& number)
{
  if (!word.empty() && word[0] == '+') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}

/// A part under construction: an `o` statement, or a `g` statement inside one.
struct Section
{
  std::string object;
  std::string group;
  std::vector<std::vector<std::size_t>> polygons;
};

class Obj_reader
{
public:
  explicit Obj_reader(const std::string& file) : file_(file), sections_(1) {}

  std::vector<Model_part> read()
  {
    std::ifstream in(file_, std::ios::binary);
    std::string line;
    while (std::getline(in, line)) {
      ++line_number_;
      join_continued(in, line);
      read_statement(trimmed(std::string_view(line).substr(0, line.find('#'))));
    }
    return parts();
  }

private:
  [[noreturn]] void fail(const std::string& what) const
  {
    throw Invalid_input(file_ + ", line " + std::to_string(line_number_) + ": " + what);
  }

  void join_continued(std::istream& in, std::string& line)
  {
    std::string next;
    while (!trimmed(line).empty() && trimmed(line).back() == '\\' && std::getline(in, next)) {
      ++line_number_;
      line = std::string(trimmed(line));
      line.back() = ' ';
      line += next;
    }
  }

  void read_statement(std::string_view statement)
  {
    const std::string_view keyword = next_word(statement);
    if (keyword == "v")
      read_vertex(statement);
    else if (keyword == "f" || keyword == "fo")
      read_face(statement);
    else if (keyword == "o")
      sections_.push_back({name_of(statement, "object"), "", {}});
    else if (keyword == "g")
      sections_.push_back({sections_.back().object, name_of(statement, "default"), {}});
  }

  static std::string name_of(std::string_view statement, const std::string& otherwise)
  {
    const std::string name(trimmed(statement));
    return name.empty() ? otherwise : name;
  }

  void read_vertex(std::string_view statement)
  {
    Point point;
    for (double& coordinate : point) {
      const std::string_view word = next_word(statement);
      if (!parse(word, coordinate)) fail("a vertex needs three numbers; '" + std::string(word) + "' is none");
    }
    points_.push_back(point);
  }

  void read_face(std::string_view statement)
  {
    std::vector<std::size_t> polygon;
    for (std::string_view word = next_word(statement); !word.empty(); word = next_word(statement))
      polygon.push_back(vertex_index(word.substr(0, word.find('/'))));
    if (polygon.size() < 3) fail("a face needs three vertices or more");
    sections_.back().polygons.push_back(std::move(polygon));
  }

  std::size_t vertex_index(std::string_view word) const
  {
    long long index = 0;
    if (!parse(word, index)) fail("'" + std::string(word) + "' is not a vertex number");
    const long long count = static_cast<long long>(points_.size());
    if (index == 0 || index > count || index < -count)
      fail("a face uses vertex " + std::to_string(index) + ", but " + std::to_string(count) +
           " vertices come before it" + in_part());
    return static_cast<std::size_t>(index > 0 ? index - 1 : count + index);
  }

  std::string in_part() const
  {
    const Section& section = sections_.back();
    const std::string& name = section.group.empty() ? section.object : section.group;
    return name.empty() ? "" : " (part '" + name + "')";
  }

  /// A group's own name, preceded by its object's where groups of several objects share it.
  std::string part_name(const Section& section) const
  {
    if (section.group.empty()) return section.object;
    for (const Section& other : sections_) {
      if (!other.polygons.empty() && other.group == section.group && other.object != section.object)
        return section.object.empty() ? section.group : section.object + "/" + section.group;
    }
    return section.group;
  }

  std::vector<Model_part> parts() const
  {
    std::vector<Model_part> result;
    std::vector<Point> polygon;
    for (const Section& section : sections_) {
      if (section.polygons.empty()) continue;
      result.push_back({part_name(section), {}});
      for (const std::vector<std::size_t>& indices : section.polygons) {
        polygon.clear();
        for (std::size_t i : indices)
          polygon.push_back(points_[i]);
        add_polygon(polygon, result.back().corners);
      }
    }
    if (result.empty())
      throw Invalid_input(file_ + ": there is no face in it; it is not a Wavefront OBJ model, or an empty one");
    return result;
  }

  std::string file_;
  std::size_t line_number_ = 0;
  std::vector<Point> points_;
  std::vector<Section> sections_;
};

} // namespace

std::vector<Model_part> read_obj_parts(const std::string& file) { return Obj_reader(file).read(); }

} // namespace CGAL::Shape_correspondence::IO
