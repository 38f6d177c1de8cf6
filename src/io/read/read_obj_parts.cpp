// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/Disjoint_sets.h"
#include "base/limits.h"
#include "io/read/model_parts.h"
#include "io/read/text_words.h"
#include "io/system/colours.h"
#include "io/system/quoting.h"
#include "shape/Loose_piece.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>

// This reader is used since assimp stores coordinates as float, which loses digits for shapes far from the origin, and
// CGAL's reader drops the names of objects and groups.

namespace CGAL::Shape_correspondence::IO {
namespace {

// Share of an object's area in its largest loose piece beyond which materials divide it better than pieces. In 20 files
// of one object with several materials and known parts, this share was at most .70 or at least .93.
constexpr double mostly_one_piece = 0.8;

/// A face as in the file.
struct Obj_polygon
{
  std::vector<std::size_t> vertices;
  std::vector<int> coordinates; ///< for each corner, the index of its texture coordinates, -1: none; or empty
  int material = -1;            ///< index of the material's name
  std::size_t number = 0;       ///< index among the faces of the file
};

/// A part under construction: an `o` statement, or a `g` statement inside one.
struct Section
{
  std::string object;
  std::string group;
  std::vector<Obj_polygon> polygons;
};

// Channel of a vertex colour above which white must be 255 rather than 1.
constexpr double brightest = 1.5;

constexpr std::string_view painted_vertices = "#MRGB ";

class Obj_reader
{
public:
  Obj_reader(std::string_view text, const std::string& file) : lines_(text, file), file_(file), sections_(1) {}

  Model_content read()
  {
    while (!lines_.rest().empty())
      read_statement(next_statement());
    join_groups();
    divide_by_materials();
    return content();
  }

private:
  /// The next line without its comment, joined with continuation lines (after a backslash) if these continue a list of
  /// numbers; a name may end in a backslash as well.
  std::string_view next_statement()
  {
    std::string_view line = lines_.next();
    if (begins_with(line, painted_vertices)) read_painted_vertices(line.substr(painted_vertices.size()));
    if (begins_with(line, "# "))
      if (const std::optional<Point> up = up_in_mark(line.substr(2))) up_ = up;
    line = trimmed(without_comment(line));
    if (line.empty() || line.back() != '\\' || !has_numbers(line)) return line;
    joined_.clear();
    for (; is_continued(line); line = trimmed(without_comment(lines_.next())))
      joined_.append(line, 0, line.size() - 1).append(1, ' ');
    return joined_.append(line, 0, line.find_last_not_of('\\') + 1);
  }

  /// Whether the line ends in a backslash and the next one starts with a number.
  bool is_continued(std::string_view line) const
  {
    if (line.empty() || line.back() != '\\') return false;
    std::string_view rest = lines_.rest();
    const std::string_view next = trimmed(next_line(rest));
    return !next.empty() && std::string_view("+-.0123456789\\").find(next[0]) != std::string_view::npos;
  }

  static bool has_numbers(std::string_view line)
  {
    const auto keywords = {"v", "vt", "vn", "vp", "f", "fo", "l", "p", "curv", "curv2", "surf", "parm", "trim", "hole"};
    return std::find(keywords.begin(), keywords.end(), next_word(line)) != keywords.end();
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
    else if (keyword == "usemtl")
      use_material(std::string(trimmed(statement)));
    else if (keyword == "vt")
      read_texture_coordinates(statement);
    else if (keyword == "mtllib")
      libraries_.emplace_back(trimmed(statement));
  }

  /// Reads a vertex: coordinates, optionally followed by a weight, a colour, or a colour and its opacity.
  void read_vertex(std::string_view statement)
  {
    points_.push_back(lines_.vertex(statement));
    for (int i = 0; i < 3; ++i)
      next_word(statement);
    Eigen::Vector3d colour;
    for (double& channel : colour)
      if (!parse(next_word(statement), channel)) return;
    colours_.resize(points_.size(), Eigen::Vector3d::Constant(-1));
    colours_.back() = colour;
    if (colour.maxCoeff() > brightest) white_ = 255;
  }

