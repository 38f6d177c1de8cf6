// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "io/model_parts.h"
#include "io/text_words.h"
#include "shape/Loose_piece.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <map>

// An own reader for Wavefront OBJ: assimp keeps coordinates as float, so a shape far from the origin would lose digits,
// and CGAL's reader drops the names of objects and groups.

namespace CGAL::Shape_correspondence::IO {
namespace {

// Share of the surface. Of 20 files of one object and several materials whose parts are known, all are better divided
// by materials above it, and none below; the pieces have at most .70 or at least .93.
constexpr double mostly_one_piece = 0.8;

/// A part under construction: an `o` statement, or a `g` statement inside one.
struct Section
{
  std::string object;
  std::string group;
  std::vector<std::vector<std::size_t>> polygons;
  std::vector<std::string> materials; ///< of the polygons
};

class Obj_reader
{
public:
  Obj_reader(std::string_view text, const std::string& file) : text_(text), file_(file), sections_(1) {}

  Model_content read()
  {
    while (!text_.empty())
      read_statement(trimmed(without_comment(next_statement())));
    divide_by_materials();
    return content();
  }

private:
  [[noreturn]] void fail(const std::string& what) const
  {
    throw Invalid_input(file_ + ", line " + std::to_string(line_number_) + ": " + what);
  }

  /// A line, and those that it is continued on by a backslash at its end.
  std::string_view next_statement()
  {
    std::string_view line = read_line();
    if (!is_continued(line)) return line;
    joined_.clear();
    for (; is_continued(line); line = read_line())
      joined_.append(line, 0, line.find_last_of('\\')).append(1, ' ');
    return joined_.append(line);
  }

  std::string_view read_line()
  {
    ++line_number_;
    return next_line(text_);
  }

  static bool is_continued(std::string_view line)
  {
    const std::string_view text = trimmed(line);
    return !text.empty() && text.back() == '\\';
  }

  /// A # inside a word is no comment: names have it.
  static std::string_view without_comment(std::string_view line)
  {
    std::size_t hash = line.find('#');
    while (hash != std::string_view::npos && hash > 0 && line[hash - 1] != ' ' && line[hash - 1] != '\t')
      hash = line.find('#', hash + 1);
    return line.substr(0, hash);
  }

  void read_statement(std::string_view statement)
  {
    const std::string_view keyword = next_word(statement);
    if (keyword == "v")
      read_vertex(statement);
    else if (keyword == "f" || keyword == "fo")
      read_face(statement);
    else if (keyword == "o")
      sections_.push_back({name_of(statement, "object"), "", {}, {}});
    else if (keyword == "g")
      sections_.push_back({sections_.back().object, name_of(statement, "default"), {}, {}});
    else if (keyword == "usemtl")
      material_ = trimmed(statement);
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
      if (!parse(word, coordinate)) fail("a vertex needs three numbers; " + cited(word) + " is none");
    }
    points_.push_back(point);
  }

  void read_face(std::string_view statement)
  {
    std::vector<std::size_t> polygon;
    for (std::string_view word = next_word(statement); !word.empty(); word = next_word(statement))
      polygon.push_back(vertex_index(word.substr(0, word.find('/'))));
    if (polygon.size() < 3) {
      ++faces_left_out_;
      return;
    }
    sections_.back().polygons.push_back(std::move(polygon));
    sections_.back().materials.push_back(material_);
  }

  std::size_t vertex_index(std::string_view word) const
  {
    long long index = 0;
    if (!parse(word, index)) fail(cited(word) + " is not a vertex number");
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
    return name.empty() ? "" : " (part " + cited(name) + ")";
  }

  /// Whether loose pieces do not tell the parts of an object: one is most of its surface, or they are too many.
  bool needs_materials(const Section& section) const
  {
    const std::vector<Part_mesh> pieces = internal::loose_pieces(weld(corners_of(section)));
    double largest = 0, all = 0;
    for (const Part_mesh& piece : pieces) {
      const double area = internal::loose_piece(0, piece).area;
      largest = std::max(largest, area);
      all += area;
    }
    return pieces.size() > internal::most_parts || largest > mostly_one_piece * all;
  }

  std::vector<Point> corners_of(const Section& section) const
  {
    std::vector<Point> result, polygon;
    for (const std::vector<std::size_t>& indices : section.polygons) {
      polygon.clear();
      for (std::size_t i : indices)
        polygon.push_back(points_[i]);
      add_polygon(polygon, result);
    }
    return result;
  }

  /// In a file of one object materials stand for objects where its pieces do not.
  void divide_by_materials()
  {
    const auto has_faces = [](const Section& section) { return !section.polygons.empty(); };
    if (std::count_if(sections_.begin(), sections_.end(), has_faces) != 1) return;
    const Section whole = *std::find_if(sections_.begin(), sections_.end(), has_faces);
    std::map<std::string, std::size_t> number;
    std::vector<Section> divided;
    for (std::size_t i = 0; i < whole.polygons.size(); ++i) {
      const std::string& material = whole.materials[i];
      if (number.emplace(material, divided.size()).second)
        divided.push_back({material.empty() ? whole.object : material, "", {}, {}});
      divided[number[material]].polygons.push_back(whole.polygons[i]);
    }
    if (divided.size() > 1 && needs_materials(whole)) sections_ = std::move(divided);
  }

  /// The objects that have a group of each name with faces, up to two.
  std::map<std::string, std::vector<std::string>> objects_of_groups() const
  {
    std::map<std::string, std::vector<std::string>> result;
    for (const Section& section : sections_) {
      if (section.polygons.empty()) continue;
      std::vector<std::string>& objects = result[section.group];
      if (objects.empty() || (objects.size() < 2 && objects[0] != section.object)) objects.push_back(section.object);
    }
    return result;
  }

  Model_content content() const
  {
    const std::map<std::string, std::vector<std::string>> objects = objects_of_groups();
    // A group's own name, preceded by its object's where groups of several objects share it
    const auto part_name = [&](const Section& section) {
      if (section.group.empty()) return section.object;
      const bool is_shared = objects.at(section.group).size() > 1 && !section.object.empty();
      return is_shared ? section.object + "/" + section.group : section.group;
    };
    Model_content result;
    result.faces_left_out = faces_left_out_;
    for (const Section& section : sections_)
      if (!section.polygons.empty()) result.parts.push_back({part_name(section), corners_of(section)});
    if (result.parts.empty())
      throw Invalid_input(file_ + ": there is no face in it; it is not a Wavefront OBJ model, or an empty one");
    return result;
  }

  std::string_view text_;
  std::string joined_; ///< a statement of several lines
  std::string file_;
  std::size_t line_number_ = 0;
  std::size_t faces_left_out_ = 0;
  std::vector<Point> points_;
  std::vector<Section> sections_;
  std::string material_; ///< of the faces that come next
};

} // namespace

Model_content read_obj_parts(std::string_view text, const std::string& file) { return Obj_reader(text, file).read(); }

} // namespace CGAL::Shape_correspondence::IO
