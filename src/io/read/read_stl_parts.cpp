// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_parts.h"
#include "io/read/text_words.h"
#include "io/system/little_endian.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <cstdint>

namespace CGAL::Shape_correspondence::IO {
namespace {

// Of binary files: a header of 80 bytes, a count, and for each triangle a normal, three corners and two bytes more
constexpr std::size_t header_size = 84, triangle_size = 50, normal_size = 12;

Model_content read_binary_stl(std::string_view text, const std::string& file)
{
  const std::size_t count = number_in<std::uint32_t>(text.data() + header_size - 4);
  if (count > (text.size() - header_size) / triangle_size)
    throw Invalid_input(file + ": it cannot be read as an STL model: it says that it has " + std::to_string(count) +
                        " triangles, which is more than the file holds: it is cut off or damaged; " +
                        remedy::save_again);
  Model_content result;
  result.parts.emplace_back();
  for (std::size_t t = 0; t < count; ++t) {
    const char* const corners = text.data() + header_size + t * triangle_size + normal_size;
    for (std::size_t k = 0; k < 3; ++k) {
      Point corner;
      for (std::size_t i = 0; i < 3; ++i)
        corner[Eigen::Index(i)] = number_in<float>(corners + 4 * (3 * k + i));
      result.parts[0].corners.push_back(corner);
    }
  }
  return result;
}

/// Every solid is a part.
Model_content read_text_stl(std::string_view text, const std::string& file)
{
  Model_content result;
  Model_lines lines(text, file);
  std::size_t corners_of_face = 0;
  while (!lines.rest().empty()) {
    std::string_view line = lines.next();
    const std::string_view keyword = next_word(line);
    if (keyword == "solid") result.parts.push_back({std::string(trimmed(line)), {}});
    if (keyword == "facet") corners_of_face = 0;
    if (keyword == "endfacet" && corners_of_face != 3) lines.fail("a facet does not have three corners");
    if (keyword != "vertex" || result.parts.empty()) continue;
    ++corners_of_face;
    result.parts.back().corners.push_back(lines.vertex(line));
  }
  if (corners_of_face % 3 != 0) lines.fail("the file ends in the middle of a facet: it is cut off", remedy::save_again);
  const auto is_empty = [](const Model_part& part) { return part.corners.empty(); };
  result.parts.erase(std::remove_if(result.parts.begin(), result.parts.end(), is_empty), result.parts.end());
  return result;
}

/// Headers of binary files may begin with the word, too.
bool is_text_stl(std::string_view text)
{
  if (text.size() >= header_size &&
      text.size() == header_size + triangle_size * std::size_t(number_in<std::uint32_t>(text.data() + header_size - 4)))
    return false;
  return next_word(text) == "solid";
}

} // namespace

Model_content read_stl_parts(std::string_view text, const std::string& file)
{
  const bool is_text = is_text_stl(text);
  if (!is_text && text.size() < header_size)
    refuse(file + ": it cannot be read as an STL model: it is another kind of file or cut off", remedy::check_kind);
  Model_content result = is_text ? read_text_stl(text, file) : read_binary_stl(text, file);
  if (result.parts.empty() || result.parts[0].corners.empty())
    throw Invalid_input(file + ": there is no triangle in it; give every part a mesh");
  return result;
}

} // namespace CGAL::Shape_correspondence::IO