  /// Reads colours of vertices from a comment of ZBrush: mask, red, green and blue in hexadecimal for each vertex.
  void read_painted_vertices(std::string_view digits)
  {
    constexpr std::size_t digits_of_vertex = 8;
    for (digits = trimmed(digits); digits.size() >= digits_of_vertex; digits.remove_prefix(digits_of_vertex)) {
      std::uint32_t colour = 0;
      const char* const end = digits.data() + digits_of_vertex;
      if (std::from_chars(digits.data(), end, colour, 16).ptr != end) return;
      painted_.push_back(Eigen::Vector3d(colour >> 16 & 255, colour >> 8 & 255, colour & 255) / 255);
    }
  }

  void use_material(const std::string& name)
  {
    material_ = material_numbers_.emplace(name, int(materials_.size())).first->second;
    if (std::size_t(material_) == materials_.size()) materials_.push_back(name);
  }

  /// Reads texture coordinates. Unreadable numbers count as 0, since a damaged appearance shall not make a model fail.
  void read_texture_coordinates(std::string_view statement)
  {
    Eigen::Vector2f at(0, 0);
    for (float& coordinate : at)
      if (!parse(next_word(statement), coordinate)) coordinate = 0;
    coordinates_.emplace_back(at.x(), 1 - at.y());
  }

  std::string name_of(std::string_view statement, const std::string& otherwise) const
  {
    const std::string name(trimmed(statement));
    return name.empty() ? otherwise : up_ ? percent_decoded(name) : name;
  }

  void read_face(std::string_view statement)
  {
    Obj_polygon polygon;
    polygon.material = material_;
    polygon.number = number_of_faces_++;
    for (std::string_view word = next_word(statement); !word.empty(); word = next_word(statement)) {
      const std::size_t slash = std::min(word.find('/'), word.size());
      polygon.vertices.push_back(vertex_index(word.substr(0, slash)));
      if (!coordinates_.empty()) polygon.coordinates.push_back(coordinate_index(word.substr(slash)));
    }
    if (polygon.vertices.size() < 3) {
      ++faces_left_out_;
      return;
    }
    sections_.back().polygons.push_back(std::move(polygon));
  }

  /// The index of an element by its number in a file, negative if counted from the last one; none if it does not exist.
  static std::optional<std::size_t> place_of(long long number, std::size_t elements)
  {
    const auto count = static_cast<long long>(elements);
    if (number == 0 || number > count || number < -count) return std::nullopt;
    return std::size_t(number > 0 ? number - 1 : count + number);
  }

  /// The index of a corner's texture coordinates; -1: none. \param rest the corner's text from its first slash on
  int coordinate_index(std::string_view rest) const
  {
    long long number = 0;
    if (rest.empty() || !parse(rest.substr(1, rest.find('/', 1) - 1), number)) return -1;
    const std::optional<std::size_t> place = place_of(number, coordinates_.size());
    return place ? int(*place) : -1;
  }

  std::size_t vertex_index(std::string_view word) const
  {
    long long number = 0;
    if (!parse(word, number)) lines_.fail(cited(word) + " is not a vertex number");
    if (const std::optional<std::size_t> place = place_of(number, points_.size())) return *place;
    lines_.fail("a face uses vertex " + std::to_string(number) + ", but " + std::to_string(points_.size()) +
                " vertices come before it" + in_part());
  }

  std::string in_part() const
  {
    const Section& section = sections_.back();
    const std::string& name = section.group.empty() ? section.object : section.group;
    return name.empty() ? "" : " (part " + cited(name) + ")";
  }

