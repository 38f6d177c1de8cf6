// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/Ply_header.h"

#include "io/read/model_parts.h"
#include "io/read/text_words.h"
#include "io/system/bytes.h"
#include "io/system/quoting.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace CGAL::Shape_correspondence::IO {
namespace {

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

/// Names of properties that assign faces or vertices to parts, the finest division first; in lower case, without
/// underscores and without CloudCompare's prefix "scalar".
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

class Ply_header_reader
{
public:
  Ply_header_reader(std::string_view& text, const std::string& file) : text_(text), file_(file) {}

  Ply_header take()
  {
    // If lines end with CR alone, an LF after the header is the first byte of the binary data
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
        choose_part_property();
        return std::move(result_);
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

private:
  [[noreturn]] void fail(const std::string& what, const char* remedy = remedy::correct_text) const
  {
    refuse(file_ + ": " + what, remedy);
  }

  /// Reads a comment: a texture's file name, or, as this program writes, the up direction or "part NUMBER NAME".
  void read_comment(std::string_view line)
  {
    if (const std::optional<Point> up = up_in_mark(trimmed(line))) result_.up = up;
    const std::string_view keyword = next_word(line);
    if (keyword == "TextureFile" && result_.textures.size() < most_ply_textures)
      result_.textures.emplace_back(trimmed(line));
    if (keyword != "part" && keyword != "label") return;
    const std::string_view number = next_word(line);
    result_.names.emplace(std::string(keyword) + ' ' + std::string(number),
                          percent_decoded(std::string(trimmed(line))));
  }

  /// Finds the property of faces, or else of vertices, that assigns them to parts.
  void choose_part_property()
  {
    for (const char* wanted : {"face", "vertex"})
      for (Ply_element& element : result_.elements)
        for (const char* name : part_properties)
          for (Ply_property& property : element.properties)
            if (element.name == wanted && result_.part_property.empty() && is_part_property(property, name)) {
              property.use = PART_NUMBER;
              result_.part_property = lower(property.name);
              result_.vertices_are_labelled = element.name == "vertex";
            }
  }

  void read_format(std::string_view word)
  {
    constexpr const char* encodings[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    const auto known = std::find(std::begin(encodings), std::end(encodings), word);
    if (known == std::end(encodings))
      fail("its PLY format is " + cited(word) + ", which is not ascii, binary_little_endian or binary_big_endian");
    result_.encoding = Ply_encoding(known - std::begin(encodings));
  }

  void read_element_statement(std::string_view line)
  {
    Ply_element element;
    element.name = next_word(line);
    const std::string_view count = next_word(line);
    if (!parse(count, element.count))
      fail("its PLY header has " + cited(count) + " where a number of elements is expected");
    result_.elements.push_back(std::move(element));
  }

  void read_property(std::string_view line)
  {
    if (result_.elements.empty()) fail("its PLY header has a property of no element");
    Ply_property property;
    std::string_view type = next_word(line);
    if (type == "list") {
      property.count_type = &type_of(next_word(line));
      type = next_word(line);
    }
    property.type = &type_of(type);
    property.name = next_word(line);
    property.use = use_of(property.name);
    result_.elements.back().properties.push_back(std::move(property));
  }

  const Ply_type& type_of(std::string_view word) const
  {
    for (const Ply_type& type : ply_types)
      if (word == type.name || word == type.other_name) return type;
    fail("its PLY header has a property of type " + cited(word) + ", which is none");
  }

  std::string_view& text_;
  const std::string& file_;
  Ply_header result_;
};

} // namespace

Ply_header take_ply_header(std::string_view& text, const std::string& file)
{
  return Ply_header_reader(text, file).take();
}

} // namespace CGAL::Shape_correspondence::IO
