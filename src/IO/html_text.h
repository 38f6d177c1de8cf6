// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_SRC_IO_HTML_TEXT_H
#define CGAL_SHAPE_CORRESPONDENCE_SRC_IO_HTML_TEXT_H

#include "colours.h"
#include "json_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace IO {

/// From linear light to what screens are given.
inline std::array<double, 3> screen_colour(const Colour& colour)
{
  std::array<double, 3> result{};
  for (int k = 0; k < 3; ++k) {
    const double c = std::clamp(colour[k], 0., 1.);
    result[static_cast<std::size_t>(k)] = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
  }
  return result;
}

/// The same in the notation of style sheets.
inline std::string css_colour(const Colour& colour)
{
  const std::array<double, 3> c = screen_colour(colour);
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", int(255 * c[0] + 0.5), int(255 * c[1] + 0.5),
                int(255 * c[2] + 0.5));
  return text;
}

/// JSON for an element of a page: nothing in it ends the element that holds it.
inline std::string script_text(const Json& json)
{
  std::string result;
  for (char c : json_line(json))
    result += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return result;
}

} // namespace IO
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_SRC_IO_HTML_TEXT_H