  /// Whether the loose pieces of an object cannot be its parts: one has most of the surface, or there are too many.
  bool needs_materials(const Section& section) const
  {
    const Part_mesh mesh = weld(part_of(section, "").corners);
    const std::vector<internal::Loose_piece> pieces = internal::loose_pieces(0, mesh, 0, {});
    double largest = 0, all = 0;
    for (const internal::Loose_piece& piece : pieces) {
      largest = std::max(largest, piece.area);
      all += piece.area;
    }
    return pieces.size() > internal::most_parts || largest > mostly_one_piece * all;
  }

  /// Colour in linear light; white for vertices without a colour.
  Eigen::Vector3f colour_of(std::size_t vertex) const
  {
    const std::vector<Eigen::Vector3d>& colours = painted_.empty() ? colours_ : painted_;
    if (vertex >= colours.size() || colours[vertex].minCoeff() < 0) return Eigen::Vector3f::Ones();
    return linear_colour(colours[vertex] / (painted_.empty() ? white_ : 1)).cast<float>();
  }

  Model_part part_of(const Section& section, const std::string& name) const
  {
    Model_part result{name, {}};
    std::vector<Point> polygon;
    const bool has_colours = !colours_.empty() || !painted_.empty();
    for (const Obj_polygon& of_file : section.polygons) {
      polygon.clear();
      for (std::size_t i : of_file.vertices)
        polygon.push_back(points_[i]);
      const std::vector<std::size_t> corners = triangles_of_polygon(polygon);
      for (std::size_t corner : corners) {
        result.corners.push_back(polygon[corner]);
        result.vertices.push_back(int(of_file.vertices[corner]));
        const int number = of_file.coordinates.empty() ? -1 : of_file.coordinates[corner];
        if (!coordinates_.empty())
          result.appearance.coordinates.push_back(number < 0 ? Eigen::Vector2f(0, 0)
                                                             : coordinates_[std::size_t(number)]);
        if (has_colours) result.appearance.colours.push_back(colour_of(of_file.vertices[corner]));
      }
      result.faces.insert(result.faces.end(), corners.size() / 3, of_file.number);
      if (!materials_.empty())
        result.appearance.materials.insert(result.appearance.materials.end(), corners.size() / 3, of_file.material);
    }
    return result;
  }

  /// Unites sections that share vertices, and so belong to one part: those of one object if `by_object`, else those of
  /// one group of an object.
  internal::Disjoint_sets sections_with_shared_vertices(bool by_object) const
  {
    internal::Disjoint_sets sets(sections_.size());
    std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> by_name;
    for (std::size_t i = 0; i < sections_.size(); ++i) {
      const auto& [object, group, polygons] = sections_[i];
      if (!polygons.empty()) by_name[{object, by_object && !object.empty() ? "" : group}].push_back(i);
    }
    for (const auto& [name, sections] : by_name) {
      std::unordered_map<std::size_t, std::size_t> first; // the first section with each vertex
      if (sections.size() > 1)
        for (std::size_t i : sections)
          for (const Obj_polygon& polygon : sections_[i].polygons)
            for (std::size_t vertex : polygon.vertices)
              sets.unite(first.emplace(vertex, i).first->second, i);
    }
    return sets;
  }

  /// Drops sections without faces, as from a `g` before vertices only, and lists objects without faces.
  void note_objects_without_faces()
  {
    std::set<std::string> have_faces;
    for (const Section& section : sections_)
      if (!section.polygons.empty()) have_faces.insert(section.object);
    for (const Section& section : sections_)
      if (have_faces.insert(section.object).second && !section.object.empty()) without_faces_.push_back(section.object);
    const auto is_empty = [](const Section& section) { return section.polygons.empty(); };
    sections_.erase(std::remove_if(sections_.begin(), sections_.end(), is_empty), sections_.end());
  }

