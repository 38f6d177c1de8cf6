// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_parts.h"
#include "io/read/text_words.h"
#include "io/system/bytes.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

namespace CGAL::Shape_correspondence::IO {
namespace {

// Binary files have a header of 80 bytes, a count, and for each triangle a normal, three corners and two bytes
constexpr std::size_t header_size = 84, triangle_size = 50, normal_size = 12;

constexpr int most_lines_before = 100; // number of lines that may come before the first solid of a text

std::uint32_t count_in(std::string_view text) { return number_in<std::uint32_t>(text.data() + header_size - 4); }

/// Whether a file, or the rest of it, starts with a header whose count is positive and fits the remaining bytes.
bool begins_with_binary(std::string_view text)
{
  return text.size() >= header_size && count_in(text) > 0 &&
         count_in(text) <= (text.size() - header_size) / triangle_size;
}

/// Whether a file is text. Binary headers may start with "solid", too, but they, or the count, contain zeros.
bool is_text(std::string_view text)
{
  if (text.size() >= header_size && text.size() == header_size + triangle_size * std::size_t(count_in(text)))
    return false;
  if (text.substr(0, header_size).find('\0') != std::string_view::npos) return false;
  for (int i = 0; i < most_lines_before && !text.empty(); ++i) {
    std::string_view line = next_line(text);
    const std::string keyword = lower(next_word(line));
    if (keyword == "solid" || keyword == "facet") return true;
  }
  return false;
}

/// Whether 50 bytes look like a triangle: the normal has length 1 or 0.
bool is_triangle(const char* bytes)
{
  constexpr float tolerance = 0.01f;
  float squared = 0;
  for (std::size_t i = 0; i < normal_size; i += 4)
    squared += number_in<float>(bytes + i) * number_in<float>(bytes + i);
  return squared == 0 || std::abs(squared - 1) < tolerance;
}

class Stl_reader
{
public:
  Stl_reader(std::string_view text, const std::string& file) : rest_(text), file_(file) {}

  /// Reads a file, which may be a concatenation of several files.
  Model_content read()
  {
    do
      if (is_text(rest_))
        read_text();
      else
        read_binary();
    while (is_text(rest_) || begins_with_binary(rest_));
    name_binary_parts();
    const auto is_empty = [](const Model_part& part) { return part.corners.empty(); };
    for (const Model_part& part : result_.parts)
      if (is_empty(part)) result_.without_faces.push_back(part.name);
    result_.parts.erase(std::remove_if(result_.parts.begin(), result_.parts.end(), is_empty), result_.parts.end());
    if (result_.parts.empty()) throw Invalid_input(file_ + ": there is no triangle in it; give every part a mesh");
    if (rest_.find_first_not_of(std::string_view(" \t\r\n\0\x1A", 6)) != std::string_view::npos)
      warn("What follows after the last triangle is no STL and was left out: " + std::to_string(rest_.size()) +
           " bytes.");
    if (lines_left_out_ > 0) warn("Lines that are no STL were left out: " + std::to_string(lines_left_out_) + ".");
    number_faces();
    return std::move(result_);
  }

private:
  void warn(const std::string& warning) { result_.warnings.push_back(warning); }

