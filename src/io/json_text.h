// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_JSON_TEXT_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_JSON_TEXT_H

#include <nlohmann/json.hpp>

#include <ostream>
#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace IO {

/// Objects keep the order in which their keys were set.
using Json = nlohmann::ordered_json;

/// The text of a value on one line. Numbers are the shortest that read back to the same double; bytes that are no
/// UTF-8 are replaced.
inline std::string json_line(const Json& value)
{
  return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Writes an object for people and for line-wise comparison: a line a key, and a line an element of an array of
/// objects.
inline void write_json(std::ostream& out, const Json& object)
{
  const char* separator = "{\n";
  for (const auto& [key, value] : object.items()) {
    out << separator << "  " << json_line(key) << ": ";
    separator = ",\n";
    if (!value.is_array() || value.empty() || !value[0].is_object()) {
      out << json_line(value);
      continue;
    }
    for (std::size_t i = 0; i < value.size(); ++i)
      out << (i == 0 ? "[\n    " : ",\n    ") << json_line(value[i]);
    out << "\n  ]";
  }
  out << "\n}\n";
}

} // namespace IO
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_JSON_TEXT_H