  /// Joins groups that are not parts: a repeated group with shared vertices, and groups of an object that share
  /// vertices, which are regions of a surface - unless this would leave a single part.
  void join_groups()
  {
    note_objects_without_faces();
    if (up_) return; // a file written by this program: the objects are the parts
    internal::Disjoint_sets sets = sections_with_shared_vertices(true);
    if (sets.number_of_sets() == 1) sets = sections_with_shared_vertices(false);
    std::vector<Section> joined;
    std::map<std::size_t, std::size_t> place; // index in `joined`, by set
    for (std::size_t i = 0; i < sections_.size(); ++i) {
      Section& section = sections_[i];
      if (const auto [known, is_new] = place.emplace(sets[i], joined.size()); is_new) {
        joined.push_back(std::move(section));
      } else {
        Section& whole = joined[known->second];
        if (whole.group != section.group) whole.group.clear();
        std::move(section.polygons.begin(), section.polygons.end(), std::back_inserter(whole.polygons));
      }
    }
    sections_ = std::move(joined);
  }

  /// Divides a file of one object by materials if its loose pieces cannot be the parts.
  void divide_by_materials()
  {
    if (sections_.size() != 1 || up_) return;
    const Section whole = sections_[0];
    std::map<std::string, std::size_t> number;
    std::vector<Section> divided;
    for (const Obj_polygon& polygon : whole.polygons) {
      const std::string material = polygon.material < 0 ? "" : materials_[std::size_t(polygon.material)];
      if (number.emplace(material, divided.size()).second)
        divided.push_back({material.empty() ? whole.object : material, "", {}});
      divided[number[material]].polygons.push_back(polygon);
    }
    if (divided.size() > 1 && needs_materials(whole)) sections_ = std::move(divided);
  }

  /// The names shared by groups of several objects.
  std::set<std::string> shared_groups() const
  {
    std::set<std::string> result;
    std::map<std::string, std::string> objects; // the first object with each group
    for (const Section& section : sections_)
      if (objects.emplace(section.group, section.object).first->second != section.object) result.insert(section.group);
    return result;
  }

  Model_content content() const
  {
    const std::set<std::string> shared = shared_groups();
    // The group's name, preceded by the object's if groups of several objects share it
    const auto part_name = [&](const Section& section) {
      if (section.group.empty()) return section.object;
      return shared.count(section.group) > 0 && !section.object.empty() ? section.object + "/" + section.group
                                                                        : section.group;
    };
    Model_content result;
    result.faces_left_out = faces_left_out_;
    result.number_of_faces = number_of_faces_;
    result.number_of_vertices = points_.size();
    for (const Section& section : sections_)
      result.parts.push_back(part_of(section, part_name(section)));
    for (const std::string& material : materials_)
      result.materials.push_back({material, Eigen::Vector4d::Ones(), -1});
    result.materials_are_names = true;
    result.libraries = libraries_;
    result.without_faces = without_faces_;
    result.are_labelled = up_.has_value();
    result.up = up_.value_or(Point::Zero());
    if (result.parts.empty())
      throw Invalid_input(
          file_ + ": there is no face in it: it is not a Wavefront OBJ model, or an empty one; give every part a mesh");
    return result;
  }

  Model_lines lines_;
  std::string joined_; ///< a statement that spans several lines
  const std::string& file_;
  std::size_t faces_left_out_ = 0, number_of_faces_ = 0;
  std::vector<Point> points_;
  std::vector<Eigen::Vector3d> colours_; ///< colours of vertices, up to the last one with a colour; negative: none
  std::vector<Eigen::Vector3d> painted_; ///< colours of vertices, from ZBrush's comments
  double white_ = 1;                     ///< value of a full channel in `colours_`
  std::vector<Section> sections_;
  std::vector<Eigen::Vector2f> coordinates_;
  std::vector<std::string> materials_, libraries_; ///< names of materials and of their files
  std::map<std::string, int> material_numbers_;
  int material_ = -1; ///< material of the following faces
  std::vector<std::string> without_faces_;
  std::optional<Point> up_; ///< given in files that this program wrote
};

} // namespace

Model_content read_obj_parts(std::string_view text, const std::string& file) { return Obj_reader(text, file).read(); }

} // namespace CGAL::Shape_correspondence::IO
