// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// A number type with its two names, such as uchar and uint8.
struct Ply_type
{
  const char *name, *other_name;
  std::size_t size;
  double (*in_little_endian)(const char*);
  double (*in_big_endian)(const char*);
  double white; ///< value of a full channel of a colour
};

/// Uses of properties; the first three are coordinates, three are the channels of a colour.
enum Ply_use { FIRST_CHANNEL = 3, FIRST_TEXTURE_COORDINATE = 6, TEXTURE_NUMBER = 8, PART_NUMBER = 9 };

struct Ply_property
{
  std::string name;
  const Ply_type* type = nullptr;
  const Ply_type* count_type = nullptr; ///< type of a list's length; null: no list
  int use = -1;                         ///< a coordinate, a channel of a colour or another `Ply_use`; -1: none
};

struct Ply_element
{
  std::string name;
  std::size_t count = 0;
  std::vector<Ply_property> properties;
};

enum class Ply_encoding { ASCII, LITTLE_ENDIAN_BYTES, BIG_ENDIAN_BYTES };

constexpr int most_ply_textures = 1000; ///< limit for the textures of a file

struct Ply_header
{
  Ply_encoding encoding = Ply_encoding::ASCII;
  std::vector<Ply_element> elements;
  std::vector<std::string> textures;        ///< file names
  std::string part_property;                ///< name of the property that defines parts; empty: none
  bool vertices_are_labelled = false;       ///< whether that property belongs to vertices rather than faces
  std::optional<Point> up;                  ///< given only in files that were written by this program
  std::map<std::string, std::string> names; ///< names of parts and labels, by keyword and number

  /// The least number of bytes that a number takes in the file.
  std::size_t least_size(const Ply_type& type) const { return encoding == Ply_encoding::ASCII ? 2 : type.size; }
};

/// Takes the header off the text of a file.
/// \throw Invalid_input if it has mistakes
Ply_header take_ply_header(std::string_view& text, const std::string& file);

} // namespace CGAL::Shape_correspondence::IO