  void read_binary()
  {
    if (rest_.size() < header_size)
      throw Invalid_input(file_ + ": it cannot be read as an STL model: it is another kind of file, or cut off; " +
                          remedy::check_kind);
    const std::size_t given = count_in(rest_), room = (rest_.size() - header_size) / triangle_size;
    const bool fills_file = (rest_.size() - header_size) % triangle_size == 0;
    std::size_t count = given;
    // Programs that stream triangles do not know their number when they write the header
    if (fills_file && (given == 0 || given == std::numeric_limits<std::uint32_t>::max())) count = room;
    if (count > room)
      throw Invalid_input(file_ + ": it cannot be read as an STL model: it says that it has " + std::to_string(count) +
                          " triangles, which is more than the file holds: it is cut off or damaged; " +
                          remedy::save_again);
    const char* triangle = rest_.data() + header_size;
    if (fills_file && count < room && is_triangle(triangle + count * triangle_size)) count = room;
    if (count != given)
      warn("The file says that it has " + std::to_string(given) + " triangles, but it holds, and " +
           std::to_string(count) + " were read.");
    Model_part& part = result_.parts.emplace_back();
    headers_.resize(result_.parts.size());
    headers_.back() = trimmed(rest_.substr(0, std::min(rest_.find('\0'), header_size - 4)));
    for (std::size_t t = 0; t < count; ++t, triangle += triangle_size)
      for (std::size_t k = 0; k < 3; ++k) {
        Point corner;
        for (std::size_t i = 0; i < 3; ++i)
          corner[Eigen::Index(i)] = number_in<float>(triangle + normal_size + 4 * (3 * k + i));
        part.corners.push_back(corner);
      }
    rest_.remove_prefix(header_size + count * triangle_size);
  }

  /// Reads the solids up to the end of the text, one part for each.
  void read_text()
  {
    Model_lines lines(rest_, file_);
    std::size_t corners_of_face = 0;
    bool is_in_solid = false;
    while (!lines.rest().empty() && (is_in_solid || !begins_with_binary(lines.rest()) || is_text(lines.rest()))) {
      std::string_view line = lines.next();
      for (std::string keyword = lower(next_word(line)); !keyword.empty(); keyword = lower(next_word(line))) {
        if (keyword == "solid" || (result_.parts.empty() && keyword == "facet"))
          result_.parts.push_back({keyword == "solid" ? std::string(trimmed(line)) : "", {}});
        if (keyword == "solid" || keyword == "endsolid") {
          is_in_solid = keyword == "solid";
          break; // the rest of the line is a name
        }
        if (keyword == "facet") {
          corners_of_face = 0;
        } else if (keyword == "endfacet") {
          if (corners_of_face != 3) lines.fail("a facet does not have three corners");
        } else if (keyword == "vertex" && !result_.parts.empty()) {
          ++corners_of_face;
          result_.parts.back().corners.push_back(lines.vertex(line));
          skip_vector(line);
        } else if (keyword == "normal") {
          skip_vector(line);
        } else if (!is_known(keyword)) {
          ++lines_left_out_;
          break;
        }
      }
    }
    if (corners_of_face % 3 != 0)
      lines.fail("the file ends in the middle of a facet: it is cut off", remedy::save_again);
    rest_ = lines.rest();
  }

  static void skip_vector(std::string_view& line)
  {
    for (int i = 0; i < 3; ++i)
      next_word(line);
  }

  /// Whether a word may be ignored without a warning; some systems end texts with zeros or a Control-Z.
  static bool is_known(const std::string& word)
  {
    return word == "outer" || word == "loop" || word == "endloop" || word[0] == '\0' || word[0] == '\x1A';
  }

  /// Names binary parts by their headers if there are several parts with distinct headers.
  void name_binary_parts()
  {
    headers_.resize(result_.parts.size());
    const std::set<std::string> all(headers_.begin(), headers_.end());
    if (all.size() < 2 || all.size() < headers_.size() || all.count("") > 0) return;
    for (std::size_t i = 0; i < headers_.size(); ++i)
      result_.parts[i].name = headers_[i];
  }

  void number_faces()
  {
    for (Model_part& part : result_.parts)
      for (std::size_t i = 0; i < part.corners.size() / 3; ++i)
        part.faces.push_back(result_.number_of_faces++);
  }

  std::string_view rest_;
  const std::string& file_;
  std::vector<std::string> headers_;
  std::size_t lines_left_out_ = 0;
  Model_content result_;
};

} // namespace

Model_content read_stl_parts(std::string_view text, const std::string& file) { return Stl_reader(text, file).read(); }

} // namespace CGAL::Shape_correspondence::IO
